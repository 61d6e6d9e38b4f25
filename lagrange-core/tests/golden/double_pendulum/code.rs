///
///# Equations of motion
///
///```text
///(m1 + m2)*l1^2*ddot(theta1) + m2*l1*l2*cos(theta1 - theta2)*ddot(theta2) = -m2*l1*l2*sin(theta1 - theta2)*dot(theta2)^2 - (m1 + m2)*l1*g*sin(theta1)
///m2*l1*l2*cos(theta1 - theta2)*ddot(theta1) + m2*l2^2*ddot(theta2) = m2*l1*l2*sin(theta1 - theta2)*dot(theta1)^2 - m2*l2*g*sin(theta2)
///```
///
///# State and structure
///
///- State: `[theta1, theta2, theta1_dot, theta2_dot]`.
///- Mass matrix: full, depends on the configuration.
///- Conserved: the energy function.
///- One evaluation of `acceleration`: 13 additions, 36 multiplications, 2 divisions, 2 sin_cos; the mass matrix is factorised, which costs no more than recursion.
pub struct DoublePendulum {
    ///Parameter `m1`.
    pub m1: ::core::primitive::f64,
    ///Parameter `m2`.
    pub m2: ::core::primitive::f64,
    ///Parameter `l1`.
    pub l1: ::core::primitive::f64,
    ///Parameter `l2`.
    pub l2: ::core::primitive::f64,
    ///Parameter `g`.
    pub g: ::core::primitive::f64,
}
///State of [`DoublePendulum`]: coordinates, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct DoublePendulumState {
    ///Coordinate `theta1`.
    pub theta1: ::core::primitive::f64,
    ///Coordinate `theta2`.
    pub theta2: ::core::primitive::f64,
    ///Velocity of `theta1`.
    pub theta1_dot: ::core::primitive::f64,
    ///Velocity of `theta2`.
    pub theta2_dot: ::core::primitive::f64,
}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::{cos, multiply_add, sin_cos};
    #[allow(
        unused_variables,
        clippy::excessive_precision,
        clippy::many_single_char_names,
        clippy::similar_names,
        clippy::suboptimal_flops,
        clippy::too_many_lines,
        clippy::trivially_copy_pass_by_ref,
        clippy::unused_self,
        reason = "generated: every method has the arguments that its kind of quantity can depend on, \
                      and the names of the formulas"
    )]
    impl DoublePendulum {
        ///Accelerations in the order of the coordinates.
        #[must_use]
        #[inline]
        pub fn acceleration(
            &self,
            t: f64,
            q: &[f64; 2usize],
            v: &[f64; 2usize],
        ) -> [f64; 2usize] {
            let Self { m1, m2, l1, l2, g } = *self;
            let [theta1, theta2] = *q;
            let [theta1_dot, theta2_dot] = *v;
            let l1_sq = l1 * l1;
            let m_0_0 = l1_sq * (m1 + m2);
            let inv_m_0_0 = 1.0 / m_0_0;
            let (sin_theta1, cos_theta1) = sin_cos(theta1);
            let pos_0 = l1 * cos_theta1;
            let pos_1 = l1 * sin_theta1;
            let vel_0 = pos_1 * theta1_dot * theta1_dot;
            let (sin_theta2, cos_theta2) = sin_cos(theta2);
            let pos_2 = l2 * sin_theta2;
            let vel_1 = m2 * multiply_add(pos_2 * theta2_dot, theta2_dot, vel_0);
            let vel_2 = pos_0 * theta1_dot * theta1_dot;
            let pos_3 = l2 * cos_theta2;
            let vel_3 = multiply_add(
                m2,
                g,
                m2 * multiply_add(pos_3 * theta2_dot, theta2_dot, vel_2),
            );
            let vel_4 = pos_1 * (multiply_add(m1, g, m1 * vel_2) + vel_3);
            let bias_0 = multiply_add(-pos_0, multiply_add(m1, vel_0, vel_1), vel_4);
            let const_0 = m2 * l2;
            let const_1 = l1 * const_0;
            let pos_4 = const_1 * sin_theta1 * sin_theta2;
            let m_0_1 = multiply_add(const_1 * cos_theta1, cos_theta2, pos_4);
            let l_1_0 = inv_m_0_0 * m_0_1;
            let bias_1 = multiply_add(
                -l_1_0,
                bias_0,
                multiply_add(-pos_3, vel_1, pos_2 * vel_3),
            );
            let m_1_1 = l2 * const_0;
            let pivot_1 = multiply_add(-m_0_1, l_1_0, m_1_1);
            let vel_5 = bias_1 / pivot_1;
            [multiply_add(-inv_m_0_0, bias_0, l_1_0 * vel_5), -vel_5]
        }
        ///Mass matrix M, in rows.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f64, q: &[f64; 2usize]) -> [[f64; 2usize]; 2usize] {
            let Self { m1, m2, l1, l2, .. } = *self;
            let [theta1, theta2] = *q;
            let l1_sq = l1 * l1;
            let m_0_0 = l1_sq * (m1 + m2);
            let const_0 = m2 * l2;
            let const_1 = l1 * const_0;
            let (sin_theta1, cos_theta1) = sin_cos(theta1);
            let (sin_theta2, cos_theta2) = sin_cos(theta2);
            let pos_0 = const_1 * sin_theta1 * sin_theta2;
            let m_0_1 = multiply_add(const_1 * cos_theta1, cos_theta2, pos_0);
            let m_1_1 = l2 * const_0;
            [[m_0_0, m_0_1], [m_0_1, m_1_1]]
        }
        ///Right-hand side f of M q̈ = f.
        #[must_use]
        #[inline]
        pub fn forcing(
            &self,
            t: f64,
            q: &[f64; 2usize],
            v: &[f64; 2usize],
        ) -> [f64; 2usize] {
            let Self { m1, m2, l1, l2, g } = *self;
            let [theta1, theta2] = *q;
            let [theta1_dot, theta2_dot] = *v;
            let (sin_theta1, cos_theta1) = sin_cos(theta1);
            let pos_0 = l1 * cos_theta1;
            let pos_1 = l1 * sin_theta1;
            let vel_0 = pos_1 * theta1_dot * theta1_dot;
            let (sin_theta2, cos_theta2) = sin_cos(theta2);
            let pos_2 = l2 * sin_theta2;
            let vel_1 = m2 * multiply_add(pos_2 * theta2_dot, theta2_dot, vel_0);
            let vel_2 = pos_0 * theta1_dot * theta1_dot;
            let pos_3 = l2 * cos_theta2;
            let vel_3 = multiply_add(
                m2,
                g,
                m2 * multiply_add(pos_3 * theta2_dot, theta2_dot, vel_2),
            );
            let vel_4 = pos_1 * (multiply_add(m1, g, m1 * vel_2) + vel_3);
            let bias_0 = multiply_add(-pos_0, multiply_add(m1, vel_0, vel_1), vel_4);
            [-bias_0, multiply_add(-pos_2, vel_3, pos_3 * vel_1)]
        }
        ///Generalised momenta ∂L/∂v.
        #[must_use]
        #[inline]
        pub fn momenta(
            &self,
            t: f64,
            q: &[f64; 2usize],
            v: &[f64; 2usize],
        ) -> [f64; 2usize] {
            let Self { m1, m2, l1, l2, .. } = *self;
            let [theta1, theta2] = *q;
            let [theta1_dot, theta2_dot] = *v;
            let (sin_theta1, cos_theta1) = sin_cos(theta1);
            let pos_0 = l1 * cos_theta1;
            let x1_dot = pos_0 * theta1_dot;
            let (sin_theta2, cos_theta2) = sin_cos(theta2);
            let pos_1 = l2 * cos_theta2;
            let x2_dot = multiply_add(pos_1, theta2_dot, x1_dot);
            let vel_0 = m2 * x2_dot;
            let pos_2 = l1 * sin_theta1;
            let y1_dot = pos_2 * theta1_dot;
            let pos_3 = l2 * sin_theta2;
            let y2_dot = multiply_add(pos_3, theta2_dot, y1_dot);
            let vel_1 = m2 * y2_dot;
            let vel_2 = pos_2 * multiply_add(m1, y1_dot, vel_1);
            [
                multiply_add(pos_0, multiply_add(m1, x1_dot, vel_0), vel_2),
                multiply_add(pos_1, vel_0, pos_3 * vel_1),
            ]
        }
        ///Kinetic energy T.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(
            &self,
            t: f64,
            q: &[f64; 2usize],
            v: &[f64; 2usize],
        ) -> f64 {
            let Self { m1, m2, l1, l2, .. } = *self;
            let [theta1, theta2] = *q;
            let [theta1_dot, theta2_dot] = *v;
            let (sin_theta2, cos_theta2) = sin_cos(theta2);
            let (sin_theta1, cos_theta1) = sin_cos(theta1);
            let y1_dot = l1 * sin_theta1 * theta1_dot;
            let y2_dot = multiply_add(l2 * sin_theta2, theta2_dot, y1_dot);
            let x1_dot = l1 * cos_theta1 * theta1_dot;
            let x2_dot = multiply_add(l2 * cos_theta2, theta2_dot, x1_dot);
            let vel_0 = m1 * multiply_add(y1_dot, y1_dot, x1_dot * x1_dot);
            0.5 * multiply_add(m2, multiply_add(y2_dot, y2_dot, x2_dot * x2_dot), vel_0)
        }
        ///Potential energy V.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, q: &[f64; 2usize]) -> f64 {
            let Self { m1, m2, l1, l2, g } = *self;
            let [theta1, theta2] = *q;
            let pos_0 = l1 * cos(theta1);
            -multiply_add(m2 * g, multiply_add(l2, cos(theta2), pos_0), m1 * g * pos_0)
        }
        ///Energy function v·∂L/∂v − L.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 2usize], v: &[f64; 2usize]) -> f64 {
            let Self { m1, m2, l1, l2, g } = *self;
            let [theta1, theta2] = *q;
            let [theta1_dot, theta2_dot] = *v;
            let (sin_theta1, cos_theta1) = sin_cos(theta1);
            let pos_0 = l1 * cos_theta1;
            let (sin_theta2, cos_theta2) = sin_cos(theta2);
            let pos_1 = l2 * cos_theta2;
            let y1_dot = l1 * sin_theta1 * theta1_dot;
            let y2_dot = multiply_add(l2 * sin_theta2, theta2_dot, y1_dot);
            let x1_dot = pos_0 * theta1_dot;
            let x2_dot = multiply_add(pos_1, theta2_dot, x1_dot);
            let vel_0 = m1 * multiply_add(y1_dot, y1_dot, x1_dot * x1_dot);
            let vel_1 = 0.5
                * multiply_add(m2, multiply_add(y2_dot, y2_dot, x2_dot * x2_dot), vel_0);
            multiply_add(-m2 * g, pos_0 + pos_1, multiply_add(-m1 * g, pos_0, vel_1))
        }
        ///Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        ///to produce the accelerations `a`.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            q: &[f64; 2usize],
            v: &[f64; 2usize],
            a: &[f64; 2usize],
        ) -> [f64; 2usize] {
            let Self { m1, m2, l1, l2, g } = *self;
            let [theta1, theta2] = *q;
            let [theta1_dot, theta2_dot] = *v;
            let [theta1_ddot, theta2_ddot] = *a;
            let (sin_theta1, cos_theta1) = sin_cos(theta1);
            let acc_0 = multiply_add(
                -cos_theta1,
                theta1_ddot,
                sin_theta1 * theta1_dot * theta1_dot,
            );
            let acc_1 = l1 * acc_0;
            let (sin_theta2, cos_theta2) = sin_cos(theta2);
            let acc_2 = multiply_add(
                -cos_theta2,
                theta2_ddot,
                sin_theta2 * theta2_dot * theta2_dot,
            );
            let acc_3 = m2 * multiply_add(l2, acc_2, acc_1);
            let acc_4 = multiply_add(
                sin_theta1,
                theta1_ddot,
                cos_theta1 * theta1_dot * theta1_dot,
            );
            let acc_5 = l1 * acc_4;
            let acc_6 = multiply_add(
                sin_theta2,
                theta2_ddot,
                cos_theta2 * theta2_dot * theta2_dot,
            );
            let acc_7 = multiply_add(m2, multiply_add(l2, acc_6, acc_5), m2 * g);
            let acc_8 = l1 * sin_theta1 * (multiply_add(m1, acc_5, m1 * g) + acc_7);
            [
                multiply_add(-l1 * cos_theta1, multiply_add(m1, acc_1, acc_3), acc_8),
                multiply_add(-l2 * cos_theta2, acc_3, l2 * sin_theta2 * acc_7),
            ]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, y: &[f64; 4usize]) -> [f64; 4usize] {
            let [theta1, theta2, theta1_dot, theta2_dot] = *y;
            let a = self.acceleration(t, &[theta1, theta2], &[theta1_dot, theta2_dot]);
            [theta1_dot, theta2_dot, a[0usize], a[1usize]]
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
    #[automatically_derived]
    impl ::core::convert::From<[f64; 4usize]> for DoublePendulumState {
        #[inline]
        fn from([theta1, theta2, theta1_dot, theta2_dot]: [f64; 4usize]) -> Self {
            Self {
                theta1,
                theta2,
                theta1_dot,
                theta2_dot,
            }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<DoublePendulumState> for [f64; 4usize] {
        #[inline]
        fn from(state: DoublePendulumState) -> Self {
            [state.theta1, state.theta2, state.theta1_dot, state.theta2_dot]
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for DoublePendulum {
        type Scalar = f64;
        type State = [f64; 4usize];
        #[inline]
        fn rhs(&self, t: f64, y: &[f64; 4usize]) -> [f64; 4usize] {
            self.rhs(t, y)
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::MechanicalSystem for DoublePendulum {
        type Coordinates = [f64; 2usize];
        const COORDINATES: &'static [&'static ::core::primitive::str] = &[
            "theta1",
            "theta2",
        ];
        #[inline]
        fn acceleration(
            &self,
            t: f64,
            q: &[f64; 2usize],
            v: &[f64; 2usize],
        ) -> [f64; 2usize] {
            self.acceleration(t, q, v)
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for DoublePendulum {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 2usize], v: &[f64; 2usize]) -> f64 {
            self.energy(t, q, v)
        }
    }
};
