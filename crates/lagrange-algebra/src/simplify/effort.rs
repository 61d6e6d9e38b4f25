//! Limits of multiplying out: how long a result may be, and how much may be made on the way to it.

use super::polynomial::Polynomial;

/// Number of monomials that may be made on the way for each one allowed in a result. What cancels
/// is made first, so that the way is longer than the result; without a bound nested products would
/// make exponentially many.
const EFFORT_PER_MONOMIAL: usize = 50;

/// Number of ways of reading a term as a side of a rule that may be tried for each monomial allowed
/// in a result. Where frames are skew, a term is read in dozens of ways, and rules are applied
/// again wherever one of them matched.
const READINGS_PER_MONOMIAL: usize = 50;

/// Monomials that may be in a result, those that may still be made, and ways of reading terms that
/// may still be tried.
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

    /// Returns the effort of another attempt, with the readings that are left.
    pub(super) fn again(&self) -> Effort {
        Effort { readings: self.readings, ..Effort::new(self.budget) }
    }

    /// Uses up ways of reading a term; `None` when too few are left.
    pub(super) fn read(&mut self, readings: usize) -> Option<()> {
        self.readings = self.readings.checked_sub(readings)?;
        Some(())
    }

    /// Uses up a part of the effort; `None` when there is not enough left.
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
