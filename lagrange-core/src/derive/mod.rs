//! From a model to its equations of motion.
//!
//! [`Equations`] are the results of the emitted methods. [`derive()`] finds them, or reports an
//! undetermined motion.
//!
//! # The form
//!
//! **Velocities stay nodes.** `dot(x)` of any expression is its total time derivative, and the
//! model remembers which velocity is the rate of which position.
//!
//! `least_constraint` traverses the Lagrangian from its root. A term ½ w u² with u = dx/dt
//! contributes *at the node u*. It adds w to the quadratic and w u̇ + ẇ u to the linear part. It
//! also contributes −½ u² at the node ẇ. The potential contributes 1 at V̇, a force F at a point p
//! contributes −F at ṗ. Everything else contributes second derivatives by a second-order reverse
//! sweep and d/dt ∂L/∂v − ∂L/∂q by reverse mode. No Jacobian appears. `quadratic_form` collects the
//! contributions at each pair of nodes and sums them when necessary.
//!
//! If such terms contain components in joint-rotated axes, brackets at the rotated pairs replace
//! these rates (`quasi_velocities`).
//!
//! A Gibbs function (`gibbs_appell`) describes part of the Lagrangian by second derivatives and
//! slopes in the accelerations. They are stored at the velocities that are the principal parts of
//! accelerations, so forms and sweeps are independent of the origin of coefficients.
//!
//! `sweep` orders the velocity nodes so that one body is finished before the body that carries it.
//! All multiples of one velocity are substituted together, so that its square shares factors with
//! the neighbouring coefficients. Terms outside squares and products, such as the rate of the
//! potential, are pushed down first, so that no velocity waits for them. Components in the axes of
//! a body rotated by a joint are substituted in pairs (`plane_rotation`).
//!
//! # The strategies
//!
//! Each of three strategies (`strategies`) is written down and the one with the lowest cost is
//! kept. Large full matrices are an exception: they are not factorised as a trial, and not even
//! written down unless requested (`forms`). The documentation of the emitted type names the
//! strategy with the counted costs. `cost` counts operations and the longest chain of dependent
//! operations.
//!
//! - *Mass matrix* (`elimination`): every node is pushed down to the generalised velocities. The
//!   coefficients are then the mass matrix, and eliminating all velocities is a left-looking LDLᵀ
//!   factorisation.
//! - *Articulated body* (`elimination`): a velocity is eliminated as soon as no unprocessed node
//!   depends on it. On chains and trees the fill-in stays within a body and the cost is linear. If
//!   joints rotate axes, velocities are eliminated before the rotation or in the order of the
//!   sweep, whichever is cheaper.
//! - *Sum of squares* (`sum_of_squares`): also body by body, but the form stays a sum of squares.
//!   The remainder of an elimination is a sum of squares again, by Lagrange's identity. It depends
//!   on the rest only through minors t₁ y₂ − t₂ y₁ of the direction t in which the unknown moves
//!   two variables. A single number therefore stands for the subtree behind a massless rod.
//!   Accelerations are substituted back in the frame of the rod, and gravity is an offset that
//!   every point shares. Nothing is subtracted that was not subtracted in the declaration. If two
//!   of several squares may both lose the unknown in some configuration, a choice replaces their
//!   rotation. Products of sines and cosines are written in sums and differences of angles where
//!   that leaves fewer terms (`algebra`). This strategy needs a kinetic energy of squares of rates;
//!   velocities are eliminated outermost first, by the number of inertias that they move.
//!
//! # Constraints, contacts and friction
//!
//! **Constraints are more unknowns of the same form** (`constraints`): −λ times the constraint's
//! requirement on accelerations. `elimination` eliminates a multiplier as soon as the velocities of
//! its constraint are gone, when its square −A M⁻¹ Aᵀ is complete. Chains of constrained bodies
//! therefore cost in proportion to their length. Systems of up to 40 unknowns also try multipliers
//! last and keep the cheaper result. Coordinates without inertia are eliminated in pairs with the
//! multiplier that determines them. Meanwhile it records the factor by which each pivot is smaller
//! than the contributions of velocities to it. If that factor exceeds the inverse square of
//! `constraint::rank_tolerance` at run time, emitted code uses a second method. It computes the
//! multipliers of least norm by orthogonal factors of the whole system, or NaN if the equations
//! contradict each other. Projection is one more right-hand side for the same factors.
//!
//! Without constraints only an indefinite matrix has pivots that vanish although it is regular.
//! `indefinite` detects this possibility by the signs of the diagonal, and the second method for
//! such systems is `constraint::indefinite_motion`. Kinetic energies cost nothing extra.
//!
//! **Contacts and friction are responses** (`responses`). A unit of force along the gradient of a
//! gap or of a slip velocity is also one more right-hand side. The acting forces are determined at
//! run time by modes, fields of the emitted type. The force of each is a symbol (`Role::Reaction`)
//! that only outputs and friction limits may contain, the limits only affinely. The equations left
//! to solve at run time are therefore linear, with one row for each force.
//!
//! # What else follows
//!
//! Momenta, forcing, bias and inverse dynamics are linear parts of the same form. Inverse dynamics
//! is the same sweep with accelerations kept, which makes it the recursive Newton–Euler algorithm
//! on chains. Jacobians are found in two ways, and the cheaper is kept (`jacobian`). One is forward
//! differentiation of the accelerations as computed. The other is implicit, from the inverse
//! dynamics, with the factors of M shared by all columns. The Coriolis matrix
//! consists of slopes of the bias (`coriolis`). The regressor consists of Newton–Euler
//! wrenches of bodies and of slopes of the remaining inverse dynamics (`regressor`).
//!
//! **Non-smooth terms switch** (`switches`): conditions of `if` and the kinks of `abs`, `sign`,
//! `min` and `max` in the equations of motion are collected as surfaces. Emission writes every
//! method with a symbol for the side of each (`Role::Side`). A field of the emitted type fixes the
//! sides; free, they are the signs of the surface functions. Conditions inserted by the derivation
//! itself (`sum_of_squares::guard`) have the same value on both sides and do not count. Systems
//! without switches are emitted as if there were none.

mod algebra;
mod centroidal;
mod conserved;
mod constraints;
mod coriolis;
mod cost;
mod coupling;
mod curvature;
mod diffusion;
mod displacements;
mod elimination;
mod energy_function;
mod equations;
mod event_jacobian;
mod forms;
mod frame_jacobians;
mod gibbs_appell;
mod grading;
mod indefinite;
mod inverse_dynamics;
mod inverse_mass_matrix;
mod jacobian;
mod least_constraint;
mod messages;
mod null_space;
mod plane_rotation;
mod power;
mod products;
mod quadratic_form;
mod quasi_velocities;
mod regressor;
mod responses;
mod series;
mod strategies;
mod structure;
mod sum_of_squares;
mod sweep;
mod switches;
mod symmetries;
mod undetermined;
mod virtual_displacements;

use proc_macro2::Span;

use crate::model::{Model, Product};
use lagrange_expr::diagnostics::Report;
use lagrange_language::syntax::ast::{Declaration, StatementKind};
use undetermined::undetermined;

pub use constraints::ConstraintEquations;
pub use coupling::most_coupled;
pub use diffusion::{Diffusion, DiffusionKind};
pub use equations::Equations;
pub use regressor::{Regressor, RegressorColumn};
pub use responses::{Affine, ReactionEquations};
pub use series::SeriesEquations;
pub use strategies::{SingularMassMatrix, Strategy, StrategyChoice};
pub use structure::{Conserved, MassStructure, Structure};
pub use switches::{Switch, one_sided};
pub(crate) use virtual_displacements::along_displacements;

/// Derives the equations of a model. A failure is reported at `place`, or at an undetermined
/// coordinate.
pub fn derive(
    declaration: &Declaration,
    place: Option<Span>,
    model: &mut Model,
    choice: StrategyChoice,
    report: &mut Report,
) -> Option<Equations> {
    let singular = match Equations::derive(model, choice) {
        Ok(equations) => {
            return report_missing_inverse(declaration, model, &equations, report).map(|()| equations);
        }
        Err(error) => error,
    };
    let moving = undetermined(model);
    let named = |index| {
        let coordinate = model.name_of_freedom(index);
        let angular = declaration.velocities().into_iter().map(|velocity| velocity.name);
        let mut names = declaration.coordinates().into_iter().cloned().chain(angular);
        names.find(|name| name.text == coordinate)
    };
    let moving = moving.into_iter().filter_map(named).collect::<Vec<_>>();
    let is_energy =
        |kind: &StatementKind| matches!(kind, StatementKind::Kinetic(_) | StatementKind::Lagrangian(_));
    let energy = declaration.statements.iter().find(|statement| is_energy(&statement.kind));
    let place = place.or(moving.first().map(|name| name.span)).or(energy.map(|energy| energy.origin.start));
    let place = place.unwrap_or(declaration.name.span);
    let names = moving.iter().map(|name| name.text.as_str()).collect::<Vec<_>>();
    report.error(place, singular.message(&names)).help(singular.help());
    None
}

/// Reports a requested inverse of a mass matrix that is singular. Constraints may determine a
/// motion without inertia.
fn report_missing_inverse(
    declaration: &Declaration,
    model: &Model,
    equations: &Equations,
    report: &mut Report,
) -> Option<()> {
    let wanted = Product::InverseMassMatrix;
    if !model.products.contains(&wanted) || equations.product(wanted, model).is_some() {
        return Some(());
    }
    let place = declaration.demand(wanted.name()).unwrap_or(&declaration.name).span;
    report.error(place, messages::NO_INVERSE).help(messages::NO_INVERSE_HELP);
    None
}
