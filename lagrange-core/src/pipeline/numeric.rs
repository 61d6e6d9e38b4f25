//! A derived system that can be evaluated without compiling it: for tests, tools and build scripts.

use super::callables::{Callables, calls};
use super::phases::DerivedPart;
use super::second_way::{is_regular, motion};
use super::system::Derived;
use crate::derive::Equations;
use crate::emit::{NamedRoots, on_sides};
use crate::model::{Model, Product};
use lagrange_algebra::program::{Labels, NewtonProgram, Program, lower, optimise, run_with};
use lagrange_expr::collections::HashMap;
use lagrange_expr::elementary::row;
use lagrange_expr::expr::evaluate;
use lagrange_expr::expr::{ExprId, Function};
use lagrange_expr::symbol::Role;

/// A system as interpreted programs, with values for its parameters and inputs.
///
/// Vectors are in the order of the positions or of the velocities; angles in radians.
#[derive(Clone, Debug)]
pub struct NumericSystem {
    /// Roles of parameters and inputs by name.
    names: HashMap<String, Role>,
    parameters: Vec<f64>,
    inputs: Vec<f64>,
    /// Numbers of positions and of velocities.
    size: [usize; 2],
    /// Rates of the positions.
    position_rates: Program,
    /// The functions whose signs are the sides of the switches.
    switches: Program,
    /// Accelerations, followed by the growth of rounding errors in their computation, as emitted
    /// code computes them.
    accelerations: Program,
    /// Multipliers, followed by the same.
    multipliers: Program,
    /// The number of these values of growth.
    growths: usize,
    /// True if some constraints always follow from others, which leaves multipliers to the second
    /// way.
    is_redundant: bool,
    /// Matrices and vectors that the second way starts from; nothing for large systems.
    undivided: Program,
    products: Vec<(Product, Program)>,
    outputs: Vec<(String, Program)>,
    callables: Callables,
}

/// Time, coordinates, velocities and, where they matter, accelerations.
#[derive(Clone, Copy, Debug)]
struct Instant<'a> {
    t: f64,
    q: &'a [f64],
    v: &'a [f64],
    a: &'a [f64],
    multipliers: &'a [f64],
}

/// Systems with more coordinates have no second way here: writing down their matrices may cost more
/// than all else.
const LARGEST_SECOND_WAY: usize = 40;

/// Values whose size is the growth of rounding errors, beyond which the second way is taken.
fn growth(equations: &Equations) -> Vec<ExprId> {
    equations.constraints.condition.into_iter().chain(equations.pivot_growth).collect()
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

fn are_finite(values: &[f64]) -> bool {
    values.iter().all(|value| value.is_finite())
}

impl NumericSystem {
    /// Lowers everything that `derived` holds. Parameters without a default are NaN until they are
    /// set.
    pub fn new(derived: &Derived) -> NumericSystem {
        NumericSystem::lowered(&derived.model, &derived.equations)
    }

    /// Lowers everything that a reduced type holds.
    pub fn of_part(part: &DerivedPart) -> NumericSystem {
        NumericSystem::lowered(&part.reduced.model, &part.equations)
    }

    fn lowered(model: &Model, equations: &Equations) -> NumericSystem {
        // A named value is kept apart, so that only with the same names the results are those of
        // emitted code.
        let mut labels = Labels::default();
        equations.labels.iter().for_each(|(expression, name)| labels.insert(*expression, name.as_str()));
        let mut graph = model.graph.clone();
        let switches = equations.switches.iter().map(|switch| switch.value).collect::<Vec<_>>();
        let switches = optimise(&lower(&graph, &switches, &labels), model.accuracy);
        let unknowns = graph.unknowns().to_vec();
        let solutions =
            unknowns.iter().map(|unknown| NewtonProgram::new(&mut graph, unknown, model.accuracy)).collect();
        let mut lowered = |roots: &[ExprId]| {
            let NamedRoots { roots, labels } = on_sides(&mut graph, &labels, &equations.switches, roots);
            optimise(&lower(&graph, &roots, &labels), model.accuracy)
        };
        let default = |default: Option<ExprId>| {
            default.map_or(f64::NAN, |value| evaluate(&model.graph, &[value], |_| f64::NAN)[0])
        };
        let parameters = model.parameters.iter().enumerate();
        let inputs = model.inputs.iter().enumerate();
        let named = parameters.map(|(i, p)| (p.name.clone(), Role::Parameter(i as u32)));
        let named = named.chain(inputs.map(|(i, p)| (p.name.clone(), Role::Input(i as u32))));
        let rates = model.position_rates();
        let growth = growth(equations);
        let with_growth = |roots: &[ExprId]| [roots, &growth].concat();
        let roots = [
            with_growth(&equations.accelerations),
            with_growth(&equations.constraints.multipliers),
            undivided(equations),
            rates,
        ];
        let [accelerations, multipliers, undivided, position_rates] = roots.map(|roots| lowered(&roots));
        let is_constrained = !model.constraints.is_empty();
        let products =
            Product::ALL.into_iter().filter(|product| is_constrained || !product.is_of_constraints());
        let products =
            products.filter_map(|product| Some((product, lowered(&equations.product(product, model)?))));
        let products = products.collect();
        NumericSystem {
            names: named.collect(),
            parameters: model.parameters.iter().map(|p| default(p.default)).collect(),
            inputs: model.inputs.iter().map(|p| default(p.default)).collect(),
            size: [model.coordinates.len(), model.speeds.len()],
            position_rates,
            switches,
            accelerations,
            multipliers,
            growths: growth.len(),
            is_redundant: equations.constraints.is_redundant,
            undivided,
            products,
            outputs: model.outputs.iter().map(|o| (o.name.clone(), lowered(&o.components))).collect(),
            callables: Callables::solving(solutions),
        }
    }

    /// Sets a parameter or an input; whether there is one of that name.
    pub fn set(&mut self, name: &str, value: f64) -> bool {
        match self.names.get(&name.to_owned()) {
            Some(Role::Parameter(i)) => self.parameters[*i as usize] = value,
            Some(Role::Input(i)) => self.inputs[*i as usize] = value,
            _ => return false,
        }
        true
    }

    /// Computes a function of the user's crate, or a derivative of one, by the name under which
    /// emitted code calls it; whether anything calls it. What is not computed is NaN.
    ///
    /// ```
    /// use lagrange_core::derive::StrategyChoice;
    /// use lagrange_core::pipeline::{NumericSystem, parse};
    ///
    /// let bead = "function height(x); coord x; kinetic = 1/2 * (dot(x)^2 + dot(height(x))^2); potential = 9.81 * height(x);";
    /// let mut bead = NumericSystem::new(&parse(bead)?.derive(StrategyChoice::Cheapest)?);
    /// bead.define("height", |x| x[0] * x[0] / 2.0);
    /// bead.define("height_derivative", |x| x[0]);
    /// bead.define("height_second_derivative", |_| 1.0);
    ///
    /// let (x, v) = (0.5, 0.3);
    /// let acceleration = bead.acceleration(0.0, &[x], &[v])[0];
    /// assert!((acceleration + x * (v * v + 9.81) / (1.0 + x * x)).abs() < 1e-15);
    /// # Ok::<(), lagrange_core::diagnostics::Report>(())
    /// ```
    pub fn define(&mut self, name: &str, value: impl Fn(&[f64]) -> f64 + Send + Sync + 'static) -> bool {
        let is_called = self.programs().any(|program| calls(program, name));
        self.callables.define(name, value);
        is_called
    }

    fn programs(&self) -> impl Iterator<Item = &Program> {
        let of_motion = [&self.position_rates, &self.switches, &self.accelerations, &self.multipliers];
        let products = self.products.iter().map(|(_, program)| program);
        let outputs = self.outputs.iter().map(|(_, program)| program);
        of_motion
            .into_iter()
            .chain([&self.undivided])
            .chain(products)
            .chain(outputs)
            .chain(self.callables.programs())
    }

    /// Returns the number of velocities.
    pub fn degrees_of_freedom(&self) -> usize {
        self.size[1]
    }

    fn run(&self, program: &Program, at: Instant<'_>) -> Vec<f64> {
        let sign = row(Function::Sign).value;
        let values = if self.switches.is_empty() { Vec::new() } else { self.run_on(&self.switches, at, &[]) };
        let sides = values.into_iter().map(|value| sign(&[value])).collect::<Vec<_>>();
        self.run_on(program, at, &sides)
    }

    fn run_on(&self, program: &Program, at: Instant<'_>, sides: &[f64]) -> Vec<f64> {
        let entry = |values: &[f64], i: u32| values.get(i as usize).copied().unwrap_or(f64::NAN);
        let value_of = |role| match role {
            Role::Parameter(i) => entry(&self.parameters, i),
            Role::Input(i) => entry(&self.inputs, i),
            Role::Time => at.t,
            Role::Coordinate(i) | Role::State(i) | Role::Discrete(i) => entry(at.q, i),
            Role::Velocity(i) => entry(at.v, i),
            Role::Acceleration(i) => entry(at.a, i),
            Role::Multiplier(i) => entry(at.multipliers, i),
            Role::Side(i) => entry(sides, i),
            Role::Reaction(_) | Role::Operand(_) | Role::Placeholder(_) => f64::NAN,
        };
        run_with(program, value_of, |function, arguments| self.callables.call(function, arguments))
    }

    /// Computes q̈.
    pub fn acceleration(&self, t: f64, q: &[f64], v: &[f64]) -> Vec<f64> {
        let at = Instant { t, q, v, a: &[], multipliers: &[] };
        match self.straight_way(at) {
            Some(found) => found,
            None => {
                let [accelerations, _] = self.second_way(at);
                accelerations
            }
        }
    }

    /// Computes the multipliers in the order of the constraints.
    pub fn multipliers(&self, t: f64, q: &[f64], v: &[f64]) -> Vec<f64> {
        let at = Instant { t, q, v, a: &[], multipliers: &[] };
        match self.trusted(&self.multipliers, at) {
            Some(found) if self.straight_way(at).is_some() => found,
            _ => {
                let [_, multipliers] = self.second_way(at);
                multipliers
            }
        }
    }

    /// The accelerations by elimination, if they are finite and their digits can be trusted.
    fn straight_way(&self, at: Instant<'_>) -> Option<Vec<f64>> {
        let found = self.trusted(&self.accelerations, at)?;
        (!self.is_redundant).then_some(found)
    }

    /// Results by elimination, if they are finite and their digits can be trusted.
    fn trusted(&self, program: &Program, at: Instant<'_>) -> Option<Vec<f64>> {
        let [found, growth] = self.eliminated(program, at);
        (are_finite(&found) && growth.into_iter().all(is_regular)).then_some(found)
    }

    /// Results by elimination, and the growth of their rounding errors.
    fn eliminated(&self, program: &Program, at: Instant<'_>) -> [Vec<f64>; 2] {
        let mut found = self.run(program, at);
        let growth = found.split_off(found.len() - self.growths);
        [found, growth]
    }

    /// Computes accelerations and multipliers from the undivided equations. Without such equations,
    /// they follow from elimination all the same. So they do where the equations have no solution
    /// although no pivot was to vanish: some accelerations may be finite.
    fn second_way(&self, at: Instant<'_>) -> [Vec<f64>; 2] {
        let (n, values) = (self.size[1], self.run(&self.undivided, at));
        let constraints = if values.is_empty() { 0 } else { values.len() / (n + 1) - n };
        let mut motion = if values.is_empty() { Vec::new() } else { motion(n, constraints, &values) };
        let is_guarded = constraints > 0 || self.growths > 0;
        if values.is_empty() || !is_guarded && !are_finite(&motion) {
            return [&self.accelerations, &self.multipliers].map(|program| {
                let [found, _] = self.eliminated(program, at);
                found
            });
        }
        let multipliers = motion.split_off(n);
        [motion, multipliers]
    }

    /// Computes ẏ = [q̇, v̇] for y = [q, v].
    pub fn rhs(&self, t: f64, y: &[f64]) -> Vec<f64> {
        let (q, v) = y.split_at(self.size[0].min(y.len()));
        let mut rate = self.run(&self.position_rates, Instant { t, q, v, a: &[], multipliers: &[] });
        rate.extend(self.acceleration(t, q, v));
        rate
    }

    /// Computes a product at a state: one value for an energy, one per coordinate for a vector,
    /// rows one after the other for a matrix. Jacobians have only the rows of the accelerations.
    /// `None` if it was not derived.
    pub fn product(&self, product: Product, t: f64, q: &[f64], v: &[f64]) -> Option<Vec<f64>> {
        let (_, program) = self.products.iter().find(|(known, _)| *known == product)?;
        let multipliers = self.multipliers(t, q, v);
        Some(self.run(program, Instant { t, q, v, a: &[], multipliers: &multipliers }))
    }

    /// Computes the generalised forces that must act in addition to the declared ones to produce
    /// accelerations. `None` if they were not derived.
    pub fn inverse_dynamics(&self, t: f64, q: &[f64], v: &[f64], a: &[f64]) -> Option<Vec<f64>> {
        let (_, program) = self.products.iter().find(|(known, _)| *known == Product::InverseDynamics)?;
        Some(self.run(program, Instant { t, q, v, a, multipliers: &[] }))
    }

    /// Computes the components of a declared output; `None` if there is none of that name.
    pub fn output(&self, name: &str, t: f64, q: &[f64], v: &[f64]) -> Option<Vec<f64>> {
        let (_, program) = self.outputs.iter().find(|(known, _)| known == name)?;
        let (a, multipliers) = (self.acceleration(t, q, v), self.multipliers(t, q, v));
        Some(self.run(program, Instant { t, q, v, a: &a, multipliers: &multipliers }))
    }
}
