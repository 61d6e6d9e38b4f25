/// Three point masses on massless rods, in joint angles.
///
///# Equations of motion
///
///```text
///(2*(m2 + m3)*l1*l2*cos(q2) + (m2 + m3)*l2^2 + (m1 + m2 + m3)*l1^2 + 2*m3*l1*l3*cos(q2 + q3) + 2*m3*l2*l3*cos(q3) + m3*l3^2)*ddot(q1) + ((m2 + m3)*l1*l2*cos(q2) + (m2 + m3)*l2^2 + m3*l1*l3*cos(q2 + q3) + 2*m3*l2*l3*cos(q3) + m3*l3^2)*ddot(q2) + (m3*l1*l3*cos(q2 + q3) + m3*l2*l3*cos(q3) + m3*l3^2)*ddot(q3) = 2*(m2 + m3)*l1*l2*sin(q2)*dot(q1)*dot(q2) + (m2 + m3)*l1*l2*sin(q2)*dot(q2)^2 + 2*m3*l1*l3*sin(q2 + q3)*dot(q1)*dot(q2) + 2*m3*l1*l3*sin(q2 + q3)*dot(q1)*dot(q3) + m3*l1*l3*sin(q2 + q3)*dot(q2)^2 + 2*m3*l1*l3*sin(q2 + q3)*dot(q2)*dot(q3) + m3*l1*l3*sin(q2 + q3)*dot(q3)^2 + 2*m3*l2*l3*sin(q3)*dot(q1)*dot(q3) + 2*m3*l2*l3*sin(q3)*dot(q2)*dot(q3) + m3*l2*l3*sin(q3)*dot(q3)^2 - (m2 + m3)*l2*g*sin(q1 + q2) - (m1 + m2 + m3)*l1*g*sin(q1) - m3*l3*g*sin(q1 + q2 + q3)
///((m2 + m3)*l1*l2*cos(q2) + (m2 + m3)*l2^2 + m3*l1*l3*cos(q2 + q3) + 2*m3*l2*l3*cos(q3) + m3*l3^2)*ddot(q1) + ((m2 + m3)*l2^2 + 2*m3*l2*l3*cos(q3) + m3*l3^2)*ddot(q2) + (m3*l2*l3*cos(q3) + m3*l3^2)*ddot(q3) = 2*m3*l2*l3*sin(q3)*dot(q1)*dot(q3) - (m2 + m3)*l1*l2*sin(q2)*dot(q1)^2 - m3*l1*l3*sin(q2 + q3)*dot(q1)^2 + 2*m3*l2*l3*sin(q3)*dot(q2)*dot(q3) + m3*l2*l3*sin(q3)*dot(q3)^2 - (m2 + m3)*l2*g*sin(q1 + q2) - m3*l3*g*sin(q1 + q2 + q3)
///m3*l3^2*ddot(q3) + (m3*l1*l3*cos(q2 + q3) + m3*l2*l3*cos(q3) + m3*l3^2)*ddot(q1) + (m3*l2*l3*cos(q3) + m3*l3^2)*ddot(q2) = -m3*l1*l3*sin(q2 + q3)*dot(q1)^2 - m3*l2*l3*sin(q3)*dot(q1)^2 - 2*m3*l2*l3*sin(q3)*dot(q1)*dot(q2) - m3*l2*l3*sin(q3)*dot(q2)^2 - m3*l3*g*sin(q1 + q2 + q3)
///```
///
///# State and structure
///
///- State: `[q1, q2, q3, q1_dot, q2_dot, q3_dot]`.
///- Mass matrix: full, depends on the configuration.
///- Conserved: the energy function.
///- One evaluation of `acceleration`: 47 additions, 66 multiplications, 3 divisions, 3 sin_cos; the mass matrix is factorised, which costs no more than recursion.
pub struct RelativeChain {
    ///Parameter `m1`.
    pub m1: ::core::primitive::f64,
    ///Parameter `m2`.
    pub m2: ::core::primitive::f64,
    ///Parameter `m3`.
    pub m3: ::core::primitive::f64,
    ///Parameter `l1`.
    pub l1: ::core::primitive::f64,
    ///Parameter `l2`.
    pub l2: ::core::primitive::f64,
    ///Parameter `l3`.
    pub l3: ::core::primitive::f64,
    ///Parameter `g`.
    pub g: ::core::primitive::f64,
}
///State of [`RelativeChain`]: coordinates, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RelativeChainState {
    ///Coordinate `q1`.
    pub q1: ::core::primitive::f64,
    ///Coordinate `q2`.
    pub q2: ::core::primitive::f64,
    ///Coordinate `q3`.
    pub q3: ::core::primitive::f64,
    ///Velocity of `q1`.
    pub q1_dot: ::core::primitive::f64,
    ///Velocity of `q2`.
    pub q2_dot: ::core::primitive::f64,
    ///Velocity of `q3`.
    pub q3_dot: ::core::primitive::f64,
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
    impl RelativeChain {
        ///Accelerations in the order of the coordinates.
        #[must_use]
        #[inline]
        pub fn acceleration(
            &self,
            t: f64,
            q: &[f64; 3usize],
            v: &[f64; 3usize],
        ) -> [f64; 3usize] {
            let Self { m1, m2, m3, l1, l2, l3, g } = *self;
            let [q1, q2, q3] = *q;
            let [q1_dot, q2_dot, q3_dot] = *v;
            let a2 = q1 + q2;
            let (sin_a2, cos_a2) = sin_cos(a2);
            let pos_0 = l2 * cos_a2;
            let const_0 = m3 * l3;
            let a3 = a2 + q3;
            let (sin_a3, cos_a3) = sin_cos(a3);
            let pos_1 = const_0 * cos_a3;
            let pos_2 = l2 * sin_a2;
            let pos_3 = const_0 * sin_a3;
            let pos_4 = multiply_add(pos_0, pos_1, pos_2 * pos_3);
            let (sin_q1, cos_q1) = sin_cos(q1);
            let pos_5 = l1 * sin_q1;
            let const_1 = m2 + m3;
            let const_2 = l2 * const_1;
            let pos_6 = pos_5 * multiply_add(const_2, sin_a2, pos_3);
            let pos_7 = l1 * cos_q1;
            let pos_8 = pos_7 * multiply_add(const_2, cos_a2, pos_1);
            let m_2_2 = l3 * const_0;
            let const_3 = multiply_add(l2, const_2, m_2_2);
            let l1_sq = l1 * l1;
            let const_4 = multiply_add(l1_sq, m1 + const_1, const_3);
            let m_0_0 = multiply_add(2.0, pos_4 + pos_6 + pos_8, const_4);
            let inv_m_0_0 = 1.0 / m_0_0;
            let pos_9 = m_2_2 + pos_4;
            let m_0_2 = multiply_add(pos_7, pos_1, multiply_add(pos_5, pos_3, pos_9));
            let l_2_0 = inv_m_0_0 * m_0_2;
            let pos_10 = 2.0 * pos_4;
            let m_0_1 = const_3 + pos_6 + pos_8 + pos_10;
            let l_1_0 = inv_m_0_0 * m_0_1;
            let pivot_1 = multiply_add(-m_0_1, l_1_0, const_3) + pos_10;
            let inv_pivot_1 = 1.0 / pivot_1;
            let pos_11 = multiply_add(-m_0_2, l_1_0, pos_9);
            let l_2_1 = inv_pivot_1 * pos_11;
            let vel_0 = pos_5 * q1_dot * q1_dot;
            let vel_1 = q1_dot + q2_dot;
            let vel_2 = multiply_add(pos_2 * vel_1, vel_1, vel_0);
            let pos_12 = l3 * sin_a3;
            let vel_3 = vel_1 + q3_dot;
            let vel_4 = m3 * multiply_add(pos_12 * vel_3, vel_3, vel_2);
            let vel_5 = multiply_add(m2, vel_2, vel_4);
            let vel_6 = pos_7 * q1_dot * q1_dot;
            let vel_7 = multiply_add(pos_0 * vel_1, vel_1, vel_6);
            let pos_13 = l3 * cos_a3;
            let vel_8 = multiply_add(
                m3,
                g,
                m3 * multiply_add(pos_13 * vel_3, vel_3, vel_7),
            );
            let vel_9 = multiply_add(m2, g, m2 * vel_7) + vel_8;
            let vel_10 = multiply_add(-pos_13, vel_4, pos_12 * vel_8);
            let vel_11 = vel_10 + multiply_add(-pos_0, vel_5, pos_2 * vel_9);
            let vel_12 = multiply_add(
                pos_5,
                multiply_add(m1, g, m1 * vel_6) + vel_9,
                vel_11,
            );
            let bias_0 = multiply_add(-pos_7, multiply_add(m1, vel_0, vel_5), vel_12);
            let bias_1 = multiply_add(-l_1_0, bias_0, vel_11);
            let bias_2 = multiply_add(
                -l_2_1,
                bias_1,
                multiply_add(-l_2_0, bias_0, vel_10),
            );
            let pivot_2 = multiply_add(
                -pos_11,
                l_2_1,
                multiply_add(-m_0_2, l_2_0, m_2_2),
            );
            let vel_13 = bias_2 / pivot_2;
            let vel_14 = multiply_add(-l_2_1, vel_13, inv_pivot_1 * bias_1);
            [
                multiply_add(
                    l_2_0,
                    vel_13,
                    multiply_add(-inv_m_0_0, bias_0, l_1_0 * vel_14),
                ),
                -vel_14,
                -vel_13,
            ]
        }
        ///Mass matrix M, in rows.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f64, q: &[f64; 3usize]) -> [[f64; 3usize]; 3usize] {
            let Self { m1, m2, m3, l1, l2, l3, .. } = *self;
            let [q1, q2, q3] = *q;
            let a2 = q1 + q2;
            let (sin_a2, cos_a2) = sin_cos(a2);
            let const_0 = m3 * l3;
            let a3 = a2 + q3;
            let (sin_a3, cos_a3) = sin_cos(a3);
            let pos_0 = const_0 * cos_a3;
            let pos_1 = const_0 * sin_a3;
            let pos_2 = multiply_add(l2 * cos_a2, pos_0, l2 * sin_a2 * pos_1);
            let (sin_q1, cos_q1) = sin_cos(q1);
            let pos_3 = l1 * sin_q1;
            let const_1 = m2 + m3;
            let const_2 = l2 * const_1;
            let pos_4 = pos_3 * multiply_add(const_2, sin_a2, pos_1);
            let pos_5 = l1 * cos_q1;
            let pos_6 = pos_5 * multiply_add(const_2, cos_a2, pos_0);
            let m_2_2 = l3 * const_0;
            let const_3 = multiply_add(l2, const_2, m_2_2);
            let l1_sq = l1 * l1;
            let const_4 = multiply_add(l1_sq, m1 + const_1, const_3);
            let m_0_0 = multiply_add(2.0, pos_2 + pos_4 + pos_6, const_4);
            let pos_7 = 2.0 * pos_2;
            let m_0_1 = const_3 + pos_4 + pos_6 + pos_7;
            let m_1_2 = m_2_2 + pos_2;
            let m_0_2 = multiply_add(pos_5, pos_0, multiply_add(pos_3, pos_1, m_1_2));
            let m_1_1 = const_3 + pos_7;
            [[m_0_0, m_0_1, m_0_2], [m_0_1, m_1_1, m_1_2], [m_0_2, m_1_2, m_2_2]]
        }
        ///Right-hand side f of M q̈ = f.
        #[must_use]
        #[inline]
        pub fn forcing(
            &self,
            t: f64,
            q: &[f64; 3usize],
            v: &[f64; 3usize],
        ) -> [f64; 3usize] {
            let Self { m1, m2, m3, l1, l2, l3, g } = *self;
            let [q1, q2, q3] = *q;
            let [q1_dot, q2_dot, q3_dot] = *v;
            let (sin_q1, cos_q1) = sin_cos(q1);
            let pos_0 = l1 * cos_q1;
            let pos_1 = l1 * sin_q1;
            let vel_0 = pos_1 * q1_dot * q1_dot;
            let a2 = q1 + q2;
            let (sin_a2, cos_a2) = sin_cos(a2);
            let pos_2 = l2 * sin_a2;
            let vel_1 = q1_dot + q2_dot;
            let vel_2 = multiply_add(pos_2 * vel_1, vel_1, vel_0);
            let a3 = a2 + q3;
            let (sin_a3, cos_a3) = sin_cos(a3);
            let pos_3 = l3 * sin_a3;
            let vel_3 = vel_1 + q3_dot;
            let vel_4 = m3 * multiply_add(pos_3 * vel_3, vel_3, vel_2);
            let vel_5 = multiply_add(m2, vel_2, vel_4);
            let vel_6 = pos_0 * q1_dot * q1_dot;
            let pos_4 = l2 * cos_a2;
            let vel_7 = multiply_add(pos_4 * vel_1, vel_1, vel_6);
            let pos_5 = l3 * cos_a3;
            let vel_8 = multiply_add(
                m3,
                g,
                m3 * multiply_add(pos_5 * vel_3, vel_3, vel_7),
            );
            let vel_9 = multiply_add(m2, g, m2 * vel_7) + vel_8;
            let vel_10 = multiply_add(-pos_5, vel_4, pos_3 * vel_8);
            let vel_11 = vel_10 + multiply_add(-pos_4, vel_5, pos_2 * vel_9);
            let vel_12 = multiply_add(
                pos_1,
                multiply_add(m1, g, m1 * vel_6) + vel_9,
                vel_11,
            );
            let bias_0 = multiply_add(-pos_0, multiply_add(m1, vel_0, vel_5), vel_12);
            [-bias_0, -vel_11, -vel_10]
        }
        ///Generalised momenta ∂L/∂v.
        #[must_use]
        #[inline]
        pub fn momenta(
            &self,
            t: f64,
            q: &[f64; 3usize],
            v: &[f64; 3usize],
        ) -> [f64; 3usize] {
            let Self { m1, m2, m3, l1, l2, l3, .. } = *self;
            let [q1, q2, q3] = *q;
            let [q1_dot, q2_dot, q3_dot] = *v;
            let (sin_q1, cos_q1) = sin_cos(q1);
            let pos_0 = l1 * cos_q1;
            let x1_dot = pos_0 * q1_dot;
            let a2 = q1 + q2;
            let (sin_a2, cos_a2) = sin_cos(a2);
            let pos_1 = l2 * cos_a2;
            let vel_0 = q1_dot + q2_dot;
            let x2_dot = multiply_add(pos_1, vel_0, x1_dot);
            let a3 = a2 + q3;
            let (sin_a3, cos_a3) = sin_cos(a3);
            let pos_2 = l3 * cos_a3;
            let vel_1 = vel_0 + q3_dot;
            let x3_dot = multiply_add(pos_2, vel_1, x2_dot);
            let vel_2 = m3 * x3_dot;
            let vel_3 = multiply_add(m2, x2_dot, vel_2);
            let pos_3 = l1 * sin_q1;
            let y1_dot = pos_3 * q1_dot;
            let pos_4 = l2 * sin_a2;
            let y2_dot = multiply_add(pos_4, vel_0, y1_dot);
            let pos_5 = l3 * sin_a3;
            let y3_dot = multiply_add(pos_5, vel_1, y2_dot);
            let vel_4 = m3 * y3_dot;
            let vel_5 = multiply_add(m2, y2_dot, vel_4);
            let vel_6 = multiply_add(pos_2, vel_2, pos_5 * vel_4);
            let vel_7 = vel_6 + multiply_add(pos_1, vel_3, pos_4 * vel_5);
            let vel_8 = multiply_add(pos_3, multiply_add(m1, y1_dot, vel_5), vel_7);
            [multiply_add(pos_0, multiply_add(m1, x1_dot, vel_3), vel_8), vel_7, vel_6]
        }
        ///Kinetic energy T.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(
            &self,
            t: f64,
            q: &[f64; 3usize],
            v: &[f64; 3usize],
        ) -> f64 {
            let Self { m1, m2, m3, l1, l2, l3, .. } = *self;
            let [q1, q2, q3] = *q;
            let [q1_dot, q2_dot, q3_dot] = *v;
            let a2 = q1 + q2;
            let a3 = a2 + q3;
            let (sin_a3, cos_a3) = sin_cos(a3);
            let vel_0 = q1_dot + q2_dot;
            let vel_1 = vel_0 + q3_dot;
            let (sin_a2, cos_a2) = sin_cos(a2);
            let (sin_q1, cos_q1) = sin_cos(q1);
            let y1_dot = l1 * sin_q1 * q1_dot;
            let y2_dot = multiply_add(l2 * sin_a2, vel_0, y1_dot);
            let y3_dot = multiply_add(l3 * sin_a3, vel_1, y2_dot);
            let x1_dot = l1 * cos_q1 * q1_dot;
            let x2_dot = multiply_add(l2 * cos_a2, vel_0, x1_dot);
            let x3_dot = multiply_add(l3 * cos_a3, vel_1, x2_dot);
            let vel_2 = m1 * multiply_add(y1_dot, y1_dot, x1_dot * x1_dot);
            let vel_3 = multiply_add(
                m2,
                multiply_add(y2_dot, y2_dot, x2_dot * x2_dot),
                vel_2,
            );
            0.5 * multiply_add(m3, multiply_add(y3_dot, y3_dot, x3_dot * x3_dot), vel_3)
        }
        ///Potential energy V.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, q: &[f64; 3usize]) -> f64 {
            let Self { m1, m2, m3, l1, l2, l3, g } = *self;
            let [q1, q2, q3] = *q;
            let a2 = q1 + q2;
            let a3 = a2 + q3;
            let pos_0 = l1 * cos(q1);
            let pos_1 = multiply_add(l2, cos(a2), pos_0);
            let pos_2 = multiply_add(m2 * g, pos_1, m1 * g * pos_0);
            -multiply_add(m3 * g, multiply_add(l3, cos(a3), pos_1), pos_2)
        }
        ///Energy function v·∂L/∂v − L.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 3usize], v: &[f64; 3usize]) -> f64 {
            let Self { m1, m2, m3, l1, l2, l3, g } = *self;
            let [q1, q2, q3] = *q;
            let [q1_dot, q2_dot, q3_dot] = *v;
            let (sin_q1, cos_q1) = sin_cos(q1);
            let pos_0 = l1 * cos_q1;
            let a2 = q1 + q2;
            let (sin_a2, cos_a2) = sin_cos(a2);
            let pos_1 = l2 * cos_a2;
            let pos_2 = pos_0 + pos_1;
            let a3 = a2 + q3;
            let (sin_a3, cos_a3) = sin_cos(a3);
            let pos_3 = l3 * cos_a3;
            let vel_0 = q1_dot + q2_dot;
            let vel_1 = vel_0 + q3_dot;
            let y1_dot = l1 * sin_q1 * q1_dot;
            let y2_dot = multiply_add(l2 * sin_a2, vel_0, y1_dot);
            let y3_dot = multiply_add(l3 * sin_a3, vel_1, y2_dot);
            let x1_dot = pos_0 * q1_dot;
            let x2_dot = multiply_add(pos_1, vel_0, x1_dot);
            let x3_dot = multiply_add(pos_3, vel_1, x2_dot);
            let vel_2 = m1 * multiply_add(y1_dot, y1_dot, x1_dot * x1_dot);
            let vel_3 = multiply_add(
                m2,
                multiply_add(y2_dot, y2_dot, x2_dot * x2_dot),
                vel_2,
            );
            let vel_4 = 0.5
                * multiply_add(m3, multiply_add(y3_dot, y3_dot, x3_dot * x3_dot), vel_3);
            let vel_5 = multiply_add(
                -m2 * g,
                pos_2,
                multiply_add(-m1 * g, pos_0, vel_4),
            );
            multiply_add(-m3 * g, pos_2 + pos_3, vel_5)
        }
        ///Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        ///to produce the accelerations `a`.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            q: &[f64; 3usize],
            v: &[f64; 3usize],
            a: &[f64; 3usize],
        ) -> [f64; 3usize] {
            let Self { m1, m2, m3, l1, l2, l3, g } = *self;
            let [q1, q2, q3] = *q;
            let [q1_dot, q2_dot, q3_dot] = *v;
            let [q1_ddot, q2_ddot, q3_ddot] = *a;
            let (sin_q1, cos_q1) = sin_cos(q1);
            let acc_0 = l1 * multiply_add(-cos_q1, q1_ddot, sin_q1 * q1_dot * q1_dot);
            let a2 = q1 + q2;
            let (sin_a2, cos_a2) = sin_cos(a2);
            let acc_1 = q1_ddot + q2_ddot;
            let vel_0 = q1_dot + q2_dot;
            let acc_2 = multiply_add(
                l2,
                multiply_add(-cos_a2, acc_1, sin_a2 * vel_0 * vel_0),
                acc_0,
            );
            let a3 = a2 + q3;
            let (sin_a3, cos_a3) = sin_cos(a3);
            let acc_3 = acc_1 + q3_ddot;
            let vel_1 = vel_0 + q3_dot;
            let acc_4 = multiply_add(
                l3,
                multiply_add(-cos_a3, acc_3, sin_a3 * vel_1 * vel_1),
                acc_2,
            );
            let acc_5 = m3 * acc_4;
            let acc_6 = multiply_add(m2, acc_2, acc_5);
            let acc_7 = l1 * multiply_add(sin_q1, q1_ddot, cos_q1 * q1_dot * q1_dot);
            let acc_8 = multiply_add(
                l2,
                multiply_add(sin_a2, acc_1, cos_a2 * vel_0 * vel_0),
                acc_7,
            );
            let acc_9 = multiply_add(
                l3,
                multiply_add(sin_a3, acc_3, cos_a3 * vel_1 * vel_1),
                acc_8,
            );
            let acc_10 = multiply_add(m3, acc_9, m3 * g);
            let acc_11 = multiply_add(m2, acc_8, m2 * g) + acc_10;
            let acc_12 = multiply_add(-l3 * cos_a3, acc_5, l3 * sin_a3 * acc_10);
            let acc_13 = acc_12
                + multiply_add(-l2 * cos_a2, acc_6, l2 * sin_a2 * acc_11);
            let acc_14 = multiply_add(
                l1 * sin_q1,
                multiply_add(m1, acc_7, m1 * g) + acc_11,
                acc_13,
            );
            [
                multiply_add(-l1 * cos_q1, multiply_add(m1, acc_0, acc_6), acc_14),
                acc_13,
                acc_12,
            ]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, y: &[f64; 6usize]) -> [f64; 6usize] {
            let [q1, q2, q3, q1_dot, q2_dot, q3_dot] = *y;
            let a = self.acceleration(t, &[q1, q2, q3], &[q1_dot, q2_dot, q3_dot]);
            [q1_dot, q2_dot, q3_dot, a[0usize], a[1usize], a[2usize]]
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
    #[automatically_derived]
    impl ::core::convert::From<[f64; 6usize]> for RelativeChainState {
        #[inline]
        fn from([q1, q2, q3, q1_dot, q2_dot, q3_dot]: [f64; 6usize]) -> Self {
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
    impl ::core::convert::From<RelativeChainState> for [f64; 6usize] {
        #[inline]
        fn from(state: RelativeChainState) -> Self {
            [state.q1, state.q2, state.q3, state.q1_dot, state.q2_dot, state.q3_dot]
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for RelativeChain {
        type Scalar = f64;
        type State = [f64; 6usize];
        #[inline]
        fn rhs(&self, t: f64, y: &[f64; 6usize]) -> [f64; 6usize] {
            self.rhs(t, y)
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::MechanicalSystem for RelativeChain {
        type Coordinates = [f64; 3usize];
        const COORDINATES: &'static [&'static ::core::primitive::str] = &[
            "q1",
            "q2",
            "q3",
        ];
        #[inline]
        fn acceleration(
            &self,
            t: f64,
            q: &[f64; 3usize],
            v: &[f64; 3usize],
        ) -> [f64; 3usize] {
            self.acceleration(t, q, v)
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for RelativeChain {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 3usize], v: &[f64; 3usize]) -> f64 {
            self.energy(t, q, v)
        }
    }
};
