//! What is emitted for each product: documentation, arguments, result.

use super::jacobian::{JACOBIAN, PARAMETER_JACOBIAN, by_fields, by_state};
use crate::derive::Equations;
use crate::emit::base::method::{Arguments, Returns};
use crate::expr::ExprId;
use crate::model::{Energies, Model, Product};

/// A method that is yet to be lowered.
pub(in crate::emit) struct Plan {
    pub(in crate::emit) docs: &'static [&'static str],
    pub(in crate::emit) arguments: Arguments,
    pub(in crate::emit) returns: Returns,
    pub(in crate::emit) roots: Vec<ExprId>,
}

/// The method of a product; `None` for one that is no method, or that the system does not have. `fields` is the number of
/// parameters and inputs.
pub(in crate::emit) fn plan(
    product: Product,
    model: &mut Model,
    equations: &Equations,
    fields: usize,
) -> Option<Plan> {
    match product {
        Product::Jacobian | Product::ParameterJacobian => {
            Some(derivatives(product, model, equations, fields))
        }
        _ if product.is_of_constraints() => Some(of_constraints(product, model, equations)),
        _ => of_energies(product, model, equations),
    }
}

fn of_energies(product: Product, model: &Model, equations: &Equations) -> Option<Plan> {
    let separate = match model.energies {
        Energies::Separate { kinetic, potential } => Some((kinetic, potential)),
        Energies::Lagrangian => None,
    };
    let or_none = |list: &Option<Vec<ExprId>>| list.clone().unwrap_or_default();
    let n = model.coordinates.len();
    let (docs, arguments, returns, roots): (&[&str], _, _, _) = match product {
        Product::MassMatrix => {
            let moving = equations.structure.mass.depends_on_velocities;
            let arguments = if moving { Arguments::State } else { Arguments::Positions };
            (&MASS_MATRIX, arguments, Returns::Matrix(n, n), equations.mass_matrix.concat())
        }
        Product::Forcing => (&FORCING, Arguments::State, Returns::Vector(n), equations.forcing.clone()),
        Product::Bias => (&BIAS, Arguments::State, Returns::Vector(n), or_none(&equations.bias)),
        Product::Momenta => (&MOMENTA, Arguments::State, Returns::Vector(n), or_none(&equations.momenta)),
        Product::MomentumRates => {
            (&MOMENTUM_RATES, Arguments::State, Returns::Vector(n), or_none(&equations.momentum_rates))
        }
        Product::KineticEnergy => (&KINETIC, Arguments::State, Returns::Scalar, vec![separate?.0]),
        Product::PotentialEnergy => (&POTENTIAL, Arguments::Positions, Returns::Scalar, vec![separate?.1]),
        Product::Energy => (&ENERGY, Arguments::State, Returns::Scalar, vec![equations.energy?]),
        Product::InverseDynamics => {
            (&INVERSE, Arguments::Motion, Returns::Vector(n), or_none(&equations.inverse_dynamics))
        }
        _ => return None,
    };
    Some(Plan { docs, arguments, returns, roots })
}

fn of_constraints(product: Product, model: &Model, equations: &Equations) -> Plan {
    let (n, m) = (model.coordinates.len(), model.constraints.len());
    let constraints = &model.constraints;
    let (docs, arguments, returns, roots): (&[&str], _, _, _) = match product {
        Product::Constraints => {
            let values = constraints.iter().map(|constraint| constraint.value).collect();
            (&CONSTRAINTS, Arguments::State, Returns::Vector(m), values)
        }
        Product::ConstraintVelocity => {
            let rates = constraints.iter().map(|constraint| constraint.velocity).collect();
            (&CONSTRAINT_VELOCITY, Arguments::State, Returns::Vector(m), rates)
        }
        Product::ConstraintJacobian => {
            let entries = equations.constraints.jacobian.concat();
            (&CONSTRAINT_JACOBIAN, Arguments::Positions, Returns::Matrix(m, n), entries)
        }
        _ => (&CONSTRAINT_FORCES, Arguments::State, Returns::Vector(n), equations.constraints.forces.clone()),
    };
    Plan { docs, arguments, returns, roots }
}

fn derivatives(product: Product, model: &mut Model, equations: &Equations, fields: usize) -> Plan {
    let (docs, (returns, roots)): (&[&str], _) = match product {
        Product::Jacobian => {
            (&JACOBIAN, by_state(&mut model.graph, equations.jacobian.as_deref().unwrap_or_default()))
        }
        _ => {
            let rows = equations.parameter_jacobian.as_deref().unwrap_or_default();
            (&PARAMETER_JACOBIAN, by_fields(&mut model.graph, rows, fields))
        }
    };
    Plan { docs, arguments: Arguments::Whole, returns, roots }
}

const MASS_MATRIX: [&str; 1] = ["Mass matrix M, in rows."];
const FORCING: [&str; 1] = ["Right-hand side f of M q̈ = f."];
const BIAS: [&str; 2] = [
    "Bias c of M q̈ + c = Q: Coriolis, centrifugal and potential terms,",
    "without applied forces and dissipation.",
];
const CONSTRAINTS: [&str; 2] = [
    "What the constraints hold at zero, in the order of their declaration; the velocities matter to",
    "nonholonomic ones only.",
];
const CONSTRAINT_VELOCITY: [&str; 2] = [
    "What the constraints demand of the velocities to be zero: the rate of a holonomic constraint,",
    "a nonholonomic one itself.",
];
const CONSTRAINT_JACOBIAN: [&str; 2] =
    ["Matrix A of the constraints, in rows: what each demands of the velocities, differentiated by", "them."];
const CONSTRAINT_FORCES: [&str; 1] = ["Generalised forces Aᵀλ of the constraints."];
const MOMENTA: [&str; 1] = ["Generalised momenta ∂L/∂v."];
const MOMENTUM_RATES: [&str; 1] = ["Rates ∂L/∂q + Q of the momenta."];
const KINETIC: [&str; 1] = ["Kinetic energy T."];
const POTENTIAL: [&str; 1] = ["Potential energy V."];
const ENERGY: [&str; 1] = ["Energy function v·∂L/∂v − L."];
const INVERSE: [&str; 2] = [
    "Inverse dynamics: the generalised forces that must act, in addition to the declared ones,",
    "to produce given accelerations.",
];
