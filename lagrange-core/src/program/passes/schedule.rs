//! The order of values: each close to its first use.

use crate::collections::HashMap;
use crate::program::{Builder, Program, ValueId};

/// Orders values depth-first from the outputs, which is also the order in which they are printed.
pub fn schedule(program: &Program) -> Program {
    let mut order = Order { program, builder: Builder::new(), image: HashMap::default() };
    let outputs = program.outputs().iter().map(|&output| order.place(output)).collect::<Vec<_>>();
    order.builder.finish(&outputs)
}

struct Order<'a> {
    program: &'a Program,
    builder: Builder,
    image: HashMap<ValueId, ValueId>,
}

impl Order<'_> {
    /// Places everything a value needs, then the value.
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
                // The first operand is placed first.
                pending[before..].reverse();
            }
            if pending.len() == before {
                pending.pop();
                self.copy(id);
            }
        }
        self.image.get(&root).copied().unwrap_or(root)
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
