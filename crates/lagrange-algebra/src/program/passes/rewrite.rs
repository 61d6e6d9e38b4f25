//! Programs with operations replaced.

use crate::program::builder::Builder;
use crate::program::ir::{Op, Program, ValueId, ValueTable};

/// Returns the program in which each operation is replaced by the result of `replace`. Its
/// arguments are the value in the old program and the operation on operands of the new one.
pub(super) fn rewrite(
    program: &Program,
    mut replace: impl FnMut(&mut Builder, ValueId, Op) -> ValueId,
) -> Program {
    let mut builder = Builder::new();
    let mut image: ValueTable<ValueId> = ValueTable::with_capacity(program.len());
    for (id, op) in program.values() {
        let op = op.map_operands(|operand| image[operand]);
        let new = replace(&mut builder, id, op);
        if let Some(name) = program.hint(id) {
            builder.propose_name(new, name);
        }
        image.push(new);
    }
    let outputs = program.outputs().iter().map(|&output| image[output]).collect::<Vec<_>>();
    builder.finish(&outputs)
}
