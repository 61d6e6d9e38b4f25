//! Checks of the whole declaration, and the resulting model.

use super::constraints::{check_reduced_constraints, is_constrained};
use super::damping::with_limits;
use super::elaborator::{Elaborator, SourceTerm};
use super::events::check_reduced_events;
use super::gibbs::total_gibbs;
use super::history::{check_history, set_past_signals};
use super::ignored::Terms;
use super::limits::store_limits;
use super::magnitudes::check_magnitudes;
use super::messages;
use super::noise::{check_noise, separate_noises};
use super::opaque::report_uncalled;
use super::products::{check_coriolis_matrix, check_products};
use super::reductions::check_reductions;
use super::scalar_range::largest;
use super::scene::check_names_of_bodies;
use super::signs::check_signs;
use super::smoothness::{check_smoothness, without_kinks};
use super::solve::check_names_of_solvers;
use super::stabilisation::check_stabilisation;
use super::start::{check_starts, initial_state};
use super::states::{check_states, positions_of_states, warn_of_constant_states};
use super::tables::{check_names_of_derivatives, check_tables};
use crate::model::{Energies, Model, Product, Reduction, Speed};
use lagrange_algebra::calculus::{AccelerationTerms, Rates, gradient};
use lagrange_expr::collections::HashMap;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::expr::{Dependencies, ExprId};
use lagrange_expr::units::NamedUnits;
use lagrange_language::syntax::ast::StatementKind;

/// Returns the model and its reductions; `None` after an error, which has been reported.
pub(super) fn finish(mut elaborator: Elaborator<'_>) -> Option<(Model, Vec<Reduction>, Terms)> {
    check_statements(&mut elaborator);
    if elaborator.evaluator.report.has_errors() {
        return None;
    }
    let energies = total_energies(&mut elaborator);
    let lagrangian = match energies {
        Energies::Separate { kinetic, potential } => elaborator.evaluator.graph.subtract(kinetic, potential),
        Energies::Lagrangian | Energies::Routhian { .. } => {
            total(&mut elaborator, |elaborator| &elaborator.lagrangian)
        }
    };
    check_signs(&mut elaborator);
    let lagrangian = without_kinks(&mut elaborator.evaluator.graph, lagrangian);
    check_inertia(&mut elaborator, lagrangian);
    check_coriolis_matrix(&mut elaborator, lagrangian);
    if elaborator.evaluator.report.has_errors() {
        return None;
    }
    elaborator.evaluator.scope.report_unused(elaborator.evaluator.report);
    warn_of_constant_states(&mut elaborator);
    report_uncalled(&mut elaborator.evaluator);
    let reductions = std::mem::take(&mut elaborator.reductions);
    let terms = Terms::of(&elaborator);
    Some((into_model(elaborator, energies, lagrangian), reductions, terms))
}

/// Performs the checks that need no Lagrangian.
fn check_statements(elaborator: &mut Elaborator<'_>) {
    check_header(elaborator);
    check_state_names(elaborator);
    check_states(elaborator);
    check_starts(elaborator);
    check_history(elaborator);
    check_reductions(elaborator);
    check_energies(elaborator);
    check_magnitudes(elaborator);
    check_tables(elaborator);
    check_names_of_derivatives(elaborator);
    check_names_of_solvers(elaborator);
    check_products(elaborator);
    check_output_names(elaborator);
    check_names_of_bodies(elaborator);
    check_reduced_constraints(elaborator);
    check_stabilisation(elaborator);
    check_reduced_events(elaborator);
    check_noise(elaborator);
}

fn check_header(elaborator: &mut Elaborator<'_>) {
    let declaration = elaborator.declaration;
    let report = &mut *elaborator.evaluator.report;
    if let Some(default) = declaration.derives.iter().find(|name| name.text == "Default") {
        report.error(default.span, messages::DERIVED_DEFAULT).help(messages::DERIVED_DEFAULT_HELP);
    }
    if let [first, ..] = declaration.underivable()[..] {
        let names = declaration.underivable().iter().map(|name| name.text.as_str()).collect::<Vec<_>>();
        let (scalar, _) = largest(&declaration.scalar);
        report.error(first.span, messages::underivable(&names, scalar)).help(messages::UNDERIVABLE_HELP);
    }
    if !declaration.unreadable_words.is_empty() {
        // The missing item may be in an unreadable statement.
        return;
    }
    let has = |kind: fn(&StatementKind) -> bool| declaration.statements.iter().any(|s| kind(&s.kind));
    if declaration.coordinates().is_empty() {
        report.error(declaration.name.span, messages::NO_COORDINATES).help(messages::COORDINATES_HELP);
    }
    // An unreadable body accounts for the missing energy.
    let is_clear = declaration.bodies.is_empty() || !report.has_errors();
    let has_energy = has(|kind| matches!(kind, StatementKind::Kinetic(_) | StatementKind::Lagrangian(_)));
    // Systems of states alone have no velocities, and no energy.
    let is_mechanical = !declaration.velocities().is_empty() || declaration.states().next().is_none();
    if is_clear && is_mechanical && !has_energy {
        report.error(declaration.name.span, messages::NO_ENERGY).help(messages::ENERGY_HELP);
    }
}

/// Checks that fields of the state are distinct. The state has a field for every coordinate and
/// velocity. Declared names are checked against each other elsewhere.
fn check_state_names(elaborator: &mut Elaborator<'_>) {
    let is_declared = |speed: &Speed| elaborator.evaluator.scope.is_velocity(&speed.name);
    let coordinates = elaborator.coordinates.iter().map(|(c, span)| (&c.name, c.position, *span));
    let speeds = elaborator.speeds.iter().filter(|(speed, _)| is_declared(speed));
    let states = elaborator.states.iter().map(|state| (&state.name.text, state.position, state.name.span));
    let mut declared = HashMap::default();
    for (name, id, span) in
        coordinates.chain(states).chain(speeds.map(|(s, span)| (&s.name, s.velocity, *span)))
    {
        declared.get_or_insert_with(name.clone(), || (id, span));
    }
    let mut clashes = Vec::new();
    for (speed, place) in &elaborator.speeds {
        let Some((coordinate, _)) = speed.coordinate.and_then(|index| elaborator.coordinates.get(index))
        else {
            continue;
        };
        if speed.name == format!("{}_dot", coordinate.name) {
            let clash = declared.get(&speed.name).filter(|(id, _)| *id != speed.velocity);
            clashes.extend(clash.map(|(_, span)| (&speed.name, &coordinate.name, *span, *place)));
        }
    }
    for (velocity, coordinate, span, place) in clashes {
        let message = messages::velocity_field_collides(velocity, coordinate);
        let error = elaborator.evaluator.report.error(span, message).help(messages::OTHER_NAME_HELP);
        error.related(Origin::from(place), messages::coordinate_is_here(coordinate));
    }
}

fn check_energies(elaborator: &mut Elaborator<'_>) {
    if let Some(lagrangian) = elaborator.lagrangian.first() {
        let beside = [("kinetic", elaborator.kinetic.first()), ("potential", elaborator.potential.first())];
        for (name, term) in beside.into_iter().filter_map(|(name, term)| Some((name, term?))) {
            let error = elaborator.evaluator.report.error(term.keyword, messages::both_lagrangian_and(name));
            error.related(lagrangian.keyword.into(), messages::LAGRANGIAN_IS_HERE);
            error.help(messages::LAGRANGIAN_HELP);
        }
    }
    for (syntax, value) in
        elaborator.potential.iter().map(|term| (term.syntax, term.value)).collect::<Vec<_>>()
    {
        let kinds = &[Dependencies::VELOCITY];
        elaborator.forbid(kinds, (syntax, value), "the potential energy", messages::POTENTIAL_HELP);
    }
}

/// Reports outputs named like the additional methods of systems with constraints, contacts or
/// events.
fn check_output_names(elaborator: &mut Elaborator<'_>) {
    let has_regressor = elaborator.products().contains(&Product::Regressor);
    let groups: [(bool, &[&str]); 9] = [
        (!elaborator.declaration.has_start(), &["start"]),
        (
            elaborator.declaration.ranges().next().is_none() && elaborator.quantities.is_empty(),
            &["check_parameters"],
        ),
        (elaborator.velocities_are_rates(), &["position_rates"]),
        (
            elaborator.constraints.is_empty(),
            &["project", "consistent_velocity", "redundant_motion", "redundant_correction"],
        ),
        (elaborator.reactions.is_empty(), &["reactions"]),
        (elaborator.events.is_empty(), &["event_functions"]),
        (elaborator.clocks.is_empty(), &["clock_periods"]),
        (elaborator.noises.is_empty(), &["diffusion"]),
        (!has_regressor, &["regressor_parameters", "REGRESSOR_PARAMETERS"]),
    ];
    let taken = groups.into_iter().filter(|(is_absent, _)| !is_absent).flat_map(|(_, names)| names);
    let taken = taken.collect::<Vec<_>>();
    for name in elaborator.declaration.outputs() {
        if taken.iter().any(|taken| **taken == name.text) {
            let error = elaborator.evaluator.report.error(name.span, messages::reserved_output(&name.text));
            error.help(messages::OTHER_NAME_HELP);
        }
    }
}

fn total_energies(elaborator: &mut Elaborator<'_>) -> Energies {
    if !elaborator.lagrangian.is_empty() {
        return Energies::Lagrangian;
    }
    let kinetic = total(elaborator, |elaborator| &elaborator.kinetic);
    let potential = total(elaborator, |elaborator| &elaborator.potential);
    Energies::Separate { kinetic, potential }
}

fn total(
    elaborator: &mut Elaborator<'_>,
    terms: impl for<'e> Fn(&'e Elaborator<'_>) -> &'e Vec<SourceTerm>,
) -> ExprId {
    let values = terms(elaborator).iter().map(|term| term.value).collect::<Vec<_>>();
    elaborator.evaluator.graph.total(values)
}

/// Checks that every velocity appears in the kinetic energy, and that momenta do not depend on
/// inputs, whose rates would be needed.
fn check_inertia(elaborator: &mut Elaborator<'_>, lagrangian: ExprId) {
    let velocities = elaborator.speeds.iter().map(|(speed, _)| speed.velocity).collect::<Vec<_>>();
    let momenta = gradient(&mut elaborator.evaluator.graph, lagrangian, &velocities);
    check_smoothness(elaborator, lagrangian, &momenta);
    let (mut needs_input_rate, mut is_random) = (false, false);
    let (has_noise, mut rates) = (!elaborator.noises.is_empty(), Rates::new(AccelerationTerms::Dropped));
    for ((speed, span), momentum) in elaborator.speeds.iter().zip(momenta) {
        let dependencies = elaborator.evaluator.graph.dependencies(momentum);
        let is_determined = dependencies.intersects(Dependencies::VELOCITY);
        if !is_determined && !is_constrained(elaborator, speed.velocity) {
            let name = elaborator.name_of_freedom(speed);
            let graph = &elaborator.evaluator.graph;
            // A declared Lagrangian may have linear terms, for example of magnets.
            let is_separate = elaborator.lagrangian.is_empty();
            let is_linear = is_separate && graph.reachable(&[lagrangian]).contains(&speed.velocity);
            let error = elaborator.evaluator.report.error(*span, messages::no_inertia(name));
            error.help(if is_linear { messages::NOT_SQUARED_HELP } else { messages::NO_INERTIA_HELP });
        }
        needs_input_rate |= dependencies.intersects(Dependencies::INPUT);
        if has_noise && dependencies.intersects(Dependencies::STATE) {
            let rate = rates.of(&mut elaborator.evaluator.graph, momentum);
            is_random |= elaborator.evaluator.graph.dependencies(rate).intersects(Dependencies::NOISE);
        }
    }
    if is_random {
        let help = messages::noise::IN_MOMENTUM_HELP;
        report_in_kinetic(elaborator, Dependencies::STATE, |name| messages::noise::in_momentum(name), help);
    }
    if needs_input_rate {
        let help = messages::RATE_OF_INPUT_HELP;
        report_in_kinetic(elaborator, Dependencies::INPUT, |name| messages::input_in_kinetic(name), help);
    }
}

/// Reports energies in which symbols of this kind multiply velocities.
fn report_in_kinetic(
    elaborator: &mut Elaborator<'_>,
    kind: Dependencies,
    message: impl Fn(&str) -> String,
    help: &str,
) {
    for term in elaborator.kinetic.iter().chain(&elaborator.lagrangian) {
        if elaborator.evaluator.graph.dependencies(term.value).intersects(kind) {
            let (place, name) = elaborator.evaluator.blame(term.syntax, kind);
            elaborator.evaluator.report.error(place, message(&name)).help(help);
        }
    }
}

fn into_model(mut elaborator: Elaborator<'_>, energies: Energies, lagrangian: ExprId) -> Model {
    let dissipation = total(&mut elaborator, |elaborator| &elaborator.dissipation);
    let dissipation = with_limits(&mut elaborator, dissipation);
    let gibbs = total_gibbs(&mut elaborator);
    let products = elaborator.products();
    let start = initial_state(&mut elaborator);
    set_past_signals(&mut elaborator);
    let noises = separate_noises(&mut elaborator);
    let states = positions_of_states(&elaborator);
    let mut labels = elaborator.labels;
    // Rates of named expressions occur in the equations even if the user did not write them.
    let moving = Dependencies::VELOCITY | Dependencies::ACCELERATION;
    let mut rates = Rates::new(AccelerationTerms::Kept);
    for (position, name) in labels.clone() {
        let dependencies = elaborator.evaluator.graph.dependencies(position);
        if !dependencies.intersects(moving) && !dependencies.is_constant_in_motion() {
            let rate = rates.of(&mut elaborator.evaluator.graph, position);
            labels.push((rate, format!("{name}_dot")));
        }
    }
    let rates = elaborator.evaluator.named_rates.iter().map(|(velocity, position)| (*velocity, *position));
    let rates = rates.collect();
    let coordinates = elaborator.coordinates.into_iter().map(|(coordinate, _)| coordinate);
    let mut coordinates = coordinates.chain(states).collect::<Vec<_>>();
    let mut speeds = elaborator.speeds.into_iter().map(|(speed, _)| speed).collect::<Vec<_>>();
    store_limits(elaborator.limits, &mut coordinates, &mut speeds);
    Model {
        graph: elaborator.evaluator.graph,
        parameters: elaborator.parameters,
        inputs: elaborator.inputs,
        noises,
        delays: elaborator.delays.into_iter().map(|(delay, _)| delay).collect(),
        coordinates,
        speeds,
        orientations: elaborator.orientations,
        start,
        energies,
        lagrangian,
        gibbs,
        dissipation,
        loads: elaborator.loads,
        constraints: elaborator.constraints.into_iter().map(|(constraint, _)| constraint).collect(),
        implied: elaborator.implied,
        stabilisation: elaborator.stabilisation.map(|(rate, _)| rate),
        events: elaborator.events.into_iter().map(|(event, _)| event).collect(),
        clocks: elaborator.clocks.into_iter().map(|(clock, _)| clock).collect(),
        reactions: elaborator.reactions.into_iter().map(|(reaction, _)| reaction).collect(),
        quantities: elaborator.quantities,
        distances: elaborator.distances,
        outputs: elaborator.outputs,
        scene: elaborator.scene,
        rates,
        labels,
        units: NamedUnits::default(),
        accuracy: elaborator.declaration.accuracy,
        products,
        reduced: Vec::new(),
    }
}
