//! Taylor series of a motion as two straight-line programs: the values at a state, and one order
//! after the other from these values.

use super::programs::Layout;
use lagrange_algebra::program::{Builder, Op, Program, ValueId, ValueTable, optimise};
use lagrange_algebra::series::{Groups, SeriesPrograms, Slot, TableArgument};
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::symbol::Role;

/// The Taylor series of a motion, by the operations of emitted code.
///
/// Step k = 0, 1, … computes coefficients of order k + 1 from *slots*: numbers that
/// [`SlotPlaces`] describes. Each step keeps some coefficients for later ones, those of the state
/// first.
#[derive(Clone, Debug)]
pub struct MotionSeries {
    /// The first slots, from the arguments of the system: values at the state, then the matrix of
    /// the unknown accelerations and multipliers in the residuals, row by row.
    pub initial: Program,
    /// The kept coefficients of one step. Its parameters are the slots.
    pub step: Program,
    /// Indices of the arguments of `step`.
    pub layout: Layout,
    /// Places of the slots.
    pub places: SlotPlaces,
    /// Number of unknowns, zero if accelerations are functions of the state.
    pub unknowns: usize,
    /// True if the matrix of the unknowns is positive definite.
    pub is_definite: bool,
    /// Sums of products of kept coefficients.
    pub groups: Groups,
    /// Kept coefficients that the next step takes, with the initial values that the first step
    /// takes.
    pub carried: Vec<(usize, usize)>,
    /// Arguments of tables.
    pub arguments: Vec<TableArgument>,
}

/// Indices of the slots of a step.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SlotPlaces {
    /// −M⁻¹ in columns, which replaces the matrix M of the unknowns after the initial values.
    pub inverse: usize,
    /// k + 1, its reciprocal, and a number that is one in the first step and zero in all others.
    pub order: usize,
    /// Carried coefficients.
    pub carried: usize,
    /// Sums of products, four for each group.
    pub sums: usize,
    /// Number of slots.
    pub end: usize,
}

impl MotionSeries {
    /// Merges the programs of a step.
    pub(super) fn new(programs: SeriesPrograms, is_definite: bool, accuracy: Accuracy) -> MotionSeries {
        let groups = Groups::new(&programs.sums);
        let unknowns = programs.expansion.outputs().len() - programs.kept;
        let places = SlotPlaces::new(&programs, &groups, unknowns);
        let step = Step { programs: &programs, groups: &groups, places, unknowns }.program(accuracy);
        MotionSeries {
            initial: optimise(&programs.initial, accuracy),
            step,
            layout: Layout {
                positions: 0,
                velocities: 0,
                parameters: places.end,
                inputs: 0,
                sides: 0,
                multipliers: 0,
                reactions: 0,
            },
            places,
            unknowns,
            is_definite,
            groups,
            carried: programs.carried,
            arguments: programs.arguments,
        }
    }
}

impl SlotPlaces {
    fn new(programs: &SeriesPrograms, groups: &Groups, unknowns: usize) -> SlotPlaces {
        let inverse = programs.initials;
        let order = inverse + unknowns * unknowns;
        let carried = order + 3;
        let sums = carried + programs.carried.len();
        SlotPlaces { inverse, order, carried, sums, end: sums + 4 * groups.groups.len() }
    }
}

/// The program of a step under construction.
struct Step<'a> {
    programs: &'a SeriesPrograms,
    groups: &'a Groups,
    places: SlotPlaces,
    unknowns: usize,
}

impl Step<'_> {
    /// Computes coefficients as if accelerations were zero, then the accelerations, and corrects
    /// the coefficients. Both parts are optimised apart, as in emitted code, for the same bits.
    fn program(&self, accuracy: Accuracy) -> Program {
        let (mut builder, kept) = (Builder::new(), self.programs.kept);
        let expansion = optimise(&self.programs.expansion, accuracy);
        let partial = self.inserted(&mut builder, &expansion, &[], &[]);
        let Some(correction) = &self.programs.correction else { return builder.finish(&partial) };
        let accelerations = self.accelerations(&mut builder, &partial[kept..]);
        let correction = optimise(correction, accuracy);
        let corrected = self.inserted(&mut builder, &correction, &partial, &accelerations);
        builder.finish(&corrected)
    }

    /// Computes (a, λ) = −M⁻¹ r, column by column.
    fn accelerations(&self, builder: &mut Builder, residuals: &[ValueId]) -> Vec<ValueId> {
        let mut sums: Vec<ValueId> = Vec::new();
        for (column, &residual) in residuals.iter().enumerate() {
            for row in 0..self.unknowns {
                let entry = slot(builder, self.places.inverse + column * self.unknowns + row);
                match sums.get(row).copied() {
                    Some(sum) => sums[row] = builder.push(Op::MultiplyAdd(entry, residual, sum)),
                    None => sums.push(builder.multiply(entry, residual)),
                }
            }
        }
        sums
    }

    /// Computes the outputs of a program over the slots of [`SeriesPrograms`].
    fn inserted(
        &self,
        builder: &mut Builder,
        program: &Program,
        partial: &[ValueId],
        accelerations: &[ValueId],
    ) -> Vec<ValueId> {
        let mut image = ValueTable::with_capacity(program.len());
        for (_, op) in program.values() {
            image.push(match op {
                Op::Input(Role::Placeholder(index)) => match self.programs.slots[*index as usize] {
                    Slot::Partial(index) => partial[index],
                    Slot::Acceleration(index) => accelerations[index as usize],
                    Slot::Velocity(index) => self.divided(builder, accelerations[index as usize]),
                    other => self.read(builder, other),
                },
                _ => builder.push(op.map_operands(|operand| image[operand])),
            });
        }
        program.outputs().iter().map(|&output| image[output]).collect()
    }

    fn read(&self, builder: &mut Builder, of: Slot) -> ValueId {
        let SlotPlaces { order, carried, sums, .. } = self.places;
        match of {
            Slot::Initial(index) => slot(builder, index),
            Slot::Carried(index) => slot(builder, carried + index),
            Slot::Integral(index) => {
                let dividend = slot(builder, carried + index);
                self.divided(builder, dividend)
            }
            Slot::Sum(index) => {
                let [group, lane] = self.groups.of_product[index];
                slot(builder, sums + 4 * group + lane)
            }
            Slot::Order => slot(builder, order),
            Slot::Reciprocal => slot(builder, order + 1),
            Slot::First => slot(builder, order + 2),
            Slot::Partial(_) | Slot::Acceleration(_) | Slot::Velocity(_) => {
                unreachable!("{of:?} is a value of the step")
            }
        }
    }

    /// Divides by k + 1.
    fn divided(&self, builder: &mut Builder, dividend: ValueId) -> ValueId {
        let order = slot(builder, self.places.order);
        builder.divide(dividend, order)
    }
}

fn slot(builder: &mut Builder, place: usize) -> ValueId {
    builder.push(Op::Input(Role::Parameter(place as u32)))
}
