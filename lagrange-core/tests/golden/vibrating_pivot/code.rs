/// Kapitza's pendulum: the pivot oscillates vertically.
///
/// # Equations of motion
///
/// ```text
/// m*l^2*ddot(theta) = m*l*a*w^2*sin(theta)*cos(w*t) - m*l*g*sin(theta)
/// ```
///
/// # State and structure
///
/// - State: `[theta, theta_dot]`.
/// - Mass matrix: diagonal, constant.
/// - Separable: explicit symplectic methods take it.
/// - Forward dynamics: each equation divided by its entry of the mass matrix.
/// - Cost of `acceleration`: 1 addition, 6 multiplications, 1 division, 2 functions.
pub struct Kapitza {
    /// Parameter `m`.
    pub m: ::core::primitive::f64,
    /// Parameter `l`.
    pub l: ::core::primitive::f64,
    /// Parameter `a`.
    pub a: ::core::primitive::f64,
    /// Parameter `w`.
    pub w: ::core::primitive::f64,
    /// Parameter `g`.
    pub g: ::core::primitive::f64,
}
/// State of [`Kapitza`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct KapitzaState {
    /// Coordinate `theta`.
    pub theta: ::core::primitive::f64,
    /// Velocity of `theta`.
    pub theta_dot: ::core::primitive::f64,
}
/// Columns of a table of states of [`Kapitza`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct KapitzaColumns<C>(C);
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::{cos, multiply_add, sin, sin_cos};
    impl Kapitza {
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 1 addition, 6 multiplications, 1 division, 2 functions.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let Self { l, a, w, g, .. } = *self;
            let [theta] = *q;
            let w_sq = w * w;
            let theta_ddot = -1.0 / l * multiply_add(-a * w_sq, cos(w * t), g)
                * sin(theta);
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
        /// Takes 3 additions, 16 multiplications, 1 function, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let Self { m, l, a, w, g } = *self;
            let [theta] = *q;
            let [theta_dot] = *v;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let theta_dot_sq = theta_dot * theta_dot;
            let vel_0 = multiply_add(
                -l * cos_theta,
                theta_dot_sq,
                a * w * w * cos(w * t),
            );
            let vel_1 = l * m * l * cos_theta * sin_theta * theta_dot_sq;
            let forcing_0 = multiply_add(
                -l * sin_theta,
                multiply_add(-m, vel_0, m * g),
                vel_1,
            );
            [forcing_0]
        }
        /// Generalised momenta ∂L/∂v.
        ///
        /// Takes 2 additions, 12 multiplications, 1 function, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn momenta(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let Self { m, l, a, w, .. } = *self;
            let [theta] = *q;
            let [theta_dot] = *v;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let y_dot = multiply_add(-a * w, sin(w * t), l * sin_theta * theta_dot);
            let l_m = l * m;
            let x_dot = l * cos_theta * theta_dot;
            [multiply_add(l_m * cos_theta, x_dot, l_m * sin_theta * y_dot)]
        }
        /// Kinetic energy T.
        ///
        /// Takes 2 additions, 11 multiplications, 1 function, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            let Self { m, l, a, w, .. } = *self;
            let [theta] = *q;
            let [theta_dot] = *v;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let x_dot = l * cos_theta * theta_dot;
            let y_dot = multiply_add(-a * w, sin(w * t), l * sin_theta * theta_dot);
            0.5 * m * multiply_add(y_dot, y_dot, x_dot * x_dot)
        }
        /// Potential energy V.
        ///
        /// Takes 1 addition, 5 multiplications, 2 functions.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, q: &[f64; 1]) -> f64 {
            let Self { m, l, a, w, g } = *self;
            let [theta] = *q;
            let y = multiply_add(-l, cos(theta), a * cos(w * t));
            m * g * y
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 6 additions, 20 multiplications, 2 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            let Self { m, l, a, w, g } = *self;
            let [theta] = *q;
            let [theta_dot] = *v;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let l_cos_theta = l * cos_theta;
            let x_dot = l_cos_theta * theta_dot;
            let (sin_w_t, cos_w_t) = sin_cos(w * t);
            let y_dot = multiply_add(-a * w, sin_w_t, l * sin_theta * theta_dot);
            let y = multiply_add(a, cos_w_t, -l_cos_theta);
            let l_m = l * m;
            let vel_0 = multiply_add(
                -0.5 * m,
                multiply_add(y_dot, y_dot, x_dot * x_dot),
                m * g * y,
            );
            let vel_1 = multiply_add(l_m * cos_theta, x_dot, l_m * sin_theta * y_dot);
            multiply_add(theta_dot, vel_1, vel_0)
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 5 additions, 18 multiplications, 1 function, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            q: &[f64; 1],
            v: &[f64; 1],
            accelerations: &[f64; 1],
        ) -> [f64; 1] {
            let Self { m, l, a, w, g } = *self;
            let [theta] = *q;
            let [theta_dot] = *v;
            let [theta_ddot] = *accelerations;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let theta_dot_sq = theta_dot * theta_dot;
            let pos_0 = a * w * w * cos(w * t);
            let acc_0 = multiply_add(sin_theta, theta_ddot, cos_theta * theta_dot_sq);
            let acc_1 = l * sin_theta
                * multiply_add(-m, multiply_add(-l, acc_0, pos_0), m * g);
            let acc_2 = multiply_add(-cos_theta, theta_ddot, sin_theta * theta_dot_sq);
            [multiply_add(-l * m * l * cos_theta, acc_2, acc_1)]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, y: &[f64; 2]) -> [f64; 2] {
            let [theta, theta_dot] = *y;
            let accelerations = self.acceleration(t, &[theta], &[theta_dot]);
            [theta_dot, accelerations[0]]
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for Kapitza {
        fn default() -> Self {
            Self {
                m: 1.0,
                l: 0.5,
                a: 0.02,
                w: 120.0,
                g: 9.81,
            }
        }
    }
    impl KapitzaState {
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
    impl ::core::convert::From<[f64; 2]> for KapitzaState {
        #[inline]
        fn from([theta, theta_dot]: [f64; 2]) -> Self {
            Self { theta, theta_dot }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<KapitzaState> for [f64; 2] {
        #[inline]
        fn from(state: KapitzaState) -> Self {
            [state.theta, state.theta_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> KapitzaColumns<C> {
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
    impl<C> ::core::convert::From<C> for KapitzaColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for KapitzaColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for Kapitza {
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
    impl ::lagrange::system::MechanicalSystem for Kapitza {
        type Coordinates = [f64; 1];
        type Velocities = [f64; 1];
        type Columns<C> = KapitzaColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &["theta"];
        const FINGERPRINT: ::core::primitive::u64 = 4457823168720754829;
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
            [("m", self.m), ("l", self.l), ("a", self.a), ("w", self.w), ("g", self.g)]
                .get(index)
                .copied()
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for Kapitza {
        type NamedState = KapitzaState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for Kapitza {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            self.energy(t, q, v)
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::SeparableSystem for Kapitza {}
};
