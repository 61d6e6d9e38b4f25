/// A mass on a spring that stiffens and another one behind it; nothing is between the two that could hold a force.
///
/// # Equations of motion
///
/// ```text
/// m*ddot(x) = -stiff*(x - joint)
///     - stiff*((soft + stiff)*joint + hard*joint^3 - stiff*x)/(soft + stiff + 3*hard*joint^2)
/// 0 = soft*joint + hard*joint^3 - stiff*(x - joint)
/// ```
///
/// # State and structure
///
/// - State: `[x, x_dot]`.
/// - Mass matrix: diagonal, constant.
/// - Conserved: the energy function.
/// - Separable: explicit symplectic methods take it.
/// - Forward dynamics: each equation divided by its entry of the mass matrix.
/// - Cost of `acceleration`: 6 additions, 9 multiplications, 2 divisions, 1 function.
pub struct SeriesSprings {
    /// Parameter `m`.
    pub m: ::core::primitive::f64,
    /// Parameter `soft`.
    pub soft: ::core::primitive::f64,
    /// Parameter `hard`.
    pub hard: ::core::primitive::f64,
    /// Parameter `stiff`.
    pub stiff: ::core::primitive::f64,
}
/// State of [`SeriesSprings`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SeriesSpringsState {
    /// Coordinate `x`.
    pub x: ::core::primitive::f64,
    /// Velocity of `x`.
    pub x_dot: ::core::primitive::f64,
}
/// Columns of a table of states of [`SeriesSprings`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct SeriesSpringsColumns<C>(C);
/// Equations of [`SeriesSprings`] for numbers side by side, with parameters of as many motions.
///
/// An evaluation takes 6 additions, 9 multiplications, 2 divisions, 1 function.
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct SeriesSpringsLanes<S> {
    /// Parameter `m`.
    pub m: S,
    /// Parameter `soft`.
    pub soft: S,
    /// Parameter `hard`.
    pub hard: S,
    /// Parameter `stiff`.
    pub stiff: S,
}
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::{abs, multiply_add};
    /// Solution `joint` of `0 = (joint - x)*stiff + joint^3*hard + joint*soft` by Newton's method; NaN if it finds none.
    #[inline(always)]
    fn solve_joint<S: ::lagrange::Number>(soft: S, hard: S, x: S, stiff: S) -> S {
        ::lagrange::root::newton(
            x,
            50,
            |joint| {
                let joint_sq = joint * joint;
                let joint_minus_x = joint - x;
                let pos_0 = multiply_add(joint_sq * joint, hard, joint * soft);
                let pos_1 = multiply_add(
                    S::from_f64(3.0) * joint_sq,
                    hard,
                    soft + stiff,
                );
                let abs_joint = abs(joint);
                let abs_joint_sq = abs_joint * abs_joint;
                let pos_2 = S::from_f64(2.0) * abs(stiff) * abs(joint_minus_x);
                let pos_3 = multiply_add(abs(hard), abs_joint_sq * abs_joint, pos_2);
                [
                    multiply_add(joint_minus_x, stiff, pos_0),
                    pos_1,
                    multiply_add(
                        abs_joint,
                        abs(pos_1),
                        multiply_add(abs_joint, abs(soft), pos_3),
                    ),
                ]
            },
        )
    }
    impl SeriesSprings {
        /// The equations of motion in LaTeX, one line for each coordinate after the definitions of
        /// abbreviations, if they need any.
        pub const EQUATIONS_LATEX: &'static ::core::primitive::str = "m \\ddot{x} = -\\mathrm{stiff} \\left(x - \\mathrm{joint}\\right) - \\frac{\\mathrm{stiff} \\left(\\left(\\mathrm{soft} + \\mathrm{stiff}\\right) \\mathrm{joint} + \\mathrm{hard} \\mathrm{joint}^{3} - \\mathrm{stiff} x\\right)}{\\mathrm{soft} + \\mathrm{stiff} + 3 \\mathrm{hard} \\mathrm{joint}^{2}}\n0 = \\mathrm{soft} \\mathrm{joint} + \\mathrm{hard} \\mathrm{joint}^{3} - \\mathrm{stiff} \\left(x - \\mathrm{joint}\\right)";
        /// Parameters, then inputs: the columns of `parameter_jacobian`.
        pub const PARAMETERS: [&'static ::core::primitive::str; 4] = [
            "m",
            "soft",
            "hard",
            "stiff",
        ];
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 6 additions, 9 multiplications, 2 divisions, 1 function.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let Self { m, soft, hard, stiff } = *self;
            let [x] = *q;
            let joint = solve_joint(soft, hard, x, stiff);
            let pos_0 = stiff * (x - joint);
            let joint_sq = joint * joint;
            let pos_1 = multiply_add(
                -soft,
                joint,
                multiply_add(-hard, joint_sq * joint, pos_0),
            );
            let forcing_0 = stiff * pos_1
                / multiply_add(3.0 * hard, joint_sq, soft + stiff) - pos_0;
            let x_ddot = 1.0 / m * forcing_0;
            [x_ddot]
        }
        /// Mass matrix M, in rows.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f64, q: &[f64; 1]) -> [[f64; 1]; 1] {
            let Self { m, .. } = *self;
            [[m]]
        }
        /// Right-hand side f of M q̈ = f.
        ///
        /// Takes 6 additions, 8 multiplications, 1 division, 1 function.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let Self { soft, hard, stiff, .. } = *self;
            let [x] = *q;
            let joint = solve_joint(soft, hard, x, stiff);
            let pos_0 = stiff * (x - joint);
            let joint_sq = joint * joint;
            let pos_1 = multiply_add(
                -soft,
                joint,
                multiply_add(-hard, joint_sq * joint, pos_0),
            );
            let forcing_0 = stiff * pos_1
                / multiply_add(3.0 * hard, joint_sq, soft + stiff) - pos_0;
            [forcing_0]
        }
        /// Generalised momenta ∂L/∂v.
        ///
        /// Takes 1 multiplication.
        #[must_use]
        #[inline]
        pub fn momenta(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let Self { m, .. } = *self;
            let [x_dot] = *v;
            [m * x_dot]
        }
        /// Kinetic energy T.
        ///
        /// Takes 3 multiplications.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            let Self { m, .. } = *self;
            let [x_dot] = *v;
            let x_dot_sq = x_dot * x_dot;
            0.5 * m * x_dot_sq
        }
        /// Potential energy V.
        ///
        /// Takes 3 additions, 8 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, q: &[f64; 1]) -> f64 {
            let Self { soft, hard, stiff, .. } = *self;
            let [x] = *q;
            let joint = solve_joint(soft, hard, x, stiff);
            let joint_sq = joint * joint;
            let x_minus_joint = x - joint;
            let x_minus_joint_sq = x_minus_joint * x_minus_joint;
            let joint_pow4 = joint_sq * joint_sq;
            let pos_0 = 0.5 * multiply_add(stiff, x_minus_joint_sq, soft * joint_sq);
            multiply_add(0.25 * hard, joint_pow4, pos_0)
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 4 additions, 10 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            let Self { m, soft, hard, stiff } = *self;
            let [x] = *q;
            let [x_dot] = *v;
            let x_dot_sq = x_dot * x_dot;
            let joint = solve_joint(soft, hard, x, stiff);
            let joint_sq = joint * joint;
            let x_minus_joint = x - joint;
            let x_minus_joint_sq = x_minus_joint * x_minus_joint;
            let vel_0 = multiply_add(soft, joint_sq, m * x_dot_sq);
            let joint_pow4 = joint_sq * joint_sq;
            let vel_1 = 0.5 * multiply_add(stiff, x_minus_joint_sq, vel_0);
            multiply_add(0.25 * hard, joint_pow4, vel_1)
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 7 additions, 9 multiplications, 1 division, 1 function.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            q: &[f64; 1],
            v: &[f64; 1],
            a: &[f64; 1],
        ) -> [f64; 1] {
            let Self { m, soft, hard, stiff } = *self;
            let [x] = *q;
            let [x_ddot] = *a;
            let joint = solve_joint(soft, hard, x, stiff);
            let pos_0 = stiff * (x - joint);
            let joint_sq = joint * joint;
            let pos_1 = multiply_add(
                -soft,
                joint,
                multiply_add(-hard, joint_sq * joint, pos_0),
            );
            let pos_2 = pos_0
                - stiff * pos_1 / multiply_add(3.0 * hard, joint_sq, soft + stiff);
            [multiply_add(m, x_ddot, pos_2)]
        }
        /// Jacobian of `rhs`, in rows: entry `[i][j]` is the derivative of its entry `i` by entry `j`
        /// of the state.
        ///
        /// Takes 10 additions, 20 multiplications, 2 divisions, 1 function.
        #[must_use]
        #[inline]
        pub fn jacobian(&self, t: f64, y: &[f64; 2]) -> [[f64; 2]; 2] {
            let Self { m, soft, hard, stiff } = *self;
            let [x, _] = *y;
            let joint = solve_joint(soft, hard, x, stiff);
            let joint_sq = joint * joint;
            let pos_0 = hard * joint_sq * 3.0;
            let inv_0 = 1.0 / (soft + stiff + pos_0);
            let pos_1 = stiff * inv_0;
            let pos_2 = stiff * (pos_1 - 1.0);
            let pos_3 = multiply_add(pos_0, pos_1, multiply_add(soft, pos_1, pos_2));
            let pos_4 = multiply_add(-hard, joint_sq * joint, stiff * (x - joint));
            let inv_0_sq = inv_0 * inv_0;
            let pos_5 = 6.0 * hard * stiff * multiply_add(-soft, joint, pos_4) * pos_1
                * joint;
            [
                [0.0, 1.0],
                [
                    1.0 / m
                        * multiply_add(
                            -pos_5,
                            inv_0_sq,
                            multiply_add(-pos_1, pos_3, pos_2),
                        ),
                    0.0,
                ],
            ]
        }
        /// Derivatives of `rhs` by the fields in the order of `PARAMETERS`, in rows: entry `[i][j]`
        /// is that of its entry `i` by field `j`.
        ///
        /// Takes 25 additions, 45 multiplications, 2 divisions, 1 function.
        #[must_use]
        #[inline]
        pub fn parameter_jacobian(&self, t: f64, y: &[f64; 2]) -> [[f64; 4]; 2] {
            let Self { m, soft, hard, stiff } = *self;
            let [x, _] = *y;
            let joint = solve_joint(soft, hard, x, stiff);
            let joint_sq = joint * joint;
            let pos_0 = hard * joint_sq * 3.0;
            let inv_0 = 1.0 / (soft + stiff + pos_0);
            let pos_1 = stiff * inv_0;
            let x_minus_joint = x - joint;
            let pos_2 = stiff * x_minus_joint;
            let joint_sq_joint = joint_sq * joint;
            let pos_3 = multiply_add(
                -soft,
                joint,
                multiply_add(-hard, joint_sq_joint, pos_2),
            );
            let forcing_0 = multiply_add(pos_1, pos_3, -pos_2);
            let inv_m = 1.0 / m;
            let inv_m_sq = inv_m * inv_m;
            let pos_4 = joint * inv_0;
            let pos_5 = stiff * pos_4;
            let hard_joint = hard * joint;
            let inv_0_sq = inv_0 * inv_0;
            let pos_6 = stiff * inv_0_sq;
            let pos_7 = multiply_add(
                -pos_3 * pos_6,
                multiply_add(6.0 * pos_4, hard_joint, -1.0),
                pos_5,
            );
            let pos_8 = multiply_add(
                pos_0,
                pos_4,
                multiply_add(soft, pos_4, pos_5 - joint),
            );
            let pos_9 = joint_sq_joint * inv_0;
            let pos_10 = stiff * pos_9;
            let pos_11 = multiply_add(
                pos_0,
                pos_9,
                multiply_add(soft, pos_9, pos_10 - joint_sq_joint),
            );
            let pos_12 = multiply_add(-2.0 * pos_9, hard_joint, joint_sq);
            let pos_13 = multiply_add(
                3.0 * pos_3 * pos_6,
                pos_12,
                multiply_add(-pos_1, pos_11, pos_10),
            );
            let pos_14 = x_minus_joint * inv_0;
            let pos_15 = multiply_add(-stiff, pos_14, x_minus_joint);
            let pos_16 = multiply_add(
                -pos_6,
                multiply_add(6.0 * pos_14, hard_joint, 1.0),
                inv_0,
            );
            let pos_17 = multiply_add(
                -pos_0,
                pos_14,
                multiply_add(-soft, pos_14, pos_15),
            );
            [
                [0.0, 0.0, 0.0, 0.0],
                [
                    -inv_m_sq * forcing_0,
                    -inv_m * multiply_add(-pos_1, pos_8, pos_7),
                    -inv_m * pos_13,
                    -inv_m
                        * multiply_add(
                            -pos_1,
                            pos_17,
                            multiply_add(-pos_3, pos_16, pos_15),
                        ),
                ],
            ]
        }
        /// Output `tension`.
        ///
        /// Takes 1 addition, 1 multiplication, 1 function.
        #[must_use]
        #[inline]
        pub fn tension(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            let Self { soft, hard, stiff, .. } = *self;
            let [x] = *q;
            let joint = solve_joint(soft, hard, x, stiff);
            stiff * (x - joint)
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, y: &[f64; 2]) -> [f64; 2] {
            let [x, x_dot] = *y;
            let a = self.acceleration(t, &[x], &[x_dot]);
            [x_dot, a[0]]
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for SeriesSprings {
        fn default() -> Self {
            Self {
                m: 1.0,
                soft: 20.0,
                hard: 50.0,
                stiff: 100.0,
            }
        }
    }
    impl SeriesSpringsState {
        /// The coordinates in their order.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [f64; 1] {
            [self.x]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [f64; 1] {
            [self.x_dot]
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 2]> for SeriesSpringsState {
        #[inline]
        fn from([x, x_dot]: [f64; 2]) -> Self {
            Self { x, x_dot }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<SeriesSpringsState> for [f64; 2] {
        #[inline]
        fn from(state: SeriesSpringsState) -> Self {
            [state.x, state.x_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> SeriesSpringsColumns<C> {
        /// Coordinate `x`.
        #[must_use]
        #[inline]
        pub fn x(&self) -> &[C::Scalar] {
            self.0.column(0)
        }
        /// Velocity of `x`.
        #[must_use]
        #[inline]
        pub fn x_dot(&self) -> &[C::Scalar] {
            self.0.column(1)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for SeriesSpringsColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for SeriesSpringsColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for SeriesSprings {
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
            let found = ::lagrange::integrate::undefined(
                self,
                (t, y, rates),
                &[],
                |q, _| ::core::option::Option::Some(self.mass_matrix(t, q)),
            )?;
            let (q, v) = ::lagrange::system::split::<Self>(y);
            let (q, v) = (&q, &v);
            ::core::option::Option::Some(
                found
                    .with_unknowns(
                        t,
                        &{
                            let Self { soft, hard, stiff, .. } = *self;
                            let [x] = *q;
                            let joint = solve_joint(soft, hard, x, stiff);
                            [("joint", joint)]
                        },
                    ),
            )
        }
        #[inline]
        fn jacobian(
            &self,
            t: f64,
            y: &[f64; 2],
        ) -> ::core::option::Option<[[f64; 2]; 2]> {
            ::core::option::Option::Some(self.jacobian(t, y))
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::MechanicalSystem for SeriesSprings {
        type Coordinates = [f64; 1];
        type Velocities = [f64; 1];
        type Columns<C> = SeriesSpringsColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &["x"];
        const FINGERPRINT: ::core::primitive::u64 = 12157355281214247698;
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
                ("soft", self.soft),
                ("hard", self.hard),
                ("stiff", self.stiff),
            ]
                .get(index)
                .copied()
        }
        #[inline]
        fn with_lanes<V: ::lagrange::system::LanesVisitor<Self>>(
            visitor: V,
        ) -> ::core::result::Result<V::Output, V> {
            ::core::result::Result::Ok(visitor.visit())
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for SeriesSprings {
        type NamedState = SeriesSpringsState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for SeriesSprings {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            self.energy(t, q, v)
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::SeparableSystem for SeriesSprings {}
    #[automatically_derived]
    impl ::lagrange::system::OutputSystem for SeriesSprings {
        type Outputs = [f64; 1];
        const OUTPUTS: &'static [&'static ::core::primitive::str] = &["tension"];
        #[inline]
        fn outputs(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let output_0 = self.tension(t, q, v);
            [output_0]
        }
    }
    #[automatically_derived]
    impl<S: ::lagrange::Number> ::lagrange::system::Equations<S>
    for SeriesSpringsLanes<S> {
        type State = [S; 2];
        #[inline(always)]
        fn rhs(&self, t: S, y: &[S; 2]) -> [S; 2] {
            let Self { m, soft, hard, stiff } = *self;
            let [x, x_dot] = *y;
            let joint = solve_joint(soft, hard, x, stiff);
            let pos_0 = stiff * (x - joint);
            let joint_sq = joint * joint;
            let pos_1 = multiply_add(
                -soft,
                joint,
                multiply_add(-hard, joint_sq * joint, pos_0),
            );
            let pos_2 = stiff * pos_1
                / multiply_add(S::from_f64(3.0) * hard, joint_sq, soft + stiff);
            let forcing_0 = pos_2 - pos_0;
            let x_ddot = S::ONE / m * forcing_0;
            [x_dot, x_ddot]
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::LanesSystem for SeriesSprings {
        type Lanes<L: ::lagrange::Number> = SeriesSpringsLanes<L>;
        fn lanes<L: ::lagrange::Number>(
            &self,
            splat: impl ::core::ops::Fn(f64) -> L,
        ) -> SeriesSpringsLanes<L> {
            SeriesSpringsLanes {
                m: splat(self.m),
                soft: splat(self.soft),
                hard: splat(self.hard),
                stiff: splat(self.stiff),
            }
        }
        fn set_lane<L: ::lagrange::system::SideBySide<Element = f64>>(
            &self,
            lanes: &mut SeriesSpringsLanes<L>,
            lane: ::core::primitive::usize,
        ) {
            ::lagrange::system::SideBySide::set_lane(&mut lanes.m, lane, self.m);
            ::lagrange::system::SideBySide::set_lane(&mut lanes.soft, lane, self.soft);
            ::lagrange::system::SideBySide::set_lane(&mut lanes.hard, lane, self.hard);
            ::lagrange::system::SideBySide::set_lane(&mut lanes.stiff, lane, self.stiff);
        }
    }
};
