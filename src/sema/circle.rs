use std::collections::{BTreeSet, HashMap};

use crate::diag::{Code, Diagnostic};
use crate::syntax::ast::{Expr, Name};

use super::undeclared::names;

/// How many definitions of a circle are marked.
const MARKED: usize = 8;

/// E0104 at names behind a `where` that need each other, used or not.
pub(super) fn circle_behind_where(bindings: &[(Name, Expr)]) -> Option<Diagnostic> {
    let circle = circle(bindings)?;
    let first = *circle.first()?;
    let words: Vec<&str> = circle.iter().map(|own| own.text.as_str()).collect();
    let mut finding = Diagnostic::new(Code::E0104, first.span, message(&words));
    for own in circle.iter().skip(1).take(MARKED) {
        finding = finding.related(own.span, format!("`{}` is defined here", own.text));
    }
    Some(finding)
}

/// What is wrong with definitions each of which needs the next one, and the last one the first.
pub(super) fn message(circle: &[&str]) -> String {
    match circle {
        [only] => format!("`{only}` is defined by itself"),
        _ => format!(
            "these definitions need each other: {} → {}",
            circle.join(" → "),
            circle.first().unwrap_or(&"")
        ),
    }
}

/// A circle among definitions, if there is one.
///
/// - **cost** linear
fn circle(bindings: &[(Name, Expr)]) -> Option<Vec<&Name>> {
    let indices = bindings.iter().enumerate();
    let indices: HashMap<&str, usize> = indices
        .map(|(index, (name, _))| (name.text.as_str(), index))
        .collect();
    let index = |own: &Name| indices.get(own.text.as_str()).copied();
    let needs: Vec<BTreeSet<usize>> = bindings
        .iter()
        .map(|(_, value)| names(value).into_iter().filter_map(index).collect())
        .collect();
    let waits = waiting(&needs);
    // what waits needs another one that waits: the way along these comes back to itself
    let mut at = waits.iter().position(|own| *own)?;
    let mut way: Vec<usize> = Vec::new();
    let mut places: HashMap<usize, usize> = HashMap::new();
    while !places.contains_key(&at) {
        places.insert(at, way.len());
        way.push(at);
        at = *needs[at].iter().find(|own| waits[**own])?;
    }
    let circle = way.get(*places.get(&at)?..)?;
    Some(circle.iter().map(|own| &bindings[*own].0).collect())
}

/// Which definitions are never free of needs when those that are free are taken away.
fn waiting(needs: &[BTreeSet<usize>]) -> Vec<bool> {
    let mut users = vec![Vec::new(); needs.len()];
    for (own, needed) in needs.iter().enumerate() {
        for needed in needed {
            users[*needed].push(own);
        }
    }
    let mut open: Vec<usize> = needs.iter().map(BTreeSet::len).collect();
    let mut free: Vec<usize> = (0..needs.len()).filter(|own| open[*own] == 0).collect();
    while let Some(own) = free.pop() {
        for user in &users[own] {
            open[*user] -= 1;
            if open[*user] == 0 {
                free.push(*user);
            }
        }
    }
    open.into_iter().map(|own| own > 0).collect()
}
