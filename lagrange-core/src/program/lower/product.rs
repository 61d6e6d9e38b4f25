//! Products: numerators multiplied, divided once by the product of the denominators.

use super::sharing::Reciprocal;
use super::{Lowering, Signed};
use crate::expr::{ExprId, Function};
use crate::number::Number;
use crate::program::{Op, ValueId, Variability};

/// Powers above this are left to a loop: written out they would be long and no faster.
const LARGEST_UNROLLED_POWER: i32 = 64;

/// The factors of a product above and below the line.
#[derive(Default)]
struct Fraction {
    above: Vec<(Variability, ValueId)>,
    below: Vec<ValueId>,
    /// Whether something below changes in the motion.
    divides_by_moving: bool,
}

impl Lowering<'_> {
    /// `coefficient · product`
    pub(super) fn product(&mut self, coefficient: &Number, product: ExprId) -> Signed {
        let mut fraction = Fraction::default();
        let mut negative = false;
        for (base, exponent) in self.sharing.factors(self.graph, product) {
            negative ^= self.push_factor(&mut fraction, base, &exponent);
        }
        // What changes less often is multiplied first: its product is more likely to occur elsewhere.
        fraction.above.sort_by_key(|(variability, _)| *variability);
        let is_sign = coefficient.abs().is_one();
        let scale = match (is_sign, negative) {
            (true, _) => Number::ONE,
            (false, true) => -coefficient,
            (false, false) => coefficient.clone(),
        };
        let scale = self.builder.constant(scale);
        let (constants, others): (Vec<_>, Vec<_>) =
            fraction.above.into_iter().partition(|(_, value)| self.builder.op(*value).is_constant());
        // What moves need not wait for a division by what does not.
        let moves = |(variability, _): &(Variability, ValueId)| *variability > Variability::Input;
        let late = others.iter().position(moves).filter(|_| !fraction.divides_by_moving);
        let (early, late) = others.split_at(late.unwrap_or(others.len()));
        let value_of = |(_, value): &(Variability, ValueId)| *value;
        // One folds away as soon as anything is multiplied by it.
        let above = self.multiply_all(scale, constants.iter().chain(early).map(value_of));
        let value = match fraction.below.split_first() {
            Some((&first, rest)) => {
                let below = self.multiply_all(first, rest.iter().copied());
                self.builder.divide(above, below)
            }
            None => above,
        };
        let value = self.multiply_all(value, late.iter().map(value_of));
        Signed { value, negative: is_sign && negative != coefficient.is_negative() }
    }

    fn multiply_all(&mut self, first: ValueId, rest: impl Iterator<Item = ValueId>) -> ValueId {
        rest.fold(first, |product, factor| self.builder.multiply(product, factor))
    }

    /// Adds a factor and returns whether it leaves a minus sign behind.
    fn push_factor(&mut self, fraction: &mut Fraction, base: ExprId, exponent: &Number) -> bool {
        let variability = Variability::of_expression(self.graph, base);
        let Signed { value, negative } = match exponent.is_integer() {
            true => self.signed(base),
            false => Signed::positive(self.plain(base)),
        };
        let negative = negative && !exponent.is_even();
        let twice =
            (exponent * &Number::TWO).to_i32().filter(|twice| twice.abs() / 2 <= LARGEST_UNROLLED_POWER);
        let Some(twice) = twice else {
            let power = self.long_power(value, exponent);
            fraction.above.push((variability, power));
            return negative;
        };
        let reciprocal = Reciprocal { base, of_root: twice % 2 != 0 };
        if twice < 0 && self.sharing.shares_reciprocal(reciprocal) {
            let power = self.power_of_reciprocal(value, -twice);
            fraction.above.push((variability, power));
        } else if twice < 0 {
            let powers = self.powers(value, -twice);
            fraction.below.extend(powers);
            fraction.divides_by_moving |= variability > Variability::Input;
        } else {
            let powers = self.powers(value, twice);
            fraction.above.extend(powers.map(|power| (variability, power)));
        }
        negative
    }

    /// What `base ^ (twice / 2)` is the product of: an integer power and a square root, or one of them.
    fn powers(&mut self, base: ValueId, twice: i32) -> impl Iterator<Item = ValueId> + use<> {
        let whole = (twice >= 2).then(|| self.integer_power(base, twice / 2));
        let root = (twice % 2 != 0).then(|| self.builder.call(Function::Sqrt, &[base]));
        whole.into_iter().chain(root)
    }

    /// `base ^ (-twice / 2)` made of `1 / base` or, for an odd number, of `1 / √base`.
    fn power_of_reciprocal(&mut self, base: ValueId, twice: i32) -> ValueId {
        let one = self.builder.constant(Number::ONE);
        if twice % 2 == 0 {
            let reciprocal = self.builder.divide(one, base);
            return self.integer_power(reciprocal, twice / 2);
        }
        let root = self.builder.call(Function::Sqrt, &[base]);
        let reciprocal = self.builder.divide(one, root);
        self.integer_power(reciprocal, twice)
    }

    /// Repeated squaring, so that powers of the same base share its squares.
    fn integer_power(&mut self, base: ValueId, exponent: i32) -> ValueId {
        let mut square = base;
        let mut power = None;
        let mut remaining = exponent;
        loop {
            if remaining % 2 != 0 {
                power = Some(power.map_or(square, |lower| self.builder.multiply(square, lower)));
            }
            remaining /= 2;
            if remaining == 0 {
                return power.unwrap_or(square);
            }
            square = self.builder.multiply(square, square);
        }
    }

    fn long_power(&mut self, base: ValueId, exponent: &Number) -> ValueId {
        if let Some(exponent) = exponent.to_i32() {
            return self.builder.push(Op::Power(base, exponent));
        }
        let exponent = self.builder.constant(exponent.clone());
        self.builder.call(Function::Power, &[base, exponent])
    }
}
