//! Joint computation of the sine and cosine of the same argument.

use super::rewrite::rewrite;
use crate::program::{Op, Program, ValueTable};
use lagrange_expr::expr::Function;

/// Computes the sine and the cosine of a value by one operation if both are needed.
pub fn pair_sines_and_cosines(program: &Program) -> Program {
    let mut sine_of = ValueTable::filled(program.len(), false);
    let mut cosine_of = sine_of.clone();
    for (_, op) in program.values() {
        match op {
            Op::Call(Function::Sin, argument) => sine_of[argument[0]] = true,
            Op::Call(Function::Cos, argument) => cosine_of[argument[0]] = true,
            _ => {}
        }
    }
    rewrite(program, |builder, id, op| {
        let (Op::Call(function, old), Op::Call(_, new)) = (program.op(id), &op) else {
            return builder.push(op);
        };
        let part = match function {
            Function::Sin => Op::SinOf,
            Function::Cos => Op::CosOf,
            _ => return builder.push(op),
        };
        if !(sine_of[old[0]] && cosine_of[old[0]]) {
            return builder.push(op);
        }
        let pair = builder.push(Op::SinCos(new[0]));
        builder.push(part(pair))
    })
}
