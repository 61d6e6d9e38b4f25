//! A checked model: with resolved names and expressions of the right kind.

mod events;
mod product;
mod samples;
mod scene;
mod state;

use proc_macro2::Span;

use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::symbol::Role;
use lagrange_expr::units::NamedUnits;
use lagrange_language::syntax::ast::Name;

pub use events::{Action, Assignment, Clock, Event, Reaction, ReactionKind};
pub use product::{
    Availability, BodyMethod, Extent, Product, ProductArguments, ProductMethod, ProductRow, ProductShape,
    ProductUnit,
};
pub(crate) use samples::{Entry, default_values, entries, may_be_flat, sample_values};
pub use scene::{
    BodyMotion, DrawnItem, InertialBody, LinkPose, LinkTwist, OutlinedPart, SampledHeight, Scene,
};
pub use state::{Bound, Coordinate, EntryLimits, Orientation, Speed};

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
    /// Quantities of contacts that depend on parameters alone, with their ranges.
    pub quantities: Vec<Quantity>,
    /// Distances of the centres of compliant contacts, which must not be zero.
    pub distances: Vec<(Name, ExprId)>,
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

/// A quantity of a contact with a range.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// Name of the contact.
    pub contact: Name,
    /// Description in words that precede the name.
    pub quantity: String,
    /// Value, a function of parameters alone.
    pub value: ExprId,
    /// Lower and upper bound, functions of parameters.
    pub range: [Option<Bound>; 2],
}

impl Quantity {
    /// Returns a description with the name of the contact as the user wrote it.
    pub fn in_words(&self, contact: &str) -> String {
        format!("{} `{contact}`", self.quantity)
    }
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
    /// The signal before the start, a function of time and of the state at the start, if the
    /// declaration states a history.
    pub before: Option<ExprId>,
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
