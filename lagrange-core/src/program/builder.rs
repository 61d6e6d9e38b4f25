//! The only maker of programs: numbers values, folds constants, leaves out what nothing needs.

use super::fold::fold;
use super::ir::{Op, Program, Value, ValueId, ValueTable};
use crate::collections::OrderedMap;
use crate::expr::Function;
use crate::number::Number;

/// A program under construction.
///
/// Pushing an operation that is already there gives the value that is there, so common subexpressions
/// need no pass of their own; operations on constants give constants.
#[derive(Clone, Default, Debug)]
pub struct Builder {
    values: OrderedMap<Op, Option<Box<str>>>,
}

impl Builder {
    /// Nothing computed yet.
    pub fn new() -> Builder {
        Builder::default()
    }

    /// The value of an operation, folded if its operands are constants.
    pub fn push(&mut self, op: Op) -> ValueId {
        match fold(self, op) {
            Ok(known) => known,
            Err(op) => self.number_value(op),
        }
    }

    fn number_value(&mut self, op: Op) -> ValueId {
        if let Some(index) = op.commuted().and_then(|commuted| self.values.index_of(&commuted)) {
            return ValueId::new(index);
        }
        ValueId::new(self.values.index_or_insert_with(op, || None))
    }

    /// The operation behind a value.
    pub fn op(&self, id: ValueId) -> &Op {
        self.values.key_at(id.index())
    }

    /// An exact number.
    pub fn constant(&mut self, value: Number) -> ValueId {
        self.push(Op::Constant(value))
    }

    /// `a + b`
    pub fn add(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.push(Op::Add(a, b))
    }

    /// `a - b`
    pub fn subtract(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.push(Op::Subtract(a, b))
    }

    /// `a * b`
    pub fn multiply(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.push(Op::Multiply(a, b))
    }

    /// `a / b`
    pub fn divide(&mut self, a: ValueId, b: ValueId) -> ValueId {
        self.push(Op::Divide(a, b))
    }

    /// `-a`
    pub fn negate(&mut self, a: ValueId) -> ValueId {
        self.push(Op::Negate(a))
    }

    /// An elementary function.
    pub fn call(&mut self, function: Function, arguments: &[ValueId]) -> ValueId {
        self.push(Op::Call(function, arguments.into()))
    }

    /// Proposes a name for a value; the first proposal counts.
    pub fn propose_name(&mut self, id: ValueId, name: &str) {
        let op = self.op(id).clone();
        if let Some(hint @ None) = self.values.get_mut(&op) {
            *hint = Some(name.into());
        }
    }

    /// The program that computes `outputs`, without the values that do not contribute to them.
    pub fn finish(self, outputs: &[ValueId]) -> Program {
        let mut needed = ValueTable::filled(self.values.len(), false);
        outputs.iter().for_each(|&output| needed[output] = true);
        for (index, (op, _)) in self.values.iter().enumerate().rev() {
            if needed[ValueId::new(index)] {
                op.for_each_operand(|operand| needed[operand] = true);
            }
        }
        let mut values = ValueTable::with_capacity(self.values.len());
        // Values that are not needed keep a meaningless entry, which nothing asks for.
        let mut renumbered = ValueTable::with_capacity(self.values.len());
        for (index, (op, hint)) in self.values.iter().enumerate() {
            let id = ValueId::new(index);
            let new = match needed[id] {
                true => {
                    let op = op.map_operands(|operand| renumbered[operand]);
                    values.push(Value { op, hint: hint.clone() })
                }
                false => id,
            };
            renumbered.push(new);
        }
        let outputs = outputs.iter().map(|&output| renumbered[output]).collect();
        Program::from_parts(values, outputs)
    }
}
