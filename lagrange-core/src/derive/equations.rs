//! What is derived from a model.

use super::constraints::{ConstraintEquations, join_multipliers};
use super::cost::cost;
use super::elimination::contracted::contracted;
use super::elimination::order::eliminate_dense;
use super::elimination::record::Elimination;
use super::elimination::solution::{Solution, push_down, solve_dense};
use super::indefinite::pivot_growth;
use super::inverse_dynamics::residual;
use super::jacobian::{Derivatives, Forms};
use super::least_constraint::{SplitLagrangian, Terms, least_constraint_form};
use super::quadratic_form::QuadraticForm;
use super::responses::{ReactionEquations, reaction_forces};
use super::strategies::{Candidates, SingularMassMatrix, Strategy, StrategyChoice};
use super::structure::Structure;
use super::switches::Switch;
use crate::calculus::{AccelerationTerms, adjoint, gradient, homogeneity};
use crate::collections::HashMap;
use crate::expr::{Dependencies, ExprId, Graph, Node};
use crate::model::{Constraint, Energies, Model, Product};
use crate::number::Number;
use crate::simplify::{self, Angles, vanishing};
use crate::syntax::ast::Accuracy;

/// Number of unknowns up to which coefficients are multiplied out on trial. What a coordinate does to itself cancels, but the number of
/// coefficients grows as its square, and with it what they share when they stay closed.
const MOST_MULTIPLIED_OUT: usize = 4;
/// Number of expressions up to which they are: the trial multiplies out everything and factorises two matrices.
const LARGEST_MULTIPLIED_OUT: usize = 300;
/// Monomials up to which a coefficient is multiplied out; a longer one hardly costs less than the closed one.
const MULTIPLYING_BUDGET: usize = 60;

/// A matrix in rows.
type Rows = Vec<Vec<ExprId>>;

/// The equations of motion and what else a model was asked for. Products that are not wanted are not
/// among `products`; the two sides of M q̈ = f come with the accelerations.
#[derive(Clone, Debug)]
pub struct Equations {
    /// q̈ as functions of t, q, v.
    pub accelerations: Vec<ExprId>,
    /// What belongs to the constraints; without any it is empty.
    pub constraints: ConstraintEquations,
    /// What belongs to contacts and friction, whose forces the accelerations above leave out.
    pub reactions: ReactionEquations,
    /// By how much rounding grows through pivots of the mass matrix that may vanish although it is regular, squared; `None` where none
    /// may, as of kinetic energies declared as such, and of systems with constraints, contacts or friction, which say so elsewhere.
    pub pivot_growth: Option<ExprId>,
    /// How they are computed.
    pub strategy: Strategy,
    /// Whether the kinetic energy can be kept a sum of squares: whatever is quadratic in the velocities is a sum of squares of rates.
    pub is_sum_of_squares: bool,
    /// The counted cost of each strategy, as far as it was tried, in the order of [`Strategy::ALL`].
    pub costs: [Option<f64>; 3],
    /// M, in rows.
    pub mass_matrix: Rows,
    /// f in M q̈ = f
    pub forcing: Vec<ExprId>,
    /// ∂L/∂q + Q, by which the momenta change without constraints
    pub free_momentum_rates: Option<Vec<ExprId>>,
    /// What was asked for beside the two sides of M q̈ = f and what the model itself holds, matrices row by row.
    products: Vec<(Product, Vec<ExprId>)>,
    /// What was found out about the system.
    pub structure: Structure,
    /// Surfaces on which what determines the motion is not smooth.
    pub switches: Vec<Switch>,
    /// Names for intermediate results, in the order of preference.
    pub labels: Vec<(ExprId, String)>,
}

impl Equations {
    /// Derives the equations of a model.
    pub fn derive(model: &mut Model, choice: StrategyChoice) -> Result<Equations, SingularMassMatrix> {
        let split = SplitLagrangian::new(model);
        let velocities = model.velocities();
        let forms = forms(model, &split);
        let mass_matrix = forms.pushed.matrix(&mut model.graph, &Number::ONE, &velocities, &velocities);
        let forcing = forcing(&mut model.graph, &forms.pushed, &velocities);
        let (form, pushed) = (forms.form.clone(), forms.pushed.clone());
        let (mut solution, strategy, costs) =
            Candidates { model, split: &split, form, pushed }.solve(choice)?;
        let is_free = model.constraints.is_empty() && model.reactions.is_empty();
        let may_be_indefinite = is_free && matches!(model.energies, Energies::Lagrangian);
        let pivot_growth =
            may_be_indefinite.then(|| pivot_growth(&mut model.graph, &mass_matrix, &solution)).flatten();
        let multipliers = solution.values.split_off(velocities.len());
        let (reactions, constraints) = match kept_elimination(model, &forms, &mut solution)? {
            Some(steps) => {
                let reactions = ReactionEquations::new(model, &steps, &multipliers);
                let found = (multipliers, solution.condition);
                (reactions, ConstraintEquations::new(model, &forms.pushed, &steps, found))
            }
            None => Default::default(),
        };
        let structure = Structure::find(model, &mass_matrix);
        let labels = labels(model, &mass_matrix, &solution);
        let mut products = jacobians(model, &split, forms, (&solution.values, strategy));
        let rates = model.products.contains(&Product::MomentumRates).then(|| free_momentum_rates(model));
        let rates = rates.unwrap_or_default();
        let touching = reaction_forces(model, &reactions);
        let mut without_constraints = None;
        for product in model.products.clone() {
            let found = match product {
                Product::Bias => residual(model, &split, AccelerationTerms::Dropped, Terms::Inertial),
                Product::Momenta => gradient(&mut model.graph, model.lagrangian, &velocities),
                Product::MomentumRates => {
                    let sums = [&constraints.forces[..], &[]]
                        .map(|forces| sums(model, &rates, &[forces, &touching]));
                    let [all, free] = sums;
                    without_constraints = Some(free);
                    all
                }
                Product::Energy => vec![energy_function(model)],
                Product::InverseDynamics => residual(model, &split, AccelerationTerms::Kept, Terms::All),
                _ => continue,
            };
            products.push((product, found));
        }
        let mut equations = Equations {
            accelerations: solution.values,
            pivot_growth,
            strategy,
            is_sum_of_squares: !split.has_other_inertia,
            costs,
            mass_matrix,
            forcing,
            free_momentum_rates: without_constraints,
            constraints,
            reactions,
            products,
            structure,
            switches: Vec::new(),
            labels,
        };
        if model.accuracy == Accuracy::Strict {
            equations.contract(model);
        }
        equations.switches = Switch::find(model, &equations.of_motion(model), &solution.guards);
        Ok(equations)
    }

    /// Components of a product of a model, matrices row by row and Jacobians without the rows of the velocities; `None` if it has no
    /// components or was not asked for.
    pub fn product(&self, product: Product, model: &Model) -> Option<Vec<ExprId>> {
        let of_constraints =
            |part: fn(&Constraint) -> ExprId| Some(model.constraints.iter().map(part).collect());
        let of_energies = |part: fn(ExprId, ExprId) -> ExprId| match model.energies {
            Energies::Separate { kinetic, potential } => Some(vec![part(kinetic, potential)]),
            Energies::Lagrangian => None,
        };
        match product {
            Product::MassMatrix => Some(self.mass_matrix.concat()),
            Product::Forcing => Some(self.forcing.clone()),
            Product::KineticEnergy => of_energies(|kinetic, _| kinetic),
            Product::PotentialEnergy => of_energies(|_, potential| potential),
            Product::Constraints => of_constraints(|constraint| constraint.value),
            Product::ConstraintVelocity => of_constraints(|constraint| constraint.velocity),
            Product::ConstraintJacobian => Some(self.constraints.jacobian.concat()),
            Product::ConstraintForces => Some(self.constraints.forces.clone()),
            _ => self.derived(product).map(<[ExprId]>::to_vec),
        }
    }

    fn derived(&self, product: Product) -> Option<&[ExprId]> {
        self.products.iter().find(|(known, _)| *known == product).map(|(_, roots)| roots.as_slice())
    }

    /// Whether the mass matrix is constant during the motion and nothing but constraint forces depends on a velocity. It is
    /// judged by what the expressions mention: a velocity that cancels unseen still counts.
    pub fn is_separable(&self, model: &Model) -> bool {
        let depends = |&value: &ExprId| model.graph.dependencies(value).intersects(Dependencies::VELOCITY);
        let free = if model.constraints.is_empty() { &self.accelerations } else { &self.forcing };
        let is_held = model.constraints.iter().all(|constraint| constraint.is_holonomic);
        let is_free = model.reactions.is_empty();
        self.structure.mass.is_constant && is_held && is_free && !free.iter().any(depends)
    }

    /// What determines how a motion goes on, whichever method integrates it.
    fn of_motion(&self, model: &Model) -> Vec<ExprId> {
        let (constraints, reactions) = (&self.constraints, &self.reactions);
        let vectors = [&self.accelerations, &self.forcing, &constraints.multipliers, &constraints.drifts];
        let vectors =
            vectors.into_iter().chain([&constraints.correction, &reactions.multipliers, &reactions.drifts]);
        let matrices = [&self.mass_matrix, &constraints.jacobian, &reactions.responses, &reactions.rows];
        let limits = reactions.kinetic.iter().chain(&reactions.fixed);
        let rates = self
            .derived(Product::MomentumRates)
            .into_iter()
            .chain(self.free_momentum_rates.as_deref())
            .flatten();
        let mut roots =
            vectors.chain(matrices.into_iter().flatten()).flatten().chain(rates).copied().collect::<Vec<_>>();
        roots.extend(limits.flat_map(|limit| limit.slopes.iter().chain([&limit.free])));
        roots.extend(model.reactions.iter().map(|reaction| reaction.velocity));
        roots
    }

    /// Writes what is emitted beside the accelerations with as little to cancel as is found.
    fn contract(&mut self, model: &mut Model) {
        let mut places = self.mass_matrix.iter_mut().flatten().chain(&mut self.forcing).collect::<Vec<_>>();
        let is_derivative =
            |product: &Product| matches!(product, Product::Jacobian | Product::ParameterJacobian);
        let products = self.products.iter_mut().filter(|(product, _)| !is_derivative(product));
        places.extend(
            products.flat_map(|(_, roots)| roots).chain(self.free_momentum_rates.iter_mut().flatten()),
        );
        if let Energies::Separate { kinetic, potential } = &mut model.energies {
            places.extend([kinetic, potential]);
        }
        places.extend(model.outputs.iter_mut().flat_map(|output| &mut output.components));
        let exprs = places.iter().map(|place| **place).collect::<Vec<_>>();
        let contracted = simplify::contract_all(&mut model.graph, &mut Angles::default(), &exprs);
        places.into_iter().zip(contracted).for_each(|(place, expr)| *place = expr);
    }
}

/// The quadratic form with its multipliers, and what it becomes over velocities alone, simplified as the level of accuracy asks.
fn forms(model: &mut Model, split: &SplitLagrangian) -> Forms {
    let (velocities, unknowns) = (model.velocities(), model.unknowns());
    let mut form = least_constraint_form(model, split, AccelerationTerms::Dropped, Terms::All);
    join_multipliers(model, &mut form);
    let mut pushed = push_down(&mut model.graph, form.clone(), &velocities);
    separate_uncoupled(&mut model.graph, &mut pushed, &velocities);
    let pushed = match model.accuracy {
        Accuracy::Strict => contracted(&mut model.graph, pushed, &unknowns),
        _ => cheaper_coefficients(&mut model.graph, pushed, &unknowns),
    };
    Forms { form, pushed }
}

/// The elimination that constraints, contacts and friction have other right-hand sides for: that of the strategy taken or, if it has
/// none, that of the mass matrix.
fn kept_elimination(
    model: &mut Model,
    forms: &Forms,
    solution: &mut Solution,
) -> Result<Option<Elimination>, SingularMassMatrix> {
    if model.constraints.is_empty() && model.reactions.is_empty() {
        return Ok(None);
    }
    let unknowns = model.unknowns();
    let own = solution.elimination.take();
    let steps = own.or_else(|| eliminate_dense(&mut model.graph, forms.pushed.clone(), &unknowns));
    steps.map(Some).ok_or(SingularMassMatrix)
}

/// The derivatives of accelerations that are wanted, by the state and by parameters and inputs.
fn jacobians(
    model: &mut Model,
    split: &SplitLagrangian,
    forms: Forms,
    solution: (&[ExprId], Strategy),
) -> Vec<(Product, Vec<ExprId>)> {
    let [by_state, by_parameters] =
        [Product::Jacobian, Product::ParameterJacobian].map(|product| model.products.contains(&product));
    if !by_state && !by_parameters {
        return Vec::new();
    }
    let derivatives = Derivatives::new(model, split, forms, solution);
    let state = [model.positions(), model.velocities()].concat();
    let constants = model.parameters.iter().chain(&model.inputs).map(|parameter| parameter.symbol);
    let constants = constants.collect::<Vec<_>>();
    let wanted =
        [(by_state, Product::Jacobian, state), (by_parameters, Product::ParameterJacobian, constants)];
    let wanted = wanted.into_iter().filter(|(is_wanted, ..)| *is_wanted);
    wanted.map(|(_, product, arguments)| (product, derivatives.by(model, &arguments).concat())).collect()
}

/// Removes couplings that vanish without showing it, as between polar coordinates that were written down by
/// way of Cartesian ones: r sin θ cos θ − r cos θ sin θ.
fn separate_uncoupled(graph: &mut Graph, pushed: &mut QuadraticForm, velocities: &[ExprId]) {
    let places = velocities.iter().enumerate().map(|(n, &v)| (v, n)).collect::<HashMap<_, _>>();
    let above_diagonal = |(n, &i): (usize, &ExprId)| {
        let near = pushed.near(i).filter_map(|j| Some((*places.get(&j)?, j)));
        let mut near = near.filter(|(place, _)| *place > n).collect::<Vec<_>>();
        near.sort_unstable();
        near.into_iter().map(move |(_, j)| (i, j))
    };
    let pairs = velocities.iter().enumerate().flat_map(above_diagonal).collect::<Vec<_>>();
    let couplings = pairs.iter().map(|&(i, j)| pushed.coefficient(graph, i, j)).collect::<Vec<_>>();
    let vanishing = vanishing(graph, &couplings);
    let uncoupled = pairs.iter().zip(vanishing).filter(|(_, vanishes)| *vanishes);
    uncoupled.for_each(|(&(i, j), _)| pushed.separate(i, j));
}

/// The form as it is or, for a small system, with its coefficients multiplied out, whichever leads to the
/// accelerations at less cost. What a coordinate does to itself often cancels when multiplied out, but sharing
/// beats that from a few coordinates on.
fn cheaper_coefficients(graph: &mut Graph, pushed: QuadraticForm, unknowns: &[ExprId]) -> QuadraticForm {
    let Some(expanded) = multiplied_out(graph, &pushed, unknowns) else { return pushed };
    let costs = [&pushed, &expanded].map(|form| {
        let solution = solve_dense(graph, form.clone(), unknowns)?;
        Some(cost(graph, &solution.values))
    });
    match costs {
        // Equal costs leave the form as it was declared.
        [Some(as_it_is), Some(multiplied_out)] if multiplied_out < as_it_is => expanded,
        _ => pushed,
    }
}

fn multiplied_out(graph: &mut Graph, pushed: &QuadraticForm, unknowns: &[ExprId]) -> Option<QuadraticForm> {
    if unknowns.len() > MOST_MULTIPLIED_OUT {
        return None;
    }
    let pairs = unknowns.iter().enumerate().flat_map(|(n, &i)| unknowns[n..].iter().map(move |&j| (i, j)));
    let pairs = pairs.collect::<Vec<_>>();
    let mut coefficients = pairs.iter().map(|&(i, j)| pushed.coefficient(graph, i, j)).collect::<Vec<_>>();
    coefficients.extend(unknowns.iter().map(|&id| pushed.linear(graph, id)).collect::<Vec<_>>());
    if graph.reachable(&coefficients).len() > LARGEST_MULTIPLIED_OUT {
        return None;
    }
    let expanded = simplify::multiply_out(graph, &coefficients, MULTIPLYING_BUDGET);
    let (quadratic, linear) = expanded.split_at(pairs.len());
    let mut form = QuadraticForm::default();
    pairs.iter().zip(quadratic).for_each(|(&(i, j), &value)| form.add_pair(graph, i, j, value));
    unknowns.iter().zip(linear).for_each(|(&id, &value)| form.add_linear(graph, id, value));
    Some(form)
}

fn forcing(graph: &mut Graph, pushed: &QuadraticForm, velocities: &[ExprId]) -> Vec<ExprId> {
    let opposite = |&v: &ExprId| {
        let value = pushed.linear(graph, v);
        graph.negate(value)
    };
    velocities.iter().map(opposite).collect()
}

/// ∂L/∂q + Q: Lagrange's equations say that ∂L/∂v changes at this rate, unless constraints act.
fn free_momentum_rates(model: &mut Model) -> Vec<ExprId> {
    let (positions, velocities) = (model.positions(), model.velocities());
    let graph = &mut model.graph;
    let loads = model.loads.iter().map(|load| (load.velocity, load.force)).collect::<Vec<_>>();
    let slopes = gradient(graph, model.lagrangian, &positions);
    let forces = adjoint(graph, &loads, &velocities);
    let resistances = gradient(graph, model.dissipation, &velocities);
    let rates = slopes.into_iter().zip(forces).zip(resistances).map(|((slope, force), resistance)| {
        let terms = [(slope, Number::ONE), (force, Number::ONE), (resistance, Number::MINUS_ONE)];
        graph.sum(Number::ZERO, terms)
    });
    rates.collect()
}

/// Each of `values` and what is added to it, if anything is.
fn sums(model: &mut Model, values: &[ExprId], added: &[&[ExprId]]) -> Vec<ExprId> {
    let sum = |(i, &value): (usize, &ExprId)| {
        let terms = added.iter().filter_map(|list| list.get(i).copied()).chain([value]).collect::<Vec<_>>();
        model.graph.total(terms)
    };
    values.iter().enumerate().map(sum).collect()
}

/// The energy function h = v·∂L/∂v − L (Goldstein, Poole and Safko, *Classical Mechanics*, 3rd ed., §2.7).
/// A term of L that is homogeneous of degree k in the velocities contributes k − 1 times itself (Euler).
fn energy_function(model: &mut Model) -> ExprId {
    let graph = &mut model.graph;
    if let Energies::Separate { kinetic, potential } = model.energies
        && homogeneity(graph, kinetic) == Some(2)
    {
        return graph.add(kinetic, potential);
    }
    if let Some(terms) = weighted_by_degree(graph, model.lagrangian) {
        return graph.sum(Number::ZERO, terms);
    }
    let velocities = model.velocities();
    let graph = &mut model.graph;
    let momenta = gradient(graph, model.lagrangian, &velocities);
    let mut terms = vec![(model.lagrangian, Number::MINUS_ONE)];
    for (&velocity, momentum) in velocities.iter().zip(momenta) {
        terms.push((graph.multiply(velocity, momentum), Number::ONE));
    }
    graph.sum(Number::ZERO, terms)
}

/// Each term of a sum with its coefficient times its degree less one.
fn weighted_by_degree(graph: &mut Graph, sum: ExprId) -> Option<Vec<(ExprId, Number)>> {
    let Node::Sum { constant, terms } = graph.node(sum).clone() else { return None };
    let mut weighted = vec![(graph.number(constant), Number::MINUS_ONE)];
    for (term, coefficient) in &terms {
        let weight = Number::from(homogeneity(graph, *term)?.checked_sub(1)?);
        weighted.push((*term, coefficient * &weight));
    }
    Some(weighted)
}

/// Names of the user, then of matrix entries and of what the solution computes on the way.
fn labels(model: &Model, mass_matrix: &[Vec<ExprId>], solution: &Solution) -> Vec<(ExprId, String)> {
    let accelerations = solution.values.iter().zip(&model.coordinates);
    let accelerations = accelerations.map(|(id, coordinate)| (*id, format!("{}_ddot", coordinate.name)));
    let derived = matrix_labels(&model.graph, mass_matrix).into_iter().chain(accelerations);
    let derived = derived.chain(solution.labels.iter().cloned());
    // A symbol or the sine of an angle says itself what it is, unless the user has named it.
    let says_itself = |id| matches!(model.graph.node(id), Node::Symbol(_) | Node::Call(..));
    let labels = model.labels.iter().cloned().chain(derived.filter(|(id, _)| !says_itself(*id)));
    labels.filter(|(id, _)| model.graph.as_number(*id).is_none()).collect()
}

fn matrix_labels(graph: &Graph, matrix: &[Vec<ExprId>]) -> Vec<(ExprId, String)> {
    let mut labels = Vec::new();
    for (i, row) in matrix.iter().enumerate() {
        let entries = row.iter().enumerate().skip(i).filter(|(_, entry)| !graph.is_zero(**entry));
        labels.extend(entries.map(|(j, &entry)| (entry, format!("m_{i}_{j}"))));
    }
    labels
}
