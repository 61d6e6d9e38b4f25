//! Complex numbers close to the real axis, for derivatives by complex steps.

use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

use lagrange::{Number, Scalar};

/// A complex number whose imaginary part is so small that its square is negligible beside the real
/// part. Elementary functions are expanded to first order in it. Order and branches are those of
/// the real part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Complex {
    pub(crate) real: f64,
    pub(crate) imaginary: f64,
}

impl Complex {
    pub(crate) fn from_real(real: f64) -> Complex {
        Complex { real, imaginary: 0.0 }
    }

    /// Returns a function with this value and slope at the real part.
    fn lifted(self, value: f64, slope: f64) -> Complex {
        Complex { real: value, imaginary: slope * self.imaginary }
    }
}

impl PartialOrd for Complex {
    fn partial_cmp(&self, other: &Complex) -> Option<Ordering> {
        self.real.partial_cmp(&other.real)
    }
}

impl Add for Complex {
    type Output = Complex;
    fn add(self, other: Complex) -> Complex {
        Complex { real: self.real + other.real, imaginary: self.imaginary + other.imaginary }
    }
}

impl Sub for Complex {
    type Output = Complex;
    fn sub(self, other: Complex) -> Complex {
        self + -other
    }
}

impl Mul for Complex {
    type Output = Complex;
    fn mul(self, other: Complex) -> Complex {
        Complex {
            real: self.real * other.real - self.imaginary * other.imaginary,
            imaginary: self.real * other.imaginary + self.imaginary * other.real,
        }
    }
}

impl Div for Complex {
    type Output = Complex;
    fn div(self, other: Complex) -> Complex {
        let quotient = self.real / other.real;
        Complex { real: quotient, imaginary: (self.imaginary - quotient * other.imaginary) / other.real }
    }
}

impl Neg for Complex {
    type Output = Complex;
    fn neg(self) -> Complex {
        Complex { real: -self.real, imaginary: -self.imaginary }
    }
}

/// Implements functions with their slopes.
macro_rules! elementary {
    ($($name:ident: $x:ident => $slope:expr;)*) => {
        $(fn $name(self) -> Complex {
            let $x = self.real;
            self.lifted($x.$name(), $slope)
        })*
    };
}

impl Scalar for Complex {
    fn is_finite(self) -> bool {
        self.real.is_finite() && self.imaginary.is_finite()
    }
}

impl Number for Complex {
    type Mask = bool;

    const ZERO: Complex = Complex { real: 0.0, imaginary: 0.0 };
    const ONE: Complex = Complex { real: 1.0, imaginary: 0.0 };
    const NAN: Complex = Complex { real: f64::NAN, imaginary: f64::NAN };

    fn from_f64(value: f64) -> Complex {
        Complex::from_real(value)
    }

    fn less(self, other: Complex) -> bool {
        self < other
    }

    fn less_equal(self, other: Complex) -> bool {
        self <= other
    }

    fn select(mask: bool, then: Complex, otherwise: Complex) -> Complex {
        if mask { then } else { otherwise }
    }

    fn sin_cos(self) -> (Complex, Complex) {
        (self.sin(), self.cos())
    }

    elementary! {
        sin: x => x.cos();
        cos: x => -x.sin();
        tan: x => x.cos().powi(-2);
        asin: x => (1.0 - x * x).sqrt().recip();
        acos: x => -(1.0 - x * x).sqrt().recip();
        atan: x => (1.0 + x * x).recip();
        sinh: x => x.cosh();
        cosh: x => x.sinh();
        tanh: x => x.cosh().powi(-2);
        exp: x => x.exp();
        ln: x => x.recip();
        sqrt: x => 0.5 / x.sqrt();
        abs: x => x.signum();
    }

    fn atan2(self, x: Complex) -> Complex {
        let imaginary = self.imaginary * x.real - self.real * x.imaginary;
        let square = x.real * x.real + self.real * self.real;
        Complex { real: self.real.atan2(x.real), imaginary: imaginary / square }
    }

    fn hypot(self, other: Complex) -> Complex {
        (self * self + other * other).sqrt()
    }

    fn powf(self, exponent: Complex) -> Complex {
        let (x, e) = (self.real, exponent.real);
        let power = self.lifted(x.powf(e), e * x.powf(e - 1.0));
        match exponent.imaginary == 0.0 {
            true => power,
            false => power + exponent.lifted(0.0, x.ln() * x.powf(e)),
        }
    }
}
