//! Programs of one step, from the coefficients of its values.

use super::coefficients::{Coefficient, Coefficients, Initial, Multiple, Part, Pass};
use super::kinds::Kind;
use super::linear::{Factors, flatten};
use super::schedule::Source;
use super::slots::Slot;
use super::{SeriesPrograms, TableArgument};
use crate::program::{Builder, Op, Program, ValueId, ValueTable};
use lagrange_expr::collections::coupled_blocks;
use lagrange_expr::expr::Relation;
use lagrange_expr::number::Number;
use lagrange_expr::opaque::Opaque;
use lagrange_expr::symbol::Role;

impl Coefficients<'_> {
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
        let unknowns = self.motion.residuals.len();
        let is_zero = |place: usize| matrix.op(matrix.outputs()[place]) == &Op::Constant(Number::ZERO);
        let blocks = coupled_blocks(unknowns, |i, j| !is_zero(i * unknowns + j));
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
            blocks,
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
        let outputs = roots.enumerate().map(|(place, Multiple { of, constants })| {
            let coefficient = match self.schedule.kinds[of] {
                // Fixed values are only kept if they are discrete states, which have no rate.
                Kind::Fixed if place < kept.len() => None,
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
