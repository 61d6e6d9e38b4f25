//! What can be emitted of a system.

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
    /// `constraints`; like the next three only for systems with constraints
    Constraints,
    /// `constraint_velocity`
    ConstraintVelocity,
    /// `constraint_jacobian`
    ConstraintJacobian,
    /// `constraint_forces`
    ConstraintForces,
    /// `jacobian`; only on demand
    Jacobian,
    /// `parameter_jacobian`; only with `jacobian` or on demand
    ParameterJacobian,
    /// `EQUATIONS_LATEX`; only on demand
    Latex,
    /// `NAME_motion` for each body; like the next two only for systems with rigid bodies, on demand
    Motion,
    /// `lagrange::scene::Scene`
    Drawing,
    /// `STATEMENTS`
    Statements,
}

impl Product {
    /// Every product, in the order in which they are emitted.
    pub const ALL: [Product; 19] = [
        Product::MassMatrix,
        Product::Forcing,
        Product::Bias,
        Product::Momenta,
        Product::MomentumRates,
        Product::KineticEnergy,
        Product::PotentialEnergy,
        Product::Energy,
        Product::InverseDynamics,
        Product::Constraints,
        Product::ConstraintVelocity,
        Product::ConstraintJacobian,
        Product::ConstraintForces,
        Product::Jacobian,
        Product::ParameterJacobian,
        Product::Latex,
        Product::Motion,
        Product::Drawing,
        Product::Statements,
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
            Product::Constraints => "constraints",
            Product::ConstraintVelocity => "constraint_velocity",
            Product::ConstraintJacobian => "constraint_jacobian",
            Product::ConstraintForces => "constraint_forces",
            Product::Jacobian => "jacobian",
            Product::ParameterJacobian => "parameter_jacobian",
            Product::Latex => "latex",
            Product::Motion => "motion",
            Product::Drawing => "drawing",
            Product::Statements => "statements",
        }
    }

    /// Whether only systems with constraints have it.
    pub fn is_of_constraints(self) -> bool {
        use Product::{ConstraintForces, ConstraintJacobian, ConstraintVelocity, Constraints};
        matches!(self, Constraints | ConstraintVelocity | ConstraintJacobian | ConstraintForces)
    }

    /// Whether only systems with rigid bodies have it. No method has its name.
    pub fn is_of_bodies(self) -> bool {
        matches!(self, Product::Motion | Product::Drawing | Product::Statements)
    }

    /// Whether it is emitted without being asked for.
    pub fn is_default(self) -> bool {
        use Product::{Bias, Jacobian, Latex, MomentumRates, ParameterJacobian};
        !self.is_of_bodies() && !matches!(self, Bias | MomentumRates | Jacobian | ParameterJacobian | Latex)
    }
}
