//! Numbers whose results have the same bits on every platform.

use core::fmt::{Debug, Display, Formatter, Result};
use core::ops::{Add, Div, Mul, Neg, Sub};

use super::{Elementary, Number, Scalar};

/// A binary number of IEEE 754: `f64` or `f32`.
pub trait Binary: Scalar + Into<f64> {}

impl Binary for f64 {}
impl Binary for f32 {}

/// A number whose results have the same bits on every platform, alone or in
/// [`Lanes`](super::Lanes). They do not depend on processor, operating system, instruction set or
/// optimisation level.
///
/// A declaration with a type parameter, such as `struct Pendulum<S>;`, can use it. All computations
/// of a motion then use it too: methods of integration and their step lengths, events, contacts,
/// tables, projections. Trajectories are identical bit by bit. They depend only on the sources of
/// this crate and of the declaration, if functions of the user's crate do not call the platform.
///
/// ```
/// use lagrange::{Portable, Simulate};
///
/// lagrange::system! {
///     #[accuracy(fast)]
///     struct Pendulum<S>;
///     coord theta;
///     kinetic = 1/2 * dot(theta)^2;
///     potential = -9.81 * cos(theta);
/// }
///
/// let pendulum = Pendulum::<Portable>::default();
/// let trajectory = pendulum.simulate([1.0, 0.0].map(Portable)).until(Portable(10.0)).run()?;
/// let Portable(end) = trajectory.theta()[trajectory.len() - 1];
/// # let _ = end;
/// # Ok::<(), lagrange::simulate::SimulationError<Pendulum<Portable>>>(())
/// ```
///
/// Sums, products, quotients and square roots are those of T, which IEEE 754 defines to the last
/// bit, and products are never fused. Elementary functions come from `lagrange-math`, which does
/// not call the platform. Errors in units in the last place are at most
///
/// | `f64` | |
/// |---|---|
/// | `sin`, `cos` | 0.55 |
/// | `tan`, `ln`, `powf` | 1 |
/// | `asin`, `acos`, `atan`, `atan2` | 0.7; `atan2` 1 where a coordinate other than zero is below 10⁻²⁷⁰ or above 10²⁷⁰ in magnitude |
/// | `sinh`, `cosh`, `tanh` | 0.8 |
/// | `exp` | 0.6, or 1.2 below 2⁻¹⁰²² |
/// | `hypot` | 0.6 |
///
/// For `f32`, they are computed in `f64` and rounded once, to 0.5000001 units in the last place.
/// Only the sign and the payload of NaN depend on the processor, and no result depends on them.
///
/// `docs/performance.md` measures the cost. `Debug` and `Display` format the number like T.
#[derive(Clone, Copy, PartialEq, PartialOrd, Default)]
#[repr(transparent)]
pub struct Portable<T = f64>(pub T);

impl<T: Debug> Debug for Portable<T> {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> Result {
        self.0.fmt(formatter)
    }
}

impl<T: Display> Display for Portable<T> {
    fn fmt(&self, formatter: &mut Formatter<'_>) -> Result {
        self.0.fmt(formatter)
    }
}

impl<T> From<T> for Portable<T> {
    #[inline]
    fn from(number: T) -> Self {
        Portable(number)
    }
}

impl From<Portable<f64>> for f64 {
    #[inline]
    fn from(number: Portable<f64>) -> f64 {
        number.0
    }
}

impl From<Portable<f32>> for f64 {
    #[inline]
    fn from(number: Portable<f32>) -> f64 {
        number.0.into()
    }
}

impl<T: Neg<Output = T>> Neg for Portable<T> {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Portable(-self.0)
    }
}

/// Implements operators, given in rows of trait, method and sign.
macro_rules! implement_operators {
    ($($operator:ident $method:ident $sign:tt;)*) => {
        $(impl<T: $operator<Output = T>> $operator for Portable<T> {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Portable(self.0 $sign other.0)
            }
        })*
    };
}

implement_operators! {
    Add add +;
    Sub sub -;
    Mul mul *;
    Div div /;
}

/// Applies a function of several numbers to the values of portable numbers.
#[inline(always)]
fn each<T: Binary, const N: usize>(
    numbers: [Portable<T>; N],
    function: impl FnOnce([T; N]) -> [T; N],
) -> [Portable<T>; N] {
    function(numbers.map(|number| number.0)).map(Portable)
}

/// Defines methods for the list rows with a formula for several numbers.
macro_rules! one_of_several {
    ($(
        $name:ident $arguments:tt C $c:tt lanes($($variant:ident: $module:ident::$formula:ident $(, $domain:ident)?)?) $method:tt
    )*) => {
        $($(#[inline]
        fn $name(self) -> Self {
            let [value] = T::values::<false, 1>(Elementary::$variant, [self.0]);
            Portable(value)
        })?)*
    };
}

impl<T: Binary> Number for Portable<T> {
    type Mask = bool;

    const ZERO: Self = Portable(T::ZERO);
    const ONE: Self = Portable(T::ONE);
    const NAN: Self = Portable(T::NAN);

    #[inline]
    fn from_f64(value: f64) -> Self {
        Portable(T::from_f64(value))
    }

    #[inline(always)]
    fn less(self, other: Self) -> bool {
        self < other
    }

    #[inline(always)]
    fn less_equal(self, other: Self) -> bool {
        self <= other
    }

    #[inline(always)]
    fn select(mask: bool, then: Self, otherwise: Self) -> Self {
        if mask { then } else { otherwise }
    }

    #[inline]
    fn floor_below(self, count: usize) -> Option<usize> {
        self.0.floor_below(count)
    }

    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        let ([sine], [cosine]) = Self::sines_and_cosines::<false, 1>([self]);
        (sine, cosine)
    }

    #[inline(always)]
    fn sin_cos_each<const N: usize>(angles: [Self; N]) -> [(Self, Self); N] {
        let (sines, cosines) = Self::sines_and_cosines::<false, N>(angles);
        core::array::from_fn(|i| (sines[i], cosines[i]))
    }

    #[inline]
    fn sin(self) -> Self {
        self.sin_cos().0
    }

    #[inline]
    fn cos(self) -> Self {
        self.sin_cos().1
    }

    #[inline]
    fn atan2(self, abscissa: Self) -> Self {
        let [angle] = T::angles::<false, 1>([self.0], [abscissa.0]);
        Portable(angle)
    }

    #[inline]
    fn hypot(self, other: Self) -> Self {
        let [length] = T::lengths::<false, 1>([self.0], [other.0]);
        Portable(length)
    }

    #[inline]
    fn sqrt(self) -> Self {
        Portable(self.0.sqrt())
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Portable(self.0.abs())
    }

    #[inline]
    fn powf(self, exponent: Self) -> Self {
        Self::from_f64(lagrange_math::power(self.0.into(), exponent.0.into()))
    }

    lagrange_math::functions!(one_of_several);
}

/// In lanes, products are not fused either, even if lanes request it.
impl<T: Binary> Scalar for Portable<T> {
    #[inline]
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }

    #[inline(always)]
    fn sines_and_cosines<const FUSED: bool, const N: usize>(angles: [Self; N]) -> ([Self; N], [Self; N]) {
        let (sines, cosines) = lagrange_math::precise_sines_and_cosines(angles.map(|angle| angle.0.into()));
        (sines.map(Self::from_f64), cosines.map(Self::from_f64))
    }

    #[inline(always)]
    fn values<const FUSED: bool, const N: usize>(function: Elementary, arguments: [Self; N]) -> [Self; N] {
        each(arguments, |arguments| T::values::<false, N>(function, arguments))
    }

    #[inline(always)]
    fn angles<const FUSED: bool, const N: usize>(ordinates: [Self; N], abscissas: [Self; N]) -> [Self; N] {
        each(ordinates, |ordinates| T::angles::<false, N>(ordinates, abscissas.map(|abscissa| abscissa.0)))
    }

    #[inline(always)]
    fn lengths<const FUSED: bool, const N: usize>(x: [Self; N], y: [Self; N]) -> [Self; N] {
        each(x, |x| T::lengths::<false, N>(x, y.map(|y| y.0)))
    }

    #[inline(always)]
    fn rough_log2(self) -> Self {
        Portable(self.0.rough_log2())
    }

    #[inline(always)]
    fn rough_exp2(self) -> Self {
        Portable(self.0.rough_exp2())
    }
}
