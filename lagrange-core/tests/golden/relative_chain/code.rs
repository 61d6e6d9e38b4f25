/// Three point masses on massless rods, in joint angles.
///
/// # Equations of motion
///
/// ```text
/// (2*(m2 + m3)*l1*l2*cos(q2) + (m2 + m3)*l2^2 + (m1 + m2 + m3)*l1^2 + 2*m3*l1*l3*cos(q2 + q3) + 2*m3*l2*l3*cos(q3) + m3*l3^2)*ddot(q1)
///     + ((m2 + m3)*l1*l2*cos(q2) + (m2 + m3)*l2^2 + m3*l1*l3*cos(q2 + q3) + 2*m3*l2*l3*cos(q3) + m3*l3^2)*ddot(q2)
///     + (m3*l1*l3*cos(q2 + q3) + m3*l2*l3*cos(q3) + m3*l3^2)*ddot(q3)
///     = 2*(m2 + m3)*l1*l2*sin(q2)*dot(q1)*dot(q2) + (m2 + m3)*l1*l2*sin(q2)*dot(q2)^2
///     + 2*m3*l1*l3*sin(q2 + q3)*dot(q1)*dot(q2) + 2*m3*l1*l3*sin(q2 + q3)*dot(q1)*dot(q3)
///     + m3*l1*l3*sin(q2 + q3)*dot(q2)^2 + 2*m3*l1*l3*sin(q2 + q3)*dot(q2)*dot(q3)
///     + m3*l1*l3*sin(q2 + q3)*dot(q3)^2 + 2*m3*l2*l3*sin(q3)*dot(q1)*dot(q3)
///     + 2*m3*l2*l3*sin(q3)*dot(q2)*dot(q3) + m3*l2*l3*sin(q3)*dot(q3)^2 - (m2 + m3)*l2*g*sin(q1 + q2)
///     - (m1 + m2 + m3)*l1*g*sin(q1) - m3*l3*g*sin(q1 + q2 + q3)
/// ((m2 + m3)*l1*l2*cos(q2) + (m2 + m3)*l2^2 + m3*l1*l3*cos(q2 + q3) + 2*m3*l2*l3*cos(q3) + m3*l3^2)*ddot(q1)
///     + ((m2 + m3)*l2^2 + 2*m3*l2*l3*cos(q3) + m3*l3^2)*ddot(q2)
///     + (m3*l2*l3*cos(q3) + m3*l3^2)*ddot(q3) = 2*m3*l2*l3*sin(q3)*dot(q1)*dot(q3)
///     - (m2 + m3)*l1*l2*sin(q2)*dot(q1)^2 - m3*l1*l3*sin(q2 + q3)*dot(q1)^2
///     + 2*m3*l2*l3*sin(q3)*dot(q2)*dot(q3) + m3*l2*l3*sin(q3)*dot(q3)^2 - (m2 + m3)*l2*g*sin(q1 + q2)
///     - m3*l3*g*sin(q1 + q2 + q3)
/// (m3*l1*l3*cos(q2 + q3) + m3*l2*l3*cos(q3) + m3*l3^2)*ddot(q1)
///     + (m3*l2*l3*cos(q3) + m3*l3^2)*ddot(q2) + m3*l3^2*ddot(q3) = -m3*l1*l3*sin(q2 + q3)*dot(q1)^2
///     - m3*l2*l3*sin(q3)*dot(q1)^2 - 2*m3*l2*l3*sin(q3)*dot(q1)*dot(q2) - m3*l2*l3*sin(q3)*dot(q2)^2
///     - m3*l3*g*sin(q1 + q2 + q3)
/// ```
///
/// # State and structure
///
/// - State: `[q1, q2, q3, q1_dot, q2_dot, q3_dot]`.
/// - Mass matrix: full, depends on the configuration.
/// - Conserved: the energy function.
/// - Forward dynamics: eliminated body by body, the kinetic energy kept a sum of squares (counted cost 352; factorised mass matrix 420, recursion 445).
/// - Cost of `acceleration`: 17 additions, 40 multiplications, 5 divisions, 3 `sin_cos`.
pub struct RelativeChain {
    /// Parameter `m1`.
    pub m1: ::core::primitive::f64,
    /// Parameter `m2`.
    pub m2: ::core::primitive::f64,
    /// Parameter `m3`.
    pub m3: ::core::primitive::f64,
    /// Parameter `l1`.
    pub l1: ::core::primitive::f64,
    /// Parameter `l2`.
    pub l2: ::core::primitive::f64,
    /// Parameter `l3`.
    pub l3: ::core::primitive::f64,
    /// Parameter `g`.
    pub g: ::core::primitive::f64,
}
/// State of [`RelativeChain`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RelativeChainState {
    /// Coordinate `q1`.
    pub q1: ::core::primitive::f64,
    /// Coordinate `q2`.
    pub q2: ::core::primitive::f64,
    /// Coordinate `q3`.
    pub q3: ::core::primitive::f64,
    /// Velocity of `q1`.
    pub q1_dot: ::core::primitive::f64,
    /// Velocity of `q2`.
    pub q2_dot: ::core::primitive::f64,
    /// Velocity of `q3`.
    pub q3_dot: ::core::primitive::f64,
}
/// Columns of a table of states of [`RelativeChain`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct RelativeChainColumns<C>(C);
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::{cos, multiply_add, sin_cos};
    impl RelativeChain {
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 17 additions, 40 multiplications, 5 divisions, 3 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> [f64; 3] {
            let Self { m1, m2, m3, l1, l2, l3, g } = *self;
            let [q1, q2, q3] = *q;
            let [q1_dot, q2_dot, q3_dot] = *v;
            let (sin_q3, cos_q3) = sin_cos(q3);
            let m3_sin_q3 = m3 * sin_q3;
            let pivot_1 = multiply_add(sin_q3, m3_sin_q3, m2);
            let inv_pivot_1 = 1.0 / pivot_1;
            let pos_0 = m2 * inv_pivot_1 * (m2 + m3);
            let (sin_q2, cos_q2) = sin_cos(q2);
            let pos_1 = sin_q2 * pos_0;
            let pivot_0 = multiply_add(sin_q2, pos_1, m1);
            let inv_pivot_0 = 1.0 / pivot_0;
            let a2_dot = q1_dot + q2_dot;
            let a3_dot = a2_dot + q3_dot;
            let a3_dot_sq = a3_dot * a3_dot;
            let a2_dot_sq = a2_dot * a2_dot;
            let l2_a2_dot_sq = l2 * a2_dot_sq;
            let vel_0 = l3 * a3_dot_sq * cos_q3 * m2 * inv_pivot_1 * m3;
            let (sin_q1, cos_q1) = sin_cos(q1);
            let q1_dot_sq = q1_dot * q1_dot;
            let normal_0 = multiply_add(l1, q1_dot_sq, g * cos_q1);
            let vel_1 = sin_q2 * inv_pivot_0 * multiply_add(pos_0, l2_a2_dot_sq, vel_0);
            let vel_2 = multiply_add(inv_pivot_0 * cos_q2 * pos_1, normal_0, vel_1);
            let vel_3 = 1.0 / l1 * multiply_add(g, sin_q1, -vel_2);
            let q1_ddot = -vel_3;
            let normal_1 = multiply_add(
                -sin_q2,
                vel_2,
                multiply_add(cos_q2, normal_0, l2_a2_dot_sq),
            );
            let vel_4 = m3 * l3 * sin_q3 * inv_pivot_1 * a3_dot_sq;
            let vel_5 = multiply_add(inv_pivot_1 * m3_sin_q3 * cos_q3, normal_1, vel_4);
            let vel_6 = 1.0 / l2
                * multiply_add(-cos_q2, vel_2, multiply_add(-sin_q2, normal_0, vel_5));
            let q2_ddot = vel_3 + vel_6;
            let q3_ddot = -multiply_add(
                1.0 / l3,
                multiply_add(cos_q3, vel_5, sin_q3 * normal_1),
                vel_6,
            );
            [q1_ddot, q2_ddot, q3_ddot]
        }
        /// Mass matrix M, in rows.
        ///
        /// Takes 19 additions, 22 multiplications, 3 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f64, q: &[f64; 3]) -> [[f64; 3]; 3] {
            let Self { m1, m2, m3, l1, l2, l3, .. } = *self;
            let [q1, q2, q3] = *q;
            let a2 = q1 + q2;
            let a3 = a2 + q3;
            let (sin_a3, cos_a3) = sin_cos(a3);
            let m3_l3 = m3 * l3;
            let m3_l3_sin_a3 = m3_l3 * sin_a3;
            let (sin_a2, cos_a2) = sin_cos(a2);
            let m2_plus_m3 = m2 + m3;
            let const_0 = l2 * m2_plus_m3;
            let (sin_q1, cos_q1) = sin_cos(q1);
            let l1_sin_q1 = l1 * sin_q1;
            let pos_0 = l1_sin_q1 * multiply_add(const_0, sin_a2, m3_l3_sin_a3);
            let m3_l3_cos_a3 = m3_l3 * cos_a3;
            let pos_1 = multiply_add(
                l2 * cos_a2,
                m3_l3_cos_a3,
                l2 * sin_a2 * m3_l3_sin_a3,
            );
            let l1_cos_q1 = l1 * cos_q1;
            let pos_2 = l1_cos_q1 * multiply_add(const_0, cos_a2, m3_l3_cos_a3);
            let m_2_2 = l3 * m3_l3;
            let const_1 = multiply_add(l2, const_0, m_2_2);
            let l1_sq = l1 * l1;
            let const_2 = multiply_add(l1_sq, m1 + m2_plus_m3, const_1);
            let m_0_0 = multiply_add(2.0, pos_1 + pos_0 + pos_2, const_2);
            let pos_3 = 2.0 * pos_1;
            let m_0_1 = const_1 + pos_0 + pos_2 + pos_3;
            let m_1_2 = m_2_2 + pos_1;
            let pos_4 = multiply_add(l1_sin_q1, m3_l3_sin_a3, m_1_2);
            let m_0_2 = multiply_add(l1_cos_q1, m3_l3_cos_a3, pos_4);
            let m_1_1 = const_1 + pos_3;
            [[m_0_0, m_0_1, m_0_2], [m_0_1, m_1_1, m_1_2], [m_0_2, m_1_2, m_2_2]]
        }
        /// Right-hand side f of M q̈ = f.
        ///
        /// Takes 21 additions, 30 multiplications, 3 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> [f64; 3] {
            let Self { m1, m2, m3, l1, l2, l3, g } = *self;
            let [q1, q2, q3] = *q;
            let [q1_dot, q2_dot, q3_dot] = *v;
            let (sin_q1, cos_q1) = sin_cos(q1);
            let l1_cos_q1 = l1 * cos_q1;
            let q1_dot_sq = q1_dot * q1_dot;
            let l1_cos_q1_q1_dot_sq = l1_cos_q1 * q1_dot_sq;
            let a2 = q1 + q2;
            let (sin_a2, cos_a2) = sin_cos(a2);
            let l2_cos_a2 = l2 * cos_a2;
            let a2_dot = q1_dot + q2_dot;
            let a2_dot_sq = a2_dot * a2_dot;
            let vel_0 = multiply_add(l2_cos_a2, a2_dot_sq, l1_cos_q1_q1_dot_sq);
            let a3 = a2 + q3;
            let (sin_a3, cos_a3) = sin_cos(a3);
            let l3_cos_a3 = l3 * cos_a3;
            let a3_dot = a2_dot + q3_dot;
            let a3_dot_sq = a3_dot * a3_dot;
            let vel_1 = multiply_add(
                m3,
                multiply_add(l3_cos_a3, a3_dot_sq, vel_0),
                m3 * g,
            );
            let vel_2 = multiply_add(m2, vel_0, m2 * g) + vel_1;
            let l2_sin_a2 = l2 * sin_a2;
            let l1_sin_q1 = l1 * sin_q1;
            let l1_sin_q1_q1_dot_sq = l1_sin_q1 * q1_dot_sq;
            let vel_3 = multiply_add(l2_sin_a2, a2_dot_sq, l1_sin_q1_q1_dot_sq);
            let l3_sin_a3 = l3 * sin_a3;
            let vel_4 = m3 * multiply_add(l3_sin_a3, a3_dot_sq, vel_3);
            let vel_5 = multiply_add(m2, vel_3, vel_4);
            let vel_6 = multiply_add(-l2_cos_a2, vel_5, l2_sin_a2 * vel_2);
            let vel_7 = multiply_add(-l3_cos_a3, vel_4, l3_sin_a3 * vel_1);
            let vel_8 = multiply_add(
                l1_cos_q1,
                multiply_add(m1, l1_sin_q1_q1_dot_sq, vel_5),
                -vel_7,
            );
            let vel_9 = multiply_add(m1, l1_cos_q1_q1_dot_sq, m1 * g) + vel_2;
            [multiply_add(-l1_sin_q1, vel_9, vel_8 - vel_6), -(vel_7 + vel_6), -vel_7]
        }
        /// Generalised momenta ∂L/∂v.
        ///
        /// Takes 17 additions, 24 multiplications, 3 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn momenta(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> [f64; 3] {
            let Self { m1, m2, m3, l1, l2, l3, .. } = *self;
            let [q1, q2, q3] = *q;
            let [q1_dot, q2_dot, q3_dot] = *v;
            let (sin_q1, cos_q1) = sin_cos(q1);
            let l1_sin_q1 = l1 * sin_q1;
            let y1_dot = l1_sin_q1 * q1_dot;
            let a2 = q1 + q2;
            let (sin_a2, cos_a2) = sin_cos(a2);
            let l2_sin_a2 = l2 * sin_a2;
            let a2_dot = q1_dot + q2_dot;
            let y2_dot = multiply_add(l2_sin_a2, a2_dot, y1_dot);
            let a3 = a2 + q3;
            let (sin_a3, cos_a3) = sin_cos(a3);
            let l3_sin_a3 = l3 * sin_a3;
            let a3_dot = a2_dot + q3_dot;
            let y3_dot = multiply_add(l3_sin_a3, a3_dot, y2_dot);
            let m3_y3_dot = m3 * y3_dot;
            let vel_0 = multiply_add(m2, y2_dot, m3_y3_dot);
            let l1_cos_q1 = l1 * cos_q1;
            let x1_dot = l1_cos_q1 * q1_dot;
            let l2_cos_a2 = l2 * cos_a2;
            let x2_dot = multiply_add(l2_cos_a2, a2_dot, x1_dot);
            let l3_cos_a3 = l3 * cos_a3;
            let x3_dot = multiply_add(l3_cos_a3, a3_dot, x2_dot);
            let m3_x3_dot = m3 * x3_dot;
            let vel_1 = multiply_add(m2, x2_dot, m3_x3_dot);
            let vel_2 = multiply_add(l3_cos_a3, m3_x3_dot, l3_sin_a3 * m3_y3_dot);
            let vel_3 = vel_2 + multiply_add(l2_cos_a2, vel_1, l2_sin_a2 * vel_0);
            let vel_4 = multiply_add(l1_sin_q1, multiply_add(m1, y1_dot, vel_0), vel_3);
            [
                multiply_add(l1_cos_q1, multiply_add(m1, x1_dot, vel_1), vel_4),
                vel_3,
                vel_2,
            ]
        }
        /// Kinetic energy T.
        ///
        /// Takes 13 additions, 22 multiplications, 3 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> f64 {
            let Self { m1, m2, m3, l1, l2, l3, .. } = *self;
            let [q1, q2, q3] = *q;
            let [q1_dot, q2_dot, q3_dot] = *v;
            let (sin_q1, cos_q1) = sin_cos(q1);
            let x1_dot = l1 * cos_q1 * q1_dot;
            let y1_dot = l1 * sin_q1 * q1_dot;
            let a2 = q1 + q2;
            let (sin_a2, cos_a2) = sin_cos(a2);
            let a2_dot = q1_dot + q2_dot;
            let x2_dot = multiply_add(l2 * cos_a2, a2_dot, x1_dot);
            let y2_dot = multiply_add(l2 * sin_a2, a2_dot, y1_dot);
            let vel_0 = m1 * multiply_add(y1_dot, y1_dot, x1_dot * x1_dot);
            let a3 = a2 + q3;
            let (sin_a3, cos_a3) = sin_cos(a3);
            let a3_dot = a2_dot + q3_dot;
            let x3_dot = multiply_add(l3 * cos_a3, a3_dot, x2_dot);
            let y3_dot = multiply_add(l3 * sin_a3, a3_dot, y2_dot);
            let vel_1 = multiply_add(
                m2,
                multiply_add(y2_dot, y2_dot, x2_dot * x2_dot),
                vel_0,
            );
            0.5 * multiply_add(m3, multiply_add(y3_dot, y3_dot, x3_dot * x3_dot), vel_1)
        }
        /// Potential energy V.
        ///
        /// Takes 6 additions, 9 multiplications, 3 functions.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, q: &[f64; 3]) -> f64 {
            let Self { m1, m2, m3, l1, l2, l3, g } = *self;
            let [q1, q2, q3] = *q;
            let l1_cos_q1 = l1 * cos(q1);
            let a2 = q1 + q2;
            let y2 = -multiply_add(l2, cos(a2), l1_cos_q1);
            let a3 = a2 + q3;
            let y3 = multiply_add(-l3, cos(a3), y2);
            multiply_add(m3 * g, y3, multiply_add(-m1 * g, l1_cos_q1, m2 * g * y2))
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 18 additions, 28 multiplications, 3 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> f64 {
            let Self { m1, m2, m3, l1, l2, l3, g } = *self;
            let [q1, q2, q3] = *q;
            let [q1_dot, q2_dot, q3_dot] = *v;
            let (sin_q1, cos_q1) = sin_cos(q1);
            let l1_cos_q1 = l1 * cos_q1;
            let x1_dot = l1_cos_q1 * q1_dot;
            let y1_dot = l1 * sin_q1 * q1_dot;
            let a2 = q1 + q2;
            let (sin_a2, cos_a2) = sin_cos(a2);
            let l2_cos_a2 = l2 * cos_a2;
            let a2_dot = q1_dot + q2_dot;
            let x2_dot = multiply_add(l2_cos_a2, a2_dot, x1_dot);
            let y2_dot = multiply_add(l2 * sin_a2, a2_dot, y1_dot);
            let vel_0 = m1 * multiply_add(y1_dot, y1_dot, x1_dot * x1_dot);
            let a3 = a2 + q3;
            let (sin_a3, cos_a3) = sin_cos(a3);
            let l3_cos_a3 = l3 * cos_a3;
            let a3_dot = a2_dot + q3_dot;
            let x3_dot = multiply_add(l3_cos_a3, a3_dot, x2_dot);
            let y3_dot = multiply_add(l3 * sin_a3, a3_dot, y2_dot);
            let vel_1 = multiply_add(
                m2,
                multiply_add(y2_dot, y2_dot, x2_dot * x2_dot),
                vel_0,
            );
            let vel_2 = 0.5
                * multiply_add(m3, multiply_add(y3_dot, y3_dot, x3_dot * x3_dot), vel_1);
            let y2 = -(l1_cos_q1 + l2_cos_a2);
            let y3 = y2 - l3_cos_a3;
            let vel_3 = multiply_add(
                m2 * g,
                y2,
                multiply_add(-m1 * g, l1_cos_q1, vel_2),
            );
            multiply_add(m3 * g, y3, vel_3)
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 28 additions, 42 multiplications, 3 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            q: &[f64; 3],
            v: &[f64; 3],
            a: &[f64; 3],
        ) -> [f64; 3] {
            let Self { m1, m2, m3, l1, l2, l3, g } = *self;
            let [q1, q2, q3] = *q;
            let [q1_dot, q2_dot, q3_dot] = *v;
            let [q1_ddot, q2_ddot, q3_ddot] = *a;
            let (sin_q1, cos_q1) = sin_cos(q1);
            let q1_dot_sq = q1_dot * q1_dot;
            let acc_0 = l1 * multiply_add(sin_q1, q1_ddot, cos_q1 * q1_dot_sq);
            let a2 = q1 + q2;
            let (sin_a2, cos_a2) = sin_cos(a2);
            let a2_dot = q1_dot + q2_dot;
            let a2_dot_sq = a2_dot * a2_dot;
            let q1_ddot_plus_q2_ddot = q1_ddot + q2_ddot;
            let acc_1 = multiply_add(sin_a2, q1_ddot_plus_q2_ddot, cos_a2 * a2_dot_sq);
            let acc_2 = multiply_add(l2, acc_1, acc_0);
            let a3 = a2 + q3;
            let (sin_a3, cos_a3) = sin_cos(a3);
            let a3_dot = a2_dot + q3_dot;
            let a3_dot_sq = a3_dot * a3_dot;
            let acc_3 = q1_ddot_plus_q2_ddot + q3_ddot;
            let acc_4 = multiply_add(
                l3,
                multiply_add(sin_a3, acc_3, cos_a3 * a3_dot_sq),
                acc_2,
            );
            let acc_5 = multiply_add(m3, acc_4, m3 * g);
            let acc_6 = multiply_add(m2, acc_2, m2 * g) + acc_5;
            let acc_7 = l1 * multiply_add(-cos_q1, q1_ddot, sin_q1 * q1_dot_sq);
            let acc_8 = multiply_add(-cos_a2, q1_ddot_plus_q2_ddot, sin_a2 * a2_dot_sq);
            let acc_9 = multiply_add(l2, acc_8, acc_7);
            let acc_10 = m3
                * multiply_add(
                    l3,
                    multiply_add(-cos_a3, acc_3, sin_a3 * a3_dot_sq),
                    acc_9,
                );
            let acc_11 = multiply_add(m2, acc_9, acc_10);
            let acc_12 = multiply_add(-l3 * cos_a3, acc_10, l3 * sin_a3 * acc_5);
            let acc_13 = acc_12
                + multiply_add(-l2 * cos_a2, acc_11, l2 * sin_a2 * acc_6);
            let acc_14 = multiply_add(
                l1 * sin_q1,
                multiply_add(m1, acc_0, m1 * g) + acc_6,
                acc_13,
            );
            [
                multiply_add(-l1 * cos_q1, multiply_add(m1, acc_7, acc_11), acc_14),
                acc_13,
                acc_12,
            ]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, y: &[f64; 6]) -> [f64; 6] {
            let [q1, q2, q3, q1_dot, q2_dot, q3_dot] = *y;
            let a = self.acceleration(t, &[q1, q2, q3], &[q1_dot, q2_dot, q3_dot]);
            [q1_dot, q2_dot, q3_dot, a[0], a[1], a[2]]
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for RelativeChain {
        fn default() -> Self {
            Self {
                m1: 1.0,
                m2: 1.0,
                m3: 1.0,
                l1: 1.0,
                l2: 1.0,
                l3: 1.0,
                g: 9.81,
            }
        }
    }
    impl RelativeChainState {
        /// The coordinates in their order.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [f64; 3] {
            [self.q1, self.q2, self.q3]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [f64; 3] {
            [self.q1_dot, self.q2_dot, self.q3_dot]
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 6]> for RelativeChainState {
        #[inline]
        fn from([q1, q2, q3, q1_dot, q2_dot, q3_dot]: [f64; 6]) -> Self {
            Self {
                q1,
                q2,
                q3,
                q1_dot,
                q2_dot,
                q3_dot,
            }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<RelativeChainState> for [f64; 6] {
        #[inline]
        fn from(state: RelativeChainState) -> Self {
            [state.q1, state.q2, state.q3, state.q1_dot, state.q2_dot, state.q3_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> RelativeChainColumns<C> {
        /// Coordinate `q1`.
        #[must_use]
        #[inline]
        pub fn q1(&self) -> &[C::Scalar] {
            self.0.column(0)
        }
        /// Coordinate `q2`.
        #[must_use]
        #[inline]
        pub fn q2(&self) -> &[C::Scalar] {
            self.0.column(1)
        }
        /// Coordinate `q3`.
        #[must_use]
        #[inline]
        pub fn q3(&self) -> &[C::Scalar] {
            self.0.column(2)
        }
        /// Velocity of `q1`.
        #[must_use]
        #[inline]
        pub fn q1_dot(&self) -> &[C::Scalar] {
            self.0.column(3)
        }
        /// Velocity of `q2`.
        #[must_use]
        #[inline]
        pub fn q2_dot(&self) -> &[C::Scalar] {
            self.0.column(4)
        }
        /// Velocity of `q3`.
        #[must_use]
        #[inline]
        pub fn q3_dot(&self) -> &[C::Scalar] {
            self.0.column(5)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for RelativeChainColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for RelativeChainColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for RelativeChain {
        type Scalar = f64;
        type State = [f64; 6];
        #[inline]
        fn rhs(&self, t: f64, y: &[f64; 6]) -> [f64; 6] {
            self.rhs(t, y)
        }
        fn undefined(
            &self,
            t: f64,
            y: &[f64; 6],
            rates: &[f64; 6],
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
    impl ::lagrange::system::MechanicalSystem for RelativeChain {
        type Coordinates = [f64; 3];
        type Velocities = [f64; 3];
        type Columns<C> = RelativeChainColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &[
            "q1",
            "q2",
            "q3",
        ];
        const FINGERPRINT: ::core::primitive::u64 = 3517158794311022743;
        #[inline]
        fn acceleration(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> [f64; 3] {
            self.acceleration(t, q, v)
        }
        #[inline]
        fn position_rates(&self, _: f64, _: &[f64; 3], v: &[f64; 3]) -> [f64; 3] {
            *v
        }
        fn parameter(
            &self,
            index: ::core::primitive::usize,
        ) -> ::core::option::Option<(&'static ::core::primitive::str, f64)> {
            [
                ("m1", self.m1),
                ("m2", self.m2),
                ("m3", self.m3),
                ("l1", self.l1),
                ("l2", self.l2),
                ("l3", self.l3),
                ("g", self.g),
            ]
                .get(index)
                .copied()
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for RelativeChain {
        type NamedState = RelativeChainState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for RelativeChain {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> f64 {
            self.energy(t, q, v)
        }
    }
};
