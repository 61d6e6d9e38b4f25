//! Functions of [`Double`]. Zeros, infinities and NaN follow IEEE 754; all other values are
//! computed by wide numbers.

use lagrange_runtime::Number;

use crate::double::Double;
use crate::elementary::{angle, exp, ln, ln_near_one, sin_cos, sinh_cosh};
use crate::exact::{ordered_sum, product};
use crate::reduction::reduced;
use crate::wide::Wide;

/// Beyond this power of e every result overflows or underflows.
const LARGEST_POWER: f64 = 800.0;
/// Above this magnitude the hyperbolic tangent is one.
const TANH_IS_ONE: f64 = 40.0;
/// Range of squares for which the square of the root and its error are exact.
const PLAIN_ROOTS: core::ops::Range<f64> = 1e-280..1e300;

impl Double {
    /// Returns the exact value of a finite number, or its leading 192 bits.
    pub(crate) fn wide(self) -> Wide {
        Wide::of(self.upper).plus(Wide::of(self.lower))
    }

    pub(crate) fn is_nan(self) -> bool {
        self.upper.is_nan() || self.lower.is_nan()
    }

    pub(crate) fn is_negative(self) -> bool {
        self.upper.is_sign_negative()
    }

    /// Returns the number with this sign.
    fn signed(self, is_negative: bool) -> Double {
        if self.is_negative() == is_negative { self } else { -self }
    }

    /// Computes a function that is the identity at zero, and undefined or infinite at infinity.
    fn odd(self, at_infinity: Double, function: impl FnOnce(Wide) -> Wide) -> Double {
        if self.is_nan() || self.upper == 0.0 {
            return self;
        }
        if self.upper.is_infinite() {
            return at_infinity.signed(self.is_negative());
        }
        function(self.wide()).to_double()
    }

    pub(crate) fn sine_and_cosine(self) -> (Wide, Wide) {
        let (quadrant, rest) = reduced(self);
        let (sine, cosine) = sin_cos(rest);
        match quadrant {
            0 => (sine, cosine),
            1 => (cosine, sine.negated()),
            2 => (sine.negated(), cosine.negated()),
            _ => (cosine.negated(), sine),
        }
    }

    pub(crate) fn tangent(self) -> Double {
        self.odd(Double::NAN, |_| {
            let (sine, cosine) = self.sine_and_cosine();
            sine.divided_by(cosine)
        })
    }

    /// Computes 1 − x and 1 + x without rounding.
    fn distances_from_ends(self) -> (Wide, Wide) {
        let (upper, lower) = (Wide::of(self.upper), Wide::of(self.lower));
        (Wide::ONE.minus(upper).minus(lower), Wide::ONE.plus(upper).plus(lower))
    }

    /// Computes √(1 − x²) for a magnitude of at most one.
    fn other_leg(self) -> Wide {
        let (below, above) = self.distances_from_ends();
        below.times(above).root()
    }

    pub(crate) fn arcsine(self) -> Double {
        if Double::ONE < self.abs() {
            return Double::NAN;
        }
        self.odd(Double::NAN, |x| {
            let angle = angle(x.magnitude(), self.other_leg());
            Wide { is_negative: x.is_negative, ..angle }
        })
    }

    pub(crate) fn arccosine(self) -> Double {
        if self.is_nan() || Double::ONE < self.abs() {
            return Double::NAN;
        }
        angle(self.other_leg(), self.wide()).to_double()
    }

    pub(crate) fn angle_with(self, abscissa: Double) -> Double {
        if self.is_nan() || abscissa.is_nan() {
            return Double::NAN;
        }
        let finite = |x: Double| if x.upper.is_infinite() { Wide::ONE } else { x.wide() };
        let (ordinate, across) = match (self.upper.is_infinite(), abscissa.upper.is_infinite()) {
            (true, false) => (Wide::ONE, Wide::ZERO),
            (false, true) => (Wide::ZERO, Wide::ONE),
            _ => (finite(self).magnitude(), finite(abscissa).magnitude()),
        };
        let across = if abscissa.is_negative() { across.negated() } else { across };
        let angle = if ordinate.is_zero() {
            if abscissa.is_negative() { Wide::PI } else { Wide::ZERO }
        } else {
            angle(ordinate, across)
        };
        angle.to_double().signed(self.is_negative())
    }

    pub(crate) fn hyperbolic_sine(self) -> Double {
        let infinity = Double::of(f64::INFINITY);
        if self.upper.abs() > LARGEST_POWER {
            return infinity.signed(self.is_negative());
        }
        self.odd(infinity, |x| sinh_cosh(x).0)
    }

    pub(crate) fn hyperbolic_cosine(self) -> Double {
        if self.is_nan() {
            return Double::NAN;
        }
        if self.upper.abs() > LARGEST_POWER {
            return Double::of(f64::INFINITY);
        }
        sinh_cosh(self.wide()).1.to_double()
    }

    pub(crate) fn hyperbolic_tangent(self) -> Double {
        if self.upper.abs() > TANH_IS_ONE {
            return Double::ONE.signed(self.is_negative());
        }
        self.odd(Double::ONE, |x| {
            let (sine, cosine) = sinh_cosh(x);
            sine.divided_by(cosine)
        })
    }

    pub(crate) fn exponential(self) -> Double {
        if self.is_nan() {
            return Double::NAN;
        }
        if self.upper.abs() > LARGEST_POWER {
            return if self.is_negative() { Double::ZERO } else { Double::of(f64::INFINITY) };
        }
        exp(self.wide()).to_double()
    }

    /// Computes the logarithm of a positive finite number.
    fn wide_logarithm(self) -> Wide {
        let above_one = Wide::of(self.upper).minus(Wide::ONE).plus(Wide::of(self.lower));
        if above_one.exponent < -1 { ln_near_one(above_one) } else { ln(self.wide()) }
    }

    pub(crate) fn logarithm(self) -> Double {
        if self.is_nan() || self.upper < 0.0 {
            return Double::NAN;
        }
        if self.upper == 0.0 {
            return Double::of(f64::NEG_INFINITY);
        }
        if self.upper.is_infinite() { self } else { self.wide_logarithm().to_double() }
    }

    pub(crate) fn root(self) -> Double {
        if self.upper == 0.0 || self.upper == f64::INFINITY {
            return self;
        }
        if self.is_nan() || self.upper < 0.0 {
            return Double::NAN;
        }
        if !PLAIN_ROOTS.contains(&self.upper) {
            return self.wide().root().to_double();
        }
        let root = Number::sqrt(self.upper);
        let (square, error) = product(root, root);
        let rest = (self.upper - square) - error + self.lower;
        let (upper, lower) = ordered_sum(root, rest / (2.0 * root));
        Double { upper, lower }
    }

    pub(crate) fn length_with(self, other: Double) -> Double {
        if self.upper.is_infinite() || other.upper.is_infinite() {
            return Double::of(f64::INFINITY);
        }
        if self.is_nan() || other.is_nan() {
            return Double::NAN;
        }
        let (x, y) = (self.wide(), other.wide());
        x.times(x).plus(y.times(y)).root().to_double()
    }

    pub(crate) fn power(self, exponent: Double) -> Double {
        if self.is_nan() || exponent.is_nan() {
            return Double::NAN;
        }
        let is_plain = self.upper != 0.0 && self.upper.is_finite() && exponent.upper.is_finite();
        let magnitude = self.abs();
        if !is_plain || exponent.upper == 0.0 || magnitude == Double::ONE {
            return self.power_at_the_edge(magnitude, exponent);
        }
        if self.is_negative() && !exponent.is_integer() {
            return Double::NAN;
        }
        let logarithm = exponent.wide().times(magnitude.wide_logarithm());
        let power = if logarithm.exponent > 10 {
            if logarithm.is_negative { Double::ZERO } else { Double::of(f64::INFINITY) }
        } else {
            exp(logarithm).to_double()
        };
        power.signed(self.is_negative() && exponent.is_odd())
    }

    /// Computes powers with zeros, ones and infinities.
    fn power_at_the_edge(self, magnitude: Double, exponent: Double) -> Double {
        let is_defined = !self.is_negative() || self.upper == 0.0 || self.upper.is_infinite();
        if !is_defined && !exponent.is_integer() && exponent.upper.is_finite() {
            return Double::NAN;
        }
        let power = match (magnitude < Double::ONE, exponent.upper) {
            _ if exponent.upper == 0.0 || magnitude == Double::ONE => 1.0,
            (true, y) if y > 0.0 => 0.0,
            (false, y) if y < 0.0 => 0.0,
            _ => f64::INFINITY,
        };
        Double::of(power).signed(self.is_negative() && exponent.is_odd())
    }

    fn is_integer(self) -> bool {
        is_integer(self.upper) && is_integer(self.lower)
    }

    fn is_odd(self) -> bool {
        self.is_integer() && is_odd(self.upper) != is_odd(self.lower)
    }
}

/// Doubles of at least this magnitude are whole, and even from twice this magnitude on.
const ALL_WHOLE: f64 = 4_503_599_627_370_496.0;

fn is_integer(x: f64) -> bool {
    x.is_finite() && (x.abs() >= ALL_WHOLE || x as i64 as f64 == x)
}

fn is_odd(x: f64) -> bool {
    x.abs() < 2.0 * ALL_WHOLE && x as i64 & 1 == 1
}
