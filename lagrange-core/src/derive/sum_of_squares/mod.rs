//! Elimination that keeps the form a sum of squares.
//!
//! Neither the mass matrix nor its Schur complements are formed. The remainder of an elimination is
//! again a sum of squares, found by [`rotation`]. This preserves the digits that differences of
//! large entries lose. On chains and trees of points it is also the shortest way, since a single
//! number represents a subtree between two points.
//!
//! # The double pendulum in numbers
//!
//! Take unit lengths and masses and g = 10. The upper rod is horizontal (θ₁ = 90°) with θ̇₁ = 1.
//! The lower one hangs from its end (θ₂ = 0) with θ̇₂ = 2. Write (x₁, y₁) and (x₂, y₂) for the
//! accelerations of the points, measured from an offset: y is ÿ + 10, so gravity occurs nowhere
//! else. Then x₁ = −1, y₁ = θ̈₁ + 10, and ½ (x₁² + y₁² + x₂² + y₂²) is to be minimised.
//!
//! **θ̈₂ first.** It moves the second point along t = (cos θ₂, sin θ₂) = (1, 0). Then x₂ = 1 θ̈₂ +
//! x₁ and y₂ = 0 θ̈₂ + y₁ + 4, with the centripetal θ̇₂² = 4 as *drift*.
//!
//! | | |
//! |---|---|
//! | weights w, arms a | 1, 1 along (1, 0) |
//! | pivot Σ w a² | 1 · 1² + 1 · 0² = 1 |
//! | minor t₁ y₂ − t₂ x₂, without θ̈₂ | y₁ + 4 |
//! | left by Lagrange's identity | ½ · (1 · 1 / 1) · (y₁ + 4)² |
//!
//! The remainder of the two squares of the second point is a single square, that of the
//! acceleration along the lower rod. It is the only effect on the upper rod. **θ̈₁ next.** In ½
//! (x₁² + y₁² + (y₁ + 4)²) the arms of θ̈₁ are 0, 1, 1:
//!
//! | | |
//! |---|---|
//! | `pivot_0` | 1 + 1 = 2; in symbols m₁ + m₂ sin²(θ₁ − θ₂), a sum as ever |
//! | stationary | y₁ + (y₁ + 4) = 0, hence y₁ = −2 and θ̈₁ = −12 |
//!
//! **Back.** Along and across the upper rod, in the frame of t = (0, 1), the end has `normal_0` =
//! −x₁ = 1 and `minus_tangential_0` = 2. The lower rod has `normal_1` = y₁ + 4 = 2, and its
//! tangential acceleration is free of load: θ̈₂ + x₁ = 0, so θ̈₂ = 1.
//!
//! ```
//! use std::f64::consts::FRAC_PI_2;
//!
//! use lagrange_core::expr::evaluate;
//! use lagrange_core::derive::{Strategy, StrategyChoice};
//! use lagrange_core::pipeline::parse;
//! use lagrange_core::symbol::Role;
//!
//! let declaration = std::fs::read_to_string("tests/golden/double_pendulum/declaration.lag")?;
//! let derived = parse(&declaration)?.derive(StrategyChoice::Always(Strategy::SumOfSquares))?;
//! let value = |expression| {
//!     let values = evaluate(&derived.model.graph, &[expression], |role| match role {
//!         Role::Parameter(4) => 10.0,
//!         Role::Coordinate(0) => FRAC_PI_2,
//!         Role::Coordinate(_) => 0.0,
//!         Role::Velocity(1) => 2.0,
//!         _ => 1.0,
//!     });
//!     (values[0] * 1e9).round() / 1e9
//! };
//! for (name, expected) in [("pivot_0", 2.0), ("normal_0", 1.0), ("minus_tangential_0", 2.0), ("normal_1", 2.0)] {
//!     let (found, _) = derived.equations.labels.iter().find(|(_, label)| label == name).expect("a label");
//!     assert_eq!(value(*found), expected, "{name}");
//! }
//! let accelerations = derived.equations.accelerations.iter().map(|&id| value(id)).collect::<Vec<_>>();
//! assert_eq!(accelerations, [-12.0, 1.0]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod back;
mod composition;
mod frame;
mod guard;
mod loads;
mod rotation;
mod square;

use super::algebra::Algebra;
use super::elimination::solution::Solution;
use super::least_constraint::SplitLagrangian;
use super::quadratic_form::QuadraticForm;
use super::sweep::{Multiples, Rotations, Sweep};
use back::{EliminatedUnknown, Substitution, Way, substitute_back};
use composition::{AffineExpansion, Composition};
use frame::frame;
use lagrange_algebra::simplify;
use lagrange_expr::collections::OrderedMap;
use lagrange_expr::expr::{ExprId, Graph};
use lagrange_expr::number::Number;
use loads::push_loads;
use rotation::{Pull, eliminate};
use square::{Carried, Carriers, Square};

/// Reason for a failed elimination among squares.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Obstacle {
    /// Some motion changes no square, so the mass matrix is singular for any weights.
    NothingMoves,
    /// Weights of both signs leave no pivot.
    Pivot,
    /// The squares fill in too much.
    Size,
}

/// Computes the accelerations, in the order of the velocities, from the squares of a Lagrangian
/// without other quadratic terms. `loads` is the linear part of the form without the rates of the
/// squares.
pub(super) fn solve_sum_of_squares(
    graph: &mut Graph,
    split: &SplitLagrangian,
    loads: QuadraticForm,
    velocities: &[ExprId],
) -> Result<Solution, Obstacle> {
    let heads = split.squares.iter().map(|&(_, u)| u).chain(loads.variables()).collect::<Vec<_>>();
    let mut sweep = Sweep::new(graph, [&heads, &[]], velocities, Multiples::Merged, Rotations::Split);
    let mut elimination = SquareElimination::new(graph, &sweep, split, loads);
    let mut order = leaves(&mut sweep);
    order.sort_by_cached_key(|&velocity| elimination.moved_by(velocity));
    for velocity in order {
        elimination.eliminate(velocity)?;
    }
    let SquareElimination { algebra, composition, steps, .. } = elimination;
    if steps.len() < velocities.len() {
        return Err(Obstacle::NothingMoves);
    }
    Ok(substitute_back(algebra, composition, &steps, velocities))
}

/// Returns the generalised velocities in the order in which the sweep frees them.
fn leaves(sweep: &mut Sweep) -> Vec<ExprId> {
    let mut order = Vec::new();
    loop {
        order.extend(std::iter::from_fn(|| sweep.next_leaf()));
        if sweep.next_step().is_none() {
            return order;
        }
    }
}

/// Returns the variables of the squares that depend on the unknown.
fn carrier_ids(expansions: &OrderedMap<ExprId, AffineExpansion>, squares: &[Square]) -> Vec<ExprId> {
    let mut ids = squares.iter().flat_map(|square| square.form.iter().map(|(id, _)| *id)).collect::<Vec<_>>();
    ids.retain(|id| expansions.contains(id));
    ids.sort_unstable();
    ids.dedup();
    ids
}

struct SquareElimination<'g> {
    algebra: Algebra<'g>,
    composition: Composition,
    squares: Vec<Square>,
    loads: QuadraticForm,
    steps: Vec<EliminatedUnknown>,
}

impl<'g> SquareElimination<'g> {
    fn new(
        graph: &'g mut Graph,
        sweep: &Sweep,
        split: &SplitLagrangian,
        loads: QuadraticForm,
    ) -> SquareElimination<'g> {
        let mut weights: OrderedMap<ExprId, Vec<(ExprId, Number)>> = OrderedMap::default();
        for &(weight, u) in &split.squares {
            weights.get_or_insert_with(u, Vec::new).push((weight, Number::ONE));
        }
        let loads = push_loads(graph, sweep, &weights, loads);
        let heads = weights.iter().map(|(u, _)| *u).chain(loads.variables());
        let composition = Composition::new(sweep, heads);
        let algebra = Algebra::new(graph);
        let mut elimination =
            SquareElimination { algebra, composition, squares: Vec::new(), loads, steps: Vec::new() };
        weights.iter().for_each(|(u, weights)| elimination.add_square_of(*u, weights));
        elimination
    }

    /// Adds the square of a variable, with the load that acts along it.
    fn add_square_of(&mut self, u: ExprId, weights: &[(ExprId, Number)]) {
        let graph = &mut *self.algebra.graph;
        let weight = simplify::collect(graph, weights.to_vec());
        let load = self.loads.take(graph, u).linear;
        let offset = graph.divide(load, weight);
        let is_steady = graph.dependencies(offset).is_constant_in_motion();
        let one = graph.number(1);
        let mut square = Square { weight, linear: load, form: vec![(u, one)] };
        // Gravity is such an offset, the same for all points, so it cancels in their differences. A
        // load that changes in motion remains a load. The same is true of a load on a generalised
        // velocity itself, which no other variable shares.
        if is_steady && !self.composition.parts(u).is_empty() {
            self.composition.set_offset(u, offset);
            square.linear = graph.number(0);
        }
        self.squares.push(square);
    }

    /// Returns the number of inertias and the number of squares that a velocity moves. The velocity
    /// that moves the fewest is eliminated first, such as the pole before its cart. Its remainder
    /// then adds to the inertia of its carrier.
    fn moved_by(&self, velocity: ExprId) -> (usize, usize) {
        let made_of = self.composition.made_of(velocity);
        let touches = |square: &&Square| square.form.iter().any(|(id, _)| made_of.binary_search(id).is_ok());
        let mut weights = self.squares.iter().filter(touches).map(|square| square.weight).collect::<Vec<_>>();
        let squares = weights.len();
        weights.sort_unstable();
        weights.dedup();
        (weights.len(), squares)
    }

    /// Eliminates one velocity.
    fn eliminate(&mut self, velocity: ExprId) -> Result<(), Obstacle> {
        let ways = self.ways_up(velocity);
        let unknown = ways.last().map_or(velocity, |way| way.whole);
        let mut expansions = self.composition.expand(&mut self.algebra, unknown);
        let touched = self.take_touched(&expansions);
        let ids = carrier_ids(&expansions, &touched);
        let scale = self.rescale(&mut expansions, &ids);
        self.draw_out_of_drifts(&mut expansions, &ids);
        let of_carriers = ids.iter().filter_map(|id| expansions.get(id).cloned()).collect();
        let carriers = Carriers::new(&mut self.algebra, ids, of_carriers);
        let touched =
            touched.into_iter().map(|square| carriers.carry(&mut self.algebra, square)).collect::<Vec<_>>();
        if touched.is_empty() {
            return Err(Obstacle::NothingMoves);
        }
        let (pull, left) = eliminate(&mut self.algebra, &carriers, &touched).ok_or(Obstacle::Size)?;
        if self.algebra.graph.is_zero(pull.pivot) {
            return Err(Obstacle::Pivot);
        }
        let applied = self.applied_load(&expansions);
        let rule = self.rule(&carriers, &touched, &pull, applied);
        let retired = expansions.iter().map(|(id, _)| *id).collect::<Vec<_>>();
        self.composition.retire(&retired);
        self.steps.push(EliminatedUnknown {
            velocity,
            unknown,
            ways,
            scale,
            pivot: pull.pivot,
            rule,
            expansions,
        });
        self.add_squares(left);
        Ok(())
    }

    /// Takes the squares that contain any of the variables.
    fn take_touched(&mut self, expansions: &OrderedMap<ExprId, AffineExpansion>) -> Vec<Square> {
        let is_touched = |square: &Square| square.form.iter().any(|(id, _)| expansions.contains(id));
        let (touched, kept) = std::mem::take(&mut self.squares).into_iter().partition(is_touched);
        self.squares = kept;
        touched
    }

    /// Returns the rule by which the unknown follows from the remaining variables. A load along it
    /// is passed on.
    fn rule(
        &mut self,
        carriers: &Carriers,
        touched: &[Carried],
        pull: &Pull,
        applied: ExprId,
    ) -> Substitution {
        let loads = [pull.applied, applied];
        if let Some(frame) = frame(carriers, &mut self.algebra, touched, pull.pivot) {
            if !self.algebra.graph.is_zero(applied) {
                let factors = frame.factors(&mut self.algebra);
                self.pass_on(&factors, applied);
            }
            let offset = self.divided(&loads, pull.pivot);
            return Substitution::InFrame { carriers: frame.carriers, bend: frame.bend, offset };
        }
        let factors = pull.factors(&mut self.algebra, carriers);
        self.pass_on(&factors, applied);
        let free = self.divided(&[&loads[..], &[pull.drifting]].concat(), pull.pivot);
        Substitution::Plain { factors, free }
    }

    fn divided(&mut self, terms: &[ExprId], pivot: ExprId) -> ExprId {
        let total = self.algebra.total(terms.iter().map(|&term| (term, Number::ONE)).collect());
        simplify::quotient(self.algebra.graph, total, pivot)
    }

    /// Returns the links from a velocity up to the variable to eliminate. The velocity only enters
    /// through this variable.
    fn ways_up(&mut self, velocity: ExprId) -> Vec<Way> {
        let mut ways = Vec::new();
        let mut part = velocity;
        while !self.squares.iter().any(|square| square.form.iter().any(|(id, _)| *id == part))
            && let Some((whole, slope)) = self.composition.only_user(self.algebra.graph, part)
            && let Some(inverse) = slope.reciprocal()
        {
            self.move_load(part, whole, &inverse);
            ways.push(Way { part, whole, inverse });
            part = whole;
        }
        ways
    }

    /// Measures the unknown in units of the common factor of the slopes of its carriers, such as
    /// the length of a rod. The factor then no longer occurs in them.
    fn rescale(
        &mut self,
        expansions: &mut OrderedMap<ExprId, AffineExpansion>,
        carriers: &[ExprId],
    ) -> ExprId {
        let slopes = carriers.iter().filter_map(|id| Some(expansions.get(id)?.slope)).collect::<Vec<_>>();
        let graph = &mut *self.algebra.graph;
        let (scale, _) = simplify::content(graph, &slopes);
        // A factor that changes in motion may vanish and is not a valid unit; a single slope would
        // be all scale.
        if slopes.len() < 2 || !graph.dependencies(scale).is_constant_in_motion() {
            return graph.number(1);
        }
        let ids = expansions.iter().map(|(id, _)| *id).collect::<Vec<_>>();
        for id in ids {
            if let Some(expansion) = expansions.get_mut(&id) {
                expansion.slope = simplify::quotient(graph, expansion.slope, scale);
            }
        }
        scale
    }

    /// Writes the drifts of the carriers as multiples of their common factor, such as the squared
    /// rate of a rod.
    fn draw_out_of_drifts(
        &mut self,
        expansions: &mut OrderedMap<ExprId, AffineExpansion>,
        carriers: &[ExprId],
    ) {
        let drifts = carriers.iter().filter_map(|id| Some(expansions.get(id)?.drift)).collect::<Vec<_>>();
        if drifts.len() < 2 {
            return;
        }
        let graph = &mut *self.algebra.graph;
        let (common, rest) = simplify::content(graph, &drifts);
        for (id, rest) in carriers.iter().zip(rest) {
            if let Some(expansion) = expansions.get_mut(id) {
                expansion.drift = graph.multiply(common, rest);
            }
        }
    }

    /// Adds squares, and merges squares of the same form.
    fn add_squares(&mut self, squares: Vec<Square>) {
        for square in squares {
            let square = self.primitive(&square);
            match self.squares.iter_mut().find(|present| present.form == square.form) {
                Some(present) => {
                    let graph = &mut *self.algebra.graph;
                    present.weight = simplify::collect(
                        graph,
                        vec![(present.weight, Number::ONE), (square.weight, Number::ONE)],
                    );
                    present.linear = graph.add(present.linear, square.linear);
                }
                None => self.squares.push(square),
            }
        }
    }

    /// Moves the common factor of the coefficients of a square into its weight.
    fn primitive(&mut self, square: &Square) -> Square {
        let (content, form) = self.algebra.primitive(&square.form);
        let graph = &mut *self.algebra.graph;
        let squared = graph.square(content);
        Square {
            weight: graph.multiply(square.weight, squared),
            linear: graph.multiply(square.linear, content),
            form,
        }
    }
}

#[cfg(test)]
mod tests;
