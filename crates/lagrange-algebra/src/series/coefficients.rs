//! Coefficients of the values of one step, from those of their operands.

use super::Motion;
use super::kinds::Kind;
use super::schedule::{Schedule, Source};
use super::slots::{Slot, Slots};
use crate::program::{Builder, Op, ValueId, ValueTable};
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::expr::Function;
use lagrange_expr::number::Number;

/// A coefficient in a program of one step; `None` is zero.
pub(super) type Coefficient = Option<ValueId>;

/// A value of order zero.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) enum Initial {
    /// x₀
    Value(ValueId),
    /// 1/x₀
    Reciprocal(ValueId),
    /// 1/(2 x₀), or 0 if x₀ is 0
    HalfReciprocal(ValueId),
}

/// A constant factor of a value.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum Constant {
    Minus,
    Times(Initial),
}

/// A multiple of a value.
#[derive(Clone, PartialEq, Eq, Hash)]
pub(super) struct Multiple {
    pub(super) of: ValueId,
    pub(super) constants: Vec<Constant>,
}

impl From<ValueId> for Multiple {
    fn from(of: ValueId) -> Multiple {
        Multiple { of, constants: Vec::new() }
    }
}

/// The place of constant factors of products.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Constants {
    /// Before sums, so that products of multiples of the same values share a sum.
    BeforeSums,
    /// In one of the factors, so that they add nothing between sums and accelerations.
    InSums,
}

/// Coefficients under construction, and the inputs that they share.
pub(super) struct Coefficients<'a> {
    pub(super) motion: &'a Motion<'a>,
    pub(super) schedule: &'a Schedule,
    constants: Constants,
    pub(super) slots: Slots,
    pub(super) initials: OrderedMap<Initial, ()>,
    pub(super) kept: OrderedMap<Multiple, ()>,
    pub(super) sums: OrderedMap<[usize; 2], ()>,
    pub(super) carried: OrderedMap<ValueId, ()>,
}

/// The part of coefficients that a pass computes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    /// Everything except the share of the unknowns, which are accelerations and multipliers.
    Known,
    /// The share of all unknowns.
    Share,
    /// The share of this unknown at order zero, as if it were one.
    Unit(u32),
}

/// The coefficients of one order.
pub(super) struct Pass {
    pub(super) builder: Builder,
    pub(super) coefficients: ValueTable<Coefficient>,
    part: Part,
}

impl<'a> Coefficients<'a> {
    pub(super) fn new(
        motion: &'a Motion<'a>,
        schedule: &'a Schedule,
        constants: Constants,
    ) -> Coefficients<'a> {
        let mut kept = OrderedMap::default();
        for entry in motion.state {
            kept.insert(Multiple::from(entry.value), ());
        }
        Coefficients {
            motion,
            schedule,
            constants,
            slots: Slots::default(),
            initials: OrderedMap::default(),
            kept,
            sums: OrderedMap::default(),
            carried: OrderedMap::default(),
        }
    }

    pub(super) fn pass(&mut self, builder: Builder, part: Part) -> Pass {
        let coefficients = ValueTable::filled(self.motion.program.len(), None);
        let mut pass = Pass { builder, coefficients, part };
        for &value in &self.schedule.order {
            pass.coefficients[value] = self.coefficient(&mut pass, value);
        }
        pass
    }

    fn coefficient(&mut self, pass: &mut Pass, value: ValueId) -> Coefficient {
        match self.schedule.source(self.motion, value) {
            Source::Time => self.slot(pass, Slot::First),
            Source::Velocity(index) => self.unknown(pass, index, Slot::Velocity(index)),
            Source::Acceleration(index) => self.unknown(pass, index, Slot::Acceleration(index)),
            Source::Previous(of) if self.schedule.kinds[of] == Kind::Fixed => self.first(pass, of),
            Source::Previous(of) => self.now(pass, of),
            Source::Rate(of) => self.times_slot(pass, pass.coefficients[of], Slot::Order),
            Source::Integral(rate) => match self.schedule.kinds[rate] {
                // Functions of velocities: the bias of the reciprocal is accepted.
                Kind::Accelerated => self.times_slot(pass, pass.coefficients[rate], Slot::Reciprocal),
                // In the first step, k + 1 is one.
                Kind::Fixed => self.first(pass, rate),
                _ => {
                    let index = self.carry(rate);
                    self.slot(pass, Slot::Integral(index))
                }
            },
            Source::Operands => self.operation(pass, value),
        }
    }

    fn operation(&mut self, pass: &mut Pass, value: ValueId) -> Coefficient {
        let is_accelerated = self.schedule.kinds[value] == Kind::Accelerated;
        match *self.motion.program.op(value) {
            Op::Add(a, b) => {
                let [a, b] = [a, b].map(|operand| self.term(pass, operand, is_accelerated));
                pass.builder.sum(a, b)
            }
            Op::Subtract(a, b) => {
                let [a, b] = [a, b].map(|operand| self.term(pass, operand, is_accelerated));
                pass.builder.difference(a, b)
            }
            Op::Negate(a) => self.term(pass, a, is_accelerated).map(|a| pass.builder.negate(a)),
            Op::Multiply(a, b) => self.product(pass, a, b),
            Op::Divide(a, b) => self.quotient(pass, value, a, b),
            Op::Call(Function::Sqrt, ref arguments) => self.root(pass, value, arguments[0]),
            Op::Select { relation, left, right, then, otherwise } => {
                let [then, otherwise] =
                    [then, otherwise].map(|operand| self.term(pass, operand, is_accelerated));
                if then == otherwise {
                    return then;
                }
                let zero = pass.builder.constant(Number::ZERO);
                let [then, otherwise] = [then, otherwise].map(|branch| branch.unwrap_or(zero));
                let [left, right] = [left, right].map(|side| self.at_start(pass, Initial::Value(side)));
                Some(pass.builder.push(Op::Select { relation, left, right, then, otherwise }))
            }
            // The schedule has rejected everything else.
            _ => None,
        }
    }

    /// Returns the coefficient of an operand of a sum, in the order of the sum.
    fn term(&mut self, pass: &mut Pass, operand: ValueId, is_accelerated: bool) -> Coefficient {
        match (self.schedule.kinds[operand], is_accelerated) {
            (Kind::Fixed, true) => self.first(pass, operand),
            (Kind::Fixed, false) => None,
            (Kind::Moving, true) => self.now(pass, operand),
            _ => pass.coefficients[operand],
        }
    }

    fn product(&mut self, pass: &mut Pass, a: ValueId, b: ValueId) -> Coefficient {
        let [of_a, of_b] = [a, b].map(|factor| self.schedule.kinds[factor]);
        match (of_a, of_b) {
            (Kind::Fixed, _) => self.times_initial(pass, pass.coefficients[b], Initial::Value(a)),
            (_, Kind::Fixed) => self.times_initial(pass, pass.coefficients[a], Initial::Value(b)),
            _ => {
                let inner = self.inner(pass, a, b);
                // If a factor is known to a higher order than the product, the sum contains its
                // newest coefficient.
                let mut edge = |newest: ValueId, other: ValueId| match self.schedule.kinds[other] {
                    Kind::Moving if of_a == of_b || self.schedule.kinds[newest] == Kind::Accelerated => {
                        self.times_initial(pass, pass.coefficients[newest], Initial::Value(other))
                    }
                    _ => None,
                };
                let (one, two) = (edge(b, a), edge(a, b));
                let edges = pass.builder.sum(one, two);
                pass.builder.sum(edges, inner)
            }
        }
    }

    fn quotient(&mut self, pass: &mut Pass, value: ValueId, a: ValueId, b: ValueId) -> Coefficient {
        let is_accelerated = self.schedule.kinds[value] == Kind::Accelerated;
        let mut above = self.term(pass, a, is_accelerated);
        if self.schedule.kinds[b] != Kind::Fixed {
            let inner = self.inner(pass, b, value);
            above = pass.builder.difference(above, inner);
            if !is_accelerated {
                let edge = self.times_initial(pass, pass.coefficients[b], Initial::Value(value));
                above = pass.builder.difference(above, edge);
            }
        }
        self.times_initial(pass, above, Initial::Reciprocal(b))
    }

    fn root(&mut self, pass: &mut Pass, value: ValueId, of: ValueId) -> Coefficient {
        let inner = self.inner(pass, value, value);
        let rest = pass.builder.difference(pass.coefficients[of], inner);
        self.times_initial(pass, rest, Initial::HalfReciprocal(value))
    }

    /// Returns Σ xⱼ yₘ₋ⱼ of the coefficients from earlier steps. Products share one of their
    /// factors if it is free of constants.
    fn inner(&mut self, pass: &mut Pass, a: ValueId, b: ValueId) -> Coefficient {
        let [(a, of_a), (b, of_b)] = [a, b].map(|factor| self.without_constants(factor));
        let mut constants = [of_a, of_b].concat();
        constants.sort_unstable();
        let is_first = |value: ValueId| (self.schedule.kinds[value], !self.kept.contains(&value.into()));
        let (first, second) = if is_first(b) < is_first(a) { (b, a) } else { (a, b) };
        let (inside, outside) = match self.constants {
            Constants::BeforeSums => (Vec::new(), constants),
            Constants::InSums => (constants, Vec::new()),
        };
        let factors = [self.keep(first.into()), self.keep(Multiple { of: second, constants: inside })];
        let factors = [factors[0].min(factors[1]), factors[0].max(factors[1])];
        let index = self.sums.index_or_insert_with(factors, || ());
        let sum = self.slot(pass, Slot::Sum(index));
        self.times(pass, sum, &outside)
    }

    /// Returns the coefficient of a multiple.
    pub(super) fn times(
        &mut self,
        pass: &mut Pass,
        coefficient: Coefficient,
        constants: &[Constant],
    ) -> Coefficient {
        constants.iter().fold(coefficient, |coefficient, constant| match *constant {
            Constant::Times(initial) => self.times_initial(pass, coefficient, initial),
            Constant::Minus => coefficient.map(|coefficient| pass.builder.negate(coefficient)),
        })
    }

    /// Splits a value into its constant factors and the rest.
    fn without_constants(&self, mut value: ValueId) -> (ValueId, Vec<Constant>) {
        let mut constants = Vec::new();
        while self.schedule.source(self.motion, value) == Source::Operands {
            let is_fixed = |operand: ValueId| self.schedule.kinds[operand] == Kind::Fixed;
            let (of, constant) = match *self.motion.program.op(value) {
                Op::Multiply(a, b) if is_fixed(a) => (b, Constant::Times(Initial::Value(a))),
                Op::Multiply(a, b) if is_fixed(b) => (a, Constant::Times(Initial::Value(b))),
                Op::Divide(a, b) if is_fixed(b) => (a, Constant::Times(Initial::Reciprocal(b))),
                Op::Negate(a) => (a, Constant::Minus),
                _ => break,
            };
            constants.push(constant);
            value = of;
        }
        (value, constants)
    }

    /// Returns the coefficient of order k of a value for which step k computes that of order k + 1.
    fn now(&mut self, pass: &mut Pass, value: ValueId) -> Coefficient {
        let index = self.carry(value);
        self.slot(pass, Slot::Carried(index))
    }

    fn carry(&mut self, value: ValueId) -> usize {
        self.carried.index_or_insert_with(value, || ())
    }

    /// Returns a fixed value in the first step, and zero afterwards.
    pub(super) fn first(&mut self, pass: &mut Pass, value: ValueId) -> Coefficient {
        let first = self.slot(pass, Slot::First);
        self.times_initial(pass, first, Initial::Value(value))
    }

    /// Returns a slot that contains the unknown with this index.
    fn unknown(&mut self, pass: &mut Pass, index: u32, slot: Slot) -> Coefficient {
        match pass.part {
            Part::Known => None,
            Part::Share => Some(self.slots.input(&mut pass.builder, slot)),
            Part::Unit(unknown) => (unknown == index).then(|| pass.builder.constant(Number::ONE)),
        }
    }

    /// Returns an input without a share of the accelerations.
    fn slot(&mut self, pass: &mut Pass, slot: Slot) -> Coefficient {
        (pass.part == Part::Known).then(|| self.slots.input(&mut pass.builder, slot))
    }

    /// Multiplies a coefficient by a slot that is one at order zero.
    fn times_slot(&mut self, pass: &mut Pass, coefficient: Coefficient, slot: Slot) -> Coefficient {
        let coefficient = coefficient?;
        if matches!(pass.part, Part::Unit(_)) {
            return Some(coefficient);
        }
        let factor = self.slots.input(&mut pass.builder, slot);
        Some(pass.builder.multiply(factor, coefficient))
    }

    fn times_initial(&mut self, pass: &mut Pass, coefficient: Coefficient, by: Initial) -> Coefficient {
        let coefficient = coefficient?;
        let factor = self.at_start(pass, by);
        Some(pass.builder.multiply(factor, coefficient))
    }

    fn at_start(&mut self, pass: &mut Pass, initial: Initial) -> ValueId {
        if let Initial::Value(value) = initial
            && let op @ (Op::Constant(_) | Op::Float(_)) = self.motion.program.op(value)
        {
            return pass.builder.push(op.clone());
        }
        let index = self.initial(initial);
        self.slots.input(&mut pass.builder, Slot::Initial(index))
    }

    pub(super) fn initial(&mut self, initial: Initial) -> usize {
        self.initials.index_or_insert_with(initial, || ())
    }

    pub(super) fn keep(&mut self, value: Multiple) -> usize {
        self.kept.index_or_insert_with(value, || ())
    }
}

impl Builder {
    /// Returns a + b, where `None` is zero.
    pub(super) fn sum(&mut self, a: Coefficient, b: Coefficient) -> Coefficient {
        match (a, b) {
            (Some(a), Some(b)) => Some(self.add(a, b)),
            (a, b) => a.or(b),
        }
    }

    /// Returns a − b, where `None` is zero.
    fn difference(&mut self, a: Coefficient, b: Coefficient) -> Coefficient {
        match (a, b) {
            (Some(a), Some(b)) => Some(self.subtract(a, b)),
            (None, Some(b)) => Some(self.negate(b)),
            (a, None) => a,
        }
    }
}
