//! Programs of one step, constructed value by value.

use super::kinds::Kind;
use super::linear::{Factors, flatten};
use super::schedule::{Schedule, Source};
use super::slots::{Slot, Slots};
use super::{Motion, SeriesPrograms, TableArgument};
use crate::program::{Builder, Op, Program, ValueId, ValueTable};
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::expr::{Function, Relation};
use lagrange_expr::number::Number;
use lagrange_expr::opaque::Opaque;
use lagrange_expr::symbol::Role;

/// A coefficient in a program of one step; `None` is zero.
type Coefficient = Option<ValueId>;

/// A value of order zero.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
enum Initial {
    /// x₀
    Value(ValueId),
    /// 1/x₀
    Reciprocal(ValueId),
    /// 1/(2 x₀), or 0 if x₀ is 0
    HalfReciprocal(ValueId),
}

/// A constant factor of a value.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
enum Constant {
    Minus,
    Times(Initial),
}

/// A multiple of a value.
#[derive(Clone, PartialEq, Eq, Hash)]
struct Multiple {
    of: ValueId,
    constants: Vec<Constant>,
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

/// Programs under construction.
pub(super) struct Recurrence<'a> {
    motion: &'a Motion<'a>,
    schedule: &'a Schedule,
    constants: Constants,
    slots: Slots,
    initials: OrderedMap<Initial, ()>,
    kept: OrderedMap<Multiple, ()>,
    sums: OrderedMap<[usize; 2], ()>,
    carried: OrderedMap<ValueId, ()>,
}

/// The part of coefficients that a pass computes.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    /// Everything except the share of the unknowns, which are accelerations and multipliers.
    Known,
    /// The share of all unknowns.
    Share,
    /// The share of this unknown at order zero, as if it were one.
    Unit(u32),
}

/// The coefficients of one order.
struct Pass {
    builder: Builder,
    coefficients: ValueTable<Coefficient>,
    part: Part,
}

impl<'a> Recurrence<'a> {
    pub(super) fn new(
        motion: &'a Motion<'a>,
        schedule: &'a Schedule,
        constants: Constants,
    ) -> Recurrence<'a> {
        let mut kept = OrderedMap::default();
        for entry in motion.state {
            kept.insert(Multiple::from(entry.value), ());
        }
        Recurrence {
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

    pub(super) fn programs(mut self) -> SeriesPrograms {
        let expansion = self.pass(Builder::new(), Part::Known);
        // The values that the next step needs are known at this point.
        let carried = self.carried.iter().map(|(value, ())| *value).collect::<Vec<_>>();
        for &value in &carried {
            self.keep(value.into());
        }
        let arguments = self.arguments();
        let kept = self.kept.iter().map(|(value, ())| value.clone()).collect::<Vec<_>>();
        let correction = (!self.motion.residuals.is_empty()).then(|| {
            let mut share = self.pass(Builder::new(), Part::Share);
            let corrected = (0..kept.len()).map(|place| self.corrected(&mut share, &kept[place], place));
            let corrected = corrected.collect::<Vec<_>>();
            share.builder.finish(&corrected)
        });
        let expansion = self.finished(expansion, &kept);
        let carried =
            carried.into_iter().map(|value| (self.keep(value.into()), self.initial(Initial::Value(value))));
        let carried = carried.collect();
        let matrix = self.matrix();
        let (initials, mut factors) = (self.initials.len(), Factors::default());
        let mut flat = |program: &Program| flatten(program, &mut self.slots, initials, &mut factors);
        let (expansion, correction) = (flat(&expansion), correction.as_ref().map(flat));
        let factors = factors.program();
        SeriesPrograms {
            initial: self.initial_program(&factors, &matrix),
            initials: initials + factors.outputs().len(),
            expansion,
            correction,
            sums: self.sums.iter().map(|(factors, ())| *factors).collect(),
            carried,
            arguments,
            slots: self.slots.list(),
            kept: kept.len(),
        }
    }

    /// Keeps the moving arguments of all tables.
    fn arguments(&mut self) -> Vec<TableArgument> {
        let mut found = Vec::new();
        for &value in &self.schedule.order {
            let Op::Opaque(function, arguments) = self.motion.program.op(value) else { continue };
            if function.table().is_none() {
                continue;
            }
            for (axis, &argument) in arguments.iter().enumerate() {
                if self.schedule.kinds[argument] == Kind::Moving {
                    let table = Opaque::value_of(function.function().clone());
                    let (kept, initial) =
                        (self.keep(argument.into()), self.initial(Initial::Value(argument)));
                    let argument = TableArgument { table, axis, kept, initial };
                    if !found.contains(&argument) {
                        found.push(argument);
                    }
                }
            }
        }
        found
    }

    fn finished(&mut self, mut pass: Pass, kept: &[Multiple]) -> Program {
        let residuals = self.motion.residuals.iter().map(|&residual| Multiple::from(residual));
        let roots = kept.iter().cloned().chain(residuals);
        let outputs = roots.map(|Multiple { of, constants }| {
            let coefficient = match self.schedule.kinds[of] {
                Kind::Fixed => self.first(&mut pass, of),
                _ => pass.coefficients[of],
            };
            let multiple = self.times(&mut pass, coefficient, &constants);
            multiple.unwrap_or_else(|| pass.builder.constant(Number::ZERO))
        });
        let outputs = outputs.collect::<Vec<_>>();
        pass.builder.finish(&outputs)
    }

    /// Returns a kept value with the share of the accelerations.
    fn corrected(&mut self, share: &mut Pass, value: &Multiple, place: usize) -> ValueId {
        let is_velocity = matches!(self.schedule.source(self.motion, value.of), Source::Velocity(_));
        let is_all = is_velocity && value.constants.is_empty();
        let partial = (!is_all).then(|| self.slots.input(&mut share.builder, Slot::Partial(place)));
        let of_accelerations = self.times(share, share.coefficients[value.of], &value.constants);
        let total = share.builder.sum(partial, of_accelerations);
        total.unwrap_or_else(|| share.builder.constant(Number::ZERO))
    }

    /// Returns the program of the matrix of the unknowns in the residuals, row by row, from the
    /// shares of each unknown.
    fn matrix(&mut self) -> Program {
        let (mut builder, mut columns) = (Builder::new(), Vec::new());
        let unknowns = 0..self.motion.residuals.len();
        for unknown in unknowns.clone() {
            let pass = self.pass(builder, Part::Unit(unknown as u32));
            columns.push(self.motion.residuals.iter().map(|&residual| pass.coefficients[residual]).collect());
            builder = pass.builder;
        }
        let zero = builder.constant(Number::ZERO);
        let row = |i: usize| columns.iter().map(move |column: &Vec<Coefficient>| column[i].unwrap_or(zero));
        let entries = unknowns.flat_map(row).collect::<Vec<_>>();
        builder.finish(&entries)
    }

    fn pass(&mut self, builder: Builder, part: Part) -> Pass {
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
            Source::Velocity(index) => {
                let acceleration = self.acceleration(pass, index);
                self.times_slot(pass, acceleration, Slot::Reciprocal)
            }
            Source::Acceleration(index) => self.acceleration(pass, index),
            Source::Previous(of) if self.schedule.kinds[of] == Kind::Fixed => self.first(pass, of),
            Source::Previous(of) => self.now(pass, of),
            Source::Rate(of) => self.times_slot(pass, pass.coefficients[of], Slot::Order),
            Source::Integral(rate) => {
                let rate = match self.schedule.kinds[rate] {
                    Kind::Accelerated => pass.coefficients[rate],
                    Kind::Fixed => self.first(pass, rate),
                    _ => self.now(pass, rate),
                };
                self.times_slot(pass, rate, Slot::Reciprocal)
            }
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
    fn times(&mut self, pass: &mut Pass, coefficient: Coefficient, constants: &[Constant]) -> Coefficient {
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
        let index = self.carried.index_or_insert_with(value, || ());
        self.slot(pass, Slot::Carried(index))
    }

    /// Returns a fixed value in the first step, and zero afterwards.
    fn first(&mut self, pass: &mut Pass, value: ValueId) -> Coefficient {
        let first = self.slot(pass, Slot::First);
        self.times_initial(pass, first, Initial::Value(value))
    }

    fn acceleration(&mut self, pass: &mut Pass, index: u32) -> Coefficient {
        match pass.part {
            Part::Known => None,
            Part::Share => Some(self.slots.input(&mut pass.builder, Slot::Acceleration(index))),
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

    fn initial(&mut self, initial: Initial) -> usize {
        self.initials.index_or_insert_with(initial, || ())
    }

    fn keep(&mut self, value: Multiple) -> usize {
        self.kept.index_or_insert_with(value, || ())
    }

    fn initial_program(&self, factors: &Program, matrix: &Program) -> Program {
        let program = self.motion.program;
        let mut builder = Builder::new();
        let mut image = ValueTable::with_capacity(program.len());
        for (id, op) in program.values() {
            let value = builder.push(op.map_operands(|operand| image[operand]));
            if let Some(name) = program.hint(id) {
                builder.propose_name(value, name);
            }
            image.push(value);
        }
        let values = self.initials.iter().map(|(initial, ())| match *initial {
            Initial::Value(of) => image[of],
            Initial::Reciprocal(of) => {
                let one = builder.constant(Number::ONE);
                builder.divide(one, image[of])
            }
            Initial::HalfReciprocal(of) => {
                let (half, zero) = (builder.constant(Number::HALF), builder.constant(Number::ZERO));
                let otherwise = builder.divide(half, image[of]);
                let relation = Relation::LessEqual;
                builder.push(Op::Select { relation, left: image[of], right: zero, then: zero, otherwise })
            }
        });
        let mut outputs = values.collect::<Vec<_>>();
        for program in [factors, matrix] {
            let more = self.inserted(&mut builder, program, &outputs);
            outputs.extend(more);
        }
        builder.finish(&outputs)
    }

    /// Computes the outputs of a program over slots of initial values from these values.
    fn inserted(&self, builder: &mut Builder, program: &Program, initials: &[ValueId]) -> Vec<ValueId> {
        let slots = self.slots.list();
        let mut image = ValueTable::with_capacity(program.len());
        for (_, op) in program.values() {
            let slot = match op {
                Op::Input(Role::Placeholder(index)) => slots.get(*index as usize),
                _ => None,
            };
            image.push(match slot {
                Some(Slot::Initial(index)) => initials[*index],
                _ => builder.push(op.map_operands(|operand| image[operand])),
            });
        }
        program.outputs().iter().map(|&output| image[output]).collect()
    }
}

impl Builder {
    /// Returns a + b, where `None` is zero.
    fn sum(&mut self, a: Coefficient, b: Coefficient) -> Coefficient {
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
