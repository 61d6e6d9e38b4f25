/// A bead on a road whose height is a function of the crate.
///
/// # Equations of motion
///
/// ```text
/// (m + m*road'(x)^2)*ddot(x) = -m*road'(x)*road''(x)*dot(x)^2 - m*g*road'(x)
/// ```
///
/// # State and structure
///
/// - State: `[x, x_dot]`.
/// - Mass matrix: diagonal, depends on the configuration.
/// - Conserved: the energy function.
/// - Forward dynamics: each equation divided by its entry of the mass matrix.
/// - Cost of `acceleration`: 2 additions, 8 multiplications, 1 division, 2 functions.
#[derive(Clone, Debug)]
pub struct BeadOnRoad {
    /// Parameter `m`.
    pub m: ::core::primitive::f64,
    /// Parameter `g`.
    pub g: ::core::primitive::f64,
}
/// State of [`BeadOnRoad`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct BeadOnRoadState {
    /// Coordinate `x`.
    pub x: ::core::primitive::f64,
    /// Velocity of `x`.
    pub x_dot: ::core::primitive::f64,
}
/// Columns of a table of states of [`BeadOnRoad`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct BeadOnRoadColumns<C>(C);
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::multiply_add;
    impl BeadOnRoad {
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 2 additions, 8 multiplications, 1 division, 2 functions.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let Self { m, g } = *self;
            let [x] = *q;
            let [x_dot] = *v;
            let road_derivative_x = road_derivative(x);
            let x_dot_sq = x_dot * x_dot;
            let pos_0 = m * road_derivative_x * road_second_derivative(x);
            let forcing_0 = -multiply_add(pos_0, x_dot_sq, m * g * road_derivative_x);
            let road_derivative_x_sq = road_derivative_x * road_derivative_x;
            let m_0_0 = multiply_add(m, road_derivative_x_sq, m);
            let x_ddot = forcing_0 / m_0_0;
            [x_ddot]
        }
        /// Mass matrix M, in rows.
        ///
        /// Takes 1 addition, 2 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f64, q: &[f64; 1]) -> [[f64; 1]; 1] {
            let Self { m, .. } = *self;
            let [x] = *q;
            let road_derivative_x = road_derivative(x);
            let road_derivative_x_sq = road_derivative_x * road_derivative_x;
            let m_0_0 = multiply_add(m, road_derivative_x_sq, m);
            [[m_0_0]]
        }
        /// Right-hand side f of M q̈ = f.
        ///
        /// Takes 1 addition, 6 multiplications, 2 functions.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let Self { m, g } = *self;
            let [x] = *q;
            let [x_dot] = *v;
            let road_derivative_x = road_derivative(x);
            let x_dot_sq = x_dot * x_dot;
            let pos_0 = m * road_derivative_x * road_second_derivative(x);
            let forcing_0 = -multiply_add(pos_0, x_dot_sq, m * g * road_derivative_x);
            [forcing_0]
        }
        /// Generalised momenta ∂L/∂v.
        ///
        /// Takes 1 addition, 4 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn momenta(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let Self { m, .. } = *self;
            let [x] = *q;
            let [x_dot] = *v;
            let road_derivative_x = road_derivative(x);
            [multiply_add(m, x_dot, m * road_derivative_x * road_derivative_x * x_dot)]
        }
        /// Kinetic energy T.
        ///
        /// Takes 1 addition, 5 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            let Self { m, .. } = *self;
            let [x] = *q;
            let [x_dot] = *v;
            let vel_0 = road_derivative(x) * x_dot;
            0.5 * m * multiply_add(vel_0, vel_0, x_dot * x_dot)
        }
        /// Potential energy V.
        ///
        /// Takes 2 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, q: &[f64; 1]) -> f64 {
            let Self { m, g } = *self;
            let [x] = *q;
            m * g * road(x)
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 2 additions, 7 multiplications, 2 functions.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            let Self { m, g } = *self;
            let [x] = *q;
            let [x_dot] = *v;
            let vel_0 = road_derivative(x) * x_dot;
            let vel_1 = 0.5 * m * multiply_add(vel_0, vel_0, x_dot * x_dot);
            multiply_add(m * g, road(x), vel_1)
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 3 additions, 7 multiplications, 2 functions.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            q: &[f64; 1],
            v: &[f64; 1],
            a: &[f64; 1],
        ) -> [f64; 1] {
            let Self { m, g } = *self;
            let [x] = *q;
            let [x_dot] = *v;
            let [x_ddot] = *a;
            let road_derivative_x = road_derivative(x);
            let vel_0 = road_second_derivative(x) * x_dot * x_dot;
            let acc_0 = multiply_add(
                m,
                multiply_add(road_derivative_x, x_ddot, vel_0),
                m * g,
            );
            [multiply_add(road_derivative_x, acc_0, m * x_ddot)]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, y: &[f64; 2]) -> [f64; 2] {
            let [x, x_dot] = *y;
            let a = self.acceleration(t, &[x], &[x_dot]);
            [x_dot, a[0]]
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for BeadOnRoad {
        fn default() -> Self {
            Self { m: 2.0, g: 9.81 }
        }
    }
    impl BeadOnRoadState {
        /// The coordinates in their order.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [f64; 1] {
            [self.x]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [f64; 1] {
            [self.x_dot]
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 2]> for BeadOnRoadState {
        #[inline]
        fn from([x, x_dot]: [f64; 2]) -> Self {
            Self { x, x_dot }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<BeadOnRoadState> for [f64; 2] {
        #[inline]
        fn from(state: BeadOnRoadState) -> Self {
            [state.x, state.x_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> BeadOnRoadColumns<C> {
        /// Coordinate `x`.
        #[must_use]
        #[inline]
        pub fn x(&self) -> &[C::Scalar] {
            self.0.column(0)
        }
        /// Velocity of `x`.
        #[must_use]
        #[inline]
        pub fn x_dot(&self) -> &[C::Scalar] {
            self.0.column(1)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for BeadOnRoadColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for BeadOnRoadColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for BeadOnRoad {
        type Scalar = f64;
        type State = [f64; 2];
        #[inline]
        fn rhs(&self, t: f64, y: &[f64; 2]) -> [f64; 2] {
            self.rhs(t, y)
        }
        fn undefined(
            &self,
            t: f64,
            y: &[f64; 2],
            rates: &[f64; 2],
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
    impl ::lagrange::system::MechanicalSystem for BeadOnRoad {
        type Coordinates = [f64; 1];
        type Velocities = [f64; 1];
        type Columns<C> = BeadOnRoadColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &["x"];
        const FINGERPRINT: ::core::primitive::u64 = 2079058540020161516;
        #[inline]
        fn acceleration(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            self.acceleration(t, q, v)
        }
        #[inline]
        fn position_rates(&self, _: f64, _: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            *v
        }
        fn parameter(
            &self,
            index: ::core::primitive::usize,
        ) -> ::core::option::Option<(&'static ::core::primitive::str, f64)> {
            [("m", self.m), ("g", self.g)].get(index).copied()
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for BeadOnRoad {
        type NamedState = BeadOnRoadState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for BeadOnRoad {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            self.energy(t, q, v)
        }
    }
};
