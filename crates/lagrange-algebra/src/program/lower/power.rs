//! Powers of factors in the numerator and denominator of a fraction.

use super::lowering::{Lowering, Signed};
use super::sharing::Reciprocal;
use crate::program::{Op, ValueId, Variability};
use lagrange_expr::expr::{ExprId, Function};
use lagrange_expr::number::Number;

/// Largest unrolled power. Larger ones use a loop: unrolled code would be long and no faster.
const LARGEST_UNROLLED_POWER: i32 = 64;

/// True if a power is written as a product of the base and its square root instead of a call.
pub fn is_written_out(exponent: &Number) -> bool {
    halves(exponent).is_some() || exponent.is_integer()
}

/// Returns twice the exponent of a power that is written out.
fn halves(exponent: &Number) -> Option<i32> {
    (exponent * &Number::TWO).to_i32().filter(|twice| twice.abs() / 2 <= LARGEST_UNROLLED_POWER)
}

/// The factors of a product in the numerator and denominator.
#[derive(Default)]
pub(super) struct Fraction {
    pub(super) above: Vec<(Variability, ValueId)>,
    pub(super) below: Vec<ValueId>,
    /// True if part of the denominator changes in the motion.
    pub(super) divides_by_moving: bool,
}

/// Lowers `base ^ exponent`.
pub(super) fn lower_power(lowering: &mut Lowering<'_>, base: ExprId, exponent: &Number) -> Signed {
    let mut fraction = Fraction::default();
    let negative = push_factor(lowering, &mut fraction, base, exponent);
    let one = lowering.builder.constant(Number::ONE);
    let above = multiply_all(lowering, one, fraction.above.into_iter().map(|(_, value)| value));
    let value =
        fraction.below.into_iter().fold(above, |value, divisor| lowering.builder.divide(value, divisor));
    Signed { value, negative }
}

/// Adds a factor; true if a minus sign remains.
pub(super) fn push_factor(
    lowering: &mut Lowering<'_>,
    fraction: &mut Fraction,
    base: ExprId,
    exponent: &Number,
) -> bool {
    let variability = Variability::of_expression(lowering.graph, base);
    let Signed { value, negative } = match exponent.is_integer() {
        true => lowering.signed(base),
        false => Signed::positive(lowering.plain(base)),
    };
    let negative = negative && !exponent.is_even();
    let Some(twice) = halves(exponent) else {
        let power = long_power(lowering, value, exponent);
        fraction.above.push((variability, power));
        return negative;
    };
    let reciprocal = Reciprocal { base, of_root: twice % 2 != 0 };
    if twice < 0 && lowering.sharing.shares_reciprocal(reciprocal) {
        let power = power_of_reciprocal(lowering, value, -twice);
        fraction.above.push((variability, power));
    } else if twice < 0 {
        let powers = powers(lowering, value, -twice);
        fraction.below.extend(powers);
        fraction.divides_by_moving |= variability > Variability::Input;
    } else {
        let powers = powers(lowering, value, twice);
        fraction.above.extend(powers.map(|power| (variability, power)));
    }
    negative
}

/// Returns the factors of `base ^ (twice / 2)`: an integer power and a square root, or one of them.
fn powers(lowering: &mut Lowering<'_>, base: ValueId, twice: i32) -> impl Iterator<Item = ValueId> + use<> {
    let whole = (twice >= 2).then(|| integer_power(lowering, base, twice / 2));
    let root = (twice % 2 != 0).then(|| lowering.builder.call(Function::Sqrt, &[base]));
    whole.into_iter().chain(root)
}

/// Lowers `base ^ (-twice / 2)` to a power of `1 / base` or, for an odd number, of `1 / √base`.
fn power_of_reciprocal(lowering: &mut Lowering<'_>, base: ValueId, twice: i32) -> ValueId {
    let one = lowering.builder.constant(Number::ONE);
    if twice % 2 == 0 {
        let reciprocal = lowering.builder.divide(one, base);
        return integer_power(lowering, reciprocal, twice / 2);
    }
    let root = lowering.builder.call(Function::Sqrt, &[base]);
    let reciprocal = lowering.builder.divide(one, root);
    integer_power(lowering, reciprocal, twice)
}

/// Lowers a power by repeated squaring, so that powers of the same base share its squares.
fn integer_power(lowering: &mut Lowering<'_>, base: ValueId, exponent: i32) -> ValueId {
    let mut square = base;
    let mut power = None;
    let mut remaining = exponent;
    loop {
        if remaining % 2 != 0 {
            power = Some(power.map_or(square, |lower| lowering.builder.multiply(square, lower)));
        }
        remaining /= 2;
        if remaining == 0 {
            return power.unwrap_or(square);
        }
        square = lowering.builder.multiply(square, square);
    }
}

fn long_power(lowering: &mut Lowering<'_>, base: ValueId, exponent: &Number) -> ValueId {
    if let Some(exponent) = exponent.to_i32() {
        return lowering.builder.push(Op::Power(base, exponent));
    }
    let exponent = lowering.builder.constant(exponent.clone());
    lowering.builder.call(Function::Power, &[base, exponent])
}

pub(super) fn multiply_all(
    lowering: &mut Lowering<'_>,
    first: ValueId,
    rest: impl Iterator<Item = ValueId>,
) -> ValueId {
    rest.fold(first, |product, factor| lowering.builder.multiply(product, factor))
}
