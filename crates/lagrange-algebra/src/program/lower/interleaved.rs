//! Products of several masses and their quotients, with interleaved multiplications and divisions.
//!
//! m₁ m₂/D is a mass, as each of the three is. However, m₁ m₂ may leave the range of floating-point
//! numbers for very small or very large masses. If [grades](crate::calculus::Grades) are known,
//! (m₁/D) m₂ is therefore computed.

use super::lowering::{Lowering, Signed};
use super::power::lower_power;
use super::sharing::Reciprocal;
use crate::program::ValueId;
use lagrange_expr::expr::ExprId;
use lagrange_expr::number::Number;

/// Maximum power that is split into factors.
const MAX_UNITS: i32 = 8;

/// A value with its grade.
type Graded = (ValueId, Number);

/// True if an intermediate value is not a mass when numerators are multiplied first and divided
/// once.
pub(super) fn needs_interleaving(lowering: &Lowering<'_>, factors: &[(ExprId, Number)]) -> bool {
    if !lowering.graph.is_graded() {
        return false;
    }
    let mut parts = [Number::ZERO, Number::ZERO];
    for (base, exponent) in factors {
        let grade = &lowering.grades.grade(*base) * exponent;
        let part = &mut parts[usize::from(grade.is_negative())];
        *part = &*part + &grade;
    }
    let largest = (&parts[0] + &parts[1]).abs().max(Number::ONE);
    let has_both = factors.iter().any(|(_, exponent)| exponent.is_negative());
    has_both && parts.iter().any(|part| part.abs() > largest)
}

/// Lowers `coefficient · Π base ^ exponent` so that no intermediate value is a higher power of
/// masses than the result.
pub(super) fn lower_interleaved(
    lowering: &mut Lowering<'_>,
    coefficient: &Number,
    factors: &[(ExprId, Number)],
) -> Signed {
    let (mut above, mut below, mut negative) = (Vec::new(), Vec::new(), false);
    for (base, exponent) in factors {
        negative ^= push_units(lowering, (&mut above, &mut below), *base, exponent);
    }
    let is_sign = coefficient.abs().is_one();
    let scale = match (is_sign, negative) {
        (true, _) => Number::ONE,
        (false, true) => -coefficient,
        (false, false) => coefficient.clone(),
    };
    let scale = lowering.builder.constant(scale);
    let value = in_turn(lowering, scale, above, below);
    Signed { value, negative: is_sign && negative != coefficient.is_negative() }
}

/// Multiplies and divides in an order that keeps intermediate grades as close to zero as possible.
fn in_turn(
    lowering: &mut Lowering<'_>,
    scale: ValueId,
    mut above: Vec<Graded>,
    mut below: Vec<Graded>,
) -> ValueId {
    // Factors without a grade are more likely to occur elsewhere.
    above.sort_by_key(|(_, grade)| !grade.is_zero());
    let (mut value, mut grade) = (scale, Number::ZERO);
    while !(above.is_empty() && below.is_empty()) {
        let size_with = |change: &Number| (&grade + change).abs();
        let fits = |(_, change): &Graded| size_with(change) <= Number::ONE;
        let fits_below = |(_, change): &Graded| size_with(&-change) <= Number::ONE;
        if let Some(place) = above.iter().position(fits).or((below.is_empty()).then_some(0)) {
            let (factor, change) = above.remove(place);
            value = lowering.builder.multiply(value, factor);
            grade = &grade + &change;
            continue;
        }
        let place = below.iter().position(fits_below).unwrap_or(0);
        let (divisor, change) = below.remove(place);
        value = lowering.builder.divide(value, divisor);
        grade = &grade + &-&change;
    }
    value
}

/// Adds a power as repeated factors; true if a minus sign remains.
fn push_units(
    lowering: &mut Lowering<'_>,
    (above, below): (&mut Vec<Graded>, &mut Vec<Graded>),
    base: ExprId,
    exponent: &Number,
) -> bool {
    let grade = lowering.grades.grade(base);
    let units = exponent.abs().to_i32().filter(|units| *units <= MAX_UNITS);
    let Some(units) = units.filter(|_| exponent.is_integer() && !grade.is_zero()) else {
        let Signed { value, negative } = lower_power(lowering, base, exponent);
        above.push((value, &grade * exponent));
        return negative;
    };
    let Signed { value, negative } = lowering.signed(base);
    let is_shared = lowering.sharing.shares_reciprocal(Reciprocal { base, of_root: false });
    for _ in 0..units {
        match (exponent.is_negative(), is_shared) {
            (false, _) => above.push((value, grade.clone())),
            (true, false) => below.push((value, grade.clone())),
            (true, true) => {
                let one = lowering.builder.constant(Number::ONE);
                above.push((lowering.builder.divide(one, value), -&grade));
            }
        }
    }
    negative && units % 2 != 0
}
