/// A driven pendulum whose equations of motion are also a kernel.
///
/// # Equations of motion
///
/// ```text
/// m*l^2*ddot(theta) = motor - c*dot(theta)*abs(dot(theta)) - m*l*g*sin(theta)
/// ```
///
/// # State and structure
///
/// - State: `[theta, theta_dot]`.
/// - Mass matrix: diagonal, constant.
/// - Forward dynamics: each equation divided by its entry of the mass matrix.
/// - Cost of `acceleration`: 2 additions, 9 multiplications, 1 division, 1 function.
pub struct Pendulum<S> {
    /// Parameter `m`.
    pub m: S,
    /// Parameter `l`.
    pub l: S,
    /// Parameter `c`.
    pub c: S,
    /// Parameter `g`.
    pub g: S,
    /// Input `motor`.
    pub motor: S,
    /// On which sides of its switches the system is computed; runs fix them.
    pub switches: ::lagrange::event::Switches,
}
/// State of [`Pendulum`]: positions, then velocities.
#[allow(clippy::derive_partial_eq_without_eq, reason = "a number type need not be `Eq`")]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct PendulumState<S> {
    /// Coordinate `theta`.
    pub theta: S,
    /// Velocity of `theta`.
    pub theta_dot: S,
}
/// Columns of a table of states of [`Pendulum`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct PendulumColumns<C>(C);
/// Inputs of [`Pendulum`].
#[allow(clippy::derive_partial_eq_without_eq, reason = "a number type need not be `Eq`")]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct PendulumInputs<S> {
    /// Input `motor`.
    pub motor: S,
}
::lagrange::private::bring_hints! {}
const _: () = {
    use ::lagrange::private::{cos, multiply_add, sin};
    impl<S: ::lagrange::Scalar> Pendulum<S> {
        /// The equations of motion as C in double precision, for OpenCL, CUDA and processors.
        pub const KERNEL_F64: &'static ::core::primitive::str = r#"typedef double REAL;
#define LAGRANGE_SINGLE 0
#ifndef LAGRANGE_PRELUDE
#define LAGRANGE_PRELUDE

#if defined(__OPENCL_VERSION__)
#if !LAGRANGE_SINGLE && defined(cl_khr_fp64)
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#endif
#define LAGRANGE_FUNCTION static inline
#define LAGRANGE_OF(name) name
#define LAGRANGE_SIN_COS(x, sine, cosine) (sine) = sincos(x, &(cosine))
#elif defined(__CUDACC__)
#define LAGRANGE_FUNCTION static __device__ __forceinline__
#define LAGRANGE_SIN_COS(x, sine, cosine) LAGRANGE_OF(sincos)(x, &(sine), &(cosine))
#else
#include <math.h>
#if defined(__GNUC__)
#define LAGRANGE_FUNCTION static inline __attribute__((unused))
#else
#define LAGRANGE_FUNCTION static inline
#endif
#define LAGRANGE_SIN_COS(x, sine, cosine) ((sine) = LAGRANGE_OF(sin)(x), (cosine) = LAGRANGE_OF(cos)(x))
#endif

/* The name of a function for numbers of this kind; in OpenCL C it is the same for all. */
#ifndef LAGRANGE_OF
#if LAGRANGE_SINGLE
#define LAGRANGE_OF(name) name##f
#else
#define LAGRANGE_OF(name) name
#endif
#endif

#define LAGRANGE_SIN(x) LAGRANGE_OF(sin)(x)
#define LAGRANGE_COS(x) LAGRANGE_OF(cos)(x)
#define LAGRANGE_TAN(x) LAGRANGE_OF(tan)(x)
#define LAGRANGE_ASIN(x) LAGRANGE_OF(asin)(x)
#define LAGRANGE_ACOS(x) LAGRANGE_OF(acos)(x)
#define LAGRANGE_ATAN(x) LAGRANGE_OF(atan)(x)
#define LAGRANGE_ATAN2(y, x) LAGRANGE_OF(atan2)(y, x)
#define LAGRANGE_SINH(x) LAGRANGE_OF(sinh)(x)
#define LAGRANGE_COSH(x) LAGRANGE_OF(cosh)(x)
#define LAGRANGE_TANH(x) LAGRANGE_OF(tanh)(x)
#define LAGRANGE_EXP(x) LAGRANGE_OF(exp)(x)
#define LAGRANGE_LN(x) LAGRANGE_OF(log)(x)
#define LAGRANGE_SQRT(x) LAGRANGE_OF(sqrt)(x)
#define LAGRANGE_ABS(x) LAGRANGE_OF(fabs)(x)
#define LAGRANGE_HYPOT(x, y) LAGRANGE_OF(hypot)(x, y)

/* What is not a number stays so: a sum is none where one of its terms is. Arguments are variables and numbers. */
#define LAGRANGE_SIGN(x) ((x) > 0 ? (REAL)1 : (x) < 0 ? (REAL)-1 : (x))
#define LAGRANGE_MIN(a, b) ((a) <= (b) ? (a) : (b) < (a) ? (b) : (a) + (b))
#define LAGRANGE_MAX(a, b) ((a) >= (b) ? (a) : (b) > (a) ? (b) : (a) + (b))
#define LAGRANGE_POWF(a, b) ((a) == (a) && (b) == (b) ? LAGRANGE_OF(pow)(a, b) : (a) + (b))

/* Rounded once where that is no slower than twice. */
#if defined(__CUDACC__) || (LAGRANGE_SINGLE ? defined(FP_FAST_FMAF) : defined(FP_FAST_FMA))
#define LAGRANGE_MULTIPLY_ADD(a, b, c) LAGRANGE_OF(fma)(a, b, c)
#else
#define LAGRANGE_MULTIPLY_ADD(a, b, c) ((a) * (b) + (c))
#endif

/* Repeated squaring from the lowest bit of the exponent. */
LAGRANGE_FUNCTION REAL lagrange_powi(REAL base, int exponent)
{
    REAL product = 1, square = base;
    unsigned int remaining = exponent < 0 ? 0u - (unsigned int)exponent : (unsigned int)exponent;
    for (; remaining > 0; remaining /= 2) {
        if (remaining % 2 == 1)
            product *= square;
        if (remaining > 1)
            square *= square;
    }
    return exponent < 0 ? 1 / product : product;
}

#endif

#define LAGRANGE_POSITIONS 1
#define LAGRANGE_VELOCITIES 1
#define LAGRANGE_PARAMETERS 5

// p: parameters, then inputs: m, l, c, g, motor

// Accelerations in the order of the velocities.
LAGRANGE_FUNCTION void lagrange_acceleration(REAL t, const REAL *q, const REAL *v, const REAL *p, REAL *a)
{
    (void)t, (void)q, (void)v, (void)p;
    const REAL x0 = v[0]; // theta_dot
    const REAL x1 = LAGRANGE_ABS(x0);
    const REAL x2 = p[2]; // c
    const REAL x3 = x2 * x0;
    const REAL x4 = p[4]; // motor
    const REAL x5 = LAGRANGE_MULTIPLY_ADD(-x3, x1, x4);
    const REAL x6 = p[1]; // l
    const REAL x7 = p[0]; // m
    const REAL x8 = x7 * x6;
    const REAL x9 = p[3]; // g
    const REAL x10 = x8 * x9;
    const REAL x11 = q[0]; // theta
    const REAL x12 = LAGRANGE_SIN(x11);
    const REAL x13 = LAGRANGE_MULTIPLY_ADD(-x10, x12, x5); // forcing_0
    const REAL x14 = x6 * x6;
    const REAL x15 = x7 * x14; // m_0_0
    const REAL x16 = 1.0 / x15;
    const REAL x17 = x16 * x13; // theta_ddot
    a[0] = x17;
}

// Rates of the positions.
LAGRANGE_FUNCTION void lagrange_position_rates(REAL t, const REAL *q, const REAL *v, const REAL *p, REAL *rates)
{
    (void)t, (void)q, (void)v, (void)p;
    const REAL x0 = v[0]; // theta_dot
    rates[0] = x0;
}

// Brings quaternions among the positions to length one.
LAGRANGE_FUNCTION void lagrange_normalise(REAL *q)
{
    (void)q;
}
"#;
        /// The equations of motion as C in single precision, for OpenCL, CUDA and processors.
        pub const KERNEL_F32: &'static ::core::primitive::str = r#"typedef float REAL;
#define LAGRANGE_SINGLE 1
#ifndef LAGRANGE_PRELUDE
#define LAGRANGE_PRELUDE

#if defined(__OPENCL_VERSION__)
#if !LAGRANGE_SINGLE && defined(cl_khr_fp64)
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#endif
#define LAGRANGE_FUNCTION static inline
#define LAGRANGE_OF(name) name
#define LAGRANGE_SIN_COS(x, sine, cosine) (sine) = sincos(x, &(cosine))
#elif defined(__CUDACC__)
#define LAGRANGE_FUNCTION static __device__ __forceinline__
#define LAGRANGE_SIN_COS(x, sine, cosine) LAGRANGE_OF(sincos)(x, &(sine), &(cosine))
#else
#include <math.h>
#if defined(__GNUC__)
#define LAGRANGE_FUNCTION static inline __attribute__((unused))
#else
#define LAGRANGE_FUNCTION static inline
#endif
#define LAGRANGE_SIN_COS(x, sine, cosine) ((sine) = LAGRANGE_OF(sin)(x), (cosine) = LAGRANGE_OF(cos)(x))
#endif

/* The name of a function for numbers of this kind; in OpenCL C it is the same for all. */
#ifndef LAGRANGE_OF
#if LAGRANGE_SINGLE
#define LAGRANGE_OF(name) name##f
#else
#define LAGRANGE_OF(name) name
#endif
#endif

#define LAGRANGE_SIN(x) LAGRANGE_OF(sin)(x)
#define LAGRANGE_COS(x) LAGRANGE_OF(cos)(x)
#define LAGRANGE_TAN(x) LAGRANGE_OF(tan)(x)
#define LAGRANGE_ASIN(x) LAGRANGE_OF(asin)(x)
#define LAGRANGE_ACOS(x) LAGRANGE_OF(acos)(x)
#define LAGRANGE_ATAN(x) LAGRANGE_OF(atan)(x)
#define LAGRANGE_ATAN2(y, x) LAGRANGE_OF(atan2)(y, x)
#define LAGRANGE_SINH(x) LAGRANGE_OF(sinh)(x)
#define LAGRANGE_COSH(x) LAGRANGE_OF(cosh)(x)
#define LAGRANGE_TANH(x) LAGRANGE_OF(tanh)(x)
#define LAGRANGE_EXP(x) LAGRANGE_OF(exp)(x)
#define LAGRANGE_LN(x) LAGRANGE_OF(log)(x)
#define LAGRANGE_SQRT(x) LAGRANGE_OF(sqrt)(x)
#define LAGRANGE_ABS(x) LAGRANGE_OF(fabs)(x)
#define LAGRANGE_HYPOT(x, y) LAGRANGE_OF(hypot)(x, y)

/* What is not a number stays so: a sum is none where one of its terms is. Arguments are variables and numbers. */
#define LAGRANGE_SIGN(x) ((x) > 0 ? (REAL)1 : (x) < 0 ? (REAL)-1 : (x))
#define LAGRANGE_MIN(a, b) ((a) <= (b) ? (a) : (b) < (a) ? (b) : (a) + (b))
#define LAGRANGE_MAX(a, b) ((a) >= (b) ? (a) : (b) > (a) ? (b) : (a) + (b))
#define LAGRANGE_POWF(a, b) ((a) == (a) && (b) == (b) ? LAGRANGE_OF(pow)(a, b) : (a) + (b))

/* Rounded once where that is no slower than twice. */
#if defined(__CUDACC__) || (LAGRANGE_SINGLE ? defined(FP_FAST_FMAF) : defined(FP_FAST_FMA))
#define LAGRANGE_MULTIPLY_ADD(a, b, c) LAGRANGE_OF(fma)(a, b, c)
#else
#define LAGRANGE_MULTIPLY_ADD(a, b, c) ((a) * (b) + (c))
#endif

/* Repeated squaring from the lowest bit of the exponent. */
LAGRANGE_FUNCTION REAL lagrange_powi(REAL base, int exponent)
{
    REAL product = 1, square = base;
    unsigned int remaining = exponent < 0 ? 0u - (unsigned int)exponent : (unsigned int)exponent;
    for (; remaining > 0; remaining /= 2) {
        if (remaining % 2 == 1)
            product *= square;
        if (remaining > 1)
            square *= square;
    }
    return exponent < 0 ? 1 / product : product;
}

#endif

#define LAGRANGE_POSITIONS 1
#define LAGRANGE_VELOCITIES 1
#define LAGRANGE_PARAMETERS 5

// p: parameters, then inputs: m, l, c, g, motor

// Accelerations in the order of the velocities.
LAGRANGE_FUNCTION void lagrange_acceleration(REAL t, const REAL *q, const REAL *v, const REAL *p, REAL *a)
{
    (void)t, (void)q, (void)v, (void)p;
    const REAL x0 = v[0]; // theta_dot
    const REAL x1 = LAGRANGE_ABS(x0);
    const REAL x2 = p[2]; // c
    const REAL x3 = x2 * x0;
    const REAL x4 = p[4]; // motor
    const REAL x5 = LAGRANGE_MULTIPLY_ADD(-x3, x1, x4);
    const REAL x6 = p[1]; // l
    const REAL x7 = p[0]; // m
    const REAL x8 = x7 * x6;
    const REAL x9 = p[3]; // g
    const REAL x10 = x8 * x9;
    const REAL x11 = q[0]; // theta
    const REAL x12 = LAGRANGE_SIN(x11);
    const REAL x13 = LAGRANGE_MULTIPLY_ADD(-x10, x12, x5); // forcing_0
    const REAL x14 = x6 * x6;
    const REAL x15 = x7 * x14; // m_0_0
    const REAL x16 = 1.0f / x15;
    const REAL x17 = x16 * x13; // theta_ddot
    a[0] = x17;
}

// Rates of the positions.
LAGRANGE_FUNCTION void lagrange_position_rates(REAL t, const REAL *q, const REAL *v, const REAL *p, REAL *rates)
{
    (void)t, (void)q, (void)v, (void)p;
    const REAL x0 = v[0]; // theta_dot
    rates[0] = x0;
}

// Brings quaternions among the positions to length one.
LAGRANGE_FUNCTION void lagrange_normalise(REAL *q)
{
    (void)q;
}
"#;
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 2 additions, 9 multiplications, 1 division, 1 function.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: S, q: &[S; 1], v: &[S; 1]) -> [S; 1] {
            let Self { m, l, c, g, motor, .. } = *self;
            let [side_0] = self.sides(t, q, v);
            let [theta] = *q;
            let [theta_dot] = *v;
            let pos_0 = multiply_add(-m * l * g, sin(theta), motor);
            let forcing_0 = multiply_add(-c * theta_dot * theta_dot, side_0, pos_0);
            let l_sq = l * l;
            let m_0_0 = m * l_sq;
            let theta_ddot = S::ONE / m_0_0 * forcing_0;
            [theta_ddot]
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 1 addition, 8 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: S, q: &[S; 1], v: &[S; 1]) -> S {
            let Self { m, l, g, .. } = *self;
            let [theta] = *q;
            let [theta_dot] = *v;
            let l_sq = l * l;
            let theta_dot_sq = theta_dot * theta_dot;
            multiply_add(
                -m * l * g,
                cos(theta),
                S::from_f64(0.5) * m * l_sq * theta_dot_sq,
            )
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: S, y: &[S; 2]) -> [S; 2] {
            let [theta, theta_dot] = *y;
            let a = self.acceleration(t, &[theta], &[theta_dot]);
            [theta_dot, a[0]]
        }
        #[inline]
        fn switch_functions(&self, t: S, q: &[S; 1], v: &[S; 1]) -> [S; 1] {
            let [theta_dot] = *v;
            [theta_dot]
        }
        #[inline]
        fn sides(&self, t: S, q: &[S; 1], v: &[S; 1]) -> [S; 1] {
            ::lagrange::event::Switches::signs(
                self.switches,
                || self.switch_functions(t, q, v),
            )
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::core::default::Default for Pendulum<S> {
        fn default() -> Self {
            Self {
                m: S::from_f64(2.0),
                l: S::from_f64(0.5),
                c: S::from_sum(0.1, -5.551115123125783e-18),
                g: S::from_sum(9.81, -4.973799150320702e-16),
                motor: S::ZERO,
                switches: ::core::default::Default::default(),
            }
        }
    }
    impl<S> PendulumState<S> {
        /// The coordinates in their order.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [S; 1] {
            [self.theta]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [S; 1] {
            [self.theta_dot]
        }
    }
    #[automatically_derived]
    impl<S> ::core::convert::From<[S; 2]> for PendulumState<S> {
        #[inline]
        fn from([theta, theta_dot]: [S; 2]) -> Self {
            Self { theta, theta_dot }
        }
    }
    #[automatically_derived]
    impl<S> ::core::convert::From<PendulumState<S>> for [S; 2] {
        #[inline]
        fn from(state: PendulumState<S>) -> Self {
            [state.theta, state.theta_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> PendulumColumns<C> {
        /// Coordinate `theta`.
        #[must_use]
        #[inline]
        pub fn theta(&self) -> &[C::Scalar] {
            self.0.column(0)
        }
        /// Velocity of `theta`.
        #[must_use]
        #[inline]
        pub fn theta_dot(&self) -> &[C::Scalar] {
            self.0.column(1)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for PendulumColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for PendulumColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::OdeSystem for Pendulum<S> {
        type Scalar = S;
        type State = [S; 2];
        #[inline]
        fn rhs(&self, t: S, y: &[S; 2]) -> [S; 2] {
            self.rhs(t, y)
        }
        fn undefined(
            &self,
            t: S,
            y: &[S; 2],
            rates: &[S; 2],
        ) -> ::core::option::Option<::lagrange::system::Undefined<S>> {
            ::lagrange::integrate::undefined(
                self,
                (t, y, rates),
                &[("motor", self.motor)],
                |_, _| ::core::option::Option::None,
            )
        }
        const EVENTS: &'static [::lagrange::event::DeclaredEvent] = &[
            ::lagrange::event::DeclaredEvent::side("`dot(theta)` in `force theta`"),
        ];
        #[inline]
        fn event_values(&self, t: S, y: &[S; 2], values: &mut [S]) {
            ::lagrange::event::side_values(self, t, y, values);
        }
        fn react(
            &self,
            event: ::core::primitive::usize,
            t: S,
            _: S,
            y: &[S; 2],
        ) -> ::lagrange::system::Reacted<Self> {
            match event {
                _ => ::lagrange::event::change_side(self, event, t, y),
            }
        }
        fn begin(
            &self,
            t: S,
            y: &[S; 2],
        ) -> ::core::result::Result<
            ::core::option::Option<Self>,
            ::lagrange::system::StepFailure<S>,
        > {
            ::core::result::Result::Ok(::lagrange::event::choose_sides(self, t, y))
        }
        fn on_sides(&self, t: S, y: &[S; 2]) -> ::core::option::Option<Self> {
            ::lagrange::event::choose_sides(self, t, y)
        }
        fn freed(&self) -> ::core::option::Option<Self> {
            ::core::option::Option::Some(::lagrange::event::free_sides(self))
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::MechanicalSystem for Pendulum<S> {
        type Coordinates = [S; 1];
        type Velocities = [S; 1];
        type Columns<C> = PendulumColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &["theta"];
        const FINGERPRINT: ::core::primitive::u64 = 12624292535769081534;
        #[inline]
        fn acceleration(&self, t: S, q: &[S; 1], v: &[S; 1]) -> [S; 1] {
            self.acceleration(t, q, v)
        }
        #[inline]
        fn position_rates(&self, _: S, _: &[S; 1], v: &[S; 1]) -> [S; 1] {
            *v
        }
        fn parameter(
            &self,
            index: ::core::primitive::usize,
        ) -> ::core::option::Option<(&'static ::core::primitive::str, S)> {
            [("m", self.m), ("l", self.l), ("c", self.c), ("g", self.g)]
                .get(index)
                .copied()
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::NamedSystem for Pendulum<S> {
        type NamedState = PendulumState<S>;
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::EnergyFunction for Pendulum<S> {
        #[inline]
        fn energy(&self, t: S, q: &[S; 1], v: &[S; 1]) -> S {
            self.energy(t, q, v)
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::event::SwitchedSystem for Pendulum<S> {
        const FIRST: ::core::primitive::usize = 0;
        fn switches(&self) -> ::lagrange::event::Switches {
            self.switches
        }
        fn with_switches(&self, switches: ::lagrange::event::Switches) -> Self {
            Self {
                switches: switches,
                m: self.m,
                l: self.l,
                c: self.c,
                g: self.g,
                motor: self.motor,
            }
        }
        fn switch_values(&self, t: S, y: &[S; 2], values: &mut [S]) {
            let [theta, theta_dot] = *y;
            values.copy_from_slice(&self.switch_functions(t, &[theta], &[theta_dot]));
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::KernelSystem for Pendulum<S> {
        type Parameters = [S; 5];
        const KERNEL_F64: &'static ::core::primitive::str = Self::KERNEL_F64;
        const KERNEL_F32: &'static ::core::primitive::str = Self::KERNEL_F32;
        const PARAMETERS: &'static [&'static ::core::primitive::str] = &[
            "m",
            "l",
            "c",
            "g",
            "motor",
        ];
        fn parameters(&self) -> [S; 5] {
            [self.m, self.l, self.c, self.g, self.motor]
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::ParametricSystem for Pendulum<S> {
        const NUMBERS: &'static [&'static ::core::primitive::str] = &[
            "m",
            "l",
            "c",
            "g",
            "motor",
        ];
        fn number(&self, index: ::core::primitive::usize) -> ::core::option::Option<S> {
            <[S]>::get(&[self.m, self.l, self.c, self.g, self.motor], index).copied()
        }
        fn with_number(&self, index: ::core::primitive::usize, value: S) -> Self {
            let mut other = Self {
                m: self.m,
                l: self.l,
                c: self.c,
                g: self.g,
                motor: self.motor,
                switches: self.switches,
            };
            match index {
                0 => other.m = value,
                1 => other.l = value,
                2 => other.c = value,
                3 => other.g = value,
                4 => other.motor = value,
                _ => {}
            }
            other
        }
    }
    #[automatically_derived]
    impl<S> ::core::convert::From<[S; 1]> for PendulumInputs<S> {
        #[inline]
        fn from([motor]: [S; 1]) -> Self {
            Self { motor }
        }
    }
    #[automatically_derived]
    impl<S> ::core::convert::From<PendulumInputs<S>> for [S; 1] {
        #[inline]
        fn from(inputs: PendulumInputs<S>) -> Self {
            [inputs.motor]
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::ControlledSystem for Pendulum<S> {
        type Inputs = PendulumInputs<S>;
        type InputVector = [S; 1];
        const INPUTS: &'static [&'static ::core::primitive::str] = &["motor"];
        #[inline]
        fn inputs(&self) -> PendulumInputs<S> {
            PendulumInputs {
                motor: self.motor,
            }
        }
        #[inline]
        fn with_inputs(&self, inputs: PendulumInputs<S>) -> Self {
            Self {
                motor: inputs.motor,
                m: self.m,
                l: self.l,
                c: self.c,
                g: self.g,
                switches: self.switches,
            }
        }
    }
};
