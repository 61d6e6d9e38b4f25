//! A complete derived system as straight-line programs and plain data, for interpretation and for
//! writers of other languages.
//!
//! Arguments of programs are the time t, the state y = `[q…, v…]` and the array p. The latter
//! begins with the declared parameters, and a [`Layout`] gives the index of each. Roots and names
//! of the programs are those of emitted code, so that results are bit-identical.

use super::drawn::DrawnScene;
use super::layout::Layout;
use super::series::MotionSeries;
use crate::derive::DiffusionKind;
use crate::emit::Variables;
use crate::model::Product;
use lagrange_algebra::program::{NewtonProgram, Op, Program};
use lagrange_expr::opaque::Opaque;
use lagrange_expr::symbol::Role;

/// A derived system as programs, with names, units, defaults and events as data.
#[derive(Clone, Debug)]
pub struct Programs {
    /// Name of the struct.
    pub name: String,
    /// Number by which emitted types distinguish declarations.
    pub fingerprint: u64,
    /// Names and units.
    pub variables: Variables,
    /// Indices of the arguments of programs.
    pub layout: Layout,
    /// Defaults of parameters and inputs; NaN without a default.
    pub defaults: Vec<f64>,
    /// Bounds of parameters.
    pub ranges: Vec<Range>,
    /// Quantities of contacts that are bounded.
    pub quantities: Vec<BoundedQuantity>,
    /// Each of these quantities with its bounds, functions of parameters alone.
    pub quantity_values: Program,
    /// Declared initial state, if any part of it is declared.
    pub start: Option<Program>,
    /// Rates of the positions.
    pub position_rates: Program,
    /// Accelerations, possibly followed by values that emitted code computes with them, and finally
    /// the growth of their rounding errors. With contacts or friction, they are those without
    /// reactions, and nothing follows.
    pub accelerations: Program,
    /// Inputs that are delayed signals, by index.
    pub delayed_inputs: Vec<usize>,
    /// Delayed signals at the time of their causes.
    pub delayed_signals: Program,
    /// Delayed signals before the start, functions of time and of the state at the start, if the
    /// declaration states a history.
    pub past_signals: Option<Program>,
    /// Delays of these signals, functions of parameters alone.
    pub lags: Program,
    /// Names of the noises.
    pub noises: Vec<String>,
    /// Diffusions of the noises, in rows.
    pub diffusion: Program,
    /// Dependence of the diffusions on the state.
    pub diffusion_kind: DiffusionKind,
    /// Multipliers, followed by the same growth of rounding errors. With contacts or friction, they
    /// are functions of the reactions.
    pub multipliers: Program,
    /// Number of these growth values.
    pub growths: usize,
    /// True if some constraints always follow from others, which leaves multipliers to the second
    /// method.
    pub is_redundant: bool,
    /// M and A in rows, f and b, from which the second method starts; nothing for large systems.
    pub undivided: Program,
    /// True for each constraint that contains positions.
    pub are_holonomic: Vec<bool>,
    /// Residuals of the constraints on positions; zero for others.
    pub position_residuals: Program,
    /// Change of velocities, or of positions, that removes residuals. The residuals replace the
    /// multipliers as arguments, and the same growth follows the results.
    pub correction: Program,
    /// M a for accelerations a.
    pub mass_times: Program,
    /// Functions whose signs are the sides of the switches.
    pub switches: Program,
    /// Times at which switches are passed, where known.
    pub switch_times: Vec<Option<Program>>,
    /// Functions of the events; one for events of contacts.
    pub event_functions: Program,
    /// Actions at the events.
    pub reactions: Vec<Reaction>,
    /// Clocks.
    pub clocks: Vec<TickingClock>,
    /// Products with their programs; Jacobians only have the rows of the accelerations.
    pub products: Vec<(Product, Program)>,
    /// ∂ẏ/∂y in rows, if requested.
    pub jacobian: Option<Program>,
    /// Derivatives of the rates with respect to parameters, then to inputs, in rows, if requested.
    pub parameter_jacobian: Option<Program>,
    /// Derivatives of the rates, then of the outputs, by the state, then by the inputs, in rows, if
    /// the system matrix is requested.
    pub linearised: Option<Program>,
    /// The system matrix [A B; C D; G 0] in rows, if requested. Its columns belong to
    /// displacements, first-order states, velocities and inputs.
    pub system_matrix: Option<Program>,
    /// Taylor series of the motion, if requested, or the reason why it has none.
    pub series: Option<Result<MotionSeries, String>>,
    /// Values of the parameters that multiply the columns of the regressor.
    pub regressor_parameters: Program,
    /// Outputs.
    pub outputs: Vec<(String, Program)>,
    /// The scene, if a drawing is requested.
    pub drawing: Option<DrawnScene>,
    /// Algebraic unknowns in the rates.
    pub unknowns: Vec<String>,
    /// Names of compliant contacts with round surfaces.
    pub round_contacts: Vec<String>,
    /// Distances of the centres in these contacts.
    pub distances: Program,
    /// Values of the algebraic unknowns.
    pub unknown_values: Program,
    /// Functions that solve equations.
    pub solutions: Vec<NewtonProgram>,
    /// Terms of contacts and friction, if there are any.
    pub touching: Option<TouchingPrograms>,
}

/// The terms of contacts and friction.
#[derive(Clone, Debug)]
pub struct TouchingPrograms {
    /// Free accelerations, responses and rows; gaps, rates, drifts, restitutions, kinetic and
    /// static limits; two slopes of limits for each pair in `slopes`. Without constraints,
    /// generalised forces replace the accelerations, responses are zero, and the matrices follow.
    pub terms: Program,
    /// The limited reaction and the reaction on which its limits depend.
    pub slopes: Vec<[usize; 2]>,
    /// Number of matrices: the mass matrix, then that of the dampers.
    pub matrices: usize,
}

/// The action at an event.
#[derive(Clone, Debug)]
pub enum Reaction {
    /// The event is recorded.
    Record,
    /// The motion ends.
    Stop,
    /// The motion continues from the state computed by the program.
    Replace(Program),
    /// A contact reacts.
    Impact,
}

/// A clock: its period, and the state after each tick.
#[derive(Clone, Debug)]
pub struct TickingClock {
    /// Period, a function of parameters alone.
    pub period: Program,
    /// State after a tick.
    pub after: Program,
}

/// Bounds of a parameter, with their inclusion.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Range {
    /// Index of the parameter.
    pub parameter: usize,
    /// Lower and upper bound, each with true if it is included.
    pub bounds: [Option<(f64, bool)>; 2],
}

/// A quantity of a contact that is bounded.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct BoundedQuantity {
    /// Description with the name of the contact.
    pub words: String,
    /// True for each bound that there is and that is included, lower and upper.
    pub bounds: [Option<bool>; 2],
}

impl Programs {
    /// Returns all programs except those of solutions and of the steps of series.
    pub fn all(&self) -> impl Iterator<Item = &Program> {
        let of_motion = [&self.position_rates, &self.accelerations, &self.multipliers, &self.undivided];
        let of_constraints =
            [&self.position_residuals, &self.correction, &self.mass_times, &self.regressor_parameters];
        let of_events = [&self.switches, &self.event_functions, &self.unknown_values, &self.diffusion];
        let of_contacts = [&self.quantity_values, &self.distances];
        let of_delays = [&self.delayed_signals, &self.lags].into_iter().chain(&self.past_signals);
        let replaced = self.reactions.iter().filter_map(|reaction| match reaction {
            Reaction::Replace(program) => Some(program),
            _ => None,
        });
        let of_clocks = self.clocks.iter().flat_map(|clock| [&clock.period, &clock.after]);
        let values = self.products.iter().map(|(_, program)| program);
        let outputs = self.outputs.iter().map(|(_, program)| program);
        let of_series = self.known_series().map(|series| &series.initial);
        let others = self
            .start
            .iter()
            .chain(&self.jacobian)
            .chain(&self.parameter_jacobian)
            .chain(&self.linearised)
            .chain(&self.system_matrix)
            .chain(self.drawing.iter().flat_map(DrawnScene::programs))
            .chain(self.switch_times.iter().flatten())
            .chain(of_series)
            .chain(self.touching.as_ref().map(|touching| &touching.terms));
        let fixed = of_motion.into_iter().chain(of_constraints).chain(of_events).chain(of_contacts);
        fixed.chain(of_delays).chain(replaced).chain(of_clocks).chain(values).chain(outputs).chain(others)
    }

    /// Returns the functions of the user's crate called by programs, without repetition.
    pub fn functions(&self) -> Vec<Opaque> {
        let mut called = Vec::new();
        let of_solutions = self.solutions.iter().flat_map(|solution| [&solution.start, &solution.equation]);
        for (_, op) in self.all().chain(of_solutions).flat_map(Program::values) {
            if let Op::Opaque(function, _) = op
                && function.table().is_none()
                && !function.is_solution()
                && !called.contains(function)
            {
                called.push(function.clone());
            }
        }
        called
    }

    /// Returns the Taylor series of the motion, if they were requested and exist.
    pub fn known_series(&self) -> Option<&MotionSeries> {
        self.series.as_ref()?.as_ref().ok()
    }

    /// Returns the program of a product, if it was derived.
    pub fn product(&self, product: Product) -> Option<&Program> {
        self.products.iter().find(|(known, _)| *known == product).map(|(_, program)| program)
    }
}

/// True if a program uses an argument whose role has this property.
pub(super) fn takes(program: &Program, has: impl Fn(Role) -> bool) -> bool {
    program.values().any(|(_, op)| matches!(op, Op::Input(role) if has(*role)))
}
