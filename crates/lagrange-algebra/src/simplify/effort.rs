//! Limits of expansion: the length of results, and the number of intermediate monomials.

use super::polynomial::Polynomial;

/// Maximum number of intermediate monomials for each monomial allowed in a result. Terms that
/// cancel must first be formed, so more monomials are formed than remain. Without a bound, nested
/// products would form exponentially many.
const EFFORT_PER_MONOMIAL: usize = 50;

/// Maximum number of ways of reading a term as a side of a rule, for each monomial allowed in a
/// result. With skew frames, a term can be read in dozens of ways, and rules are applied again
/// after each match.
const READINGS_PER_MONOMIAL: usize = 50;

/// Maximum number of monomials in a result, and the remaining numbers of intermediate monomials and
/// of readings.
pub(super) struct Effort {
    budget: usize,
    left: usize,
    readings: usize,
}

impl Effort {
    pub(super) fn new(budget: usize) -> Effort {
        Effort {
            budget,
            left: budget.saturating_mul(EFFORT_PER_MONOMIAL),
            readings: budget.saturating_mul(READINGS_PER_MONOMIAL),
        }
    }

    /// Returns the effort of another attempt, with the remaining readings.
    pub(super) fn again(&self) -> Effort {
        Effort { readings: self.readings, ..Effort::new(self.budget) }
    }

    /// Consumes ways of reading a term; `None` if too few remain.
    pub(super) fn read(&mut self, readings: usize) -> Option<()> {
        self.readings = self.readings.checked_sub(readings)?;
        Some(())
    }

    /// Consumes a part of the effort; `None` if not enough remains.
    pub(super) fn spend(&mut self, monomials: usize) -> Option<()> {
        self.left = self.left.checked_sub(monomials)?;
        Some(())
    }

    pub(super) fn within_budget(&self, polynomial: Polynomial) -> Option<Polynomial> {
        (polynomial.len() <= self.budget).then_some(polynomial)
    }

    pub(super) fn times(&mut self, a: &Polynomial, b: &Polynomial) -> Option<Polynomial> {
        self.spend(a.len().saturating_mul(b.len()))?;
        self.within_budget(a.times(b))
    }
}
