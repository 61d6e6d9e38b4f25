//! The rows of all products.

use super::Availability::{Always, Bodies, Constraints, Demand, Events, SeparateEnergies, With};
use super::ProductArguments::{Configuration, Motion, Positions, State, Whole};
use super::ProductShape::{Matrix, Scalar, Vector};
use super::ProductUnit::{Described, Over, Quotient, Same, Times};
use super::{Extent, Product, ProductRow};

/// Every product in the order of emission, which is that of [`Product`].
pub(super) const ROWS: [ProductRow; 41] = [
    ProductRow::new(Product::MassMatrix, "mass_matrix", Always)
        .with_method(Configuration, Matrix(Extent::Velocities, Extent::Velocities), &["Mass matrix M, in rows."])
        .in_unit(Over("J")),
    ProductRow::new(Product::InverseMassMatrix, "inverse_mass_matrix", Demand)
        .with_method(Configuration, Matrix(Extent::Velocities, Extent::Velocities), &[
            "Inverse M⁻¹ of the mass matrix, in rows: accelerations due to unit forces, without constraints.",
        ])
        .in_unit(Times("1/J")),
    ProductRow::new(Product::Forcing, "forcing", Always)
        .with_method(State, Vector(Extent::Velocities), &["Right-hand side f of M q̈ = f."])
        .in_unit(Over("W")),
    ProductRow::new(Product::Bias, "bias", Demand)
        .with_method(State, Vector(Extent::Velocities), &[
            "Bias c of M q̈ + c = Q: Coriolis, centrifugal and potential terms,",
            "without applied forces and dissipation.",
        ])
        .in_unit(Over("W")),
    ProductRow::new(Product::CoriolisMatrix, "coriolis_matrix", Demand)
        .with_method(State, Matrix(Extent::Velocities, Extent::Velocities), &[
            "Coriolis matrix C, in rows: C v are the terms of `bias` with velocities, and Ṁ − 2C is skew if",
            "M does not depend explicitly on time or states.",
        ])
        .in_unit(Over("W")),
    ProductRow::new(Product::Momenta, "momenta", Always)
        .with_method(State, Vector(Extent::Velocities), &["Generalised momenta ∂L/∂v."])
        .in_unit(Over("J")),
    ProductRow::new(Product::MomentumRates, "momentum_rates", Demand)
        .with_method(State, Vector(Extent::Velocities), &["Rates ∂L/∂q + Q of the momenta."])
        .in_unit(Over("W")),
    ProductRow::new(Product::KineticEnergy, "kinetic_energy", SeparateEnergies)
        .with_method(State, Scalar, &["Kinetic energy T."])
        .in_unit(Same("J")),
    ProductRow::new(Product::PotentialEnergy, "potential_energy", SeparateEnergies)
        .with_method(Positions, Scalar, &["Potential energy V."])
        .in_unit(Same("J")),
    ProductRow::new(Product::Energy, "energy", Always)
        .with_method(State, Scalar, &["Energy function v·∂L/∂v − L."])
        .in_unit(Same("J")),
    ProductRow::new(Product::InverseDynamics, "inverse_dynamics", Always)
        .with_method(Motion, Vector(Extent::Velocities), &[
            "Inverse dynamics: the generalised forces that must act, in addition to the declared ones,",
            "to produce given accelerations.",
        ])
        .in_unit(Over("W")),
    ProductRow::new(Product::InverseDynamicsJacobian, "inverse_dynamics_jacobian", Demand)
        .with_method(Motion, Matrix(Extent::Velocities, Extent::Tangent), &[
            "Derivatives of `inverse_dynamics`, in rows, by displacements of the positions, changes of the",
            "states and of the velocities; those by the accelerations are the mass matrix.",
        ])
        .in_unit(Quotient),
    ProductRow::new(Product::Regressor, "regressor", Demand)
        .with_method(Motion, Matrix(Extent::Velocities, Extent::Regressed), &[
            "Regressor Y of the inverse dynamics, in rows. Its columns multiply the parameters",
            "`REGRESSOR_PARAMETERS`, in which the inverse dynamics is linear; other terms are not in it.",
        ])
        .in_unit(Quotient),
    ProductRow::new(Product::Constraints, "constraints", Constraints)
        .with_method(State, Vector(Extent::Constraints), &[
            "Values that the constraints hold at zero, in the order of their declaration; only those of",
            "nonholonomic constraints depend on the velocities.",
        ])
        .in_unit(Described("Each is in the unit of its condition: that declared, m for points of joints, 1 for their directions.")),
    ProductRow::new(Product::ConstraintVelocity, "constraint_velocity", Constraints)
        .with_method(State, Vector(Extent::Constraints), &[
            "Conditions on the velocities, which the constraints hold at zero: rates of holonomic constraints,",
            "nonholonomic constraints themselves.",
        ])
        .in_unit(Described("Rates of holonomic constraints are in the units of their conditions over s.")),
    ProductRow::new(Product::ConstraintJacobian, "constraint_jacobian", Constraints)
        .with_method(Positions, Matrix(Extent::Constraints, Extent::Velocities), &[
            "Matrix A of the constraints, in rows: the derivatives of their conditions on the velocities by",
            "them.",
        ])
        .in_unit(Quotient),
    ProductRow::new(Product::ConstraintForces, "constraint_forces", Constraints)
        .with_method(State, Vector(Extent::Velocities), &[
            "Generalised forces Aᵀλ of the constraints, on the right-hand side of M q̈ = f + Aᵀλ.",
        ])
        .in_unit(Over("W")),
    ProductRow::new(Product::Jacobian, "jacobian", Demand)
        .with_method(Whole, Matrix(Extent::State, Extent::State), &[
            "Jacobian of `rhs`, in rows: entry `[i][j]` is the derivative of its entry `i` by entry `j`",
            "of the state.",
        ])
        .in_unit(Quotient),
    ProductRow::new(Product::TangentJacobian, "tangent_jacobian", Demand)
        .with_method(Whole, Matrix(Extent::Tangent, Extent::Tangent), &[
            "Matrix of the linearised equations of motion, in rows, by displacements of the positions,",
            "changes of the states and of the velocities: `jacobian` without the lengths of quaternions.",
        ])
        .in_unit(Quotient),
    ProductRow::new(Product::ParameterJacobian, "parameter_jacobian", With(Product::Jacobian))
        .with_method(Whole, Matrix(Extent::State, Extent::Fields), &[
            "Derivatives of `rhs` by the fields in the order of `PARAMETERS`, in rows: entry `[i][j]`",
            "is that of its entry `i` by field `j`.",
        ])
        .in_unit(Quotient),
    ProductRow::new(Product::SystemMatrix, "system_matrix", Demand)
        .with_method(Whole, Matrix(Extent::LinearRows, Extent::LinearColumns), &[
            "System matrix [A B; C D; G 0] of the linearised system, in rows: `tangent_jacobian` and the",
            "derivatives with respect to the inputs, then those of the outputs and of the constraint velocities.",
        ])
        .in_unit(Quotient),
    ProductRow::new(Product::EventJacobian, "event_jacobian", Events)
        .with_method(Whole, Matrix(Extent::Events, Extent::StateAndTime), &[
            "Derivatives of the functions of declared events, in rows, by the entries of the state and, last,",
            "by time. Gaps of contacts are positive while bodies are apart.",
        ])
        .in_unit(Quotient),
    ProductRow::new(Product::Prepared, "prepared", Demand),
    ProductRow::new(Product::Kernel, "kernel", Demand),
    ProductRow::new(Product::Lanes, "lanes", Demand),
    ProductRow::new(Product::Taylor, "taylor", Demand),
    ProductRow::new(Product::Latex, "latex", Demand),
    ProductRow::new(Product::Conserved, "conserved", Demand),
    ProductRow::new(Product::Power, "power", Demand),
    ProductRow::new(Product::Lagrangian, "lagrangian", With(Product::Tests))
        .with_method(State, Scalar, &["Lagrangian L."])
        .in_unit(Same("J")),
    ProductRow::new(Product::LagrangianHessian, "lagrangian_hessian", Demand)
        .with_method(State, Matrix(Extent::State, Extent::State), &[
            "Second derivatives of the Lagrangian with respect to positions and velocities, in rows.",
        ])
        .in_unit(Described("Each entry is in J over the units of its row and of its column.")),
    ProductRow::new(Product::GeneralisedForces, "generalised_forces", With(Product::Tests))
        .with_method(State, Vector(Extent::Velocities), &[
            "Generalised forces Q of d/dt ∂L/∂v − ∂L/∂q = Q: applied forces, dissipation, forces of",
            "constraints, contacts and friction.",
        ])
        .in_unit(Over("W")),
    ProductRow::new(Product::Tests, "tests", Demand),
    ProductRow::new(Product::CenterOfMass, "center_of_mass", Bodies)
        .with_method(Positions, Vector(Extent::Axes), &["Centre of mass of all bodies."])
        .in_unit(Same("m")),
    ProductRow::new(Product::CentroidalMomentum, "centroidal_momentum", Bodies)
        .with_method(State, Vector(Extent::Motions), &[
            "Momentum of all bodies, in world axes: angular momentum about their centre of mass, then linear",
            "momentum.",
        ])
        .in_unit(Described("Angular momentum is in N*m*s, linear momentum in kg*m/s.")),
    ProductRow::new(Product::CentroidalMomentumMatrix, "centroidal_momentum_matrix", Bodies)
        .with_method(Positions, Matrix(Extent::Motions, Extent::Velocities), &[
            "Matrix A of the centroidal momentum A v, in rows; what time alone adds is omitted.",
        ])
        .in_unit(Quotient),
    ProductRow::new(Product::Motion, "motion", Bodies),
    ProductRow::new(Product::Frames, "frames", Bodies),
    ProductRow::new(Product::FrameJacobians, "frame_jacobians", Bodies),
    ProductRow::new(Product::Drawing, "drawing", Bodies),
    ProductRow::new(Product::Statements, "statements", Demand),
];

#[cfg(test)]
mod tests {
    use super::ROWS;

    #[test]
    fn rows_stand_in_the_order_of_the_products() {
        for (index, row) in ROWS.iter().enumerate() {
            assert_eq!(row.product as usize, index, "{}", row.name);
        }
    }
}
