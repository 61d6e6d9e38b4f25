//! The products that can be emitted, one row each.
//!
//! A row holds everything about a product that the language, its messages and emitted code need.
//! [`Equations`](crate::derive::Equations) contains its derivation.

mod rows;

use rows::ROWS;

/// Something that can be emitted in addition to accelerations and outputs.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
#[expect(missing_docs, reason = "the names are those of the rows")]
pub enum Product {
    MassMatrix,
    InverseMassMatrix,
    Forcing,
    Bias,
    CoriolisMatrix,
    Momenta,
    MomentumRates,
    KineticEnergy,
    PotentialEnergy,
    Energy,
    InverseDynamics,
    InverseDynamicsJacobian,
    Regressor,
    Constraints,
    ConstraintVelocity,
    ConstraintJacobian,
    ConstraintForces,
    Jacobian,
    TangentJacobian,
    ParameterJacobian,
    SystemMatrix,
    EventJacobian,
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
    CenterOfMass,
    CentroidalMomentum,
    CentroidalMomentumMatrix,
    Motion,
    Frames,
    FrameJacobians,
    Drawing,
    Statements,
}

/// A method for each body or frame.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum BodyMethod {
    /// Its motion.
    Motion,
    /// Its placement.
    Frame,
    /// The Jacobian of its frame.
    Jacobian,
    /// The acceleration of its frame at constant velocities.
    BiasAcceleration,
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
    /// On demand, for systems with events.
    Events,
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
    /// One for each declared event.
    Events,
    /// One for each position and each velocity, and one for time.
    StateAndTime,
    /// One for each axis of the plane or of space.
    Axes,
    /// One for each rotation, then one for each axis, of the plane or of space.
    Motions,
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

/// The units of multipliers of constraints.
const MULTIPLIERS: ProductUnit =
    ProductUnit::Described("Each is in W over the unit of its condition on the velocities.");

/// The unit of the entries of a result, from coherent units and those of velocities.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ProductUnit {
    /// This unit.
    Same(&'static str),
    /// This unit, over those of the velocities of the row and, in a matrix, of the column.
    Over(&'static str),
    /// This unit, times those of the velocities.
    Times(&'static str),
    /// The unit of the row over that of the column.
    Quotient,
    /// Units that a sentence describes.
    Described(&'static str),
    /// The units of accelerations.
    Acceleration,
}

impl ProductUnit {
    /// Describes the unit of the entries of a result where the units of the velocities are not
    /// known.
    #[must_use]
    pub fn sentence(self, returns: ProductShape) -> String {
        let velocities = match returns {
            ProductShape::Matrix(..) => "the units of the velocities of its row and of its column",
            _ => "the unit of its velocity",
        };
        match self {
            ProductUnit::Same(unit) => format!("In {unit}."),
            ProductUnit::Over(unit) => format!("Each entry is in {unit} over {velocities}."),
            ProductUnit::Times(unit) => format!("Each entry is in {unit} times {velocities}."),
            ProductUnit::Quotient => "Each entry has the unit of its row over that of its column.".to_owned(),
            ProductUnit::Described(units) => units.to_owned(),
            ProductUnit::Acceleration => "Each entry is in the unit of its velocity over s.".to_owned(),
        }
    }
}

/// The method of a product: arguments, result, its unit, and documentation by lines.
#[derive(Debug)]
pub struct ProductMethod {
    /// Arguments.
    pub arguments: ProductArguments,
    /// Result.
    pub returns: ProductShape,
    /// Unit of the entries of the result, unless it differs in other ways.
    pub unit: Option<ProductUnit>,
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

impl ProductRow {
    /// Creates the row of a product without a method.
    const fn new(product: Product, name: &'static str, when: Availability) -> Self {
        ProductRow { product, name, when, method: None }
    }

    /// Adds a method with these arguments, result and documentation.
    const fn with_method(
        self,
        arguments: ProductArguments,
        returns: ProductShape,
        docs: &'static [&'static str],
    ) -> Self {
        ProductRow { method: Some(ProductMethod { arguments, returns, unit: None, docs }), ..self }
    }

    /// Sets the unit of the method's result.
    const fn in_unit(self, unit: ProductUnit) -> Self {
        match self.method {
            Some(method) => ProductRow { method: Some(ProductMethod { unit: Some(unit), ..method }), ..self },
            None => self,
        }
    }
}

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

    /// Returns the unit of the method of this name, if it is that of a product, the acceleration or
    /// the multipliers.
    pub fn unit_of_method(name: &str) -> Option<ProductUnit> {
        match name {
            "acceleration" => Some(ProductUnit::Acceleration),
            "multipliers" => Some(MULTIPLIERS),
            _ => Product::by_name(name)?.row().method.as_ref()?.unit,
        }
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

    /// True if only systems with events have it.
    pub fn is_of_events(self) -> bool {
        self.row().when == Availability::Events
    }

    /// True if only systems with rigid bodies have it.
    pub fn is_of_bodies(self) -> bool {
        self.row().when == Availability::Bodies
    }

    /// True if it is computed from the motions of bodies.
    pub fn needs_motions(self) -> bool {
        matches!(self, Product::Motion | Product::Drawing) || self.is_centroidal()
    }

    /// True for totals of all bodies.
    pub fn is_centroidal(self) -> bool {
        matches!(
            self,
            Product::CenterOfMass | Product::CentroidalMomentum | Product::CentroidalMomentumMatrix
        )
    }

    /// True if its name is the name of a method, or of a constant in lower case.
    pub fn is_method(self) -> bool {
        let is_other = matches!(
            self,
            Product::Prepared | Product::Kernel | Product::Lanes | Product::Taylor | Product::Latex
        );
        self.row().method.is_some() || is_other
    }

    /// Returns its methods for each body.
    pub fn methods_of_bodies(self) -> &'static [BodyMethod] {
        match self {
            Product::Motion => &[BodyMethod::Motion],
            Product::Frames => &[BodyMethod::Frame],
            Product::FrameJacobians => &[BodyMethod::Jacobian, BodyMethod::BiasAcceleration],
            _ => &[],
        }
    }
}

impl BodyMethod {
    /// Returns the name of the method for a body of this name.
    pub fn name(self, body: &str) -> String {
        let suffix = match self {
            BodyMethod::Motion => "motion",
            BodyMethod::Frame => "frame",
            BodyMethod::Jacobian => "jacobian",
            BodyMethod::BiasAcceleration => "bias_acceleration",
        };
        format!("{body}_{suffix}")
    }
}
