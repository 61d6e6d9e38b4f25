//! A checked model: every name resolved, every expression of the right kind.

use proc_macro2::Span;

use crate::expr::{ExprId, Graph};
use crate::syntax::ast::{Accuracy, Name};

/// What a declaration says, as expressions of one graph.
#[derive(Clone, Debug)]
pub struct Model {
    /// Owns all expressions.
    pub graph: Graph,
    /// Run-time parameters in declaration order.
    pub parameters: Vec<Parameter>,
    /// Inputs in declaration order.
    pub inputs: Vec<Parameter>,
    /// Generalised coordinates in state order; at least one.
    pub coordinates: Vec<Coordinate>,
    /// The energies as declared.
    pub energies: Energies,
    /// L = T − V, or as declared.
    pub lagrangian: ExprId,
    /// The Rayleigh function, whose gradient with respect to v is subtracted from the forces.
    pub dissipation: ExprId,
    /// Applied forces and torques.
    pub loads: Vec<Load>,
    /// Declared outputs.
    pub outputs: Vec<Output>,
    /// Velocities that are known to be rates, with what they are rates of: `(u, x)` with u = dx/dt.
    pub rates: Vec<(ExprId, ExprId)>,
    /// The user's names for expressions, in the order of preference.
    pub labels: Vec<(ExprId, String)>,
    /// The level of accuracy that was asked for.
    pub accuracy: Accuracy,
    /// The products to emit, in the order of [`Product::ALL`].
    pub products: Vec<Product>,
    /// The reduced types, in the order of their declaration.
    pub reduced: Vec<Reduced>,
}

/// A model with fewer coordinates or with small ones, made from another.
#[derive(Clone, Debug)]
pub struct Reduced {
    /// What was done to the coordinates; values are expressions of the reduced model.
    pub reduction: Reduction,
    /// What it comes to. Nothing is reduced a second time.
    pub model: Model,
}

/// What is done to the coordinates of a model to reduce it.
#[derive(Clone, Debug)]
pub struct Reduction {
    /// The name of the reduced type.
    pub name: Name,
    /// Coordinates held at a value.
    pub frozen: Vec<Held>,
    /// Coordinates that stay near a value.
    pub small: Vec<Held>,
}

/// A coordinate and a value that is constant in motion.
#[derive(Clone, Debug)]
pub struct Held {
    /// The index of the coordinate in the model that is reduced.
    pub coordinate: usize,
    /// The value.
    pub value: ExprId,
    /// Where the coordinate is named.
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
}

/// A generalised coordinate.
#[derive(Clone, Debug)]
pub struct Coordinate {
    /// Its name.
    pub name: String,
    /// q
    pub position: ExprId,
    /// q̇
    pub velocity: ExprId,
    /// q̈
    pub acceleration: ExprId,
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
}

/// A force along a velocity: it does work at the rate `force · velocity`.
#[derive(Clone, Copy, Debug)]
pub struct Load {
    /// The velocity, affine in q̇.
    pub velocity: ExprId,
    /// The force component.
    pub force: ExprId,
}

/// A declared output.
#[derive(Clone, Debug)]
pub struct Output {
    /// Its name.
    pub name: String,
    /// One expression for a scalar, two or three for a vector.
    pub components: Vec<ExprId>,
    /// Whether it needs the accelerations.
    pub uses_accelerations: bool,
}

/// Something that can be emitted beside accelerations and outputs.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Product {
    /// `mass_matrix`
    MassMatrix,
    /// `forcing`
    Forcing,
    /// `bias`; only on demand
    Bias,
    /// `momenta`
    Momenta,
    /// `momentum_rates`; only on demand
    MomentumRates,
    /// `kinetic_energy`
    KineticEnergy,
    /// `potential_energy`
    PotentialEnergy,
    /// `energy`
    Energy,
    /// `inverse_dynamics`
    InverseDynamics,
    /// `jacobian`; only on demand
    Jacobian,
    /// `parameter_jacobian`; only with `jacobian` or on demand
    ParameterJacobian,
    /// `EQUATIONS_LATEX`; only on demand
    Latex,
}

impl Product {
    /// Every product, in the order in which they are emitted.
    pub const ALL: [Product; 12] = [
        Product::MassMatrix,
        Product::Forcing,
        Product::Bias,
        Product::Momenta,
        Product::MomentumRates,
        Product::KineticEnergy,
        Product::PotentialEnergy,
        Product::Energy,
        Product::InverseDynamics,
        Product::Jacobian,
        Product::ParameterJacobian,
        Product::Latex,
    ];

    /// Its name in `emit { … }`.
    pub fn name(self) -> &'static str {
        match self {
            Product::MassMatrix => "mass_matrix",
            Product::Forcing => "forcing",
            Product::Bias => "bias",
            Product::Momenta => "momenta",
            Product::MomentumRates => "momentum_rates",
            Product::KineticEnergy => "kinetic_energy",
            Product::PotentialEnergy => "potential_energy",
            Product::Energy => "energy",
            Product::InverseDynamics => "inverse_dynamics",
            Product::Jacobian => "jacobian",
            Product::ParameterJacobian => "parameter_jacobian",
            Product::Latex => "latex",
        }
    }

    /// Whether it is emitted without being asked for.
    pub fn is_default(self) -> bool {
        !matches!(
            self,
            Product::Bias
                | Product::MomentumRates
                | Product::Jacobian
                | Product::ParameterJacobian
                | Product::Latex
        )
    }
}

impl Model {
    /// The generalised velocities in state order.
    pub fn velocities(&self) -> Vec<ExprId> {
        self.coordinates.iter().map(|coordinate| coordinate.velocity).collect()
    }

    /// The generalised coordinates in state order.
    pub fn positions(&self) -> Vec<ExprId> {
        self.coordinates.iter().map(|coordinate| coordinate.position).collect()
    }
}
