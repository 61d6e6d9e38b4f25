/// Two pendulums, one on the other, on a pivot that is shaken.
///
/// # Equations of motion
///
/// ```text
/// (m1 + m2)*l1^2*ddot(theta1) + m2*l1*l2*cos(theta1 - theta2)*ddot(theta2)
///     = (m1 + m2)*l1*a*omega^2*cos(omega*t)*sin(theta1) - m2*l1*l2*sin(theta1 - theta2)*dot(theta2)^2
///     - (m1 + m2)*l1*g*sin(theta1)
/// m2*l1*l2*cos(theta1 - theta2)*ddot(theta1) + m2*l2^2*ddot(theta2)
///     = m2*l1*l2*sin(theta1 - theta2)*dot(theta1)^2 + m2*l2*a*omega^2*cos(omega*t)*sin(theta2)
///     - m2*l2*g*sin(theta2)
/// ```
///
/// # State and structure
///
/// - State: `[theta1, theta2, theta1_dot, theta2_dot]`.
/// - Mass matrix: full, depends on the configuration.
/// - Forward dynamics: eliminated body by body, the kinetic energy kept a sum of squares (counted cost 240; factorised mass matrix 253, recursion 298).
/// - Accuracy: `fast`. Sines and cosines are computed several at a time;
///   in `f64` each is within 0.9 units in the last place.
/// - Cost of `acceleration`: 8 additions, 23 multiplications, 3 divisions, 3 `sin_cos`.
pub struct ShakenDoublePendulum {
    /// Parameter `m1`.
    pub m1: ::core::primitive::f64,
    /// Parameter `m2`.
    pub m2: ::core::primitive::f64,
    /// Parameter `l1`.
    pub l1: ::core::primitive::f64,
    /// Parameter `l2`.
    pub l2: ::core::primitive::f64,
    /// Parameter `a`.
    pub a: ::core::primitive::f64,
    /// Parameter `omega`.
    pub omega: ::core::primitive::f64,
    /// Parameter `g`.
    pub g: ::core::primitive::f64,
}
/// State of [`ShakenDoublePendulum`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ShakenDoublePendulumState {
    /// Coordinate `theta1`.
    pub theta1: ::core::primitive::f64,
    /// Coordinate `theta2`.
    pub theta2: ::core::primitive::f64,
    /// Velocity of `theta1`.
    pub theta1_dot: ::core::primitive::f64,
    /// Velocity of `theta2`.
    pub theta2_dot: ::core::primitive::f64,
}
/// Columns of a table of states of [`ShakenDoublePendulum`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct ShakenDoublePendulumColumns<C>(C);
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::{multiply_add, sin_cos_each};
    impl ShakenDoublePendulum {
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 8 additions, 23 multiplications, 3 divisions, 3 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let Self { m1, m2, l1, l2, a, omega, g } = *self;
            let [theta1, theta2] = *q;
            let [theta1_dot, theta2_dot] = *v;
            let [(sin_theta1, cos_theta1), (_, cos_omega_t),
            (sin_theta1_minus_theta2, cos_theta1_minus_theta2)] = sin_cos_each([
                theta1,
                omega * t,
                theta1 - theta2,
            ]);
            let pos_0 = m2 * sin_theta1_minus_theta2;
            let pivot_0 = multiply_add(sin_theta1_minus_theta2, pos_0, m1);
            let inv_pivot_0 = 1.0 / pivot_0;
            let theta2_dot_sq = theta2_dot * theta2_dot;
            let theta1_dot_sq = theta1_dot * theta1_dot;
            let omega_sq = omega * omega;
            let pos_1 = a * omega_sq * cos_omega_t;
            let normal_0 = multiply_add(
                -pos_1,
                cos_theta1,
                multiply_add(l1, theta1_dot_sq, g * cos_theta1),
            );
            let vel_0 = m2 * l2 * sin_theta1_minus_theta2 * inv_pivot_0 * theta2_dot_sq;
            let minus_tangential_0 = multiply_add(
                inv_pivot_0 * pos_0 * cos_theta1_minus_theta2,
                normal_0,
                vel_0,
            );
            let theta1_ddot = -1.0 / l1
                * multiply_add(sin_theta1, g - pos_1, minus_tangential_0);
            let vel_1 = sin_theta1_minus_theta2 * normal_0;
            let theta2_ddot = 1.0 / l2
                * multiply_add(cos_theta1_minus_theta2, minus_tangential_0, vel_1);
            [theta1_ddot, theta2_ddot]
        }
        /// Mass matrix M, in rows.
        ///
        /// Takes 2 additions, 9 multiplications, 2 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f64, q: &[f64; 2]) -> [[f64; 2]; 2] {
            let Self { m1, m2, l1, l2, .. } = *self;
            let [theta1, theta2] = *q;
            let l1_sq = l1 * l1;
            let m_0_0 = l1_sq * (m1 + m2);
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2)] = sin_cos_each([
                theta1,
                theta2,
            ]);
            let m_0_1 = m2 * l1 * l2
                * multiply_add(cos_theta1, cos_theta2, sin_theta1 * sin_theta2);
            let l2_sq = l2 * l2;
            let m_1_1 = m2 * l2_sq;
            [[m_0_0, m_0_1], [m_0_1, m_1_1]]
        }
        /// Right-hand side f of M q̈ = f.
        ///
        /// Takes 6 additions, 26 multiplications, 3 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let Self { m1, m2, l1, l2, a, omega, g } = *self;
            let [theta1, theta2] = *q;
            let [theta1_dot, theta2_dot] = *v;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2), (_, cos_omega_t)] = sin_cos_each([
                theta1,
                theta2,
                omega * t,
            ]);
            let omega_sq = omega * omega;
            let m1_plus_m2 = m1 + m2;
            let pos_0 = l1 * a * omega_sq * m1_plus_m2 * cos_omega_t * sin_theta1;
            let pos_1 = m2 * l1 * l2
                * multiply_add(-cos_theta1, sin_theta2, sin_theta1 * cos_theta2);
            let theta2_dot_sq = theta2_dot * theta2_dot;
            let pos_2 = multiply_add(-l1 * g * m1_plus_m2, sin_theta1, pos_0);
            let theta1_dot_sq = theta1_dot * theta1_dot;
            let m2_l2 = m2 * l2;
            let pos_3 = m2_l2 * a * omega_sq * cos_omega_t;
            let vel_0 = multiply_add(pos_3, sin_theta2, pos_1 * theta1_dot_sq);
            [
                multiply_add(-pos_1, theta2_dot_sq, pos_2),
                multiply_add(-m2_l2 * g, sin_theta2, vel_0),
            ]
        }
        /// Generalised momenta ∂L/∂v.
        ///
        /// Takes 7 additions, 19 multiplications, 3 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn momenta(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let Self { m1, m2, l1, l2, a, omega, .. } = *self;
            let [theta1, theta2] = *q;
            let [theta1_dot, theta2_dot] = *v;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2), (sin_omega_t, _)] = sin_cos_each([
                theta1,
                theta2,
                omega * t,
            ]);
            let l1_sin_theta1 = l1 * sin_theta1;
            let y1_dot = multiply_add(
                -a * omega,
                sin_omega_t,
                l1_sin_theta1 * theta1_dot,
            );
            let l2_sin_theta2 = l2 * sin_theta2;
            let y2_dot = multiply_add(l2_sin_theta2, theta2_dot, y1_dot);
            let m2_y2_dot = m2 * y2_dot;
            let l1_cos_theta1 = l1 * cos_theta1;
            let x1_dot = l1_cos_theta1 * theta1_dot;
            let l2_cos_theta2 = l2 * cos_theta2;
            let x2_dot = multiply_add(l2_cos_theta2, theta2_dot, x1_dot);
            let m2_x2_dot = m2 * x2_dot;
            let vel_0 = l1_sin_theta1 * multiply_add(m1, y1_dot, m2_y2_dot);
            [
                multiply_add(l1_cos_theta1, multiply_add(m1, x1_dot, m2_x2_dot), vel_0),
                multiply_add(l2_cos_theta2, m2_x2_dot, l2_sin_theta2 * m2_y2_dot),
            ]
        }
        /// Kinetic energy T.
        ///
        /// Takes 6 additions, 18 multiplications, 3 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
            let Self { m1, m2, l1, l2, a, omega, .. } = *self;
            let [theta1, theta2] = *q;
            let [theta1_dot, theta2_dot] = *v;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2), (sin_omega_t, _)] = sin_cos_each([
                theta1,
                theta2,
                omega * t,
            ]);
            let x1_dot = l1 * cos_theta1 * theta1_dot;
            let y1_dot = multiply_add(
                -a * omega,
                sin_omega_t,
                l1 * sin_theta1 * theta1_dot,
            );
            let x2_dot = multiply_add(l2 * cos_theta2, theta2_dot, x1_dot);
            let y2_dot = multiply_add(l2 * sin_theta2, theta2_dot, y1_dot);
            let vel_0 = m1 * multiply_add(y1_dot, y1_dot, x1_dot * x1_dot);
            0.5 * multiply_add(m2, multiply_add(y2_dot, y2_dot, x2_dot * x2_dot), vel_0)
        }
        /// Potential energy V.
        ///
        /// Takes 3 additions, 8 multiplications, 3 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, q: &[f64; 2]) -> f64 {
            let Self { m1, m2, l1, l2, a, omega, g } = *self;
            let [theta1, theta2] = *q;
            let [(_, cos_theta1), (_, cos_theta2), (_, cos_omega_t)] = sin_cos_each([
                theta1,
                theta2,
                omega * t,
            ]);
            let y0 = a * cos_omega_t;
            let y1 = multiply_add(-l1, cos_theta1, y0);
            let y2 = multiply_add(-l2, cos_theta2, y1);
            multiply_add(m2 * g, y2, m1 * g * y1)
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 16 additions, 33 multiplications, 3 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
            let Self { m1, m2, l1, l2, a, omega, g } = *self;
            let [theta1, theta2] = *q;
            let [theta1_dot, theta2_dot] = *v;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2),
            (sin_omega_t, cos_omega_t)] = sin_cos_each([theta1, theta2, omega * t]);
            let l1_cos_theta1 = l1 * cos_theta1;
            let x1_dot = l1_cos_theta1 * theta1_dot;
            let l1_sin_theta1 = l1 * sin_theta1;
            let y1_dot = multiply_add(
                -a * omega,
                sin_omega_t,
                l1_sin_theta1 * theta1_dot,
            );
            let l2_cos_theta2 = l2 * cos_theta2;
            let x2_dot = multiply_add(l2_cos_theta2, theta2_dot, x1_dot);
            let l2_sin_theta2 = l2 * sin_theta2;
            let y2_dot = multiply_add(l2_sin_theta2, theta2_dot, y1_dot);
            let vel_0 = m1 * multiply_add(y1_dot, y1_dot, x1_dot * x1_dot);
            let y0 = a * cos_omega_t;
            let y1 = y0 - l1_cos_theta1;
            let vel_1 = multiply_add(
                m2,
                multiply_add(y2_dot, y2_dot, x2_dot * x2_dot),
                vel_0,
            );
            let y2 = y1 - l2_cos_theta2;
            let m2_y2_dot = m2 * y2_dot;
            let m2_x2_dot = m2 * x2_dot;
            let vel_2 = l1_sin_theta1 * multiply_add(m1, y1_dot, m2_y2_dot);
            let vel_3 = multiply_add(m2 * g, y2, multiply_add(-0.5, vel_1, m1 * g * y1));
            let vel_4 = multiply_add(
                l1_cos_theta1,
                multiply_add(m1, x1_dot, m2_x2_dot),
                vel_2,
            );
            let vel_5 = multiply_add(
                l2_cos_theta2,
                m2_x2_dot,
                l2_sin_theta2 * m2_y2_dot,
            );
            multiply_add(theta2_dot, vel_5, multiply_add(theta1_dot, vel_4, vel_3))
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 13 additions, 32 multiplications, 3 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            q: &[f64; 2],
            v: &[f64; 2],
            accelerations: &[f64; 2],
        ) -> [f64; 2] {
            let Self { m1, m2, l1, l2, a, omega, g } = *self;
            let [theta1, theta2] = *q;
            let [theta1_dot, theta2_dot] = *v;
            let [theta1_ddot, theta2_ddot] = *accelerations;
            let [(sin_theta1, cos_theta1), (sin_theta2, cos_theta2), (_, cos_omega_t)] = sin_cos_each([
                theta1,
                theta2,
                omega * t,
            ]);
            let theta1_dot_sq = theta1_dot * theta1_dot;
            let pos_0 = a * omega * omega * cos_omega_t;
            let acc_0 = multiply_add(
                sin_theta1,
                theta1_ddot,
                cos_theta1 * theta1_dot_sq,
            );
            let acc_1 = multiply_add(-l1, acc_0, pos_0);
            let theta2_dot_sq = theta2_dot * theta2_dot;
            let acc_2 = multiply_add(
                sin_theta2,
                theta2_ddot,
                cos_theta2 * theta2_dot_sq,
            );
            let acc_3 = multiply_add(m2, multiply_add(l2, acc_2, -acc_1), m2 * g);
            let acc_4 = l1
                * multiply_add(-cos_theta1, theta1_ddot, sin_theta1 * theta1_dot_sq);
            let acc_5 = multiply_add(
                -cos_theta2,
                theta2_ddot,
                sin_theta2 * theta2_dot_sq,
            );
            let acc_6 = m2 * multiply_add(l2, acc_5, acc_4);
            let acc_7 = l1 * sin_theta1 * (multiply_add(-m1, acc_1, m1 * g) + acc_3);
            [
                multiply_add(-l1 * cos_theta1, multiply_add(m1, acc_4, acc_6), acc_7),
                multiply_add(-l2 * cos_theta2, acc_6, l2 * sin_theta2 * acc_3),
            ]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, y: &[f64; 4]) -> [f64; 4] {
            let [theta1, theta2, theta1_dot, theta2_dot] = *y;
            let accelerations = self
                .acceleration(t, &[theta1, theta2], &[theta1_dot, theta2_dot]);
            [theta1_dot, theta2_dot, accelerations[0], accelerations[1]]
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for ShakenDoublePendulum {
        fn default() -> Self {
            Self {
                m1: 1.0,
                m2: 1.0,
                l1: 1.0,
                l2: 1.0,
                a: 0.1,
                omega: 20.0,
                g: 9.81,
            }
        }
    }
    impl ShakenDoublePendulumState {
        /// The coordinates in their order.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [f64; 2] {
            [self.theta1, self.theta2]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [f64; 2] {
            [self.theta1_dot, self.theta2_dot]
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 4]> for ShakenDoublePendulumState {
        #[inline]
        fn from([theta1, theta2, theta1_dot, theta2_dot]: [f64; 4]) -> Self {
            Self {
                theta1,
                theta2,
                theta1_dot,
                theta2_dot,
            }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<ShakenDoublePendulumState> for [f64; 4] {
        #[inline]
        fn from(state: ShakenDoublePendulumState) -> Self {
            [state.theta1, state.theta2, state.theta1_dot, state.theta2_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> ShakenDoublePendulumColumns<C> {
        /// Coordinate `theta1`.
        #[must_use]
        #[inline]
        pub fn theta1(&self) -> &[C::Scalar] {
            self.0.column(0)
        }
        /// Coordinate `theta2`.
        #[must_use]
        #[inline]
        pub fn theta2(&self) -> &[C::Scalar] {
            self.0.column(1)
        }
        /// Velocity of `theta1`.
        #[must_use]
        #[inline]
        pub fn theta1_dot(&self) -> &[C::Scalar] {
            self.0.column(2)
        }
        /// Velocity of `theta2`.
        #[must_use]
        #[inline]
        pub fn theta2_dot(&self) -> &[C::Scalar] {
            self.0.column(3)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for ShakenDoublePendulumColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for ShakenDoublePendulumColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for ShakenDoublePendulum {
        type Scalar = f64;
        type State = [f64; 4];
        #[inline]
        fn rhs(&self, t: f64, y: &[f64; 4]) -> [f64; 4] {
            self.rhs(t, y)
        }
        fn undefined(
            &self,
            t: f64,
            y: &[f64; 4],
            rates: &[f64; 4],
        ) -> ::core::option::Option<::lagrange::system::Undefined<f64>> {
            ::lagrange::integrate::undefined(
                self,
                (t, y, rates),
                &[],
                |q, _| ::core::option::Option::Some(self.mass_matrix(t, q)),
            )
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::MechanicalSystem for ShakenDoublePendulum {
        type Coordinates = [f64; 2];
        type Velocities = [f64; 2];
        type Columns<C> = ShakenDoublePendulumColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &[
            "theta1",
            "theta2",
        ];
        const FINGERPRINT: ::core::primitive::u64 = 11375429752052773372;
        #[inline]
        fn acceleration(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            self.acceleration(t, q, v)
        }
        #[inline]
        fn position_rates(&self, _: f64, _: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            *v
        }
        fn parameter(
            &self,
            index: ::core::primitive::usize,
        ) -> ::core::option::Option<(&'static ::core::primitive::str, f64)> {
            [
                ("m1", self.m1),
                ("m2", self.m2),
                ("l1", self.l1),
                ("l2", self.l2),
                ("a", self.a),
                ("omega", self.omega),
                ("g", self.g),
            ]
                .get(index)
                .copied()
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for ShakenDoublePendulum {
        type NamedState = ShakenDoublePendulumState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for ShakenDoublePendulum {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
            self.energy(t, q, v)
        }
    }
};
