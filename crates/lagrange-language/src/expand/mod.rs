//! Expansion of arrays, loops, sums and parts.
//!
//! `theta[2]` becomes the name `theta_2`, `u[1][2]` becomes `u_1_2`, a loop becomes its statements,
//! and a sum its terms. This precedes all other processing. The result is therefore the same as for
//! a declaration that was written out by hand: the same equations, the same code. Expressions keep
//! the places of their original tokens.
//!
//! `param`, `input`, `const`, `coord` and `quaternion` declare whole arrays, with the number of
//! elements in brackets; all other statements declare one element, with its index. Indices are
//! evaluated exactly, from integers, constants and variables of loops.
//!
//! Nested loops may produce any number of statements, so this number is limited, as is the total
//! number of terms.

mod callees;
mod collecting;
mod complaints;
mod copier;
mod copies;
mod corners;
mod counting;
mod defaults;
mod elements;
mod indices;
mod messages;
mod parts;
mod paths;
mod placements;
mod scopes;
mod statements;
#[cfg(test)]
mod tests;
mod unrolling;
mod warnings;
mod wholes;

use std::collections::BTreeSet;

use crate::syntax::ast::{
    ArrayExpression, Declaration, Enclosure, Expression, Expressions, Nested, Statement, StatementKind,
    declared_bodies, nested,
};
use collecting::declared_elements;
use complaints::Complaints;
use copier::Copier;
use corners::{has_corners, loop_over_corners};
use lagrange_expr::collections::HashSet;
use lagrange_expr::diagnostics::Report;
use scopes::{BUILT_IN, Scopes};
use statements::written_out;
use unrolling::{Unrolled, unroll};

use warnings::say_where_placed;
pub use warnings::{name_elements, once_for_each_array, without_repetitions};

/// Expands arrays, loops and sums. Errors in them are reported, and the result then contains
/// everything that is still known.
pub fn without_arrays(mut declaration: Declaration, report: &mut Report) -> Declaration {
    if !has_arrays(&mut declaration) {
        return declaration;
    }
    let mut statements = std::mem::take(&mut declaration.statements);
    let mut expressions = std::mem::take(&mut declaration.expressions);
    loop_over_corners(&mut statements, &mut expressions);
    let (names, counted) = (names_of(&statements), counted(&mut statements, &expressions));
    let mut complaints = Complaints::new(report, &declaration, &names);
    let before = complaints.report.diagnostics().len();
    let mut scopes = Scopes::among(&names);
    let unrolled = unroll(&statements, &expressions, &mut scopes, &mut complaints);
    let elements = declared_elements(&unrolled, &expressions, &scopes, &mut complaints);
    let mut silent = Report::default();
    // Consequences of errors in names are not reported.
    if complaints.report.diagnostics().len() > before {
        complaints = Complaints::new(&mut silent, &declaration, &names);
    }
    let mut copier = Copier::new(&mut expressions, scopes, &unrolled.constants, &elements, complaints);
    let written = unrolled.instances.iter().flat_map(|instance| written_out(&mut copier, instance));
    let statements = written.collect::<Vec<_>>();
    expressions.end_of_text();
    let (bodies, arrays) = (declared_bodies(&statements), elements.arrays());
    let Unrolled { placed, unplaced, .. } = unrolled;
    let written =
        Declaration { statements, expressions, bodies, arrays, placed, unplaced, counted, ..declaration };
    say_where_placed(&written, report);
    written
}

/// True if there is anything to expand.
pub fn has_arrays(declaration: &mut Declaration) -> bool {
    let is_array = |expression: &Expression| match expression {
        Expression::Array(_) | Expression::Entry { .. } => true,
        Expression::Component(_, name) | Expression::Call(name, _) => !name.indices.is_empty(),
        _ => false,
    };
    let mut expressions = declaration.expressions.iter();
    expressions.any(|(_, expression)| is_array(expression))
        || has_corners(declaration)
        || declaration.statements.iter_mut().any(|statement| {
            let is_several = matches!(statement.kind, StatementKind::Block(_));
            is_several
                || !statement.kind.enclosures_mut().is_empty()
                || statement
                    .kind
                    .names_mut()
                    .iter()
                    .any(|name| !(name.indices.is_empty() && name.members.is_empty()))
        })
}

/// Returns all declared names, except those that are local to loops.
fn names_of(statements: &[Statement]) -> BTreeSet<String> {
    let mut names = BTreeSet::from(BUILT_IN.map(str::to_owned));
    let lasting = nested(statements).into_iter().flat_map(Nested::lasting_names);
    names.extend(lasting.map(|(name, suffix)| format!("{}{suffix}", name.text)));
    names
}

/// Returns the names in indices, ranges of loops and conditions on indices.
fn counted(statements: &mut [Statement], expressions: &Expressions) -> HashSet<String> {
    let mut roots = Vec::new();
    let mut pending = statements.iter_mut().collect::<Vec<_>>();
    while let Some(Statement { kind, .. }) = pending.pop() {
        roots.extend(kind.names_mut().into_iter().flat_map(|name| name.indices.clone()));
        let around = kind.enclosures_mut().into_iter().filter(|enclosure| enclosure.is_counted());
        roots.extend(around.flat_map(Enclosure::expressions_mut).map(|id| *id));
        if let StatementKind::Block(block) = kind {
            let (expressions, bodies) = block.parts_mut();
            roots.extend(expressions.into_iter().map(|id| *id));
            pending.extend(bodies.into_iter().flatten());
        }
    }
    for (_, expression) in expressions.iter() {
        match expression {
            Expression::Array(ArrayExpression::Element(name)) | Expression::Call(name, _) => {
                roots.extend(&name.indices);
            }
            Expression::Array(ArrayExpression::Fold { range, .. }) => roots.extend([range.from, range.to]),
            Expression::Array(ArrayExpression::Select { condition, .. }) => {
                roots.extend(condition.expressions());
            }
            Expression::Entry { indices, .. } => roots.extend(indices),
            _ => {}
        }
    }
    let parts = roots.into_iter().flat_map(|root| expressions.parts(root));
    let names = parts.filter_map(|id| match expressions.get(id) {
        Expression::Name(name) => Some(name.clone()),
        Expression::Array(ArrayExpression::Element(name)) => Some(name.text.clone()),
        _ => None,
    });
    names.collect()
}
