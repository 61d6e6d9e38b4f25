//! The products that can be emitted, one row each.
//!
//! A row holds everything about a product that the language, its messages and emitted code need.
//! [`Equations`](crate::derive::Equations) contains its derivation.

/// Something that can be emitted in addition to accelerations and outputs.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
#[expect(missing_docs, reason = "the names are those of the rows")]
pub enum Product {
    MassMatrix,
    Forcing,
    Bias,
    Momenta,
    MomentumRates,
    KineticEnergy,
    PotentialEnergy,
    Energy,
    InverseDynamics,
    Regressor,
    Constraints,
    ConstraintVelocity,
    ConstraintJacobian,
    ConstraintForces,
    Jacobian,
    TangentJacobian,
    ParameterJacobian,
    SystemMatrix,
    Prepared,
    Kernel,
    Lanes,
    Taylor,
    Latex,
    Conserved,
    Power,
    Lagrangian,
    LagrangianHessian,
    GeneralisedForces,
    Tests,
    Motion,
    Frames,
    FrameJacobians,
    Drawing,
    Statements,
}

/// Condition under which a product is emitted.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Availability {
    /// For every system.
    Always,
    /// For systems given by kinetic and potential energies.
    SeparateEnergies,
    /// For systems with constraints.
    Constraints,
    /// On demand.
    Demand,
    /// On demand, or together with another product.
    With(Product),
    /// On demand, for systems with rigid bodies.
    Bodies,
}

/// The arguments of a product, in addition to time and the parameters.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ProductArguments {
    /// The positions, and also the velocities if the result depends on them.
    Configuration,
    /// The positions.
    Positions,
    /// The positions and the velocities.
    State,
    /// The positions, the velocities and the accelerations.
    Motion,
    /// The whole state as one vector.
    Whole,
}

/// The number of entries in a result.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Extent {
    /// One for each velocity.
    Velocities,
    /// One for each position and each velocity.
    State,
    /// Displacements of the positions, changes of the first-order states and of the velocities.
    Tangent,
    /// One for each entry of the tangent, each component of an output and each constraint.
    LinearRows,
    /// One for each entry of the tangent and each input.
    LinearColumns,
    /// One for each constraint.
    Constraints,
    /// One for each parameter and each input.
    Fields,
    /// One for each column of the regressor.
    Regressed,
}

/// The result of a product's method.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ProductShape {
    /// A number.
    Scalar,
    /// A vector of this many numbers.
    Vector(Extent),
    /// Rows and columns.
    Matrix(Extent, Extent),
}

/// The method of a product: arguments, result, and documentation by lines.
#[derive(Debug)]
pub struct ProductMethod {
    /// Arguments.
    pub arguments: ProductArguments,
    /// Result.
    pub returns: ProductShape,
    /// Documentation.
    pub docs: &'static [&'static str],
}

/// The properties of one product.
#[derive(Debug)]
pub struct ProductRow {
    /// The product.
    pub product: Product,
    /// Its name in `emit { … }`, and the name of its method if there is one.
    pub name: &'static str,
    /// Condition under which it is emitted.
    pub when: Availability,
    /// Its method; `None` for constants and for products of bodies.
    pub method: Option<ProductMethod>,
}

/// Every product in the order of emission, which is that of [`Product`].
const ROWS: [ProductRow; 34] = [
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
                "What the constraints hold at zero, in the order of their declaration; the velocities matter to",
                "nonholonomic ones only.",
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
                "What the constraints demand of the velocities to be zero: the rate of a holonomic constraint,",
                "a nonholonomic one itself.",
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
                "Matrix A of the constraints, in rows: what each demands of the velocities, differentiated by",
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

impl Product {
    /// Every product, in the order in which they are emitted.
    pub const ALL: [Product; ROWS.len()] = {
        let mut all = [Product::MassMatrix; ROWS.len()];
        let mut index = 0;
        while index < all.len() {
            all[index] = ROWS[index].product;
            index += 1;
        }
        all
    };

    /// Returns the row of the product.
    pub fn row(self) -> &'static ProductRow {
        &ROWS[self as usize]
    }

    /// Returns the product of this name in `emit { … }`.
    pub fn by_name(name: &str) -> Option<Product> {
        Product::ALL.into_iter().find(|product| product.name() == name)
    }

    /// Returns its name in `emit { … }`.
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// True if only systems with constraints have it.
    pub fn is_of_constraints(self) -> bool {
        self.row().when == Availability::Constraints
    }

    /// True for derivatives of the right-hand side.
    pub fn is_derivative(self) -> bool {
        matches!(
            self,
            Product::Jacobian | Product::TangentJacobian | Product::ParameterJacobian | Product::SystemMatrix
        )
    }

    /// True if only systems with rigid bodies have it. No method has its name.
    pub fn is_of_bodies(self) -> bool {
        self.row().when == Availability::Bodies
    }

    /// True if its name is the name of a method, or of a constant in lower case.
    pub fn is_method(self) -> bool {
        let is_other = matches!(
            self,
            Product::Prepared | Product::Kernel | Product::Lanes | Product::Taylor | Product::Latex
        );
        self.row().method.is_some() || is_other
    }

    /// Returns the suffix of its method for each body; the name of the body comes first.
    pub fn method_suffix(self) -> Option<&'static str> {
        match self {
            Product::Motion => Some("_motion"),
            Product::Frames => Some("_frame"),
            Product::FrameJacobians => Some("_jacobian"),
            _ => None,
        }
    }
}

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
