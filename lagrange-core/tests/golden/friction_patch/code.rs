/// A block on a slope; friction grows linearly while the block enters the rough part.
///
/// # Equations of motion
///
/// ```text
/// 3/2*m*ddot(s) = m*g*sin(alpha)
///     - (if s < l1 { 0 } else if s < 2*r + l1 { -m*mu*g*(l1 - s)/(2*r) } else { m*mu*g })*sign(dot(s))
/// ```
///
/// # State and structure
///
/// - State: `[s, s_dot]`.
/// - Mass matrix: diagonal, constant.
/// - Forward dynamics: each equation divided by its entry of the mass matrix.
/// - Cost of `acceleration`: 2 additions, 10 multiplications, 2 divisions, 1 function, 2 selections.
pub struct FrictionPatch {
    /// Parameter `m`.
    pub m: ::core::primitive::f64,
    /// Parameter `r`.
    pub r: ::core::primitive::f64,
    /// Parameter `mu`.
    pub mu: ::core::primitive::f64,
    /// Parameter `l1`.
    pub l1: ::core::primitive::f64,
    /// Parameter `alpha`.
    pub alpha: ::core::primitive::f64,
    /// Parameter `g`.
    pub g: ::core::primitive::f64,
    /// On which sides of its switches the system is computed; runs fix them.
    pub switches: ::lagrange::event::Switches,
}
/// State of [`FrictionPatch`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct FrictionPatchState {
    /// Coordinate `s`.
    pub s: ::core::primitive::f64,
    /// Velocity of `s`.
    pub s_dot: ::core::primitive::f64,
}
/// Columns of a table of states of [`FrictionPatch`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct FrictionPatchColumns<C>(C);
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::{multiply_add, sin};
    impl FrictionPatch {
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 2 additions, 10 multiplications, 2 divisions, 1 function, 2 selections.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let Self { m, r, mu, l1, alpha, g, .. } = *self;
            let [side_0, side_1, side_2] = self.sides(t, q, v);
            let [s] = *q;
            let friction = if side_1 < 0.0 {
                0.0
            } else if side_1 >= 0.0 {
                if side_0 < 0.0 {
                    -0.5 * m * mu * g / r * (l1 - s)
                } else if side_0 >= 0.0 {
                    m * mu * g
                } else {
                    f64::NAN
                }
            } else {
                f64::NAN
            };
            let s_ddot = 0.6666666666666666 / m
                * multiply_add(-side_2, friction, m * g * sin(alpha));
            [s_ddot]
        }
        /// Mass matrix M, in rows.
        ///
        /// Takes 1 multiplication.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f64, q: &[f64; 1]) -> [[f64; 1]; 1] {
            let Self { m, .. } = *self;
            let m_0_0 = 1.5 * m;
            [[m_0_0]]
        }
        /// Right-hand side f of M q̈ = f.
        ///
        /// Takes 2 additions, 9 multiplications, 1 division, 1 function, 2 selections.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let Self { m, r, mu, l1, alpha, g, .. } = *self;
            let [side_0, side_1, side_2] = self.sides(t, q, v);
            let [s] = *q;
            let friction = if side_1 < 0.0 {
                0.0
            } else if side_1 >= 0.0 {
                if side_0 < 0.0 {
                    -0.5 * m * mu * g / r * (l1 - s)
                } else if side_0 >= 0.0 {
                    m * mu * g
                } else {
                    f64::NAN
                }
            } else {
                f64::NAN
            };
            let forcing_0 = multiply_add(-side_2, friction, m * g * sin(alpha));
            [forcing_0]
        }
        /// Generalised momenta ∂L/∂v.
        ///
        /// Takes 2 multiplications.
        #[must_use]
        #[inline]
        pub fn momenta(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let Self { m, .. } = *self;
            let [s_dot] = *v;
            [1.5 * m * s_dot]
        }
        /// Kinetic energy T.
        ///
        /// Takes 3 multiplications.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            let Self { m, .. } = *self;
            let [s_dot] = *v;
            let s_dot_sq = s_dot * s_dot;
            0.75 * m * s_dot_sq
        }
        /// Potential energy V.
        ///
        /// Takes 3 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, q: &[f64; 1]) -> f64 {
            let Self { m, alpha, g, .. } = *self;
            let [s] = *q;
            -m * g * sin(alpha) * s
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 1 addition, 6 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            let Self { m, alpha, g, .. } = *self;
            let [s] = *q;
            let [s_dot] = *v;
            let s_dot_sq = s_dot * s_dot;
            multiply_add(-m * g * sin(alpha), s, 0.75 * m * s_dot_sq)
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 3 additions, 11 multiplications, 1 division, 1 function, 2 selections.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            q: &[f64; 1],
            v: &[f64; 1],
            a: &[f64; 1],
        ) -> [f64; 1] {
            let Self { m, r, mu, l1, alpha, g, .. } = *self;
            let [side_0, side_1, side_2] = self.sides(t, q, v);
            let [s] = *q;
            let [s_ddot] = *a;
            let friction = if side_1 < 0.0 {
                0.0
            } else if side_1 >= 0.0 {
                if side_0 < 0.0 {
                    -0.5 * m * mu * g / r * (l1 - s)
                } else if side_0 >= 0.0 {
                    m * mu * g
                } else {
                    f64::NAN
                }
            } else {
                f64::NAN
            };
            let vel_0 = multiply_add(-m * g, sin(alpha), side_2 * friction);
            [multiply_add(1.5 * m, s_ddot, vel_0)]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, y: &[f64; 2]) -> [f64; 2] {
            let [s, s_dot] = *y;
            let a = self.acceleration(t, &[s], &[s_dot]);
            [s_dot, a[0]]
        }
        #[inline]
        fn switch_functions(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 3] {
            let Self { r, l1, .. } = *self;
            let [s] = *q;
            let [s_dot] = *v;
            let s_minus_l1 = s - l1;
            [multiply_add(-2.0, r, s_minus_l1), s_minus_l1, s_dot]
        }
        #[inline]
        fn sides(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 3] {
            ::lagrange::event::Switches::signs(
                self.switches,
                || self.switch_functions(t, q, v),
            )
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for FrictionPatch {
        fn default() -> Self {
            Self {
                m: 1.5,
                r: 0.25,
                mu: 0.6,
                l1: 1.2,
                alpha: 0.52,
                g: 9.81,
                switches: ::core::default::Default::default(),
            }
        }
    }
    impl FrictionPatchState {
        /// The coordinates in their order.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [f64; 1] {
            [self.s]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [f64; 1] {
            [self.s_dot]
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 2]> for FrictionPatchState {
        #[inline]
        fn from([s, s_dot]: [f64; 2]) -> Self {
            Self { s, s_dot }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<FrictionPatchState> for [f64; 2] {
        #[inline]
        fn from(state: FrictionPatchState) -> Self {
            [state.s, state.s_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> FrictionPatchColumns<C> {
        /// Coordinate `s`.
        #[must_use]
        #[inline]
        pub fn s(&self) -> &[C::Scalar] {
            self.0.column(0)
        }
        /// Velocity of `s`.
        #[must_use]
        #[inline]
        pub fn s_dot(&self) -> &[C::Scalar] {
            self.0.column(1)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for FrictionPatchColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for FrictionPatchColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for FrictionPatch {
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
        const EVENTS: &'static [::lagrange::event::DeclaredEvent] = &[
            ::lagrange::event::DeclaredEvent::side("`s - 2*r - l1` in `force s`"),
            ::lagrange::event::DeclaredEvent::side("`s - l1` in `force s`"),
            ::lagrange::event::DeclaredEvent::side("`dot(s)` in `force s`"),
        ];
        #[inline]
        fn event_values(&self, t: f64, y: &[f64; 2], values: &mut [f64]) {
            ::lagrange::event::side_values(self, t, y, values);
        }
        fn react(
            &self,
            event: ::core::primitive::usize,
            t: f64,
            _: f64,
            y: &[f64; 2],
        ) -> ::lagrange::system::Reacted<Self> {
            match event {
                _ => ::lagrange::event::change_side(self, event, t, y),
            }
        }
        fn begin(
            &self,
            t: f64,
            y: &[f64; 2],
        ) -> ::core::result::Result<
            ::core::option::Option<Self>,
            ::lagrange::system::StepFailure<f64>,
        > {
            ::core::result::Result::Ok(::lagrange::event::choose_sides(self, t, y))
        }
        fn on_sides(&self, t: f64, y: &[f64; 2]) -> ::core::option::Option<Self> {
            ::lagrange::event::choose_sides(self, t, y)
        }
        fn freed(&self) -> ::core::option::Option<Self> {
            ::core::option::Option::Some(::lagrange::event::free_sides(self))
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::MechanicalSystem for FrictionPatch {
        type Coordinates = [f64; 1];
        type Velocities = [f64; 1];
        type Columns<C> = FrictionPatchColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &["s"];
        const FINGERPRINT: ::core::primitive::u64 = 4471870307528955108;
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
                ("m", self.m),
                ("r", self.r),
                ("mu", self.mu),
                ("l1", self.l1),
                ("alpha", self.alpha),
                ("g", self.g),
            ]
                .get(index)
                .copied()
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for FrictionPatch {
        type NamedState = FrictionPatchState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for FrictionPatch {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            self.energy(t, q, v)
        }
    }
    #[automatically_derived]
    impl ::lagrange::event::SwitchedSystem for FrictionPatch {
        const FIRST: ::core::primitive::usize = 0;
        fn switches(&self) -> ::lagrange::event::Switches {
            self.switches
        }
        fn with_switches(&self, switches: ::lagrange::event::Switches) -> Self {
            Self {
                switches: switches,
                m: self.m,
                r: self.r,
                mu: self.mu,
                l1: self.l1,
                alpha: self.alpha,
                g: self.g,
            }
        }
        fn switch_values(&self, t: f64, y: &[f64; 2], values: &mut [f64]) {
            let [s, s_dot] = *y;
            values.copy_from_slice(&self.switch_functions(t, &[s], &[s_dot]));
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::ParametricSystem for FrictionPatch {
        const NUMBERS: &'static [&'static ::core::primitive::str] = &[
            "m",
            "r",
            "mu",
            "l1",
            "alpha",
            "g",
        ];
        fn number(
            &self,
            index: ::core::primitive::usize,
        ) -> ::core::option::Option<f64> {
            <[f64]>::get(&[self.m, self.r, self.mu, self.l1, self.alpha, self.g], index)
                .copied()
        }
        fn with_number(&self, index: ::core::primitive::usize, value: f64) -> Self {
            let mut other = Self {
                m: self.m,
                r: self.r,
                mu: self.mu,
                l1: self.l1,
                alpha: self.alpha,
                g: self.g,
                switches: self.switches,
            };
            match index {
                0 => other.m = value,
                1 => other.r = value,
                2 => other.mu = value,
                3 => other.l1 = value,
                4 => other.alpha = value,
                5 => other.g = value,
                _ => {}
            }
            other
        }
    }
};
