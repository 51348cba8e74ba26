//! Every form of expression.

use sweepc::syntax::ast::{Declaration, ExprKind, Sign};
use sweepc::syntax::canonical_name;

use crate::{expression, parsed, tree};

#[test]
fn precedence_is_the_usual_one() {
    for (text, expected) in [
        ("7", "7"),
        ("1 + 2 - 3", "(+ 1 2 (- 3))"),
        ("-a", "(+ (- a))"),
        ("-a + b", "(+ (- a) b)"),
        ("-a b", "(+ (- (_ a b)))"),
        ("-a^2", "(+ (- (^ a 2)))"),
        ("- -a", "(+ (- (neg a)))"),
        ("a - -b", "(+ a (- (neg b)))"),
        ("a + -b c", "(+ a (_ (neg b) c))"),
        ("2 * -x", "(* 2 (neg x))"),
        ("2 * -x^2", "(* 2 (neg (^ x 2)))"),
        ("a * b / c", "(*/ a b c)"),
        ("a · b × c", "(** a b c)"),
        ("a − b", "(+ a (- b))"),
        ("1/2u", "(/_ 1 2 u)"),
        ("0 xF", "(_ 0 xF)"),
        ("0 x(u)", "(_ 0 (apply x u))"),
        ("2u", "(_ 2 u)"),
        ("x(u) n(v)", "(_ (apply x u) (apply n v))"),
        ("3 (1 - v)^2 v", "(__ 3 (^ (group (+ 1 (- v))) 2) v)"),
        ("u^2(1 - v)", "(_ (^ u 2) (group (+ 1 (- v))))"),
        ("u^n (1 - v)", "(_ (^ u n) (group (+ 1 (- v))))"),
        ("q(v)(1 - v)", "(_ (apply q v) (group (+ 1 (- v))))"),
        ("(a)(b)", "(_ (group a) (group b))"),
        ("a -b", "(+ a (- b))"),
    ] {
        assert_eq!(expression(text), expected, "{text}");
    }
}

#[test]
fn powers_associate_to_the_right() {
    for (text, expected) in [
        ("2^3^2", "(^ 2 (^ 3 2))"),
        ("a^-2", "(^ a (neg 2))"),
        ("a^−2", "(^ a (neg 2))"),
        ("a^n^-1", "(^ a (^ n (neg 1)))"),
        ("a^(1/2)", "(^ a (group (/ 1 2)))"),
        ("a^(n)^2", "(^ a (^ (group n) 2))"),
        ("a^-2 b", "(_ (^ a (neg 2)) b)"),
        ("a^2 + b^2", "(+ (^ a 2) (^ b 2))"),
        ("f(u)^2", "(^ (apply f u) 2)"),
        ("c.x(u)^2", "(^ (apply c.x u) 2)"),
        ("(a, b).x^2", "(^ (. (tuple a b) x) 2)"),
    ] {
        assert_eq!(expression(text), expected, "{text}");
    }
}

#[test]
fn names_take_qualifiers_primes_and_parentheses() {
    for (text, expected) in [
        ("σ(v)", "(apply σ v)"),
        ("c.sigma(v)", "(apply c.σ v)"),
        ("c.σ'(v)", "(apply c.σ' v)"),
        ("f'(v)", "(apply f' v)"),
        ("f''(v)", "(apply f'' v)"),
        ("f″′’(v)", "(apply f'''' v)"),
        ("f'", "f'"),
        ("f' g", "(_ f' g)"),
        ("R.W", "R.W"),
        ("a.x", "a.x"),
        ("a.x.y", "(. a.x y)"),
        ("c(v).x", "(. (apply c v) x)"),
        ("c(v).x y", "(_ (. (apply c v) x) y)"),
        ("(a + b).x", "(. (group (+ a b)) x)"),
        ("c'(v).x.y", "(. (. (apply c' v) x) y)"),
        ("f()", "(apply f)"),
        ("f (a)", "(apply f a)"),
        ("f(a)(b)", "(_ (apply f a) (group b))"),
        ("f((a, b))", "(apply f (tuple a b))"),
        ("f(a, b)", "(apply f a b)"),
        ("sqrt(2) a", "(_ (apply sqrt 2) a)"),
    ] {
        assert_eq!(expression(text), expected, "{text}");
    }
}

#[test]
fn arguments_take_labels_lists_and_strings() {
    for (text, expected) in [
        ("f(a, branch: best)", "(apply f a branch:best)"),
        ("f(branch: \"+-\")", "(apply f branch:\"+-\")"),
        ("f(\"\")", "(apply f \"\")"),
        (
            "bezier([(0, 0), (1, 2)], weights: [1, 2])",
            "(apply bezier (list (tuple 0 0) (tuple 1 2)) weights:(list 1 2))",
        ),
        ("f([])", "(apply f (list))"),
        (
            "f(knots: [-1, a + b])",
            "(apply f knots:(list (+ (- 1)) (+ a b)))",
        ),
        ("(1,5)", "(tuple 1 5)"),
        ("(1, 2, 3, 4)", "(tuple 1 2 3 4)"),
        ("f(1,5)", "(apply f 1 5)"),
        ("f([1,5])", "(apply f (list 1 5))"),
    ] {
        assert_eq!(expression(text), expected, "{text}");
    }
}

#[test]
fn numbers_are_the_longest_match() {
    for (text, expected) in [
        ("007", "007"),
        ("0.8", "0.8"),
        ("1.5e-3", "1.5e-3"),
        ("1.5e−3", "1.5e-3"),
        ("2e5", "2e5"),
        ("2e+5x", "(_ 2e+5 x)"),
        ("2e", "(_ 2 e)"),
        ("2em", "(_ 2 em)"),
        ("2e + 1", "(+ (_ 2 e) 1)"),
        ("2E5", "(_ 2 E5)"),
        ("1e999999999", "1e999999999"),
    ] {
        assert_eq!(expression(text), expected, "{text}");
    }
}

#[test]
fn names_are_folded() {
    for (written, canonical) in [
        ("sigma", "σ"),
        ("kappa", "κ"),
        ("rho", "ρ"),
        ("µ", "μ"),
        ("ϰ", "κ"),
        ("ϱ", "ρ"),
        ("ϵ", "ε"),
        ("ϕ_1", "φ_1"),
        ("sigma1", "sigma1"),
        ("Γ", "Γ"),
        ("_a9", "_a9"),
        ("λμ", "λμ"),
    ] {
        assert_eq!(expression(written), canonical);
        assert_eq!(canonical_name(written), canonical);
        assert_eq!(
            tree(&format!("param {written} = 1")),
            format!("(param {canonical} 1)\n")
        );
    }
}

#[test]
fn spans_of_expressions_are_exact() {
    let text = "let a = -f'(x, l: 2 ) + (b).x c^-2 # end";
    let (document, _) = parsed(text);
    let Declaration::Let { value, .. } = &document.items[0].declaration else {
        panic!()
    };
    let marked = |span: sweepc::diag::Span| &text[span.range()];
    assert_eq!(marked(value.span), "-f'(x, l: 2 ) + (b).x c^-2");
    let ExprKind::Sum(terms) = &value.kind else {
        panic!()
    };
    assert_eq!(terms[0].0, Sign::Minus);
    assert_eq!(marked(terms[0].1.span), "f'(x, l: 2 )");
    let ExprKind::Apply {
        function,
        arguments,
        parenthesis,
    } = &terms[0].1.kind
    else {
        panic!()
    };
    assert_eq!(marked(function.span), "f'");
    assert_eq!(marked(function.name.span), "f");
    assert_eq!(marked(*parenthesis), "(x, l: 2 )");
    assert_eq!(marked(arguments[1].label.as_ref().unwrap().span), "l");
    let ExprKind::Product(factors) = &terms[1].1.kind else {
        panic!()
    };
    assert_eq!(marked(factors[0].1.span), "(b).x");
    assert_eq!(marked(factors[1].1.span), "c^-2");
}
