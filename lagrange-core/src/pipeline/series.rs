//! Taylor series of a motion as two straight-line programs: the values at a state, and one order
//! after the other from these values.

use super::layout::Layout;
use lagrange_algebra::program::{Builder, Op, Program, ValueId, ValueTable, optimise};
use lagrange_algebra::series::{Groups, SeriesPrograms, Slot, TableArgument};
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::symbol::Role;

/// The Taylor series of a motion, by the operations of emitted code.
///
/// Step k = 0, 1, … computes coefficients of order k + 1 from *slots*: numbers that
/// [`SlotPlaces`] describes. [`ResultPlaces`] describes its results.
#[derive(Clone, Debug)]
pub struct MotionSeries {
    /// The first slots, from the arguments of the system: values at the state, then the matrix of
    /// the unknowns in the residuals, row by row.
    pub initial: Program,
    /// The results of one step. Its parameters are the slots.
    pub step: Program,
    /// Indices of the arguments of `step`.
    pub layout: Layout,
    /// Places of the slots.
    pub places: SlotPlaces,
    /// Places of the results.
    pub results: ResultPlaces,
    /// Number of unknown accelerations and multipliers, which is the number of rows of the matrix.
    /// There are none if accelerations are functions of the state.
    pub rows: usize,
    /// True if the matrix of the unknowns is positive definite.
    pub is_definite: bool,
    /// The shared factors of each group of products.
    pub of_group: Vec<usize>,
    /// Initial values that the first step takes in place of carried coefficients.
    pub carried: Vec<usize>,
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

/// Indices of the results of a step, after the coefficients of the state.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct ResultPlaces {
    /// Coefficients that the next step takes.
    pub carried: usize,
    /// Coefficients of the arguments of tables.
    pub arguments: usize,
    /// Shared factors of products, in fours.
    pub shared: usize,
    /// Other factors of each group, in fours.
    pub groups: usize,
    /// Number of results.
    pub end: usize,
}

impl MotionSeries {
    /// Merges the programs of a step of a state with this number of entries.
    pub(super) fn new(
        programs: SeriesPrograms,
        (entries, is_definite, accuracy): (usize, bool, Accuracy),
    ) -> MotionSeries {
        let groups = Groups::new(&programs);
        let unknowns = programs.expansion.outputs().len() - programs.kept;
        let places = SlotPlaces::new(&programs, &groups, unknowns);
        let results = ResultPlaces::new(entries, &programs, &groups);
        let step = Step { programs: &programs, groups: &groups, places, unknowns }.program(entries, accuracy);
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
            results,
            rows: unknowns,
            is_definite,
            of_group: groups.of_group,
            carried: programs.carried.iter().map(|(_, initial)| *initial).collect(),
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

impl ResultPlaces {
    fn new(entries: usize, programs: &SeriesPrograms, groups: &Groups) -> ResultPlaces {
        let arguments = entries + programs.carried.len();
        let shared = arguments + programs.arguments.len();
        let others = shared + 4 * groups.shared.len();
        let end = others + 4 * groups.groups.len();
        ResultPlaces { carried: entries, arguments, shared, groups: others, end }
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
    fn program(&self, entries: usize, accuracy: Accuracy) -> Program {
        let (mut builder, kept) = (Builder::new(), self.programs.kept);
        let expansion = optimise(&self.programs.expansion, accuracy);
        let partial = self.inserted(&mut builder, &expansion, &[], &[]);
        let corrected = self.programs.correction.as_ref().map(|correction| {
            let accelerations = self.accelerations(&mut builder, &partial[kept..]);
            self.inserted(&mut builder, &optimise(correction, accuracy), &partial, &accelerations)
        });
        let kept = corrected.unwrap_or(partial);
        builder.finish(&self.results(entries, &kept))
    }

    /// Arranges kept coefficients, as [`ResultPlaces`] describes.
    fn results(&self, entries: usize, kept: &[ValueId]) -> Vec<ValueId> {
        let carried = self.programs.carried.iter().map(|(place, _)| *place);
        let arguments = self.programs.arguments.iter().map(|argument| argument.kept);
        let factors = self.groups.shared.iter().chain(&self.groups.groups).flatten().copied();
        (0..entries).chain(carried).chain(arguments).chain(factors).map(|place| kept[place]).collect()
    }

    /// Computes (a, λ) = −M⁻¹ r block by block, each column by column.
    fn accelerations(&self, builder: &mut Builder, residuals: &[ValueId]) -> Vec<ValueId> {
        let mut accelerations = residuals.to_vec();
        for block in &self.programs.blocks {
            for &row in block {
                let mut sum = None;
                for &column in block {
                    let entry = slot(builder, self.places.inverse + column * self.unknowns + row);
                    sum = Some(match sum {
                        Some(sum) => builder.push(Op::MultiplyAdd(entry, residuals[column], sum)),
                        None => builder.multiply(entry, residuals[column]),
                    });
                }
                accelerations[row] = sum.unwrap_or(accelerations[row]);
            }
        }
        accelerations
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
