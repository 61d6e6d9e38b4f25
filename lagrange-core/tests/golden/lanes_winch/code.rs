/// A motor that winds up a spring, whose force grows up to a limit, against a bumper.
///
/// # Equations of motion
///
/// ```text
/// m*ddot(x) = min(u, limit) - (if x < stop { 0 } else { -k*(stop - x) })
/// 1/2*m*r^2*ddot(theta) = -(if 1 < r { r } else { 1 })*dot(theta)*abs(dot(theta)) - m*r*g*cos(theta)
/// ```
///
/// # State and structure
///
/// - State: `[x, theta, x_dot, theta_dot]`.
/// - Mass matrix: diagonal, constant.
/// - Cyclic coordinates: `x`.
/// - Forward dynamics: each equation divided by its entry of the mass matrix.
/// - Accuracy: `fast`. Sines and cosines are computed several at a time;
///   in `f64` each is within 0.9 units in the last place.
/// - Cost of `acceleration`: 3 additions, 11 multiplications, 2 divisions, 1 `sin_cos`, 3 selections.
pub struct Winch {
    /// Parameter `m`.
    pub m: ::core::primitive::f64,
    /// Parameter `r`.
    pub r: ::core::primitive::f64,
    /// Parameter `k`.
    pub k: ::core::primitive::f64,
    /// Parameter `limit`.
    pub limit: ::core::primitive::f64,
    /// Parameter `stop`.
    pub stop: ::core::primitive::f64,
    /// Parameter `g`.
    pub g: ::core::primitive::f64,
    /// Input `u`.
    pub u: ::core::primitive::f64,
    /// On which sides of its switches the system is computed; runs fix them.
    pub switches: ::lagrange::event::Switches,
}
/// State of [`Winch`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WinchState {
    /// Coordinate `x`.
    pub x: ::core::primitive::f64,
    /// Coordinate `theta`.
    pub theta: ::core::primitive::f64,
    /// Velocity of `x`.
    pub x_dot: ::core::primitive::f64,
    /// Velocity of `theta`.
    pub theta_dot: ::core::primitive::f64,
}
/// Columns of a table of states of [`Winch`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct WinchColumns<C>(C);
/// Inputs of [`Winch`].
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct WinchInputs {
    /// Input `u`.
    pub u: ::core::primitive::f64,
}
/// Equations of [`Winch`] for numbers side by side, with parameters of as many motions.
///
/// An evaluation takes 3 additions, 11 multiplications, 2 divisions, 1 `sin_cos`, 3 selections.
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct WinchLanes<S> {
    /// Parameter `m`.
    pub m: S,
    /// Parameter `r`.
    pub r: S,
    /// Parameter `k`.
    pub k: S,
    /// Parameter `limit`.
    pub limit: S,
    /// Parameter `stop`.
    pub stop: S,
    /// Parameter `g`.
    pub g: S,
    /// Input `u`.
    pub u: S,
}
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::{if_less, multiply_add, sign, sin_cos_each};
    impl Winch {
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 3 additions, 11 multiplications, 2 divisions, 1 `sin_cos`, 3 selections.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let Self { m, r, k, limit, stop, g, u, .. } = *self;
            let [side_0, side_1, side_2] = self.sides(t, q, v);
            let [x, theta] = *q;
            let [_, theta_dot] = *v;
            let vel_0 = if side_1 < 0.0 {
                0.0
            } else if side_1 >= 0.0 {
                -k * (stop - x)
            } else {
                f64::NAN
            };
            let vel_1 = if side_0 < 0.0 {
                u
            } else if side_0 >= 0.0 {
                limit
            } else {
                f64::NAN
            };
            let forcing_0 = vel_1 - vel_0;
            let inv_m = 1.0 / m;
            let x_ddot = inv_m * forcing_0;
            let [(_, cos_theta)] = sin_cos_each([theta]);
            let const_0 = if 1.0 < r { r } else if 1.0 >= r { 1.0 } else { f64::NAN };
            let r_sq = r * r;
            let vel_2 = multiply_add(
                const_0 * theta_dot * theta_dot,
                side_2,
                m * r * g * cos_theta,
            );
            let theta_ddot = -2.0 * inv_m / r_sq * vel_2;
            [x_ddot, theta_ddot]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, y: &[f64; 4]) -> [f64; 4] {
            let [x, theta, x_dot, theta_dot] = *y;
            let a = self.acceleration(t, &[x, theta], &[x_dot, theta_dot]);
            [x_dot, theta_dot, a[0], a[1]]
        }
        #[inline]
        fn switch_functions(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 3] {
            let Self { limit, stop, u, .. } = *self;
            let [x, _] = *q;
            let [_, theta_dot] = *v;
            [u - limit, x - stop, theta_dot]
        }
        #[inline]
        fn sides(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 3] {
            ::lagrange::event::Switches::signs(
                self.switches,
                || self.switch_functions(t, q, v),
            )
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for Winch {
        fn default() -> Self {
            Self {
                m: 2.0,
                r: 0.5,
                k: 300.0,
                limit: 40.0,
                stop: 1.2,
                g: 9.81,
                u: 0.0,
                switches: ::core::default::Default::default(),
            }
        }
    }
    impl WinchState {
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
    impl ::core::convert::From<[f64; 4]> for WinchState {
        #[inline]
        fn from([x, theta, x_dot, theta_dot]: [f64; 4]) -> Self {
            Self { x, theta, x_dot, theta_dot }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<WinchState> for [f64; 4] {
        #[inline]
        fn from(state: WinchState) -> Self {
            [state.x, state.theta, state.x_dot, state.theta_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> WinchColumns<C> {
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
    impl<C> ::core::convert::From<C> for WinchColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for WinchColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for Winch {
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
        const EVENTS: &'static [::lagrange::event::DeclaredEvent] = &[
            ::lagrange::event::DeclaredEvent::side("`u - limit` in `force x`"),
            ::lagrange::event::DeclaredEvent::side("`x - stop` in `force x`"),
            ::lagrange::event::DeclaredEvent::side("`dot(theta)` in `force theta`"),
        ];
        #[inline]
        fn event_values(&self, t: f64, y: &[f64; 4], values: &mut [f64]) {
            ::lagrange::event::side_values(self, t, y, values);
        }
        fn react(
            &self,
            event: ::core::primitive::usize,
            t: f64,
            _: f64,
            y: &[f64; 4],
        ) -> ::lagrange::system::Reacted<Self> {
            match event {
                _ => ::lagrange::event::change_side(self, event, t, y),
            }
        }
        fn begin(
            &self,
            t: f64,
            y: &[f64; 4],
        ) -> ::core::result::Result<
            ::core::option::Option<Self>,
            ::lagrange::system::StepFailure<f64>,
        > {
            ::core::result::Result::Ok(::lagrange::event::choose_sides(self, t, y))
        }
        fn on_sides(&self, t: f64, y: &[f64; 4]) -> ::core::option::Option<Self> {
            ::lagrange::event::choose_sides(self, t, y)
        }
        fn freed(&self) -> ::core::option::Option<Self> {
            ::core::option::Option::Some(::lagrange::event::free_sides(self))
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::MechanicalSystem for Winch {
        type Coordinates = [f64; 2];
        type Velocities = [f64; 2];
        type Columns<C> = WinchColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &["x", "theta"];
        const FINGERPRINT: ::core::primitive::u64 = 14593268254366086852;
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
                ("m", self.m),
                ("r", self.r),
                ("k", self.k),
                ("limit", self.limit),
                ("stop", self.stop),
                ("g", self.g),
            ]
                .get(index)
                .copied()
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for Winch {
        type NamedState = WinchState;
    }
    #[automatically_derived]
    impl ::lagrange::event::SwitchedSystem for Winch {
        const FIRST: ::core::primitive::usize = 0;
        fn switches(&self) -> ::lagrange::event::Switches {
            self.switches
        }
        fn with_switches(&self, switches: ::lagrange::event::Switches) -> Self {
            Self {
                switches: switches,
                m: self.m,
                r: self.r,
                k: self.k,
                limit: self.limit,
                stop: self.stop,
                g: self.g,
                u: self.u,
            }
        }
        fn switch_values(&self, t: f64, y: &[f64; 4], values: &mut [f64]) {
            let [x, theta, x_dot, theta_dot] = *y;
            values
                .copy_from_slice(
                    &self.switch_functions(t, &[x, theta], &[x_dot, theta_dot]),
                );
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::ParametricSystem for Winch {
        const NUMBERS: &'static [&'static ::core::primitive::str] = &[
            "m",
            "r",
            "k",
            "limit",
            "stop",
            "g",
            "u",
        ];
        fn number(
            &self,
            index: ::core::primitive::usize,
        ) -> ::core::option::Option<f64> {
            <[f64]>::get(
                    &[self.m, self.r, self.k, self.limit, self.stop, self.g, self.u],
                    index,
                )
                .copied()
        }
        fn with_number(&self, index: ::core::primitive::usize, value: f64) -> Self {
            let mut other = Self {
                m: self.m,
                r: self.r,
                k: self.k,
                limit: self.limit,
                stop: self.stop,
                g: self.g,
                u: self.u,
                switches: self.switches,
            };
            match index {
                0 => other.m = value,
                1 => other.r = value,
                2 => other.k = value,
                3 => other.limit = value,
                4 => other.stop = value,
                5 => other.g = value,
                6 => other.u = value,
                _ => {}
            }
            other
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 1]> for WinchInputs {
        #[inline]
        fn from([u]: [f64; 1]) -> Self {
            Self { u }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<WinchInputs> for [f64; 1] {
        #[inline]
        fn from(inputs: WinchInputs) -> Self {
            [inputs.u]
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::ControlledSystem for Winch {
        type Inputs = WinchInputs;
        type InputVector = [f64; 1];
        const INPUTS: &'static [&'static ::core::primitive::str] = &["u"];
        #[inline]
        fn inputs(&self) -> WinchInputs {
            WinchInputs { u: self.u }
        }
        #[inline]
        fn with_inputs(&self, inputs: WinchInputs) -> Self {
            Self {
                u: inputs.u,
                m: self.m,
                r: self.r,
                k: self.k,
                limit: self.limit,
                stop: self.stop,
                g: self.g,
                switches: self.switches,
            }
        }
    }
    impl<S: ::lagrange::Number> WinchLanes<S> {
        #[inline(always)]
        fn sides(&self, t: S, y: &[S; 4]) -> [S; 3] {
            let Self { limit, stop, u, .. } = *self;
            let [x, _, _, theta_dot] = *y;
            [sign(u - limit), sign(x - stop), sign(theta_dot)]
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Number> ::lagrange::system::Equations<S> for WinchLanes<S> {
        type State = [S; 4];
        type Series = ();
        #[inline(always)]
        fn rhs(&self, t: S, y: &[S; 4]) -> [S; 4] {
            let Self { m, r, k, limit, stop, g, u } = *self;
            let [side_0, side_1, side_2] = self.sides(t, y);
            let [x, theta, x_dot, theta_dot] = *y;
            let const_0 = S::ZERO;
            let vel_0 = if_less(side_1, const_0, const_0, -k * (stop - x));
            let forcing_0 = if_less(side_0, const_0, u, limit) - vel_0;
            let const_1 = S::ONE;
            let inv_m = const_1 / m;
            let x_ddot = inv_m * forcing_0;
            let [(_, cos_theta)] = sin_cos_each([theta]);
            let vel_1 = if_less(const_1, r, r, const_1) * theta_dot * theta_dot;
            let r_sq = r * r;
            let vel_2 = multiply_add(vel_1, side_2, m * r * g * cos_theta);
            let theta_ddot = S::from_f64(-2.0) * inv_m / r_sq * vel_2;
            [x_dot, theta_dot, x_ddot, theta_ddot]
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::LanesSystem for Winch {
        type Lanes<L: ::lagrange::Number> = WinchLanes<L>;
        fn lanes<L: ::lagrange::Number>(
            &self,
            splat: impl ::core::ops::Fn(f64) -> L,
        ) -> WinchLanes<L> {
            WinchLanes {
                m: splat(self.m),
                r: splat(self.r),
                k: splat(self.k),
                limit: splat(self.limit),
                stop: splat(self.stop),
                g: splat(self.g),
                u: splat(self.u),
            }
        }
        fn set_lane<L: ::lagrange::system::SideBySide<Element = f64>>(
            &self,
            lanes: &mut WinchLanes<L>,
            lane: ::core::primitive::usize,
        ) {
            ::lagrange::system::SideBySide::set_lane(&mut lanes.m, lane, self.m);
            ::lagrange::system::SideBySide::set_lane(&mut lanes.r, lane, self.r);
            ::lagrange::system::SideBySide::set_lane(&mut lanes.k, lane, self.k);
            ::lagrange::system::SideBySide::set_lane(&mut lanes.limit, lane, self.limit);
            ::lagrange::system::SideBySide::set_lane(&mut lanes.stop, lane, self.stop);
            ::lagrange::system::SideBySide::set_lane(&mut lanes.g, lane, self.g);
            ::lagrange::system::SideBySide::set_lane(&mut lanes.u, lane, self.u);
        }
    }
};
