//! The law of contacts and friction as a linear complementarity problem, solved by Lemke's method.
//!
//! Reactions and rates are measured as in [`reaction_forces`](super::reaction_forces). Three pairs
//! w ≥ 0, z ≥ 0, w z = 0 stand for friction that holds or slips, and one for a contact that presses
//! or parts:
//!
//! ```text
//! contact:   w = rate,                     z = r
//! friction:  w = rate + s,                 z = r₊            r = r₊ − r₋
//!            w = −rate + s,                z = r₋
//!            w = limit − r₊ − r₋,          z = s             s is the size of the slip velocity
//! ```
//!
//! Rates and limits are affine in the reactions, so that w = q + M z. Friction that is known to
//! slip is an equation for a reaction without a sign. All w become possible by a multiple z₀ of the
//! vector of ones. Then z₀ is reduced to zero: whenever a variable leaves the basis its complement
//! enters.
//!
//! If G is positive semidefinite and limits do not fall where contacts press, M is copositive. Then
//! Lemke's method ends at a solution if no friction is known to slip, and no reactions without
//! effect on the rates work against q. Every impact without restitution therefore has impulses.
//! Friction that is known to slip may leave no solution: the paradox of Painlevé.
//!
//! q is increased by a little more than rounding, by a different amount in each row, which prevents
//! cycles. The last basis gives the rules, and the rules give the reactions.
//!
//! Sources: Stewart, Trinkle, "An implicit time-stepping scheme for rigid body dynamics with
//! inelastic collisions and Coulomb friction", *Int. J. Numer. Methods Eng.* 39 (1996) 2673–2691;
//! Anitescu, Potra, "Formulating dynamic multi-rigid-body contact problems with friction as
//! solvable linear complementarity problems", *Nonlinear Dynamics* 14 (1997) 231–247; Cottle, Pang,
//! Stone, *The Linear Complementarity Problem*, §4.4, §4.9.

use super::LimitSlope;
use super::choice::{Choice, Rule, Settled};
use super::reaction_forces::Balance;
use crate::linalg::singular::negligible;
use crate::scalar::Scalar;

/// Number of pairs of each reaction.
const PAIRS: usize = 3;
/// Maximum number of exchanges for each pair.
const MOST_EXCHANGES: usize = 16;

/// An entry for each pair, reaction by reaction.
type Pairs<T, const K: usize> = [[T; PAIRS]; K];

/// A variable: w and z of a pair, or z₀.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Variable {
    W(usize),
    Z(usize),
    Cover,
}

/// A variable as a function of the others: its value if they are zero, and its slope with respect
/// to each.
#[derive(Clone, Copy, Debug)]
struct Row<S, const K: usize> {
    variable: Variable,
    value: S,
    slopes: Pairs<S, K>,
    /// Slope with respect to the variable of the initial column of z₀.
    cover: S,
    /// True if it must not be negative. Rows of excluded pairs, and of reactions without a sign,
    /// may be negative.
    has_sign: bool,
}

/// The variables in the basis as functions of the others, which are zero.
struct PivotTableau<S, const K: usize> {
    rows: Pairs<Row<S, K>, K>,
    /// The variables of the columns.
    columns: Pairs<Variable, K>,
    cover: Variable,
}

/// Returns the column of a pair, or the last one.
type Column = Option<usize>;

impl Variable {
    /// Returns the other variable of its pair.
    fn complement(self) -> Variable {
        match self {
            Variable::W(pair) => Variable::Z(pair),
            Variable::Z(pair) => Variable::W(pair),
            Variable::Cover => Variable::Cover,
        }
    }
}

impl<S: Scalar, const K: usize> Row<S, K> {
    fn slope(&self, column: Column) -> S {
        column.map_or(self.cover, |pair| self.slopes[pair / PAIRS][pair % PAIRS])
    }

    fn slope_mut(&mut self, column: Column) -> &mut S {
        match column {
            Some(pair) => &mut self.slopes[pair / PAIRS][pair % PAIRS],
            None => &mut self.cover,
        }
    }

    /// Adds a multiple of another row, and replaces the entry of that column.
    fn add(&mut self, factor: S, other: &Row<S, K>, column: Column) {
        let kept = factor * other.slope(column);
        self.value = factor.multiply_add(other.value, self.value);
        self.cover = factor.multiply_add(other.cover, self.cover);
        for (slopes, others) in self.slopes.iter_mut().zip(&other.slopes) {
            for (slope, &other) in slopes.iter_mut().zip(others) {
                *slope = factor.multiply_add(other, *slope);
            }
        }
        *self.slope_mut(column) = kept;
    }
}

impl<S: Scalar, const K: usize> PivotTableau<S, K> {
    /// Exchanges the variable of a column, which enters the basis, and the variable of a row.
    fn exchange(&mut self, pair: usize, column: Column) -> Variable {
        let mut row = self.rows[pair / PAIRS][pair % PAIRS];
        let pivot = row.slope(column);
        let factor = -S::ONE / pivot;
        for slope in row.slopes.iter_mut().flatten() {
            *slope = *slope * factor;
        }
        (row.value, row.cover) = (row.value * factor, row.cover * factor);
        *row.slope_mut(column) = S::ONE / pivot;
        let left = row.variable;
        let entered = match column {
            Some(pair) => core::mem::replace(&mut self.columns[pair / PAIRS][pair % PAIRS], left),
            None => core::mem::replace(&mut self.cover, left),
        };
        row.variable = entered;
        for (other, present) in self.rows.iter_mut().flatten().enumerate() {
            if other == pair {
                *present = row;
            } else {
                let factor = present.slope(column);
                if factor != S::ZERO {
                    present.add(factor, &row, column);
                }
            }
        }
        left
    }

    /// Returns the column of a variable that is not in the basis.
    fn column_of(&self, variable: Variable) -> Option<Column> {
        if self.cover == variable {
            return Some(None);
        }
        self.columns.iter().flatten().position(|column| *column == variable).map(Some)
    }

    /// Returns the first row that becomes negative as the variable of a column grows. If there are
    /// several, the row of z₀ is preferred.
    fn first_to_vanish(&self, column: Column) -> Option<usize> {
        let mut first: Option<(usize, S)> = None;
        for (pair, row) in self.rows.iter().flatten().enumerate() {
            let slope = row.slope(column);
            if !row.has_sign || slope >= -negligible::<S>() {
                continue;
            }
            let ratio = row.value / -slope;
            let is_first = first.is_none_or(|(_, least)| {
                ratio < least || (ratio == least && row.variable == Variable::Cover)
            });
            if is_first {
                first = Some((pair, ratio));
            }
        }
        first.map(|(pair, _)| pair)
    }

    /// Returns the row with the most negative value.
    fn lowest(&self) -> Option<usize> {
        let mut lowest: Option<(usize, S)> = None;
        for (pair, row) in self.rows.iter().flatten().enumerate() {
            if row.has_sign && row.value < lowest.map_or(S::ZERO, |(_, value)| value) {
                lowest = Some((pair, row.value));
            }
        }
        lowest.map(|(pair, _)| pair)
    }

    /// Runs Lemke's method; returns true if it ended at a solution.
    fn solve(&mut self) -> bool {
        let Some(lowest) = self.lowest() else { return true };
        let mut left = self.exchange(lowest, None);
        for _ in 0..MOST_EXCHANGES * PAIRS * K {
            let Some(column) = self.column_of(left.complement()) else { return false };
            let Some(pair) = self.first_to_vanish(column) else { return false };
            left = self.exchange(pair, column);
            if left == Variable::Cover {
                return true;
            }
        }
        false
    }

    /// Returns the value of a variable.
    fn value(&self, variable: Variable) -> S {
        let row = self.rows.iter().flatten().find(|row| row.variable == variable);
        row.map_or(S::ZERO, |row| row.value)
    }
}

impl<S: Scalar, const N: usize, const K: usize> Balance<'_, S, N, K> {
    /// Finds rules among these choices that fit together within the tolerance of searches; `None`
    /// if the method fails.
    pub(super) fn complementary(&self, choices: &[Choice<S>; K]) -> Option<Settled<S, K>> {
        let mut tableau = self.tableau(choices)?;
        if !tableau.solve() {
            return None;
        }
        let units = self.units();
        let z = |k: usize, pair: usize| tableau.value(Variable::Z(PAIRS * k + pair));
        let reactions = core::array::from_fn(|k| (z(k, 0) - z(k, 1)) / units[k]);
        let rules = core::array::from_fn(|k| match choices[k] {
            Choice::Only(rule) => rule,
            Choice::Touch if z(k, 0) > S::ZERO => Rule::Holds,
            Choice::Touch => Rule::Absent,
            Choice::Rest if z(k, 2) > S::ZERO && z(k, 0) > z(k, 1) => Rule::Slips(-S::ONE),
            Choice::Rest if z(k, 2) > S::ZERO => Rule::Slips(S::ONE),
            Choice::Rest | Choice::GiveWay | Choice::Across => Rule::Holds,
        });
        Some(Settled { rules, reactions })
    }

    /// Builds the problem of these choices; `None` if an equation cannot be solved for its
    /// reaction.
    fn tableau(&self, choices: &[Choice<S>; K]) -> Option<PivotTableau<S, K>> {
        let problem = Problem::new(self, choices);
        let pair = |k: usize, pair: usize| PAIRS * k + pair;
        let rows = core::array::from_fn(|k| core::array::from_fn(|i| problem.row(k, i)));
        let columns = core::array::from_fn(|k| core::array::from_fn(|i| Variable::Z(pair(k, i))));
        let mut tableau = PivotTableau { rows, columns, cover: Variable::Cover };
        tableau.perturb();
        for k in (0..K).filter(|k| problem.is_equation(*k)) {
            let row = &tableau.rows[k][0];
            if row.slopes[k][0].abs() <= negligible() {
                return None;
            }
            tableau.exchange(pair(k, 0), Some(pair(k, 0)));
        }
        Some(tableau)
    }
}

impl<S: Scalar, const K: usize> PivotTableau<S, K> {
    /// Increases the values of rows with a sign by a small amount.
    fn perturb(&mut self) {
        let rows = self.rows.iter().flatten();
        let size = rows.fold(S::ZERO, |size, row| size.max(row.value.abs()));
        let golden = S::from_f64(0.618_033_988_749_894_9);
        let mut part = S::ZERO;
        for row in self.rows.iter_mut().flatten().filter(|row| row.has_sign) {
            part = part + golden;
            part = if part > S::ONE { part - S::ONE } else { part };
            row.value = row.value + negligible::<S>() * size * (S::ONE + part);
        }
    }
}

/// Builds the rows of the original problem.
struct Problem<'a, S, const N: usize, const K: usize> {
    balance: &'a Balance<'a, S, N, K>,
    choices: &'a [Choice<S>; K],
    units: [S; K],
}

impl<'a, S: Scalar, const N: usize, const K: usize> Problem<'a, S, N, K> {
    fn new(balance: &'a Balance<'a, S, N, K>, choices: &'a [Choice<S>; K]) -> Self {
        Problem { balance, choices, units: balance.units() }
    }

    /// True if reaction k is friction that is known to slip.
    fn is_equation(&self, k: usize) -> bool {
        matches!(self.choices[k], Choice::Only(Rule::Slips(_) | Rule::Smooth))
    }

    /// Returns w of a pair as a function of all z.
    fn row(&self, k: usize, pair: usize) -> Row<S, K> {
        let zero = Row {
            variable: Variable::W(PAIRS * k + pair),
            value: S::ZERO,
            slopes: [[S::ZERO; PAIRS]; K],
            cover: S::ZERO,
            has_sign: false,
        };
        match (self.choices[k], pair) {
            (Choice::Only(Rule::Smooth), 0) => self.slipping(zero, k, S::ONE),
            (Choice::Only(Rule::Slips(component)), 0) => self.slipping(zero, k, component),
            (Choice::Touch, 0) => self.rate(zero, k, S::ONE),
            (Choice::Rest, 0 | 1) => {
                let mut row = self.rate(zero, k, if pair == 0 { S::ONE } else { -S::ONE });
                row.slopes[k][2] = S::ONE;
                row
            }
            (Choice::Rest, _) => {
                let mut row = self.limit(Row { cover: S::ONE, has_sign: true, ..zero }, k, S::ONE);
                for side in 0..2 {
                    row.slopes[k][side] = row.slopes[k][side] - S::ONE;
                }
                row
            }
            _ => zero,
        }
    }

    /// Returns the row of 0 = r + sign·limit.
    fn slipping(&self, row: Row<S, K>, k: usize, sign: S) -> Row<S, K> {
        let mut row = self.limit(row, k, sign);
        row.slopes[k][0] = row.slopes[k][0] + S::ONE;
        row
    }

    /// Returns the row of sign·rate.
    fn rate(&self, row: Row<S, K>, k: usize, sign: S) -> Row<S, K> {
        let mut row = Row {
            value: sign * self.balance.offset(k) / self.units[k],
            cover: S::ONE,
            has_sign: true,
            ..row
        };
        for j in 0..K {
            let slope = sign * self.balance.entry(k, j) / (self.units[k] * self.units[j]);
            self.add(&mut row, j, slope);
        }
        row
    }

    /// Returns a row and sign·limit, with the sign changed if it is negative without reactions.
    fn limit(&self, mut row: Row<S, K>, k: usize, sign: S) -> Row<S, K> {
        let law = self.balance.law();
        let free = law.kinetic(k);
        let is_reversed = free < S::ZERO && self.choices[k] != Choice::Only(Rule::Smooth);
        let sign = if is_reversed { -sign } else { sign };
        row.value = sign * free * self.units[k];
        for &LimitSlope { reaction, kinetic, .. } in law.slopes(k) {
            self.add(&mut row, reaction, sign * kinetic * self.units[k] / self.units[reaction]);
        }
        row
    }

    /// Adds a dependence on reaction j to a row.
    fn add(&self, row: &mut Row<S, K>, j: usize, slope: S) {
        match self.choices[j] {
            Choice::Only(Rule::Absent | Rule::Holds) | Choice::GiveWay | Choice::Across => {}
            Choice::Only(_) | Choice::Touch => row.slopes[j][0] = row.slopes[j][0] + slope,
            Choice::Rest => {
                row.slopes[j][0] = row.slopes[j][0] + slope;
                row.slopes[j][1] = row.slopes[j][1] - slope;
            }
        }
    }
}
