/// A cart that carries a pendulum, pushed by a force u.
///
/// # Equations of motion
///
/// ```text
/// (mc + mp)*ddot(x) + mp*l*cos(theta)*ddot(theta) = mp*l*sin(theta)*dot(theta)^2 + u
/// mp*l*cos(theta)*ddot(x) + mp*l^2*ddot(theta) = -c*dot(theta) - mp*l*g*sin(theta)
/// ```
///
/// # State and structure
///
/// - State: `[x, theta, x_dot, theta_dot]`.
/// - Mass matrix: full, depends on the configuration.
/// - Cyclic coordinates: `x`.
/// - Forward dynamics: the mass matrix is factorised (counted cost 153; recursion 174, sum of squares 167).
/// - Cost of `acceleration`: 6 additions, 15 multiplications, 2 divisions, 1 `sin_cos`.
#[derive(Clone, Debug)]
pub struct CartPole {
    /// Parameter `mc` in kg.
    pub mc: ::core::primitive::f64,
    /// Parameter `mp` in kg, 100 g by default.
    pub mp: ::core::primitive::f64,
    /// Parameter `l` in m, 500 mm by default.
    pub l: ::core::primitive::f64,
    /// Parameter `c` in N*m*s.
    pub c: ::core::primitive::f64,
    /// Parameter `g` in m/s^2.
    pub g: ::core::primitive::f64,
    /// Input `u` in N.
    pub u: ::core::primitive::f64,
}
/// State of [`CartPole`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct CartPoleState {
    /// Coordinate `x` in m.
    pub x: ::core::primitive::f64,
    /// Coordinate `theta` in rad.
    pub theta: ::core::primitive::f64,
    /// Velocity of `x` in m/s.
    pub x_dot: ::core::primitive::f64,
    /// Velocity of `theta` in rad/s.
    pub theta_dot: ::core::primitive::f64,
}
/// Columns of a table of states of [`CartPole`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct CartPoleColumns<C>(C);
/// Inputs of [`CartPole`].
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct CartPoleInputs {
    /// Input `u` in N.
    pub u: ::core::primitive::f64,
}
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::{cos, multiply_add, sin, sin_cos};
    impl CartPole {
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 6 additions, 15 multiplications, 2 divisions, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let Self { mc, mp, l, c, g, u } = *self;
            let [_, theta] = *q;
            let [_, theta_dot] = *v;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let mp_l = mp * l;
            let theta_dot_sq = theta_dot * theta_dot;
            let forcing_0 = multiply_add(mp_l * sin_theta, theta_dot_sq, u);
            let m_0_1 = mp_l * cos_theta;
            let m_0_0 = mc + mp;
            let inv_m_0_0 = 1.0 / m_0_0;
            let factor_1_0 = inv_m_0_0 * m_0_1;
            let vel_0 = multiply_add(mp_l * g, sin_theta, c * theta_dot);
            let forcing_1 = -multiply_add(factor_1_0, forcing_0, vel_0);
            let l_sq = l * l;
            let m_1_1 = mp * l_sq;
            let pivot_1 = multiply_add(-m_0_1, factor_1_0, m_1_1);
            let theta_ddot = forcing_1 / pivot_1;
            let x_ddot = multiply_add(-factor_1_0, theta_ddot, inv_m_0_0 * forcing_0);
            [x_ddot, theta_ddot]
        }
        /// Mass matrix M, in rows.
        ///
        /// Takes 1 addition, 4 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f64, q: &[f64; 2]) -> [[f64; 2]; 2] {
            let Self { mc, mp, l, .. } = *self;
            let [_, theta] = *q;
            let m_0_0 = mc + mp;
            let m_0_1 = mp * l * cos(theta);
            let l_sq = l * l;
            let m_1_1 = mp * l_sq;
            [[m_0_0, m_0_1], [m_0_1, m_1_1]]
        }
        /// Right-hand side f of M q̈ = f.
        ///
        /// Takes 2 additions, 7 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let Self { mp, l, c, g, u, .. } = *self;
            let [_, theta] = *q;
            let [_, theta_dot] = *v;
            let sin_theta = sin(theta);
            let mp_l = mp * l;
            let theta_dot_sq = theta_dot * theta_dot;
            let forcing_0 = multiply_add(mp_l * sin_theta, theta_dot_sq, u);
            [forcing_0, -multiply_add(mp_l * g, sin_theta, c * theta_dot)]
        }
        /// Generalised momenta ∂L/∂v.
        ///
        /// Takes 3 additions, 10 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn momenta(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let Self { mc, mp, l, .. } = *self;
            let [_, theta] = *q;
            let [x_dot, theta_dot] = *v;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let l_cos_theta = l * cos_theta;
            let px_dot = multiply_add(l_cos_theta, theta_dot, x_dot);
            let mp_px_dot = mp * px_dot;
            let py_dot = l * sin_theta * theta_dot;
            [
                multiply_add(mc, x_dot, mp_px_dot),
                multiply_add(l_cos_theta, mp_px_dot, l * mp * sin_theta * py_dot),
            ]
        }
        /// Kinetic energy T.
        ///
        /// Takes 3 additions, 10 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
            let Self { mc, mp, l, .. } = *self;
            let [_, theta] = *q;
            let [x_dot, theta_dot] = *v;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let px_dot = multiply_add(l * cos_theta, theta_dot, x_dot);
            let py_dot = l * sin_theta * theta_dot;
            let x_dot_sq = x_dot * x_dot;
            let vel_0 = multiply_add(
                mp,
                multiply_add(py_dot, py_dot, px_dot * px_dot),
                mc * x_dot_sq,
            );
            0.5 * vel_0
        }
        /// Potential energy V.
        ///
        /// Takes 3 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, q: &[f64; 2]) -> f64 {
            let Self { mp, l, g, .. } = *self;
            let [_, theta] = *q;
            -mp * g * l * cos(theta)
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 4 additions, 13 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
            let Self { mc, mp, l, g, .. } = *self;
            let [_, theta] = *q;
            let [x_dot, theta_dot] = *v;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let px_dot = multiply_add(l * cos_theta, theta_dot, x_dot);
            let py_dot = l * sin_theta * theta_dot;
            let x_dot_sq = x_dot * x_dot;
            let vel_0 = multiply_add(
                mp,
                multiply_add(py_dot, py_dot, px_dot * px_dot),
                mc * x_dot_sq,
            );
            multiply_add(-mp * g * l, cos_theta, 0.5 * vel_0)
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 8 additions, 16 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            q: &[f64; 2],
            v: &[f64; 2],
            a: &[f64; 2],
        ) -> [f64; 2] {
            let Self { mc, mp, l, c, g, u } = *self;
            let [_, theta] = *q;
            let [_, theta_dot] = *v;
            let [x_ddot, theta_ddot] = *a;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let theta_dot_sq = theta_dot * theta_dot;
            let acc_0 = multiply_add(-cos_theta, theta_ddot, sin_theta * theta_dot_sq);
            let acc_1 = mp * multiply_add(-l, acc_0, x_ddot);
            let acc_2 = multiply_add(sin_theta, theta_ddot, cos_theta * theta_dot_sq);
            let acc_3 = multiply_add(l * cos_theta, acc_1, c * theta_dot);
            [
                multiply_add(mc, x_ddot, acc_1 - u),
                multiply_add(l * sin_theta, multiply_add(mp * l, acc_2, mp * g), acc_3),
            ]
        }
        /// Output `tip` in m.
        ///
        /// Takes 1 addition, 2 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn tip(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let Self { l, .. } = *self;
            let [x, theta] = *q;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let px = multiply_add(l, sin_theta, x);
            let py = -l * cos_theta;
            [px, py]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, y: &[f64; 4]) -> [f64; 4] {
            let [x, theta, x_dot, theta_dot] = *y;
            let a = self.acceleration(t, &[x, theta], &[x_dot, theta_dot]);
            [x_dot, theta_dot, a[0], a[1]]
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for CartPole {
        fn default() -> Self {
            Self {
                mc: 1.0,
                mp: 0.1,
                l: 0.5,
                c: 0.0,
                g: 9.81,
                u: 0.0,
            }
        }
    }
    impl CartPoleState {
        /// The coordinates in their order.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [f64; 2] {
            [self.x, self.theta]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [f64; 2] {
            [self.x_dot, self.theta_dot]
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 4]> for CartPoleState {
        #[inline]
        fn from([x, theta, x_dot, theta_dot]: [f64; 4]) -> Self {
            Self { x, theta, x_dot, theta_dot }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<CartPoleState> for [f64; 4] {
        #[inline]
        fn from(state: CartPoleState) -> Self {
            [state.x, state.theta, state.x_dot, state.theta_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> CartPoleColumns<C> {
        /// Coordinate `x` in m.
        #[must_use]
        #[inline]
        pub fn x(&self) -> &[C::Scalar] {
            self.0.column(0)
        }
        /// Coordinate `theta` in rad.
        #[must_use]
        #[inline]
        pub fn theta(&self) -> &[C::Scalar] {
            self.0.column(1)
        }
        /// Velocity of `x` in m/s.
        #[must_use]
        #[inline]
        pub fn x_dot(&self) -> &[C::Scalar] {
            self.0.column(2)
        }
        /// Velocity of `theta` in rad/s.
        #[must_use]
        #[inline]
        pub fn theta_dot(&self) -> &[C::Scalar] {
            self.0.column(3)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for CartPoleColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for CartPoleColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for CartPole {
        type Scalar = f64;
        type State = [f64; 4];
        #[inline]
        fn rhs(&self, t: f64, y: &[f64; 4]) -> [f64; 4] {
            self.rhs(t, y)
        }
        fn undefined(
            &self,
            t: f64,
            y: &[f64; 4],
            rates: &[f64; 4],
        ) -> ::core::option::Option<::lagrange::system::Undefined<f64>> {
            ::lagrange::integrate::undefined(
                self,
                (t, y, rates),
                &[("u", self.u)],
                |q, _| ::core::option::Option::Some(self.mass_matrix(t, q)),
            )
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::MechanicalSystem for CartPole {
        type Coordinates = [f64; 2];
        type Velocities = [f64; 2];
        type Columns<C> = CartPoleColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &["x", "theta"];
        const UNITS: &'static [(
            &'static ::core::primitive::str,
            &'static ::core::primitive::str,
        )] = &[
            ("x", "m"),
            ("theta", "rad"),
            ("x_dot", "m/s"),
            ("theta_dot", "rad/s"),
            ("x_ddot", "m/s^2"),
            ("theta_ddot", "rad/s^2"),
            ("mc", "kg"),
            ("mp", "kg"),
            ("l", "m"),
            ("c", "N*m*s"),
            ("g", "m/s^2"),
            ("u", "N"),
            ("tip.x", "m"),
            ("tip.y", "m"),
        ];
        const FINGERPRINT: ::core::primitive::u64 = 16353244810247407374;
        #[inline]
        fn acceleration(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            self.acceleration(t, q, v)
        }
        #[inline]
        fn position_rates(&self, _: f64, _: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            *v
        }
        fn parameter(
            &self,
            index: ::core::primitive::usize,
        ) -> ::core::option::Option<(&'static ::core::primitive::str, f64)> {
            [
                ("mc", self.mc),
                ("mp", self.mp),
                ("l", self.l),
                ("c", self.c),
                ("g", self.g),
            ]
                .get(index)
                .copied()
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for CartPole {
        type NamedState = CartPoleState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for CartPole {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
            self.energy(t, q, v)
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 1]> for CartPoleInputs {
        #[inline]
        fn from([u]: [f64; 1]) -> Self {
            Self { u }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<CartPoleInputs> for [f64; 1] {
        #[inline]
        fn from(inputs: CartPoleInputs) -> Self {
            [inputs.u]
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::ControlledSystem for CartPole {
        type Inputs = CartPoleInputs;
        type InputVector = [f64; 1];
        const INPUTS: &'static [&'static ::core::primitive::str] = &["u"];
        #[inline]
        fn inputs(&self) -> CartPoleInputs {
            CartPoleInputs { u: self.u }
        }
        #[inline]
        fn with_inputs(&self, inputs: CartPoleInputs) -> Self {
            Self {
                u: inputs.u,
                mc: self.mc,
                mp: self.mp,
                l: self.l,
                c: self.c,
                g: self.g,
            }
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OutputSystem for CartPole {
        type Outputs = [f64; 2];
        const OUTPUTS: &'static [&'static ::core::primitive::str] = &["tip.x", "tip.y"];
        #[inline]
        fn outputs(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let [output_0, output_1] = self.tip(t, q, v);
            [output_0, output_1]
        }
    }
};
