//! Checks of the products that `emit { … }` requests.

use super::delays::check_delays;
use super::elaborator::Elaborator;
use super::messages::{self, scene};
use crate::model::Product;
use lagrange_algebra::calculus::{AccelerationTerms, Rates, gradient, jacobian};
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::expr::{Dependencies, ExprId, Graph};
use lagrange_language::syntax::ast::StateKind;

/// Checks the requested products, except for conditions on the Lagrangian.
pub(super) fn check_products(elaborator: &mut Elaborator<'_>) {
    for &(product, wanted, span) in &elaborator.wanted {
        // A body may be in an unreadable part of the text.
        let is_unclear = product.is_of_bodies() && !elaborator.declaration.unreadable_words.is_empty();
        if wanted && elaborator.is_undefined(product) && !is_unclear {
            let (message, help) = match product {
                _ if product.is_of_bodies() => without_bodies(elaborator, product),
                _ if product.is_of_constraints() => {
                    (messages::needs_constraints(product.name()), messages::CONSTRAINT_HELP)
                }
                _ if product.is_of_events() => (messages::needs_events(product.name()), messages::EVENT_HELP),
                _ => (messages::needs_separate_energies(product.name()), messages::LAGRANGIAN_HELP),
            };
            elaborator.evaluator.report.error(span, message).help(help);
        }
    }
    check_needed_products(elaborator);
    check_derivatives(elaborator);
    check_event_jacobian(elaborator);
    check_linear_model(elaborator);
    check_hessian(elaborator);
    check_delays(elaborator);
}

/// Returns the mistake of a product that requires bodies that do not exist, or that exist in the
/// wrong number of dimensions.
fn without_bodies(elaborator: &Elaborator<'_>, product: Product) -> (String, &'static str) {
    let staged = &elaborator.staged;
    match product {
        Product::Frames | Product::FrameJacobians if !staged.bodies.is_empty() => {
            (scene::only_in_space(product.name()), scene::IN_THE_PLANE_HELP)
        }
        _ => (scene::needs_bodies(product.name()), scene::BODY_HELP),
    }
}

/// Checks that methods called by others are also emitted.
fn check_needed_products(elaborator: &mut Elaborator<'_>) {
    let is_canonical =
        elaborator.velocities_are_rates() && elaborator.products().contains(&Product::MomentumRates);
    let is_constrained = !elaborator.constraints.is_empty();
    let is_ignoring = elaborator.reductions.iter().any(|reduction| !reduction.ignored.is_empty());
    for &(product, wanted, span) in &elaborator.wanted {
        let reason = match product {
            Product::Momenta if is_ignoring => messages::NEEDED_BY_IGNORED,
            Product::Momenta | Product::MassMatrix if is_canonical => messages::NEEDED_BY_MOMENTUM_RATES,
            Product::ConstraintVelocity | Product::ConstraintJacobian if is_constrained => {
                messages::NEEDED_BY_PROJECTION
            }
            _ => continue,
        };
        if !wanted {
            let error = elaborator.evaluator.report.error(span, messages::needed_product(product.name()));
            error.help(messages::needed_product_help(product.name(), reason));
        }
    }
}

/// Reports derivatives beside contacts and friction, at whose changes of mode accelerations jump.
fn check_derivatives(elaborator: &mut Elaborator<'_>) {
    let Some((reaction, declared)) = elaborator.reactions.first() else { return };
    for &(product, wanted, span) in &elaborator.wanted {
        if wanted && product.is_derivative() {
            let message = messages::derivative_of_jumps(product.name());
            let error =
                elaborator.evaluator.report.error(span, message).help(messages::DERIVATIVE_OF_JUMPS_HELP);
            error.related(Origin::from(*declared), messages::acts_here(&reaction.name));
        }
    }
}

/// Reports derivatives of events that contain accelerations, beside contacts and friction, at whose
/// changes of mode they jump.
fn check_event_jacobian(elaborator: &mut Elaborator<'_>) {
    let Some((reaction, declared)) = elaborator.reactions.first() else { return };
    let (graph, jumping) =
        (&elaborator.evaluator.graph, Dependencies::ACCELERATION | Dependencies::MULTIPLIER);
    if !elaborator.events.iter().any(|(event, _)| graph.dependencies(event.value).intersects(jumping)) {
        return;
    }
    for span in elaborator.demands(Product::EventJacobian) {
        let message = messages::derivative_of_jumps(Product::EventJacobian.name());
        let error = elaborator.evaluator.report.error(span, message).help(messages::EVENT_OF_JUMPS_HELP);
        error.related(Origin::from(*declared), messages::acts_here(&reaction.name));
    }
}

/// Reports linear models of discrete systems. A linear model does not include jumps of the state,
/// and the matrix of constants without a rate is singular.
fn check_linear_model(elaborator: &mut Elaborator<'_>) {
    let discrete = elaborator.states.iter().filter(|state| state.kind == StateKind::Discrete);
    let mut places = discrete.map(|state| state.name.span).chain(elaborator.clocks.iter().map(|(_, at)| *at));
    let Some(place) = places.next() else { return };
    for span in elaborator.demands(Product::SystemMatrix) {
        let error = elaborator.evaluator.report.error(span, messages::DISCRETE_LINEAR_MODEL);
        error.related(Origin::from(place), messages::DISCRETE_IS_HERE);
        error.help(messages::DISCRETE_LINEAR_MODEL_HELP);
    }
}

/// Reports Hessians with unit quaternions. Second derivatives with respect to their components
/// depend on the extension of the Lagrangian to other lengths.
fn check_hessian(elaborator: &mut Elaborator<'_>) {
    if elaborator.orientations.is_empty() {
        return;
    }
    for span in elaborator.demands(Product::LagrangianHessian) {
        let report = &mut *elaborator.evaluator.report;
        report.error(span, messages::HESSIAN_OF_ORIENTATION).help(messages::HESSIAN_OF_ORIENTATION_HELP);
    }
}

/// Reports Coriolis matrices of systems whose inertia depends on velocities, directly or through
/// the rate of a state. Their bias is not quadratic in the velocities.
pub(super) fn check_coriolis_matrix(elaborator: &mut Elaborator<'_>, lagrangian: ExprId) {
    let demands = elaborator.demands(Product::CoriolisMatrix);
    if demands.is_empty() || !has_moving_inertia(elaborator, lagrangian) {
        return;
    }
    for span in demands {
        let error = elaborator.evaluator.report.error(span, messages::CORIOLIS_OF_MOVING_INERTIA);
        error.help(messages::CORIOLIS_OF_MOVING_INERTIA_HELP);
    }
}

fn has_moving_inertia(elaborator: &mut Elaborator<'_>, lagrangian: ExprId) -> bool {
    let velocities = elaborator.speeds.iter().map(|(speed, _)| speed.velocity).collect::<Vec<_>>();
    let graph = &mut elaborator.evaluator.graph;
    let mut rates = Rates::new(AccelerationTerms::Dropped);
    let moves = |graph: &Graph, id: ExprId| graph.dependencies(id).intersects(Dependencies::VELOCITY);
    let states = elaborator.states.iter().map(|state| state.position);
    let driven = states.filter(|&state| {
        let rate = rates.of(graph, state);
        moves(graph, rate)
    });
    let driven = driven.collect::<Vec<_>>();
    let momenta = gradient(graph, lagrangian, &velocities);
    let inertia = jacobian(graph, &momenta, &velocities).concat();
    let slopes = jacobian(graph, &momenta, &driven).concat();
    inertia.iter().any(|&entry| moves(graph, entry)) || !slopes.iter().all(|&slope| graph.is_zero(slope))
}
