/// A mechanical system with the coordinates `theta1`, `theta2`.
///
/// # Equations of motion
///
/// ```text
/// (m1 + m2)*l1^2*ddot(theta1) + m2*l1*l2*cos(theta1 - theta2)*ddot(theta2)
///     = -m2*l1*l2*sin(theta1 - theta2)*dot(theta2)^2 - (m1 + m2)*l1*g*sin(theta1)
/// m2*l1*l2*cos(theta1 - theta2)*ddot(theta1) + m2*l2^2*ddot(theta2)
///     = m2*l1*l2*sin(theta1 - theta2)*dot(theta1)^2 - m2*l2*g*sin(theta2)
/// ```
///
/// # State and structure
///
/// - State: `[theta1, theta2, theta1_dot, theta2_dot]`.
/// - Mass matrix: full, depends on the configuration.
/// - Conserved: the energy function.
/// - Forward dynamics: eliminated body by body, the kinetic energy kept a sum of squares (counted cost 210; factorised mass matrix 218, recursion 266).
/// - Cost of `acceleration`: 6 additions, 18 multiplications, 3 divisions, 2 `sin_cos`.
pub struct DoublePendulum {
    /// Parameter `m1` in kg.
    pub m1: ::core::primitive::f64,
    /// Parameter `m2` in kg.
    pub m2: ::core::primitive::f64,
    /// Parameter `l1` in m.
    pub l1: ::core::primitive::f64,
    /// Parameter `l2` in m.
    pub l2: ::core::primitive::f64,
    /// Parameter `g` in m/s^2.
    pub g: ::core::primitive::f64,
}
/// State of [`DoublePendulum`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct DoublePendulumState {
    /// Coordinate `theta1` in rad.
    pub theta1: ::core::primitive::f64,
    /// Coordinate `theta2` in rad.
    pub theta2: ::core::primitive::f64,
    /// Velocity of `theta1` in rad/s.
    pub theta1_dot: ::core::primitive::f64,
    /// Velocity of `theta2` in rad/s.
    pub theta2_dot: ::core::primitive::f64,
}
/// Columns of a table of states of [`DoublePendulum`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct DoublePendulumColumns<C>(C);
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::{cos, multiply_add, reciprocal, sin_cos};
    impl DoublePendulum {
        /// Accelerations in the order of the velocities.
        ///
        /// In rad/s^2.
        ///
        /// Takes 6 additions, 18 multiplications, 3 divisions, 2 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let Self { m1, m2, l1, l2, g } = *self;
            let [theta1, theta2] = *q;
            let [theta1_dot, theta2_dot] = *v;
            let (sin_theta1_minus_theta2, cos_theta1_minus_theta2) = sin_cos(
                theta1 - theta2,
            );
            let pos_0 = m2 * sin_theta1_minus_theta2;
            let pivot_0 = multiply_add(sin_theta1_minus_theta2, pos_0, m1);
            let inv_pivot_0 = reciprocal(pivot_0);
            let theta2_dot_sq = theta2_dot * theta2_dot;
            let (sin_theta1, cos_theta1) = sin_cos(theta1);
            let theta1_dot_sq = theta1_dot * theta1_dot;
            let normal_0 = multiply_add(l1, theta1_dot_sq, g * cos_theta1);
            let vel_0 = m2 * l2 * sin_theta1_minus_theta2 * inv_pivot_0 * theta2_dot_sq;
            let minus_tangential_0 = multiply_add(
                inv_pivot_0 * pos_0 * cos_theta1_minus_theta2,
                normal_0,
                vel_0,
            );
            let theta1_ddot = -1.0 / l1
                * multiply_add(g, sin_theta1, minus_tangential_0);
            let vel_1 = sin_theta1_minus_theta2 * normal_0;
            let theta2_ddot = 1.0 / l2
                * multiply_add(cos_theta1_minus_theta2, minus_tangential_0, vel_1);
            [theta1_ddot, theta2_ddot]
        }
        /// Mass matrix M, in rows.
        ///
        /// In kg*m^2.
        ///
        /// Takes 2 additions, 9 multiplications, 2 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f64, q: &[f64; 2]) -> [[f64; 2]; 2] {
            let Self { m1, m2, l1, l2, .. } = *self;
            let [theta1, theta2] = *q;
            let l1_sq = l1 * l1;
            let m_0_0 = l1_sq * (m1 + m2);
            let (sin_theta2, cos_theta2) = sin_cos(theta2);
            let (sin_theta1, cos_theta1) = sin_cos(theta1);
            let m_0_1 = m2 * l1 * l2
                * multiply_add(cos_theta1, cos_theta2, sin_theta1 * sin_theta2);
            let l2_sq = l2 * l2;
            let m_1_1 = m2 * l2_sq;
            [[m_0_0, m_0_1], [m_0_1, m_1_1]]
        }
        /// Right-hand side f of M q̈ = f.
        ///
        /// In N*m.
        ///
        /// Takes 4 additions, 15 multiplications, 2 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let Self { m1, m2, l1, l2, g } = *self;
            let [theta1, theta2] = *q;
            let [theta1_dot, theta2_dot] = *v;
            let (sin_theta2, cos_theta2) = sin_cos(theta2);
            let (sin_theta1, cos_theta1) = sin_cos(theta1);
            let pos_0 = m2 * l1 * l2
                * multiply_add(-cos_theta1, sin_theta2, sin_theta1 * cos_theta2);
            let theta2_dot_sq = theta2_dot * theta2_dot;
            let theta1_dot_sq = theta1_dot * theta1_dot;
            [
                -multiply_add(pos_0, theta2_dot_sq, l1 * g * (m1 + m2) * sin_theta1),
                multiply_add(-m2 * l2 * g, sin_theta2, pos_0 * theta1_dot_sq),
            ]
        }
        /// Generalised momenta ∂L/∂v.
        ///
        /// In J*s.
        ///
        /// Takes 6 additions, 16 multiplications, 2 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn momenta(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let Self { m1, m2, l1, l2, .. } = *self;
            let [theta1, theta2] = *q;
            let [theta1_dot, theta2_dot] = *v;
            let (sin_theta1, cos_theta1) = sin_cos(theta1);
            let l1_sin_theta1 = l1 * sin_theta1;
            let y1_dot = l1_sin_theta1 * theta1_dot;
            let (sin_theta2, cos_theta2) = sin_cos(theta2);
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
        /// In J.
        ///
        /// Takes 5 additions, 15 multiplications, 2 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
            let Self { m1, m2, l1, l2, .. } = *self;
            let [theta1, theta2] = *q;
            let [theta1_dot, theta2_dot] = *v;
            let (sin_theta1, cos_theta1) = sin_cos(theta1);
            let x1_dot = l1 * cos_theta1 * theta1_dot;
            let y1_dot = l1 * sin_theta1 * theta1_dot;
            let (sin_theta2, cos_theta2) = sin_cos(theta2);
            let x2_dot = multiply_add(l2 * cos_theta2, theta2_dot, x1_dot);
            let y2_dot = multiply_add(l2 * sin_theta2, theta2_dot, y1_dot);
            let vel_0 = m1 * multiply_add(y1_dot, y1_dot, x1_dot * x1_dot);
            0.5 * multiply_add(m2, multiply_add(y2_dot, y2_dot, x2_dot * x2_dot), vel_0)
        }
        /// Potential energy V.
        ///
        /// In J.
        ///
        /// Takes 2 additions, 6 multiplications, 2 functions.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, q: &[f64; 2]) -> f64 {
            let Self { m1, m2, l1, l2, g } = *self;
            let [theta1, theta2] = *q;
            let l1_cos_theta1 = l1 * cos(theta1);
            let y2 = -multiply_add(l2, cos(theta2), l1_cos_theta1);
            multiply_add(-m1 * g, l1_cos_theta1, m2 * g * y2)
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// In J.
        ///
        /// Takes 8 additions, 19 multiplications, 2 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
            let Self { m1, m2, l1, l2, g } = *self;
            let [theta1, theta2] = *q;
            let [theta1_dot, theta2_dot] = *v;
            let (sin_theta1, cos_theta1) = sin_cos(theta1);
            let l1_cos_theta1 = l1 * cos_theta1;
            let x1_dot = l1_cos_theta1 * theta1_dot;
            let y1_dot = l1 * sin_theta1 * theta1_dot;
            let (sin_theta2, cos_theta2) = sin_cos(theta2);
            let l2_cos_theta2 = l2 * cos_theta2;
            let x2_dot = multiply_add(l2_cos_theta2, theta2_dot, x1_dot);
            let y2_dot = multiply_add(l2 * sin_theta2, theta2_dot, y1_dot);
            let vel_0 = m1 * multiply_add(y1_dot, y1_dot, x1_dot * x1_dot);
            let vel_1 = 0.5
                * multiply_add(m2, multiply_add(y2_dot, y2_dot, x2_dot * x2_dot), vel_0);
            let y2 = -(l1_cos_theta1 + l2_cos_theta2);
            multiply_add(m2 * g, y2, multiply_add(-m1 * g, l1_cos_theta1, vel_1))
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// In N*m.
        ///
        /// Takes 12 additions, 28 multiplications, 2 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            q: &[f64; 2],
            v: &[f64; 2],
            a: &[f64; 2],
        ) -> [f64; 2] {
            let Self { m1, m2, l1, l2, g } = *self;
            let [theta1, theta2] = *q;
            let [theta1_dot, theta2_dot] = *v;
            let [theta1_ddot, theta2_ddot] = *a;
            let (sin_theta1, cos_theta1) = sin_cos(theta1);
            let theta1_dot_sq = theta1_dot * theta1_dot;
            let acc_0 = l1
                * multiply_add(sin_theta1, theta1_ddot, cos_theta1 * theta1_dot_sq);
            let (sin_theta2, cos_theta2) = sin_cos(theta2);
            let theta2_dot_sq = theta2_dot * theta2_dot;
            let acc_1 = multiply_add(
                sin_theta2,
                theta2_ddot,
                cos_theta2 * theta2_dot_sq,
            );
            let acc_2 = multiply_add(m2, multiply_add(l2, acc_1, acc_0), m2 * g);
            let acc_3 = l1
                * multiply_add(-cos_theta1, theta1_ddot, sin_theta1 * theta1_dot_sq);
            let acc_4 = multiply_add(
                -cos_theta2,
                theta2_ddot,
                sin_theta2 * theta2_dot_sq,
            );
            let acc_5 = m2 * multiply_add(l2, acc_4, acc_3);
            let acc_6 = l1 * sin_theta1 * (multiply_add(m1, acc_0, m1 * g) + acc_2);
            [
                multiply_add(-l1 * cos_theta1, multiply_add(m1, acc_3, acc_5), acc_6),
                multiply_add(-l2 * cos_theta2, acc_5, l2 * sin_theta2 * acc_2),
            ]
        }
        /// Rate of the state: velocities, then accelerations.
        ///
        /// Each is in the unit of its entry of the state over s.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, y: &[f64; 4]) -> [f64; 4] {
            let [theta1, theta2, theta1_dot, theta2_dot] = *y;
            let a = self.acceleration(t, &[theta1, theta2], &[theta1_dot, theta2_dot]);
            [theta1_dot, theta2_dot, a[0], a[1]]
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for DoublePendulum {
        fn default() -> Self {
            Self {
                m1: 1.0,
                m2: 1.0,
                l1: 1.0,
                l2: 1.0,
                g: 9.81,
            }
        }
    }
    impl DoublePendulumState {
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
    impl ::core::convert::From<[f64; 4]> for DoublePendulumState {
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
    impl ::core::convert::From<DoublePendulumState> for [f64; 4] {
        #[inline]
        fn from(state: DoublePendulumState) -> Self {
            [state.theta1, state.theta2, state.theta1_dot, state.theta2_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> DoublePendulumColumns<C> {
        /// Coordinate `theta1` in rad.
        #[must_use]
        #[inline]
        pub fn theta1(&self) -> &[C::Scalar] {
            self.0.column(0)
        }
        /// Coordinate `theta2` in rad.
        #[must_use]
        #[inline]
        pub fn theta2(&self) -> &[C::Scalar] {
            self.0.column(1)
        }
        /// Velocity of `theta1` in rad/s.
        #[must_use]
        #[inline]
        pub fn theta1_dot(&self) -> &[C::Scalar] {
            self.0.column(2)
        }
        /// Velocity of `theta2` in rad/s.
        #[must_use]
        #[inline]
        pub fn theta2_dot(&self) -> &[C::Scalar] {
            self.0.column(3)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for DoublePendulumColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for DoublePendulumColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for DoublePendulum {
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
    impl ::lagrange::system::MechanicalSystem for DoublePendulum {
        type Coordinates = [f64; 2];
        type Velocities = [f64; 2];
        type Columns<C> = DoublePendulumColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &[
            "theta1",
            "theta2",
        ];
        const UNITS: &'static [(
            &'static ::core::primitive::str,
            &'static ::core::primitive::str,
        )] = &[
            ("theta1", "rad"),
            ("theta2", "rad"),
            ("theta1_dot", "rad/s"),
            ("theta2_dot", "rad/s"),
            ("theta1_ddot", "rad/s^2"),
            ("theta2_ddot", "rad/s^2"),
            ("m1", "kg"),
            ("m2", "kg"),
            ("l1", "m"),
            ("l2", "m"),
            ("g", "m/s^2"),
        ];
        const FINGERPRINT: ::core::primitive::u64 = 694020329973207837;
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
                ("g", self.g),
            ]
                .get(index)
                .copied()
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for DoublePendulum {
        type NamedState = DoublePendulumState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for DoublePendulum {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
            self.energy(t, q, v)
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::ParametricSystem for DoublePendulum {
        const NUMBERS: &'static [&'static ::core::primitive::str] = &[
            "m1",
            "m2",
            "l1",
            "l2",
            "g",
        ];
        fn number(
            &self,
            index: ::core::primitive::usize,
        ) -> ::core::option::Option<f64> {
            <[f64]>::get(&[self.m1, self.m2, self.l1, self.l2, self.g], index).copied()
        }
        fn with_number(&self, index: ::core::primitive::usize, value: f64) -> Self {
            let mut other = Self {
                m1: self.m1,
                m2: self.m2,
                l1: self.l1,
                l2: self.l2,
                g: self.g,
            };
            match index {
                0 => other.m1 = value,
                1 => other.m2 = value,
                2 => other.l1 = value,
                3 => other.l2 = value,
                4 => other.g = value,
                _ => {}
            }
            other
        }
    }
};
