/// A planet in polar coordinates about the sun.
///
/// # Equations of motion
///
/// ```text
/// m*ddot(r) = m*r*dot(phi)^2 - m*mu/r^2
/// m*r^2*ddot(phi) = -2*m*r*dot(r)*dot(phi)
/// ```
///
/// # State and structure
///
/// - State: `[r, phi, r_dot, phi_dot]`.
/// - Mass matrix: diagonal, depends on the configuration.
/// - Cyclic coordinates: `phi`.
/// - Conserved: the momentum of `phi`, the energy function.
/// - Forward dynamics: each equation divided by its entry of the mass matrix.
/// - Cost of `acceleration`: 1 addition, 7 multiplications, 1 division.
pub struct Kepler<S> {
    /// Parameter `m`.
    pub m: S,
    /// Parameter `mu`.
    pub mu: S,
}
/// State of [`Kepler`]: positions, then velocities.
#[allow(clippy::derive_partial_eq_without_eq, reason = "a number type need not be `Eq`")]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct KeplerState<S> {
    /// Coordinate `r`.
    pub r: S,
    /// Coordinate `phi`.
    pub phi: S,
    /// Velocity of `r`.
    pub r_dot: S,
    /// Velocity of `phi`.
    pub phi_dot: S,
}
/// Columns of a table of states of [`Kepler`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct KeplerColumns<C>(C);
::lagrange::private::bring_hints! {}
::lagrange::private::bring_hints! {
    default
}
const _: () = {
    use ::lagrange::private::multiply_add;
    impl<S: ::lagrange::Scalar> Kepler<S> {
        /// Parameters, then inputs: the columns of `parameter_jacobian`.
        pub const PARAMETERS: [&'static ::core::primitive::str; 2] = ["m", "mu"];
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 1 addition, 7 multiplications, 1 division.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: S, q: &[S; 2], v: &[S; 2]) -> [S; 2] {
            let Self { mu, .. } = *self;
            let [r, _] = *q;
            let [r_dot, phi_dot] = *v;
            let phi_dot_sq = phi_dot * phi_dot;
            let inv_r = S::ONE / r;
            let inv_r_sq = inv_r * inv_r;
            let r_ddot = multiply_add(-mu, inv_r_sq, r * phi_dot_sq);
            let phi_ddot = S::from_f64(-2.0) * inv_r * r_dot * phi_dot;
            [r_ddot, phi_ddot]
        }
        /// Mass matrix M, in rows.
        ///
        /// Takes 2 multiplications.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: S, q: &[S; 2]) -> [[S; 2]; 2] {
            let Self { m, .. } = *self;
            let [r, _] = *q;
            let const_0 = S::ZERO;
            let r_sq = r * r;
            let m_1_1 = m * r_sq;
            [[m, const_0], [const_0, m_1_1]]
        }
        /// Right-hand side f of M q̈ = f.
        ///
        /// Takes 1 addition, 8 multiplications, 1 division.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: S, q: &[S; 2], v: &[S; 2]) -> [S; 2] {
            let Self { m, mu } = *self;
            let [r, _] = *q;
            let [r_dot, phi_dot] = *v;
            let r_sq = r * r;
            let m_r = m * r;
            let phi_dot_sq = phi_dot * phi_dot;
            let forcing_0 = multiply_add(m_r, phi_dot_sq, -m * mu / r_sq);
            let forcing_1 = S::from_f64(-2.0) * m_r * phi_dot * r_dot;
            [forcing_0, forcing_1]
        }
        /// Generalised momenta ∂L/∂v.
        ///
        /// Takes 4 multiplications.
        #[must_use]
        #[inline]
        pub fn momenta(&self, t: S, q: &[S; 2], v: &[S; 2]) -> [S; 2] {
            let Self { m, .. } = *self;
            let [r, _] = *q;
            let [r_dot, phi_dot] = *v;
            let r_sq = r * r;
            [m * r_dot, m * r_sq * phi_dot]
        }
        /// Rates ∂L/∂q + Q of the momenta.
        ///
        /// Takes 1 addition, 5 multiplications, 1 division.
        #[must_use]
        #[inline]
        pub fn momentum_rates(&self, t: S, q: &[S; 2], v: &[S; 2]) -> [S; 2] {
            let Self { m, mu } = *self;
            let [r, _] = *q;
            let [_, phi_dot] = *v;
            let r_sq = r * r;
            let phi_dot_sq = phi_dot * phi_dot;
            [multiply_add(m * r, phi_dot_sq, -m * mu / r_sq), S::ZERO]
        }
        /// Kinetic energy T.
        ///
        /// Takes 1 addition, 6 multiplications.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: S, q: &[S; 2], v: &[S; 2]) -> S {
            let Self { m, .. } = *self;
            let [r, _] = *q;
            let [r_dot, phi_dot] = *v;
            let r_sq = r * r;
            let phi_dot_sq = phi_dot * phi_dot;
            S::from_f64(0.5) * m * multiply_add(r_sq, phi_dot_sq, r_dot * r_dot)
        }
        /// Potential energy V.
        ///
        /// Takes 1 multiplication, 1 division.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: S, q: &[S; 2]) -> S {
            let Self { m, mu } = *self;
            let [r, _] = *q;
            -m * mu / r
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 2 additions, 7 multiplications, 1 division.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: S, q: &[S; 2], v: &[S; 2]) -> S {
            let Self { m, mu } = *self;
            let [r, _] = *q;
            let [r_dot, phi_dot] = *v;
            let r_sq = r * r;
            let phi_dot_sq = phi_dot * phi_dot;
            let vel_0 = multiply_add(r_sq, phi_dot_sq, r_dot * r_dot);
            multiply_add(S::from_f64(0.5) * m, vel_0, -m * mu / r)
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 3 additions, 11 multiplications, 1 division.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: S,
            q: &[S; 2],
            v: &[S; 2],
            a: &[S; 2],
        ) -> [S; 2] {
            let Self { m, mu } = *self;
            let [r, _] = *q;
            let [r_dot, phi_dot] = *v;
            let [r_ddot, phi_ddot] = *a;
            let r_sq = r * r;
            let m_r = m * r;
            let phi_dot_sq = phi_dot * phi_dot;
            let m_1_1 = m * r_sq;
            [
                multiply_add(m, r_ddot, multiply_add(-m_r, phi_dot_sq, m * mu / r_sq)),
                multiply_add(m_1_1, phi_ddot, S::from_f64(2.0) * m_r * phi_dot * r_dot),
            ]
        }
        /// Jacobian of `rhs`, in rows: entry `[i][j]` is the derivative of its entry `i` by entry `j`
        /// of the state.
        ///
        /// Takes 1 addition, 13 multiplications, 1 division.
        #[must_use]
        #[inline]
        pub fn jacobian(&self, t: S, y: &[S; 4]) -> [[S; 4]; 4] {
            let Self { mu, .. } = *self;
            let [r, _, r_dot, phi_dot] = *y;
            let const_0 = S::ZERO;
            let const_1 = S::ONE;
            let inv_r = const_1 / r;
            let inv_r_sq = inv_r * inv_r;
            let two = S::from_f64(2.0);
            let pos_0 = S::from_f64(-2.0) * inv_r;
            [
                [const_0, const_0, const_1, const_0],
                [const_0, const_0, const_0, const_1],
                [
                    multiply_add(two * mu, inv_r_sq * inv_r, phi_dot * phi_dot),
                    const_0,
                    const_0,
                    two * r * phi_dot,
                ],
                [
                    two * inv_r_sq * r_dot * phi_dot,
                    const_0,
                    pos_0 * phi_dot,
                    pos_0 * r_dot,
                ],
            ]
        }
        /// Derivatives of `rhs` by the fields in the order of `PARAMETERS`, in rows: entry `[i][j]`
        /// is that of its entry `i` by field `j`.
        ///
        /// Takes 1 multiplication, 1 division.
        #[must_use]
        #[inline]
        pub fn parameter_jacobian(&self, t: S, y: &[S; 4]) -> [[S; 2]; 4] {
            let [r, _, _, _] = *y;
            let const_0 = S::ZERO;
            let r_sq = r * r;
            [
                [const_0, const_0],
                [const_0, const_0],
                [const_0, -S::ONE / r_sq],
                [const_0, const_0],
            ]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: S, y: &[S; 4]) -> [S; 4] {
            let [r, phi, r_dot, phi_dot] = *y;
            let a = self.acceleration(t, &[r, phi], &[r_dot, phi_dot]);
            [r_dot, phi_dot, a[0], a[1]]
        }
    }
    impl<S> KeplerState<S> {
        /// The coordinates in their order.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [S; 2] {
            [self.r, self.phi]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [S; 2] {
            [self.r_dot, self.phi_dot]
        }
    }
    #[automatically_derived]
    impl<S> ::core::convert::From<[S; 4]> for KeplerState<S> {
        #[inline]
        fn from([r, phi, r_dot, phi_dot]: [S; 4]) -> Self {
            Self { r, phi, r_dot, phi_dot }
        }
    }
    #[automatically_derived]
    impl<S> ::core::convert::From<KeplerState<S>> for [S; 4] {
        #[inline]
        fn from(state: KeplerState<S>) -> Self {
            [state.r, state.phi, state.r_dot, state.phi_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> KeplerColumns<C> {
        /// Coordinate `r`.
        #[must_use]
        #[inline]
        pub fn r(&self) -> &[C::Scalar] {
            self.0.column(0)
        }
        /// Coordinate `phi`.
        #[must_use]
        #[inline]
        pub fn phi(&self) -> &[C::Scalar] {
            self.0.column(1)
        }
        /// Velocity of `r`.
        #[must_use]
        #[inline]
        pub fn r_dot(&self) -> &[C::Scalar] {
            self.0.column(2)
        }
        /// Velocity of `phi`.
        #[must_use]
        #[inline]
        pub fn phi_dot(&self) -> &[C::Scalar] {
            self.0.column(3)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for KeplerColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for KeplerColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::OdeSystem for Kepler<S> {
        type Scalar = S;
        type State = [S; 4];
        #[inline]
        fn rhs(&self, t: S, y: &[S; 4]) -> [S; 4] {
            self.rhs(t, y)
        }
        fn undefined(
            &self,
            t: S,
            y: &[S; 4],
            rates: &[S; 4],
        ) -> ::core::option::Option<::lagrange::system::Undefined<S>> {
            ::lagrange::integrate::undefined(
                self,
                (t, y, rates),
                &[],
                |q, _| ::core::option::Option::Some(self.mass_matrix(t, q)),
            )
        }
        #[inline]
        fn jacobian(&self, t: S, y: &[S; 4]) -> ::core::option::Option<[[S; 4]; 4]> {
            ::core::option::Option::Some(self.jacobian(t, y))
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::MechanicalSystem for Kepler<S> {
        type Coordinates = [S; 2];
        type Velocities = [S; 2];
        type Columns<C> = KeplerColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &["r", "phi"];
        const FINGERPRINT: ::core::primitive::u64 = 1097449540437580892;
        #[inline]
        fn acceleration(&self, t: S, q: &[S; 2], v: &[S; 2]) -> [S; 2] {
            self.acceleration(t, q, v)
        }
        #[inline]
        fn position_rates(&self, _: S, _: &[S; 2], v: &[S; 2]) -> [S; 2] {
            *v
        }
        fn parameter(
            &self,
            index: ::core::primitive::usize,
        ) -> ::core::option::Option<(&'static ::core::primitive::str, S)> {
            [("m", self.m), ("mu", self.mu)].get(index).copied()
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::NamedSystem for Kepler<S> {
        type NamedState = KeplerState<S>;
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::EnergyFunction for Kepler<S> {
        #[inline]
        fn energy(&self, t: S, q: &[S; 2], v: &[S; 2]) -> S {
            self.energy(t, q, v)
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::CanonicalSystem for Kepler<S> {
        #[inline]
        fn momenta(&self, t: S, q: &[S; 2], v: &[S; 2]) -> [S; 2] {
            self.momenta(t, q, v)
        }
        #[inline]
        fn momentum_rates(&self, t: S, q: &[S; 2], v: &[S; 2]) -> [S; 2] {
            self.momentum_rates(t, q, v)
        }
        #[inline]
        fn mass_matrix(&self, t: S, q: &[S; 2], v: &[S; 2]) -> [[S; 2]; 2] {
            self.mass_matrix(t, q)
        }
    }
};
