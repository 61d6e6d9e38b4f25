/// A rod with a hole, hinged to a point and held by a spring, above a slope.
///
/// # Equations of motion
///
/// ```text
/// 0.9*m*ddot(x) = u + hinge_x
///     - (x + 19/36*l*cos(a) - 2)*(k - k/(2*sqrt((x + 19/36*l*cos(a) - 2)^2 + (y + 19/36*l*sin(a) - 1)^2)))
/// 0.9*m*ddot(y) = hinge_y - 0.9*m*g
///     - (y + 19/36*l*sin(a) - 1)*(k - k/(2*sqrt((x + 19/36*l*cos(a) - 2)^2 + (y + 19/36*l*sin(a) - 1)^2)))
/// 5731/72000*m*l^2*ddot(a) = 17/36*l*sin(a)*hinge_x - 17/36*l*cos(a)*hinge_y
///     - 19/36*(l*cos(a)*(y + 19/36*l*sin(a) - 1)*(k - k/(2*sqrt((x + 19/36*l*cos(a) - 2)^2 + (y + 19/36*l*sin(a) - 1)^2))) - l*sin(a)*(x + 19/36*l*cos(a) - 2)*(k - k/(2*sqrt((x + 19/36*l*cos(a) - 2)^2 + (y + 19/36*l*sin(a) - 1)^2))))
/// x - 17/36*l*cos(a) = 0
/// y - 17/36*l*sin(a) - 1 = 0
/// ```
///
/// # State and structure
///
/// - State: `[x, y, a, x_dot, y_dot, a_dot]`.
/// - Mass matrix: diagonal, constant.
/// - Leapfrog methods take it and keep it on the constraints.
/// - Forward dynamics: eliminated body by body (counted cost 364; factorised mass matrix 366).
/// - Multipliers, which the equations name like their constraints: `[hinge_x, hinge_y]`.
/// - Cost of `acceleration`: 23 additions, 55 multiplications, 5 divisions, 1 square root, 1 function, 1 `sin_cos`.
///
/// # Statements
///
/// Those about rigid bodies stand for plain ones:
///
/// ```text
/// param m = 2, l = 1.5, k = 30, g = 9.81, slope = 0.3;
/// coord x, y, a;
/// input u;
/// let rod_mass = m - m/10;
/// let rod_centroid_x = -(m/10 * (l/4) / rod_mass);
/// let rod_inertia = rectangle(m, l, l/5) + m * (-rod_centroid_x)^2 - (disk(m/10, l/20) + m/10 * (l/4 - rod_centroid_x)^2);
/// let rod_center = (x, y);
/// kinetic = kinetic_energy(rod_mass, dot(rod_center));
/// kinetic = kinetic_energy(rod_inertia, dot(a));
/// potential = rod_mass * g * rod_center.y;
/// constraint hinge_x = rod_center.x - rod_centroid_x * cos(a) - l/2 * cos(a);
/// constraint hinge_y = rod_center.y - rod_centroid_x * sin(a) - l/2 * sin(a) - 1;
/// let spring_1_span = (2 - (rod_center.x - rod_centroid_x * cos(a) + l/2 * cos(a)), 1 - (rod_center.y - rod_centroid_x * sin(a) + l/2 * sin(a)));
/// potential = spring_energy(k, norm(spring_1_span) - 1/2);
/// force (u, 0) at rod_center;
/// emit { no momenta }
/// ```
pub struct RodOnSlope {
    /// Parameter `m`.
    pub m: ::core::primitive::f64,
    /// Parameter `l`.
    pub l: ::core::primitive::f64,
    /// Parameter `k`.
    pub k: ::core::primitive::f64,
    /// Parameter `g`.
    pub g: ::core::primitive::f64,
    /// Parameter `slope`.
    pub slope: ::core::primitive::f64,
    /// Input `u`.
    pub u: ::core::primitive::f64,
}
/// State of [`RodOnSlope`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RodOnSlopeState {
    /// Coordinate `x`.
    pub x: ::core::primitive::f64,
    /// Coordinate `y`.
    pub y: ::core::primitive::f64,
    /// Coordinate `a`.
    pub a: ::core::primitive::f64,
    /// Velocity of `x`.
    pub x_dot: ::core::primitive::f64,
    /// Velocity of `y`.
    pub y_dot: ::core::primitive::f64,
    /// Velocity of `a`.
    pub a_dot: ::core::primitive::f64,
}
/// Columns of a table of states of [`RodOnSlope`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct RodOnSlopeColumns<C>(C);
/// Inputs of [`RodOnSlope`].
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RodOnSlopeInputs {
    /// Input `u`.
    pub u: ::core::primitive::f64,
}
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::{abs, multiply_add, sin_cos, sqrt};
    impl RodOnSlope {
        /// The statements that those about rigid bodies stand for.
        pub const STATEMENTS: &'static ::core::primitive::str = "param m = 2, l = 1.5, k = 30, g = 9.81, slope = 0.3;\ncoord x, y, a;\ninput u;\nlet rod_mass = m - m/10;\nlet rod_centroid_x = -(m/10 * (l/4) / rod_mass);\nlet rod_inertia = rectangle(m, l, l/5) + m * (-rod_centroid_x)^2 - (disk(m/10, l/20) + m/10 * (l/4 - rod_centroid_x)^2);\nlet rod_center = (x, y);\nkinetic = kinetic_energy(rod_mass, dot(rod_center));\nkinetic = kinetic_energy(rod_inertia, dot(a));\npotential = rod_mass * g * rod_center.y;\nconstraint hinge_x = rod_center.x - rod_centroid_x * cos(a) - l/2 * cos(a);\nconstraint hinge_y = rod_center.y - rod_centroid_x * sin(a) - l/2 * sin(a) - 1;\nlet spring_1_span = (2 - (rod_center.x - rod_centroid_x * cos(a) + l/2 * cos(a)), 1 - (rod_center.y - rod_centroid_x * sin(a) + l/2 * sin(a)));\npotential = spring_energy(k, norm(spring_1_span) - 1/2);\nforce (u, 0) at rod_center;\nemit { no momenta }\n";
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 23 additions, 55 multiplications, 5 divisions, 1 square root, 1 function, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> [f64; 3] {
            let Self { m, l, k, g, u, .. } = *self;
            let [x, y, a] = *q;
            let [_, _, a_dot] = *v;
            let (sin_a, cos_a) = sin_cos(a);
            let l_cos_a = l * cos_a;
            let spring_1_span_x = multiply_add(-0.5277777777777778, l_cos_a, 2.0 - x);
            let l_sin_a = l * sin_a;
            let spring_1_span_y = multiply_add(-0.5277777777777778, l_sin_a, 1.0 - y);
            let spring_1_span_x_sq = spring_1_span_x * spring_1_span_x;
            let sqrt_0 = sqrt(
                multiply_add(spring_1_span_y, spring_1_span_y, spring_1_span_x_sq),
            );
            let pos_0 = k * (sqrt_0 - 0.5) / sqrt_0;
            let pos_1 = spring_1_span_y * pos_0;
            let forcing_1 = multiply_add(-0.9 * m, g, pos_1);
            let inv_m = 1.0 / m;
            let inv_m_forcing_1 = inv_m * forcing_1;
            let const_0 = 0.4722222222222222 * l;
            let a_dot_sq = a_dot * a_dot;
            let pos_2 = spring_1_span_x * pos_0;
            let pos_3 = multiply_add(-l_cos_a, pos_1, l_sin_a * pos_2);
            let pos_4 = 3.131119253959945 * pos_3;
            let l_sq = l * l;
            let inv_0 = 1.0 / (m * l_sq);
            let pos_5 = inv_0 * l_cos_a;
            let vel_0 = multiply_add(
                -(-1.1111111111111112),
                inv_m_forcing_1,
                const_0 * sin_a * a_dot_sq,
            );
            let forcing_0 = u + pos_2;
            let inv_m_forcing_0 = inv_m * forcing_0;
            let pos_6 = inv_0 * l_sin_a;
            let vel_1 = multiply_add(
                1.1111111111111112,
                inv_m_forcing_0,
                const_0 * cos_a * a_dot_sq,
            );
            let forcing_3 = multiply_add(-pos_4, pos_6, vel_1);
            let const_1 = 1.1111111111111112 * inv_m;
            let pivot_3 = -multiply_add(2.8015277535431085 * l_sin_a, pos_6, const_1);
            let inv_pivot_3 = 1.0 / pivot_3;
            let pos_7 = l_cos_a * pos_6;
            let pos_8 = pos_7 * inv_pivot_3;
            let vel_2 = multiply_add(pos_4, pos_5, vel_0);
            let forcing_4 = multiply_add(-2.8015277535431085 * pos_8, forcing_3, vel_2);
            let pos_9 = l_cos_a * pos_5 * 2.8015277535431085;
            let pivot_4 = multiply_add(-7.848557753872297 * pos_7, pos_8, -const_1)
                - pos_9;
            let inv_pivot_4 = 1.0 / pivot_4;
            let vel_3 = inv_pivot_4 * forcing_4;
            let vel_4 = multiply_add(
                -inv_pivot_3,
                forcing_3,
                2.8015277535431085 * pos_8 * vel_3,
            );
            let x_ddot = 1.1111111111111112
                * multiply_add(-inv_m, vel_4, inv_m_forcing_0);
            let y_ddot = 1.1111111111111112
                * multiply_add(inv_m, vel_3, inv_m_forcing_1);
            let vel_5 = multiply_add(pos_5, vel_3, pos_6 * vel_4);
            let a_ddot = -multiply_add(
                5.9326470075030535,
                vel_5,
                6.630605478974001 * inv_0 * pos_3,
            );
            let values = [x_ddot, y_ddot, a_ddot];
            if ::lagrange::constraint::are_regular(
                &values,
                abs(inv_pivot_4 * (const_1 + pos_9)),
            ) {
                values
            } else {
                self.redundant_motion(t, q, v).acceleration
            }
        }
        /// Multipliers λ of the constraints in the order of their declaration: M q̈ = f + Aᵀλ. That of a
        /// constraint on a length is the force along it.
        ///
        /// Takes 19 additions, 45 multiplications, 5 divisions, 1 square root, 1 function, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn multipliers(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> [f64; 2] {
            let Self { m, l, k, g, u, .. } = *self;
            let [x, y, a] = *q;
            let [_, _, a_dot] = *v;
            let (sin_a, cos_a) = sin_cos(a);
            let l_cos_a = l * cos_a;
            let spring_1_span_x = multiply_add(-0.5277777777777778, l_cos_a, 2.0 - x);
            let l_sin_a = l * sin_a;
            let spring_1_span_y = multiply_add(-0.5277777777777778, l_sin_a, 1.0 - y);
            let spring_1_span_x_sq = spring_1_span_x * spring_1_span_x;
            let sqrt_0 = sqrt(
                multiply_add(spring_1_span_y, spring_1_span_y, spring_1_span_x_sq),
            );
            let pos_0 = k * (sqrt_0 - 0.5) / sqrt_0;
            let pos_1 = spring_1_span_x * pos_0;
            let pos_2 = spring_1_span_y * pos_0;
            let pos_3 = 3.131119253959945
                * multiply_add(-l_cos_a, pos_2, l_sin_a * pos_1);
            let forcing_1 = multiply_add(-0.9 * m, g, pos_2);
            let const_0 = 0.4722222222222222 * l;
            let a_dot_sq = a_dot * a_dot;
            let inv_m = 1.0 / m;
            let vel_0 = const_0 * sin_a * a_dot_sq;
            let l_sq = l * l;
            let inv_0 = 1.0 / (m * l_sq);
            let pos_4 = inv_0 * l_cos_a;
            let vel_1 = multiply_add(-(-1.1111111111111112 * inv_m), forcing_1, vel_0);
            let forcing_0 = u + pos_1;
            let const_1 = 1.1111111111111112 * inv_m;
            let pos_5 = inv_0 * l_sin_a;
            let vel_2 = multiply_add(const_1, forcing_0, const_0 * cos_a * a_dot_sq);
            let forcing_3 = multiply_add(-pos_3, pos_5, vel_2);
            let pivot_3 = -multiply_add(2.8015277535431085 * l_sin_a, pos_5, const_1);
            let inv_pivot_3 = 1.0 / pivot_3;
            let pos_6 = l_cos_a * pos_5;
            let pos_7 = pos_6 * inv_pivot_3;
            let vel_3 = multiply_add(pos_3, pos_4, vel_1);
            let forcing_4 = multiply_add(-2.8015277535431085 * pos_7, forcing_3, vel_3);
            let pos_8 = l_cos_a * pos_4 * 2.8015277535431085;
            let pivot_4 = multiply_add(-7.848557753872297 * pos_6, pos_7, -const_1)
                - pos_8;
            let inv_pivot_4 = 1.0 / pivot_4;
            let vel_4 = inv_pivot_4 * forcing_4;
            let values = [
                multiply_add(
                    -2.8015277535431085 * pos_7,
                    vel_4,
                    inv_pivot_3 * forcing_3,
                ),
                vel_4,
            ];
            if ::lagrange::constraint::are_regular(
                &values,
                abs(inv_pivot_4 * (const_1 + pos_8)),
            ) {
                values
            } else {
                self.redundant_motion(t, q, v).multipliers
            }
        }
        /// Mass matrix M, in rows.
        ///
        /// Takes 4 multiplications.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f64, q: &[f64; 3]) -> [[f64; 3]; 3] {
            let Self { m, l, .. } = *self;
            let rod_mass = 0.9 * m;
            let l_sq = l * l;
            let rod_inertia = 0.07959722222222222 * m * l_sq;
            [[rod_mass, 0.0, 0.0], [0.0, rod_mass, 0.0], [0.0, 0.0, rod_inertia]]
        }
        /// Right-hand side f of M q̈ = f.
        ///
        /// Takes 9 additions, 15 multiplications, 1 division, 1 square root, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> [f64; 3] {
            let Self { m, l, k, g, u, .. } = *self;
            let [x, y, a] = *q;
            let (sin_a, cos_a) = sin_cos(a);
            let const_0 = 0.5277777777777778 * l;
            let spring_1_span_x = multiply_add(-const_0, cos_a, 2.0 - x);
            let spring_1_span_y = multiply_add(-const_0, sin_a, 1.0 - y);
            let spring_1_span_x_sq = spring_1_span_x * spring_1_span_x;
            let sqrt_0 = sqrt(
                multiply_add(spring_1_span_y, spring_1_span_y, spring_1_span_x_sq),
            );
            let pos_0 = k * (sqrt_0 - 0.5) / sqrt_0;
            let pos_1 = spring_1_span_x * pos_0;
            let forcing_0 = u + pos_1;
            let pos_2 = spring_1_span_y * pos_0;
            let forcing_1 = multiply_add(-0.9 * m, g, pos_2);
            [
                forcing_0,
                forcing_1,
                -0.5277777777777778 * multiply_add(-l * cos_a, pos_2, l * sin_a * pos_1),
            ]
        }
        /// Kinetic energy T.
        ///
        /// Takes 2 additions, 9 multiplications.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> f64 {
            let Self { m, l, .. } = *self;
            let [x_dot, y_dot, a_dot] = *v;
            let l_sq = l * l;
            let a_dot_sq = a_dot * a_dot;
            let vel_0 = 0.45 * m * multiply_add(y_dot, y_dot, x_dot * x_dot);
            multiply_add(0.03979861111111111 * m * l_sq, a_dot_sq, vel_0)
        }
        /// Potential energy V.
        ///
        /// Takes 7 additions, 11 multiplications, 1 square root, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, q: &[f64; 3]) -> f64 {
            let Self { m, l, k, g, .. } = *self;
            let [x, y, a] = *q;
            let (sin_a, cos_a) = sin_cos(a);
            let const_0 = 0.5277777777777778 * l;
            let spring_1_span_x = multiply_add(-const_0, cos_a, 2.0 - x);
            let spring_1_span_y = multiply_add(-const_0, sin_a, 1.0 - y);
            let spring_1_span_x_sq = spring_1_span_x * spring_1_span_x;
            let pos_0 = sqrt(
                multiply_add(spring_1_span_y, spring_1_span_y, spring_1_span_x_sq),
            ) - 0.5;
            let pos_0_sq = pos_0 * pos_0;
            multiply_add(0.5 * k, pos_0_sq, 0.9 * m * g * y)
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 10 additions, 20 multiplications, 1 square root, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> f64 {
            let Self { m, l, k, g, .. } = *self;
            let [x, y, a] = *q;
            let [x_dot, y_dot, a_dot] = *v;
            let (sin_a, cos_a) = sin_cos(a);
            let const_0 = 0.5277777777777778 * l;
            let spring_1_span_x = multiply_add(-const_0, cos_a, 2.0 - x);
            let spring_1_span_y = multiply_add(-const_0, sin_a, 1.0 - y);
            let spring_1_span_x_sq = spring_1_span_x * spring_1_span_x;
            let pos_0 = sqrt(
                multiply_add(spring_1_span_y, spring_1_span_y, spring_1_span_x_sq),
            ) - 0.5;
            let l_sq = l * l;
            let a_dot_sq = a_dot * a_dot;
            let vel_0 = 0.45 * m * multiply_add(y_dot, y_dot, x_dot * x_dot);
            let vel_1 = multiply_add(0.03979861111111111 * m * l_sq, a_dot_sq, vel_0);
            let pos_0_sq = pos_0 * pos_0;
            multiply_add(0.5 * k, pos_0_sq, multiply_add(0.9 * m * g, y, vel_1))
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 12 additions, 22 multiplications, 1 division, 1 square root, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            q: &[f64; 3],
            v: &[f64; 3],
            accelerations: &[f64; 3],
        ) -> [f64; 3] {
            let Self { m, l, k, g, u, .. } = *self;
            let [x, y, a] = *q;
            let [x_ddot, y_ddot, a_ddot] = *accelerations;
            let (sin_a, cos_a) = sin_cos(a);
            let const_0 = 0.5277777777777778 * l;
            let spring_1_span_x = multiply_add(-const_0, cos_a, 2.0 - x);
            let spring_1_span_y = multiply_add(-const_0, sin_a, 1.0 - y);
            let spring_1_span_x_sq = spring_1_span_x * spring_1_span_x;
            let sqrt_0 = sqrt(
                multiply_add(spring_1_span_y, spring_1_span_y, spring_1_span_x_sq),
            );
            let pos_0 = k * (sqrt_0 - 0.5) / sqrt_0;
            let pos_1 = spring_1_span_x * pos_0;
            let pos_2 = spring_1_span_y * pos_0;
            let l_sq = l * l;
            let pos_3 = 0.5277777777777778
                * multiply_add(-l * cos_a, pos_2, l * sin_a * pos_1);
            [
                multiply_add(0.9 * m, x_ddot, -u) - pos_1,
                multiply_add(0.9, multiply_add(m, y_ddot, m * g), -pos_2),
                multiply_add(0.07959722222222222 * m * l_sq, a_ddot, pos_3),
            ]
        }
        /// What the constraints hold at zero, in the order of their declaration; the velocities matter to
        /// nonholonomic ones only.
        ///
        /// Takes 3 additions, 3 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn constraints(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> [f64; 2] {
            let Self { l, .. } = *self;
            let [x, y, a] = *q;
            let (sin_a, cos_a) = sin_cos(a);
            let const_0 = 0.4722222222222222 * l;
            [multiply_add(-const_0, cos_a, x), multiply_add(-const_0, sin_a, y) - 1.0]
        }
        /// What the constraints demand of the velocities to be zero: the rate of a holonomic constraint,
        /// a nonholonomic one itself.
        ///
        /// Takes 2 additions, 5 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn constraint_velocity(
            &self,
            t: f64,
            q: &[f64; 3],
            v: &[f64; 3],
        ) -> [f64; 2] {
            let Self { l, .. } = *self;
            let [_, _, a] = *q;
            let [x_dot, y_dot, a_dot] = *v;
            let (sin_a, cos_a) = sin_cos(a);
            let const_0 = 0.4722222222222222 * l;
            [
                multiply_add(const_0 * sin_a, a_dot, x_dot),
                multiply_add(-const_0 * cos_a, a_dot, y_dot),
            ]
        }
        /// Matrix A of the constraints, in rows: what each demands of the velocities, differentiated by
        /// them.
        ///
        /// Takes 4 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn constraint_jacobian(&self, t: f64, q: &[f64; 3]) -> [[f64; 3]; 2] {
            let Self { l, .. } = *self;
            let [_, _, a] = *q;
            let (sin_a, cos_a) = sin_cos(a);
            [
                [1.0, 0.0, 0.4722222222222222 * l * sin_a],
                [0.0, 1.0, -0.4722222222222222 * l * cos_a],
            ]
        }
        /// Generalised forces Aᵀλ of the constraints.
        ///
        /// Takes 1 addition, 5 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn constraint_forces(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> [f64; 3] {
            let Self { l, .. } = *self;
            let [_, _, a] = *q;
            let [hinge_x, hinge_y] = self.multipliers(t, q, v);
            let (sin_a, cos_a) = sin_cos(a);
            [
                hinge_x,
                hinge_y,
                0.4722222222222222
                    * multiply_add(-l * hinge_y, cos_a, hinge_x * l * sin_a),
            ]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, state: &[f64; 6]) -> [f64; 6] {
            let [x, y, a, x_dot, y_dot, a_dot] = *state;
            let accelerations = self.acceleration(t, &[x, y, a], &[x_dot, y_dot, a_dot]);
            [x_dot, y_dot, a_dot, accelerations[0], accelerations[1], accelerations[2]]
        }
        /// How the body `rod` moves.
        ///
        /// Takes 5 multiplications.
        #[must_use]
        #[inline]
        pub fn rod_motion(
            &self,
            t: f64,
            q: &[f64; 3],
            v: &[f64; 3],
        ) -> ::lagrange::body::Motion<f64> {
            let Self { m, l, .. } = *self;
            let [x, y, a] = *q;
            let [x_dot, y_dot, a_dot] = *v;
            let [x_ddot, y_ddot, a_ddot] = self.acceleration(t, q, v);
            let rod_mass = 0.9 * m;
            let l_sq = l * l;
            let rod_inertia = 0.07959722222222222 * m * l_sq;
            let rod_centroid_x = -0.027777777777777776 * l;
            ::lagrange::body::Motion {
                mass: rod_mass,
                inertia: rod_inertia,
                centroid: [rod_centroid_x, 0.0],
                center: [x, y],
                angle: a,
                velocity: [x_dot, y_dot],
                angular_velocity: a_dot,
                acceleration: [x_ddot, y_ddot],
                angular_acceleration: a_ddot,
            }
        }
        /// Takes positions and velocities to the nearest ones that satisfy the constraints, as the mass matrix where they
        /// are found measures distances: first positions, then velocities.
        ///
        /// # Errors
        /// If that does not succeed; both are then what they were.
        #[inline]
        pub fn project(
            &self,
            t: f64,
            q: &mut [f64; 3],
            v: &mut [f64; 3],
        ) -> ::core::result::Result<(), ::lagrange::constraint::Violation<f64>> {
            ::lagrange::constraint::project(self, t, q, v)
        }
        /// The nearest velocities that satisfy the constraints at these positions.
        ///
        /// # Errors
        /// If there are none.
        #[inline]
        pub fn consistent_velocity(
            &self,
            t: f64,
            q: &[f64; 3],
            v: &[f64; 3],
        ) -> ::core::result::Result<[f64; 3], ::lagrange::constraint::Violation<f64>> {
            ::lagrange::constraint::consistent_velocity(self, t, q, v)
        }
        /// The correction where constraints depend on each other.
        #[cold]
        #[inline(never)]
        fn redundant_correction(
            &self,
            t: f64,
            q: &[f64; 3],
            v: &[f64; 3],
            residuals: &[f64; 2],
        ) -> [f64; 3] {
            let Self { m, l, .. } = *self;
            let [_, _, a] = *q;
            let rod_mass = 0.9 * m;
            let l_sq = l * l;
            let rod_inertia = 0.07959722222222222 * m * l_sq;
            let (sin_a, cos_a) = sin_cos(a);
            ::lagrange::constraint::redundant_correction(
                &[[rod_mass, 0.0, 0.0], [0.0, rod_mass, 0.0], [0.0, 0.0, rod_inertia]],
                &[
                    [1.0, 0.0, 0.4722222222222222 * l * sin_a],
                    [0.0, 1.0, -0.4722222222222222 * l * cos_a],
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
            q: &[f64; 3],
            v: &[f64; 3],
        ) -> ::lagrange::constraint::RedundantMotion<f64, 3, 2> {
            let Self { m, l, k, g, u, .. } = *self;
            let [x, y, a] = *q;
            let [_, _, a_dot] = *v;
            let rod_mass = 0.9 * m;
            let l_sq = l * l;
            let rod_inertia = 0.07959722222222222 * m * l_sq;
            let (sin_a, cos_a) = sin_cos(a);
            let l_sin_a = l * sin_a;
            let l_cos_a = l * cos_a;
            let spring_1_span_x = multiply_add(-0.5277777777777778, l_cos_a, 2.0 - x);
            let spring_1_span_y = multiply_add(-0.5277777777777778, l_sin_a, 1.0 - y);
            let spring_1_span_x_sq = spring_1_span_x * spring_1_span_x;
            let sqrt_0 = sqrt(
                multiply_add(spring_1_span_y, spring_1_span_y, spring_1_span_x_sq),
            );
            let pos_0 = k * (sqrt_0 - 0.5) / sqrt_0;
            let pos_1 = spring_1_span_x * pos_0;
            let forcing_0 = u + pos_1;
            let pos_2 = spring_1_span_y * pos_0;
            let forcing_1 = multiply_add(-rod_mass, g, pos_2);
            let const_0 = 0.4722222222222222 * l;
            let a_dot_sq = a_dot * a_dot;
            ::lagrange::constraint::redundant_motion(
                &[[rod_mass, 0.0, 0.0], [0.0, rod_mass, 0.0], [0.0, 0.0, rod_inertia]],
                &[
                    forcing_0,
                    forcing_1,
                    -0.5277777777777778 * multiply_add(-l_cos_a, pos_2, l_sin_a * pos_1),
                ],
                &[
                    [1.0, 0.0, 0.4722222222222222 * l_sin_a],
                    [0.0, 1.0, -0.4722222222222222 * l_cos_a],
                ],
                &[const_0 * cos_a * a_dot_sq, const_0 * sin_a * a_dot_sq],
            )
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for RodOnSlope {
        fn default() -> Self {
            Self {
                m: 2.0,
                l: 1.5,
                k: 30.0,
                g: 9.81,
                slope: 0.3,
                u: 0.0,
            }
        }
    }
    impl RodOnSlopeState {
        /// The coordinates in their order.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [f64; 3] {
            [self.x, self.y, self.a]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [f64; 3] {
            [self.x_dot, self.y_dot, self.a_dot]
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 6]> for RodOnSlopeState {
        #[inline]
        fn from([x, y, a, x_dot, y_dot, a_dot]: [f64; 6]) -> Self {
            Self {
                x,
                y,
                a,
                x_dot,
                y_dot,
                a_dot,
            }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<RodOnSlopeState> for [f64; 6] {
        #[inline]
        fn from(state: RodOnSlopeState) -> Self {
            [state.x, state.y, state.a, state.x_dot, state.y_dot, state.a_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> RodOnSlopeColumns<C> {
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
        /// Coordinate `a`.
        #[must_use]
        #[inline]
        pub fn a(&self) -> &[C::Scalar] {
            self.0.column(2)
        }
        /// Velocity of `x`.
        #[must_use]
        #[inline]
        pub fn x_dot(&self) -> &[C::Scalar] {
            self.0.column(3)
        }
        /// Velocity of `y`.
        #[must_use]
        #[inline]
        pub fn y_dot(&self) -> &[C::Scalar] {
            self.0.column(4)
        }
        /// Velocity of `a`.
        #[must_use]
        #[inline]
        pub fn a_dot(&self) -> &[C::Scalar] {
            self.0.column(5)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for RodOnSlopeColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for RodOnSlopeColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for RodOnSlope {
        type Scalar = f64;
        type State = [f64; 6];
        #[inline]
        fn rhs(&self, t: f64, state: &[f64; 6]) -> [f64; 6] {
            self.rhs(t, state)
        }
        fn undefined(
            &self,
            t: f64,
            state: &[f64; 6],
            rates: &[f64; 6],
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
            state: &mut [f64; 6],
        ) -> ::core::result::Result<(), ::lagrange::system::StepFailure<f64>> {
            ::lagrange::constraint::correct(self, t, state)?;
            ::core::result::Result::Ok(())
        }
        #[inline]
        fn admit(
            &self,
            t: f64,
            state: &mut [f64; 6],
        ) -> ::core::result::Result<(), ::lagrange::system::StepFailure<f64>> {
            ::lagrange::constraint::admit(self, t, state)?;
            ::core::result::Result::Ok(())
        }
        #[inline]
        fn restore(
            &self,
            t: f64,
            state: &mut [f64; 6],
        ) -> ::core::result::Result<(), ::lagrange::system::StepFailure<f64>> {
            ::lagrange::constraint::restore(self, t, state)?;
            ::core::result::Result::Ok(())
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::MechanicalSystem for RodOnSlope {
        type Coordinates = [f64; 3];
        type Velocities = [f64; 3];
        type Columns<C> = RodOnSlopeColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &["x", "y", "a"];
        const FINGERPRINT: ::core::primitive::u64 = 7325929191695969984;
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
                ("m", self.m),
                ("l", self.l),
                ("k", self.k),
                ("g", self.g),
                ("slope", self.slope),
            ]
                .get(index)
                .copied()
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for RodOnSlope {
        type NamedState = RodOnSlopeState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for RodOnSlope {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> f64 {
            self.energy(t, q, v)
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::LeapfrogSystem for RodOnSlope {
        const IS_HELD: ::core::primitive::bool = true;
        #[inline]
        fn position_correction(
            &self,
            t: f64,
            q: &[f64; 3],
            later: f64,
            to: &[f64; 3],
        ) -> [f64; 3] {
            let residuals = ::lagrange::constraint::ConstrainedSystem::position_residuals(
                self,
                later,
                to,
            );
            ::lagrange::constraint::ConstrainedSystem::correction(
                self,
                t,
                q,
                q,
                &residuals,
            )
        }
        #[inline]
        fn velocity_correction(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> [f64; 3] {
            let residuals = self.constraint_velocity(t, q, v);
            ::lagrange::constraint::ConstrainedSystem::correction(
                self,
                t,
                q,
                v,
                &residuals,
            )
        }
    }
    #[automatically_derived]
    impl ::lagrange::constraint::ConstrainedSystem for RodOnSlope {
        type Multipliers = [f64; 2];
        const CONSTRAINTS: &'static [&'static ::core::primitive::str] = &[
            "hinge_x",
            "hinge_y",
        ];
        #[inline]
        fn multipliers(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> [f64; 2] {
            self.multipliers(t, q, v)
        }
        #[inline]
        fn velocity_residuals(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> [f64; 2] {
            self.constraint_velocity(t, q, v)
        }
        #[inline]
        fn residual_scales(&self, t: f64, q: &[f64; 3], shares: &[f64; 3]) -> [f64; 2] {
            ::lagrange::constraint::weighed(&self.constraint_jacobian(t, q), shares)
        }
        #[inline]
        fn correction(
            &self,
            t: f64,
            q: &[f64; 3],
            v: &[f64; 3],
            residuals: &[f64; 2],
        ) -> [f64; 3] {
            let Self { m, l, .. } = *self;
            let [_, _, a] = *q;
            let [hinge_x, hinge_y] = *residuals;
            let (sin_a, cos_a) = sin_cos(a);
            let l_sin_a = l * sin_a;
            let l_sq = l * l;
            let inv_0 = 1.0 / (m * l_sq);
            let pos_0 = inv_0 * l_sin_a;
            let inv_m = 1.0 / m;
            let const_0 = 1.1111111111111112 * inv_m;
            let pivot_3 = -multiply_add(2.8015277535431085 * l_sin_a, pos_0, const_0);
            let inv_pivot_3 = 1.0 / pivot_3;
            let l_cos_a = l * cos_a;
            let pos_1 = l_cos_a * pos_0;
            let pos_2 = pos_1 * inv_pivot_3;
            let pos_3 = inv_0 * l_cos_a;
            let pos_4 = l_cos_a * pos_3 * 2.8015277535431085;
            let pivot_4 = multiply_add(-7.848557753872297 * pos_1, pos_2, -const_0)
                - pos_4;
            let inv_pivot_4 = 1.0 / pivot_4;
            let acc_0 = inv_pivot_4
                * multiply_add(-2.8015277535431085 * hinge_x, pos_2, hinge_y);
            let acc_1 = multiply_add(
                -hinge_x,
                inv_pivot_3,
                2.8015277535431085 * pos_2 * acc_0,
            );
            let values = [
                -1.1111111111111112 * inv_m * acc_1,
                const_0 * acc_0,
                -5.9326470075030535 * multiply_add(pos_3, acc_0, pos_0 * acc_1),
            ];
            if ::lagrange::constraint::are_regular(
                &values,
                abs(inv_pivot_4 * (const_0 + pos_4)),
            ) {
                values
            } else {
                self.redundant_correction(t, q, v, residuals)
            }
        }
        #[inline]
        fn position_residuals(&self, t: f64, q: &[f64; 3]) -> [f64; 2] {
            let Self { l, .. } = *self;
            let [x, y, a] = *q;
            let (sin_a, cos_a) = sin_cos(a);
            let const_0 = 0.4722222222222222 * l;
            [multiply_add(-const_0, cos_a, x), multiply_add(-const_0, sin_a, y) - 1.0]
        }
        #[inline]
        fn mass_times(
            &self,
            t: f64,
            q: &[f64; 3],
            v: &[f64; 3],
            accelerations: &[f64; 3],
        ) -> [f64; 3] {
            let Self { m, l, .. } = *self;
            let [x_ddot, y_ddot, a_ddot] = *accelerations;
            let const_0 = 0.9 * m;
            let l_sq = l * l;
            [const_0 * x_ddot, const_0 * y_ddot, 0.07959722222222222 * m * l_sq * a_ddot]
        }
    }
    #[automatically_derived]
    impl ::lagrange::scene::Scene for RodOnSlope {
        #[inline]
        fn items(
            &self,
            t: f64,
            q: &[f64; 3],
            v: &[f64; 3],
            visit: &mut dyn ::core::ops::FnMut(::lagrange::scene::Item<'_, f64>),
        ) {
            let Self { m, l, k, g, slope, u } = *self;
            let [x, y, a] = *q;
            let [x_dot, y_dot, a_dot] = *v;
            let [x_ddot, y_ddot, a_ddot] = self.acceleration(t, q, v);
            let [hinge_x, hinge_y] = self.multipliers(t, q, v);
            let rod_mass = 0.9 * m;
            let l_sq = l * l;
            let rod_inertia = 0.07959722222222222 * m * l_sq;
            let rod_centroid_x = -0.027777777777777776 * l;
            let (sin_a, cos_a) = sin_cos(a);
            let l_cos_a = l * cos_a;
            let pos_0 = 0.5277777777777778 * l_cos_a;
            let pos_1 = x + pos_0;
            let l_sin_a = l * sin_a;
            let pos_2 = 0.5277777777777778 * l_sin_a;
            let pos_3 = y + pos_2;
            let spring_1_span_x = 2.0 - x - pos_0;
            let spring_1_span_y = 1.0 - y - pos_2;
            let spring_1_span_x_sq = spring_1_span_x * spring_1_span_x;
            let sqrt_0 = sqrt(
                multiply_add(spring_1_span_y, spring_1_span_y, spring_1_span_x_sq),
            );
            let pos_4 = sqrt_0 - 0.5;
            let pos_5 = multiply_add(-0.4722222222222222, l_cos_a, x);
            let pos_6 = multiply_add(-0.4722222222222222, l_sin_a, y);
            let inv_sqrt_0 = 1.0 / sqrt_0;
            visit(::lagrange::scene::Item::Line {
                name: "ground",
                body: ::core::option::Option::None,
                through: [0.0, 0.0],
                angle: slope,
            });
            visit(::lagrange::scene::Item::Body {
                name: "rod",
                motion: ::lagrange::body::Motion {
                    mass: rod_mass,
                    inertia: rod_inertia,
                    centroid: [rod_centroid_x, 0.0],
                    center: [x, y],
                    angle: a,
                    velocity: [x_dot, y_dot],
                    angular_velocity: a_dot,
                    acceleration: [x_ddot, y_ddot],
                    angular_acceleration: a_ddot,
                },
                parts: &[
                    ::lagrange::scene::Part {
                        outline: ::lagrange::scene::Outline::Rectangle(l, 0.2 * l),
                        at: [0.0, 0.0],
                        angle: 0.0,
                        is_hole: false,
                    },
                    ::lagrange::scene::Part {
                        outline: ::lagrange::scene::Outline::Disk(0.05 * l),
                        at: [0.25 * l, 0.0],
                        angle: 0.0,
                        is_hole: true,
                    },
                ],
            });
            visit(::lagrange::scene::Item::Connector {
                name: "spring_1",
                kind: ::lagrange::scene::Connector::Spring,
                from: [pos_1, pos_3],
                to: [2.0, 1.0],
                tension: k * pos_4,
            });
            visit(::lagrange::scene::Item::Joint {
                name: "hinge",
                kind: ::lagrange::scene::Joint::Anchor,
                at: [pos_5, pos_6],
            });
            visit(::lagrange::scene::Item::Force {
                name: "gravity",
                cause: ::lagrange::scene::LoadOrigin::Gravity,
                body: ::core::option::Option::Some("rod"),
                at: [x, y],
                force: [0.0, -0.9 * m * g],
            });
            visit(::lagrange::scene::Item::Force {
                name: "hinge",
                cause: ::lagrange::scene::LoadOrigin::Joint,
                body: ::core::option::Option::Some("rod"),
                at: [pos_5, pos_6],
                force: [hinge_x, hinge_y],
            });
            visit(::lagrange::scene::Item::Force {
                name: "spring_1",
                cause: ::lagrange::scene::LoadOrigin::Connector,
                body: ::core::option::Option::Some("rod"),
                at: [pos_1, pos_3],
                force: [
                    k * spring_1_span_x * inv_sqrt_0 * pos_4,
                    k * spring_1_span_y * inv_sqrt_0 * pos_4,
                ],
            });
            visit(::lagrange::scene::Item::Force {
                name: "force",
                cause: ::lagrange::scene::LoadOrigin::Applied,
                body: ::core::option::Option::Some("rod"),
                at: [x, y],
                force: [u, 0.0],
            });
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 1]> for RodOnSlopeInputs {
        #[inline]
        fn from([u]: [f64; 1]) -> Self {
            Self { u }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<RodOnSlopeInputs> for [f64; 1] {
        #[inline]
        fn from(inputs: RodOnSlopeInputs) -> Self {
            [inputs.u]
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::ControlledSystem for RodOnSlope {
        type Inputs = RodOnSlopeInputs;
        type InputVector = [f64; 1];
        const INPUTS: &'static [&'static ::core::primitive::str] = &["u"];
        #[inline]
        fn inputs(&self) -> RodOnSlopeInputs {
            RodOnSlopeInputs { u: self.u }
        }
        #[inline]
        fn with_inputs(&self, inputs: RodOnSlopeInputs) -> Self {
            Self {
                u: inputs.u,
                m: self.m,
                l: self.l,
                k: self.k,
                g: self.g,
                slope: self.slope,
            }
        }
    }
};
