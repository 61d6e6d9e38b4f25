//! Products that are used once, in a sum, are computed together with the sum.

use super::rewrite::rewrite;
use crate::program::{Op, Program, ValueId};

/// Fuses `a * b + c` and its relatives. Products with a name stay: somebody wants to read them.
///
/// If both operands of a sum are such products, the right one is fused, since the left one is the
/// sum so far.
pub fn fuse_multiply_adds(program: &Program) -> Program {
    let uses = program.uses();
    let fusible = |id: ValueId| uses[id] == 1 && program.hint(id).is_none();
    rewrite(program, |builder, id, op| {
        let product = |old: ValueId, new: ValueId| match builder.op(new) {
            &Op::Multiply(a, b) if fusible(old) => Some((a, b)),
            _ => None,
        };
        let fused = match (program.op(id), &op) {
            (Op::Add(left, right), Op::Add(x, y)) => match (product(*left, *x), product(*right, *y)) {
                (_, Some((a, b))) => Op::MultiplyAdd(a, b, *x),
                (Some((a, b)), None) => Op::MultiplyAdd(a, b, *y),
                (None, None) => op,
            },
            (Op::Subtract(left, right), Op::Subtract(x, y)) => {
                match (product(*left, *x), product(*right, *y)) {
                    (_, Some((a, b))) => Op::SubtractProduct(a, b, *x),
                    (Some((a, b)), None) => Op::MultiplySubtract(a, b, *y),
                    (None, None) => op,
                }
            }
            _ => op,
        };
        builder.push(fused)
    })
}
