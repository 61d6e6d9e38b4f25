//! Lowering of the equations of a system to programs.

use super::drawn::{DrawnScene, PlacedHeight, placed_items};
use super::layout::Layout;
use super::phases::DerivedPart;
use super::programs::{BoundedQuantity, Programs, Range, Reaction, TickingClock, TouchingPrograms};
use super::series::MotionSeries;
use super::system::Derived;
use crate::derive::Equations;
use crate::emit::{
    NamedRoots, ReactionTerms, Variables, by_fields, by_state, by_state_and_inputs, on_sides,
    separate_events, series_programs, system_matrix, variables,
};
use crate::model::{Action, Assignment, Bound, Clock, Event, Model, Product, Quantity, SampledHeight, Speed};
use lagrange_algebra::calculus::gradient;
use lagrange_algebra::program::{Labels, NewtonProgram, Program, lower, optimise};
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::expr::{ExprId, Graph, Node};
use lagrange_language::syntax::ast::Declaration;

/// Maximum number of velocities of systems with a second method. Writing down larger matrices may
/// exceed all other costs.
const LARGEST_SECOND_WAY: usize = 40;

impl Programs {
    /// Lowers all parts of a derived system.
    pub fn new(derived: &Derived) -> Programs {
        Lowering::new(&derived.declaration, &derived.model, &derived.equations).programs()
    }

    /// Lowers all parts of a reduced type.
    pub fn of_part(part: &DerivedPart) -> Programs {
        Lowering::new(&part.declaration, &part.reduced.model, &part.equations).programs()
    }
}

/// The lowering of a system.
struct Lowering<'a> {
    declaration: &'a Declaration,
    model: Model,
    equations: &'a Equations,
    variables: Variables,
    /// Names of subexpressions. Named values are kept as separate results, so results only match
    /// emitted code with the same names.
    labels: Labels,
}

impl<'a> Lowering<'a> {
    fn new(declaration: &'a Declaration, model: &Model, equations: &'a Equations) -> Lowering<'a> {
        let mut labels = Labels::default();
        equations.labels.iter().for_each(|(expression, name)| labels.insert(*expression, name.as_str()));
        let variables = variables(declaration, model, equations);
        Lowering { declaration, model: model.clone(), equations, variables, labels }
    }

    fn programs(mut self) -> Programs {
        let equations = self.equations;
        let growth = growth(equations);
        let rates = self.model.position_rates();
        let unknowns = self.unknowns(&rates);
        let with_growth = |roots: &[ExprId]| [roots, &growth].concat();
        let (accelerations, multipliers) = motion(equations, &growth);
        let events = separate_events(self.declaration, &self.model);
        let reactions = events.iter().map(|event| self.reaction(event)).collect();
        let clocks = self.model.clocks.clone().iter().map(|clock| self.clock(clock)).collect();
        let located = &equations.switches[..self.variables.switches.len()];
        let switches = located.iter().map(|switch| switch.value).collect::<Vec<_>>();
        let times = located.iter().map(|switch| switch.time);
        Programs {
            name: self.declaration.name.text.clone(),
            fingerprint: crate::emit::fingerprint(self.declaration),
            layout: self.layout(),
            defaults: self.defaults(),
            ranges: self.ranges(),
            quantities: self.quantities(),
            quantity_values: self.quantity_values(),
            start: (!self.model.start.is_empty()).then(|| self.as_declared(&self.model.start)),
            position_rates: self.on_sides(&rates),
            accelerations: self.on_sides(&accelerations),
            delayed_inputs: self.model.delays.iter().map(|delay| delay.input).collect(),
            delayed_signals: self
                .on_sides(&self.model.delays.iter().map(|delay| delay.signal).collect::<Vec<_>>()),
            past_signals: self
                .model
                .delays
                .iter()
                .map(|delay| delay.before)
                .collect::<Option<Vec<_>>>()
                .filter(|before| !before.is_empty())
                .map(|before| self.as_declared(&before)),
            lags: self.as_declared(&self.model.delays.iter().map(|delay| delay.lag).collect::<Vec<_>>()),
            noises: self.model.noises.iter().map(|noise| noise.name.clone()).collect(),
            diffusion: self.on_sides(&equations.diffusion.columns.concat()),
            diffusion_kind: equations.diffusion.kind,
            multipliers: self.on_sides(&multipliers),
            growths: growth.len(),
            is_redundant: equations.constraints.is_redundant,
            undivided: self.on_sides(&undivided(equations)),
            are_holonomic: self.model.constraints.iter().map(|constraint| constraint.is_holonomic).collect(),
            position_residuals: self.position_residuals(),
            correction: self.on_sides(&with_growth(&equations.constraints.correction)),
            mass_times: self.mass_times(),
            switch_times: times.map(|time| time.map(|time| self.as_declared(&[time]))).collect(),
            switches: self.as_declared(&switches),
            event_functions: self.event_functions(&events),
            reactions,
            clocks,
            products: self.products(),
            jacobian: self.derivatives(Product::Jacobian, |model, _, rows| by_state(model, rows)),
            parameter_jacobian: self
                .derivatives(Product::ParameterJacobian, |model, _, rows| by_fields(model, rows)),
            linearised: self.derivatives(Product::SystemMatrix, by_state_and_inputs),
            system_matrix: self.derivatives(Product::SystemMatrix, system_matrix),
            series: self.series(),
            regressor_parameters: self.regressor_parameters(),
            outputs: self.outputs(),
            drawing: self.drawing(),
            round_contacts: self
                .model
                .distances
                .iter()
                .map(|(name, _)| self.declaration.written(&name.text).to_owned())
                .collect(),
            distances: self.on_sides(&self.model.distances.iter().map(|(_, root)| *root).collect::<Vec<_>>()),
            unknowns: unknowns.iter().map(|(_, name)| name.clone()).collect(),
            unknown_values: self.on_sides(&unknowns.iter().map(|(root, _)| *root).collect::<Vec<_>>()),
            solutions: self.solutions(),
            touching: self.touching(),
            variables: self.variables,
        }
    }

    fn layout(&self) -> Layout {
        Layout {
            positions: self.model.coordinates.len(),
            velocities: self.model.speeds.len(),
            parameters: self.model.parameters.len(),
            inputs: self.model.inputs.len(),
            sides: self.variables.switches.len(),
            multipliers: self.model.constraints.len(),
            reactions: self.model.reactions.len(),
        }
    }

    /// Lowers expressions for the sides of the switches.
    fn on_sides(&mut self, roots: &[ExprId]) -> Program {
        let switches = &self.equations.switches[..self.variables.switches.len()];
        let graph = &mut self.model.graph;
        let NamedRoots { roots, labels } = on_sides(graph, &self.labels, switches, roots);
        lowered(&self.model.graph, &roots, &labels, self.model.accuracy)
    }

    /// Lowers expressions with conditions, kinks and jumps as they are declared.
    fn as_declared(&self, roots: &[ExprId]) -> Program {
        lowered(&self.model.graph, roots, &self.labels, self.model.accuracy)
    }

    /// Evaluates constant expressions.
    fn constants(&self, roots: &[ExprId]) -> Vec<f64> {
        let program = lowered(&self.model.graph, roots, &Labels::default(), self.model.accuracy);
        lagrange_algebra::program::run(&program, |_| f64::NAN)
    }

    fn defaults(&self) -> Vec<f64> {
        let fields = self.model.parameters.iter().chain(&self.model.inputs);
        let known = fields.clone().filter_map(|field| field.default).collect::<Vec<_>>();
        let mut values = self.constants(&known).into_iter();
        fields.map(|field| field.default.and_then(|_| values.next()).unwrap_or(f64::NAN)).collect()
    }

    fn ranges(&self) -> Vec<Range> {
        let bound = |bound: &Option<Bound>| {
            let bound = bound.as_ref()?;
            Some((self.constants(&[bound.value])[0], bound.is_included))
        };
        let parameters = self.model.parameters.iter().enumerate();
        let limited = parameters.filter(|(_, parameter)| parameter.range.iter().any(Option::is_some));
        limited.map(|(parameter, of)| Range { parameter, bounds: of.range.each_ref().map(bound) }).collect()
    }

    fn quantities(&self) -> Vec<BoundedQuantity> {
        let bounded = |quantity: &Quantity| BoundedQuantity {
            words: quantity.in_words(self.declaration.written(&quantity.contact.text)),
            bounds: quantity.range.map(|bound| Some(bound?.is_included)),
        };
        self.model.quantities.iter().map(bounded).collect()
    }

    fn quantity_values(&self) -> Program {
        let values = |Quantity { value, range, .. }: &Quantity| {
            [*value].into_iter().chain(range.iter().flatten().map(|bound| bound.value)).collect::<Vec<_>>()
        };
        self.as_declared(&self.model.quantities.iter().flat_map(values).collect::<Vec<_>>())
    }

    fn position_residuals(&mut self) -> Program {
        let zero = self.model.graph.number(0);
        let constraints = self.model.constraints.iter();
        let roots = constraints.map(|c| if c.is_holonomic { c.value } else { zero }).collect::<Vec<_>>();
        self.on_sides(&roots)
    }

    /// Lowers M a, the gradient of a · ∂L/∂v with respect to the velocities.
    fn mass_times(&mut self) -> Program {
        if self.model.constraints.is_empty() {
            return self.as_declared(&[]);
        }
        let (lagrangian, velocities) = (self.model.lagrangian, self.model.velocities());
        let changes = self.model.speeds.iter().map(|speed: &Speed| speed.acceleration).collect::<Vec<_>>();
        let graph = &mut self.model.graph;
        let momenta = gradient(graph, lagrangian, &velocities);
        let products = momenta.iter().zip(&changes).map(|(&p, &change)| graph.multiply(p, change));
        let products = products.collect::<Vec<_>>();
        let product = graph.total(products);
        let roots = gradient(graph, product, &velocities);
        self.on_sides(&roots)
    }

    fn event_functions(&mut self, events: &[Event]) -> Program {
        let one = self.model.graph.number(1);
        let value = |event: &Event| if let Action::Impact(_) = event.action { one } else { event.value };
        let values = events.iter().map(value).collect::<Vec<_>>();
        self.on_sides(&values)
    }

    fn reaction(&mut self, event: &Event) -> Reaction {
        match &event.action {
            Action::Record => Reaction::Record,
            Action::Stop => Reaction::Stop,
            Action::Impact(_) => Reaction::Impact,
            Action::Assign(assignments) => Reaction::Replace(self.assigned(assignments)),
        }
    }

    fn clock(&mut self, clock: &Clock) -> TickingClock {
        TickingClock { period: self.as_declared(&[clock.period]), after: self.assigned(&clock.assignments) }
    }

    /// Lowers the state after assignments.
    fn assigned(&mut self, assignments: &[Assignment]) -> Program {
        self.on_sides(&self.model.state_after(assignments))
    }

    fn products(&mut self) -> Vec<(Product, Program)> {
        let is_constrained = !self.model.constraints.is_empty();
        let wanted = Product::ALL.into_iter().filter(|product| {
            // All rows of the system matrix have separate programs.
            *product != Product::SystemMatrix && (is_constrained || !product.is_of_constraints())
        });
        let roots =
            wanted.filter_map(|product| Some((product, self.equations.product(product, &self.model)?)));
        let roots = roots.collect::<Vec<_>>();
        roots.into_iter().map(|(product, roots)| (product, self.on_sides(&roots))).collect()
    }

    /// Lowers all rows of a derivative, which follow from the rows of the accelerations.
    fn derivatives(
        &mut self,
        product: Product,
        all: impl FnOnce(&mut Model, &Equations, &[ExprId]) -> Vec<ExprId>,
    ) -> Option<Program> {
        let rows = self.equations.product(product, &self.model)?;
        let entries = all(&mut self.model, self.equations, &rows);
        Some(self.on_sides(&entries))
    }

    /// Derives the Taylor series of the motion, if they are requested.
    fn series(&mut self) -> Option<Result<MotionSeries, String>> {
        if !self.model.products.contains(&Product::Taylor) {
            return None;
        }
        let switches = &self.equations.switches[..self.variables.switches.len()];
        let programs = series_programs(&mut self.model, self.equations, switches);
        let Layout { positions, velocities, .. } = self.layout();
        let settings = (positions + velocities, self.model.constraints.is_empty(), self.model.accuracy);
        Some(programs.map(|programs| MotionSeries::new(programs, settings)))
    }

    fn regressor_parameters(&mut self) -> Program {
        let columns = self.equations.regressor.columns.iter().map(|column| column.parameter);
        self.as_declared(&columns.collect::<Vec<_>>())
    }

    fn outputs(&mut self) -> Vec<(String, Program)> {
        let outputs = self.model.outputs.clone().into_iter();
        outputs.map(|output| (output.name, self.on_sides(&output.components))).collect()
    }

    fn drawing(&mut self) -> Option<DrawnScene> {
        let is_in_space = self.declaration.is_in_space;
        let placed = |height: &SampledHeight| PlacedHeight {
            variables: height.variables.clone(),
            program: self.as_declared(&[height.value]),
        };
        let (items, roots) = placed_items(&self.model.scene, is_in_space, placed);
        (!items.is_empty()).then(|| DrawnScene { is_in_space, items, program: self.on_sides(&roots) })
    }

    /// Lowers the terms of contacts and friction, if there are any.
    fn touching(&mut self) -> Option<TouchingPrograms> {
        if self.model.reactions.is_empty() {
            return None;
        }
        let terms = ReactionTerms::new(&mut self.model, self.equations);
        let (slopes, matrices) = (terms.slopes.iter().map(|(pair, _)| *pair).collect(), terms.inertia.len());
        Some(TouchingPrograms { terms: self.on_sides(&terms.roots()), slopes, matrices })
    }

    /// Returns the algebraic unknowns in the rates, with their names.
    fn unknowns(&self, position_rates: &[ExprId]) -> Vec<(ExprId, String)> {
        let rates = [&self.equations.accelerations[..], position_rates].concat();
        let graph = &self.model.graph;
        let unknown = |id: ExprId| match graph.node(id) {
            Node::Opaque(function, _) if function.is_solution() => {
                Some((id, self.declaration.written(&function.function().name).to_owned()))
            }
            _ => None,
        };
        graph.reachable(&rates).into_iter().filter_map(unknown).collect()
    }

    fn solutions(&mut self) -> Vec<NewtonProgram> {
        let unknowns = self.model.graph.unknowns().to_vec();
        let accuracy = self.model.accuracy;
        unknowns.iter().map(|unknown| NewtonProgram::new(&mut self.model.graph, unknown, accuracy)).collect()
    }
}

fn lowered(graph: &Graph, roots: &[ExprId], labels: &Labels, accuracy: Accuracy) -> Program {
    optimise(&lower(graph, roots, labels), accuracy)
}

/// Returns the accelerations and the multipliers, each with the values after them.
fn motion(equations: &Equations, growth: &[ExprId]) -> (Vec<ExprId>, Vec<ExprId>) {
    let Equations { accelerations, constraints, reactions, .. } = equations;
    if !reactions.rows.is_empty() {
        return (accelerations.clone(), reactions.multipliers.clone());
    }
    let accelerations = [&accelerations[..], &beside(equations), growth].concat();
    (accelerations, [&constraints.multipliers[..], growth].concat())
}

/// Returns values whose magnitude is the growth of rounding errors that triggers the second method.
fn growth(equations: &Equations) -> Vec<ExprId> {
    equations.constraints.condition.into_iter().chain(equations.pivot_growth).collect()
}

/// Returns values that emitted code computes with the accelerations, since its second method starts
/// from them.
fn beside(equations: &Equations) -> Vec<ExprId> {
    let is_indefinite = equations.pivot_growth.is_some();
    let values = || [&equations.forcing[..], &equations.mass_matrix.concat()].concat();
    is_indefinite.then(values).unwrap_or_default()
}

/// Returns M and A in rows, f and b; nothing for large systems.
fn undivided(equations: &Equations) -> Vec<ExprId> {
    let Equations { mass_matrix, forcing, constraints, .. } = equations;
    if forcing.len() > LARGEST_SECOND_WAY {
        return Vec::new();
    }
    let matrices = [mass_matrix.concat(), constraints.jacobian.concat()].concat();
    [&matrices[..], forcing, &constraints.drifts].concat()
}
