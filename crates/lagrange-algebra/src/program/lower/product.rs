//! Products: numerators are multiplied, then divided once by the product of the denominators.

use super::interleaved::{lower_interleaved, needs_interleaving};
use super::lowering::{Lowering, Signed};
use super::power::{Fraction, multiply_all, push_factor};
use crate::program::{ValueId, Variability};
use lagrange_expr::expr::ExprId;
use lagrange_expr::number::Number;

/// Lowers `coefficient · product`.
pub(super) fn lower_product(lowering: &mut Lowering<'_>, coefficient: &Number, product: ExprId) -> Signed {
    let mut fraction = Fraction::default();
    let mut negative = false;
    let factors = lowering.sharing.factors(lowering.graph, product);
    if needs_interleaving(lowering, &factors) {
        return lower_interleaved(lowering, coefficient, &factors);
    }
    for (base, exponent) in factors {
        negative ^= push_factor(lowering, &mut fraction, base, &exponent);
    }
    // Factors that change less often are multiplied first, since their product is more likely to
    // occur elsewhere.
    fraction.above.sort_by_key(|(variability, _)| *variability);
    let is_sign = coefficient.abs().is_one();
    let scale = match (is_sign, negative) {
        (true, _) => Number::ONE,
        (false, true) => -coefficient,
        (false, false) => coefficient.clone(),
    };
    let scale = lowering.builder.constant(scale);
    let (constants, others): (Vec<_>, Vec<_>) =
        fraction.above.into_iter().partition(|(_, value)| lowering.builder.op(*value).is_constant());
    // Moving factors need not wait for a division by constant ones.
    let moves = |(variability, _): &(Variability, ValueId)| *variability > Variability::Input;
    let late = others.iter().position(moves).filter(|_| !fraction.divides_by_moving);
    let (early, late) = others.split_at(late.unwrap_or(others.len()));
    let value_of = |(_, value): &(Variability, ValueId)| *value;
    // A factor of one folds away in the first multiplication.
    let above = multiply_all(lowering, scale, constants.iter().chain(early).map(value_of));
    let value = match fraction.below.split_first() {
        Some((&first, rest)) => {
            let below = multiply_all(lowering, first, rest.iter().copied());
            lowering.builder.divide(above, below)
        }
        None => above,
    };
    let value = multiply_all(lowering, value, late.iter().map(value_of));
    Signed { value, negative: is_sign && negative != coefficient.is_negative() }
}
