//! The equations derived from a model.

use super::conserved::add_conserved;
use super::constraints::ConstraintEquations;
use super::diffusion::Diffusion;
use super::elimination::order::eliminate_dense;
use super::elimination::record::Elimination;
use super::elimination::solution::Solution;
use super::forms::{Forms, Rows};
use super::frame_jacobians::{frame_biases, frame_jacobians};
use super::grading::grade_parameters;
use super::indefinite::{largest, pivot_growth};
use super::inverse_dynamics::residual;
use super::least_constraint::{SplitLagrangian, Terms};
use super::power::add_power;
use super::products::{DerivedProducts, SolvedMotion};
use super::regressor::Regressor;
use super::responses::ReactionEquations;
use super::series::SeriesEquations;
use super::strategies::{Candidates, SingularMassMatrix, Strategy, StrategyChoice, has_large_mass_matrix};
use super::structure::{MassStructure, Structure};
use super::switches::Switch;
use crate::model::{Constraint, Energies, Model, Product};
use lagrange_algebra::calculus::AccelerationTerms;
use lagrange_algebra::simplify::{self, Angles};
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::expr::{Dependencies, ExprId, Graph, Node};

/// The equations of motion and the other requested products of a model. `products` only contains
/// requested products; both sides of M q̈ = f accompany the accelerations.
#[derive(Clone, Debug)]
pub struct Equations {
    /// q̈ as functions of t, q, v.
    pub accelerations: Vec<ExprId>,
    /// Equations of the constraints; empty without constraints.
    pub constraints: ConstraintEquations,
    /// Equations of contacts and friction, whose forces the accelerations above exclude.
    pub reactions: ReactionEquations,
    /// Squared growth of rounding errors through pivots of a regular mass matrix that may vanish.
    /// `None` if no pivot may vanish, as for declared kinetic energies, and for systems with
    /// constraints, contacts or friction, which report it elsewhere.
    pub pivot_growth: Option<ExprId>,
    /// Strategy for the accelerations.
    pub strategy: Strategy,
    /// True if the kinetic energy can be kept as a sum of squares: all quadratic terms in the
    /// velocities are sums of squares of rates.
    pub is_sum_of_squares: bool,
    /// Counted cost of each strategy that was tried, in the order of [`Strategy::ALL`].
    pub costs: [Option<f64>; 3],
    /// M in rows; empty if it is large and was not requested.
    pub mass_matrix: Rows,
    /// f in M q̈ = f
    pub forcing: Vec<ExprId>,
    /// ∂L/∂q + Q, by which the momenta change without constraints
    pub free_momentum_rates: Option<Vec<ExprId>>,
    /// Equations of motion for the expansion in Taylor series, if requested.
    pub series: Option<SeriesEquations>,
    /// Requested products other than both sides of M q̈ = f and those contained in the model;
    /// matrices row by row.
    products: Vec<(Product, Vec<ExprId>)>,
    /// Jacobians of frames in the order of `Scene::twists`, each in six rows.
    pub frame_jacobians: Vec<Vec<ExprId>>,
    /// Accelerations of these frames at constant velocities: angular, then of the origin.
    pub frame_biases: Vec<[ExprId; 6]>,
    /// Columns of the regressor of the inverse dynamics; none unless requested.
    pub regressor: Regressor,
    /// Diffusions of the noises, which everything else excludes.
    pub diffusion: Diffusion,
    /// Structure found in the system.
    pub structure: Structure,
    /// Surfaces on which the equations of motion are not smooth.
    pub switches: Vec<Switch>,
    /// Names for intermediate results, in the order of preference.
    pub labels: Vec<(ExprId, String)>,
}

impl Equations {
    /// Derives the equations of a model.
    pub fn derive(model: &mut Model, choice: StrategyChoice) -> Result<Equations, SingularMassMatrix> {
        let split = SplitLagrangian::new(model);
        let velocities = model.velocities();
        let mut forms = Forms::new(model, &split);
        if wants_mass_matrix(model, choice) || !has_large_mass_matrix(model) {
            forms.push_down(model);
        }
        let (mut solution, strategy, costs) =
            Candidates { model, split: &split, forms: &mut forms }.solve(choice)?;
        let is_balanced = strategy == Strategy::SumOfSquares || model.accuracy == Accuracy::Strict;
        if is_balanced || model.products.iter().any(|product| product.is_derivative()) {
            grade_parameters(model);
        }
        if is_balanced {
            solution.balance(&mut model.graph);
        }
        let is_free = model.constraints.is_empty() && model.reactions.is_empty();
        let may_be_indefinite = matches!(model.energies, Energies::Lagrangian);
        let growth = may_be_indefinite.then(|| pivot_growth(model, forms.mass_matrix(), &solution)).flatten();
        let (pivot_growth, of_constraints) = if is_free { (growth, None) } else { (None, growth) };
        let multipliers = solution.values.split_off(velocities.len());
        let (reactions, constraints) = match kept_elimination(model, &mut forms, &mut solution)? {
            Some(steps) => {
                let reactions = ReactionEquations::new(model, Some(&steps), &multipliers);
                let conditions = [solution.condition, of_constraints].into_iter().flatten();
                let condition = conditions.reduce(|a, b| largest(&mut model.graph, a, b));
                let found = (multipliers, condition);
                let pushed = forms.pushed(model);
                (reactions, ConstraintEquations::new(model, pushed, &steps, found))
            }
            None => (ReactionEquations::new(model, None, &multipliers), Default::default()),
        };
        let mass = mass_structure(model, &split, &mut forms);
        let structure = Structure::find(model, mass);
        add_conserved(model, &structure);
        add_power(model);
        let labels = labels(model, forms.mass_matrix(), &solution);
        let solved =
            SolvedMotion { solution: &solution, strategy, constraints: &constraints, reactions: &reactions };
        let DerivedProducts { products, free_momentum_rates } = solved.products(model, &split, &mut forms);
        let wants_regressor = model.products.contains(&Product::Regressor);
        let regressor = if wants_regressor { Regressor::new(model) } else { Regressor::default() };
        let diffusion = Diffusion::new(model, &mut forms);
        let wants_series = model.products.contains(&Product::Taylor);
        let series = wants_series.then(|| SeriesEquations::new(model, &split, &constraints));
        let (mass_matrix, forcing) = forms.into_sides(model, &split);
        let mut equations = Equations {
            accelerations: solution.values,
            pivot_growth,
            strategy,
            is_sum_of_squares: !split.has_other_inertia,
            costs,
            mass_matrix,
            forcing,
            free_momentum_rates,
            series,
            constraints,
            reactions,
            products,
            frame_jacobians: frame_jacobians(model),
            frame_biases: frame_biases(model),
            regressor,
            diffusion,
            structure,
            switches: Vec::new(),
            labels,
        };
        if model.accuracy == Accuracy::Strict {
            equations.contract(model);
        }
        // Noise may cross a surface any number of times within a step.
        if model.noises.is_empty() {
            equations.switches = Switch::find(model, &equations.of_motion(model), &solution.guards);
        }
        Ok(equations)
    }

    /// Returns the components of a product of a model, by the entries of the state. Matrices are
    /// row by row, and Jacobians lack the rows of the positions' rates. `None` if it has no
    /// components or was not requested.
    pub fn product(&self, product: Product, model: &Model) -> Option<Vec<ExprId>> {
        let of_constraints =
            |part: fn(&Constraint) -> ExprId| Some(model.constraints.iter().map(part).collect());
        let of_energies = |part: usize| Some(vec![model.energies.parts()?[part]]);
        match product {
            Product::MassMatrix if self.mass_matrix.is_empty() => None,
            Product::MassMatrix => Some(self.mass_matrix.concat()),
            Product::Forcing => Some(self.forcing.clone()),
            Product::KineticEnergy => of_energies(0),
            Product::PotentialEnergy => of_energies(1),
            Product::Constraints => of_constraints(|constraint| constraint.value),
            Product::ConstraintVelocity => of_constraints(|constraint| constraint.velocity),
            Product::ConstraintJacobian => Some(self.constraints.jacobian.concat()),
            Product::ConstraintForces => Some(self.constraints.forces.clone()),
            Product::Regressor if self.regressor.columns.is_empty() => None,
            Product::Regressor => Some(self.regressor.rows(model.speeds.len())),
            _ => self.derived(product).map(<[ExprId]>::to_vec),
        }
    }

    fn derived(&self, product: Product) -> Option<&[ExprId]> {
        self.products.iter().find(|(known, _)| *known == product).map(|(_, roots)| roots.as_slice())
    }

    /// True if the mass matrix is constant during the motion and nothing but constraint forces
    /// depends on a velocity. This is judged by the symbols in the expressions: a velocity that
    /// cancels undetected still counts.
    pub fn is_separable(&self, model: &Model) -> bool {
        let depends = |&value: &ExprId| model.graph.dependencies(value).intersects(Dependencies::VELOCITY);
        let free = if model.constraints.is_empty() { &self.accelerations } else { &self.forcing };
        let are_rates = model.velocities_are_rates();
        let is_held = model.constraints.iter().all(|constraint| constraint.is_holonomic);
        let is_free = model.reactions.is_empty();
        self.structure.mass.is_constant && are_rates && is_held && is_free && !free.iter().any(depends)
    }

    /// Returns the expressions that determine the motion, whichever method integrates it.
    pub fn of_motion(&self, model: &Model) -> Vec<ExprId> {
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
        roots.extend(model.states().map(|state| state.rate));
        roots.extend(model.delays.iter().map(|delay| delay.signal));
        roots
    }

    /// Simplifies the emitted expressions other than accelerations to reduce cancellation.
    fn contract(&mut self, model: &mut Model) {
        let mut places = self.mass_matrix.iter_mut().flatten().chain(&mut self.forcing).collect::<Vec<_>>();
        let products = self.products.iter_mut().filter(|(product, _)| !product.is_derivative());
        places.extend(
            products.flat_map(|(_, roots)| roots).chain(self.free_momentum_rates.iter_mut().flatten()),
        );
        places.extend(model.energies.parts_mut());
        places.extend(model.outputs.iter_mut().flat_map(|output| &mut output.components));
        let exprs = places.iter().map(|place| **place).collect::<Vec<_>>();
        let contracted = simplify::contract_all(&mut model.graph, &mut Angles::default(), &exprs);
        places.into_iter().zip(contracted).for_each(|(place, expr)| *place = expr);
    }
}

/// True if the mass matrix, or something derived from it, is needed regardless of the strategy.
/// Constraints, contacts and friction add rows to it, and `strict` searches it for cancellation.
fn wants_mass_matrix(model: &Model, choice: StrategyChoice) -> bool {
    let is_made_of_it = |product: &Product| {
        product.is_derivative() || matches!(product, Product::MassMatrix | Product::Latex | Product::Taylor)
    };
    let is_free = model.constraints.is_empty() && model.reactions.is_empty();
    let is_asked_for = model.products.iter().any(is_made_of_it);
    let is_factorised = choice == StrategyChoice::Always(Strategy::MassMatrix);
    is_asked_for || !is_free || is_factorised || model.accuracy == Accuracy::Strict
}

/// Determines the shape of the mass matrix, which is only written down if nothing else reveals it.
fn mass_structure(model: &mut Model, split: &SplitLagrangian, forms: &mut Forms) -> MassStructure {
    if !forms.is_pushed() && !split.has_other_inertia {
        let residual = residual(model, split, AccelerationTerms::Kept, Terms::All);
        if let Some(found) = MassStructure::seen_at_points(&model.graph, &residual) {
            return found;
        }
    }
    forms.push_down(model);
    MassStructure::of_matrix(&model.graph, forms.mass_matrix())
}

/// Returns the elimination for the right-hand sides of constraints, contacts and friction. It is
/// that of the chosen strategy or, if there is none, of the mass matrix. `None` without
/// constraints.
fn kept_elimination(
    model: &mut Model,
    forms: &mut Forms,
    solution: &mut Solution,
) -> Result<Option<Elimination>, SingularMassMatrix> {
    if model.constraints.is_empty() {
        return Ok(None);
    }
    let unknowns = model.unknowns();
    let own = solution.elimination.take();
    let steps = own.or_else(|| {
        let pushed = forms.pushed(model).clone();
        eliminate_dense(&mut model.graph, pushed, &unknowns)
    });
    steps.map(Some).ok_or(SingularMassMatrix)
}

/// Returns the user's names, followed by names of matrix entries and intermediate results of the
/// solution.
fn labels(model: &Model, mass_matrix: &[Vec<ExprId>], solution: &Solution) -> Vec<(ExprId, String)> {
    let symbols = model.speeds.iter().map(|speed| model.graph.symbol_of(speed.acceleration));
    let accelerations = solution.values.iter().zip(symbols);
    let accelerations = accelerations.filter_map(|(id, symbol)| Some((*id, symbol?.identifier())));
    let derived = matrix_labels(&model.graph, mass_matrix).into_iter().chain(accelerations);
    let rates = model.states().map(|state| (state.rate, format!("{}_dot", state.name)));
    let derived = derived.chain(rates).chain(solution.labels.iter().cloned());
    // Symbols and sines of angles are self-explanatory, unless the user has named them.
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
