//! Accelerations of a declared system to any number of digits: the reference for derived code.
//!
//! Only differentiation is shared with the derivation under test. M = ∂²L/∂v² and f = ∂L/∂q −
//! (∂p/∂q) v − ∂p/∂t + Q with p = ∂L/∂v stay undivided expressions (Goldstein, Poole and Safko,
//! *Classical Mechanics*, 3rd ed., §1.4). With unit quaternions, q̇ = N v, the term ∂L/∂q becomes
//! Nᵀ ∂L/∂q. An angular velocity ω adds −ω × ∂L/∂ω (Lurie, *Analytical Mechanics*, §10.1). M a = f
//! is solved numerically by Gaussian elimination with partial pivoting (Golub and Van Loan, *Matrix
//! Computations*, 4th ed., §3.4). The number of bits is doubled until two results agree, so that
//! the condition of M does not matter.

use lagrange_core::calculus::{AccelerationTerms, Rates, gradient};
use lagrange_core::expr::ExprId;
use lagrange_core::model::Model;
use lagrange_core::number::Number;
use lagrange_core::pipeline::parse;
use lagrange_core::symbol::Role;

use crate::digits::{Arithmetic, Real, approximate};
use crate::linear::solve;

/// The precisions to try, in bits.
const BITS: [usize; 5] = [256, 512, 1024, 2048, 4096];
/// Required agreement between two results, relative to each entry.
const AGREEMENT: f64 = 1e-30;
/// Threshold below which an entry counts as zero, relative to the largest one.
const NOTHING: f64 = 1e-200;

/// The undivided equations of motion of a declaration.
pub(crate) struct Reference {
    pub(crate) model: Model,
    mass_matrix: Vec<ExprId>,
    forcing: Vec<ExprId>,
    momenta: Vec<ExprId>,
}

/// Exact values at a state.
#[derive(Clone, Debug)]
pub(crate) struct Truth {
    /// q̈
    pub(crate) accelerations: Vec<Real>,
    /// v·∂L/∂v − L
    pub(crate) energy: Real,
    /// √Mᵢᵢ: the scales in which a mass matrix has a unit diagonal.
    pub(crate) scales: Vec<f64>,
}

impl Reference {
    /// Derives the equations of a declaration given as text.
    pub(crate) fn new(declaration: &str) -> Reference {
        let mut model = parse(declaration).unwrap_or_else(|report| panic!("{report}")).model;
        let velocities = model.velocities();
        let momenta = gradient(&mut model.graph, model.lagrangian, &velocities);
        let rows = momenta.iter().map(|&p| gradient(&mut model.graph, p, &velocities));
        let mass_matrix = rows.flatten().collect();
        let forcing = forcing(&mut model, &momenta);
        Reference { model, mass_matrix, forcing, momenta }
    }

    fn size(&self) -> usize {
        self.forcing.len()
    }

    /// Returns the exact values where symbols have the values of `value_of`, or `None` if the mass
    /// matrix is singular.
    pub(crate) fn at(&self, value_of: impl Fn(Role, &mut Arithmetic) -> Real) -> Option<Truth> {
        let mut before: Option<Truth> = None;
        for bits in BITS {
            let found = self.with_bits(bits, &value_of);
            if let (Some(found), Some(before)) = (&found, &before)
                && agree(&found.accelerations, &before.accelerations)
            {
                return Some(found.clone());
            }
            before = found;
        }
        None
    }

    pub(crate) fn with_bits(
        &self,
        bits: usize,
        value_of: &impl Fn(Role, &mut Arithmetic) -> Real,
    ) -> Option<Truth> {
        let mut arithmetic = Arithmetic::new(bits);
        let n = self.size();
        let roots = [&self.mass_matrix[..], &self.forcing, &self.momenta, &[self.model.lagrangian]].concat();
        let roots = [roots, self.model.velocities()].concat();
        let values = arithmetic.evaluate(&self.model.graph, &roots, value_of);
        let (matrix, rest) = values.split_at(n * n);
        let (forcing, rest) = rest.split_at(n);
        let (momenta, rest) = rest.split_at(n);
        let energy = arithmetic.subtract(&arithmetic.dot(momenta, &rest[1..]), &rest[0]);
        let scales = (0..n).map(|i| approximate(&matrix[i * n + i]).abs().sqrt()).collect();
        let accelerations = solve(&arithmetic, matrix, forcing)?;
        Some(Truth { accelerations, energy, scales })
    }

    /// Returns ‖S‖₁ ‖S⁻¹‖₁ of the mass matrix M, as it is and scaled to a unit diagonal, S = D M D.
    pub(crate) fn conditions(&self, value_of: impl Fn(Role, &mut Arithmetic) -> Real) -> [f64; 2] {
        let mut arithmetic = Arithmetic::new(1024);
        let n = self.size();
        let matrix = arithmetic.evaluate(&self.model.graph, &self.mass_matrix, value_of);
        let scale = |i: usize| arithmetic.sqrt(&matrix[i * n + i].abs());
        let scales = (0..n).map(scale).collect::<Vec<_>>();
        let scaled = (0..n * n).map(|k| {
            let row_scaled = arithmetic.divide(&matrix[k], &scales[k / n]);
            arithmetic.divide(&row_scaled, &scales[k % n])
        });
        let scaled = scaled.collect::<Vec<_>>();
        [&matrix, &scaled].map(|matrix| condition(&arithmetic, matrix, n))
    }
}

/// Summands of an entry.
type Terms = Vec<(ExprId, Number)>;

fn forcing(model: &mut Model, momenta: &[ExprId]) -> Vec<ExprId> {
    let mut terms = slopes(model);
    let velocities = model.velocities();
    let graph = &mut model.graph;
    let mut rates = Rates::new(AccelerationTerms::Dropped);
    let losses = gradient(graph, model.dissipation, &velocities);
    for ((terms, &momentum), loss) in terms.iter_mut().zip(momenta).zip(losses) {
        let drift = rates.of(graph, momentum);
        terms.extend([(drift, Number::MINUS_ONE), (loss, Number::MINUS_ONE)]);
    }
    for load in &model.loads {
        let arms = gradient(graph, load.velocity, &velocities);
        for (terms, arm) in terms.iter_mut().zip(arms) {
            terms.push((graph.multiply(load.force, arm), Number::ONE));
        }
    }
    add_turning(model, momenta, &mut terms);
    terms.into_iter().map(|terms| model.graph.sum(Number::ZERO, terms)).collect()
}

/// Returns Nᵀ ∂L/∂q for rates N v of the positions.
fn slopes(model: &mut Model) -> Vec<Terms> {
    let (velocities, positions) = (model.velocities(), model.positions());
    let graph = &mut model.graph;
    let mut terms = vec![Terms::new(); velocities.len()];
    let slopes = gradient(graph, model.lagrangian, &positions);
    for (coordinate, slope) in model.coordinates.iter().zip(slopes) {
        let shares = gradient(graph, coordinate.rate, &velocities);
        for (terms, share) in terms.iter_mut().zip(shares) {
            terms.push((graph.multiply(slope, share), Number::ONE));
        }
    }
    terms
}

/// Adds −ω × p at the angular velocities.
fn add_turning(model: &mut Model, momenta: &[ExprId], terms: &mut [Terms]) {
    let velocities = model.velocities();
    for orientation in &model.orientations {
        for axis in 0..3 {
            let [next, last] = [1, 2].map(|by| orientation.velocity + (axis + by) % 3);
            let products = [(next, last, Number::MINUS_ONE), (last, next, Number::ONE)];
            let products = products.map(|(turning, carried, sign)| {
                (model.graph.multiply(velocities[turning], momenta[carried]), sign)
            });
            terms[orientation.velocity + axis].extend(products);
        }
    }
}

/// Returns ‖M‖₁ ‖M⁻¹‖₁, or infinity for a singular matrix.
fn condition(arithmetic: &Arithmetic, matrix: &[Real], n: usize) -> f64 {
    let sum = |column: &[Real]| {
        column.iter().fold(arithmetic.integer(0), |sum, entry| arithmetic.add(&sum, &entry.abs()))
    };
    let largest = |columns: &mut dyn Iterator<Item = Vec<Real>>| {
        columns.fold(arithmetic.integer(0), |largest, column| largest.max(&sum(&column)))
    };
    let norm = largest(&mut (0..n).map(|j| (0..n).map(|i| matrix[i * n + j].clone()).collect()));
    let unit = |j: usize| (0..n).map(|i| arithmetic.integer(i32::from(i == j))).collect::<Vec<_>>();
    let inverse = (0..n).map(|j| solve(arithmetic, matrix, &unit(j))).collect::<Option<Vec<_>>>();
    let inverse = inverse.map(|columns| largest(&mut columns.into_iter()));
    inverse.map_or(f64::INFINITY, |inverse| approximate(&arithmetic.multiply(&norm, &inverse)))
}

fn agree(found: &[Real], before: &[Real]) -> bool {
    let largest = found.iter().fold(0.0_f64, |largest, value| largest.max(approximate(value).abs()));
    found.iter().zip(before).all(|(found, before)| {
        relative_error(before, found) <= AGREEMENT || approximate(found).abs() <= NOTHING * largest
    })
}

/// Returns |found − exact| / |exact|, or 0 if both are 0.
pub(crate) fn relative_error(found: &Real, exact: &Real) -> f64 {
    let arithmetic = Arithmetic::new(256);
    let difference = arithmetic.subtract(found, exact);
    if difference.is_zero() { 0.0 } else { approximate(&arithmetic.divide(&difference, exact)).abs() }
}
