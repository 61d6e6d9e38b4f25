/// A symmetric top with a fixed point, in Euler angles.
///
/// # Equations of motion
///
/// ```text
/// (i1*sin(theta)^2 + i3*cos(theta)^2)*ddot(phi) + i3*cos(theta)*ddot(psi)
///     = i3*sin(theta)*dot(theta)*dot(psi) - 2*(i1 - i3)*sin(theta)*cos(theta)*dot(phi)*dot(theta)
/// i1*ddot(theta) = (i1 - i3)*sin(theta)*cos(theta)*dot(phi)^2 - i3*sin(theta)*dot(phi)*dot(psi)
///     + m*h*g*sin(theta)
/// i3*cos(theta)*ddot(phi) + i3*ddot(psi) = i3*sin(theta)*dot(phi)*dot(theta)
/// ```
///
/// # State and structure
///
/// - State: `[phi, theta, psi, phi_dot, theta_dot, psi_dot]`.
/// - Mass matrix: blocks {`phi`, `psi`}, {`theta`}, depends on the configuration.
/// - Cyclic coordinates: `phi`, `psi`.
/// - Conserved: the momentum of `phi`, the momentum of `psi`, the energy function.
/// - Forward dynamics: eliminated body by body (counted cost 142; factorised mass matrix 179, the kinetic energy is no sum of squares).
/// - Cost of `acceleration`: 5 additions, 19 multiplications, 2 divisions, 1 `sin_cos`.
pub struct HeavyTop {
    /// Parameter `i1`.
    pub i1: ::core::primitive::f64,
    /// Parameter `i3`.
    pub i3: ::core::primitive::f64,
    /// Parameter `m`.
    pub m: ::core::primitive::f64,
    /// Parameter `h`.
    pub h: ::core::primitive::f64,
    /// Parameter `g`.
    pub g: ::core::primitive::f64,
}
/// State of [`HeavyTop`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct HeavyTopState {
    /// Coordinate `phi`.
    pub phi: ::core::primitive::f64,
    /// Coordinate `theta`.
    pub theta: ::core::primitive::f64,
    /// Coordinate `psi`.
    pub psi: ::core::primitive::f64,
    /// Velocity of `phi`.
    pub phi_dot: ::core::primitive::f64,
    /// Velocity of `theta`.
    pub theta_dot: ::core::primitive::f64,
    /// Velocity of `psi`.
    pub psi_dot: ::core::primitive::f64,
}
/// Columns of a table of states of [`HeavyTop`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct HeavyTopColumns<C>(C);
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::{cos, multiply_add, sin_cos};
    impl HeavyTop {
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 5 additions, 19 multiplications, 2 divisions, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> [f64; 3] {
            let Self { i1, i3, m, h, g } = *self;
            let [_, theta, _] = *q;
            let [phi_dot, theta_dot, psi_dot] = *v;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let vel_0 = i3 * multiply_add(cos_theta, phi_dot, psi_dot);
            let inv_i1 = 1.0 / i1;
            let vel_1 = inv_i1 * multiply_add(-2.0 * i1 * cos_theta, phi_dot, vel_0)
                * theta_dot;
            let phi_ddot = vel_1 / sin_theta;
            let sin_theta_phi_dot = sin_theta * phi_dot;
            let phi_dot_sq = phi_dot * phi_dot;
            let vel_2 = multiply_add(-sin_theta_phi_dot, vel_0, m * h * g * sin_theta);
            let forcing_1 = multiply_add(i1 * cos_theta * sin_theta, phi_dot_sq, vel_2);
            let theta_ddot = inv_i1 * forcing_1;
            let psi_ddot = multiply_add(
                -cos_theta,
                phi_ddot,
                sin_theta_phi_dot * theta_dot,
            );
            [phi_ddot, theta_ddot, psi_ddot]
        }
        /// Mass matrix M, in rows.
        ///
        /// Takes 1 addition, 5 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f64, q: &[f64; 3]) -> [[f64; 3]; 3] {
            let Self { i1, i3, .. } = *self;
            let [_, theta, _] = *q;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let sin_theta_sq = sin_theta * sin_theta;
            let pivot_0 = i1 * sin_theta_sq;
            let cos_theta_sq = cos_theta * cos_theta;
            let m_0_0 = multiply_add(i3, cos_theta_sq, pivot_0);
            let m_0_2 = i3 * cos_theta;
            [[m_0_0, 0.0, m_0_2], [0.0, i1, 0.0], [m_0_2, 0.0, i3]]
        }
        /// Right-hand side f of M q̈ = f.
        ///
        /// Takes 4 additions, 18 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> [f64; 3] {
            let Self { i1, i3, m, h, g } = *self;
            let [_, theta, _] = *q;
            let [phi_dot, theta_dot, psi_dot] = *v;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let i3_sin_theta = i3 * sin_theta;
            let i1_minus_i3 = i1 - i3;
            let vel_0 = 2.0 * i1_minus_i3 * sin_theta * cos_theta * phi_dot;
            let phi_dot_sq = phi_dot * phi_dot;
            let i3_sin_theta_phi_dot = i3_sin_theta * phi_dot;
            let vel_1 = i1_minus_i3 * sin_theta * cos_theta * phi_dot_sq;
            let vel_2 = multiply_add(-i3_sin_theta_phi_dot, psi_dot, vel_1);
            [
                multiply_add(-vel_0, theta_dot, i3_sin_theta * theta_dot * psi_dot),
                multiply_add(m * h * g, sin_theta, vel_2),
                i3_sin_theta_phi_dot * theta_dot,
            ]
        }
        /// Generalised momenta ∂L/∂v.
        ///
        /// Takes 2 additions, 7 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn momenta(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> [f64; 3] {
            let Self { i1, i3, .. } = *self;
            let [_, theta, _] = *q;
            let [phi_dot, theta_dot, psi_dot] = *v;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let vel_0 = i3 * multiply_add(cos_theta, phi_dot, psi_dot);
            let sin_theta_sq = sin_theta * sin_theta;
            [
                multiply_add(i1 * sin_theta_sq, phi_dot, cos_theta * vel_0),
                i1 * theta_dot,
                vel_0,
            ]
        }
        /// Kinetic energy T.
        ///
        /// Takes 3 additions, 9 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> f64 {
            let Self { i1, i3, .. } = *self;
            let [_, theta, _] = *q;
            let [phi_dot, theta_dot, psi_dot] = *v;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let sin_theta_sq = sin_theta * sin_theta;
            let phi_dot_sq = phi_dot * phi_dot;
            let vel_0 = multiply_add(cos_theta, phi_dot, psi_dot);
            let vel_0_sq = vel_0 * vel_0;
            let vel_1 = i1
                * multiply_add(sin_theta_sq, phi_dot_sq, theta_dot * theta_dot);
            0.5 * multiply_add(i3, vel_0_sq, vel_1)
        }
        /// Potential energy V.
        ///
        /// Takes 3 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, q: &[f64; 3]) -> f64 {
            let Self { m, h, g, .. } = *self;
            let [_, theta, _] = *q;
            m * h * g * cos(theta)
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 4 additions, 12 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> f64 {
            let Self { i1, i3, m, h, g } = *self;
            let [_, theta, _] = *q;
            let [phi_dot, theta_dot, psi_dot] = *v;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let sin_theta_sq = sin_theta * sin_theta;
            let phi_dot_sq = phi_dot * phi_dot;
            let vel_0 = multiply_add(cos_theta, phi_dot, psi_dot);
            let vel_0_sq = vel_0 * vel_0;
            let vel_1 = i1
                * multiply_add(sin_theta_sq, phi_dot_sq, theta_dot * theta_dot);
            multiply_add(m * h * g, cos_theta, 0.5 * multiply_add(i3, vel_0_sq, vel_1))
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 9 additions, 25 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            q: &[f64; 3],
            v: &[f64; 3],
            a: &[f64; 3],
        ) -> [f64; 3] {
            let Self { i1, i3, m, h, g } = *self;
            let [_, theta, _] = *q;
            let [phi_dot, theta_dot, psi_dot] = *v;
            let [phi_ddot, theta_ddot, psi_ddot] = *a;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let i1_sin_theta = i1 * sin_theta;
            let vel_0 = i3 * multiply_add(cos_theta, phi_dot, psi_dot);
            let sin_theta_theta_dot = sin_theta * theta_dot;
            let vel_1 = 2.0 * cos_theta * i1_sin_theta * phi_dot * theta_dot;
            let acc_0 = multiply_add(-phi_dot, sin_theta_theta_dot, psi_ddot);
            let acc_1 = i3 * multiply_add(cos_theta, phi_ddot, acc_0);
            let sin_theta_sq = sin_theta * sin_theta;
            let pivot_0 = i1 * sin_theta_sq;
            let acc_2 = multiply_add(
                cos_theta,
                acc_1,
                multiply_add(-vel_0, sin_theta_theta_dot, vel_1),
            );
            let phi_dot_sq = phi_dot * phi_dot;
            let vel_2 = multiply_add(-m * h * g, sin_theta, sin_theta * phi_dot * vel_0);
            let vel_3 = multiply_add(-cos_theta * i1_sin_theta, phi_dot_sq, vel_2);
            [
                multiply_add(pivot_0, phi_ddot, acc_2),
                multiply_add(i1, theta_ddot, vel_3),
                acc_1,
            ]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, y: &[f64; 6]) -> [f64; 6] {
            let [phi, theta, psi, phi_dot, theta_dot, psi_dot] = *y;
            let a = self
                .acceleration(t, &[phi, theta, psi], &[phi_dot, theta_dot, psi_dot]);
            [phi_dot, theta_dot, psi_dot, a[0], a[1], a[2]]
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for HeavyTop {
        fn default() -> Self {
            Self {
                i1: 0.12,
                i3: 0.05,
                m: 1.1,
                h: 0.25,
                g: 9.81,
            }
        }
    }
    impl HeavyTopState {
        /// The coordinates in their order.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [f64; 3] {
            [self.phi, self.theta, self.psi]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [f64; 3] {
            [self.phi_dot, self.theta_dot, self.psi_dot]
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 6]> for HeavyTopState {
        #[inline]
        fn from([phi, theta, psi, phi_dot, theta_dot, psi_dot]: [f64; 6]) -> Self {
            Self {
                phi,
                theta,
                psi,
                phi_dot,
                theta_dot,
                psi_dot,
            }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<HeavyTopState> for [f64; 6] {
        #[inline]
        fn from(state: HeavyTopState) -> Self {
            [
                state.phi,
                state.theta,
                state.psi,
                state.phi_dot,
                state.theta_dot,
                state.psi_dot,
            ]
        }
    }
    impl<C: ::lagrange::system::Columns> HeavyTopColumns<C> {
        /// Coordinate `phi`.
        #[must_use]
        #[inline]
        pub fn phi(&self) -> &[C::Scalar] {
            self.0.column(0)
        }
        /// Coordinate `theta`.
        #[must_use]
        #[inline]
        pub fn theta(&self) -> &[C::Scalar] {
            self.0.column(1)
        }
        /// Coordinate `psi`.
        #[must_use]
        #[inline]
        pub fn psi(&self) -> &[C::Scalar] {
            self.0.column(2)
        }
        /// Velocity of `phi`.
        #[must_use]
        #[inline]
        pub fn phi_dot(&self) -> &[C::Scalar] {
            self.0.column(3)
        }
        /// Velocity of `theta`.
        #[must_use]
        #[inline]
        pub fn theta_dot(&self) -> &[C::Scalar] {
            self.0.column(4)
        }
        /// Velocity of `psi`.
        #[must_use]
        #[inline]
        pub fn psi_dot(&self) -> &[C::Scalar] {
            self.0.column(5)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for HeavyTopColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for HeavyTopColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for HeavyTop {
        type Scalar = f64;
        type State = [f64; 6];
        #[inline]
        fn rhs(&self, t: f64, y: &[f64; 6]) -> [f64; 6] {
            self.rhs(t, y)
        }
        fn undefined(
            &self,
            t: f64,
            y: &[f64; 6],
            rates: &[f64; 6],
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
    impl ::lagrange::system::MechanicalSystem for HeavyTop {
        type Coordinates = [f64; 3];
        type Velocities = [f64; 3];
        type Columns<C> = HeavyTopColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &[
            "phi",
            "theta",
            "psi",
        ];
        const FINGERPRINT: ::core::primitive::u64 = 16260293178597113532;
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
                ("i1", self.i1),
                ("i3", self.i3),
                ("m", self.m),
                ("h", self.h),
                ("g", self.g),
            ]
                .get(index)
                .copied()
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for HeavyTop {
        type NamedState = HeavyTopState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for HeavyTop {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 3], v: &[f64; 3]) -> f64 {
            self.energy(t, q, v)
        }
    }
};
