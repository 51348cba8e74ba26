//! The tree in one line per declaration, for comparison.

use sweepc::syntax::ast::{
    Argument, Declaration, Document, Expr, ExprKind, Interval, Plane, ProductOp, Reference,
    Relation, Role, Sign,
};

/// A line for every declaration.
pub(crate) fn show_document(document: &Document) -> String {
    let lines = document
        .items
        .iter()
        .map(|item| show_declaration(&item.declaration) + "\n");
    lines.collect()
}

fn bracketed(parts: Vec<String>) -> String {
    let parts: Vec<_> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    format!("({})", parts.join(" "))
}

fn show_names(names: &[sweepc::syntax::ast::Name]) -> String {
    let list: Vec<_> = names.iter().map(|name| name.text.as_str()).collect();
    list.join(" ")
}

fn show_role(role: Role) -> &'static str {
    match role {
        Role::Profile => "profile",
        Role::Sweep => "sweep",
        Role::Further => "curve",
    }
}

#[rustfmt::skip]
fn show_declaration(declaration: &Declaration) -> String {
    use Declaration as D;
    bracketed(match declaration {
        D::Param { name, value } => {
            vec!["param".into(), name.text.clone(), show_expression(value)]
        }
        D::Let { name, parameters, value } => {
            vec!["let".into(), name.text.clone(), show_names(parameters), show_expression(value)]
        }
        D::Curve { role, name, parameter, plane, domain, value } => vec![
            show_role(*role).into(),
            name.text.clone(),
            parameter.text.clone(),
            plane.map_or(String::new(), |(plane, _)| show_plane(plane).into()),
            domain.as_ref().map_or(String::new(), show_interval),
            show_expression(value),
        ],
        D::Construction { name, parameters, body, bindings } => {
            let mut parts = vec!["construction".into(), name.text.clone(), show_names(parameters)];
            parts.push(show_expression(body));
            let binding = |(name, value): &(sweepc::syntax::ast::Name, _)| {
                format!("({} {})", name.text, show_expression(value))
            };
            parts.extend(bindings.iter().map(binding));
            parts
        }
        D::Surface { name, domain, value } => {
            let domain = domain.as_ref().map_or(String::new(), |(u, v)| {
                format!("{} {}", show_interval(u), show_interval(v))
            });
            vec!["surface".into(), name.text.clone(), domain, show_expression(value)]
        }
        D::Expect { left, relation } => {
            let mut parts = vec!["expect".into(), show_expression(left)];
            if let Some((relation, right)) = relation {
                parts.push(show_relation(*relation).into());
                parts.push(show_expression(right));
            }
            parts
        }
        D::Import { path, .. } => vec!["import".into(), path.clone()],
        D::Unit { name } => vec!["unit".into(), name.text.clone()],
    })
}

fn show_plane(plane: Plane) -> &'static str {
    match plane {
        Plane::Xy => "xy",
        Plane::Xz => "xz",
        Plane::Yz => "yz",
    }
}

fn show_interval(interval: &Interval) -> String {
    format!(
        "[{} {}]",
        show_expression(&interval.start),
        show_expression(&interval.end)
    )
}

fn show_relation(relation: Relation) -> &'static str {
    match relation {
        Relation::Equal => "==",
        Relation::NotEqual => "!=",
        Relation::Less => "<",
        Relation::LessOrEqual => "<=",
        Relation::Greater => ">",
        Relation::GreaterOrEqual => ">=",
    }
}

fn show_reference(reference: &Reference) -> String {
    let qualifier = reference
        .qualifier
        .as_ref()
        .map_or(String::new(), |name| format!("{}.", name.text));
    format!(
        "{qualifier}{}{}",
        reference.name.text,
        "'".repeat(reference.primes as usize)
    )
}

fn show_argument(argument: &Argument) -> String {
    let label = argument
        .label
        .as_ref()
        .map_or(String::new(), |name| format!("{}:", name.text));
    label + &show_expression(&argument.value)
}

/// A tree as an S-expression; a product begins with its operators, `_` for none.
pub(crate) fn show_expression(expression: &Expr) -> String {
    let all = |head: &str, list: &[Expr]| {
        let mut parts = vec![head.to_owned()];
        parts.extend(list.iter().map(show_expression));
        bracketed(parts)
    };
    match &expression.kind {
        ExprKind::Number(number) => number.clone(),
        ExprKind::Text(text) => format!("\"{text}\""),
        ExprKind::Sum(terms) => {
            let mut parts = vec!["+".to_owned()];
            parts.extend(terms.iter().map(|(sign, term)| match sign {
                Sign::Plus => show_expression(term),
                Sign::Minus => format!("(- {})", show_expression(term)),
            }));
            bracketed(parts)
        }
        ExprKind::Product(factors) => {
            assert_eq!(
                factors[0].0,
                ProductOp::Times,
                "the first factor joins by `*`"
            );
            let operators = factors[1..].iter().map(|(operator, _)| match operator {
                ProductOp::Times => '*',
                ProductOp::Divide => '/',
                ProductOp::Juxtapose => '_',
            });
            let mut parts = vec![operators.collect()];
            parts.extend(factors.iter().map(|(_, factor)| show_expression(factor)));
            bracketed(parts)
        }
        ExprKind::Negate(inner) => format!("(neg {})", show_expression(inner)),
        ExprKind::Power(base, exponent) => {
            format!(
                "(^ {} {})",
                show_expression(base),
                show_expression(exponent)
            )
        }
        ExprKind::Reference(reference) => show_reference(reference),
        ExprKind::Apply {
            function,
            arguments,
            ..
        } => {
            let mut parts = vec!["apply".to_owned(), show_reference(function)];
            parts.extend(arguments.iter().map(show_argument));
            bracketed(parts)
        }
        ExprKind::Component(inner, name) => format!("(. {} {})", show_expression(inner), name.text),
        ExprKind::Tuple(entries) => all("tuple", entries),
        ExprKind::List(entries) => all("list", entries),
        ExprKind::Group(inner) => format!("(group {})", show_expression(inner)),
    }
}
