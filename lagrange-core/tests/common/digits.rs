//! Real numbers with any number of bits, and elementary functions of them.

use astro_float_num::{BigFloat, Consts, Radix, RoundingMode, WORD_BIT_SIZE};
use lagrange_core::expr::Function;
use lagrange_core::number::Number;

pub(crate) use astro_float_num::BigFloat as Real;

/// Results need not be correctly rounded: the precision is chosen large enough that rounding is
/// negligible.
const ROUNDING: RoundingMode = RoundingMode::None;

/// Arithmetic with a given number of bits.
pub(crate) struct Arithmetic {
    bits: usize,
    constants: Consts,
}

impl Arithmetic {
    pub(crate) fn new(bits: usize) -> Arithmetic {
        Arithmetic { bits, constants: Consts::new().expect("memory for constants") }
    }

    pub(crate) fn float(&self, value: f64) -> Real {
        if !value.is_subnormal() {
            return BigFloat::from_f64(value, self.bits);
        }
        // `from_f64` of version 0.3.7 halves subnormal numbers.
        let lift = 64.0_f64.exp2();
        let lifted = BigFloat::from_f64(value * lift, self.bits);
        self.divide(&lifted, &BigFloat::from_f64(lift, self.bits))
    }

    pub(crate) fn integer(&self, value: i32) -> Real {
        BigFloat::from_i32(value, self.bits)
    }

    /// Returns the value of a decimal such as `-2.5e-3`.
    pub(crate) fn decimal(&mut self, text: &str) -> Real {
        BigFloat::parse(text, Radix::Dec, self.bits, ROUNDING, &mut self.constants)
    }

    pub(crate) fn number(&mut self, value: &Number) -> Real {
        if let Some(value) = value.to_i32() {
            return self.integer(value);
        }
        let text = value.to_string();
        let (numerator, denominator) = text.split_once('/').unwrap_or((&text, "1"));
        let [numerator, denominator] = [numerator, denominator].map(|digits| self.decimal(digits));
        self.divide(&numerator, &denominator)
    }

    pub(crate) fn add(&self, a: &Real, b: &Real) -> Real {
        a.add(b, self.bits, ROUNDING)
    }

    pub(crate) fn subtract(&self, a: &Real, b: &Real) -> Real {
        a.sub(b, self.bits, ROUNDING)
    }

    pub(crate) fn multiply(&self, a: &Real, b: &Real) -> Real {
        a.mul(b, self.bits, ROUNDING)
    }

    pub(crate) fn divide(&self, a: &Real, b: &Real) -> Real {
        a.div(b, self.bits, ROUNDING)
    }

    pub(crate) fn sqrt(&self, a: &Real) -> Real {
        a.sqrt(self.bits, ROUNDING)
    }

    /// Returns Σ aᵢ bᵢ.
    pub(crate) fn dot(&self, a: &[Real], b: &[Real]) -> Real {
        let products = a.iter().zip(b).map(|(a, b)| self.multiply(a, b));
        products.fold(self.integer(0), |sum, product| self.add(&sum, &product))
    }

    pub(crate) fn pi(&mut self) -> Real {
        self.constants.pi(self.bits, ROUNDING)
    }

    /// Returns a rational power of a base that is positive unless the power is whole.
    pub(crate) fn power(&mut self, base: &Real, exponent: &Number) -> Real {
        let twice = (exponent * &Number::TWO).to_i32();
        let magnitude = match (exponent.to_i32(), twice) {
            (Some(1), _) => return base.clone(),
            (Some(n), _) => base.powi(n.unsigned_abs() as usize, self.bits, ROUNDING),
            (_, Some(n)) => self.sqrt(base).powi(n.unsigned_abs() as usize, self.bits, ROUNDING),
            _ => {
                let exponent = self.number(&exponent.abs());
                base.pow(&exponent, self.bits, ROUNDING, &mut self.constants)
            }
        };
        if exponent.is_negative() { self.divide(&self.integer(1), &magnitude) } else { magnitude }
    }

    /// Returns the value of an elementary function.
    pub(crate) fn call(&mut self, function: Function, arguments: &[Real]) -> Real {
        let (x, bits, constants) = (&arguments[0], self.bits, &mut self.constants);
        let second = || &arguments[1];
        match function {
            Function::Sin => x.sin(bits, ROUNDING, constants),
            Function::Cos => x.cos(bits, ROUNDING, constants),
            Function::Tan => x.tan(bits, ROUNDING, constants),
            Function::Asin => x.asin(bits, ROUNDING, constants),
            Function::Acos => x.acos(bits, ROUNDING, constants),
            Function::Atan => x.atan(bits, ROUNDING, constants),
            Function::Atan2 => self.atan2(x, second()),
            Function::Sinh => x.sinh(bits, ROUNDING, constants),
            Function::Cosh => x.cosh(bits, ROUNDING, constants),
            Function::Tanh => x.tanh(bits, ROUNDING, constants),
            Function::Exp => x.exp(bits, ROUNDING, constants),
            Function::Ln => x.ln(bits, ROUNDING, constants),
            Function::Sqrt => self.sqrt(x),
            Function::Abs => x.abs(),
            Function::Sign | Function::MagnitudeSlope if x.is_zero() => self.integer(0),
            Function::Sign | Function::MagnitudeSlope => x.signum(),
            Function::Min => x.min(second()),
            Function::Max => x.max(second()),
            Function::Power => x.pow(second(), bits, ROUNDING, constants),
            Function::Hypot => self.sqrt(&self.dot(arguments, arguments)),
        }
    }

    /// Returns the angle of (x, y). In the left half-plane it is that of the opposite vector,
    /// turned by half a turn.
    fn atan2(&mut self, y: &Real, x: &Real) -> Real {
        let half_turn = self.constants.pi(self.bits, ROUNDING);
        if x.is_zero() {
            let quarter = self.divide(&half_turn, &self.integer(2));
            return if y.is_negative() { quarter.neg() } else { quarter };
        }
        let angle = self.divide(y, x).atan(self.bits, ROUNDING, &mut self.constants);
        match (x.is_negative(), y.is_negative()) {
            (false, _) => angle,
            (true, false) => self.add(&angle, &half_turn),
            (true, true) => self.subtract(&angle, &half_turn),
        }
    }
}

/// Returns a number within rounding of the nearest `f64`, good enough for judging errors.
pub(crate) fn approximate(value: &Real) -> f64 {
    if value.is_zero() {
        return 0.0;
    }
    let (Some([.., top]), Some(exponent), Some(sign)) =
        (value.mantissa_digits(), value.exponent(), value.sign())
    else {
        return if value.is_nan() { f64::NAN } else { f64::INFINITY };
    };
    // In two steps, since the power alone may overflow.
    let halves = [exponent / 2, exponent - exponent / 2].map(|half| f64::from(half).exp2());
    let fraction = *top as f64 / f64::from(WORD_BIT_SIZE as u32).exp2();
    f64::from(sign.to_int()) * fraction * halves[0] * halves[1]
}

#[test]
fn elementary_functions_agree_with_those_of_the_platform() {
    use lagrange_core::elementary::ROWS;
    let mut arithmetic = Arithmetic::new(512);
    for row in &ROWS {
        for arguments in [[0.4, 0.7], [0.9, -2.0], [-0.6, 0.3], [-0.2, -1.5], [1e-9, 40.0], [0.0, 2.0]] {
            let expected = (row.value)(&arguments[..row.arity]);
            if !expected.is_finite() {
                continue;
            }
            let reals = arguments.map(|argument| arithmetic.float(argument));
            let found = approximate(&arithmetic.call(row.function, &reals[..row.arity]));
            let error = (found - expected).abs();
            assert!(error <= 4.0 * f64::EPSILON * expected.abs(), "{} of {arguments:?}: {found}", row.name);
        }
    }
}

#[test]
fn reals_begin_as_exact_floats_and_come_back() {
    let arithmetic = Arithmetic::new(256);
    for value in [1.0, -0.1, 9.81, 1e300, -1e-300, 5e-324, 0.0, f64::MAX] {
        assert_eq!(approximate(&arithmetic.float(value)), value);
    }
}
