//! A checked model: every name resolved, every expression of the right kind.

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
pub use scene::{BodyMotion, DrawnItem, InertialBody, LinkPose, LinkTwist, OutlinedPart, Scene};

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
    /// The state at the start, [q…, v…], of numbers and parameters; empty if none is declared.
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
    /// Rigid bodies, as far as requested.
    pub scene: Scene,
    /// Velocities that are known to be rates, with their variables: `(u, x)` with u = dx/dt.
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

/// A model with fewer coordinates or with small ones, made from another.
#[derive(Clone, Debug)]
pub struct Reduced {
    /// Reduction that was made; values are expressions of the reduced model.
    pub reduction: Reduction,
    /// Model that results. Nothing is reduced a second time.
    pub model: Model,
}

/// Changes to the coordinates of a model that reduce it.
#[derive(Clone, Debug)]
pub struct Reduction {
    /// The name of the reduced type.
    pub name: Name,
    /// Coordinates held at a value.
    pub frozen: Vec<Pinned>,
    /// Coordinates that stay near a value.
    pub small: Vec<Pinned>,
    /// Cyclic coordinates whose momenta are parameters, in state order; without values.
    pub ignored: Vec<Pinned>,
}

/// A coordinate and a value that is constant in motion.
#[derive(Clone, Debug)]
pub struct Pinned {
    /// The index of the coordinate in the model that is reduced.
    pub coordinate: usize,
    /// The value.
    pub value: ExprId,
    /// Place where the coordinate is named.
    pub span: Span,
}

/// A parameter or an input.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its name.
    pub name: String,
    /// The expression that stands for it.
    pub symbol: ExprId,
    /// Its default, free of symbols.
    pub default: Option<ExprId>,
    /// The lower and the upper bound of its values.
    pub range: [Option<Bound>; 2],
}

/// A white noise.
#[derive(Clone, Debug)]
pub struct Noise {
    /// Its name.
    pub name: String,
    /// Its two-sided spectral density.
    pub density: ExprId,
    /// A velocity and the force along it per unit of the noise, for each load.
    pub loads: Vec<(ExprId, ExprId)>,
    /// A state and its rate per unit of the noise, for each state.
    pub rates: Vec<(ExprId, ExprId)>,
}

/// An input whose value is that of a signal some time ago.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Delay {
    /// The index of the input.
    pub input: usize,
    /// The signal, a function of time, the state and inputs.
    pub signal: ExprId,
    /// The time by which it is delayed, of parameters alone.
    pub lag: ExprId,
}

/// A bound of the values of a parameter.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Bound {
    /// Its value, free of symbols.
    pub value: ExprId,
    /// True if a parameter may have this value.
    pub is_included: bool,
}

/// A position: a generalised coordinate, a component of a unit quaternion, or a state, of first
/// order or discrete.
#[derive(Clone, Debug)]
pub struct Coordinate {
    /// Its name.
    pub name: String,
    /// q
    pub position: ExprId,
    /// q̇, a function of positions and generalised velocities, linear in these; of a first-order
    /// state any function of time, positions, velocities and inputs
    pub rate: ExprId,
    /// True if it is a state, which displacements leave as it is.
    pub is_state: bool,
}

/// A generalised velocity, which Kane calls a generalised speed: the rate of a coordinate, or a
/// component of an angular velocity.
#[derive(Clone, Debug)]
pub struct Speed {
    /// Its name in the state.
    pub name: String,
    /// Index of the coordinate that it is the rate of; `None` of an angular velocity.
    pub coordinate: Option<usize>,
    /// v
    pub velocity: ExprId,
    /// v̇
    pub acceleration: ExprId,
}

/// An orientation as a unit quaternion among the positions, with the angular velocity in the turned
/// axes among the velocities.
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
    /// L is the Routhian, in which T and V are no longer seen.
    Routhian {
        /// T with all velocities, also those of ignored coordinates.
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

/// A force along a velocity: it does work at the rate `force · velocity`.
#[derive(Clone, Debug)]
pub struct Load {
    /// Names the statement, whose other components share the name.
    pub name: String,
    /// The velocity, affine in v.
    pub velocity: ExprId,
    /// The force component.
    pub force: ExprId,
}

/// A constraint.
#[derive(Clone, Debug)]
pub struct Constraint {
    /// Its name.
    pub name: String,
    /// Function of t and q, or one that is affine in v, that the constraint makes zero.
    pub value: ExprId,
    /// Function of the velocities that must be zero: the rate of `value` or, if that holds
    /// velocities, `value` itself.
    pub velocity: ExprId,
    /// True if `value` is a function of t and q.
    pub is_holonomic: bool,
    /// The symbol of its multiplier.
    pub multiplier: ExprId,
}

/// A declared output.
#[derive(Clone, Debug)]
pub struct Output {
    /// Its name.
    pub name: String,
    /// One expression for a scalar, two or three for a vector.
    pub components: Vec<ExprId>,
    /// True if it needs the accelerations.
    pub uses_accelerations: bool,
    /// True if it needs the multipliers.
    pub uses_multipliers: bool,
    /// True if it needs the forces of contacts or of friction.
    pub uses_reactions: bool,
    /// Its meaning, if it is derived instead of declared.
    pub description: Option<String>,
}

/// A zero to be found during a motion, and what happens there.
#[derive(Clone, Debug)]
pub struct Event {
    /// Its name.
    pub name: String,
    /// Function of t, q and v, accelerations and multipliers whose zeros are the event.
    pub value: ExprId,
    /// Zeros that count.
    pub direction: Direction,
    /// Action at the event.
    pub action: Action,
}

/// Assignments at the multiples of a period.
#[derive(Clone, Debug)]
pub struct Clock {
    /// The period, a function of parameters.
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
    /// Entries of the state take other values, all at once.
    Assign(Vec<Assignment>),
}

/// An entry of the state and its value after an event.
#[derive(Clone, Copy, Debug)]
pub struct Assignment {
    /// Its index in [q…, v…], where q has one entry for each position.
    pub index: usize,
    /// A function of t, q and v before the event.
    pub value: ExprId,
}

/// A contact or dry friction, with a force along the gradient of a velocity.
#[derive(Clone, Debug)]
pub struct Reaction {
    /// Its name.
    pub name: String,
    /// The symbol of its force.
    pub symbol: ExprId,
    /// The rate of the gap or the slip velocity, affine in q̇.
    pub velocity: ExprId,
    /// Law of its force.
    pub kind: ReactionKind,
}

/// Law of the force of a contact or of friction.
#[derive(Clone, Copy, Debug)]
pub enum ReactionKind {
    /// A unilateral contact.
    Contact {
        /// A function of t and q, positive where bodies are apart.
        gap: ExprId,
        /// The coefficient of restitution, a function of t, q and v.
        restitution: ExprId,
    },
    /// Dry friction that sticks and slips. Limits are functions of t, q and v, affine in
    /// multipliers and in the forces of reactions declared before.
    Friction {
        /// The magnitude of the force while it slips.
        kinetic: ExprId,
        /// The largest magnitude of the force while it sticks.
        fixed: ExprId,
    },
    /// The second component of friction in a plane, whose limits are those of the reaction before
    /// it. They bound the length of the force.
    Across {
        /// Its magnitude while it slips.
        kinetic: ExprId,
        /// Its largest magnitude while it sticks.
        fixed: ExprId,
    },
    /// Friction that only slips: the force is −limit · tanh(velocity / width).
    Smooth {
        /// The magnitude of the force far from velocity zero, a limit like those above.
        limit: ExprId,
        /// A velocity, constant in motion.
        width: ExprId,
    },
}

impl Energies {
    /// Returns T and V, if the energies are known one by one.
    pub fn parts(self) -> Option<[ExprId; 2]> {
        match self {
            Energies::Separate { kinetic, potential } | Energies::Routhian { kinetic, potential } => {
                Some([kinetic, potential])
            }
            Energies::Lagrangian => None,
        }
    }

    /// Returns T and V, to be replaced.
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
    /// True if it has a mode of its own, which events switch.
    pub fn has_mode(self) -> bool {
        !matches!(self, ReactionKind::Smooth { .. } | ReactionKind::Across { .. })
    }
}

impl Model {
    /// Returns the generalised velocities in state order.
    pub fn velocities(&self) -> Vec<ExprId> {
        self.speeds.iter().map(|speed| speed.velocity).collect()
    }

    /// Unknowns of the equations of motion: rates of the velocities, and multipliers.
    pub fn unknowns(&self) -> Vec<ExprId> {
        let mut unknowns = self.velocities();
        unknowns.extend(self.multipliers());
        unknowns
    }

    /// Returns the multipliers in the order of the constraints.
    pub fn multipliers(&self) -> Vec<ExprId> {
        self.constraints.iter().map(|constraint| constraint.multiplier).collect()
    }

    /// Returns the name of a velocity in messages: that of the coordinate whose rate it is.
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

    /// Returns the states in their order.
    pub fn states(&self) -> impl Iterator<Item = &Coordinate> {
        self.coordinates.iter().filter(|coordinate| coordinate.is_state)
    }

    /// True if velocities are the rates of the positions, one by one.
    pub fn velocities_are_rates(&self) -> bool {
        self.orientations.is_empty() && self.states().next().is_none()
    }

    /// Returns the positions in state order.
    pub fn positions(&self) -> Vec<ExprId> {
        self.coordinates.iter().map(|coordinate| coordinate.position).collect()
    }
}
