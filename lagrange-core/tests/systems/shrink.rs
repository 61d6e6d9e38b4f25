//! Shrinking of failing cases: irrelevant statements are removed, and expressions shortened.

use std::collections::HashMap;

use crate::compare::{derived, verdict};
use crate::generate::Case;
use crate::layout::{Layout, Slot};
use crate::tree::{Declaration, Expr, Statement, number};
use crate::world::State;

/// Largest number of smaller cases to judge.
const MAX_TRIALS: usize = 400;

/// Returns the smallest failing case found from one of its states.
pub(crate) fn smallest(case: &Case, index: usize) -> Case {
    let mut small = Case { states: vec![case.states[index].clone()], ..case.clone() };
    let mut trials = 0;
    while let Some(smaller) = smaller(&small, &mut trials) {
        small = smaller;
    }
    small
}

/// Returns a smaller case that fails, too.
fn smaller(case: &Case, trials: &mut usize) -> Option<Case> {
    let statements = &case.declaration.statements;
    let without = |removed: &dyn Fn(usize, &Statement) -> bool| {
        let kept = statements.iter().enumerate().filter(|(index, statement)| !removed(*index, statement));
        kept.map(|(_, statement)| statement.clone()).collect::<Vec<_>>()
    };
    let names = names(statements);
    let by_name = names.iter().map(|name| without(&|_, statement| mentions(statement, name)));
    let one_by_one = (0..statements.len()).rev().map(|index| without(&|at, _| at == index));
    let edited = (0..statements.len()).flat_map(|index| {
        let edited = edits(&statements[index]).into_iter().map(move |edited| {
            let mut statements = statements.clone();
            statements[index] = edited;
            statements
        });
        edited.collect::<Vec<_>>()
    });
    by_name.chain(one_by_one).chain(edited).find_map(|statements| {
        *trials += 1;
        let smaller = reduced(case, statements)?;
        (*trials <= MAX_TRIALS && fails(&smaller)).then_some(smaller)
    })
}

fn fails(case: &Case) -> bool {
    let system = derived(&case.declaration, case.choice);
    system.is_ok_and(|system| verdict(&system, &case.declaration, &case.states[0]).differs())
}

/// Returns the case with fewer statements, and the remaining part of its state. It is `None` if
/// nothing can move.
fn reduced(case: &Case, statements: Vec<Statement>) -> Option<Case> {
    let [old, new] = [&case.declaration.statements, &statements].map(|statements| Layout::of(statements));
    let (state, wanted) = &case.states[0];
    let (q, v) = (entries(&old, Entries::Positions, &state.q), entries(&old, Entries::Velocities, &state.v));
    let wanted = entries(&old, Entries::Velocities, wanted);
    let State { t, .. } = *state;
    let state =
        State { t, q: picked(&new, Entries::Positions, &q), v: picked(&new, Entries::Velocities, &v) };
    let wanted = picked(&new, Entries::Velocities, &wanted);
    let declaration = Declaration { statements, ..case.declaration.clone() };
    (new.velocities > 0).then(|| Case { declaration, states: vec![(state, wanted)], ..case.clone() })
}

/// A half of the state.
#[derive(Clone, Copy, PartialEq)]
enum Entries {
    Positions,
    Velocities,
}

/// Returns names with the offsets and the numbers of their entries.
fn places(layout: &Layout, entries: Entries) -> Vec<(&str, usize, usize)> {
    let is_positions = entries == Entries::Positions;
    let slots = layout.slots.iter().map(|slot| match slot {
        Slot::Coordinate { name, position, velocity } => {
            (&name[..], if is_positions { *position } else { *velocity }, 1)
        }
        Slot::Orientation { name, position, velocity } => {
            (&name[..], if is_positions { *position } else { *velocity }, if is_positions { 4 } else { 3 })
        }
    });
    let states = layout.states.iter().enumerate().filter(|_| is_positions);
    slots.chain(states.map(|(k, name)| (&name[..], layout.positions + k, 1))).collect()
}

fn entries(layout: &Layout, entries: Entries, values: &[f64]) -> HashMap<String, Vec<f64>> {
    let places = places(layout, entries).into_iter();
    places.map(|(name, first, count)| (name.to_owned(), values[first..first + count].to_vec())).collect()
}

fn picked(layout: &Layout, entries: Entries, values: &HashMap<String, Vec<f64>>) -> Vec<f64> {
    places(layout, entries).iter().flat_map(|(name, ..)| values[*name].clone()).collect()
}

/// Returns the names that statements declare.
fn names(statements: &[Statement]) -> Vec<String> {
    let names = statements.iter().rev().filter_map(|statement| match statement {
        Statement::Coordinate { name, .. }
        | Statement::State { name, .. }
        | Statement::Quaternion(name)
        | Statement::Let(name, _)
        | Statement::Solve { name, .. } => Some(name.clone()),
        Statement::Body(body) => Some(body.name.clone()),
        _ => None,
    });
    names.collect()
}

/// True if a statement contains a name as a word, or as the beginning of a derived name.
fn mentions(statement: &Statement, name: &str) -> bool {
    let text = statement.to_string();
    let is_word = |c: char| c.is_alphanumeric();
    text.match_indices(name).any(|(at, _)| {
        !text[..at].ends_with(|c| is_word(c) || c == '_') && !text[at + name.len()..].starts_with(is_word)
    })
}

/// Returns statements in which a part of a node, or a number, replaces the node.
fn edits(statement: &Statement) -> Vec<Statement> {
    let mut found = Vec::new();
    for at in 0.. {
        let mut probe = statement.clone();
        let Some(node) = node(&mut probe, at) else { return found };
        let mut parts = node.parts_mut().into_iter().map(|part| part.clone()).collect::<Vec<_>>();
        if !parts.is_empty() {
            parts.extend([number("0"), number("1")]);
        }
        for part in parts {
            let mut edited = statement.clone();
            if let Some(node) = self::node(&mut edited, at) {
                *node = part;
                found.push(edited);
            }
        }
    }
    found
}

/// Returns the node of a number, counted from the outside to the inside.
fn node(statement: &mut Statement, at: usize) -> Option<&mut Expr> {
    let mut pending = statement.expressions_mut();
    pending.reverse();
    let mut seen = 0;
    while let Some(expression) = pending.pop() {
        if seen == at {
            return Some(expression);
        }
        seen += 1;
        pending.extend(expression.parts_mut().into_iter().rev());
    }
    None
}
