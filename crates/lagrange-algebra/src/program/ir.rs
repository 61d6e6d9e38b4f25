//! The program and its operations.

use std::ops::{Index, IndexMut};

use lagrange_expr::expr::{Function, Relation};
use lagrange_expr::number::Number;
use lagrange_expr::opaque::Opaque;
use lagrange_expr::symbol::Role;

/// Identifies a value of one [`Program`].
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct ValueId(u32);

impl ValueId {
    pub(super) fn new(index: usize) -> ValueId {
        ValueId(u32::try_from(index).expect("fewer than 2^32 values fit in memory"))
    }

    pub(super) fn index(self) -> usize {
        self.0 as usize
    }
}

/// A double-precision number with what it lacks, which can be hashed: numbers are equal if they
/// have the same bits.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Float([u64; 2]);

impl Float {
    /// Wraps a number that lacks nothing, or whose remainder is unknown.
    pub fn new(value: f64) -> Float {
        Float::with_remainder(value, 0.0)
    }

    /// Wraps a number with its remainder, for numbers wider than `f64`.
    pub fn with_remainder(value: f64, remainder: f64) -> Float {
        Float([value, remainder].map(f64::to_bits))
    }

    /// Returns the number.
    pub fn value(self) -> f64 {
        f64::from_bits(self.0[0])
    }

    /// Returns what the number lacks.
    pub fn remainder(self) -> f64 {
        f64::from_bits(self.0[1])
    }

    /// Returns the opposite.
    pub fn negated(self) -> Float {
        Float::with_remainder(-self.value(), -self.remainder())
    }
}

impl std::fmt::Debug for Float {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        self.value().fmt(f)
    }
}

/// One operation; operands are earlier values of the same program.
#[derive(Clone, PartialEq, Eq, Hash, Debug)]
pub enum Op {
    /// The value of a symbol.
    Input(Role),
    /// An exact number, rounded when it is written out.
    Constant(Number),
    /// A number that is not rational, such as 2π, already rounded.
    Float(Float),
    /// `a + b`
    Add(ValueId, ValueId),
    /// `a - b`
    Subtract(ValueId, ValueId),
    /// `a * b`
    Multiply(ValueId, ValueId),
    /// `a / b`
    Divide(ValueId, ValueId),
    /// `-a`
    Negate(ValueId),
    /// `a * b + c`, rounded once if the target supports it.
    MultiplyAdd(ValueId, ValueId, ValueId),
    /// `a * b - c`, rounded once if the target supports it.
    MultiplySubtract(ValueId, ValueId, ValueId),
    /// `c - a * b`, rounded once if the target supports it.
    SubtractProduct(ValueId, ValueId, ValueId),
    /// `a` to an integer power too large to be written as products.
    Power(ValueId, i32),
    /// An elementary function.
    Call(Function, Box<[ValueId]>),
    /// The value or a derivative of a function without a formula.
    Opaque(Opaque, Box<[ValueId]>),
    /// Sine and cosine of `a` together: a pair, only used by [`Op::SinOf`] and [`Op::CosOf`].
    SinCos(ValueId),
    /// The sine in a pair.
    SinOf(ValueId),
    /// The cosine in a pair.
    CosOf(ValueId),
    /// Sines and cosines of several values at a time, only used by [`Op::SinIn`] and [`Op::CosIn`].
    SinCosEach(Box<[ValueId]>),
    /// The sine of the value at this place in a batch.
    SinIn(ValueId, u32),
    /// The cosine of the value at this place in a batch.
    CosIn(ValueId, u32),
    /// `then` where the relation holds, `otherwise` where its opposite does, NaN where an operand
    /// of the relation is NaN.
    Select {
        /// `<` or `<=`.
        relation: Relation,
        /// Left operand of the relation.
        left: ValueId,
        /// Right operand of the relation.
        right: ValueId,
        /// Value where the relation holds.
        then: ValueId,
        /// Value where it does not.
        otherwise: ValueId,
    },
}

impl Op {
    /// Calls `visit` with every operand, in the order in which they are written.
    pub fn for_each_operand(&self, mut visit: impl FnMut(ValueId)) {
        match self {
            Op::Input(_) | Op::Constant(_) | Op::Float(_) => {}
            Op::Negate(a) | Op::Power(a, _) | Op::SinCos(a) | Op::SinOf(a) | Op::CosOf(a) => visit(*a),
            Op::Add(a, b) | Op::Subtract(a, b) | Op::Multiply(a, b) | Op::Divide(a, b) => {
                [*a, *b].into_iter().for_each(visit);
            }
            Op::MultiplyAdd(a, b, c) | Op::MultiplySubtract(a, b, c) | Op::SubtractProduct(a, b, c) => {
                [*a, *b, *c].into_iter().for_each(visit);
            }
            Op::SinIn(batch, _) | Op::CosIn(batch, _) => visit(*batch),
            Op::Call(_, arguments) | Op::Opaque(_, arguments) | Op::SinCosEach(arguments) => {
                arguments.iter().copied().for_each(visit);
            }
            Op::Select { left, right, then, otherwise, .. } => {
                [*left, *right, *then, *otherwise].into_iter().for_each(visit);
            }
        }
    }

    /// Returns an operation of the same kind on other operands.
    pub fn map_operands(&self, mut map: impl FnMut(ValueId) -> ValueId) -> Op {
        let mut mapped = self.clone();
        mapped.for_each_operand_mut(|operand| *operand = map(*operand));
        mapped
    }

    fn for_each_operand_mut(&mut self, mut visit: impl FnMut(&mut ValueId)) {
        match self {
            Op::Input(_) | Op::Constant(_) | Op::Float(_) => {}
            Op::Negate(a) | Op::Power(a, _) | Op::SinCos(a) | Op::SinOf(a) | Op::CosOf(a) => visit(a),
            Op::Add(a, b) | Op::Subtract(a, b) | Op::Multiply(a, b) | Op::Divide(a, b) => {
                [a, b].into_iter().for_each(visit);
            }
            Op::MultiplyAdd(a, b, c) | Op::MultiplySubtract(a, b, c) | Op::SubtractProduct(a, b, c) => {
                [a, b, c].into_iter().for_each(visit);
            }
            Op::SinIn(batch, _) | Op::CosIn(batch, _) => visit(batch),
            Op::Call(_, arguments) | Op::Opaque(_, arguments) | Op::SinCosEach(arguments) => {
                arguments.iter_mut().for_each(visit);
            }
            Op::Select { left, right, then, otherwise, .. } => {
                [left, right, then, otherwise].into_iter().for_each(visit);
            }
        }
    }

    /// Returns the operation with the operands of its commutative part exchanged.
    pub(super) fn commuted(&self) -> Option<Op> {
        match self {
            Op::Add(a, b) => Some(Op::Add(*b, *a)),
            Op::Multiply(a, b) => Some(Op::Multiply(*b, *a)),
            Op::MultiplyAdd(a, b, c) => Some(Op::MultiplyAdd(*b, *a, *c)),
            Op::MultiplySubtract(a, b, c) => Some(Op::MultiplySubtract(*b, *a, *c)),
            Op::SubtractProduct(a, b, c) => Some(Op::SubtractProduct(*b, *a, *c)),
            _ => None,
        }
    }

    /// True if this is a known number.
    pub fn is_constant(&self) -> bool {
        matches!(self, Op::Constant(_) | Op::Float(_))
    }
}

/// A straight-line program: every value is computed once, from earlier ones.
///
/// Only a [`Builder`](super::Builder) creates programs. No two values are therefore the same
/// operation, and every value contributes to an output.
#[derive(Clone, PartialEq, Debug)]
pub struct Program {
    values: ValueTable<Value>,
    outputs: Vec<ValueId>,
}

/// An operation and the name its result should have.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Value {
    pub(super) op: Op,
    pub(super) hint: Option<Box<str>>,
}

impl Program {
    pub(super) fn from_parts(values: ValueTable<Value>, outputs: Vec<ValueId>) -> Program {
        Program { values, outputs }
    }

    /// Returns the operation that computes a value.
    pub fn op(&self, id: ValueId) -> &Op {
        &self.values[id].op
    }

    /// Returns the preferred name of a value, if it has one.
    pub fn hint(&self, id: ValueId) -> Option<&str> {
        self.values[id].hint.as_deref()
    }

    /// Returns the values in the order in which they are computed.
    pub fn values(&self) -> impl DoubleEndedIterator<Item = (ValueId, &Op)> + ExactSizeIterator {
        self.values.iter().map(|(id, value)| (id, &value.op))
    }

    /// Returns the results in the requested order; some may be the same value.
    pub fn outputs(&self) -> &[ValueId] {
        &self.outputs
    }

    /// Returns the number of values.
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// True if nothing is computed.
    pub fn is_empty(&self) -> bool {
        self.values.len() == 0
    }

    /// Returns the number of uses of each value, where an output counts as a use.
    pub fn uses(&self) -> ValueTable<usize> {
        let mut uses = ValueTable::filled(self.len(), 0);
        for (_, op) in self.values() {
            op.for_each_operand(|operand| uses[operand] += 1);
        }
        self.outputs.iter().for_each(|&output| uses[output] += 1);
        uses
    }
}

/// Table with an entry for each value of a program.
#[derive(Clone, PartialEq, Debug)]
pub struct ValueTable<T>(Vec<T>);

impl<T> ValueTable<T> {
    /// Creates an empty table, to be filled in the order of the values.
    pub fn with_capacity(capacity: usize) -> ValueTable<T> {
        ValueTable(Vec::with_capacity(capacity))
    }

    /// Creates a table with the same entry for each of `len` values.
    pub fn filled(len: usize, entry: T) -> ValueTable<T>
    where
        T: Clone,
    {
        ValueTable(vec![entry; len])
    }

    /// Adds the entry of the next value.
    pub fn push(&mut self, entry: T) -> ValueId {
        self.0.push(entry);
        ValueId::new(self.0.len() - 1)
    }

    /// Returns the number of entries.
    fn len(&self) -> usize {
        self.0.len()
    }

    fn iter(&self) -> impl DoubleEndedIterator<Item = (ValueId, &T)> + ExactSizeIterator {
        self.0.iter().enumerate().map(|(index, entry)| (ValueId::new(index), entry))
    }
}

impl<T> Index<ValueId> for ValueTable<T> {
    type Output = T;
    fn index(&self, id: ValueId) -> &T {
        &self.0[id.index()]
    }
}

impl<T> IndexMut<ValueId> for ValueTable<T> {
    fn index_mut(&mut self, id: ValueId) -> &mut T {
        &mut self.0[id.index()]
    }
}
