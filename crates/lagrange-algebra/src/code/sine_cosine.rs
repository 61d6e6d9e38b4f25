//! Values of a program that are the sine or the cosine from a pair.

use crate::program::{Op, Program, ValueId};
use lagrange_expr::collections::HashMap;

/// Values taken from each pair, and from each place in a batch: the sine and the cosine, where they
/// are used.
pub(super) type SinesAndCosines = HashMap<(ValueId, u32), [Option<ValueId>; 2]>;

pub(super) fn sines_and_cosines(program: &Program) -> SinesAndCosines {
    let mut found = SinesAndCosines::default();
    for (id, op) in program.values() {
        let (pair, place, part) = match op {
            Op::SinOf(pair) => (*pair, 0, 0),
            Op::CosOf(pair) => (*pair, 0, 1),
            Op::SinIn(batch, place) => (*batch, *place, 0),
            Op::CosIn(batch, place) => (*batch, *place, 1),
            _ => continue,
        };
        found.get_or_insert_with((pair, place), || [None; 2])[part] = Some(id);
    }
    found
}
