//! All of a derived system as straight-line programs and plain data: what is interpreted, and what
//! writers of other languages start from.
//!
//! Programs take their numbers from the time t, the state y = `[q…, v…]` and the parameters p.
//! These begin with those of the declaration; a [`Layout`] gives the place of each. Roots and names
//! of the programs are those of emitted code, so that results have the same bits.

use super::drawn::{DrawnScene, placed_items};
use super::phases::DerivedPart;
use super::system::Derived;
use crate::derive::Equations;
use crate::emit::{
    NamedRoots, Variables, by_fields, by_state, by_state_and_inputs, on_sides, system_matrix, variables,
};
use crate::model::{Action, Assignment, Bound, Clock, Event, Model, Product, Speed};
use lagrange_algebra::calculus::gradient;
use lagrange_algebra::program::{Labels, NewtonProgram, Op, Program, lower, optimise};
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::expr::{ExprId, Graph, Node};
use lagrange_expr::opaque::Opaque;
use lagrange_expr::symbol::Role;
use lagrange_language::syntax::ast::Declaration;

/// Systems with more velocities have no second way: writing down their matrices may cost more than
/// all else.
const LARGEST_SECOND_WAY: usize = 40;

/// A derived system as programs, with names, units, defaults and events as data.
#[derive(Clone, Debug)]
pub struct Programs {
    /// Name of the struct.
    pub name: String,
    /// The number by which emitted types distinguish declarations.
    pub fingerprint: u64,
    /// Names and units.
    pub variables: Variables,
    /// Places of the numbers that programs take.
    pub layout: Layout,
    /// Defaults of parameters and inputs, NaN where there is none.
    pub defaults: Vec<f64>,
    /// Bounds of parameters.
    pub ranges: Vec<Range>,
    /// The declared state at the start, if any of it is declared.
    pub start: Option<Program>,
    /// Rates of the positions.
    pub position_rates: Program,
    /// Accelerations, perhaps more values that emitted code computes with them, and at the end the
    /// growth of rounding errors in their computation.
    pub accelerations: Program,
    /// Multipliers, followed by the same growth.
    pub multipliers: Program,
    /// Number of these values of growth.
    pub growths: usize,
    /// True if some constraints always follow from others, which leaves multipliers to the second
    /// way.
    pub is_redundant: bool,
    /// M and A in rows, f and b, from which the second way starts; nothing for large systems.
    pub undivided: Program,
    /// True for each constraint that contains positions.
    pub are_holonomic: Vec<bool>,
    /// Residuals of the constraints on positions; zero for others.
    pub position_residuals: Program,
    /// The change of velocities, or of positions, that removes residuals, which take the places of
    /// multipliers, followed by the same growth.
    pub correction: Program,
    /// M a of the accelerations a.
    pub mass_times: Program,
    /// The functions whose signs are the sides of the switches.
    pub switches: Program,
    /// Times at which switches are passed, as far as they are known.
    pub switch_times: Vec<Option<Program>>,
    /// Functions of the events; one for those of contacts.
    pub event_functions: Program,
    /// Actions at the events.
    pub reactions: Vec<Reaction>,
    /// Clocks.
    pub clocks: Vec<TickingClock>,
    /// Products with their programs; Jacobians have the rows of the accelerations only.
    pub products: Vec<(Product, Program)>,
    /// ∂ẏ/∂y in rows, if it is requested.
    pub jacobian: Option<Program>,
    /// Derivatives of the rates by parameters, then by inputs, in rows, if they are requested.
    pub parameter_jacobian: Option<Program>,
    /// Derivatives of the rates, then of the outputs, by the state, then by the inputs, in rows, if
    /// the system matrix is requested.
    pub linearised: Option<Program>,
    /// The system matrix [A B; C D; G 0] in rows, if it is requested. Columns are those of
    /// displacements, first-order states, velocities and inputs.
    pub system_matrix: Option<Program>,
    /// Values of the parameters that the columns of the regressor multiply.
    pub regressor_parameters: Program,
    /// Outputs.
    pub outputs: Vec<(String, Program)>,
    /// The scene, if a drawing is requested.
    pub drawing: Option<DrawnScene>,
    /// Algebraic unknowns that rates are made of.
    pub unknowns: Vec<String>,
    /// Their values.
    pub unknown_values: Program,
    /// Functions that solve equations.
    pub solutions: Vec<NewtonProgram>,
}

/// The action at an event.
#[derive(Clone, Debug)]
pub enum Reaction {
    /// The event is recorded.
    Record,
    /// The motion ends.
    Stop,
    /// The motion continues from the state that the program computes.
    Replace(Program),
    /// A contact reacts.
    Impact,
}

/// A clock: its period, and the state after its tick.
#[derive(Clone, Debug)]
pub struct TickingClock {
    /// The period, of parameters alone.
    pub period: Program,
    /// The state after a tick.
    pub after: Program,
}

/// Bounds of a parameter, with their inclusion.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Range {
    /// Index of the parameter.
    pub parameter: usize,
    /// The lower and the upper bound, and true for each that is allowed itself.
    pub bounds: [Option<(f64, bool)>; 2],
}

/// Places of the numbers that programs take: numbers of each kind, in their order in p.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Layout {
    /// Positions, which begin the state.
    pub positions: usize,
    /// Velocities, which end it.
    pub velocities: usize,
    /// Parameters, which begin p.
    pub parameters: usize,
    /// Inputs, behind the parameters.
    pub inputs: usize,
    /// Sides of the switches, behind the inputs.
    pub sides: usize,
    /// Multipliers, behind the sides. As many accelerations follow as there are velocities.
    pub multipliers: usize,
}

/// Place of a number.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Place {
    /// The time.
    Time,
    /// An entry of the state.
    State(usize),
    /// An entry of p.
    Parameter(usize),
}

impl Layout {
    /// Returns the place of the numbers with this role; `None` for roles that no program here has.
    pub fn place(&self, role: Role) -> Option<Place> {
        let [inputs, sides] = [self.parameters, self.parameters + self.inputs];
        let multipliers = sides + self.sides;
        Some(match role {
            Role::Time => Place::Time,
            Role::Coordinate(i) | Role::State(i) | Role::Discrete(i) => Place::State(i as usize),
            Role::Velocity(i) => Place::State(self.positions + i as usize),
            Role::Parameter(i) => Place::Parameter(i as usize),
            Role::Input(i) => Place::Parameter(inputs + i as usize),
            Role::Side(i) => Place::Parameter(sides + i as usize),
            Role::Multiplier(i) => Place::Parameter(multipliers + i as usize),
            Role::Acceleration(i) => Place::Parameter(multipliers + self.multipliers + i as usize),
            Role::Reaction(_) | Role::Operand(_) | Role::Placeholder(_) => return None,
        })
    }

    /// Returns the number of parameters and inputs.
    pub fn fields(&self) -> usize {
        self.parameters + self.inputs
    }

    /// Returns the length of p.
    pub fn length(&self) -> usize {
        self.fields() + self.sides + self.multipliers + self.velocities
    }
}

impl Programs {
    /// Lowers everything that a derived system holds.
    pub fn new(derived: &Derived) -> Programs {
        Lowering::new(&derived.declaration, &derived.model, &derived.equations).programs()
    }

    /// Lowers everything that a reduced type holds.
    pub fn of_part(part: &DerivedPart) -> Programs {
        Lowering::new(&part.declaration, &part.reduced.model, &part.equations).programs()
    }

    /// Returns all programs but those of solutions.
    pub fn all(&self) -> impl Iterator<Item = &Program> {
        let of_motion = [&self.position_rates, &self.accelerations, &self.multipliers, &self.undivided];
        let of_constraints =
            [&self.position_residuals, &self.correction, &self.mass_times, &self.regressor_parameters];
        let of_events = [&self.switches, &self.event_functions, &self.unknown_values];
        let replaced = self.reactions.iter().filter_map(|reaction| match reaction {
            Reaction::Replace(program) => Some(program),
            _ => None,
        });
        let of_clocks = self.clocks.iter().flat_map(|clock| [&clock.period, &clock.after]);
        let values = self.products.iter().map(|(_, program)| program);
        let outputs = self.outputs.iter().map(|(_, program)| program);
        let others = self
            .start
            .iter()
            .chain(&self.jacobian)
            .chain(&self.parameter_jacobian)
            .chain(&self.linearised)
            .chain(&self.system_matrix)
            .chain(self.drawing.iter().map(|drawing| &drawing.program))
            .chain(self.switch_times.iter().flatten());
        let fixed = of_motion.into_iter().chain(of_constraints).chain(of_events);
        fixed.chain(replaced).chain(of_clocks).chain(values).chain(outputs).chain(others)
    }

    /// Returns the functions of the user's crate that programs call, each once.
    pub fn functions(&self) -> Vec<Opaque> {
        let mut called = Vec::new();
        let of_solutions = self.solutions.iter().flat_map(|solution| [&solution.start, &solution.equation]);
        for (_, op) in self.all().chain(of_solutions).flat_map(Program::values) {
            if let Op::Opaque(function, _) = op
                && function.table().is_none()
                && !function.is_solution()
                && !called.contains(function)
            {
                called.push(function.clone());
            }
        }
        called
    }

    /// Returns the program of a product, if it was derived.
    pub fn product(&self, product: Product) -> Option<&Program> {
        self.products.iter().find(|(known, _)| *known == product).map(|(_, program)| program)
    }
}

/// True if a program takes numbers of a role that has this property.
pub(super) fn takes(program: &Program, has: impl Fn(Role) -> bool) -> bool {
    program.values().any(|(_, op)| matches!(op, Op::Input(role) if has(*role)))
}

/// The lowering of a system.
struct Lowering<'a> {
    declaration: &'a Declaration,
    model: Model,
    equations: &'a Equations,
    variables: Variables,
    /// Names of parts of expressions. A named value is kept apart, so that only with the same names
    /// the results are those of emitted code.
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
        let reactions = self.model.events.clone().iter().map(|event| self.reaction(event)).collect();
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
            start: (!self.model.start.is_empty()).then(|| self.as_declared(&self.model.start)),
            position_rates: self.on_sides(&rates),
            accelerations: self
                .on_sides(&[&equations.accelerations[..], &beside(equations), &growth].concat()),
            multipliers: self.on_sides(&with_growth(&equations.constraints.multipliers)),
            growths: growth.len(),
            is_redundant: equations.constraints.is_redundant,
            undivided: self.on_sides(&undivided(equations)),
            are_holonomic: self.model.constraints.iter().map(|constraint| constraint.is_holonomic).collect(),
            position_residuals: self.position_residuals(),
            correction: self.on_sides(&with_growth(&equations.constraints.correction)),
            mass_times: self.mass_times(),
            switch_times: times.map(|time| time.map(|time| self.as_declared(&[time]))).collect(),
            switches: self.as_declared(&switches),
            event_functions: self.event_functions(),
            reactions,
            clocks,
            products: self.products(),
            jacobian: self.derivatives(Product::Jacobian, |model, _, rows| by_state(model, rows)),
            parameter_jacobian: self
                .derivatives(Product::ParameterJacobian, |model, _, rows| by_fields(model, rows)),
            linearised: self.derivatives(Product::SystemMatrix, by_state_and_inputs),
            system_matrix: self.derivatives(Product::SystemMatrix, system_matrix),
            regressor_parameters: self.regressor_parameters(),
            outputs: self.outputs(),
            drawing: self.drawing(),
            unknowns: unknowns.iter().map(|(_, name)| name.clone()).collect(),
            unknown_values: self.on_sides(&unknowns.iter().map(|(root, _)| *root).collect::<Vec<_>>()),
            solutions: self.solutions(),
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
        }
    }

    /// Lowers expressions on the sides of the switches.
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

    /// Computes expressions of numbers alone.
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

    fn position_residuals(&mut self) -> Program {
        let zero = self.model.graph.number(0);
        let constraints = self.model.constraints.iter();
        let roots = constraints.map(|c| if c.is_holonomic { c.value } else { zero }).collect::<Vec<_>>();
        self.on_sides(&roots)
    }

    /// Lowers M a, the gradient of a · ∂L/∂v by the velocities.
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

    fn event_functions(&mut self) -> Program {
        let one = self.model.graph.number(1);
        let value = |event: &Event| if let Action::Impact(_) = event.action { one } else { event.value };
        let values = self.model.events.iter().map(value).collect::<Vec<_>>();
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

    /// The state after assignments.
    fn assigned(&mut self, assignments: &[Assignment]) -> Program {
        self.on_sides(&self.model.state_after(assignments))
    }

    fn products(&mut self) -> Vec<(Product, Program)> {
        let is_constrained = !self.model.constraints.is_empty();
        let wanted = Product::ALL.into_iter().filter(|product| {
            // All rows of the system matrix have programs of their own.
            *product != Product::SystemMatrix && (is_constrained || !product.is_of_constraints())
        });
        let roots =
            wanted.filter_map(|product| Some((product, self.equations.product(product, &self.model)?)));
        let roots = roots.collect::<Vec<_>>();
        roots.into_iter().map(|(product, roots)| (product, self.on_sides(&roots))).collect()
    }

    /// All rows of a derivative, which follow from those of the accelerations.
    fn derivatives(
        &mut self,
        product: Product,
        all: impl FnOnce(&mut Model, &Equations, &[ExprId]) -> Vec<ExprId>,
    ) -> Option<Program> {
        let rows = self.equations.product(product, &self.model)?;
        let entries = all(&mut self.model, self.equations, &rows);
        Some(self.on_sides(&entries))
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
        let (items, roots) = placed_items(&self.model.scene, is_in_space);
        (!items.is_empty()).then(|| DrawnScene { is_in_space, items, program: self.on_sides(&roots) })
    }

    /// The algebraic unknowns that rates are made of, with their names.
    fn unknowns(&self, position_rates: &[ExprId]) -> Vec<(ExprId, String)> {
        let rates = [&self.equations.accelerations[..], position_rates].concat();
        let graph = &self.model.graph;
        let unknown = |id: ExprId| match graph.node(id) {
            Node::Opaque(function, _) if function.is_solution() => {
                Some((id, function.function().name.clone()))
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

/// Values whose size is the growth of rounding errors, beyond which the second way is taken.
fn growth(equations: &Equations) -> Vec<ExprId> {
    equations.constraints.condition.into_iter().chain(equations.pivot_growth).collect()
}

/// Values that emitted code computes with the accelerations, since its second way starts from them.
fn beside(equations: &Equations) -> Vec<ExprId> {
    let is_indefinite = equations.pivot_growth.is_some();
    let values = || [&equations.forcing[..], &equations.mass_matrix.concat()].concat();
    is_indefinite.then(values).unwrap_or_default()
}

/// M and A in rows, f and b; nothing for large systems.
fn undivided(equations: &Equations) -> Vec<ExprId> {
    let Equations { mass_matrix, forcing, constraints, .. } = equations;
    if forcing.len() > LARGEST_SECOND_WAY {
        return Vec::new();
    }
    let matrices = [mass_matrix.concat(), constraints.jacobian.concat()].concat();
    [&matrices[..], forcing, &constraints.drifts].concat()
}
