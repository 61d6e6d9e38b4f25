//! Fusion of products whose only use is a sum into multiply-adds.

use super::rewrite::rewrite;
use crate::program::{Op, Program, ValueId};

/// Fuses `a * b + c` and similar sums. Products with a name are kept, so that the emitted code
/// shows them.
///
/// If both operands of a sum are such products, the right one is fused, since the left one is the
/// partial sum.
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
