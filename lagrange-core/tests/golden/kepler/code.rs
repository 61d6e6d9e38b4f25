/// A planet in polar coordinates about the sun.
///
///# Equations of motion
///
///```text
///m*ddot(r) = m*r*dot(phi)^2 - m*mu/r^2
///m*r^2*ddot(phi) = -2*m*r*dot(r)*dot(phi)
///```
///
///# State and structure
///
///- State: `[r, phi, r_dot, phi_dot]`.
///- Mass matrix: diagonal, depends on the configuration.
///- Cyclic coordinates: `phi`.
///- Conserved: the momentum of `phi`, the energy function.
///- One evaluation of `acceleration`: 1 addition, 9 multiplications, 3 divisions; the mass matrix is factorised, which costs no more than recursion.
pub struct Kepler<S> {
    ///Parameter `m`.
    pub m: S,
    ///Parameter `mu`.
    pub mu: S,
}
///State of [`Kepler`]: coordinates, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct KeplerState<S> {
    ///Coordinate `r`.
    pub r: S,
    ///Coordinate `phi`.
    pub phi: S,
    ///Velocity of `r`.
    pub r_dot: S,
    ///Velocity of `phi`.
    pub phi_dot: S,
}
const _: () = {
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
    impl<S: ::lagrange::Scalar> Kepler<S> {
        ///Accelerations in the order of the coordinates.
        #[must_use]
        #[inline]
        pub fn acceleration(
            &self,
            t: S,
            q: &[S; 2usize],
            v: &[S; 2usize],
        ) -> [S; 2usize] {
            let Self { m, mu } = *self;
            let [r, _] = *q;
            let [r_dot, phi_dot] = *v;
            let pos_0 = m * r;
            let r_sq = r * r;
            let phi_dot_sq = phi_dot * phi_dot;
            let bias_0 = multiply_add(-pos_0, phi_dot_sq, m * mu / r_sq);
            let m_1_1 = m * r_sq;
            [
                -bias_0 / m,
                <S as ::lagrange::Scalar>::from_f64(-2.0) * pos_0 * phi_dot * r_dot
                    / m_1_1,
            ]
        }
        ///Mass matrix M, in rows.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: S, q: &[S; 2usize]) -> [[S; 2usize]; 2usize] {
            let Self { m, .. } = *self;
            let [r, _] = *q;
            let m_0_1 = <S as ::lagrange::Scalar>::ZERO;
            let r_sq = r * r;
            let m_1_1 = m * r_sq;
            [[m, m_0_1], [m_0_1, m_1_1]]
        }
        ///Right-hand side f of M q̈ = f.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: S, q: &[S; 2usize], v: &[S; 2usize]) -> [S; 2usize] {
            let Self { m, mu } = *self;
            let [r, _] = *q;
            let [r_dot, phi_dot] = *v;
            let pos_0 = m * r;
            let r_sq = r * r;
            let phi_dot_sq = phi_dot * phi_dot;
            let bias_0 = multiply_add(-pos_0, phi_dot_sq, m * mu / r_sq);
            [
                -bias_0,
                <S as ::lagrange::Scalar>::from_f64(-2.0) * pos_0 * phi_dot * r_dot,
            ]
        }
        ///Generalised momenta ∂L/∂v.
        #[must_use]
        #[inline]
        pub fn momenta(&self, t: S, q: &[S; 2usize], v: &[S; 2usize]) -> [S; 2usize] {
            let Self { m, .. } = *self;
            let [r, _] = *q;
            let [r_dot, phi_dot] = *v;
            let r_sq = r * r;
            [m * r_dot, m * r_sq * phi_dot]
        }
        ///Kinetic energy T.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: S, q: &[S; 2usize], v: &[S; 2usize]) -> S {
            let Self { m, .. } = *self;
            let [r, _] = *q;
            let [r_dot, phi_dot] = *v;
            let r_sq = r * r;
            let phi_dot_sq = phi_dot * phi_dot;
            let vel_0 = multiply_add(r_sq, phi_dot_sq, r_dot * r_dot);
            <S as ::lagrange::Scalar>::from_f64(0.5) * m * vel_0
        }
        ///Potential energy V.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: S, q: &[S; 2usize]) -> S {
            let Self { m, mu } = *self;
            let [r, _] = *q;
            -m * mu / r
        }
        ///Energy function v·∂L/∂v − L.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: S, q: &[S; 2usize], v: &[S; 2usize]) -> S {
            let Self { m, mu } = *self;
            let [r, _] = *q;
            let [r_dot, phi_dot] = *v;
            let r_sq = r * r;
            let phi_dot_sq = phi_dot * phi_dot;
            let vel_0 = multiply_add(r_sq, phi_dot_sq, r_dot * r_dot);
            multiply_add(
                <S as ::lagrange::Scalar>::from_f64(0.5) * m,
                vel_0,
                -m * mu / r,
            )
        }
        ///Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        ///to produce the accelerations `a`.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: S,
            q: &[S; 2usize],
            v: &[S; 2usize],
            a: &[S; 2usize],
        ) -> [S; 2usize] {
            let Self { m, mu } = *self;
            let [r, _] = *q;
            let [r_dot, phi_dot] = *v;
            let [r_ddot, phi_ddot] = *a;
            let pos_0 = m * r;
            let r_sq = r * r;
            let phi_dot_sq = phi_dot * phi_dot;
            let m_1_1 = m * r_sq;
            let vel_0 = <S as ::lagrange::Scalar>::from_f64(2.0) * pos_0 * phi_dot
                * r_dot;
            [
                multiply_add(m, r_ddot, multiply_add(-pos_0, phi_dot_sq, m * mu / r_sq)),
                multiply_add(m_1_1, phi_ddot, vel_0),
            ]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: S, y: &[S; 4usize]) -> [S; 4usize] {
            let [r, phi, r_dot, phi_dot] = *y;
            let a = self.acceleration(t, &[r, phi], &[r_dot, phi_dot]);
            [r_dot, phi_dot, a[0usize], a[1usize]]
        }
    }
    #[automatically_derived]
    impl<S> ::core::convert::From<[S; 4usize]> for KeplerState<S> {
        #[inline]
        fn from([r, phi, r_dot, phi_dot]: [S; 4usize]) -> Self {
            Self { r, phi, r_dot, phi_dot }
        }
    }
    #[automatically_derived]
    impl<S> ::core::convert::From<KeplerState<S>> for [S; 4usize] {
        #[inline]
        fn from(state: KeplerState<S>) -> Self {
            [state.r, state.phi, state.r_dot, state.phi_dot]
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::OdeSystem for Kepler<S> {
        type Scalar = S;
        type State = [S; 4usize];
        #[inline]
        fn rhs(&self, t: S, y: &[S; 4usize]) -> [S; 4usize] {
            self.rhs(t, y)
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::MechanicalSystem for Kepler<S> {
        type Coordinates = [S; 2usize];
        const COORDINATES: &'static [&'static ::core::primitive::str] = &["r", "phi"];
        #[inline]
        fn acceleration(&self, t: S, q: &[S; 2usize], v: &[S; 2usize]) -> [S; 2usize] {
            self.acceleration(t, q, v)
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::EnergyFunction for Kepler<S> {
        #[inline]
        fn energy(&self, t: S, q: &[S; 2usize], v: &[S; 2usize]) -> S {
            self.energy(t, q, v)
        }
    }
};
