//! What single passes do.

use super::{letters, lowered};
use crate::expr::Function;
use crate::functions::apply;
use crate::number::Number;
use crate::program::{Op, Program, fuse_multiply_adds, pair_sines_and_cosines, schedule};

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

#[test]
fn values_are_computed_close_to_their_use() {
    let (mut g, [a, b, c, d], _) = letters();
    let early = g.multiply(a, b);
    let late = g.sum(Number::ONE, [(c, Number::ONE), (d, Number::ONE)]);
    let program = schedule(&lowered(&g, &[late, early]));
    assert_eq!(kinds(&program), ["add", "other", "add", "multiply"]);
    assert_eq!(schedule(&program), program);
}
