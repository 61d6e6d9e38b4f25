//! The rows of all products.

use super::{Availability, Extent, Product, ProductArguments, ProductMethod, ProductRow, ProductShape};

/// Every product in the order of emission, which is that of [`Product`].
pub(super) const ROWS: [ProductRow; 34] = [
    ProductRow {
        product: Product::MassMatrix,
        name: "mass_matrix",
        when: Availability::Always,
        method: Some(ProductMethod {
            arguments: ProductArguments::Configuration,
            returns: ProductShape::Matrix(Extent::Velocities, Extent::Velocities),
            docs: &["Mass matrix M, in rows."],
        }),
    },
    ProductRow {
        product: Product::Forcing,
        name: "forcing",
        when: Availability::Always,
        method: Some(ProductMethod {
            arguments: ProductArguments::State,
            returns: ProductShape::Vector(Extent::Velocities),
            docs: &["Right-hand side f of M q̈ = f."],
        }),
    },
    ProductRow {
        product: Product::Bias,
        name: "bias",
        when: Availability::Demand,
        method: Some(ProductMethod {
            arguments: ProductArguments::State,
            returns: ProductShape::Vector(Extent::Velocities),
            docs: &[
                "Bias c of M q̈ + c = Q: Coriolis, centrifugal and potential terms,",
                "without applied forces and dissipation.",
            ],
        }),
    },
    ProductRow {
        product: Product::Momenta,
        name: "momenta",
        when: Availability::Always,
        method: Some(ProductMethod {
            arguments: ProductArguments::State,
            returns: ProductShape::Vector(Extent::Velocities),
            docs: &["Generalised momenta ∂L/∂v."],
        }),
    },
    ProductRow {
        product: Product::MomentumRates,
        name: "momentum_rates",
        when: Availability::Demand,
        method: Some(ProductMethod {
            arguments: ProductArguments::State,
            returns: ProductShape::Vector(Extent::Velocities),
            docs: &["Rates ∂L/∂q + Q of the momenta."],
        }),
    },
    ProductRow {
        product: Product::KineticEnergy,
        name: "kinetic_energy",
        when: Availability::SeparateEnergies,
        method: Some(ProductMethod {
            arguments: ProductArguments::State,
            returns: ProductShape::Scalar,
            docs: &["Kinetic energy T."],
        }),
    },
    ProductRow {
        product: Product::PotentialEnergy,
        name: "potential_energy",
        when: Availability::SeparateEnergies,
        method: Some(ProductMethod {
            arguments: ProductArguments::Positions,
            returns: ProductShape::Scalar,
            docs: &["Potential energy V."],
        }),
    },
    ProductRow {
        product: Product::Energy,
        name: "energy",
        when: Availability::Always,
        method: Some(ProductMethod {
            arguments: ProductArguments::State,
            returns: ProductShape::Scalar,
            docs: &["Energy function v·∂L/∂v − L."],
        }),
    },
    ProductRow {
        product: Product::InverseDynamics,
        name: "inverse_dynamics",
        when: Availability::Always,
        method: Some(ProductMethod {
            arguments: ProductArguments::Motion,
            returns: ProductShape::Vector(Extent::Velocities),
            docs: &[
                "Inverse dynamics: the generalised forces that must act, in addition to the declared ones,",
                "to produce given accelerations.",
            ],
        }),
    },
    ProductRow {
        product: Product::Regressor,
        name: "regressor",
        when: Availability::Demand,
        method: Some(ProductMethod {
            arguments: ProductArguments::Motion,
            returns: ProductShape::Matrix(Extent::Velocities, Extent::Regressed),
            docs: &[
                "Regressor Y of the inverse dynamics, in rows. Its columns multiply the parameters",
                "`REGRESSOR_PARAMETERS`, in which the inverse dynamics is linear; other terms are not in it.",
            ],
        }),
    },
    ProductRow {
        product: Product::Constraints,
        name: "constraints",
        when: Availability::Constraints,
        method: Some(ProductMethod {
            arguments: ProductArguments::State,
            returns: ProductShape::Vector(Extent::Constraints),
            docs: &[
                "Values that the constraints hold at zero, in the order of their declaration; only those of",
                "nonholonomic constraints depend on the velocities.",
            ],
        }),
    },
    ProductRow {
        product: Product::ConstraintVelocity,
        name: "constraint_velocity",
        when: Availability::Constraints,
        method: Some(ProductMethod {
            arguments: ProductArguments::State,
            returns: ProductShape::Vector(Extent::Constraints),
            docs: &[
                "Conditions on the velocities, which the constraints hold at zero: rates of holonomic constraints,",
                "nonholonomic constraints themselves.",
            ],
        }),
    },
    ProductRow {
        product: Product::ConstraintJacobian,
        name: "constraint_jacobian",
        when: Availability::Constraints,
        method: Some(ProductMethod {
            arguments: ProductArguments::Positions,
            returns: ProductShape::Matrix(Extent::Constraints, Extent::Velocities),
            docs: &[
                "Matrix A of the constraints, in rows: the derivatives of their conditions on the velocities by",
                "them.",
            ],
        }),
    },
    ProductRow {
        product: Product::ConstraintForces,
        name: "constraint_forces",
        when: Availability::Constraints,
        method: Some(ProductMethod {
            arguments: ProductArguments::State,
            returns: ProductShape::Vector(Extent::Velocities),
            docs: &["Generalised forces Aᵀλ of the constraints."],
        }),
    },
    ProductRow {
        product: Product::Jacobian,
        name: "jacobian",
        when: Availability::Demand,
        method: Some(ProductMethod {
            arguments: ProductArguments::Whole,
            returns: ProductShape::Matrix(Extent::State, Extent::State),
            docs: &[
                "Jacobian of `rhs`, in rows: entry `[i][j]` is the derivative of its entry `i` by entry `j`",
                "of the state.",
            ],
        }),
    },
    ProductRow {
        product: Product::TangentJacobian,
        name: "tangent_jacobian",
        when: Availability::Demand,
        method: Some(ProductMethod {
            arguments: ProductArguments::Whole,
            returns: ProductShape::Matrix(Extent::Tangent, Extent::Tangent),
            docs: &[
                "Matrix of the linearised equations of motion, in rows, by displacements of the positions,",
                "changes of the states and of the velocities: `jacobian` without the lengths of quaternions.",
            ],
        }),
    },
    ProductRow {
        product: Product::ParameterJacobian,
        name: "parameter_jacobian",
        when: Availability::With(Product::Jacobian),
        method: Some(ProductMethod {
            arguments: ProductArguments::Whole,
            returns: ProductShape::Matrix(Extent::State, Extent::Fields),
            docs: &[
                "Derivatives of `rhs` by the fields in the order of `PARAMETERS`, in rows: entry `[i][j]`",
                "is that of its entry `i` by field `j`.",
            ],
        }),
    },
    ProductRow {
        product: Product::SystemMatrix,
        name: "system_matrix",
        when: Availability::Demand,
        method: Some(ProductMethod {
            arguments: ProductArguments::Whole,
            returns: ProductShape::Matrix(Extent::LinearRows, Extent::LinearColumns),
            docs: &[
                "System matrix [A B; C D; G 0] of the linearised system, in rows: `tangent_jacobian` and the",
                "derivatives by the inputs, then those of the outputs and of the constraint velocities.",
            ],
        }),
    },
    ProductRow { product: Product::Prepared, name: "prepared", when: Availability::Demand, method: None },
    ProductRow { product: Product::Kernel, name: "kernel", when: Availability::Demand, method: None },
    ProductRow { product: Product::Lanes, name: "lanes", when: Availability::Demand, method: None },
    ProductRow { product: Product::Taylor, name: "taylor", when: Availability::Demand, method: None },
    ProductRow { product: Product::Latex, name: "latex", when: Availability::Demand, method: None },
    ProductRow { product: Product::Conserved, name: "conserved", when: Availability::Demand, method: None },
    ProductRow { product: Product::Power, name: "power", when: Availability::Demand, method: None },
    ProductRow {
        product: Product::Lagrangian,
        name: "lagrangian",
        when: Availability::With(Product::Tests),
        method: Some(ProductMethod {
            arguments: ProductArguments::State,
            returns: ProductShape::Scalar,
            docs: &["Lagrangian L."],
        }),
    },
    ProductRow {
        product: Product::LagrangianHessian,
        name: "lagrangian_hessian",
        when: Availability::Demand,
        method: Some(ProductMethod {
            arguments: ProductArguments::State,
            returns: ProductShape::Matrix(Extent::State, Extent::State),
            docs: &[
                "Second derivatives of the Lagrangian with respect to positions and velocities, in rows.",
            ],
        }),
    },
    ProductRow {
        product: Product::GeneralisedForces,
        name: "generalised_forces",
        when: Availability::With(Product::Tests),
        method: Some(ProductMethod {
            arguments: ProductArguments::State,
            returns: ProductShape::Vector(Extent::Velocities),
            docs: &[
                "Generalised forces Q of d/dt ∂L/∂v − ∂L/∂q = Q: applied forces, dissipation, forces of",
                "constraints, contacts and friction.",
            ],
        }),
    },
    ProductRow { product: Product::Tests, name: "tests", when: Availability::Demand, method: None },
    ProductRow { product: Product::Motion, name: "motion", when: Availability::Bodies, method: None },
    ProductRow { product: Product::Frames, name: "frames", when: Availability::Bodies, method: None },
    ProductRow {
        product: Product::FrameJacobians,
        name: "frame_jacobians",
        when: Availability::Bodies,
        method: None,
    },
    ProductRow { product: Product::Drawing, name: "drawing", when: Availability::Bodies, method: None },
    ProductRow { product: Product::Statements, name: "statements", when: Availability::Bodies, method: None },
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
