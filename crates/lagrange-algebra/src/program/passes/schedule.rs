//! Order of values that places each close to its first use.

use crate::program::{Builder, Program, ValueId};
use lagrange_expr::collections::HashMap;

/// Orders values depth-first from the outputs, which is also the order in which they are printed.
/// The operand with the longest dependency chain comes first. Short computations are then placed
/// where they are needed. Function calls, which compilers do not move, are spread along the long
/// chain.
pub fn schedule(program: &Program) -> Program {
    let heights = heights(program);
    let mut order = Order { program, heights, builder: Builder::new(), image: HashMap::default() };
    let outputs = program.outputs().iter().map(|&output| order.place(output)).collect::<Vec<_>>();
    order.builder.finish(&outputs)
}

/// Returns the length of the longest dependency chain of each value.
fn heights(program: &Program) -> HashMap<ValueId, u32> {
    let mut heights: HashMap<ValueId, u32> = HashMap::default();
    for (id, op) in program.values() {
        let mut height = 0;
        op.for_each_operand(|operand| {
            height = height.max(heights.get(&operand).map_or(0, |below| below + 1));
        });
        heights.insert(id, height);
    }
    heights
}

struct Order<'a> {
    program: &'a Program,
    heights: HashMap<ValueId, u32>,
    builder: Builder,
    image: HashMap<ValueId, ValueId>,
}

impl Order<'_> {
    /// Places everything that a value depends on, then the value.
    fn place(&mut self, root: ValueId) -> ValueId {
        let mut pending = vec![root];
        while let Some(&id) = pending.last() {
            let before = pending.len();
            if !self.image.contains(&id) {
                self.program.op(id).for_each_operand(|operand| {
                    if !self.image.contains(&operand) {
                        pending.push(operand);
                    }
                });
                // The operand with the longest dependency chain is placed first.
                pending[before..].sort_by_key(|&operand| self.height(operand));
            }
            if pending.len() == before {
                pending.pop();
                self.copy(id);
            }
        }
        self.image.get(&root).copied().unwrap_or(root)
    }

    fn height(&self, id: ValueId) -> u32 {
        self.heights.get(&id).copied().unwrap_or(0)
    }

    fn copy(&mut self, id: ValueId) {
        if self.image.contains(&id) {
            return;
        }
        let moved = |operand| self.image.get(&operand).copied().unwrap_or(operand);
        let new = self.builder.push(self.program.op(id).map_operands(moved));
        if let Some(name) = self.program.hint(id) {
            self.builder.propose_name(new, name);
        }
        self.image.insert(id, new);
    }
}
