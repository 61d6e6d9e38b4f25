/// An arm of two links on a turning base, with a tool.
///
/// # Equations of motion
///
/// ```text
/// (1/3*m*l^2*sin(lift)^2 + m*l*r*sin(lift) + m*r^2 + 0.01)*ddot(turn)
///     = -2/3*m*l^2*sin(lift)*cos(lift)*dot(turn)*dot(lift) - m*l*r*cos(lift)*dot(turn)*dot(lift)
/// 1/3*m*l^2*ddot(lift) = 1/3*m*l^2*sin(lift)*cos(lift)*dot(turn)^2 + 1/2*m*l*r*cos(lift)*dot(turn)^2
///     + 4.905*m*l*sin(lift)
/// ```
///
/// # State and structure
///
/// - State: `[turn, lift, turn_dot, lift_dot]`.
/// - Mass matrix: diagonal, depends on the configuration.
/// - Cyclic coordinates: `turn`.
/// - Conserved: the momentum of `turn`, the energy function.
/// - Forward dynamics: each equation divided by its entry of the mass matrix.
/// - Cost of `acceleration`: 6 additions, 29 multiplications, 2 divisions, 1 `sin_cos`.
///
/// # Statements
///
/// Those about rigid bodies stand for plain ones:
///
/// ```text
/// param m = 2, l = 0.5, r = 0.05;
/// coord turn;
/// let base_w = (0, 0, dot(turn));
/// let base_x = (cos(turn), sin(turn), 0);
/// let base_y = (-sin(turn), cos(turn), 0);
/// let base_T_rotation = 1/2 * 0.01 * base_w.z^2;
/// kinetic = base_T_rotation;
/// let base_V = 3 * m * (9.81 * 0.3);
/// potential = base_V;
/// coord lift;
/// let arm_joint_v = (0, base_w.z * r, 0);
/// let arm_joint_origin = (r * base_x.x, r * base_x.y, 0.3 + 0.1);
/// let arm_w = (-(sin(lift) * base_w.z), dot(lift), cos(lift) * base_w.z);
/// let arm_x = (cos(lift) * base_x.x, cos(lift) * base_x.y, -sin(lift));
/// let arm_z = (sin(lift) * base_x.x, sin(lift) * base_x.y, cos(lift));
/// let arm_center_v = (arm_w.y * (l/2), arm_joint_v.y - arm_w.x * (l/2), 0);
/// let arm_T_translation = kinetic_energy(m, (arm_center_v.x, arm_center_v.y, 0));
/// kinetic = arm_T_translation;
/// let arm_T_rotation = 1/2 * (m * l^2 / 12) * arm_w.x^2 + 1/2 * (m * l^2 / 12) * arm_w.y^2;
/// kinetic = arm_T_rotation;
/// let arm_V = m * (9.81 * (arm_joint_origin.z + l/2 * arm_z.z));
/// potential = arm_V;
/// let tool_joint_origin = (arm_joint_origin.x + l * arm_z.x, arm_joint_origin.y + l * arm_z.y, arm_joint_origin.z + l * arm_z.z);
/// let tool_z = (-base_y.x, -base_y.y, 0);
/// let arm_moment = (0, 0, m * (l/2));
/// let arm_J = (m * l^2 / 12 + m * (l/2) * (l/2), m * l^2 / 12 + m * (l/2) * (l/2), 0);
/// let base_J = (0.1 * (0.1 * m), 0.1 * (0.1 * m) + m * r * r, m * r * r);
/// let base_alpha = (0, 0, ddot(turn));
/// let base_w_squares = (0, 0, base_w.z^2);
/// let base_relative_x = (-base_w_squares.z, -base_alpha.z, 0);
/// let base_relative_y = (base_alpha.z, -base_w_squares.z, 0);
/// let base_S = 1/2 * (0.01 + base_J.z) * base_alpha.z^2;
/// let arm_joint_a = (base_relative_x.x * r, base_relative_y.x * r, 9.81);
/// let arm_alpha = (-(sin(lift) * base_alpha.z) - arm_w.z * dot(lift), ddot(lift), cos(lift) * base_alpha.z + arm_w.x * dot(lift));
/// let arm_a = (cos(lift) * arm_joint_a.x - sin(lift) * 9.81, arm_joint_a.y, cos(lift) * 9.81 + sin(lift) * arm_joint_a.x);
/// let arm_w_squares = (arm_w.x^2, arm_w.y^2, arm_w.z^2);
/// let arm_w_products = (arm_w.y * arm_w.z, arm_w.z * arm_w.x, arm_w.x * arm_w.y);
/// let arm_relative_x = (-(arm_w_squares.y + arm_w_squares.z), arm_w_products.z - arm_alpha.z, arm_w_products.y + arm_alpha.y);
/// let arm_relative_y = (arm_w_products.z + arm_alpha.z, -(arm_w_squares.z + arm_w_squares.x), arm_w_products.x - arm_alpha.x);
/// let arm_relative_z = (arm_w_products.y - arm_alpha.y, arm_w_products.x + arm_alpha.x, -(arm_w_squares.x + arm_w_squares.y));
/// let arm_S = arm_a.x * (arm_relative_x.z * arm_moment.z) + arm_a.y * (arm_relative_y.z * arm_moment.z) + arm_a.z * (arm_relative_z.z * arm_moment.z) + 1/2 * arm_J.x * arm_alpha.x^2 - arm_J.y * arm_w_products.x * arm_alpha.x + 1/2 * arm_J.y * arm_alpha.y^2 + arm_J.x * arm_w_products.y * arm_alpha.y + (arm_J.y - arm_J.x) * arm_w_products.z * arm_alpha.z;
/// gibbs = base_S + arm_S, for: base_T_rotation - base_V + (arm_T_translation + arm_T_rotation - arm_V);
/// ```
pub struct SpatialArm {
    /// Parameter `m`.
    pub m: ::core::primitive::f64,
    /// Parameter `l`.
    pub l: ::core::primitive::f64,
    /// Parameter `r`.
    pub r: ::core::primitive::f64,
}
/// State of [`SpatialArm`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SpatialArmState {
    /// Coordinate `turn`.
    pub turn: ::core::primitive::f64,
    /// Coordinate `lift`.
    pub lift: ::core::primitive::f64,
    /// Velocity of `turn`.
    pub turn_dot: ::core::primitive::f64,
    /// Velocity of `lift`.
    pub lift_dot: ::core::primitive::f64,
}
/// Columns of a table of states of [`SpatialArm`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct SpatialArmColumns<C>(C);
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::{cos, multiply_add, sin, sin_cos};
    impl SpatialArm {
        /// The statements that those about rigid bodies stand for.
        pub const STATEMENTS: &'static ::core::primitive::str = "param m = 2, l = 0.5, r = 0.05;\ncoord turn;\nlet base_w = (0, 0, dot(turn));\nlet base_x = (cos(turn), sin(turn), 0);\nlet base_y = (-sin(turn), cos(turn), 0);\nlet base_T_rotation = 1/2 * 0.01 * base_w.z^2;\nkinetic = base_T_rotation;\nlet base_V = 3 * m * (9.81 * 0.3);\npotential = base_V;\ncoord lift;\nlet arm_joint_v = (0, base_w.z * r, 0);\nlet arm_joint_origin = (r * base_x.x, r * base_x.y, 0.3 + 0.1);\nlet arm_w = (-(sin(lift) * base_w.z), dot(lift), cos(lift) * base_w.z);\nlet arm_x = (cos(lift) * base_x.x, cos(lift) * base_x.y, -sin(lift));\nlet arm_z = (sin(lift) * base_x.x, sin(lift) * base_x.y, cos(lift));\nlet arm_center_v = (arm_w.y * (l/2), arm_joint_v.y - arm_w.x * (l/2), 0);\nlet arm_T_translation = kinetic_energy(m, (arm_center_v.x, arm_center_v.y, 0));\nkinetic = arm_T_translation;\nlet arm_T_rotation = 1/2 * (m * l^2 / 12) * arm_w.x^2 + 1/2 * (m * l^2 / 12) * arm_w.y^2;\nkinetic = arm_T_rotation;\nlet arm_V = m * (9.81 * (arm_joint_origin.z + l/2 * arm_z.z));\npotential = arm_V;\nlet tool_joint_origin = (arm_joint_origin.x + l * arm_z.x, arm_joint_origin.y + l * arm_z.y, arm_joint_origin.z + l * arm_z.z);\nlet tool_z = (-base_y.x, -base_y.y, 0);\nlet arm_moment = (0, 0, m * (l/2));\nlet arm_J = (m * l^2 / 12 + m * (l/2) * (l/2), m * l^2 / 12 + m * (l/2) * (l/2), 0);\nlet base_J = (0.1 * (0.1 * m), 0.1 * (0.1 * m) + m * r * r, m * r * r);\nlet base_alpha = (0, 0, ddot(turn));\nlet base_w_squares = (0, 0, base_w.z^2);\nlet base_relative_x = (-base_w_squares.z, -base_alpha.z, 0);\nlet base_relative_y = (base_alpha.z, -base_w_squares.z, 0);\nlet base_S = 1/2 * (0.01 + base_J.z) * base_alpha.z^2;\nlet arm_joint_a = (base_relative_x.x * r, base_relative_y.x * r, 9.81);\nlet arm_alpha = (-(sin(lift) * base_alpha.z) - arm_w.z * dot(lift), ddot(lift), cos(lift) * base_alpha.z + arm_w.x * dot(lift));\nlet arm_a = (cos(lift) * arm_joint_a.x - sin(lift) * 9.81, arm_joint_a.y, cos(lift) * 9.81 + sin(lift) * arm_joint_a.x);\nlet arm_w_squares = (arm_w.x^2, arm_w.y^2, arm_w.z^2);\nlet arm_w_products = (arm_w.y * arm_w.z, arm_w.z * arm_w.x, arm_w.x * arm_w.y);\nlet arm_relative_x = (-(arm_w_squares.y + arm_w_squares.z), arm_w_products.z - arm_alpha.z, arm_w_products.y + arm_alpha.y);\nlet arm_relative_y = (arm_w_products.z + arm_alpha.z, -(arm_w_squares.z + arm_w_squares.x), arm_w_products.x - arm_alpha.x);\nlet arm_relative_z = (arm_w_products.y - arm_alpha.y, arm_w_products.x + arm_alpha.x, -(arm_w_squares.x + arm_w_squares.y));\nlet arm_S = arm_a.x * (arm_relative_x.z * arm_moment.z) + arm_a.y * (arm_relative_y.z * arm_moment.z) + arm_a.z * (arm_relative_z.z * arm_moment.z) + 1/2 * arm_J.x * arm_alpha.x^2 - arm_J.y * arm_w_products.x * arm_alpha.x + 1/2 * arm_J.y * arm_alpha.y^2 + arm_J.x * arm_w_products.y * arm_alpha.y + (arm_J.y - arm_J.x) * arm_w_products.z * arm_alpha.z;\ngibbs = base_S + arm_S, for: base_T_rotation - base_V + (arm_T_translation + arm_T_rotation - arm_V);\n";
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 6 additions, 29 multiplications, 2 divisions, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let Self { m, l, r } = *self;
            let [_, lift] = *q;
            let [turn_dot, lift_dot] = *v;
            let (sin_lift, arm_z_z) = sin_cos(lift);
            let m_l_r = m * l * r;
            let l_sq = l * l;
            let vel_0 = 0.6666666666666666 * m * l_sq * sin_lift * arm_z_z * turn_dot;
            let forcing_0 = -multiply_add(
                vel_0,
                lift_dot,
                m_l_r * arm_z_z * turn_dot * lift_dot,
            );
            let r_sq = r * r;
            let base_J_z = m * r_sq;
            let sin_lift_sq = sin_lift * sin_lift;
            let const_0 = 0.3333333333333333 * m * l_sq;
            let pos_0 = multiply_add(
                const_0,
                sin_lift_sq,
                multiply_add(m_l_r, sin_lift, base_J_z),
            );
            let m_0_0 = pos_0 + 0.01;
            let turn_ddot = forcing_0 / m_0_0;
            let turn_dot_sq = turn_dot * turn_dot;
            let pos_1 = 0.3333333333333333 * l * sin_lift * arm_z_z;
            let vel_1 = multiply_add(pos_1, turn_dot_sq, 4.905 * sin_lift);
            let lift_ddot = 3.0 / l
                * multiply_add(0.5 * r * arm_z_z, turn_dot_sq, vel_1);
            [turn_ddot, lift_ddot]
        }
        /// Mass matrix M, in rows.
        ///
        /// Takes 3 additions, 10 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f64, q: &[f64; 2]) -> [[f64; 2]; 2] {
            let Self { m, l, r } = *self;
            let [_, lift] = *q;
            let r_sq = r * r;
            let base_J_z = m * r_sq;
            let sin_lift = sin(lift);
            let l_sq = l * l;
            let arm_J_x = 0.3333333333333333 * m * l_sq;
            let sin_lift_sq = sin_lift * sin_lift;
            let pos_0 = multiply_add(
                arm_J_x,
                sin_lift_sq,
                multiply_add(m * l * r, sin_lift, base_J_z),
            );
            let m_0_0 = pos_0 + 0.01;
            [[m_0_0, 0.0], [0.0, arm_J_x]]
        }
        /// Right-hand side f of M q̈ = f.
        ///
        /// Takes 3 additions, 26 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let Self { m, l, r } = *self;
            let [_, lift] = *q;
            let [turn_dot, lift_dot] = *v;
            let (sin_lift, arm_z_z) = sin_cos(lift);
            let l_sq = l * l;
            let vel_0 = 0.6666666666666666 * m * l_sq * sin_lift * arm_z_z * turn_dot;
            let forcing_0 = -multiply_add(
                vel_0,
                lift_dot,
                m * l * r * arm_z_z * turn_dot * lift_dot,
            );
            let turn_dot_sq = turn_dot * turn_dot;
            let vel_1 = multiply_add(
                4.905 * m * l,
                sin_lift,
                0.5 * m * l * r * arm_z_z * turn_dot_sq,
            );
            let pos_0 = 0.3333333333333333 * m * l_sq * sin_lift * arm_z_z;
            let forcing_1 = multiply_add(pos_0, turn_dot_sq, vel_1);
            [forcing_0, forcing_1]
        }
        /// Generalised momenta ∂L/∂v.
        ///
        /// Takes 5 additions, 17 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn momenta(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let Self { m, l, r } = *self;
            let [_, lift] = *q;
            let [turn_dot, lift_dot] = *v;
            let sin_lift = sin(lift);
            let sin_lift_turn_dot = sin_lift * turn_dot;
            let arm_joint_v_y = r * turn_dot;
            let const_0 = 0.5 * l;
            let arm_center_v_y = multiply_add(const_0, sin_lift_turn_dot, arm_joint_v_y);
            let m_arm_center_v_y = m * arm_center_v_y;
            let l_sq = l * l;
            let const_1 = 0.08333333333333333 * m * l_sq;
            let vel_0 = multiply_add(
                const_0,
                m_arm_center_v_y,
                const_1 * sin_lift_turn_dot,
            );
            let vel_1 = multiply_add(sin_lift, vel_0, 0.01 * turn_dot);
            [
                multiply_add(r, m_arm_center_v_y, vel_1),
                multiply_add(0.25 * l_sq * m, lift_dot, const_1 * lift_dot),
            ]
        }
        /// Kinetic energy T.
        ///
        /// Takes 5 additions, 19 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
            let Self { m, l, r } = *self;
            let [_, lift] = *q;
            let [turn_dot, lift_dot] = *v;
            let l_lift_dot = l * lift_dot;
            let l_lift_dot_sq = l_lift_dot * l_lift_dot;
            let sin_lift_turn_dot = sin(lift) * turn_dot;
            let arm_joint_v_y = r * turn_dot;
            let arm_center_v_y = multiply_add(0.5 * l, sin_lift_turn_dot, arm_joint_v_y);
            let base_w_squares_z = turn_dot * turn_dot;
            let vel_0 = multiply_add(
                arm_center_v_y,
                arm_center_v_y,
                0.25 * l_lift_dot_sq,
            );
            let l_sq = l * l;
            let m_l_sq = m * l_sq;
            let sin_lift_turn_dot_sq = sin_lift_turn_dot * sin_lift_turn_dot;
            let lift_dot_sq = lift_dot * lift_dot;
            let vel_1 = multiply_add(0.5 * m, vel_0, 0.005 * base_w_squares_z);
            let vel_2 = multiply_add(m_l_sq, lift_dot_sq, m_l_sq * sin_lift_turn_dot_sq);
            multiply_add(0.041666666666666664, vel_2, vel_1)
        }
        /// Potential energy V.
        ///
        /// Takes 2 additions, 5 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, q: &[f64; 2]) -> f64 {
            let Self { m, l, .. } = *self;
            let [_, lift] = *q;
            let arm_z_z = cos(lift);
            multiply_add(9.81 * m, multiply_add(0.5 * l, arm_z_z, 0.4), 8.829 * m)
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 8 additions, 23 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
            let Self { m, l, r } = *self;
            let [_, lift] = *q;
            let [turn_dot, lift_dot] = *v;
            let (sin_lift, arm_z_z) = sin_cos(lift);
            let sin_lift_turn_dot = sin_lift * turn_dot;
            let arm_joint_v_y = r * turn_dot;
            let const_0 = 0.5 * l;
            let arm_center_v_y = multiply_add(const_0, sin_lift_turn_dot, arm_joint_v_y);
            let l_lift_dot = l * lift_dot;
            let l_lift_dot_sq = l_lift_dot * l_lift_dot;
            let base_w_squares_z = turn_dot * turn_dot;
            let vel_0 = multiply_add(
                arm_center_v_y,
                arm_center_v_y,
                0.25 * l_lift_dot_sq,
            );
            let l_sq = l * l;
            let m_l_sq = m * l_sq;
            let sin_lift_turn_dot_sq = sin_lift_turn_dot * sin_lift_turn_dot;
            let lift_dot_sq = lift_dot * lift_dot;
            let vel_1 = multiply_add(0.5 * m, vel_0, 0.005 * base_w_squares_z);
            let vel_2 = multiply_add(m_l_sq, lift_dot_sq, m_l_sq * sin_lift_turn_dot_sq);
            let vel_3 = multiply_add(
                8.829,
                m,
                multiply_add(0.041666666666666664, vel_2, vel_1),
            );
            multiply_add(9.81 * m, multiply_add(const_0, arm_z_z, 0.4), vel_3)
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 10 additions, 30 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            q: &[f64; 2],
            v: &[f64; 2],
            a: &[f64; 2],
        ) -> [f64; 2] {
            let Self { m, l, r } = *self;
            let [_, lift] = *q;
            let [turn_dot, lift_dot] = *v;
            let [turn_ddot, lift_ddot] = *a;
            let (sin_lift, arm_z_z) = sin_cos(lift);
            let arm_w_z = arm_z_z * turn_dot;
            let arm_w_products_x = lift_dot * arm_w_z;
            let acc_0 = multiply_add(sin_lift, turn_ddot, arm_w_products_x);
            let arm_alpha_x = -acc_0;
            let l_sq = l * l;
            let m_l_sq = m * l_sq;
            let m_l = m * l;
            let arm_joint_a_y = r * turn_ddot;
            let acc_1 = multiply_add(-m_l_sq, arm_alpha_x, m_l_sq * arm_w_products_x);
            let r_sq = r * r;
            let base_J_z = m * r_sq;
            let acc_2 = multiply_add(
                0.3333333333333333,
                acc_1,
                0.5 * m_l * arm_joint_a_y,
            );
            let arm_relative_y_z = arm_w_products_x + acc_0;
            let acc_3 = multiply_add(sin_lift, acc_2, (base_J_z + 0.01) * turn_ddot);
            let acc_4 = multiply_add(
                -m_l_sq * sin_lift * turn_dot,
                arm_w_z,
                m_l_sq * lift_ddot,
            );
            let turn_dot_sq = turn_dot * turn_dot;
            let arm_a_x = -multiply_add(r * arm_z_z, turn_dot_sq, 9.81 * sin_lift);
            [
                multiply_add(0.5 * r * m_l, arm_relative_y_z, acc_3),
                multiply_add(-(-0.5 * m_l), arm_a_x, 0.3333333333333333 * acc_4),
            ]
        }
        /// Where the frame of `base` is in the world: its rotation, in rows, whose columns are the axes of the frame,
        /// and its origin.
        ///
        /// Takes 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn base_frame(&self, t: f64, q: &[f64; 2]) -> ([[f64; 3]; 3], [f64; 3]) {
            let [turn, _] = *q;
            let (base_x_y, base_x_x) = sin_cos(turn);
            let base_y_x = -base_x_y;
            (
                [[base_x_x, base_y_x, 0.0], [base_x_y, base_x_x, 0.0], [0.0, 0.0, 1.0]],
                [0.0, 0.0, 0.3],
            )
        }
        /// Where the frame of `arm` is in the world: its rotation, in rows, whose columns are the axes of the frame,
        /// and its origin.
        ///
        /// The link behind the shoulder.
        ///
        /// Takes 6 multiplications, 2 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn arm_frame(&self, t: f64, q: &[f64; 2]) -> ([[f64; 3]; 3], [f64; 3]) {
            let Self { r, .. } = *self;
            let [turn, lift] = *q;
            let (sin_lift, arm_z_z) = sin_cos(lift);
            let (base_x_y, base_x_x) = sin_cos(turn);
            let arm_x_x = base_x_x * arm_z_z;
            let base_y_x = -base_x_y;
            let arm_z_x = base_x_x * sin_lift;
            let arm_x_y = base_x_y * arm_z_z;
            let arm_z_y = base_x_y * sin_lift;
            let arm_x_z = -sin_lift;
            let arm_joint_origin_x = r * base_x_x;
            let arm_joint_origin_y = r * base_x_y;
            (
                [
                    [arm_x_x, base_y_x, arm_z_x],
                    [arm_x_y, base_x_x, arm_z_y],
                    [arm_x_z, 0.0, arm_z_z],
                ],
                [arm_joint_origin_x, arm_joint_origin_y, 0.4],
            )
        }
        /// Where the frame of `tool` is in the world: its rotation, in rows, whose columns are the axes of the frame,
        /// and its origin.
        ///
        /// Where the tool is held.
        ///
        /// Takes 3 additions, 9 multiplications, 2 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn tool_frame(&self, t: f64, q: &[f64; 2]) -> ([[f64; 3]; 3], [f64; 3]) {
            let Self { l, r, .. } = *self;
            let [turn, lift] = *q;
            let (sin_lift, arm_z_z) = sin_cos(lift);
            let (base_x_y, base_x_x) = sin_cos(turn);
            let arm_x_x = base_x_x * arm_z_z;
            let arm_z_x = base_x_x * sin_lift;
            let arm_x_y = base_x_y * arm_z_z;
            let arm_z_y = base_x_y * sin_lift;
            let tool_z_y = -base_x_x;
            let arm_x_z = -sin_lift;
            let arm_joint_origin_x = r * base_x_x;
            let tool_joint_origin_x = multiply_add(l, arm_z_x, arm_joint_origin_x);
            let arm_joint_origin_y = r * base_x_y;
            let tool_joint_origin_y = multiply_add(l, arm_z_y, arm_joint_origin_y);
            let tool_joint_origin_z = multiply_add(l, arm_z_z, 0.4);
            (
                [
                    [arm_x_x, arm_z_x, base_x_y],
                    [arm_x_y, arm_z_y, tool_z_y],
                    [arm_x_z, arm_z_z, 0.0],
                ],
                [tool_joint_origin_x, tool_joint_origin_y, tool_joint_origin_z],
            )
        }
        /// Jacobian of the frame of `base` by the generalised velocities, in the axes of the world: rows 0 to 2
        /// are those of its angular velocity, rows 3 to 5 those of the velocity of its origin. What time alone adds to
        /// these is left out.
        #[must_use]
        #[inline]
        pub fn base_jacobian(&self, t: f64, q: &[f64; 2]) -> [[f64; 2]; 6] {
            [[0.0, 0.0], [0.0, 0.0], [1.0, 0.0], [0.0, 0.0], [0.0, 0.0], [0.0, 0.0]]
        }
        /// Jacobian of the frame of `arm` by the generalised velocities, in the axes of the world: rows 0 to 2
        /// are those of its angular velocity, rows 3 to 5 those of the velocity of its origin. What time alone adds to
        /// these is left out.
        ///
        /// The link behind the shoulder.
        ///
        /// Takes 2 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn arm_jacobian(&self, t: f64, q: &[f64; 2]) -> [[f64; 2]; 6] {
            let Self { r, .. } = *self;
            let [turn, _] = *q;
            let (base_x_y, base_x_x) = sin_cos(turn);
            let base_y_x = -base_x_y;
            let arm_joint_origin_y = r * base_x_y;
            let arm_joint_origin_x = r * base_x_x;
            [
                [0.0, base_y_x],
                [0.0, base_x_x],
                [1.0, 0.0],
                [-arm_joint_origin_y, 0.0],
                [arm_joint_origin_x, 0.0],
                [0.0, 0.0],
            ]
        }
        /// Jacobian of the frame of `tool` by the generalised velocities, in the axes of the world: rows 0 to 2
        /// are those of its angular velocity, rows 3 to 5 those of the velocity of its origin. What time alone adds to
        /// these is left out.
        ///
        /// Where the tool is held.
        ///
        /// Takes 3 additions, 11 multiplications, 2 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn tool_jacobian(&self, t: f64, q: &[f64; 2]) -> [[f64; 2]; 6] {
            let Self { l, r, .. } = *self;
            let [turn, lift] = *q;
            let (base_x_y, base_x_x) = sin_cos(turn);
            let base_y_x = -base_x_y;
            let (sin_lift, arm_z_z) = sin_cos(lift);
            let arm_z_y = base_x_y * sin_lift;
            let l_arm_z_y = l * arm_z_y;
            let arm_joint_origin_y = r * base_x_y;
            let tool_joint_origin_y = arm_joint_origin_y + l_arm_z_y;
            let l_arm_z_z = l * arm_z_z;
            let arm_z_x = base_x_x * sin_lift;
            let l_arm_z_x = l * arm_z_x;
            let arm_joint_origin_x = r * base_x_x;
            let tool_joint_origin_x = arm_joint_origin_x + l_arm_z_x;
            [
                [0.0, base_y_x],
                [0.0, base_x_x],
                [1.0, 0.0],
                [-tool_joint_origin_y, base_x_x * l_arm_z_z],
                [tool_joint_origin_x, base_x_y * l_arm_z_z],
                [0.0, -multiply_add(base_x_x, l_arm_z_x, base_x_y * l_arm_z_y)],
            ]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, y: &[f64; 4]) -> [f64; 4] {
            let [turn, lift, turn_dot, lift_dot] = *y;
            let a = self.acceleration(t, &[turn, lift], &[turn_dot, lift_dot]);
            [turn_dot, lift_dot, a[0], a[1]]
        }
        /// How the body `base` moves.
        ///
        /// Takes 1 multiplication, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn base_motion(
            &self,
            t: f64,
            q: &[f64; 2],
            v: &[f64; 2],
        ) -> ::lagrange::body::SpatialMotion<f64> {
            let Self { m, .. } = *self;
            let [turn, _] = *q;
            let [turn_dot, _] = *v;
            let [turn_ddot, _] = self.acceleration(t, q, v);
            let (base_x_y, base_x_x) = sin_cos(turn);
            let base_y_x = -base_x_y;
            ::lagrange::body::SpatialMotion {
                mass: 3.0 * m,
                inertia: [[0.02, 0.0, 0.0], [0.0, 0.02, 0.0], [0.0, 0.0, 0.01]],
                centroid: [0.0, 0.0, 0.0],
                center: [0.0, 0.0, 0.3],
                rotation: [
                    [base_x_x, base_y_x, 0.0],
                    [base_x_y, base_x_x, 0.0],
                    [0.0, 0.0, 1.0],
                ],
                velocity: [0.0, 0.0, 0.0],
                angular_velocity: [0.0, 0.0, turn_dot],
                acceleration: [0.0, 0.0, 0.0],
                angular_acceleration: [0.0, 0.0, turn_ddot],
            }
        }
        /// The link behind the shoulder.
        ///
        /// Takes 27 additions, 64 multiplications, 2 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn arm_motion(
            &self,
            t: f64,
            q: &[f64; 2],
            v: &[f64; 2],
        ) -> ::lagrange::body::SpatialMotion<f64> {
            let Self { m, l, r } = *self;
            let [turn, lift] = *q;
            let [turn_dot, lift_dot] = *v;
            let [turn_ddot, lift_ddot] = self.acceleration(t, q, v);
            let l_sq = l * l;
            let const_0 = 0.08333333333333333 * m * l_sq;
            let const_1 = 0.5 * l;
            let (base_x_y, base_x_x) = sin_cos(turn);
            let arm_joint_origin_x = r * base_x_x;
            let (sin_lift, arm_z_z) = sin_cos(lift);
            let arm_z_x = base_x_x * sin_lift;
            let arm_joint_origin_y = r * base_x_y;
            let arm_z_y = base_x_y * sin_lift;
            let arm_x_x = base_x_x * arm_z_z;
            let base_y_x = -base_x_y;
            let arm_x_y = base_x_y * arm_z_z;
            let arm_x_z = -sin_lift;
            let sin_lift_turn_dot = sin_lift * turn_dot;
            let arm_joint_v_y = r * turn_dot;
            let arm_center_v_y = multiply_add(const_1, sin_lift_turn_dot, arm_joint_v_y);
            let arm_w_z = arm_z_z * turn_dot;
            let vel_0 = multiply_add(-arm_x_x, sin_lift_turn_dot, arm_z_x * arm_w_z);
            let vel_1 = multiply_add(-arm_x_y, sin_lift_turn_dot, base_x_x * lift_dot);
            let acc_0 = multiply_add(arm_w_z, lift_dot, sin_lift * turn_ddot);
            let arm_joint_a_y = r * turn_ddot;
            let acc_1 = multiply_add(
                0.5,
                multiply_add(l * lift_dot, arm_w_z, l * acc_0),
                arm_joint_a_y,
            );
            let acc_2 = multiply_add(-arm_w_z, arm_center_v_y, const_1 * lift_ddot);
            let lift_dot_sq = lift_dot * lift_dot;
            let vel_2 = multiply_add(
                const_1,
                lift_dot_sq,
                sin_lift_turn_dot * arm_center_v_y,
            );
            let acc_3 = multiply_add(-sin_lift_turn_dot, lift_dot, arm_z_z * turn_ddot);
            let acc_4 = multiply_add(-arm_x_x, acc_0, arm_z_x * acc_3);
            let acc_5 = multiply_add(-arm_x_y, acc_0, base_x_x * lift_ddot);
            ::lagrange::body::SpatialMotion {
                mass: m,
                inertia: [[const_0, 0.0, 0.0], [0.0, const_0, 0.0], [0.0, 0.0, 0.0]],
                centroid: [0.0, 0.0, const_1],
                center: [
                    multiply_add(const_1, arm_z_x, arm_joint_origin_x),
                    multiply_add(const_1, arm_z_y, arm_joint_origin_y),
                    multiply_add(const_1, arm_z_z, 0.4),
                ],
                rotation: [
                    [arm_x_x, base_y_x, arm_z_x],
                    [arm_x_y, base_x_x, arm_z_y],
                    [arm_x_z, 0.0, arm_z_z],
                ],
                velocity: [
                    multiply_add(
                        -base_x_y,
                        arm_center_v_y,
                        const_1 * arm_x_x * lift_dot,
                    ),
                    multiply_add(base_x_x, arm_center_v_y, const_1 * arm_x_y * lift_dot),
                    -0.5 * l * sin_lift * lift_dot,
                ],
                angular_velocity: [
                    multiply_add(-base_x_y, lift_dot, vel_0),
                    multiply_add(arm_z_y, arm_w_z, vel_1),
                    multiply_add(arm_z_z, arm_w_z, sin_lift * sin_lift_turn_dot),
                ],
                acceleration: [
                    multiply_add(
                        -arm_z_x,
                        vel_2,
                        multiply_add(-base_x_y, acc_1, arm_x_x * acc_2),
                    ),
                    multiply_add(
                        -arm_z_y,
                        vel_2,
                        multiply_add(base_x_x, acc_1, arm_x_y * acc_2),
                    ),
                    -multiply_add(arm_z_z, vel_2, sin_lift * acc_2),
                ],
                angular_acceleration: [
                    multiply_add(-base_x_y, lift_ddot, acc_4),
                    multiply_add(arm_z_y, acc_3, acc_5),
                    multiply_add(arm_z_z, acc_3, sin_lift * acc_0),
                ],
            }
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for SpatialArm {
        fn default() -> Self {
            Self { m: 2.0, l: 0.5, r: 0.05 }
        }
    }
    impl SpatialArmState {
        /// The coordinates in their order.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [f64; 2] {
            [self.turn, self.lift]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [f64; 2] {
            [self.turn_dot, self.lift_dot]
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 4]> for SpatialArmState {
        #[inline]
        fn from([turn, lift, turn_dot, lift_dot]: [f64; 4]) -> Self {
            Self {
                turn,
                lift,
                turn_dot,
                lift_dot,
            }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<SpatialArmState> for [f64; 4] {
        #[inline]
        fn from(state: SpatialArmState) -> Self {
            [state.turn, state.lift, state.turn_dot, state.lift_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> SpatialArmColumns<C> {
        /// Coordinate `turn`.
        #[must_use]
        #[inline]
        pub fn turn(&self) -> &[C::Scalar] {
            self.0.column(0)
        }
        /// Coordinate `lift`.
        #[must_use]
        #[inline]
        pub fn lift(&self) -> &[C::Scalar] {
            self.0.column(1)
        }
        /// Velocity of `turn`.
        #[must_use]
        #[inline]
        pub fn turn_dot(&self) -> &[C::Scalar] {
            self.0.column(2)
        }
        /// Velocity of `lift`.
        #[must_use]
        #[inline]
        pub fn lift_dot(&self) -> &[C::Scalar] {
            self.0.column(3)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for SpatialArmColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for SpatialArmColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for SpatialArm {
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
    impl ::lagrange::system::MechanicalSystem for SpatialArm {
        type Coordinates = [f64; 2];
        type Velocities = [f64; 2];
        type Columns<C> = SpatialArmColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &[
            "turn",
            "lift",
        ];
        const FINGERPRINT: ::core::primitive::u64 = 3164220976481450985;
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
            [("m", self.m), ("l", self.l), ("r", self.r)].get(index).copied()
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for SpatialArm {
        type NamedState = SpatialArmState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for SpatialArm {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
            self.energy(t, q, v)
        }
    }
};
