//! Strategies of forward dynamics: ways from a quadratic form to the accelerations, and the choice
//! among them.

use std::fmt;

use super::cost::cost;
use super::coupling::most_coupled;
use super::elimination::contracted::{MAX_CONTRACTED, solve_contracted};
use super::elimination::solution::{Solution, solve_dense, solve_recursive};
use super::forms::Forms;
use super::least_constraint::{SplitLagrangian, Terms, loads_beside_squares};
use super::messages;
use super::sum_of_squares::{Obstacle, solve_sum_of_squares};
use crate::model::Model;
use lagrange_algebra::calculus::AccelerationTerms;
use lagrange_expr::accuracy::Accuracy;
use lagrange_expr::expr::ExprId;

/// Maximum number of coordinates for which a full mass matrix is factorised on trial. For more,
/// writing down a factorisation of cubic size would be wasted effort.
const LARGEST_TRIAL: usize = 40;

/// True if a full block of the mass matrix is too large to be factorised on trial.
pub(super) fn has_large_mass_matrix(model: &Model) -> bool {
    most_coupled(model, LARGEST_TRIAL + 1) > LARGEST_TRIAL
}

/// Strategy by which the accelerations are computed.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Strategy {
    /// The mass matrix is formed and factorised.
    MassMatrix,
    /// Coordinates are eliminated body by body; the mass matrix is never formed.
    ArticulatedBody,
    /// Coordinates are eliminated body by body, and the kinetic energy remains a sum of squares:
    /// nothing is ever subtracted from a coefficient.
    SumOfSquares,
}

impl Strategy {
    /// Every strategy, in the order of [`Equations::costs`](super::Equations::costs).
    pub const ALL: [Strategy; 3] = [Strategy::MassMatrix, Strategy::ArticulatedBody, Strategy::SumOfSquares];
}

/// Choice of a strategy.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum StrategyChoice {
    /// The strategy with the lowest estimated cost.
    #[default]
    Cheapest,
    /// A given strategy, or the mass matrix if this strategy finds no solution.
    Always(Strategy),
}

/// The error of a mass matrix that is singular for all values of the parameters.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SingularMassMatrix;

impl fmt::Display for SingularMassMatrix {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(messages::SINGULAR_MASS_MATRIX)
    }
}

impl std::error::Error for SingularMassMatrix {}

impl SingularMassMatrix {
    /// Writes the message for users, with the names of the coordinates that take part in a motion
    /// without inertia.
    pub fn message(self, coordinates: &[&str]) -> String {
        messages::singular_mass_matrix(coordinates)
    }

    /// Returns advice.
    pub fn help(self) -> &'static str {
        messages::SINGULAR_HELP
    }
}

/// A solution, the strategy that found it, and the estimated cost of each strategy that was tried.
pub(super) type Solved = (Solution, Strategy, [Option<f64>; 3]);

/// The common input of the strategies.
pub(super) struct Candidates<'a> {
    pub(super) model: &'a mut Model,
    pub(super) split: &'a SplitLagrangian,
    pub(super) forms: &'a mut Forms,
}

impl Candidates<'_> {
    pub(super) fn solve(mut self, choice: StrategyChoice) -> Result<Solved, SingularMassMatrix> {
        if choice == StrategyChoice::Cheapest && self.model.accuracy == Accuracy::Strict {
            return self.most_accurate();
        }
        let mut best = None;
        let mut costs = [None; 3];
        // The mass matrix is tried last, since its factors are not worth writing down if it is
        // large.
        for (n, strategy) in Strategy::ALL.into_iter().enumerate().rev() {
            let solution = match choice {
                StrategyChoice::Always(only) if only != strategy => None,
                StrategyChoice::Cheapest
                    if strategy == Strategy::MassMatrix && best.is_some() && self.is_large() =>
                {
                    None
                }
                _ => self.take(strategy)?,
            };
            let Some(solution) = solution else { continue };
            let cost = cost(&self.model.graph, &solution.values);
            costs[n] = Some(cost);
            // In a tie the later strategy, which is simpler, is kept.
            if best.as_ref().is_none_or(|(_, _, least)| cost <= *least) {
                best = Some((solution, strategy, cost));
            }
        }
        match (best, choice) {
            (Some((solution, strategy, _)), _) => Ok((solution, strategy, costs)),
            (None, StrategyChoice::Always(Strategy::ArticulatedBody | Strategy::SumOfSquares)) => {
                self.solve(StrategyChoice::Always(Strategy::MassMatrix))
            }
            (None, _) => Err(SingularMassMatrix),
        }
    }

    /// Returns the most accurate solution. Systems without coupling need no elimination. Otherwise
    /// squares are tried first. If they fail, the mass matrix is used if its cancellations can be
    /// found. If it is too large for that, elimination body by body is used, since it accumulates
    /// less before it subtracts.
    fn most_accurate(&mut self) -> Result<Solved, SingularMassMatrix> {
        let velocities = self.model.velocities();
        let pushed = self.forms.pushed(self.model);
        let is_coupled = velocities.iter().any(|&velocity| pushed.degree(velocity) > 0);
        let is_contracted = velocities.len() <= MAX_CONTRACTED;
        let strategies = match (is_coupled, is_contracted) {
            // Accelerations in the axes of bodies lose digits when they are expanded.
            (true, _) if self.split.has_gibbs_function() => {
                [Strategy::ArticulatedBody, Strategy::MassMatrix, Strategy::SumOfSquares]
            }
            (false, _) => [Strategy::MassMatrix, Strategy::ArticulatedBody, Strategy::SumOfSquares],
            (true, true) => [Strategy::SumOfSquares, Strategy::MassMatrix, Strategy::ArticulatedBody],
            (true, false) => [Strategy::SumOfSquares, Strategy::ArticulatedBody, Strategy::MassMatrix],
        };
        for strategy in strategies {
            if let Some(solution) = self.take(strategy)? {
                return Ok((solution, strategy, [None; 3]));
            }
        }
        Err(SingularMassMatrix)
    }

    /// True if the mass matrix is large and full. A large matrix that has not been formed yet
    /// counts as full.
    fn is_large(&mut self) -> bool {
        let count = self.model.speeds.len();
        count > LARGEST_TRIAL
            && (!self.forms.is_pushed() || self.forms.pushed(self.model).is_mostly_full(count))
    }

    /// Solves by one strategy; `None` if it finds no solution.
    fn take(&mut self, strategy: Strategy) -> Result<Option<Solution>, SingularMassMatrix> {
        let unknowns = self.model.unknowns();
        match strategy {
            Strategy::MassMatrix => Ok(self.factorised(&unknowns)),
            Strategy::ArticulatedBody => {
                Ok(solve_recursive(&mut self.model.graph, self.forms.form.clone(), &unknowns))
            }
            Strategy::SumOfSquares if !self.has_squares_only() => Ok(None),
            Strategy::SumOfSquares => self.squares(),
        }
    }

    /// True if there are only squares of rates, which excludes multipliers, since these occur in
    /// products.
    fn has_squares_only(&self) -> bool {
        !self.split.has_other_inertia && self.model.constraints.is_empty()
    }

    fn factorised(&mut self, unknowns: &[ExprId]) -> Option<Solution> {
        let is_strict = self.model.accuracy == Accuracy::Strict && self.model.constraints.is_empty();
        let pushed = self.forms.pushed(self.model);
        let graph = &mut self.model.graph;
        let contracted = is_strict.then(|| solve_contracted(graph, pushed, unknowns)).flatten();
        contracted.or_else(|| solve_dense(graph, pushed.clone(), unknowns))
    }

    /// Solves by squares; `None` if they have no pivot or fill in too much.
    fn squares(&mut self) -> Result<Option<Solution>, SingularMassMatrix> {
        let velocities = self.model.velocities();
        let loads = loads_beside_squares(self.model, self.split, AccelerationTerms::Dropped, Terms::All);
        match solve_sum_of_squares(&mut self.model.graph, self.split, loads, &velocities) {
            Ok(solution) => Ok(Some(solution)),
            Err(Obstacle::NothingMoves) => Err(SingularMassMatrix),
            Err(Obstacle::Pivot | Obstacle::Size) => Ok(None),
        }
    }
}
