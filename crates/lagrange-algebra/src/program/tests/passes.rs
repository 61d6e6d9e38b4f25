//! Effects of single passes.

use super::{letters, lowered};
use crate::program::{
    Op, Program, ValueId, batch_sines_and_cosines, fuse_multiply_adds, pair_sines_and_cosines, run, schedule,
    verify,
};
use lagrange_expr::expr::Function;
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

fn kinds(program: &Program) -> Vec<&'static str> {
    let kind = |op: &Op| match op {
        Op::Input(_) => "input",
        Op::MultiplyAdd(..) => "a*b+c",
        Op::MultiplySubtract(..) => "a*b-c",
        Op::SubtractProduct(..) => "c-a*b",
        Op::Multiply(..) => "multiply",
        Op::Add(..) => "add",
        Op::Subtract(..) => "subtract",
        Op::SinCos(_) => "pair",
        Op::SinOf(_) => "sine",
        Op::CosOf(_) => "cosine",
        Op::SinCosEach(_) => "batch",
        Op::SinIn(..) => "sine",
        Op::CosIn(..) => "cosine",
        _ => "other",
    };
    program.values().map(|(_, op)| kind(op)).filter(|kind| *kind != "input").collect()
}

#[test]
fn products_used_once_are_fused_with_their_sum() {
    let (mut g, [a, b, c, d], _) = letters();
    let (ab, cd) = (g.multiply(a, b), g.multiply(c, d));
    let difference = g.subtract(ab, cd);
    let fused = |outputs: &[_]| kinds(&fuse_multiply_adds(&lowered(&g, outputs)));
    assert_eq!(fused(&[difference]), ["multiply", "c-a*b"]);
    assert_eq!(fused(&[difference, cd]), ["multiply", "a*b-c"]);
    assert_eq!(fused(&[difference, ab, cd]), ["multiply", "multiply", "subtract"]);
}

#[test]
fn a_pair_is_made_only_where_both_are_wanted() {
    let (mut g, _, [x, y]) = letters();
    let sines = [x, y].map(|angle| apply(&mut g, Function::Sin, &[angle]));
    let cosine = apply(&mut g, Function::Cos, &[x]);
    let program = pair_sines_and_cosines(&lowered(&g, &[sines[0], sines[1], cosine]));
    assert_eq!(kinds(&program), ["pair", "sine", "other", "cosine"]);
}

/// Returns the arguments of each batch.
fn batches(program: &Program) -> Vec<Vec<ValueId>> {
    let batch = |op: &Op| match op {
        Op::SinCosEach(angles) => Some(angles.to_vec()),
        _ => None,
    };
    program.values().filter_map(|(_, op)| batch(op)).collect()
}

#[test]
fn sines_and_cosines_that_do_not_wait_for_each_other_are_computed_together() {
    let (mut g, _, [x, y]) = letters();
    let [sin_x, cos_x] = [Function::Sin, Function::Cos].map(|function| apply(&mut g, function, &[x]));
    let cos_y = apply(&mut g, Function::Cos, &[y]);
    let sum = g.add(sin_x, y);
    let later = apply(&mut g, Function::Sin, &[sum]);
    let program = batch_sines_and_cosines(&lowered(&g, &[cos_y, later, cos_x]));
    assert_eq!(verify(&program), Ok(()));
    assert_eq!(batches(&program).iter().map(Vec::len).collect::<Vec<_>>(), [2, 1]);
    let value_of = |role| if role == Role::Coordinate(0) { 0.3 } else { 2.0 };
    let expected = [2.0_f64.cos(), (0.3_f64.sin() + 2.0).sin(), 0.3_f64.cos()];
    for (found, expected) in run(&program, value_of).into_iter().zip(expected) {
        assert!((found - expected).abs() < 2e-16, "{found} for {expected}");
    }
}

#[test]
fn batches_are_of_bounded_size_and_miss_nothing() {
    let (mut g, [a, ..], [x, _]) = letters();
    let mut angles = Vec::new();
    for k in 0..100 {
        angles.push(g.sum(Number::from(k), [(x, Number::ONE), (a, Number::from(k))]));
    }
    let sines = angles.iter().map(|angle| apply(&mut g, Function::Sin, &[*angle])).collect::<Vec<_>>();
    let program = batch_sines_and_cosines(&lowered(&g, &sines));
    assert_eq!(verify(&program), Ok(()));
    assert_eq!(batches(&program).iter().map(Vec::len).collect::<Vec<_>>(), [32, 32, 32, 4]);
}

#[test]
fn values_are_computed_close_to_their_use() {
    let (mut g, [a, b, c, d], _) = letters();
    let early = g.multiply(a, b);
    let late = g.sum(Number::ONE, [(c, Number::ONE), (d, Number::ONE)]);
    let program = schedule(&lowered(&g, &[late, early]));
    assert_eq!(kinds(&program), ["add", "other", "add", "multiply"]);
    assert_eq!(schedule(&program), program);
}

/// c·d has no dependencies, while sin(a·b) depends on a product. The product therefore comes first,
/// and c·d immediately before its use.
#[test]
fn values_with_the_longest_wait_are_computed_first() {
    let (mut g, [a, b, c, d], _) = letters();
    let angle = g.multiply(a, b);
    let late = apply(&mut g, Function::Sin, &[angle]);
    let early = g.multiply(c, d);
    for sum in [g.add(early, late), g.add(late, early)] {
        let program = schedule(&lowered(&g, &[sum]));
        assert_eq!(kinds(&program), ["multiply", "other", "multiply", "add"]);
    }
}
