/// A wing whose lift depends on its angle and its speed, with a measured derivative by the angle.
///
/// # Equations of motion
///
/// ```text
/// m*ddot(z) = lift(alpha - atan2(dot(z), speed), speed) - m*g - spring'(z - 0.1)
/// j*ddot(alpha) = 0
/// ```
///
/// # State and structure
///
/// - State: `[z, alpha, z_dot, alpha_dot]`.
/// - Mass matrix: diagonal, constant.
/// - Cyclic coordinates: `alpha`.
/// - Conserved: the momentum of `alpha`.
/// - Forward dynamics: each equation divided by its entry of the mass matrix.
/// - Cost of `acceleration`: 4 additions, 2 multiplications, 1 division, 3 functions.
pub struct GlidingWing<S> {
    /// Parameter `m`.
    pub m: S,
    /// Parameter `j`.
    pub j: S,
    /// Parameter `g`.
    pub g: S,
    /// Parameter `speed`.
    pub speed: S,
}
/// State of [`GlidingWing`]: positions, then velocities.
#[allow(clippy::derive_partial_eq_without_eq, reason = "a number type need not be `Eq`")]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct GlidingWingState<S> {
    /// Coordinate `z`.
    pub z: S,
    /// Coordinate `alpha`.
    pub alpha: S,
    /// Velocity of `z`.
    pub z_dot: S,
    /// Velocity of `alpha`.
    pub alpha_dot: S,
}
/// Columns of a table of states of [`GlidingWing`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct GlidingWingColumns<C>(C);
::lagrange::private::bring_hints! {}
const _: () = {
    use ::lagrange::private::{atan2, multiply_add};
    impl<S: ::lagrange::Scalar> GlidingWing<S> {
        /// Parameters, then inputs: the columns of `parameter_jacobian`.
        pub const PARAMETERS: [&'static ::core::primitive::str; 4] = [
            "m",
            "j",
            "g",
            "speed",
        ];
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 4 additions, 2 multiplications, 1 division, 3 functions.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: S, q: &[S; 2], v: &[S; 2]) -> [S; 2] {
            let Self { m, g, speed, .. } = *self;
            let [z, alpha] = *q;
            let [z_dot, _] = *v;
            let vel_0 = lift(alpha - atan2(z_dot, speed), speed)
                - spring_force(z - S::from_f64(0.1));
            let forcing_0 = multiply_add(-m, g, vel_0);
            let z_ddot = S::ONE / m * forcing_0;
            [z_ddot, S::ZERO]
        }
        /// Mass matrix M, in rows.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: S, q: &[S; 2]) -> [[S; 2]; 2] {
            let Self { m, j, .. } = *self;
            let const_0 = S::ZERO;
            [[m, const_0], [const_0, j]]
        }
        /// Right-hand side f of M q̈ = f.
        ///
        /// Takes 4 additions, 1 multiplication, 3 functions.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: S, q: &[S; 2], v: &[S; 2]) -> [S; 2] {
            let Self { m, g, speed, .. } = *self;
            let [z, alpha] = *q;
            let [z_dot, _] = *v;
            let vel_0 = lift(alpha - atan2(z_dot, speed), speed)
                - spring_force(z - S::from_f64(0.1));
            let forcing_0 = multiply_add(-m, g, vel_0);
            [forcing_0, S::ZERO]
        }
        /// Generalised momenta ∂L/∂v.
        ///
        /// Takes 2 multiplications.
        #[must_use]
        #[inline]
        pub fn momenta(&self, t: S, q: &[S; 2], v: &[S; 2]) -> [S; 2] {
            let Self { m, j, .. } = *self;
            let [z_dot, alpha_dot] = *v;
            [m * z_dot, j * alpha_dot]
        }
        /// Kinetic energy T.
        ///
        /// Takes 1 addition, 5 multiplications.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: S, q: &[S; 2], v: &[S; 2]) -> S {
            let Self { m, j, .. } = *self;
            let [z_dot, alpha_dot] = *v;
            let z_dot_sq = z_dot * z_dot;
            let alpha_dot_sq = alpha_dot * alpha_dot;
            S::from_f64(0.5) * multiply_add(j, alpha_dot_sq, m * z_dot_sq)
        }
        /// Potential energy V.
        ///
        /// Takes 2 additions, 2 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: S, q: &[S; 2]) -> S {
            let Self { m, g, .. } = *self;
            let [z, _] = *q;
            multiply_add(m * g, z, spring(z - S::from_f64(0.1)))
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 4 additions, 7 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: S, q: &[S; 2], v: &[S; 2]) -> S {
            let Self { m, j, g, .. } = *self;
            let [z, _] = *q;
            let [z_dot, alpha_dot] = *v;
            let z_dot_sq = z_dot * z_dot;
            let alpha_dot_sq = alpha_dot * alpha_dot;
            let vel_0 = S::from_f64(0.5) * multiply_add(j, alpha_dot_sq, m * z_dot_sq);
            multiply_add(m * g, z, vel_0) + spring(z - S::from_f64(0.1))
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 5 additions, 3 multiplications, 3 functions.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: S,
            q: &[S; 2],
            v: &[S; 2],
            a: &[S; 2],
        ) -> [S; 2] {
            let Self { m, j, g, speed } = *self;
            let [z, alpha] = *q;
            let [z_dot, _] = *v;
            let [z_ddot, alpha_ddot] = *a;
            let vel_0 = spring_force(z - S::from_f64(0.1))
                - lift(alpha - atan2(z_dot, speed), speed);
            [multiply_add(m, z_ddot, multiply_add(m, g, vel_0)), j * alpha_ddot]
        }
        /// Jacobian of `rhs`, in rows: entry `[i][j]` is the derivative of its entry `i` by entry `j`
        /// of the state.
        ///
        /// Takes 3 additions, 6 multiplications, 2 divisions, 3 functions.
        #[must_use]
        #[inline]
        pub fn jacobian(&self, t: S, y: &[S; 4]) -> [[S; 4]; 4] {
            let Self { m, speed, .. } = *self;
            let [z, alpha, z_dot, _] = *y;
            let const_0 = S::ZERO;
            let const_1 = S::ONE;
            let inv_m = const_1 / m;
            let value_0 = lift_slope(alpha - atan2(z_dot, speed), speed);
            [
                [const_0, const_0, const_1, const_0],
                [const_0, const_0, const_0, const_1],
                [
                    -inv_m * spring_stiffness(z - S::from_f64(0.1)),
                    inv_m * value_0,
                    -inv_m * speed * value_0 / multiply_add(speed, speed, z_dot * z_dot),
                    const_0,
                ],
                [const_0, const_0, const_0, const_0],
            ]
        }
        /// Derivatives of `rhs` by the fields in the order of `PARAMETERS`, in rows: entry `[i][j]`
        /// is that of its entry `i` by field `j`.
        ///
        /// Takes 7 additions, 8 multiplications, 2 divisions, 5 functions.
        #[must_use]
        #[inline]
        pub fn parameter_jacobian(&self, t: S, y: &[S; 4]) -> [[S; 4]; 4] {
            let Self { m, g, speed, .. } = *self;
            let [z, alpha, z_dot, _] = *y;
            let const_0 = S::ZERO;
            let vel_0 = alpha - atan2(z_dot, speed);
            let forcing_0 = multiply_add(
                -m,
                g,
                lift(vel_0, speed) - spring_force(z - S::from_f64(0.1)),
            );
            let inv_m = S::ONE / m;
            let inv_m_sq = inv_m * inv_m;
            let vel_1 = lift_slope(vel_0, speed) * z_dot
                / multiply_add(speed, speed, z_dot * z_dot);
            [
                [const_0, const_0, const_0, const_0],
                [const_0, const_0, const_0, const_0],
                [
                    -multiply_add(inv_m, g, inv_m_sq * forcing_0),
                    const_0,
                    S::from_f64(-1.0),
                    inv_m * (lift_by_speed(vel_0, speed) + vel_1),
                ],
                [const_0, const_0, const_0, const_0],
            ]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: S, y: &[S; 4]) -> [S; 4] {
            let [z, alpha, z_dot, alpha_dot] = *y;
            let a = self.acceleration(t, &[z, alpha], &[z_dot, alpha_dot]);
            [z_dot, alpha_dot, a[0], a[1]]
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::core::default::Default for GlidingWing<S> {
        fn default() -> Self {
            Self {
                m: S::from_f64(3.0),
                j: S::from_f64(0.4),
                g: S::from_f64(9.81),
                speed: S::from_f64(20.0),
            }
        }
    }
    impl<S> GlidingWingState<S> {
        /// The coordinates in their order.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [S; 2] {
            [self.z, self.alpha]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [S; 2] {
            [self.z_dot, self.alpha_dot]
        }
    }
    #[automatically_derived]
    impl<S> ::core::convert::From<[S; 4]> for GlidingWingState<S> {
        #[inline]
        fn from([z, alpha, z_dot, alpha_dot]: [S; 4]) -> Self {
            Self { z, alpha, z_dot, alpha_dot }
        }
    }
    #[automatically_derived]
    impl<S> ::core::convert::From<GlidingWingState<S>> for [S; 4] {
        #[inline]
        fn from(state: GlidingWingState<S>) -> Self {
            [state.z, state.alpha, state.z_dot, state.alpha_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> GlidingWingColumns<C> {
        /// Coordinate `z`.
        #[must_use]
        #[inline]
        pub fn z(&self) -> &[C::Scalar] {
            self.0.column(0)
        }
        /// Coordinate `alpha`.
        #[must_use]
        #[inline]
        pub fn alpha(&self) -> &[C::Scalar] {
            self.0.column(1)
        }
        /// Velocity of `z`.
        #[must_use]
        #[inline]
        pub fn z_dot(&self) -> &[C::Scalar] {
            self.0.column(2)
        }
        /// Velocity of `alpha`.
        #[must_use]
        #[inline]
        pub fn alpha_dot(&self) -> &[C::Scalar] {
            self.0.column(3)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for GlidingWingColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for GlidingWingColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::OdeSystem for GlidingWing<S> {
        type Scalar = S;
        type State = [S; 4];
        #[inline]
        fn rhs(&self, t: S, y: &[S; 4]) -> [S; 4] {
            self.rhs(t, y)
        }
        fn undefined(
            &self,
            t: S,
            y: &[S; 4],
            rates: &[S; 4],
        ) -> ::core::option::Option<::lagrange::system::Undefined<S>> {
            ::lagrange::integrate::undefined(
                self,
                (t, y, rates),
                &[],
                |q, _| ::core::option::Option::Some(self.mass_matrix(t, q)),
            )
        }
        #[inline]
        fn jacobian(&self, t: S, y: &[S; 4]) -> ::core::option::Option<[[S; 4]; 4]> {
            ::core::option::Option::Some(self.jacobian(t, y))
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::MechanicalSystem for GlidingWing<S> {
        type Coordinates = [S; 2];
        type Velocities = [S; 2];
        type Columns<C> = GlidingWingColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &["z", "alpha"];
        const FINGERPRINT: ::core::primitive::u64 = 3408905973838231633;
        #[inline]
        fn acceleration(&self, t: S, q: &[S; 2], v: &[S; 2]) -> [S; 2] {
            self.acceleration(t, q, v)
        }
        #[inline]
        fn position_rates(&self, _: S, _: &[S; 2], v: &[S; 2]) -> [S; 2] {
            *v
        }
        fn parameter(
            &self,
            index: ::core::primitive::usize,
        ) -> ::core::option::Option<(&'static ::core::primitive::str, S)> {
            [("m", self.m), ("j", self.j), ("g", self.g), ("speed", self.speed)]
                .get(index)
                .copied()
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::NamedSystem for GlidingWing<S> {
        type NamedState = GlidingWingState<S>;
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::EnergyFunction for GlidingWing<S> {
        #[inline]
        fn energy(&self, t: S, q: &[S; 2], v: &[S; 2]) -> S {
            self.energy(t, q, v)
        }
    }
};
