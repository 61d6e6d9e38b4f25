/// An arm with a hole that a motor turns, and a bob that is pinned to its tip and held by a spring.
///
/// # Equations of motion
///
/// ```text
/// m*ddot(x) = -hook_x - (x - 1)*(k - l*k/sqrt(z^2 + (x - 1)^2 + (y - 1)^2))
/// m*ddot(y) = -hook_y - (y - 1)*(k - l*k/sqrt(z^2 + (x - 1)^2 + (y - 1)^2))
/// m*ddot(z) = -hook_z - m*g - z*(k - l*k/sqrt(z^2 + (x - 1)^2 + (y - 1)^2))
/// (1/12*l^2 + 397/4800*r^2)*m*ddot(q) = u - l*cos(q)*hook_z - l*sin(q)*hook_x
/// l*cos(q) - x = 0
/// -y = 0
/// -z - l*sin(q) = 0
/// ```
///
/// # State and structure
///
/// - State: `[x, y, z, q, x_dot, y_dot, z_dot, q_dot]`.
/// - Mass matrix: diagonal, constant.
/// - Cyclic coordinates: `q`.
/// - Leapfrog methods take it and keep it on the constraints.
/// - Forward dynamics: the mass matrix is factorised (counted cost 299; recursion 299, the kinetic energy is no sum of squares).
/// - Multipliers, which the equations name like their constraints: `[hook_x, hook_y, hook_z]`.
/// - Cost of `acceleration`: 21 additions, 41 multiplications, 5 divisions, 1 square root, 1 function, 1 `sin_cos`.
///
/// # Statements
///
/// Those about rigid bodies stand for plain ones:
///
/// ```text
/// param m = 2, l = 0.8, r = 0.1, k = 30, g = 9.81;
/// input u;
/// coord x, y, z;
/// let arm_mass = m - m/50;
/// let arm_moments = (m * (1/12 * r^2 + 1/12 * r^2) - m/50 * (1/4 * (r/4)^2 + 1/12 * r^2), m * (1/12 * r^2 + 1/12 * l^2) - m/50 * (1/2 * (r/4)^2), m * (1/12 * l^2 + 1/12 * r^2) - m/50 * (1/4 * (r/4)^2 + 1/12 * r^2));
/// coord q;
/// let arm_w = (0, dot(q), 0);
/// let arm_x = (cos(q), 0, -sin(q));
/// let arm_z = (sin(q), 0, cos(q));
/// let arm_T_rotation = 1/2 * arm_moments.y * arm_w.y^2;
/// kinetic = arm_T_rotation;
/// let tip_origin = (l * arm_x.x, 0, l * arm_x.z);
/// force q = u;
/// let bob_T_translation = kinetic_energy(m, dot((x, y, z)));
/// kinetic = bob_T_translation;
/// let bob_V = m * (g * z);
/// potential = bob_V;
/// constraint hook_x = tip_origin.x - x;
/// constraint hook_y = -y;
/// constraint hook_z = tip_origin.z - z;
/// let spring_1_span = (1 - x, 1 - y, -z);
/// potential = spring_energy(k, norm(spring_1_span) - l);
/// emit { no momenta }
/// let arm_alpha = (0, ddot(q), 0);
/// let arm_S = 1/2 * arm_moments.y * arm_alpha.y^2;
/// gibbs = arm_S, for: arm_T_rotation;
/// ```
pub struct HungArm {
    /// Parameter `m`.
    pub m: ::core::primitive::f64,
    /// Parameter `l`.
    pub l: ::core::primitive::f64,
    /// Parameter `r`.
    pub r: ::core::primitive::f64,
    /// Parameter `k`.
    pub k: ::core::primitive::f64,
    /// Parameter `g`.
    pub g: ::core::primitive::f64,
    /// Input `u`.
    pub u: ::core::primitive::f64,
}
/// State of [`HungArm`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct HungArmState {
    /// Coordinate `x`.
    pub x: ::core::primitive::f64,
    /// Coordinate `y`.
    pub y: ::core::primitive::f64,
    /// Coordinate `z`.
    pub z: ::core::primitive::f64,
    /// Coordinate `q`.
    pub q: ::core::primitive::f64,
    /// Velocity of `x`.
    pub x_dot: ::core::primitive::f64,
    /// Velocity of `y`.
    pub y_dot: ::core::primitive::f64,
    /// Velocity of `z`.
    pub z_dot: ::core::primitive::f64,
    /// Velocity of `q`.
    pub q_dot: ::core::primitive::f64,
}
/// Columns of a table of states of [`HungArm`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct HungArmColumns<C>(C);
/// Inputs of [`HungArm`].
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct HungArmInputs {
    /// Input `u`.
    pub u: ::core::primitive::f64,
}
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::{abs, multiply_add, sin_cos, sqrt};
    impl HungArm {
        /// The declaration in plain statements: without parts, arrays and rigid bodies.
        pub const STATEMENTS: &'static ::core::primitive::str = "param m = 2, l = 0.8, r = 0.1, k = 30, g = 9.81;\ninput u;\ncoord x, y, z;\nlet arm_mass = m - m/50;\nlet arm_moments = (m * (1/12 * r^2 + 1/12 * r^2) - m/50 * (1/4 * (r/4)^2 + 1/12 * r^2), m * (1/12 * r^2 + 1/12 * l^2) - m/50 * (1/2 * (r/4)^2), m * (1/12 * l^2 + 1/12 * r^2) - m/50 * (1/4 * (r/4)^2 + 1/12 * r^2));\ncoord q;\nlet arm_w = (0, dot(q), 0);\nlet arm_x = (cos(q), 0, -sin(q));\nlet arm_z = (sin(q), 0, cos(q));\nlet arm_T_rotation = 1/2 * arm_moments.y * arm_w.y^2;\nkinetic = arm_T_rotation;\nlet tip_origin = (l * arm_x.x, 0, l * arm_x.z);\nforce q = u;\nlet bob_T_translation = kinetic_energy(m, dot((x, y, z)));\nkinetic = bob_T_translation;\nlet bob_V = m * (g * z);\npotential = bob_V;\nconstraint hook_x = tip_origin.x - x;\nconstraint hook_y = -y;\nconstraint hook_z = tip_origin.z - z;\nlet spring_1_span = (1 - x, 1 - y, -z);\npotential = spring_energy(k, norm(spring_1_span) - l);\nemit { no momenta }\nlet arm_alpha = (0, ddot(q), 0);\nlet arm_S = 1/2 * arm_moments.y * arm_alpha.y^2;\ngibbs = arm_S, for: arm_T_rotation;\n";
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 21 additions, 41 multiplications, 5 divisions, 1 square root, 1 function, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn acceleration(
            &self,
            t: f64,
            positions: &[f64; 4],
            v: &[f64; 4],
        ) -> [f64; 4] {
            let Self { m, l, r, k, g, u } = *self;
            let [x, y, z, q] = *positions;
            let [_, _, _, q_dot] = *v;
            let spring_1_span_x = 1.0 - x;
            let spring_1_span_y = 1.0 - y;
            let spring_1_span_x_sq = spring_1_span_x * spring_1_span_x;
            let pos_0 = multiply_add(
                spring_1_span_y,
                spring_1_span_y,
                spring_1_span_x_sq,
            );
            let sqrt_0 = sqrt(multiply_add(z, z, pos_0));
            let pos_1 = k * (l - sqrt_0) / sqrt_0;
            let forcing_0 = -spring_1_span_x * pos_1;
            let factor_4_0 = 1.0 / m;
            let factor_4_0_forcing_0 = factor_4_0 * forcing_0;
            let (arm_z_x, arm_x_x) = sin_cos(q);
            let arm_z_x_dot = arm_x_x * q_dot;
            let r_sq = r * r;
            let const_0 = 0.08333333333333333 * m * multiply_add(l, l, r_sq);
            let arm_moments_y = multiply_add(-0.000625 * m, r_sq, const_0);
            let inv_arm_moments_y = 1.0 / arm_moments_y;
            let l_arm_z_x = l * arm_z_x;
            let factor_4_3 = inv_arm_moments_y * l_arm_z_x;
            let vel_0 = multiply_add(l * q_dot, arm_z_x_dot, factor_4_0_forcing_0);
            let forcing_4 = -multiply_add(u, factor_4_3, vel_0);
            let forcing_2 = multiply_add(-m, g, z * pos_1);
            let factor_4_0_forcing_2 = factor_4_0 * forcing_2;
            let tip_origin_x = l * arm_x_x;
            let factor_6_3 = inv_arm_moments_y * tip_origin_x;
            let vel_1 = multiply_add(l_arm_z_x * q_dot, q_dot, -factor_4_0_forcing_2);
            let pivot_4 = -multiply_add(l_arm_z_x, factor_4_3, factor_4_0);
            let inv_pivot_4 = 1.0 / pivot_4;
            let pos_2 = tip_origin_x * factor_4_3;
            let pos_3 = pos_2 * inv_pivot_4;
            let forcing_6 = multiply_add(
                pos_3,
                forcing_4,
                multiply_add(-u, factor_6_3, vel_1),
            );
            let pos_4 = multiply_add(tip_origin_x, factor_6_3, factor_4_0);
            let pivot_6 = -multiply_add(pos_2, pos_3, pos_4);
            let inv_pivot_6 = 1.0 / pivot_6;
            let vel_2 = inv_pivot_6 * forcing_6;
            let vel_3 = multiply_add(pos_3, vel_2, inv_pivot_4 * forcing_4);
            let x_ddot = multiply_add(-factor_4_0, vel_3, factor_4_0_forcing_0);
            let z_ddot = multiply_add(-factor_4_0, vel_2, factor_4_0_forcing_2);
            let vel_4 = multiply_add(-factor_4_3, vel_3, inv_arm_moments_y * u);
            let q_ddot = multiply_add(-factor_6_3, vel_2, vel_4);
            let values = [x_ddot, 0.0, z_ddot, q_ddot];
            if ::lagrange::constraint::are_regular(&values, abs(inv_pivot_6 * pos_4)) {
                values
            } else {
                self.redundant_motion(t, positions, v).acceleration
            }
        }
        /// Multipliers λ of the constraints in the order of their declaration: M q̈ = f + Aᵀλ. That of a
        /// constraint on a length is the force along it.
        ///
        /// Takes 17 additions, 37 multiplications, 5 divisions, 1 square root, 1 function, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn multipliers(
            &self,
            t: f64,
            positions: &[f64; 4],
            v: &[f64; 4],
        ) -> [f64; 3] {
            let Self { m, l, r, k, g, u } = *self;
            let [x, y, z, q] = *positions;
            let [_, _, _, q_dot] = *v;
            let spring_1_span_x = 1.0 - x;
            let spring_1_span_y = 1.0 - y;
            let spring_1_span_x_sq = spring_1_span_x * spring_1_span_x;
            let pos_0 = multiply_add(
                spring_1_span_y,
                spring_1_span_y,
                spring_1_span_x_sq,
            );
            let sqrt_0 = sqrt(multiply_add(z, z, pos_0));
            let pos_1 = k * (l - sqrt_0) / sqrt_0;
            let forcing_0 = -spring_1_span_x * pos_1;
            let (arm_z_x, arm_x_x) = sin_cos(q);
            let arm_z_x_dot = arm_x_x * q_dot;
            let factor_4_0 = 1.0 / m;
            let r_sq = r * r;
            let const_0 = 0.08333333333333333 * m * multiply_add(l, l, r_sq);
            let arm_moments_y = multiply_add(-0.000625 * m, r_sq, const_0);
            let inv_arm_moments_y = 1.0 / arm_moments_y;
            let l_arm_z_x = l * arm_z_x;
            let factor_4_3 = inv_arm_moments_y * l_arm_z_x;
            let vel_0 = multiply_add(factor_4_0, forcing_0, l * q_dot * arm_z_x_dot);
            let forcing_4 = -multiply_add(u, factor_4_3, vel_0);
            let forcing_2 = multiply_add(-m, g, z * pos_1);
            let tip_origin_x = l * arm_x_x;
            let factor_6_3 = inv_arm_moments_y * tip_origin_x;
            let vel_1 = multiply_add(-factor_4_0, forcing_2, l_arm_z_x * q_dot * q_dot);
            let pivot_4 = -multiply_add(l_arm_z_x, factor_4_3, factor_4_0);
            let inv_pivot_4 = 1.0 / pivot_4;
            let pos_2 = tip_origin_x * factor_4_3;
            let pos_3 = pos_2 * inv_pivot_4;
            let forcing_6 = multiply_add(
                pos_3,
                forcing_4,
                multiply_add(-u, factor_6_3, vel_1),
            );
            let pos_4 = multiply_add(tip_origin_x, factor_6_3, factor_4_0);
            let pivot_6 = -multiply_add(pos_2, pos_3, pos_4);
            let inv_pivot_6 = 1.0 / pivot_6;
            let vel_2 = inv_pivot_6 * forcing_6;
            let forcing_1 = -spring_1_span_y * pos_1;
            let values = [
                multiply_add(pos_3, vel_2, inv_pivot_4 * forcing_4),
                forcing_1,
                vel_2,
            ];
            if ::lagrange::constraint::are_regular(&values, abs(inv_pivot_6 * pos_4)) {
                values
            } else {
                self.redundant_motion(t, positions, v).multipliers
            }
        }
        /// Mass matrix M, in rows.
        ///
        /// Takes 2 additions, 6 multiplications.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f64, positions: &[f64; 4]) -> [[f64; 4]; 4] {
            let Self { m, l, r, .. } = *self;
            let r_sq = r * r;
            let const_0 = 0.08333333333333333 * m * multiply_add(l, l, r_sq);
            let arm_moments_y = multiply_add(-0.000625 * m, r_sq, const_0);
            [
                [m, 0.0, 0.0, 0.0],
                [0.0, m, 0.0, 0.0],
                [0.0, 0.0, m, 0.0],
                [0.0, 0.0, 0.0, arm_moments_y],
            ]
        }
        /// Right-hand side f of M q̈ = f.
        ///
        /// Takes 6 additions, 8 multiplications, 1 division, 1 square root.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: f64, positions: &[f64; 4], v: &[f64; 4]) -> [f64; 4] {
            let Self { m, l, k, g, u, .. } = *self;
            let [x, y, z, _] = *positions;
            let spring_1_span_x = 1.0 - x;
            let spring_1_span_y = 1.0 - y;
            let spring_1_span_x_sq = spring_1_span_x * spring_1_span_x;
            let pos_0 = multiply_add(
                spring_1_span_y,
                spring_1_span_y,
                spring_1_span_x_sq,
            );
            let sqrt_0 = sqrt(multiply_add(z, z, pos_0));
            let pos_1 = k * (l - sqrt_0) / sqrt_0;
            let forcing_0 = -spring_1_span_x * pos_1;
            let forcing_1 = -spring_1_span_y * pos_1;
            let forcing_2 = multiply_add(-m, g, z * pos_1);
            [forcing_0, forcing_1, forcing_2, u]
        }
        /// Kinetic energy T.
        ///
        /// Takes 5 additions, 13 multiplications.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: f64, positions: &[f64; 4], v: &[f64; 4]) -> f64 {
            let Self { m, l, r, .. } = *self;
            let [x_dot, y_dot, z_dot, q_dot] = *v;
            let r_sq = r * r;
            let const_0 = 0.08333333333333333 * m * multiply_add(l, l, r_sq);
            let arm_moments_y = multiply_add(-0.000625 * m, r_sq, const_0);
            let q_dot_sq = q_dot * q_dot;
            let vel_0 = multiply_add(
                z_dot,
                z_dot,
                multiply_add(y_dot, y_dot, x_dot * x_dot),
            );
            0.5 * multiply_add(m, vel_0, arm_moments_y * q_dot_sq)
        }
        /// Potential energy V.
        ///
        /// Takes 6 additions, 8 multiplications, 1 square root.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, positions: &[f64; 4]) -> f64 {
            let Self { m, l, k, g, .. } = *self;
            let [x, y, z, _] = *positions;
            let spring_1_span_x = 1.0 - x;
            let spring_1_span_y = 1.0 - y;
            let spring_1_span_x_sq = spring_1_span_x * spring_1_span_x;
            let pos_0 = multiply_add(
                spring_1_span_y,
                spring_1_span_y,
                spring_1_span_x_sq,
            );
            let pos_1 = l - sqrt(multiply_add(z, z, pos_0));
            let bob_V = m * g * z;
            let pos_1_sq = pos_1 * pos_1;
            multiply_add(0.5 * k, pos_1_sq, bob_V)
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 12 additions, 20 multiplications, 1 square root.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, positions: &[f64; 4], v: &[f64; 4]) -> f64 {
            let Self { m, l, r, k, g, .. } = *self;
            let [x, y, z, _] = *positions;
            let [x_dot, y_dot, z_dot, q_dot] = *v;
            let spring_1_span_x = 1.0 - x;
            let spring_1_span_y = 1.0 - y;
            let spring_1_span_x_sq = spring_1_span_x * spring_1_span_x;
            let pos_0 = multiply_add(
                spring_1_span_y,
                spring_1_span_y,
                spring_1_span_x_sq,
            );
            let pos_1 = l - sqrt(multiply_add(z, z, pos_0));
            let r_sq = r * r;
            let const_0 = 0.08333333333333333 * m * multiply_add(l, l, r_sq);
            let arm_moments_y = multiply_add(-0.000625 * m, r_sq, const_0);
            let q_dot_sq = q_dot * q_dot;
            let vel_0 = multiply_add(
                z_dot,
                z_dot,
                multiply_add(y_dot, y_dot, x_dot * x_dot),
            );
            let pos_1_sq = pos_1 * pos_1;
            let bob_V = m * g * z;
            let vel_1 = multiply_add(
                k,
                pos_1_sq,
                multiply_add(m, vel_0, arm_moments_y * q_dot_sq),
            );
            multiply_add(0.5, vel_1, bob_V)
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 12 additions, 18 multiplications, 1 division, 1 square root.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            positions: &[f64; 4],
            v: &[f64; 4],
            a: &[f64; 4],
        ) -> [f64; 4] {
            let Self { m, l, r, k, g, u } = *self;
            let [x, y, z, _] = *positions;
            let [x_ddot, y_ddot, z_ddot, q_ddot] = *a;
            let spring_1_span_x = 1.0 - x;
            let spring_1_span_y = 1.0 - y;
            let spring_1_span_x_sq = spring_1_span_x * spring_1_span_x;
            let pos_0 = multiply_add(
                spring_1_span_y,
                spring_1_span_y,
                spring_1_span_x_sq,
            );
            let sqrt_0 = sqrt(multiply_add(z, z, pos_0));
            let pos_1 = k * (l - sqrt_0) / sqrt_0;
            let r_sq = r * r;
            let const_0 = 0.08333333333333333 * m * multiply_add(l, l, r_sq);
            let arm_moments_y = multiply_add(-0.000625 * m, r_sq, const_0);
            [
                multiply_add(spring_1_span_x, pos_1, m * x_ddot),
                multiply_add(spring_1_span_y, pos_1, m * y_ddot),
                multiply_add(m, z_ddot, multiply_add(-z, pos_1, m * g)),
                multiply_add(arm_moments_y, q_ddot, -u),
            ]
        }
        /// Values that the constraints hold at zero, in the order of their declaration; only those of
        /// nonholonomic constraints depend on the velocities.
        ///
        /// Takes 2 additions, 2 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn constraints(
            &self,
            t: f64,
            positions: &[f64; 4],
            v: &[f64; 4],
        ) -> [f64; 3] {
            let Self { l, .. } = *self;
            let [x, y, z, q] = *positions;
            let (arm_z_x, arm_x_x) = sin_cos(q);
            let tip_origin_x = l * arm_x_x;
            [tip_origin_x - x, -y, -multiply_add(l, arm_z_x, z)]
        }
        /// Conditions on the velocities, which the constraints hold at zero: rates of holonomic constraints,
        /// nonholonomic constraints themselves.
        ///
        /// Takes 2 additions, 4 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn constraint_velocity(
            &self,
            t: f64,
            positions: &[f64; 4],
            v: &[f64; 4],
        ) -> [f64; 3] {
            let Self { l, .. } = *self;
            let [_, _, _, q] = *positions;
            let [x_dot, y_dot, z_dot, q_dot] = *v;
            let (arm_z_x, arm_x_x) = sin_cos(q);
            let spring_1_span_y_dot = -y_dot;
            let arm_z_x_dot = arm_x_x * q_dot;
            [
                -multiply_add(l * arm_z_x, q_dot, x_dot),
                spring_1_span_y_dot,
                -multiply_add(l, arm_z_x_dot, z_dot),
            ]
        }
        /// Matrix A of the constraints, in rows: the derivatives of their conditions on the velocities by
        /// them.
        ///
        /// Takes 2 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn constraint_jacobian(
            &self,
            t: f64,
            positions: &[f64; 4],
        ) -> [[f64; 4]; 3] {
            let Self { l, .. } = *self;
            let [_, _, _, q] = *positions;
            let (arm_z_x, arm_x_x) = sin_cos(q);
            let tip_origin_z = -l * arm_z_x;
            let tip_origin_x = l * arm_x_x;
            [
                [-1.0, 0.0, 0.0, tip_origin_z],
                [0.0, -1.0, 0.0, 0.0],
                [0.0, 0.0, -1.0, -tip_origin_x],
            ]
        }
        /// Generalised forces Aᵀλ of the constraints, on the right-hand side of M q̈ = f + Aᵀλ.
        ///
        /// Takes 1 addition, 4 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn constraint_forces(
            &self,
            t: f64,
            positions: &[f64; 4],
            v: &[f64; 4],
        ) -> [f64; 4] {
            let Self { l, .. } = *self;
            let [_, _, _, q] = *positions;
            let [hook_x, hook_y, hook_z] = self.multipliers(t, positions, v);
            let (arm_z_x, arm_x_x) = sin_cos(q);
            let tip_origin_x = l * arm_x_x;
            [
                -hook_x,
                -hook_y,
                -hook_z,
                -multiply_add(hook_z, tip_origin_x, l * hook_x * arm_z_x),
            ]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, state: &[f64; 8]) -> [f64; 8] {
            let [x, y, z, q, x_dot, y_dot, z_dot, q_dot] = *state;
            let a = self.acceleration(t, &[x, y, z, q], &[x_dot, y_dot, z_dot, q_dot]);
            [x_dot, y_dot, z_dot, q_dot, a[0], a[1], a[2], a[3]]
        }
        /// Takes positions and velocities to the nearest ones that satisfy the constraints: first
        /// positions, then velocities. The mass matrix at the result measures distances.
        ///
        /// # Errors
        /// If that does not succeed; both are then unchanged.
        #[inline]
        pub fn project(
            &self,
            t: f64,
            positions: &mut [f64; 4],
            v: &mut [f64; 4],
        ) -> ::core::result::Result<(), ::lagrange::constraint::Violation<f64>> {
            ::lagrange::constraint::project(self, t, positions, v)
        }
        /// The nearest velocities that satisfy the constraints at these positions.
        ///
        /// # Errors
        /// If there are none.
        #[inline]
        pub fn consistent_velocity(
            &self,
            t: f64,
            positions: &[f64; 4],
            v: &[f64; 4],
        ) -> ::core::result::Result<[f64; 4], ::lagrange::constraint::Violation<f64>> {
            ::lagrange::constraint::consistent_velocity(self, t, positions, v)
        }
        /// The correction where constraints depend on each other.
        #[cold]
        #[inline(never)]
        fn redundant_correction(
            &self,
            t: f64,
            positions: &[f64; 4],
            v: &[f64; 4],
            residuals: &[f64; 3],
        ) -> [f64; 4] {
            let Self { m, l, r, .. } = *self;
            let [_, _, _, q] = *positions;
            let r_sq = r * r;
            let const_0 = 0.08333333333333333 * m * multiply_add(l, l, r_sq);
            let arm_moments_y = multiply_add(-0.000625 * m, r_sq, const_0);
            let (arm_z_x, arm_x_x) = sin_cos(q);
            let tip_origin_z = -l * arm_z_x;
            let tip_origin_x = l * arm_x_x;
            ::lagrange::constraint::redundant_correction(
                &[
                    [m, 0.0, 0.0, 0.0],
                    [0.0, m, 0.0, 0.0],
                    [0.0, 0.0, m, 0.0],
                    [0.0, 0.0, 0.0, arm_moments_y],
                ],
                &[
                    [-1.0, 0.0, 0.0, tip_origin_z],
                    [0.0, -1.0, 0.0, 0.0],
                    [0.0, 0.0, -1.0, -tip_origin_x],
                ],
                residuals,
            )
        }
        /// Accelerations and the least multipliers where constraints depend on each other.
        #[cold]
        #[inline(never)]
        fn redundant_motion(
            &self,
            t: f64,
            positions: &[f64; 4],
            v: &[f64; 4],
        ) -> ::lagrange::constraint::RedundantMotion<f64, 4, 3> {
            let Self { m, l, r, k, g, u } = *self;
            let [x, y, z, q] = *positions;
            let [_, _, _, q_dot] = *v;
            let r_sq = r * r;
            let const_0 = 0.08333333333333333 * m * multiply_add(l, l, r_sq);
            let arm_moments_y = multiply_add(-0.000625 * m, r_sq, const_0);
            let (arm_z_x, arm_x_x) = sin_cos(q);
            let l_arm_z_x = l * arm_z_x;
            let tip_origin_z = -l_arm_z_x;
            let tip_origin_x = l * arm_x_x;
            let spring_1_span_x = 1.0 - x;
            let spring_1_span_y = 1.0 - y;
            let spring_1_span_x_sq = spring_1_span_x * spring_1_span_x;
            let pos_0 = multiply_add(
                spring_1_span_y,
                spring_1_span_y,
                spring_1_span_x_sq,
            );
            let sqrt_0 = sqrt(multiply_add(z, z, pos_0));
            let pos_1 = k * (l - sqrt_0) / sqrt_0;
            let forcing_0 = -spring_1_span_x * pos_1;
            let forcing_1 = -spring_1_span_y * pos_1;
            let forcing_2 = multiply_add(-m, g, z * pos_1);
            let arm_z_x_dot = arm_x_x * q_dot;
            ::lagrange::constraint::redundant_motion(
                &[
                    [m, 0.0, 0.0, 0.0],
                    [0.0, m, 0.0, 0.0],
                    [0.0, 0.0, m, 0.0],
                    [0.0, 0.0, 0.0, arm_moments_y],
                ],
                &[forcing_0, forcing_1, forcing_2, u],
                &[
                    [-1.0, 0.0, 0.0, tip_origin_z],
                    [0.0, -1.0, 0.0, 0.0],
                    [0.0, 0.0, -1.0, -tip_origin_x],
                ],
                &[-l * q_dot * arm_z_x_dot, 0.0, l_arm_z_x * q_dot * q_dot],
            )
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for HungArm {
        fn default() -> Self {
            Self {
                m: 2.0,
                l: 0.8,
                r: 0.1,
                k: 30.0,
                g: 9.81,
                u: 0.0,
            }
        }
    }
    impl HungArmState {
        /// The coordinates in their order.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [f64; 4] {
            [self.x, self.y, self.z, self.q]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [f64; 4] {
            [self.x_dot, self.y_dot, self.z_dot, self.q_dot]
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 8]> for HungArmState {
        #[inline]
        fn from([x, y, z, q, x_dot, y_dot, z_dot, q_dot]: [f64; 8]) -> Self {
            Self {
                x,
                y,
                z,
                q,
                x_dot,
                y_dot,
                z_dot,
                q_dot,
            }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<HungArmState> for [f64; 8] {
        #[inline]
        fn from(state: HungArmState) -> Self {
            [
                state.x,
                state.y,
                state.z,
                state.q,
                state.x_dot,
                state.y_dot,
                state.z_dot,
                state.q_dot,
            ]
        }
    }
    impl<C: ::lagrange::system::Columns> HungArmColumns<C> {
        /// Coordinate `x`.
        #[must_use]
        #[inline]
        pub fn x(&self) -> &[C::Scalar] {
            self.0.column(0)
        }
        /// Coordinate `y`.
        #[must_use]
        #[inline]
        pub fn y(&self) -> &[C::Scalar] {
            self.0.column(1)
        }
        /// Coordinate `z`.
        #[must_use]
        #[inline]
        pub fn z(&self) -> &[C::Scalar] {
            self.0.column(2)
        }
        /// Coordinate `q`.
        #[must_use]
        #[inline]
        pub fn q(&self) -> &[C::Scalar] {
            self.0.column(3)
        }
        /// Velocity of `x`.
        #[must_use]
        #[inline]
        pub fn x_dot(&self) -> &[C::Scalar] {
            self.0.column(4)
        }
        /// Velocity of `y`.
        #[must_use]
        #[inline]
        pub fn y_dot(&self) -> &[C::Scalar] {
            self.0.column(5)
        }
        /// Velocity of `z`.
        #[must_use]
        #[inline]
        pub fn z_dot(&self) -> &[C::Scalar] {
            self.0.column(6)
        }
        /// Velocity of `q`.
        #[must_use]
        #[inline]
        pub fn q_dot(&self) -> &[C::Scalar] {
            self.0.column(7)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for HungArmColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for HungArmColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for HungArm {
        type Scalar = f64;
        type State = [f64; 8];
        #[inline]
        fn rhs(&self, t: f64, state: &[f64; 8]) -> [f64; 8] {
            self.rhs(t, state)
        }
        fn undefined(
            &self,
            t: f64,
            state: &[f64; 8],
            rates: &[f64; 8],
        ) -> ::core::option::Option<::lagrange::system::Undefined<f64>> {
            ::lagrange::integrate::undefined(
                self,
                (t, state, rates),
                &[("u", self.u)],
                |_, _| ::core::option::Option::None,
            )
        }
        const IS_CONSTRAINED: ::core::primitive::bool = true;
        #[inline]
        fn correct(
            &self,
            t: f64,
            state: &mut [f64; 8],
        ) -> ::core::result::Result<(), ::lagrange::system::StepFailure<f64>> {
            ::lagrange::constraint::correct(self, t, state)?;
            ::core::result::Result::Ok(())
        }
        #[inline]
        fn admit(
            &self,
            t: f64,
            state: &mut [f64; 8],
        ) -> ::core::result::Result<(), ::lagrange::system::StepFailure<f64>> {
            ::lagrange::constraint::admit(self, t, state)?;
            ::core::result::Result::Ok(())
        }
        #[inline]
        fn restore(
            &self,
            t: f64,
            state: &mut [f64; 8],
        ) -> ::core::result::Result<(), ::lagrange::system::StepFailure<f64>> {
            ::lagrange::constraint::restore(self, t, state)?;
            ::core::result::Result::Ok(())
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::MechanicalSystem for HungArm {
        type Coordinates = [f64; 4];
        type Velocities = [f64; 4];
        type Columns<C> = HungArmColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &[
            "x",
            "y",
            "z",
            "q",
        ];
        const FINGERPRINT: ::core::primitive::u64 = 4202435592529770351;
        #[inline]
        fn acceleration(&self, t: f64, positions: &[f64; 4], v: &[f64; 4]) -> [f64; 4] {
            self.acceleration(t, positions, v)
        }
        #[inline]
        fn position_rates(&self, _: f64, _: &[f64; 4], v: &[f64; 4]) -> [f64; 4] {
            *v
        }
        fn parameter(
            &self,
            index: ::core::primitive::usize,
        ) -> ::core::option::Option<(&'static ::core::primitive::str, f64)> {
            [("m", self.m), ("l", self.l), ("r", self.r), ("k", self.k), ("g", self.g)]
                .get(index)
                .copied()
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for HungArm {
        type NamedState = HungArmState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for HungArm {
        #[inline]
        fn energy(&self, t: f64, positions: &[f64; 4], v: &[f64; 4]) -> f64 {
            self.energy(t, positions, v)
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::LeapfrogSystem for HungArm {
        const IS_HELD: ::core::primitive::bool = true;
        #[inline]
        fn position_correction(
            &self,
            t: f64,
            positions: &[f64; 4],
            later: f64,
            to: &[f64; 4],
        ) -> [f64; 4] {
            let residuals = ::lagrange::constraint::ConstrainedSystem::position_residuals(
                self,
                later,
                to,
            );
            ::lagrange::constraint::ConstrainedSystem::correction(
                self,
                t,
                positions,
                positions,
                &residuals,
            )
        }
        #[inline]
        fn velocity_correction(
            &self,
            t: f64,
            positions: &[f64; 4],
            v: &[f64; 4],
        ) -> [f64; 4] {
            let residuals = self.constraint_velocity(t, positions, v);
            ::lagrange::constraint::ConstrainedSystem::correction(
                self,
                t,
                positions,
                v,
                &residuals,
            )
        }
    }
    #[automatically_derived]
    impl ::lagrange::constraint::ConstrainedSystem for HungArm {
        type Multipliers = [f64; 3];
        const CONSTRAINTS: &'static [&'static ::core::primitive::str] = &[
            "hook_x",
            "hook_y",
            "hook_z",
        ];
        #[inline]
        fn multipliers(&self, t: f64, positions: &[f64; 4], v: &[f64; 4]) -> [f64; 3] {
            self.multipliers(t, positions, v)
        }
        #[inline]
        fn velocity_residuals(
            &self,
            t: f64,
            positions: &[f64; 4],
            v: &[f64; 4],
        ) -> [f64; 3] {
            self.constraint_velocity(t, positions, v)
        }
        #[inline]
        fn residual_scales(
            &self,
            t: f64,
            positions: &[f64; 4],
            shares: &[f64; 4],
        ) -> [f64; 3] {
            ::lagrange::constraint::weighed(
                &self.constraint_jacobian(t, positions),
                shares,
            )
        }
        #[inline]
        fn correction(
            &self,
            t: f64,
            positions: &[f64; 4],
            v: &[f64; 4],
            residuals: &[f64; 3],
        ) -> [f64; 4] {
            let Self { m, l, r, .. } = *self;
            let [_, _, _, q] = *positions;
            let [hook_x, hook_y, hook_z] = *residuals;
            let r_sq = r * r;
            let const_0 = 0.08333333333333333 * m * multiply_add(l, l, r_sq);
            let arm_moments_y = multiply_add(-0.000625 * m, r_sq, const_0);
            let inv_arm_moments_y = 1.0 / arm_moments_y;
            let (arm_z_x, arm_x_x) = sin_cos(q);
            let l_arm_z_x = l * arm_z_x;
            let factor_4_3 = inv_arm_moments_y * l_arm_z_x;
            let factor_4_0 = 1.0 / m;
            let pivot_4 = -multiply_add(l_arm_z_x, factor_4_3, factor_4_0);
            let inv_pivot_4 = 1.0 / pivot_4;
            let tip_origin_x = l * arm_x_x;
            let pos_0 = tip_origin_x * factor_4_3;
            let pos_1 = pos_0 * inv_pivot_4;
            let factor_6_3 = inv_arm_moments_y * tip_origin_x;
            let pos_2 = multiply_add(tip_origin_x, factor_6_3, factor_4_0);
            let pivot_6 = -multiply_add(pos_0, pos_1, pos_2);
            let inv_pivot_6 = 1.0 / pivot_6;
            let acc_0 = inv_pivot_6 * multiply_add(hook_x, pos_1, hook_z);
            let acc_1 = multiply_add(pos_1, acc_0, hook_x * inv_pivot_4);
            let values = [
                -factor_4_0 * acc_1,
                hook_y,
                -factor_4_0 * acc_0,
                -multiply_add(factor_6_3, acc_0, factor_4_3 * acc_1),
            ];
            if ::lagrange::constraint::are_regular(&values, abs(inv_pivot_6 * pos_2)) {
                values
            } else {
                self.redundant_correction(t, positions, v, residuals)
            }
        }
        #[inline]
        fn position_residuals(&self, t: f64, positions: &[f64; 4]) -> [f64; 3] {
            let Self { l, .. } = *self;
            let [x, y, z, q] = *positions;
            let (arm_z_x, arm_x_x) = sin_cos(q);
            let tip_origin_x = l * arm_x_x;
            [tip_origin_x - x, -y, -multiply_add(l, arm_z_x, z)]
        }
        #[inline]
        fn mass_times(
            &self,
            t: f64,
            positions: &[f64; 4],
            v: &[f64; 4],
            a: &[f64; 4],
        ) -> [f64; 4] {
            let Self { m, l, r, .. } = *self;
            let [x_ddot, y_ddot, z_ddot, q_ddot] = *a;
            let r_sq = r * r;
            let const_0 = 0.08333333333333333 * m * multiply_add(l, l, r_sq);
            let arm_moments_y = multiply_add(-0.000625 * m, r_sq, const_0);
            [m * x_ddot, m * y_ddot, m * z_ddot, arm_moments_y * q_ddot]
        }
    }
    #[automatically_derived]
    impl ::lagrange::scene::Scene for HungArm {
        type Space = ::lagrange::scene::Spatial;
        #[inline]
        fn items(
            &self,
            t: f64,
            positions: &[f64; 4],
            v: &[f64; 4],
            visit: &mut dyn ::core::ops::FnMut(
                ::lagrange::scene::Item<'_, f64, ::lagrange::scene::Spatial>,
            ),
        ) {
            let Self { m, l, r, k, g, u } = *self;
            let [x, y, z, q] = *positions;
            let [x_dot, y_dot, z_dot, q_dot] = *v;
            let [x_ddot, y_ddot, z_ddot, q_ddot] = self.acceleration(t, positions, v);
            let [hook_x, hook_y, hook_z] = self.multipliers(t, positions, v);
            let arm_mass = 0.98 * m;
            let r_sq = r * r;
            let m_r_sq = m * r_sq;
            let arm_moments_x = 0.1646875 * m_r_sq;
            let const_0 = m * multiply_add(l, l, r_sq) * 0.08333333333333333;
            let arm_moments_y = multiply_add(-0.000625, m_r_sq, const_0);
            let arm_moments_z = multiply_add(-0.001979166666666667, m_r_sq, const_0);
            let (arm_z_x, arm_x_x) = sin_cos(q);
            let arm_x_z = -arm_z_x;
            let tip_origin_x = l * arm_x_x;
            let tip_origin_z = -l * arm_z_x;
            let spring_1_span_x = 1.0 - x;
            let spring_1_span_y = 1.0 - y;
            let spring_1_span_x_sq = spring_1_span_x * spring_1_span_x;
            let pos_0 = multiply_add(
                spring_1_span_y,
                spring_1_span_y,
                spring_1_span_x_sq,
            );
            let sqrt_0 = sqrt(multiply_add(z, z, pos_0));
            let pos_1 = l - sqrt_0;
            let m_g = m * g;
            let inv_sqrt_0 = 1.0 / sqrt_0;
            visit(::lagrange::scene::Item::Body {
                name: "arm",
                motion: ::lagrange::body::SpatialMotion {
                    mass: arm_mass,
                    inertia: [
                        [arm_moments_x, 0.0, 0.0],
                        [0.0, arm_moments_y, 0.0],
                        [0.0, 0.0, arm_moments_z],
                    ],
                    centroid: [0.0, 0.0, 0.0],
                    center: [0.0, 0.0, 0.0],
                    rotation: [
                        [arm_x_x, 0.0, arm_z_x],
                        [0.0, 1.0, 0.0],
                        [arm_x_z, 0.0, arm_x_x],
                    ],
                    velocity: [0.0, 0.0, 0.0],
                    angular_velocity: [0.0, q_dot, 0.0],
                    acceleration: [0.0, 0.0, 0.0],
                    angular_acceleration: [0.0, q_ddot, 0.0],
                },
                parts: &[
                    ::lagrange::scene::Part {
                        shape: ::lagrange::scene::Solid::Cuboid(l, r, r),
                        at: [0.0, 0.0, 0.0],
                        rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
                        is_hole: false,
                    },
                    ::lagrange::scene::Part {
                        shape: ::lagrange::scene::Solid::Cylinder(0.25 * r, r),
                        at: [0.0, 0.0, 0.0],
                        rotation: [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]],
                        is_hole: true,
                    },
                ],
            });
            visit(
                ::lagrange::scene::Item::Frame(::lagrange::scene::Frame {
                    name: "tip",
                    rotation: [
                        [arm_x_x, 0.0, arm_z_x],
                        [0.0, 1.0, 0.0],
                        [arm_x_z, 0.0, arm_x_x],
                    ],
                    origin: [tip_origin_x, 0.0, tip_origin_z],
                }),
            );
            visit(::lagrange::scene::Item::Body {
                name: "bob",
                motion: ::lagrange::body::SpatialMotion {
                    mass: m,
                    inertia: [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]],
                    centroid: [0.0, 0.0, 0.0],
                    center: [x, y, z],
                    rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
                    velocity: [x_dot, y_dot, z_dot],
                    angular_velocity: [0.0, 0.0, 0.0],
                    acceleration: [x_ddot, y_ddot, z_ddot],
                    angular_acceleration: [0.0, 0.0, 0.0],
                },
                parts: &[
                    ::lagrange::scene::Part {
                        shape: ::lagrange::scene::Solid::PointMass,
                        at: [0.0, 0.0, 0.0],
                        rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
                        is_hole: false,
                    },
                ],
            });
            visit(::lagrange::scene::Item::Connector {
                name: "spring_1",
                kind: ::lagrange::scene::Connector::Spring,
                from: [x, y, z],
                to: [1.0, 1.0, 0.0],
                tension: -k * pos_1,
            });
            visit(::lagrange::scene::Item::Joint {
                name: "q",
                kind: ::lagrange::scene::SpatialJoint {
                    kind: ::lagrange::scene::SpatialJointKind::Revolute,
                    axis: [0.0, 1.0, 0.0],
                    bodies: [
                        ::core::option::Option::None,
                        ::core::option::Option::Some("arm"),
                    ],
                },
                at: [0.0, 0.0, 0.0],
            });
            visit(::lagrange::scene::Item::Joint {
                name: "tip",
                kind: ::lagrange::scene::SpatialJoint {
                    kind: ::lagrange::scene::SpatialJointKind::Weld,
                    axis: [arm_z_x, 0.0, arm_x_x],
                    bodies: [
                        ::core::option::Option::Some("arm"),
                        ::core::option::Option::Some("tip"),
                    ],
                },
                at: [tip_origin_x, 0.0, tip_origin_z],
            });
            visit(::lagrange::scene::Item::Joint {
                name: "hook",
                kind: ::lagrange::scene::SpatialJoint {
                    kind: ::lagrange::scene::SpatialJointKind::Pin,
                    axis: [0.0, 0.0, 1.0],
                    bodies: [
                        ::core::option::Option::Some("tip"),
                        ::core::option::Option::Some("bob"),
                    ],
                },
                at: [tip_origin_x, 0.0, tip_origin_z],
            });
            visit(::lagrange::scene::Item::Force {
                name: "gravity",
                cause: ::lagrange::scene::LoadOrigin::Gravity,
                body: ::core::option::Option::Some("arm"),
                at: [0.0, 0.0, 0.0],
                force: [0.0, 0.0, -0.98 * m_g],
            });
            visit(::lagrange::scene::Item::Moment {
                name: "torque",
                cause: ::lagrange::scene::LoadOrigin::Applied,
                body: ::core::option::Option::Some("arm"),
                at: [0.0, 0.0, 0.0],
                moment: [0.0, u, 0.0],
            });
            visit(::lagrange::scene::Item::Force {
                name: "gravity",
                cause: ::lagrange::scene::LoadOrigin::Gravity,
                body: ::core::option::Option::Some("bob"),
                at: [x, y, z],
                force: [0.0, 0.0, -m_g],
            });
            visit(::lagrange::scene::Item::Force {
                name: "hook",
                cause: ::lagrange::scene::LoadOrigin::Joint,
                body: ::core::option::Option::Some("arm"),
                at: [tip_origin_x, 0.0, tip_origin_z],
                force: [hook_x, hook_y, hook_z],
            });
            visit(::lagrange::scene::Item::Force {
                name: "hook",
                cause: ::lagrange::scene::LoadOrigin::Joint,
                body: ::core::option::Option::Some("bob"),
                at: [x, y, z],
                force: [-hook_x, -hook_y, -hook_z],
            });
            visit(::lagrange::scene::Item::Force {
                name: "spring_1",
                cause: ::lagrange::scene::LoadOrigin::Connector,
                body: ::core::option::Option::Some("bob"),
                at: [x, y, z],
                force: [
                    -k * spring_1_span_x * inv_sqrt_0 * pos_1,
                    -k * spring_1_span_y * inv_sqrt_0 * pos_1,
                    k * z * inv_sqrt_0 * pos_1,
                ],
            });
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::ParametricSystem for HungArm {
        const NUMBERS: &'static [&'static ::core::primitive::str] = &[
            "m",
            "l",
            "r",
            "k",
            "g",
            "u",
        ];
        fn number(
            &self,
            index: ::core::primitive::usize,
        ) -> ::core::option::Option<f64> {
            <[f64]>::get(&[self.m, self.l, self.r, self.k, self.g, self.u], index)
                .copied()
        }
        fn with_number(&self, index: ::core::primitive::usize, value: f64) -> Self {
            let mut other = Self {
                m: self.m,
                l: self.l,
                r: self.r,
                k: self.k,
                g: self.g,
                u: self.u,
            };
            match index {
                0 => other.m = value,
                1 => other.l = value,
                2 => other.r = value,
                3 => other.k = value,
                4 => other.g = value,
                5 => other.u = value,
                _ => {}
            }
            other
        }
        fn correct_adjoint(
            &self,
            t: f64,
            state: &[f64; 8],
            slope: &mut [f64; 8],
            indices: &[::core::primitive::usize],
            by: &mut [f64],
        ) -> ::core::primitive::bool {
            ::lagrange::constraint::correct_adjoint(self, t, state, slope, indices, by)
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 1]> for HungArmInputs {
        #[inline]
        fn from([u]: [f64; 1]) -> Self {
            Self { u }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<HungArmInputs> for [f64; 1] {
        #[inline]
        fn from(inputs: HungArmInputs) -> Self {
            [inputs.u]
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::ControlledSystem for HungArm {
        type Inputs = HungArmInputs;
        type InputVector = [f64; 1];
        const INPUTS: &'static [&'static ::core::primitive::str] = &["u"];
        #[inline]
        fn inputs(&self) -> HungArmInputs {
            HungArmInputs { u: self.u }
        }
        #[inline]
        fn with_inputs(&self, inputs: HungArmInputs) -> Self {
            Self {
                u: inputs.u,
                m: self.m,
                l: self.l,
                r: self.r,
                k: self.k,
                g: self.g,
            }
        }
    }
};
