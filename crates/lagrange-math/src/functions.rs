//! The list of elementary functions, from which numbers, lanes, emitted code and kernels derive
//! their functions.

/// Passes the list of elementary functions to a macro, after tokens for that macro.
///
/// ```text
/// name(arguments) C(name for double, name for float) lanes(Variant: formula, domain) {
///     /// Documentation.
///     fn(parameters of the method) { default }
/// }
/// ```
///
/// The default is the body of the method for number types that do not define it, or `;` if every
/// number type must. The names in C are also those of `libm`. If there is a formula for lanes, they
/// use it to compute several numbers together. It is a function of this crate; the platform
/// computes numbers outside its domain.
#[doc(hidden)]
#[macro_export]
macro_rules! functions {
    ($then:ident $($context:tt)*) => {
        $then! {
            $($context)*

            sin(x) C(sin, sinf) lanes() {
                /// Computes the sine; NaN at infinity.
                fn(self);
            }

            cos(x) C(cos, cosf) lanes() {
                /// Computes the cosine; NaN at infinity.
                fn(self);
            }

            tan(x) C(tan, tanf) lanes(Tan: tangent::tan, is_angle) {
                /// Computes the tangent; NaN at infinity. Finite elsewhere, since no binary number
                /// is an odd multiple of π/2.
                fn(self) {
                    let (sine, cosine) = self.sin_cos();
                    sine / cosine
                }
            }

            asin(x) C(asin, asinf) lanes(Asin: arc::asin) {
                /// Computes the angle in [−π/2, π/2] with this sine; NaN outside [−1, 1].
                fn(self) {
                    self.atan2(((Self::ONE - self) * (Self::ONE + self)).sqrt())
                }
            }

            acos(x) C(acos, acosf) lanes(Acos: arc::acos) {
                /// Computes the angle in [0, π] with this cosine; NaN outside [−1, 1].
                fn(self) {
                    ((Self::ONE - self) * (Self::ONE + self)).sqrt().atan2(self)
                }
            }

            atan(x) C(atan, atanf) lanes(Atan: arc::atan) {
                /// Computes the angle in [−π/2, π/2] with this tangent; ±π/2 at ±∞.
                fn(self) {
                    self.atan2(Self::ONE)
                }
            }

            atan2(y, x) C(atan2, atan2f) lanes() {
                /// Computes the angle in [−π, π] of the point with ordinate `self` and the given
                /// abscissa.
                ///
                /// As in IEEE 754, the sign of a zero determines the side of the cut. The angle is
                /// ±π for (±0, −1) and ±0 for (±0, 1). The origin counts as a point of the axis
                /// given by the signs of its zeros.
                fn(self, abscissa);
            }

            sinh(x) C(sinh, sinhf) lanes(Sinh: exponential::sinh, is_moderate) {
                /// Computes the hyperbolic sine.
                fn(self) {
                    // The difference of exponentials cancels near zero, where the Taylor series is
                    // short.
                    let (square, mut series) = (self * self, Self::ONE);
                    for k in (1_u16..=14).rev() {
                        series = Self::ONE + square * series / Self::from_f64(f64::from(2 * k * (2 * k + 1)));
                    }
                    let half = Self::from_f64(0.5);
                    let root = (self.abs() * half).exp();
                    let magnitude = root * (root * half) - half / (root * root);
                    let difference = Self::select(self.less(Self::ZERO), -magnitude, magnitude);
                    Self::select(self.abs().less(Self::ONE), self * series, difference)
                }
            }

            cosh(x) C(cosh, coshf) lanes(Cosh: exponential::cosh, is_moderate) {
                /// Computes the hyperbolic cosine.
                fn(self) {
                    let half = Self::from_f64(0.5);
                    let root = (self.abs() * half).exp();
                    root * (root * half) + half / (root * root)
                }
            }

            tanh(x) C(tanh, tanhf) lanes(Tanh: exponential::tanh) {
                /// Computes the hyperbolic tangent; ±1 at ±∞.
                fn(self) {
                    let one = Self::select(self.less(Self::ZERO), -Self::ONE, Self::ONE);
                    let is_one = Self::from_f64(50.0).less(self.abs());
                    Self::select(is_one, one, self.sinh() / self.cosh())
                }
            }

            exp(x) C(exp, expf) lanes(Exp: exponential::exp) {
                /// Computes e to this power.
                fn(self);
            }

            ln(x) C(log, logf) lanes(Ln: logarithm::ln) {
                /// Computes the natural logarithm; −∞ at ±0, NaN below.
                fn(self);
            }

            sqrt(x) C(sqrt, sqrtf) lanes() {
                /// Computes the square root, correctly rounded; −0 at −0, NaN below.
                fn(self);
            }

            abs(x) C(fabs, fabsf) lanes() {
                /// Computes the magnitude.
                fn(self) {
                    // The sum is never a negative zero.
                    Self::select(self.less(Self::ZERO), -self, self + Self::ZERO)
                }
            }

            hypot(x, y) C(hypot, hypotf) lanes() {
                /// Computes √(self² + other²) without intermediate overflow or underflow; +∞ if
                /// either is infinite.
                fn(self, other) {
                    let (x, y) = (self.abs(), other.abs());
                    let (large, small) = (x.max(y), x.min(y));
                    let ratio = small / large;
                    let length = large * (Self::ONE + ratio * ratio).sqrt();
                    let length = Self::select(large.less_equal(Self::ZERO), large, length);
                    let infinity = Self::ONE / Self::ZERO;
                    let length = Self::select(infinity.less_equal(x), x, length);
                    Self::select(infinity.less_equal(y), y, length)
                }
            }
        }
    };
}
