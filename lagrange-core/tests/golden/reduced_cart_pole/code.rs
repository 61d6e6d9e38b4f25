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
    /// Parameter `mc`.
    pub mc: ::core::primitive::f64,
    /// Parameter `mp`.
    pub mp: ::core::primitive::f64,
    /// Parameter `l`.
    pub l: ::core::primitive::f64,
    /// Parameter `c`.
    pub c: ::core::primitive::f64,
    /// Parameter `g`.
    pub g: ::core::primitive::f64,
    /// Input `u`.
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
    /// Coordinate `x`.
    pub x: ::core::primitive::f64,
    /// Coordinate `theta`.
    pub theta: ::core::primitive::f64,
    /// Velocity of `x`.
    pub x_dot: ::core::primitive::f64,
    /// Velocity of `theta`.
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
    /// Input `u`.
    pub u: ::core::primitive::f64,
}
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::{cos, multiply_add, sin_cos};
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
        /// Output `tip`.
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
        /// Coordinate `x`.
        #[must_use]
        #[inline]
        pub fn x(&self) -> &[C::Scalar] {
            self.0.column(0)
        }
        /// Coordinate `theta`.
        #[must_use]
        #[inline]
        pub fn theta(&self) -> &[C::Scalar] {
            self.0.column(1)
        }
        /// Velocity of `x`.
        #[must_use]
        #[inline]
        pub fn x_dot(&self) -> &[C::Scalar] {
            self.0.column(2)
        }
        /// Velocity of `theta`.
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
                |_, _| ::core::option::Option::None,
            )
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::MechanicalSystem for CartPole {
        type Coordinates = [f64; 2];
        type Velocities = [f64; 2];
        type Columns<C> = CartPoleColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &["x", "theta"];
        const FINGERPRINT: ::core::primitive::u64 = 8400207761191193533;
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
/// The pendulum of a cart that is held at the end of its track.
///
/// Reduced from [`CartPole`]: `x = 2*l` frozen.
///
/// # Equations of motion
///
/// ```text
/// mp*l^2*ddot(theta) = -c*dot(theta) - mp*l*g*sin(theta)
/// ```
///
/// # State and structure
///
/// - State: `[theta, theta_dot]`.
/// - Mass matrix: diagonal, constant.
/// - Forward dynamics: each equation divided by its entry of the mass matrix.
/// - Cost of `acceleration`: 1 addition, 7 multiplications, 1 division, 1 function.
#[derive(Clone, Debug)]
pub struct Parked {
    /// Parameter `mc`.
    pub mc: ::core::primitive::f64,
    /// Parameter `mp`.
    pub mp: ::core::primitive::f64,
    /// Parameter `l`.
    pub l: ::core::primitive::f64,
    /// Parameter `c`.
    pub c: ::core::primitive::f64,
    /// Parameter `g`.
    pub g: ::core::primitive::f64,
    /// Input `u`.
    pub u: ::core::primitive::f64,
}
/// State of [`Parked`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ParkedState {
    /// Coordinate `theta`.
    pub theta: ::core::primitive::f64,
    /// Velocity of `theta`.
    pub theta_dot: ::core::primitive::f64,
}
/// Columns of a table of states of [`Parked`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct ParkedColumns<C>(C);
/// Inputs of [`Parked`].
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct ParkedInputs {
    /// Input `u`.
    pub u: ::core::primitive::f64,
}
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::{cos, multiply_add, sin, sin_cos};
    impl Parked {
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 1 addition, 7 multiplications, 1 division, 1 function.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let Self { mp, l, c, g, .. } = *self;
            let [theta] = *q;
            let [theta_dot] = *v;
            let forcing_0 = -multiply_add(mp * l * g, sin(theta), c * theta_dot);
            let l_sq = l * l;
            let m_0_0 = mp * l_sq;
            let theta_ddot = 1.0 / m_0_0 * forcing_0;
            [theta_ddot]
        }
        /// Kinetic energy T.
        ///
        /// Takes 1 addition, 8 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            let Self { mp, l, .. } = *self;
            let [theta] = *q;
            let [theta_dot] = *v;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let py_dot = l * sin_theta * theta_dot;
            let px_dot = l * cos_theta * theta_dot;
            0.5 * mp * multiply_add(px_dot, px_dot, py_dot * py_dot)
        }
        /// Potential energy V.
        ///
        /// Takes 3 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, q: &[f64; 1]) -> f64 {
            let Self { mp, l, g, .. } = *self;
            let [theta] = *q;
            -mp * g * l * cos(theta)
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 2 additions, 11 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            let Self { mp, l, g, .. } = *self;
            let [theta] = *q;
            let [theta_dot] = *v;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let py_dot = l * sin_theta * theta_dot;
            let px_dot = l * cos_theta * theta_dot;
            let vel_0 = 0.5 * mp * multiply_add(px_dot, px_dot, py_dot * py_dot);
            multiply_add(-mp * g * l, cos_theta, vel_0)
        }
        /// Output `tip`.
        ///
        /// Takes 1 addition, 3 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn tip(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 2] {
            let Self { l, .. } = *self;
            let [theta] = *q;
            let (sin_theta, cos_theta) = sin_cos(theta);
            let px = multiply_add(l, sin_theta, 2.0 * l);
            let py = -l * cos_theta;
            [px, py]
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
    impl ::core::default::Default for Parked {
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
    impl ParkedState {
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
    impl ::core::convert::From<[f64; 2]> for ParkedState {
        #[inline]
        fn from([theta, theta_dot]: [f64; 2]) -> Self {
            Self { theta, theta_dot }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<ParkedState> for [f64; 2] {
        #[inline]
        fn from(state: ParkedState) -> Self {
            [state.theta, state.theta_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> ParkedColumns<C> {
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
    impl<C> ::core::convert::From<C> for ParkedColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for ParkedColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for Parked {
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
                &[("u", self.u)],
                |_, _| ::core::option::Option::None,
            )
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::MechanicalSystem for Parked {
        type Coordinates = [f64; 1];
        type Velocities = [f64; 1];
        type Columns<C> = ParkedColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &["theta"];
        const FINGERPRINT: ::core::primitive::u64 = 11973907379972613236;
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
    impl ::lagrange::system::NamedSystem for Parked {
        type NamedState = ParkedState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for Parked {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            self.energy(t, q, v)
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 1]> for ParkedInputs {
        #[inline]
        fn from([u]: [f64; 1]) -> Self {
            Self { u }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<ParkedInputs> for [f64; 1] {
        #[inline]
        fn from(inputs: ParkedInputs) -> Self {
            [inputs.u]
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::ControlledSystem for Parked {
        type Inputs = ParkedInputs;
        type InputVector = [f64; 1];
        const INPUTS: &'static [&'static ::core::primitive::str] = &["u"];
        #[inline]
        fn inputs(&self) -> ParkedInputs {
            ParkedInputs { u: self.u }
        }
        #[inline]
        fn with_inputs(&self, inputs: ParkedInputs) -> Self {
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
    impl ::lagrange::system::OutputSystem for Parked {
        type Outputs = [f64; 2];
        const OUTPUTS: &'static [&'static ::core::primitive::str] = &["tip.x", "tip.y"];
        #[inline]
        fn outputs(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 2] {
            let [output_0, output_1] = self.tip(t, q, v);
            [output_0, output_1]
        }
    }
};
const _: () = {
    use ::core::primitive::f64;
    #[automatically_derived]
    impl ::core::convert::From<&CartPole> for Parked {
        #[inline]
        fn from(system: &CartPole) -> Self {
            Self {
                mc: system.mc,
                mp: system.mp,
                l: system.l,
                c: system.c,
                g: system.g,
                u: system.u,
            }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<&Parked> for CartPole {
        #[inline]
        fn from(system: &Parked) -> Self {
            Self {
                mc: system.mc,
                mp: system.mp,
                l: system.l,
                c: system.c,
                g: system.g,
                u: system.u,
            }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<CartPoleState> for ParkedState {
        #[inline]
        fn from(state: CartPoleState) -> Self {
            Self {
                theta: state.theta,
                theta_dot: state.theta_dot,
            }
        }
    }
    impl Parked {
        /// The state of [`CartPole`] that belongs to a state of this system:
        /// frozen coordinates have their values, and no velocity.
        #[must_use]
        #[inline]
        pub fn expand(&self, state: ParkedState) -> CartPoleState {
            let Self { l, .. } = *self;
            let held = 2.0 * l;
            CartPoleState {
                x: held,
                theta: state.theta,
                x_dot: 0.0,
                theta_dot: state.theta_dot,
            }
        }
        /// How far a state of [`CartPole`] is from those that this system stands for:
        /// differences from their values for coordinates that are frozen or small, their velocities, and
        /// zero for everything else. What is frozen is lost in the reduced state; of what is small, the
        /// third power is neglected in energies.
        #[must_use]
        #[inline]
        pub fn deviation(&self, state: CartPoleState) -> CartPoleState {
            let Self { l, .. } = *self;
            let held = 2.0 * l;
            CartPoleState {
                x: state.x - held,
                theta: 0.0,
                x_dot: state.x_dot,
                theta_dot: 0.0,
            }
        }
    }
};
/// Reduced from [`CartPole`]: `theta ≈ 0` small.
///
/// Energies and dissipation are expanded to second order in what is small and its rates together, forces on
/// it to first order. Outputs are exact.
///
/// # Equations of motion
///
/// ```text
/// (mc + mp)*ddot(x) + mp*l*ddot(theta) = u
/// mp*l*ddot(x) + mp*l^2*ddot(theta) = -c*dot(theta) - mp*l*g*theta
/// ```
///
/// # State and structure
///
/// - State: `[x, theta, x_dot, theta_dot]`.
/// - Mass matrix: full, constant.
/// - Cyclic coordinates: `x`.
/// - Forward dynamics: the mass matrix is factorised (counted cost 86; recursion 100, sum of squares 104).
/// - Cost of `acceleration`: 5 additions, 11 multiplications, 2 divisions.
#[derive(Clone, Debug)]
pub struct Linear {
    /// Parameter `mc`.
    pub mc: ::core::primitive::f64,
    /// Parameter `mp`.
    pub mp: ::core::primitive::f64,
    /// Parameter `l`.
    pub l: ::core::primitive::f64,
    /// Parameter `c`.
    pub c: ::core::primitive::f64,
    /// Parameter `g`.
    pub g: ::core::primitive::f64,
    /// Input `u`.
    pub u: ::core::primitive::f64,
}
/// State of [`Linear`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct LinearState {
    /// Coordinate `x`.
    pub x: ::core::primitive::f64,
    /// Coordinate `theta`.
    pub theta: ::core::primitive::f64,
    /// Velocity of `x`.
    pub x_dot: ::core::primitive::f64,
    /// Velocity of `theta`.
    pub theta_dot: ::core::primitive::f64,
}
/// Columns of a table of states of [`Linear`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct LinearColumns<C>(C);
/// Inputs of [`Linear`].
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct LinearInputs {
    /// Input `u`.
    pub u: ::core::primitive::f64,
}
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::{multiply_add, sin_cos};
    impl Linear {
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 5 additions, 11 multiplications, 2 divisions.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let Self { mc, mp, l, c, g, u } = *self;
            let [_, theta] = *q;
            let [_, theta_dot] = *v;
            let m_0_1 = mp * l;
            let m_0_0 = mc + mp;
            let inv_m_0_0 = 1.0 / m_0_0;
            let factor_1_0 = m_0_1 * inv_m_0_0;
            let forcing_1 = -multiply_add(
                factor_1_0,
                u,
                multiply_add(m_0_1 * g, theta, c * theta_dot),
            );
            let m_1_1 = l * m_0_1;
            let pivot_1 = multiply_add(-m_0_1, factor_1_0, m_1_1);
            let theta_ddot = 1.0 / pivot_1 * forcing_1;
            let x_ddot = multiply_add(-factor_1_0, theta_ddot, inv_m_0_0 * u);
            [x_ddot, theta_ddot]
        }
        /// Kinetic energy T.
        ///
        /// Takes 2 additions, 6 multiplications.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
            let Self { mc, mp, l, .. } = *self;
            let [x_dot, theta_dot] = *v;
            let x_dot_sq = x_dot * x_dot;
            let px_dot = multiply_add(l, theta_dot, x_dot);
            let px_dot_sq = px_dot * px_dot;
            0.5 * multiply_add(mp, px_dot_sq, mc * x_dot_sq)
        }
        /// Potential energy V.
        ///
        /// Takes 1 addition, 5 multiplications.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, q: &[f64; 2]) -> f64 {
            let Self { mp, l, g, .. } = *self;
            let [_, theta] = *q;
            let theta_sq = theta * theta;
            let py = l * multiply_add(0.5, theta_sq, -1.0);
            mp * g * py
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 4 additions, 11 multiplications.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
            let Self { mc, mp, l, g, .. } = *self;
            let [_, theta] = *q;
            let [x_dot, theta_dot] = *v;
            let x_dot_sq = x_dot * x_dot;
            let px_dot = multiply_add(l, theta_dot, x_dot);
            let px_dot_sq = px_dot * px_dot;
            let theta_sq = theta * theta;
            let py = l * multiply_add(0.5, theta_sq, -1.0);
            multiply_add(mp * g, py, 0.5 * multiply_add(mp, px_dot_sq, mc * x_dot_sq))
        }
        /// Output `tip`.
        ///
        /// Takes 1 addition, 2 multiplications, 1 `sin_cos`.
        #[must_use]
        #[inline]
        pub fn tip(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let Self { l, .. } = *self;
            let [x, theta] = *q;
            let (sin_theta, cos_theta) = sin_cos(theta);
            [multiply_add(l, sin_theta, x), -l * cos_theta]
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
    impl ::core::default::Default for Linear {
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
    impl LinearState {
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
    impl ::core::convert::From<[f64; 4]> for LinearState {
        #[inline]
        fn from([x, theta, x_dot, theta_dot]: [f64; 4]) -> Self {
            Self { x, theta, x_dot, theta_dot }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<LinearState> for [f64; 4] {
        #[inline]
        fn from(state: LinearState) -> Self {
            [state.x, state.theta, state.x_dot, state.theta_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> LinearColumns<C> {
        /// Coordinate `x`.
        #[must_use]
        #[inline]
        pub fn x(&self) -> &[C::Scalar] {
            self.0.column(0)
        }
        /// Coordinate `theta`.
        #[must_use]
        #[inline]
        pub fn theta(&self) -> &[C::Scalar] {
            self.0.column(1)
        }
        /// Velocity of `x`.
        #[must_use]
        #[inline]
        pub fn x_dot(&self) -> &[C::Scalar] {
            self.0.column(2)
        }
        /// Velocity of `theta`.
        #[must_use]
        #[inline]
        pub fn theta_dot(&self) -> &[C::Scalar] {
            self.0.column(3)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for LinearColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for LinearColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for Linear {
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
                |_, _| ::core::option::Option::None,
            )
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::MechanicalSystem for Linear {
        type Coordinates = [f64; 2];
        type Velocities = [f64; 2];
        type Columns<C> = LinearColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &["x", "theta"];
        const FINGERPRINT: ::core::primitive::u64 = 14212579825385221619;
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
    impl ::lagrange::system::NamedSystem for Linear {
        type NamedState = LinearState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for Linear {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
            self.energy(t, q, v)
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 1]> for LinearInputs {
        #[inline]
        fn from([u]: [f64; 1]) -> Self {
            Self { u }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<LinearInputs> for [f64; 1] {
        #[inline]
        fn from(inputs: LinearInputs) -> Self {
            [inputs.u]
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::ControlledSystem for Linear {
        type Inputs = LinearInputs;
        type InputVector = [f64; 1];
        const INPUTS: &'static [&'static ::core::primitive::str] = &["u"];
        #[inline]
        fn inputs(&self) -> LinearInputs {
            LinearInputs { u: self.u }
        }
        #[inline]
        fn with_inputs(&self, inputs: LinearInputs) -> Self {
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
    impl ::lagrange::system::OutputSystem for Linear {
        type Outputs = [f64; 2];
        const OUTPUTS: &'static [&'static ::core::primitive::str] = &["tip.x", "tip.y"];
        #[inline]
        fn outputs(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let [output_0, output_1] = self.tip(t, q, v);
            [output_0, output_1]
        }
    }
};
const _: () = {
    use ::core::primitive::f64;
    #[automatically_derived]
    impl ::core::convert::From<&CartPole> for Linear {
        #[inline]
        fn from(system: &CartPole) -> Self {
            Self {
                mc: system.mc,
                mp: system.mp,
                l: system.l,
                c: system.c,
                g: system.g,
                u: system.u,
            }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<&Linear> for CartPole {
        #[inline]
        fn from(system: &Linear) -> Self {
            Self {
                mc: system.mc,
                mp: system.mp,
                l: system.l,
                c: system.c,
                g: system.g,
                u: system.u,
            }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<CartPoleState> for LinearState {
        #[inline]
        fn from(state: CartPoleState) -> Self {
            Self {
                x: state.x,
                theta: state.theta,
                x_dot: state.x_dot,
                theta_dot: state.theta_dot,
            }
        }
    }
    impl Linear {
        /// The state of [`CartPole`] that belongs to a state of this system:
        /// frozen coordinates have their values, and no velocity.
        #[must_use]
        #[inline]
        pub fn expand(&self, state: LinearState) -> CartPoleState {
            CartPoleState {
                x: state.x,
                theta: state.theta,
                x_dot: state.x_dot,
                theta_dot: state.theta_dot,
            }
        }
        /// How far a state of [`CartPole`] is from those that this system stands for:
        /// differences from their values for coordinates that are frozen or small, their velocities, and
        /// zero for everything else. What is frozen is lost in the reduced state; of what is small, the
        /// third power is neglected in energies.
        #[must_use]
        #[inline]
        pub fn deviation(&self, state: CartPoleState) -> CartPoleState {
            CartPoleState {
                x: 0.0,
                theta: state.theta,
                x_dot: 0.0,
                theta_dot: state.theta_dot,
            }
        }
    }
};
