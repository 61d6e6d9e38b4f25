//! The order of the coefficients that a step of an expansion computes.

use crate::scalar::Number;

/// The largest order whose coefficients are divided. Terms of higher orders are so small that the
/// rounding of the reciprocal is lost in that of the state.
const MAX_DIVIDED: usize = 8;

/// The order k + 1 of the coefficients of step k, as a number.
///
/// The reciprocals of three, five, six, … are rounded, always in the same direction. Products with
/// them would change each step by about a hundredth of a rounding error in the same sense. Energy
/// would drift in proportion to time. With quotients, it does not.
#[derive(Clone, Copy, Debug)]
pub struct Order<S> {
    /// k + 1
    pub number: S,
    /// 1/(k + 1)
    pub reciprocal: S,
    /// One for the first order, zero for all others.
    pub first: S,
    is_divided: bool,
}

impl<S: Number> Order<S> {
    /// Returns the order after `k`.
    #[inline(always)]
    #[must_use]
    pub fn after(k: usize) -> Self {
        let number = S::from_f64((k + 1) as f64);
        Order {
            number,
            reciprocal: S::ONE / number,
            first: if k == 0 { S::ONE } else { S::ZERO },
            is_divided: k < MAX_DIVIDED,
        }
    }

    /// Divides coefficients of order k by k + 1, as an integral does.
    #[inline(always)]
    #[must_use]
    pub fn divide<const N: usize>(self, coefficients: &[S; N]) -> [S; N] {
        match self.is_divided {
            true => coefficients.map(|coefficient| coefficient / self.number),
            false => coefficients.map(|coefficient| coefficient * self.reciprocal),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn integrals_of_low_orders_are_rounded_once() {
        for k in 0..MAX_DIVIDED {
            let values: [f64; 40] = core::array::from_fn(|index| index as f64 + 1.0);
            let order = Order::after(k);
            assert_eq!(order.divide(&values), values.map(|value| value / (k + 1) as f64));
        }
    }

    #[test]
    fn only_the_first_order_is_first() {
        assert_eq!([0, 1, 39].map(|k| Order::<f64>::after(k).first), [1.0, 0.0, 0.0]);
    }
}
