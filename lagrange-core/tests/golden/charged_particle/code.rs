/// A charge in a uniform magnetic field along z and an electric field along x.
///
///# Equations of motion
///
///```text
///m*ddot(x) = q*b*dot(y) + q*e
///m*ddot(y) = -q*b*dot(x)
///m*ddot(z) = 0
///```
///
///# State and structure
///
///- State: `[x, y, z, x_dot, y_dot, z_dot]`.
///- Mass matrix: diagonal, constant.
///- Cyclic coordinates: `z`.
///- Conserved: the momentum of `z`, the energy function.
///- One evaluation of `acceleration`: 1 addition, 6 multiplications, 1 division; the mass matrix is factorised, which costs no more than recursion.
pub struct ChargedParticle {
    ///Parameter `m`.
    pub m: ::core::primitive::f32,
    ///Parameter `q`.
    pub q: ::core::primitive::f32,
    ///Parameter `b`.
    pub b: ::core::primitive::f32,
    ///Parameter `e`.
    pub e: ::core::primitive::f32,
}
///State of [`ChargedParticle`]: coordinates, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ChargedParticleState {
    ///Coordinate `x`.
    pub x: ::core::primitive::f32,
    ///Coordinate `y`.
    pub y: ::core::primitive::f32,
    ///Coordinate `z`.
    pub z: ::core::primitive::f32,
    ///Velocity of `x`.
    pub x_dot: ::core::primitive::f32,
    ///Velocity of `y`.
    pub y_dot: ::core::primitive::f32,
    ///Velocity of `z`.
    pub z_dot: ::core::primitive::f32,
}
const _: () = {
    use ::core::primitive::f32;
    use ::lagrange::private::multiply_add;
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
    impl ChargedParticle {
        ///Accelerations in the order of the coordinates.
        #[must_use]
        #[inline]
        pub fn acceleration(
            &self,
            t: f32,
            q_2: &[f32; 3usize],
            v: &[f32; 3usize],
        ) -> [f32; 3usize] {
            let Self { m, q, b, e } = *self;
            let [x_dot, y_dot, _] = *v;
            let inv_m = 1.0 / m;
            let const_0 = q * b;
            let bias_1 = const_0 * x_dot;
            [inv_m * multiply_add(const_0, y_dot, q * e), -inv_m * bias_1, 0.0]
        }
        ///Mass matrix M, in rows.
        #[must_use]
        #[inline]
        pub fn mass_matrix(
            &self,
            t: f32,
            q_2: &[f32; 3usize],
        ) -> [[f32; 3usize]; 3usize] {
            let Self { m, .. } = *self;
            [[m, 0.0, 0.0], [0.0, m, 0.0], [0.0, 0.0, m]]
        }
        ///Right-hand side f of M q̈ = f.
        #[must_use]
        #[inline]
        pub fn forcing(
            &self,
            t: f32,
            q_2: &[f32; 3usize],
            v: &[f32; 3usize],
        ) -> [f32; 3usize] {
            let Self { q, b, e, .. } = *self;
            let [x_dot, y_dot, _] = *v;
            let const_0 = q * b;
            let bias_1 = const_0 * x_dot;
            [multiply_add(const_0, y_dot, q * e), -bias_1, 0.0]
        }
        ///Generalised momenta ∂L/∂v.
        #[must_use]
        #[inline]
        pub fn momenta(
            &self,
            t: f32,
            q_2: &[f32; 3usize],
            v: &[f32; 3usize],
        ) -> [f32; 3usize] {
            let Self { m, q, b, .. } = *self;
            let [x, y, _] = *q_2;
            let [x_dot, y_dot, z_dot] = *v;
            let const_0 = q * b * 0.5;
            [
                multiply_add(-const_0, y, m * x_dot),
                multiply_add(m, y_dot, const_0 * x),
                m * z_dot,
            ]
        }
        ///Energy function v·∂L/∂v − L.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f32, q_2: &[f32; 3usize], v: &[f32; 3usize]) -> f32 {
            let Self { m, q, b, e } = *self;
            let [x, y, _] = *q_2;
            let [x_dot, y_dot, z_dot] = *v;
            let const_0 = q * b;
            let const_1 = 0.5 * const_0;
            let vel_0 = m
                * multiply_add(z_dot, z_dot, multiply_add(y_dot, y_dot, x_dot * x_dot));
            let vel_1 = multiply_add(const_0, multiply_add(-y, x_dot, x * y_dot), vel_0);
            let vel_2 = multiply_add(
                -0.5,
                vel_1,
                y_dot * multiply_add(m, y_dot, const_1 * x),
            );
            let vel_3 = multiply_add(-m, x_dot, const_1 * y);
            let vel_4 = multiply_add(-x_dot, vel_3, multiply_add(-q * e, x, vel_2));
            multiply_add(m * z_dot, z_dot, vel_4)
        }
        ///Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        ///to produce the accelerations `a`.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f32,
            q_2: &[f32; 3usize],
            v: &[f32; 3usize],
            a: &[f32; 3usize],
        ) -> [f32; 3usize] {
            let Self { m, q, b, e } = *self;
            let [x_dot, y_dot, _] = *v;
            let [x_ddot, y_ddot, z_ddot] = *a;
            let const_0 = q * b;
            let bias_1 = const_0 * x_dot;
            [
                multiply_add(-const_0, y_dot, multiply_add(-q, e, m * x_ddot)),
                multiply_add(m, y_ddot, bias_1),
                m * z_ddot,
            ]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f32, y_2: &[f32; 6usize]) -> [f32; 6usize] {
            let [x, y, z, x_dot, y_dot, z_dot] = *y_2;
            let a = self.acceleration(t, &[x, y, z], &[x_dot, y_dot, z_dot]);
            [x_dot, y_dot, z_dot, a[0usize], a[1usize], a[2usize]]
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for ChargedParticle {
        fn default() -> Self {
            Self {
                m: 1.0,
                q: 0.7,
                b: 2.5,
                e: 0.3,
            }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f32; 6usize]> for ChargedParticleState {
        #[inline]
        fn from([x, y, z, x_dot, y_dot, z_dot]: [f32; 6usize]) -> Self {
            Self {
                x,
                y,
                z,
                x_dot,
                y_dot,
                z_dot,
            }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<ChargedParticleState> for [f32; 6usize] {
        #[inline]
        fn from(state: ChargedParticleState) -> Self {
            [state.x, state.y, state.z, state.x_dot, state.y_dot, state.z_dot]
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for ChargedParticle {
        type Scalar = f32;
        type State = [f32; 6usize];
        #[inline]
        fn rhs(&self, t: f32, y_2: &[f32; 6usize]) -> [f32; 6usize] {
            self.rhs(t, y_2)
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::MechanicalSystem for ChargedParticle {
        type Coordinates = [f32; 3usize];
        const COORDINATES: &'static [&'static ::core::primitive::str] = &["x", "y", "z"];
        #[inline]
        fn acceleration(
            &self,
            t: f32,
            q_2: &[f32; 3usize],
            v: &[f32; 3usize],
        ) -> [f32; 3usize] {
            self.acceleration(t, q_2, v)
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for ChargedParticle {
        #[inline]
        fn energy(&self, t: f32, q_2: &[f32; 3usize], v: &[f32; 3usize]) -> f32 {
            self.energy(t, q_2, v)
        }
    }
};
