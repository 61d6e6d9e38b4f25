//! Computations from parameters alone, extracted from programs and performed only once.
//!
//! A value of numbers and parameters that a changing value depends on becomes an input of its
//! program. It is extracted before any pass runs, since a product of parameters that has been fused
//! into a sum could no longer be extracted.

use super::builder::Builder;
use super::ir::{Op, Program, ValueId, ValueTable};
use super::variability::Variability;
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::symbol::Role;

/// The constant parts of several programs, each only once.
#[derive(Debug)]
pub struct Preparation {
    builder: Builder,
    /// Values that become inputs, in the order of their roles.
    kept: OrderedMap<ValueId, ()>,
    /// Number of parameters; the roles of the new inputs follow theirs.
    parameters: u32,
}

impl Preparation {
    /// Creates an empty preparation for a system with this many parameters.
    pub fn new(parameters: u32) -> Preparation {
        Preparation { builder: Builder::new(), kept: OrderedMap::default(), parameters }
    }

    /// Returns the role of a prepared value.
    pub fn role(&self, index: usize) -> Role {
        Role::Parameter(self.parameters + u32::try_from(index).expect("fewer than 2^32 values fit in memory"))
    }

    /// Returns the equivalent program with the prepared values as inputs.
    pub fn prepare(&mut self, program: &Program) -> Program {
        let variability = Variability::of_values(program);
        let mut builder = Builder::new();
        // The image of each value: in the preparation, or in the new program.
        let mut found = ValueTable::with_capacity(program.len());
        for (id, op) in program.values() {
            let value = match variability[id] {
                Variability::Constant => self.builder.push(op.map_operands(|operand| found[operand])),
                _ => {
                    let op = op.map_operands(|operand| match variability[operand] {
                        Variability::Constant => self.taken(&mut builder, found[operand]),
                        _ => found[operand],
                    });
                    builder.push(op)
                }
            };
            if let Some(hint) = program.hint(id) {
                let builder =
                    if variability[id] == Variability::Constant { &mut self.builder } else { &mut builder };
                builder.propose_name(value, hint);
            }
            found.push(value);
        }
        let outputs = program.outputs().iter().map(|&output| match variability[output] {
            Variability::Constant => self.taken(&mut builder, found[output]),
            _ => found[output],
        });
        let outputs = outputs.collect::<Vec<_>>();
        builder.finish(&outputs)
    }

    /// Returns a constant value in a program: numbers and parameters as they are, anything else as
    /// an input. Signs cost nothing.
    fn taken(&mut self, builder: &mut Builder, value: ValueId) -> ValueId {
        match self.builder.op(value) {
            &Op::Negate(of) => {
                let of = self.taken(builder, of);
                builder.negate(of)
            }
            op @ (Op::Input(_) | Op::Constant(_) | Op::Float(_)) => builder.push(op.clone()),
            _ => {
                let index = self.kept.index_or_insert_with(value, || ());
                builder.push(Op::Input(self.role(index)))
            }
        }
    }

    /// Returns the number of prepared values.
    pub fn len(&self) -> usize {
        self.kept.len()
    }

    /// True if nothing is prepared.
    pub fn is_empty(&self) -> bool {
        self.kept.is_empty()
    }

    /// Returns the name of a prepared value, if it has one.
    pub fn name(&self, index: usize) -> Option<&str> {
        self.builder.name(*self.kept.key_at(index))
    }

    /// Returns the program that computes the prepared values, in the order of their roles.
    pub fn finish(self) -> Program {
        let outputs = self.kept.iter().map(|(value, ())| *value).collect::<Vec<_>>();
        self.builder.finish(&outputs)
    }
}
