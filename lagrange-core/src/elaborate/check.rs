//! The checks that need the whole declaration, and the model they certify.

use super::elaborator::{Elaborator, Term};
use super::messages::{self, scene};
use super::numbers::largest;
use super::smoothness::without_kinks;
use crate::calculus::{AccelerationTerms, Rates, gradient};
use crate::diagnostics::Origin;
use crate::expr::{Dependencies, ExprId};
use crate::model::{Energies, Model, Product, Reduction};
use crate::syntax::ast::StatementKind;

impl Elaborator<'_> {
    /// The model and what is to be reduced of it.
    pub(super) fn finish(mut self) -> Option<(Model, Vec<Reduction>)> {
        self.check_header();
        self.check_state_names();
        self.check_reductions();
        self.check_energies();
        self.check_magnitudes();
        self.check_products();
        self.check_output_names();
        self.check_motion_names();
        self.check_constraint_count();
        self.check_reduced_constraints();
        self.check_stabilisation();
        self.check_event_count();
        self.check_reduced_events();
        if self.evaluator.report.has_errors() {
            return None;
        }
        let energies = self.energies();
        let lagrangian = match energies {
            Energies::Separate { kinetic, potential } => self.evaluator.graph.subtract(kinetic, potential),
            Energies::Lagrangian => self.total(|elaborator| &elaborator.lagrangian),
        };
        self.check_signs();
        let lagrangian = without_kinks(&mut self.evaluator.graph, lagrangian);
        self.check_inertia(lagrangian);
        if self.evaluator.report.has_errors() {
            return None;
        }
        self.evaluator.scope.report_unused(self.evaluator.report);
        let reductions = std::mem::take(&mut self.reductions);
        Some((self.into_model(energies, lagrangian), reductions))
    }

    fn check_header(&mut self) {
        let declaration = self.declaration;
        let report = &mut *self.evaluator.report;
        if let Some(default) = declaration.derives.iter().find(|name| name.text == "Default") {
            report.error(default.span, messages::DERIVED_DEFAULT).help(messages::DERIVED_DEFAULT_HELP);
        }
        if let [first, ..] = declaration.underivable()[..] {
            let names = declaration.underivable().iter().map(|name| name.text.as_str()).collect::<Vec<_>>();
            let (scalar, _) = largest(&declaration.scalar);
            report.error(first.span, messages::underivable(&names, scalar)).help(messages::UNDERIVABLE_HELP);
        }
        if !declaration.unreadable_words.is_empty() {
            // What is missing may be in a statement that could not be read.
            return;
        }
        let has = |kind: fn(&StatementKind) -> bool| declaration.statements.iter().any(|s| kind(&s.kind));
        if !has(|kind| matches!(kind, StatementKind::Coordinates(_))) {
            report.error(declaration.name.span, messages::NO_COORDINATES).help(messages::COORDINATES_HELP);
        }
        if !has(|kind| matches!(kind, StatementKind::Kinetic(_) | StatementKind::Lagrangian(_))) {
            report.error(declaration.name.span, messages::NO_ENERGY).help(messages::ENERGY_HELP);
        }
    }

    /// The state has a field for every coordinate and for every velocity.
    fn check_state_names(&mut self) {
        for (coordinate, declared) in &self.coordinates {
            let velocity = format!("{}_dot", coordinate.name);
            let clash = self.coordinates.iter().find(|(other, _)| other.name == velocity);
            if let Some((other, span)) = clash {
                let message = messages::velocity_field_collides(&other.name, &coordinate.name);
                let error = self.evaluator.report.error(*span, message).help(messages::OTHER_NAME_HELP);
                error.related(Origin::from(*declared), messages::coordinate_is_here(&coordinate.name));
            }
        }
    }

    fn check_energies(&mut self) {
        if let Some(lagrangian) = self.lagrangian.first() {
            let beside = [("kinetic", self.kinetic.first()), ("potential", self.potential.first())];
            for (name, term) in beside.into_iter().filter_map(|(name, term)| Some((name, term?))) {
                let error = self.evaluator.report.error(term.keyword, messages::both_lagrangian_and(name));
                error.related(lagrangian.keyword.into(), messages::LAGRANGIAN_IS_HERE);
                error.help(messages::LAGRANGIAN_HELP);
            }
        }
        for (syntax, value) in self.potential.iter().map(|term| (term.syntax, term.value)).collect::<Vec<_>>()
        {
            let kinds = &[Dependencies::VELOCITY];
            self.forbid(kinds, (syntax, value), "the potential energy", messages::POTENTIAL_HELP);
        }
    }

    fn check_products(&mut self) {
        for &(product, wanted, span) in &self.wanted {
            // A body may be where the text could not be read.
            let is_unclear = product.is_of_bodies() && !self.declaration.unreadable_words.is_empty();
            if wanted && self.is_undefined(product) && !is_unclear {
                let (message, help) = match product {
                    _ if product.is_of_bodies() => (scene::needs_bodies(product.name()), scene::BODY_HELP),
                    _ if product.is_of_constraints() => {
                        (messages::needs_constraints(product.name()), messages::CONSTRAINT_HELP)
                    }
                    _ => (messages::needs_separate_energies(product.name()), messages::LAGRANGIAN_HELP),
                };
                self.evaluator.report.error(span, message).help(help);
            }
        }
        self.check_needed_products();
        self.check_derivatives();
    }

    /// Some methods are called by others.
    fn check_needed_products(&mut self) {
        let is_canonical = self.products().contains(&Product::MomentumRates);
        let is_constrained = !self.constraints.is_empty();
        for &(product, wanted, span) in &self.wanted {
            let reason = match product {
                Product::Momenta | Product::MassMatrix if is_canonical => messages::NEEDED_BY_MOMENTUM_RATES,
                Product::ConstraintVelocity | Product::ConstraintJacobian if is_constrained => {
                    messages::NEEDED_BY_PROJECTION
                }
                _ => continue,
            };
            if !wanted {
                let error = self.evaluator.report.error(span, messages::needed_product(product.name()));
                error.help(messages::needed_product_help(product.name(), reason));
            }
        }
    }

    /// Accelerations jump where contacts and friction change what they do.
    fn check_derivatives(&mut self) {
        let Some((reaction, declared)) = self.reactions.first() else { return };
        for &(product, wanted, span) in &self.wanted {
            if wanted && matches!(product, Product::Jacobian | Product::ParameterJacobian) {
                let message = messages::derivative_of_jumps(product.name());
                let error =
                    self.evaluator.report.error(span, message).help(messages::DERIVATIVE_OF_JUMPS_HELP);
                error.related(Origin::from(*declared), messages::acts_here(&reaction.name));
            }
        }
    }

    /// Names of methods that systems with constraints, contacts or events have beside those of all systems.
    fn check_output_names(&mut self) {
        let groups: [(bool, &[&str]); 3] = [
            (
                self.constraints.is_empty(),
                &["project", "consistent_velocity", "redundant_motion", "redundant_correction"],
            ),
            (self.reactions.is_empty(), &["reactions"]),
            (self.events.is_empty(), &["event_functions"]),
        ];
        let taken = groups.into_iter().filter(|(is_absent, _)| !is_absent).flat_map(|(_, names)| names);
        let taken = taken.collect::<Vec<_>>();
        for statement in &self.declaration.statements {
            if let StatementKind::Output(name, _) = &statement.kind
                && taken.iter().any(|taken| **taken == name.text)
            {
                let error = self.evaluator.report.error(name.span, messages::reserved_output(&name.text));
                error.help(messages::OTHER_NAME_HELP);
            }
        }
    }

    fn is_undefined(&self, product: Product) -> bool {
        let is_energy = matches!(product, Product::KineticEnergy | Product::PotentialEnergy);
        !self.lagrangian.is_empty() && is_energy
            || self.constraints.is_empty() && product.is_of_constraints()
            || self.staged.lacks(product)
    }

    pub(super) fn products(&self) -> Vec<Product> {
        let last_word = |product| self.wanted.iter().rev().find(|(named, ..)| *named == product);
        let asked =
            |product: Product, otherwise| last_word(product).map_or(otherwise, |(_, wanted, _)| *wanted);
        let wanted = |&product: &Product| {
            let otherwise = match product {
                Product::ParameterJacobian => asked(Product::Jacobian, false),
                product => product.is_default(),
            };
            asked(product, otherwise) && !self.is_undefined(product)
        };
        Product::ALL.into_iter().filter(wanted).collect()
    }

    fn energies(&mut self) -> Energies {
        if !self.lagrangian.is_empty() {
            return Energies::Lagrangian;
        }
        let kinetic = self.total(|elaborator| &elaborator.kinetic);
        let potential = self.total(|elaborator| &elaborator.potential);
        Energies::Separate { kinetic, potential }
    }

    fn total(&mut self, terms: impl Fn(&Self) -> &Vec<Term>) -> ExprId {
        let values = terms(self).iter().map(|term| term.value).collect::<Vec<_>>();
        self.evaluator.graph.total(values)
    }

    /// Every velocity must appear in the kinetic energy, and the momenta must not depend on inputs, whose
    /// rates would be needed.
    fn check_inertia(&mut self, lagrangian: ExprId) {
        let velocities = self.coordinates.iter().map(|(c, _)| c.velocity).collect::<Vec<_>>();
        let momenta = gradient(&mut self.evaluator.graph, lagrangian, &velocities);
        self.check_smoothness(lagrangian, &momenta);
        let mut needs_input_rate = false;
        for ((coordinate, span), momentum) in self.coordinates.iter().zip(momenta) {
            let dependencies = self.evaluator.graph.dependencies(momentum);
            let is_determined = dependencies.intersects(Dependencies::VELOCITY);
            if !is_determined && !self.is_constrained(coordinate.velocity) {
                let error = self.evaluator.report.error(*span, messages::no_inertia(&coordinate.name));
                error.help(messages::NO_INERTIA_HELP);
            }
            needs_input_rate |= dependencies.intersects(Dependencies::INPUT);
        }
        if needs_input_rate {
            self.report_input_in_kinetic();
        }
    }

    fn report_input_in_kinetic(&mut self) {
        for term in self.kinetic.iter().chain(&self.lagrangian) {
            if self.evaluator.graph.dependencies(term.value).intersects(Dependencies::INPUT) {
                let (place, name) = self.evaluator.blame(term.syntax, Dependencies::INPUT);
                let error = self.evaluator.report.error(place, messages::input_in_kinetic(&name));
                error.help(messages::RATE_OF_INPUT_HELP);
            }
        }
    }

    fn into_model(mut self, energies: Energies, lagrangian: ExprId) -> Model {
        let dissipation = self.total(|elaborator| &elaborator.dissipation);
        let dissipation = self.with_limits(dissipation);
        let products = self.products();
        let mut labels = self.labels;
        // Rates of what has a name occur in the equations whether or not the user wrote them.
        let moving = Dependencies::VELOCITY | Dependencies::ACCELERATION;
        let mut rates = Rates::new(AccelerationTerms::Kept);
        for (position, name) in labels.clone() {
            let dependencies = self.evaluator.graph.dependencies(position);
            if !dependencies.intersects(moving) && !dependencies.is_constant_in_motion() {
                let rate = rates.of(&mut self.evaluator.graph, position);
                labels.push((rate, format!("{name}_dot")));
            }
        }
        let rates = self.evaluator.named_rates.iter().map(|(velocity, position)| (*velocity, *position));
        let rates = rates.collect();
        Model {
            graph: self.evaluator.graph,
            parameters: self.parameters,
            inputs: self.inputs,
            coordinates: self.coordinates.into_iter().map(|(coordinate, _)| coordinate).collect(),
            energies,
            lagrangian,
            dissipation,
            loads: self.loads,
            constraints: self.constraints.into_iter().map(|(constraint, _)| constraint).collect(),
            implied: self.implied,
            stabilisation: self.stabilisation.map(|(rate, _)| rate),
            events: self.events.into_iter().map(|(event, _)| event).collect(),
            reactions: self.reactions.into_iter().map(|(reaction, _)| reaction).collect(),
            outputs: self.outputs,
            scene: self.scene,
            rates,
            labels,
            accuracy: self.declaration.accuracy,
            products,
            reduced: Vec::new(),
        }
    }
}
