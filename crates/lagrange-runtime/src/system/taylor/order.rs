//! The order of the coefficients that a step of an expansion computes.

use crate::scalar::Number;

/// The order k + 1 of the coefficients of step k, as a number.
///
/// The reciprocals of three, five, six, … are rounded, each in the same direction in every step.
/// Products with them would change a step by about a hundredth of a rounding error, always in the
/// same sense. Energy would drift in proportion to time. The bias of quotients is ten times
/// smaller.
#[derive(Clone, Copy, Debug)]
pub struct Order<S> {
    /// k + 1
    pub number: S,
    /// 1/(k + 1)
    pub reciprocal: S,
    /// One for the first order, zero for all others.
    pub first: S,
}

impl<S: Number> Order<S> {
    /// Returns the order after `k`.
    #[inline(always)]
    #[must_use]
    pub fn after(k: usize) -> Self {
        let number = S::from_f64((k + 1) as f64);
        Order { number, reciprocal: S::ONE / number, first: if k == 0 { S::ONE } else { S::ZERO } }
    }

    /// Divides coefficients of order k by k + 1, as an integral does.
    #[inline(always)]
    #[must_use]
    pub fn divide<const N: usize>(self, coefficients: &[S; N]) -> [S; N] {
        let mut quotients = *coefficients;
        for quotient in &mut quotients {
            *quotient = *quotient / self.number;
        }
        quotients
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_count_from_one() {
        let orders = [0, 1, 39].map(Order::<f64>::after);
        assert_eq!(orders.map(|order| order.number), [1.0, 2.0, 40.0]);
        assert_eq!(orders.map(|order| order.first), [1.0, 0.0, 0.0]);
        // The quotient of 5 and 3 differs from the product with the rounded reciprocal.
        let third = Order::<f64>::after(2);
        assert_eq!(third.divide(&[5.0]), [5.0 / 3.0]);
        assert_ne!(third.divide(&[5.0]), [5.0 * third.reciprocal]);
    }
}
