//! The list of elementary functions: numbers, lanes, emitted code and kernels all take their
//! functions from it.

/// Passes the list of elementary functions to a macro, behind tokens for that macro.
///
/// ```text
/// name(arguments) C(name for double, name for float) lanes(Variant: formula, domain) {
///     /// Documentation.
///     fn(parameters of the method) { default }
/// }
/// ```
///
/// The default is the body of the method for number types that do not define it, or `;` if every
/// number type must. The names in C are also those of `libm`. Lanes compute several numbers
/// together by the formula, if there is one. It is a function of this crate; numbers outside its
/// domain are left to the platform.
#[doc(hidden)]
#[macro_export]
macro_rules! functions {
    ($then:ident $($context:tt)*) => {
        $then! {
            $($context)*

            sin(x) C(sin, sinf) lanes() {
                /// Sine; NaN at infinity.
                fn(self);
            }

            cos(x) C(cos, cosf) lanes() {
                /// Cosine; NaN at infinity.
                fn(self);
            }

            tan(x) C(tan, tanf) lanes(Tan: tangent::tan, is_angle) {
                /// Tangent; NaN at infinity. Finite elsewhere, since no binary number is an odd
                /// multiple of π/2.
                fn(self) {
                    let (sine, cosine) = self.sin_cos();
                    sine / cosine
                }
            }

            asin(x) C(asin, asinf) lanes(Asin: arc::asin) {
                /// The angle in [−π/2, π/2] with this sine; NaN outside [−1, 1].
                fn(self) {
                    self.atan2(((Self::ONE - self) * (Self::ONE + self)).sqrt())
                }
            }

            acos(x) C(acos, acosf) lanes(Acos: arc::acos) {
                /// The angle in [0, π] with this cosine; NaN outside [−1, 1].
                fn(self) {
                    ((Self::ONE - self) * (Self::ONE + self)).sqrt().atan2(self)
                }
            }

            atan(x) C(atan, atanf) lanes(Atan: arc::atan) {
                /// The angle in [−π/2, π/2] with this tangent; ±π/2 at ±∞.
                fn(self) {
                    self.atan2(Self::ONE)
                }
            }

            atan2(y, x) C(atan2, atan2f) lanes() {
                /// The angle in [−π, π] of the point with ordinate `self` and the given abscissa.
                ///
                /// As in IEEE 754, the sign of a zero picks the side of the cut: (±0, −1) gives ±π
                /// and (±0, 1) gives ±0. The origin counts as a point of the axis of its zeros.
                fn(self, abscissa);
            }

            sinh(x) C(sinh, sinhf) lanes(Sinh: exponential::sinh, is_moderate) {
                /// Hyperbolic sine.
                fn(self) {
                    // The difference of exponentials cancels near zero, where Taylor's series is
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
                /// Hyperbolic cosine.
                fn(self) {
                    let half = Self::from_f64(0.5);
                    let root = (self.abs() * half).exp();
                    root * (root * half) + half / (root * root)
                }
            }

            tanh(x) C(tanh, tanhf) lanes(Tanh: exponential::tanh) {
                /// Hyperbolic tangent; ±1 at ±∞.
                fn(self) {
                    let one = Self::select(self.less(Self::ZERO), -Self::ONE, Self::ONE);
                    let is_one = Self::from_f64(50.0).less(self.abs());
                    Self::select(is_one, one, self.sinh() / self.cosh())
                }
            }

            exp(x) C(exp, expf) lanes(Exp: exponential::exp) {
                /// e to this power.
                fn(self);
            }

            ln(x) C(log, logf) lanes(Ln: logarithm::ln) {
                /// Natural logarithm; −∞ at ±0, NaN below.
                fn(self);
            }

            sqrt(x) C(sqrt, sqrtf) lanes() {
                /// Square root, correctly rounded; −0 at −0, NaN below.
                fn(self);
            }

            abs(x) C(fabs, fabsf) lanes() {
                /// Magnitude.
                fn(self) {
                    // The sum has no negative zero.
                    Self::select(self.less(Self::ZERO), -self, self + Self::ZERO)
                }
            }

            hypot(x, y) C(hypot, hypotf) lanes() {
                /// √(self² + other²) without intermediate overflow or underflow; +∞ if either is
                /// infinite.
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
