/// A charge in a uniform magnetic field along z and an electric field along x.
///
/// # Equations of motion
///
/// ```text
/// m*ddot(x) = q*b*dot(y) + q*e
/// m*ddot(y) = -q*b*dot(x)
/// m*ddot(z) = 0
/// ```
///
/// # State and structure
///
/// - State: `[x, y, z, x_dot, y_dot, z_dot]`.
/// - Mass matrix: diagonal, constant.
/// - Cyclic coordinates: `z`.
/// - Conserved: the momentum of `z`, the energy function.
/// - Forward dynamics: each equation divided by its entry of the mass matrix.
/// - Cost of `acceleration`: 1 addition, 7 multiplications, 1 division.
pub struct ChargedParticle {
    /// Parameter `m`.
    pub m: ::core::primitive::f32,
    /// Parameter `q`.
    pub q: ::core::primitive::f32,
    /// Parameter `b`.
    pub b: ::core::primitive::f32,
    /// Parameter `e`.
    pub e: ::core::primitive::f32,
}
/// State of [`ChargedParticle`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ChargedParticleState {
    /// Coordinate `x`.
    pub x: ::core::primitive::f32,
    /// Coordinate `y`.
    pub y: ::core::primitive::f32,
    /// Coordinate `z`.
    pub z: ::core::primitive::f32,
    /// Velocity of `x`.
    pub x_dot: ::core::primitive::f32,
    /// Velocity of `y`.
    pub y_dot: ::core::primitive::f32,
    /// Velocity of `z`.
    pub z_dot: ::core::primitive::f32,
}
/// Columns of a table of states of [`ChargedParticle`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct ChargedParticleColumns<C>(C);
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f32;
    use ::lagrange::private::multiply_add;
    impl ChargedParticle {
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 1 addition, 7 multiplications, 1 division.
        #[must_use]
        #[inline]
        pub fn acceleration(
            &self,
            t: f32,
            positions: &[f32; 3],
            v: &[f32; 3],
        ) -> [f32; 3] {
            let Self { m, q, b, e } = *self;
            let [x_dot, y_dot, _] = *v;
            let forcing_0 = multiply_add(q * b, y_dot, q * e);
            let inv_m = 1.0 / m;
            let x_ddot = inv_m * forcing_0;
            let y_ddot = -inv_m * q * b * x_dot;
            [x_ddot, y_ddot, 0.0]
        }
        /// Mass matrix M, in rows.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f32, positions: &[f32; 3]) -> [[f32; 3]; 3] {
            let Self { m, .. } = *self;
            [[m, 0.0, 0.0], [0.0, m, 0.0], [0.0, 0.0, m]]
        }
        /// Right-hand side f of M q̈ = f.
        ///
        /// Takes 1 addition, 4 multiplications.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: f32, positions: &[f32; 3], v: &[f32; 3]) -> [f32; 3] {
            let Self { q, b, e, .. } = *self;
            let [x_dot, y_dot, _] = *v;
            let q_b = q * b;
            let forcing_0 = multiply_add(q_b, y_dot, q * e);
            let forcing_1 = -q_b * x_dot;
            [forcing_0, forcing_1, 0.0]
        }
        /// Generalised momenta ∂L/∂v.
        ///
        /// Takes 2 additions, 7 multiplications.
        #[must_use]
        #[inline]
        pub fn momenta(&self, t: f32, positions: &[f32; 3], v: &[f32; 3]) -> [f32; 3] {
            let Self { m, q, b, .. } = *self;
            let [x, y, _] = *positions;
            let [x_dot, y_dot, z_dot] = *v;
            let const_0 = q * b * 0.5;
            [
                multiply_add(-const_0, y, m * x_dot),
                multiply_add(m, y_dot, const_0 * x),
                m * z_dot,
            ]
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 3 additions, 7 multiplications.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f32, positions: &[f32; 3], v: &[f32; 3]) -> f32 {
            let Self { m, q, e, .. } = *self;
            let [x, _, _] = *positions;
            let [x_dot, y_dot, z_dot] = *v;
            let vel_0 = 0.5 * m
                * multiply_add(z_dot, z_dot, multiply_add(y_dot, y_dot, x_dot * x_dot));
            multiply_add(-q * e, x, vel_0)
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 3 additions, 7 multiplications.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f32,
            positions: &[f32; 3],
            v: &[f32; 3],
            a: &[f32; 3],
        ) -> [f32; 3] {
            let Self { m, q, b, e } = *self;
            let [x_dot, y_dot, _] = *v;
            let [x_ddot, y_ddot, z_ddot] = *a;
            let q_b = q * b;
            [
                multiply_add(-q_b, y_dot, multiply_add(-q, e, m * x_ddot)),
                multiply_add(m, y_ddot, q_b * x_dot),
                m * z_ddot,
            ]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f32, state: &[f32; 6]) -> [f32; 6] {
            let [x, y, z, x_dot, y_dot, z_dot] = *state;
            let a = self.acceleration(t, &[x, y, z], &[x_dot, y_dot, z_dot]);
            [x_dot, y_dot, z_dot, a[0], a[1], a[2]]
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
    impl ChargedParticleState {
        /// The coordinates in their order.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [f32; 3] {
            [self.x, self.y, self.z]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [f32; 3] {
            [self.x_dot, self.y_dot, self.z_dot]
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f32; 6]> for ChargedParticleState {
        #[inline]
        fn from([x, y, z, x_dot, y_dot, z_dot]: [f32; 6]) -> Self {
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
    impl ::core::convert::From<ChargedParticleState> for [f32; 6] {
        #[inline]
        fn from(state: ChargedParticleState) -> Self {
            [state.x, state.y, state.z, state.x_dot, state.y_dot, state.z_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> ChargedParticleColumns<C> {
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
        /// Velocity of `z`.
        #[must_use]
        #[inline]
        pub fn z_dot(&self) -> &[C::Scalar] {
            self.0.column(5)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for ChargedParticleColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for ChargedParticleColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for ChargedParticle {
        type Scalar = f32;
        type State = [f32; 6];
        #[inline]
        fn rhs(&self, t: f32, state: &[f32; 6]) -> [f32; 6] {
            self.rhs(t, state)
        }
        fn undefined(
            &self,
            t: f32,
            state: &[f32; 6],
            rates: &[f32; 6],
        ) -> ::core::option::Option<::lagrange::system::Undefined<f32>> {
            ::lagrange::integrate::undefined(
                self,
                (t, state, rates),
                &[],
                |positions, _| ::core::option::Option::Some(
                    self.mass_matrix(t, positions),
                ),
            )
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::MechanicalSystem for ChargedParticle {
        type Coordinates = [f32; 3];
        type Velocities = [f32; 3];
        type Columns<C> = ChargedParticleColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &["x", "y", "z"];
        const FINGERPRINT: ::core::primitive::u64 = 1070212168592270867;
        #[inline]
        fn acceleration(&self, t: f32, positions: &[f32; 3], v: &[f32; 3]) -> [f32; 3] {
            self.acceleration(t, positions, v)
        }
        #[inline]
        fn position_rates(&self, _: f32, _: &[f32; 3], v: &[f32; 3]) -> [f32; 3] {
            *v
        }
        fn parameter(
            &self,
            index: ::core::primitive::usize,
        ) -> ::core::option::Option<(&'static ::core::primitive::str, f32)> {
            [("m", self.m), ("q", self.q), ("b", self.b), ("e", self.e)]
                .get(index)
                .copied()
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for ChargedParticle {
        type NamedState = ChargedParticleState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for ChargedParticle {
        #[inline]
        fn energy(&self, t: f32, positions: &[f32; 3], v: &[f32; 3]) -> f32 {
            self.energy(t, positions, v)
        }
    }
};
