//! A checked model: with resolved names and expressions of the right kind.

mod product;
mod samples;
mod scene;

use proc_macro2::Span;

use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::symbol::Role;
use lagrange_expr::units::NamedUnits;
use lagrange_language::syntax::ast::{Direction, Name};

pub use product::{Availability, Extent, Product, ProductArguments, ProductMethod, ProductRow, ProductShape};
pub(crate) use samples::{Entry, default_values, entries, may_be_flat, sample_values};
pub use scene::{
    BodyMotion, DrawnItem, InertialBody, LinkPose, LinkTwist, OutlinedPart, SampledHeight, Scene,
};

/// Meaning of a declaration, as expressions of one graph.
#[derive(Clone, Debug)]
pub struct Model {
    /// Owns all expressions.
    pub graph: Graph,
    /// Run-time parameters in declaration order.
    pub parameters: Vec<Parameter>,
    /// Inputs in declaration order.
    pub inputs: Vec<Parameter>,
    /// White noises in declaration order; forces and rates of the model exclude them.
    pub noises: Vec<Noise>,
    /// Inputs that are delayed signals.
    pub delays: Vec<Delay>,
    /// Positions in state order: generalised coordinates and components of unit quaternions, at
    /// least one, then first-order states.
    pub coordinates: Vec<Coordinate>,
    /// Generalised velocities in state order, one for each freedom.
    pub speeds: Vec<Speed>,
    /// Orientations in unit quaternions.
    pub orientations: Vec<Orientation>,
    /// Initial state [q…, v…], of numbers and parameters; empty if none is declared.
    pub start: Vec<ExprId>,
    /// The energies as declared.
    pub energies: Energies,
    /// L = T − V, or as declared.
    pub lagrangian: ExprId,
    /// Gibbs function that states the equations of motion of part of the Lagrangian.
    pub gibbs: Option<GibbsFunction>,
    /// The Rayleigh function, whose gradient with respect to v is subtracted from the forces.
    pub dissipation: ExprId,
    /// Applied forces and torques.
    pub loads: Vec<Load>,
    /// Constraints on coordinates and velocities, in declaration order.
    pub constraints: Vec<Constraint>,
    /// Names of constraints of joints that are omitted, since the coordinates satisfy them.
    pub implied: Vec<String>,
    /// The rate κ at which constraints are stabilised: c̈ + 2 κ ċ + κ² c = 0; constant in motion.
    pub stabilisation: Option<ExprId>,
    /// Declared events.
    pub events: Vec<Event>,
    /// Declared clocks.
    pub clocks: Vec<Clock>,
    /// Contacts and friction, in declaration order.
    pub reactions: Vec<Reaction>,
    /// Declared outputs.
    pub outputs: Vec<Output>,
    /// Rigid bodies, as far as they are requested.
    pub scene: Scene,
    /// Velocities known to be rates, with their variables: `(u, x)` with u = dx/dt.
    pub rates: Vec<(ExprId, ExprId)>,
    /// The user's names for expressions, in the order of preference.
    pub labels: Vec<(ExprId, String)>,
    /// Units of parameters, inputs, coordinates, velocities and outputs, as far as they are known.
    pub units: NamedUnits,
    /// The requested level of accuracy.
    pub accuracy: Accuracy,
    /// The products to emit, in the order of [`Product::ALL`].
    pub products: Vec<Product>,
    /// The reduced types, in the order of their declaration.
    pub reduced: Vec<Reduced>,
}

/// A model derived from another one, with fewer or with small coordinates.
#[derive(Clone, Debug)]
pub struct Reduced {
    /// Reduction; values are expressions of the reduced model.
    pub reduction: Reduction,
    /// Resulting model. It has no reductions itself.
    pub model: Model,
}

/// Changes to the coordinates that reduce a model.
#[derive(Clone, Debug)]
pub struct Reduction {
    /// Name of the reduced type.
    pub name: Name,
    /// Coordinates held at a value.
    pub frozen: Vec<Pinned>,
    /// Coordinates that remain near a value.
    pub small: Vec<Pinned>,
    /// Cyclic coordinates whose momenta are parameters, in state order; they have no values.
    pub ignored: Vec<Pinned>,
}

/// A coordinate and a value that is constant in motion.
#[derive(Clone, Debug)]
pub struct Pinned {
    /// Index of the coordinate in the original model.
    pub coordinate: usize,
    /// Value of the coordinate.
    pub value: ExprId,
    /// Position of the coordinate's name.
    pub span: Span,
}

/// A parameter or an input.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Name of the parameter.
    pub name: String,
    /// Symbol of the parameter.
    pub symbol: ExprId,
    /// Default value, free of symbols.
    pub default: Option<ExprId>,
    /// Lower and upper bound of the values.
    pub range: [Option<Bound>; 2],
}

/// A white noise.
#[derive(Clone, Debug)]
pub struct Noise {
    /// Name of the noise.
    pub name: String,
    /// Two-sided spectral density.
    pub density: ExprId,
    /// For each load, a velocity and the force along it per unit of the noise.
    pub loads: Vec<(ExprId, ExprId)>,
    /// For each state, its position and its rate per unit of the noise.
    pub rates: Vec<(ExprId, ExprId)>,
}

/// An input with the past value of a signal.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Delay {
    /// Index of the input.
    pub input: usize,
    /// Signal, a function of time, the state and inputs.
    pub signal: ExprId,
    /// Delay of the signal, a function of parameters alone.
    pub lag: ExprId,
}

/// A bound of the values of a parameter.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Bound {
    /// Value of the bound, free of symbols.
    pub value: ExprId,
    /// True if a parameter may have this value.
    pub is_included: bool,
}

/// A position: a generalised coordinate, a component of a unit quaternion, or a first-order or
/// discrete state.
#[derive(Clone, Debug)]
pub struct Coordinate {
    /// Name of the position.
    pub name: String,
    /// q
    pub position: ExprId,
    /// q̇, a function of positions and generalised velocities, linear in the velocities; for a
    /// first-order state, any function of time, positions, velocities and inputs
    pub rate: ExprId,
    /// True if it is a state, which displacements do not change.
    pub is_state: bool,
    /// Its range and nominal value.
    pub limits: EntryLimits,
}

/// The range and the nominal value of an entry of the state.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct EntryLimits {
    /// Lower and upper bound, each with true if it is included.
    pub bounds: [Option<(f64, bool)>; 2],
    /// The magnitude that counts as one, if it is declared.
    pub nominal: Option<f64>,
}

impl EntryLimits {
    /// True if a value is in the range.
    pub(crate) fn contains(&self, value: f64) -> bool {
        let [lower, upper] = self.bounds;
        let is_above = lower.is_none_or(|(bound, included)| value > bound || included && value == bound);
        is_above && upper.is_none_or(|(bound, included)| value < bound || included && value == bound)
    }
}

/// A generalised velocity, called generalised speed by Kane: the rate of a coordinate, or a
/// component of an angular velocity.
#[derive(Clone, Debug)]
pub struct Speed {
    /// Name in the state.
    pub name: String,
    /// Index of the coordinate whose rate it is; `None` for an angular velocity.
    pub coordinate: Option<usize>,
    /// v
    pub velocity: ExprId,
    /// v̇
    pub acceleration: ExprId,
    /// Its range and nominal value.
    pub limits: EntryLimits,
}

/// An orientation as a unit quaternion among the positions, with the angular velocity in the
/// rotated axes among the velocities.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Orientation {
    /// Index of the scalar part among the positions; the vector part follows.
    pub position: usize,
    /// Index of the first component of the angular velocity among the velocities; the others
    /// follow.
    pub velocity: usize,
}

/// The energies of a system.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Energies {
    /// L = T − V
    Separate {
        /// T
        kinetic: ExprId,
        /// V
        potential: ExprId,
    },
    /// L as declared
    Lagrangian,
    /// L is the Routhian, which does not separate into T and V.
    Routhian {
        /// T with all velocities, including those of ignored coordinates.
        kinetic: ExprId,
        /// V
        potential: ExprId,
    },
}

/// A function S of the accelerations a, whose slopes are inertial forces: ∂S/∂a = d/dt ∂F/∂v −
/// ∂F/∂q for part F of the Lagrangian.
#[derive(Clone, Copy, Debug)]
pub struct GibbsFunction {
    /// S, at most quadratic in the accelerations.
    pub function: ExprId,
    /// F
    pub stated: ExprId,
}

/// A force along a velocity, with the power `force · velocity`.
#[derive(Clone, Debug)]
pub struct Load {
    /// Name of the statement, shared by its other components.
    pub name: String,
    /// Velocity, affine in v.
    pub velocity: ExprId,
    /// Force component.
    pub force: ExprId,
}

/// A constraint.
#[derive(Clone, Debug)]
pub struct Constraint {
    /// Name of the constraint.
    pub name: String,
    /// Function of t and q, or affine in v, that the constraint sets to zero.
    pub value: ExprId,
    /// Function of the velocities that must be zero: the rate of `value` or, if this contains
    /// velocities, `value` itself.
    pub velocity: ExprId,
    /// True if `value` is a function of t and q.
    pub is_holonomic: bool,
    /// Symbol of the multiplier.
    pub multiplier: ExprId,
}

/// A declared output.
#[derive(Clone, Debug)]
pub struct Output {
    /// Name of the output.
    pub name: String,
    /// One expression for a scalar, two or three for a vector.
    pub components: Vec<ExprId>,
    /// True if it depends on the accelerations.
    pub uses_accelerations: bool,
    /// True if it depends on the multipliers.
    pub uses_multipliers: bool,
    /// True if it depends on the forces of contacts or of friction.
    pub uses_reactions: bool,
    /// Meaning of the output, if it is derived instead of declared.
    pub description: Option<String>,
}

/// A zero to be found during a motion, and the action at it.
#[derive(Clone, Debug)]
pub struct Event {
    /// Name of the event.
    pub name: String,
    /// Function of t, q and v, accelerations and multipliers, whose zeros are the event.
    pub value: ExprId,
    /// Direction of relevant zeros.
    pub direction: Direction,
    /// Action at the event.
    pub action: Action,
}

/// Assignments at the multiples of a period.
#[derive(Clone, Debug)]
pub struct Clock {
    /// Period, a function of parameters.
    pub period: ExprId,
    /// Simultaneous assignments at each tick.
    pub assignments: Vec<Assignment>,
}

/// Action at an event.
#[derive(Clone, Debug)]
pub enum Action {
    /// The motion ends.
    Stop,
    /// The run continues.
    Record,
    /// Bodies touch: the contact with this index among [`Model::reactions`].
    Impact(u32),
    /// Entries of the state are assigned new values simultaneously.
    Assign(Vec<Assignment>),
}

/// An entry of the state and its value after an event.
#[derive(Clone, Copy, Debug)]
pub struct Assignment {
    /// Index in [q…, v…], where q has one entry for each position.
    pub index: usize,
    /// New value, a function of t, q and v before the event.
    pub value: ExprId,
}

/// A contact or dry friction, with a force along the gradient of a velocity.
#[derive(Clone, Debug)]
pub struct Reaction {
    /// Name of the reaction.
    pub name: String,
    /// Symbol of the force.
    pub symbol: ExprId,
    /// Rate of the gap, or the slip velocity, affine in q̇.
    pub velocity: ExprId,
    /// Law of the force.
    pub kind: ReactionKind,
}

/// Law of the force of a contact or of friction.
#[derive(Clone, Copy, Debug)]
pub enum ReactionKind {
    /// A unilateral contact.
    Contact {
        /// Function of t and q, positive if bodies are apart.
        gap: ExprId,
        /// Coefficient of restitution, a function of t, q and v.
        restitution: ExprId,
    },
    /// Dry friction that sticks and slips. Limits are functions of t, q and v, affine in
    /// multipliers and in the forces of previously declared reactions.
    Friction {
        /// Magnitude of the force while slipping.
        kinetic: ExprId,
        /// Maximum magnitude of the force while sticking.
        fixed: ExprId,
    },
    /// The second component of friction in a plane, with the limits of the previous reaction. They
    /// bound the magnitude of the vector.
    Across {
        /// Magnitude while slipping.
        kinetic: ExprId,
        /// Maximum magnitude while sticking.
        fixed: ExprId,
    },
    /// Friction that only slips: the force is −limit · tanh(velocity / width).
    Smooth {
        /// Magnitude of the force far from velocity zero, a limit like those above.
        limit: ExprId,
        /// Velocity, constant in motion.
        width: ExprId,
    },
}

impl Energies {
    /// Returns T and V, if the energies are known separately.
    pub fn parts(self) -> Option<[ExprId; 2]> {
        match self {
            Energies::Separate { kinetic, potential } | Energies::Routhian { kinetic, potential } => {
                Some([kinetic, potential])
            }
            Energies::Lagrangian => None,
        }
    }

    /// Returns mutable references to T and V.
    pub fn parts_mut(&mut self) -> impl Iterator<Item = &mut ExprId> {
        let parts = match self {
            Energies::Separate { kinetic, potential } | Energies::Routhian { kinetic, potential } => {
                Some([kinetic, potential])
            }
            Energies::Lagrangian => None,
        };
        parts.into_iter().flatten()
    }
}

impl ReactionKind {
    /// True if the reaction has its own mode, switched by events.
    pub fn has_mode(self) -> bool {
        !matches!(self, ReactionKind::Smooth { .. } | ReactionKind::Across { .. })
    }
}

impl Model {
    /// Returns the ranges and nominal values of the entries of the state. A velocity has the
    /// nominal value of its coordinate unless it has its own.
    pub fn entry_limits(&self) -> Vec<EntryLimits> {
        let positions = self.coordinates.iter().map(|coordinate| coordinate.limits);
        let velocities = self.speeds.iter().map(|speed| {
            let of_coordinate = speed.coordinate.and_then(|index| self.coordinates[index].limits.nominal);
            EntryLimits { nominal: speed.limits.nominal.or(of_coordinate), ..speed.limits }
        });
        positions.chain(velocities).collect()
    }

    /// Returns the generalised velocities in state order.
    pub fn velocities(&self) -> Vec<ExprId> {
        self.speeds.iter().map(|speed| speed.velocity).collect()
    }

    /// Returns the unknowns of the equations of motion: rates of the velocities, and multipliers.
    pub fn unknowns(&self) -> Vec<ExprId> {
        let mut unknowns = self.velocities();
        unknowns.extend(self.multipliers());
        unknowns
    }

    /// Returns the multipliers in the order of the constraints.
    pub fn multipliers(&self) -> Vec<ExprId> {
        self.constraints.iter().map(|constraint| constraint.multiplier).collect()
    }

    /// Returns the name of a velocity in messages: the name of the coordinate whose rate it is.
    pub fn name_of_freedom(&self, index: usize) -> &str {
        let speed = &self.speeds[index];
        speed.coordinate.map_or(&speed.name, |coordinate| &self.coordinates[coordinate].name)
    }

    /// Returns the rates of the positions, functions of positions and velocities.
    pub fn position_rates(&self) -> Vec<ExprId> {
        self.coordinates.iter().map(|coordinate| coordinate.rate).collect()
    }

    /// Returns the state [q…, v…] after simultaneous assignments.
    pub fn state_after(&self, assignments: &[Assignment]) -> Vec<ExprId> {
        let mut state = [self.positions(), self.velocities()].concat();
        assignments.iter().for_each(|assignment| state[assignment.index] = assignment.value);
        state
    }

    /// Returns the role of a position.
    pub fn role_of_position(&self, index: usize) -> Role {
        let coordinate = self.coordinates.get(index);
        let symbol = coordinate.and_then(|coordinate| self.graph.symbol_of(coordinate.position));
        symbol.map_or(Role::Coordinate(index as u32), |symbol| symbol.role)
    }

    /// Returns the states in order.
    pub fn states(&self) -> impl Iterator<Item = &Coordinate> {
        self.coordinates.iter().filter(|coordinate| coordinate.is_state)
    }

    /// True if each velocity is the rate of the corresponding position.
    pub fn velocities_are_rates(&self) -> bool {
        self.orientations.is_empty() && self.states().next().is_none()
    }

    /// Returns the positions in state order.
    pub fn positions(&self) -> Vec<ExprId> {
        self.coordinates.iter().map(|coordinate| coordinate.position).collect()
    }
}
