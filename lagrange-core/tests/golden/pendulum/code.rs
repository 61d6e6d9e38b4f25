/// A point mass on a massless rod.
///
/// # Equations of motion
///
/// ```text
/// m*l^2*ddot(theta) = -m*l*g*sin(theta)
/// ```
///
/// # State and structure
///
/// - State: `[theta, theta_dot]`.
/// - Mass matrix: diagonal, constant.
/// - Conserved: the energy function.
/// - Separable: explicit symplectic methods take it.
/// - Forward dynamics: each equation divided by its entry of the mass matrix.
/// - Cost of `acceleration`: 1 multiplication, 1 division, 1 function.
pub struct Pendulum {
    /// Parameter `m`.
    pub m: ::core::primitive::f64,
    /// Parameter `l`.
    pub l: ::core::primitive::f64,
    /// Parameter `g`.
    pub g: ::core::primitive::f64,
}
/// State of [`Pendulum`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct PendulumState {
    /// Coordinate `theta`.
    pub theta: ::core::primitive::f64,
    /// Velocity of `theta`.
    pub theta_dot: ::core::primitive::f64,
}
/// Columns of a table of states of [`Pendulum`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct PendulumColumns<C>(C);
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::{cos, multiply_add, sin};
    impl Pendulum {
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 1 multiplication, 1 division, 1 function.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let Self { l, g, .. } = *self;
            let [theta] = *q;
            let theta_ddot = -g / l * sin(theta);
            [theta_ddot]
        }
        /// Mass matrix M, in rows.
        ///
        /// Takes 2 multiplications.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f64, q: &[f64; 1]) -> [[f64; 1]; 1] {
            let Self { m, l, .. } = *self;
            let m_0_0 = l * m * l;
            [[m_0_0]]
        }
        /// Right-hand side f of M q̈ = f.
        ///
        /// Takes 3 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let Self { m, l, g } = *self;
            let [theta] = *q;
            let forcing_0 = -m * l * g * sin(theta);
            [forcing_0]
        }
        /// Generalised momenta ∂L/∂v.
        ///
        /// Takes 3 multiplications.
        #[must_use]
        #[inline]
        pub fn momenta(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let Self { m, l, .. } = *self;
            let [theta_dot] = *v;
            [l * m * l * theta_dot]
        }
        /// Kinetic energy T.
        ///
        /// Takes 4 multiplications.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            let Self { m, l, .. } = *self;
            let [theta_dot] = *v;
            let l_theta_dot = l * theta_dot;
            let l_theta_dot_sq = l_theta_dot * l_theta_dot;
            0.5 * m * l_theta_dot_sq
        }
        /// Potential energy V.
        ///
        /// Takes 3 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, q: &[f64; 1]) -> f64 {
            let Self { m, l, g } = *self;
            let [theta] = *q;
            -m * l * g * cos(theta)
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 1 addition, 7 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            let Self { m, l, g } = *self;
            let [theta] = *q;
            let [theta_dot] = *v;
            let l_theta_dot = l * theta_dot;
            let l_theta_dot_sq = l_theta_dot * l_theta_dot;
            multiply_add(-m * l * g, cos(theta), 0.5 * m * l_theta_dot_sq)
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 1 addition, 5 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            q: &[f64; 1],
            v: &[f64; 1],
            a: &[f64; 1],
        ) -> [f64; 1] {
            let Self { m, l, g } = *self;
            let [theta] = *q;
            let [theta_ddot] = *a;
            let m_l = m * l;
            [multiply_add(m_l * l, theta_ddot, m_l * g * sin(theta))]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, y: &[f64; 2]) -> [f64; 2] {
            let [theta, theta_dot] = *y;
            let a = self.acceleration(t, &[theta], &[theta_dot]);
            [theta_dot, a[0]]
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for Pendulum {
        fn default() -> Self {
            Self { m: 1.0, l: 1.0, g: 9.81 }
        }
    }
    impl PendulumState {
        /// The coordinates in their order.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [f64; 1] {
            [self.theta]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [f64; 1] {
            [self.theta_dot]
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 2]> for PendulumState {
        #[inline]
        fn from([theta, theta_dot]: [f64; 2]) -> Self {
            Self { theta, theta_dot }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<PendulumState> for [f64; 2] {
        #[inline]
        fn from(state: PendulumState) -> Self {
            [state.theta, state.theta_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> PendulumColumns<C> {
        /// Coordinate `theta`.
        #[must_use]
        #[inline]
        pub fn theta(&self) -> &[C::Scalar] {
            self.0.column(0)
        }
        /// Velocity of `theta`.
        #[must_use]
        #[inline]
        pub fn theta_dot(&self) -> &[C::Scalar] {
            self.0.column(1)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for PendulumColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for PendulumColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for Pendulum {
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
    impl ::lagrange::system::MechanicalSystem for Pendulum {
        type Coordinates = [f64; 1];
        type Velocities = [f64; 1];
        type Columns<C> = PendulumColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &["theta"];
        const FINGERPRINT: ::core::primitive::u64 = 6337903344932996905;
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
            [("m", self.m), ("l", self.l), ("g", self.g)].get(index).copied()
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for Pendulum {
        type NamedState = PendulumState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for Pendulum {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            self.energy(t, q, v)
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::SeparableSystem for Pendulum {}
};
