//! Shapes and values of lowered programs.

use super::{letters, lowered, optimised};
use crate::program::{Labels, Op, Program, lower, optimise, run, verify};
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::expr::{ExprId, Function, Graph, Relation};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

fn multiplies_by_minus_one(program: &Program) -> bool {
    program.values().any(|(_, op)| *op == Op::Constant(Number::MINUS_ONE))
}

#[test]
fn a_sum_starts_with_a_positive_term() {
    let (mut g, [a, b, c, _], _) = letters();
    let (ab, bc) = (g.multiply(a, b), g.multiply(b, c));
    let sum = g.subtract(bc, ab);
    let program = lowered(&g, &[sum]);
    assert!(!program.values().any(|(_, op)| matches!(op, Op::Negate(_))), "{program:?}");
    assert!(!multiplies_by_minus_one(&program));
}

#[test]
fn a_sum_of_negative_terms_is_negated_once() {
    let (mut g, [a, b, c, _], _) = letters();
    let sum = g.sum(Number::from(-3), [a, b, c].map(|term| (term, Number::MINUS_ONE)));
    let program = lowered(&g, &[sum]);
    let negations = program.values().filter(|(_, op)| matches!(op, Op::Negate(_))).count();
    assert_eq!(negations, 1);
    assert!(!multiplies_by_minus_one(&program));
}

#[test]
fn not_a_number_in_a_condition_comes_through() {
    let (mut g, [a, b, ..], [x, y]) = letters();
    let choice = g.choose(Relation::Less, x, y, a, b);
    let program = optimised(&g, &[choice]);
    let at = |x: f64| {
        let value_of = move |role| match role {
            Role::Parameter(0) => 1.0,
            Role::Parameter(_) => 2.0,
            Role::Coordinate(0) => x,
            _ => 0.0,
        };
        run(&program, value_of)[0]
    };
    assert_eq!((at(-1.0), at(0.0), at(1.0)), (1.0, 2.0, 2.0));
    assert!(at(f64::NAN).is_nan());
}

#[test]
fn labels_name_values_and_keep_products_apart() {
    let (mut g, [a, b, c, _], _) = letters();
    let product = g.multiply(a, b);
    let sum = g.add(product, c);
    let mut labels = Labels::default();
    labels.insert(product, "area");
    labels.insert(product, "second");
    labels.insert(sum, "total");
    let program = optimise(&lower(&g, &[sum], &labels), Accuracy::Standard);
    let names = program.values().filter_map(|(id, _)| program.hint(id)).collect::<Vec<_>>();
    assert_eq!(names, ["area", "total"]);
}

#[test]
fn an_empty_program_and_repeated_outputs_are_programs() {
    let (g, [a, ..], _) = letters();
    assert!(optimised(&g, &[]).is_empty());
    assert_eq!(run(&optimised(&g, &[a, a]), |_| 3.0), [3.0, 3.0]);
}

/// Nests `step` so deeply that a recursive walk would overflow the stack of this thread.
fn deep(step: fn(&mut Graph, ExprId, ExprId) -> ExprId) {
    let run = move || {
        let (mut g, [a, ..], [x, _]) = letters();
        let root = (0..20_000).fold(x, |inner, _| step(&mut g, inner, a));
        let program = lower(&g, &[root], &Labels::default());
        for level in Accuracy::ALL {
            assert_eq!(verify(&optimise(&program, level)), Ok(()));
        }
    };
    let thread = std::thread::Builder::new().stack_size(256 << 10).spawn(run);
    thread.expect("a thread can be spawned").join().expect("no overflow");
}

#[test]
fn deep_graphs_need_no_stack() {
    deep(|g, inner, a| {
        let sum = g.add(inner, a);
        g.divide(sum, a)
    });
    deep(|g, inner, a| {
        let product = g.multiply(inner, a);
        g.sum(Number::ONE, [(product, Number::MINUS_ONE), (a, Number::TWO)])
    });
    deep(|g, inner, _| {
        let shifted = g.sum(Number::ONE, [(inner, Number::ONE)]);
        apply(g, Function::Sin, &[shifted])
    });
}
