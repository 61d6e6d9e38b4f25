/// A driven rod on a pivot, whose length is an output.
///
/// # Equations of motion
///
/// ```text
/// (i + m*l^2)*ddot(theta) = motor - m*l*g*sin(theta)
/// ```
///
/// # State and structure
///
/// - State: `[theta, theta_dot]`.
/// - Mass matrix: diagonal, constant.
/// - Separable: explicit symplectic methods take it.
/// - Forward dynamics: each equation divided by its entry of the mass matrix.
/// - Cost of `acceleration`: 2 additions, 6 multiplications, 1 division, 1 function.
pub struct Rod<S> {
    /// Parameter `m`, `> 0`.
    pub m: S,
    /// Parameter `l`, `in 0.1..=1`.
    pub l: S,
    /// Parameter `i`.
    pub i: S,
    /// Parameter `g`.
    pub g: S,
    /// Input `motor`.
    pub motor: S,
}
/// State of [`Rod`]: positions, then velocities.
#[allow(clippy::derive_partial_eq_without_eq, reason = "a number type need not be `Eq`")]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RodState<S> {
    /// Coordinate `theta`.
    pub theta: S,
    /// Velocity of `theta`.
    pub theta_dot: S,
}
/// Columns of a table of states of [`Rod`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct RodColumns<C>(C);
/// Inputs of [`Rod`].
#[allow(clippy::derive_partial_eq_without_eq, reason = "a number type need not be `Eq`")]
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct RodInputs<S> {
    /// Input `motor`.
    pub motor: S,
}
/// [`Rod`] beside the values of all that its methods compute of parameters alone.
///
/// [`Rod::prepared`] makes it of the parameters as they are then: it keeps a copy of the system.
/// Keeps 3 values, which take 1 addition, 4 multiplications, 1 division.
pub struct RodPrepared<S> {
    system: Rod<S>,
    const_0: S,
    const_1: S,
    m_0_0: S,
}
::lagrange::private::bring_hints! {}
const _: () = {
    use ::lagrange::private::{cos, multiply_add, sin};
    impl<S: ::lagrange::Scalar> Rod<S> {
        /// The declared state at the start; entries without a declared value are zero.
        #[must_use]
        pub fn start(&self) -> RodState<S> {
            let Self { l, .. } = *self;
            RodState {
                theta: S::from_sum(0.3, 1.1102230246251566e-17),
                theta_dot: S::ONE / l,
            }
        }
        /// Checks that parameters, and quantities of contacts, are in their ranges. Runs do so before the first step.
        ///
        /// # Errors
        ///
        /// The first one that is outside of its range, or NaN.
        pub fn check_parameters(
            &self,
        ) -> ::core::result::Result<(), ::lagrange::system::OutOfRange<S>> {
            ::lagrange::system::OutOfRange::check(
                ::lagrange::system::RangedKind::Parameter,
                "m",
                self.m,
                (::core::ops::Bound::Excluded(S::ZERO), ::core::ops::Bound::Unbounded),
                "",
            )?;
            ::lagrange::system::OutOfRange::check(
                ::lagrange::system::RangedKind::Parameter,
                "l",
                self.l,
                (
                    ::core::ops::Bound::Included(
                        S::from_sum(0.1, -5.551115123125783e-18),
                    ),
                    ::core::ops::Bound::Included(S::ONE),
                ),
                "",
            )?;
            ::core::result::Result::Ok(())
        }
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 2 additions, 6 multiplications, 1 division, 1 function.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: S, q: &[S; 1], v: &[S; 1]) -> [S; 1] {
            let Self { m, l, i, g, motor } = *self;
            let [theta] = *q;
            let forcing_0 = multiply_add(-m * l * g, sin(theta), motor);
            let l_sq = l * l;
            let m_0_0 = multiply_add(m, l_sq, i);
            let theta_ddot = S::ONE / m_0_0 * forcing_0;
            [theta_ddot]
        }
        /// Mass matrix M, in rows.
        ///
        /// Takes 1 addition, 2 multiplications.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: S, q: &[S; 1]) -> [[S; 1]; 1] {
            let Self { m, l, i, .. } = *self;
            let l_sq = l * l;
            let m_0_0 = multiply_add(m, l_sq, i);
            [[m_0_0]]
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 2 additions, 8 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: S, q: &[S; 1], v: &[S; 1]) -> S {
            let Self { m, l, i, g, .. } = *self;
            let [theta] = *q;
            let [theta_dot] = *v;
            let l_sq = l * l;
            let m_0_0 = multiply_add(m, l_sq, i);
            let theta_dot_sq = theta_dot * theta_dot;
            multiply_add(-m * l * g, cos(theta), S::from_f64(0.5) * m_0_0 * theta_dot_sq)
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 3 additions, 6 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: S,
            q: &[S; 1],
            v: &[S; 1],
            a: &[S; 1],
        ) -> [S; 1] {
            let Self { m, l, i, g, motor } = *self;
            let [theta] = *q;
            let [theta_ddot] = *a;
            let l_sq = l * l;
            let m_0_0 = multiply_add(m, l_sq, i);
            [
                multiply_add(
                    m_0_0,
                    theta_ddot,
                    multiply_add(m * l * g, sin(theta), -motor),
                ),
            ]
        }
        /// Output `height`.
        ///
        /// Takes 1 multiplication, 1 function.
        #[must_use]
        #[inline]
        pub fn height(&self, t: S, q: &[S; 1], v: &[S; 1]) -> S {
            let Self { l, .. } = *self;
            let [theta] = *q;
            -l * cos(theta)
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: S, y: &[S; 2]) -> [S; 2] {
            let [theta, theta_dot] = *y;
            let a = self.acceleration(t, &[theta], &[theta_dot]);
            [theta_dot, a[0]]
        }
        /// The system beside the values of all that its methods compute of parameters alone.
        #[must_use]
        pub fn prepared(&self) -> RodPrepared<S> {
            let Self { m, l, i, g, .. } = *self;
            let l_sq = l * l;
            let m_0_0 = multiply_add(m, l_sq, i);
            RodPrepared {
                system: Self {
                    m: self.m,
                    l: self.l,
                    i: self.i,
                    g: self.g,
                    motor: self.motor,
                },
                const_0: m * l * g,
                const_1: S::ONE / m_0_0,
                m_0_0,
            }
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::core::default::Default for Rod<S> {
        fn default() -> Self {
            Self {
                m: S::from_f64(2.0),
                l: S::from_f64(0.5),
                i: S::from_sum(0.1, -5.551115123125783e-18),
                g: S::from_sum(9.81, -4.973799150320702e-16),
                motor: S::ZERO,
            }
        }
    }
    impl<S> RodState<S> {
        /// The coordinates in their order.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [S; 1] {
            [self.theta]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [S; 1] {
            [self.theta_dot]
        }
    }
    #[automatically_derived]
    impl<S> ::core::convert::From<[S; 2]> for RodState<S> {
        #[inline]
        fn from([theta, theta_dot]: [S; 2]) -> Self {
            Self { theta, theta_dot }
        }
    }
    #[automatically_derived]
    impl<S> ::core::convert::From<RodState<S>> for [S; 2] {
        #[inline]
        fn from(state: RodState<S>) -> Self {
            [state.theta, state.theta_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> RodColumns<C> {
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
    impl<C> ::core::convert::From<C> for RodColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for RodColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::OdeSystem for Rod<S> {
        type Scalar = S;
        type State = [S; 2];
        #[inline]
        fn rhs(&self, t: S, y: &[S; 2]) -> [S; 2] {
            self.rhs(t, y)
        }
        fn undefined(
            &self,
            t: S,
            y: &[S; 2],
            rates: &[S; 2],
        ) -> ::core::option::Option<::lagrange::system::Undefined<S>> {
            ::lagrange::integrate::undefined(
                self,
                (t, y, rates),
                &[("motor", self.motor)],
                |q, _| ::core::option::Option::Some(self.mass_matrix(t, q)),
            )
        }
        fn begin(
            &self,
            _: S,
            _: &[S; 2],
        ) -> ::core::result::Result<
            ::core::option::Option<Self>,
            ::lagrange::system::StepFailure<S>,
        > {
            self.check_parameters()?;
            ::core::result::Result::Ok(::core::option::Option::None)
        }
        #[inline]
        fn domain(&self) -> &'static ::lagrange::system::Domain {
            const DOMAIN: ::lagrange::system::Domain = ::lagrange::system::Domain {
                ranges: &[
                    ::lagrange::system::EntryRange {
                        entry: 0,
                        kind: ::lagrange::system::RangedKind::Coordinate,
                        name: "theta",
                        unit: "",
                        bounds: (
                            ::core::ops::Bound::Included(-3.0),
                            ::core::ops::Bound::Excluded(3.0),
                        ),
                    },
                ],
                nominal: &[0.5, 0.5],
            };
            &DOMAIN
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::MechanicalSystem for Rod<S> {
        type Coordinates = [S; 1];
        type Velocities = [S; 1];
        type Columns<C> = RodColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &["theta"];
        const FINGERPRINT: ::core::primitive::u64 = 2645187919563327573;
        #[inline]
        fn acceleration(&self, t: S, q: &[S; 1], v: &[S; 1]) -> [S; 1] {
            self.acceleration(t, q, v)
        }
        #[inline]
        fn position_rates(&self, _: S, _: &[S; 1], v: &[S; 1]) -> [S; 1] {
            *v
        }
        fn parameter(
            &self,
            index: ::core::primitive::usize,
        ) -> ::core::option::Option<(&'static ::core::primitive::str, S)> {
            [("m", self.m), ("l", self.l), ("i", self.i), ("g", self.g)]
                .get(index)
                .copied()
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::NamedSystem for Rod<S> {
        type NamedState = RodState<S>;
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::EnergyFunction for Rod<S> {
        #[inline]
        fn energy(&self, t: S, q: &[S; 1], v: &[S; 1]) -> S {
            self.energy(t, q, v)
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::SeparableSystem for Rod<S> {}
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::SeparableSystem for RodPrepared<S> {}
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::ParametricSystem for Rod<S> {
        const NUMBERS: &'static [&'static ::core::primitive::str] = &[
            "m",
            "l",
            "i",
            "g",
            "motor",
        ];
        fn number(&self, index: ::core::primitive::usize) -> ::core::option::Option<S> {
            <[S]>::get(&[self.m, self.l, self.i, self.g, self.motor], index).copied()
        }
        fn with_number(&self, index: ::core::primitive::usize, value: S) -> Self {
            let mut other = Self {
                m: self.m,
                l: self.l,
                i: self.i,
                g: self.g,
                motor: self.motor,
            };
            match index {
                0 => other.m = value,
                1 => other.l = value,
                2 => other.i = value,
                3 => other.g = value,
                4 => other.motor = value,
                _ => {}
            }
            other
        }
    }
    #[automatically_derived]
    impl<S> ::core::convert::From<[S; 1]> for RodInputs<S> {
        #[inline]
        fn from([motor]: [S; 1]) -> Self {
            Self { motor }
        }
    }
    #[automatically_derived]
    impl<S> ::core::convert::From<RodInputs<S>> for [S; 1] {
        #[inline]
        fn from(inputs: RodInputs<S>) -> Self {
            [inputs.motor]
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::ControlledSystem for Rod<S> {
        type Inputs = RodInputs<S>;
        type InputVector = [S; 1];
        const INPUTS: &'static [&'static ::core::primitive::str] = &["motor"];
        #[inline]
        fn inputs(&self) -> RodInputs<S> {
            RodInputs { motor: self.motor }
        }
        #[inline]
        fn with_inputs(&self, inputs: RodInputs<S>) -> Self {
            Self {
                motor: inputs.motor,
                m: self.m,
                l: self.l,
                i: self.i,
                g: self.g,
            }
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::OutputSystem for Rod<S> {
        type Outputs = [S; 1];
        const OUTPUTS: &'static [&'static ::core::primitive::str] = &["height"];
        #[inline]
        fn outputs(&self, t: S, q: &[S; 1], v: &[S; 1]) -> [S; 1] {
            let output_0 = self.height(t, q, v);
            [output_0]
        }
    }
    impl<S: ::lagrange::Scalar> RodPrepared<S> {
        /// The system as it was prepared.
        #[must_use]
        #[inline]
        pub fn system(&self) -> &Rod<S> {
            &self.system
        }
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 1 addition, 2 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: S, q: &[S; 1], v: &[S; 1]) -> [S; 1] {
            let Rod { motor, .. } = self.system;
            let Self { const_0, const_1, .. } = *self;
            let [theta] = *q;
            let forcing_0 = multiply_add(-const_0, sin(theta), motor);
            let theta_ddot = const_1 * forcing_0;
            [theta_ddot]
        }
        /// Mass matrix M, in rows.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: S, q: &[S; 1]) -> [[S; 1]; 1] {
            let Self { m_0_0, .. } = *self;
            [[m_0_0]]
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 2 additions, 2 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: S,
            q: &[S; 1],
            v: &[S; 1],
            a: &[S; 1],
        ) -> [S; 1] {
            let Rod { motor, .. } = self.system;
            let Self { const_0, m_0_0, .. } = *self;
            let [theta] = *q;
            let [theta_ddot] = *a;
            [multiply_add(m_0_0, theta_ddot, multiply_add(const_0, sin(theta), -motor))]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: S, y: &[S; 2]) -> [S; 2] {
            let [theta, theta_dot] = *y;
            let a = self.acceleration(t, &[theta], &[theta_dot]);
            [theta_dot, a[0]]
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::core::clone::Clone for RodPrepared<S> {
        fn clone(&self) -> Self {
            self.system.prepared()
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::Wrapper for RodPrepared<S> {
        type Inner = Rod<S>;
        type State = [S; 2];
        #[inline]
        fn inner(&self) -> &Rod<S> {
            &self.system
        }
        fn around(&self, system: Rod<S>) -> Self {
            system.prepared()
        }
        #[inline]
        fn outer_rhs(&self, t: S, y: &[S; 2]) -> [S; 2] {
            self.rhs(t, y)
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::ControlledSystem for RodPrepared<S> {
        type Inputs = RodInputs<S>;
        type InputVector = <Rod<S> as ::lagrange::system::ControlledSystem>::InputVector;
        const INPUTS: &'static [&'static ::core::primitive::str] = <Rod<
            S,
        > as ::lagrange::system::ControlledSystem>::INPUTS;
        #[inline]
        fn inputs(&self) -> RodInputs<S> {
            <Rod<S> as ::lagrange::system::ControlledSystem>::inputs(&self.system)
        }
        #[inline]
        fn with_inputs(&self, inputs: RodInputs<S>) -> Self {
            Self {
                system: <Rod<
                    S,
                > as ::lagrange::system::ControlledSystem>::with_inputs(
                    &self.system,
                    inputs,
                ),
                const_0: self.const_0,
                const_1: self.const_1,
                m_0_0: self.m_0_0,
            }
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Scalar> ::lagrange::system::OutputSystem for RodPrepared<S> {
        type Outputs = <Rod<S> as ::lagrange::system::OutputSystem>::Outputs;
        const OUTPUTS: &'static [&'static ::core::primitive::str] = <Rod<
            S,
        > as ::lagrange::system::OutputSystem>::OUTPUTS;
        #[inline]
        fn outputs(&self, t: S, q: &[S; 1], v: &[S; 1]) -> Self::Outputs {
            <Rod<S> as ::lagrange::system::OutputSystem>::outputs(&self.system, t, q, v)
        }
    }
};
