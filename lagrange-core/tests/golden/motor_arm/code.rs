/// An arm that a motor turns against gravity.
///
/// # Equations of motion
///
/// ```text
/// m*l^2*ddot(theta) = k*current - c*dot(theta) - m*l*g*sin(theta)
/// dot(current) = (voltage - k*dot(theta) - r*current)/inductance
/// ```
///
/// # State and structure
///
/// - State: `[theta, current, theta_dot]`.
/// - Mass matrix: diagonal, constant.
/// - Forward dynamics: each equation divided by its entry of the mass matrix.
/// - Cost of `acceleration`: 2 additions, 7 multiplications, 1 division, 1 function.
pub struct MotorArm {
    /// Parameter `m`.
    pub m: ::core::primitive::f64,
    /// Parameter `l`.
    pub l: ::core::primitive::f64,
    /// Parameter `k`.
    pub k: ::core::primitive::f64,
    /// Parameter `r`.
    pub r: ::core::primitive::f64,
    /// Parameter `inductance`.
    pub inductance: ::core::primitive::f64,
    /// Parameter `c`.
    pub c: ::core::primitive::f64,
    /// Parameter `g`.
    pub g: ::core::primitive::f64,
    /// Input `voltage`.
    pub voltage: ::core::primitive::f64,
}
/// State of [`MotorArm`]: positions, first-order states, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct MotorArmState {
    /// Coordinate `theta`.
    pub theta: ::core::primitive::f64,
    /// State `current`.
    pub current: ::core::primitive::f64,
    /// Velocity of `theta`.
    pub theta_dot: ::core::primitive::f64,
}
/// Columns of a table of states of [`MotorArm`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct MotorArmColumns<C>(C);
/// Inputs of [`MotorArm`].
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct MotorArmInputs {
    /// Input `voltage`.
    pub voltage: ::core::primitive::f64,
}
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::{cos, multiply_add, sin};
    impl MotorArm {
        /// The equations of motion in LaTeX, one line for each coordinate after the definitions of
        /// abbreviations, if they need any.
        pub const EQUATIONS_LATEX: &'static ::core::primitive::str = "m l^{2} \\ddot{\\theta} = k \\mathrm{current} - c \\dot{\\theta} - m l g \\sin\\left(\\theta\\right)\n\\dot{\\mathrm{current}} = \\frac{\\mathrm{voltage} - k \\dot{\\theta} - r \\mathrm{current}}{\\mathrm{inductance}}";
        /// Parameters, then inputs: the columns of `parameter_jacobian`.
        pub const PARAMETERS: [&'static ::core::primitive::str; 8] = [
            "m",
            "l",
            "k",
            "r",
            "inductance",
            "c",
            "g",
            "voltage",
        ];
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 2 additions, 7 multiplications, 1 division, 1 function.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 2], v: &[f64; 1]) -> [f64; 1] {
            let Self { m, l, k, c, g, .. } = *self;
            let [theta, current] = *q;
            let [theta_dot] = *v;
            let l_m = l * m;
            let forcing_0 = multiply_add(
                -l_m * g,
                sin(theta),
                multiply_add(-c, theta_dot, k * current),
            );
            let m_0_0 = l_m * l;
            let theta_ddot = 1.0 / m_0_0 * forcing_0;
            [theta_ddot]
        }
        /// Rates of the positions: kinematic differential equations, then the equations of the states.
        #[must_use]
        #[inline]
        pub fn position_rates(&self, t: f64, q: &[f64; 2], v: &[f64; 1]) -> [f64; 2] {
            let Self { k, r, inductance, voltage, .. } = *self;
            let [_, current] = *q;
            let [theta_dot] = *v;
            let vel_0 = multiply_add(-k, theta_dot, multiply_add(-r, current, voltage));
            let current_dot = 1.0 / inductance * vel_0;
            [theta_dot, current_dot]
        }
        /// Mass matrix M, in rows.
        ///
        /// Takes 2 multiplications.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f64, q: &[f64; 2]) -> [[f64; 1]; 1] {
            let Self { m, l, .. } = *self;
            let m_0_0 = l * m * l;
            [[m_0_0]]
        }
        /// Right-hand side f of M q̈ = f.
        ///
        /// Takes 2 additions, 5 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: f64, q: &[f64; 2], v: &[f64; 1]) -> [f64; 1] {
            let Self { m, l, k, c, g, .. } = *self;
            let [theta, current] = *q;
            let [theta_dot] = *v;
            let forcing_0 = multiply_add(
                -m * l * g,
                sin(theta),
                multiply_add(-c, theta_dot, k * current),
            );
            [forcing_0]
        }
        /// Generalised momenta ∂L/∂v.
        ///
        /// Takes 3 multiplications.
        #[must_use]
        #[inline]
        pub fn momenta(&self, t: f64, q: &[f64; 2], v: &[f64; 1]) -> [f64; 1] {
            let Self { m, l, .. } = *self;
            let [theta_dot] = *v;
            [l * m * l * theta_dot]
        }
        /// Kinetic energy T.
        ///
        /// Takes 4 multiplications.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: f64, q: &[f64; 2], v: &[f64; 1]) -> f64 {
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
        pub fn potential_energy(&self, t: f64, q: &[f64; 2]) -> f64 {
            let Self { m, l, g, .. } = *self;
            let [theta, _] = *q;
            -m * l * g * cos(theta)
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 1 addition, 7 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 2], v: &[f64; 1]) -> f64 {
            let Self { m, l, g, .. } = *self;
            let [theta, _] = *q;
            let [theta_dot] = *v;
            let l_theta_dot = l * theta_dot;
            let l_theta_dot_sq = l_theta_dot * l_theta_dot;
            multiply_add(-m * l * g, cos(theta), 0.5 * m * l_theta_dot_sq)
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 3 additions, 7 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            q: &[f64; 2],
            v: &[f64; 1],
            a: &[f64; 1],
        ) -> [f64; 1] {
            let Self { m, l, k, c, g, .. } = *self;
            let [theta, current] = *q;
            let [theta_dot] = *v;
            let [theta_ddot] = *a;
            let m_l = m * l;
            let vel_0 = multiply_add(
                m_l * g,
                sin(theta),
                multiply_add(-k, current, c * theta_dot),
            );
            [multiply_add(m_l * l, theta_ddot, vel_0)]
        }
        /// Jacobian of `rhs`, in rows: entry `[i][j]` is the derivative of its entry `i` by entry `j`
        /// of the state.
        ///
        /// Takes 10 multiplications, 2 divisions, 1 function.
        #[must_use]
        #[inline]
        pub fn jacobian(&self, t: f64, y: &[f64; 3]) -> [[f64; 3]; 3] {
            let Self { m, l, k, r, inductance, c, g, .. } = *self;
            let [theta, _, _] = *y;
            let inv_inductance = 1.0 / inductance;
            let m_0_0 = l * m * l;
            let inv_m_0_0 = 1.0 / m_0_0;
            [
                [0.0, 0.0, 1.0],
                [0.0, -r * inv_inductance, -k * inv_inductance],
                [-inv_m_0_0 * m * l * g * cos(theta), k * inv_m_0_0, -c * inv_m_0_0],
            ]
        }
        /// Derivatives of `rhs` by the fields in the order of `PARAMETERS`, in rows: entry `[i][j]`
        /// is that of its entry `i` by field `j`.
        ///
        /// Takes 6 additions, 27 multiplications, 3 divisions, 1 function.
        #[must_use]
        #[inline]
        pub fn parameter_jacobian(&self, t: f64, y: &[f64; 3]) -> [[f64; 8]; 3] {
            let Self { m, l, k, r, inductance, c, g, voltage } = *self;
            let [theta, current, theta_dot] = *y;
            let inv_inductance = 1.0 / inductance;
            let inv_inductance_sq = inv_inductance * inv_inductance;
            let vel_0 = multiply_add(-k, theta_dot, multiply_add(-r, current, voltage));
            let m_l = m * l;
            let m_0_0 = l * m_l;
            let inv_m_0_0 = 1.0 / m_0_0;
            let sin_theta = sin(theta);
            let forcing_0 = multiply_add(
                -m_l * g,
                sin_theta,
                multiply_add(-c, theta_dot, k * current),
            );
            let inv_m_0_0_sq = inv_m_0_0 * inv_m_0_0;
            let vel_1 = inv_m_0_0_sq * forcing_0;
            let l_sq = l * l;
            [
                [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
                [
                    0.0,
                    0.0,
                    -inv_inductance * theta_dot,
                    -inv_inductance * current,
                    -inv_inductance_sq * vel_0,
                    0.0,
                    0.0,
                    inv_inductance,
                ],
                [
                    -multiply_add(inv_m_0_0 * l * g, sin_theta, l_sq * vel_1),
                    -multiply_add(inv_m_0_0 * m * g, sin_theta, 2.0 * m_l * vel_1),
                    inv_m_0_0 * current,
                    0.0,
                    0.0,
                    -inv_m_0_0 * theta_dot,
                    -1.0 / l * sin_theta,
                    0.0,
                ],
            ]
        }
        /// Output `power`.
        ///
        /// Takes 1 multiplication.
        #[must_use]
        #[inline]
        pub fn power(&self, t: f64, q: &[f64; 2], v: &[f64; 1]) -> f64 {
            let Self { voltage, .. } = *self;
            let [_, current] = *q;
            voltage * current
        }
        /// Output `surge`.
        ///
        /// Takes 3 additions, 3 multiplications, 1 division.
        #[must_use]
        #[inline]
        pub fn surge(&self, t: f64, q: &[f64; 2], v: &[f64; 1]) -> f64 {
            let Self { k, r, inductance, voltage, .. } = *self;
            let [_, current] = *q;
            let [theta_dot] = *v;
            let [theta_ddot] = self.acceleration(t, q, v);
            let vel_0 = multiply_add(-k, theta_dot, multiply_add(-r, current, voltage));
            let current_dot = 1.0 / inductance * vel_0;
            theta_ddot + current_dot
        }
        /// Rate of the state: rates of the positions, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, y: &[f64; 3]) -> [f64; 3] {
            let [theta, current, theta_dot] = *y;
            let a = self.acceleration(t, &[theta, current], &[theta_dot]);
            let rates = self.position_rates(t, &[theta, current], &[theta_dot]);
            [rates[0], rates[1], a[0]]
        }
        #[inline]
        fn event_functions(&self, t: f64, q: &[f64; 2], v: &[f64; 1]) -> [f64; 1] {
            let [_, current] = *q;
            [current - 20.0]
        }
        #[inline]
        fn after_event_0(&self, t: f64, q: &[f64; 2], v: &[f64; 1]) -> [f64; 3] {
            let [theta, _] = *q;
            let [theta_dot] = *v;
            [theta, 0.0, theta_dot]
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for MotorArm {
        fn default() -> Self {
            Self {
                m: 1.2,
                l: 0.4,
                k: 0.08,
                r: 0.9,
                inductance: 0.02,
                c: 0.01,
                g: 9.81,
                voltage: 0.0,
            }
        }
    }
    impl MotorArmState {
        /// The coordinates in their order, then the states.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [f64; 2] {
            [self.theta, self.current]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [f64; 1] {
            [self.theta_dot]
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 3]> for MotorArmState {
        #[inline]
        fn from([theta, current, theta_dot]: [f64; 3]) -> Self {
            Self { theta, current, theta_dot }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<MotorArmState> for [f64; 3] {
        #[inline]
        fn from(state: MotorArmState) -> Self {
            [state.theta, state.current, state.theta_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> MotorArmColumns<C> {
        /// Coordinate `theta`.
        #[must_use]
        #[inline]
        pub fn theta(&self) -> &[C::Scalar] {
            self.0.column(0)
        }
        /// State `current`.
        #[must_use]
        #[inline]
        pub fn current(&self) -> &[C::Scalar] {
            self.0.column(1)
        }
        /// Velocity of `theta`.
        #[must_use]
        #[inline]
        pub fn theta_dot(&self) -> &[C::Scalar] {
            self.0.column(2)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for MotorArmColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for MotorArmColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for MotorArm {
        type Scalar = f64;
        type State = [f64; 3];
        #[inline]
        fn rhs(&self, t: f64, y: &[f64; 3]) -> [f64; 3] {
            self.rhs(t, y)
        }
        fn undefined(
            &self,
            t: f64,
            y: &[f64; 3],
            rates: &[f64; 3],
        ) -> ::core::option::Option<::lagrange::system::Undefined<f64>> {
            ::lagrange::integrate::undefined(
                self,
                (t, y, rates),
                &[("voltage", self.voltage)],
                |q, _| ::core::option::Option::Some(self.mass_matrix(t, q)),
            )
        }
        #[inline]
        fn jacobian(
            &self,
            t: f64,
            y: &[f64; 3],
        ) -> ::core::option::Option<[[f64; 3]; 3]> {
            ::core::option::Option::Some(self.jacobian(t, y))
        }
        const EVENTS: &'static [::lagrange::event::DeclaredEvent] = &[
            ::lagrange::event::DeclaredEvent::new(
                "trip",
                ::lagrange::event::Direction::Rising,
            ),
        ];
        #[inline]
        fn event_values(&self, t: f64, y: &[f64; 3], values: &mut [f64]) {
            for (value, found) in ::core::iter::Iterator::zip(
                values.iter_mut(),
                {
                    let [theta, current, theta_dot] = *y;
                    self.event_functions(t, &[theta, current], &[theta_dot])
                },
            ) {
                *value = found;
            }
        }
        fn react(
            &self,
            event: ::core::primitive::usize,
            t: f64,
            _: f64,
            y: &[f64; 3],
        ) -> ::lagrange::system::Reacted<Self> {
            match event {
                0 => {
                    ::core::result::Result::Ok(
                        ::lagrange::event::Response::new(
                            ::lagrange::event::Action::Replace({
                                let [theta, current, theta_dot] = *y;
                                self.after_event_0(t, &[theta, current], &[theta_dot])
                            }),
                        ),
                    )
                }
                _ => {
                    ::core::result::Result::Ok(
                        ::lagrange::event::Response::new(
                            ::lagrange::event::Action::Continue,
                        ),
                    )
                }
            }
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::MechanicalSystem for MotorArm {
        type Coordinates = [f64; 2];
        type Velocities = [f64; 1];
        type Columns<C> = MotorArmColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &[
            "theta",
            "current",
        ];
        const FINGERPRINT: ::core::primitive::u64 = 16527272910017222182;
        #[inline]
        fn acceleration(&self, t: f64, q: &[f64; 2], v: &[f64; 1]) -> [f64; 1] {
            self.acceleration(t, q, v)
        }
        #[inline]
        fn position_rates(&self, t: f64, q: &[f64; 2], v: &[f64; 1]) -> [f64; 2] {
            self.position_rates(t, q, v)
        }
        const VELOCITIES: &'static [&'static ::core::primitive::str] = &["theta_dot"];
        const RATES_OF: &'static [&'static ::core::primitive::str] = &["theta"];
        const FIRST_ORDER_STATES: ::core::primitive::usize = 1;
        #[inline]
        fn displacement(&self, _: f64, from: &[f64; 2], to: &[f64; 2]) -> [f64; 1] {
            [to[0] - from[0]]
        }
        #[inline]
        fn position_change(&self, t: f64, q: &[f64; 2], v: &[f64; 1]) -> [f64; 2] {
            let mut change = self.position_rates(t, q, v);
            change[1] = <f64 as ::lagrange::Number>::ZERO;
            change
        }
        fn parameter(
            &self,
            index: ::core::primitive::usize,
        ) -> ::core::option::Option<(&'static ::core::primitive::str, f64)> {
            [
                ("m", self.m),
                ("l", self.l),
                ("k", self.k),
                ("r", self.r),
                ("inductance", self.inductance),
                ("c", self.c),
                ("g", self.g),
            ]
                .get(index)
                .copied()
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for MotorArm {
        type NamedState = MotorArmState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for MotorArm {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 2], v: &[f64; 1]) -> f64 {
            self.energy(t, q, v)
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 1]> for MotorArmInputs {
        #[inline]
        fn from([voltage]: [f64; 1]) -> Self {
            Self { voltage }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<MotorArmInputs> for [f64; 1] {
        #[inline]
        fn from(inputs: MotorArmInputs) -> Self {
            [inputs.voltage]
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::ControlledSystem for MotorArm {
        type Inputs = MotorArmInputs;
        type InputVector = [f64; 1];
        const INPUTS: &'static [&'static ::core::primitive::str] = &["voltage"];
        #[inline]
        fn inputs(&self) -> MotorArmInputs {
            MotorArmInputs {
                voltage: self.voltage,
            }
        }
        #[inline]
        fn with_inputs(&self, inputs: MotorArmInputs) -> Self {
            Self {
                voltage: inputs.voltage,
                m: self.m,
                l: self.l,
                k: self.k,
                r: self.r,
                inductance: self.inductance,
                c: self.c,
                g: self.g,
            }
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OutputSystem for MotorArm {
        type Outputs = [f64; 2];
        const OUTPUTS: &'static [&'static ::core::primitive::str] = &["power", "surge"];
        #[inline]
        fn outputs(&self, t: f64, q: &[f64; 2], v: &[f64; 1]) -> [f64; 2] {
            let output_0 = self.power(t, q, v);
            let output_1 = self.surge(t, q, v);
            [output_0, output_1]
        }
    }
};
