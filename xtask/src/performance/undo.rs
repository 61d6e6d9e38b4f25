//! Passes that undo the work of lowering and other passes, to measure its value.

use lagrange_core::number::Number;
use lagrange_core::program::{Builder, Op, Program, ValueId, ValueTable};

/// Replaces every product with a reciprocal by a quotient.
pub(super) fn divide_each(program: &Program) -> Program {
    rewritten(program, |builder, op| {
        let Op::Multiply(a, b) = op else { return builder.push(op) };
        match (denominator(builder, a), denominator(builder, b)) {
            (_, Some(below)) => builder.divide(a, below),
            (Some(below), None) => builder.divide(b, below),
            (None, None) => builder.push(op),
        }
    })
}

/// Returns the value whose reciprocal this is.
fn denominator(builder: &Builder, value: ValueId) -> Option<ValueId> {
    let Op::Divide(above, below) = builder.op(value) else { return None };
    matches!(builder.op(*above), Op::Constant(one) if *one == Number::ONE).then_some(*below)
}

/// Splits every batch of sines and cosines into batches of one.
pub(super) fn split_batches(program: &Program) -> Program {
    rewritten(program, |builder, op| {
        let (batch, place, part): (_, _, fn(ValueId, u32) -> Op) = match op {
            Op::SinIn(batch, place) => (batch, place, Op::SinIn),
            Op::CosIn(batch, place) => (batch, place, Op::CosIn),
            _ => return builder.push(op),
        };
        let Op::SinCosEach(angles) = builder.op(batch) else { return builder.push(op) };
        let angle = angles[place as usize];
        let single = builder.push(Op::SinCosEach([angle].into()));
        builder.push(part(single, 0))
    })
}

fn rewritten(program: &Program, mut replace: impl FnMut(&mut Builder, Op) -> ValueId) -> Program {
    let mut builder = Builder::new();
    let mut image: ValueTable<ValueId> = ValueTable::with_capacity(program.len());
    for (id, op) in program.values() {
        let new = replace(&mut builder, op.map_operands(|operand| image[operand]));
        if let Some(name) = program.hint(id) {
            builder.propose_name(new, name);
        }
        image.push(new);
    }
    let outputs = program.outputs().iter().map(|&output| image[output]).collect::<Vec<_>>();
    builder.finish(&outputs)
}
