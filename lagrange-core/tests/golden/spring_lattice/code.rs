/// Masses on a square of springs, of which the upper two hang from fixed points: arrays, grids, loops and sums.
///
/// # Equations of motion
///
/// ```text
/// m_0_0*ddot(u_0_0) = m_0_0*g - 3*k*u_0_0 + k*u_0_1 + k*u_1_0
/// m_0_1*ddot(u_0_1) = m_0_1*g + k*u_0_0 - 3*k*u_0_1 + k*u_1_1
/// m_1_0*ddot(u_1_0) = pull_0 + m_1_0*g + k*(u_0_0 - u_1_0) - k*(u_1_0 - u_1_1)
/// m_1_1*ddot(u_1_1) = pull_1 + m_1_1*g + k*(u_0_1 - u_1_1) + k*(u_1_0 - u_1_1)
/// ```
///
/// # State and structure
///
/// - State: `[u_0_0, u_0_1, u_1_0, u_1_1, u_0_0_dot, u_0_1_dot, u_1_0_dot, u_1_1_dot]`.
/// - Mass matrix: diagonal, constant.
/// - Separable: explicit symplectic methods take it.
/// - Forward dynamics: each equation divided by its entry of the mass matrix.
/// - Cost of `acceleration`: 16 additions, 14 multiplications, 4 divisions.
pub struct SpringLattice {
    /// Masses.
    pub m: [[::core::primitive::f64; 2]; 2],
    /// Masses.
    pub k: ::core::primitive::f64,
    /// Masses.
    pub g: ::core::primitive::f64,
    /// Inputs `pull`.
    pub pull: [::core::primitive::f64; 2],
}
/// State of [`SpringLattice`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SpringLatticeState {
    /// Elongations.
    pub u: [[::core::primitive::f64; 2]; 2],
    /// Velocities of `u`.
    pub u_dot: [[::core::primitive::f64; 2]; 2],
}
/// Columns of a table of states of [`SpringLattice`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct SpringLatticeColumns<C>(C);
/// Inputs of [`SpringLattice`].
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct SpringLatticeInputs {
    /// Inputs `pull`.
    pub pull: [::core::primitive::f64; 2],
}
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::multiply_add;
    impl SpringLattice {
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 16 additions, 14 multiplications, 4 divisions.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 4], v: &[f64; 4]) -> [f64; 4] {
            let Self {
                m: [[m_0_0,
                m_0_1,
                ],
                [m_1_0,
                m_1_1,
                ],
                ],
                k,
                g,
                pull: [pull_0,
                pull_1,
                ],
            } = *self;
            let [u_0_0, u_0_1, u_1_0, u_1_1] = *q;
            let pos_0 = k * (u_0_0 - u_1_0);
            let pos_1 = k * (u_0_0 - u_0_1);
            let forcing_0 = multiply_add(
                -k,
                u_0_0,
                multiply_add(m_0_0, g, -pos_0) - pos_1,
            );
            let u_0_0_ddot = 1.0 / m_0_0 * forcing_0;
            let pos_2 = k * (u_0_1 - u_1_1);
            let forcing_1 = multiply_add(
                m_0_1,
                g,
                multiply_add(-k, u_0_1, pos_1 - pos_2),
            );
            let u_0_1_ddot = 1.0 / m_0_1 * forcing_1;
            let pos_3 = k * (u_1_0 - u_1_1);
            let forcing_2 = multiply_add(m_1_0, g, pull_0 - pos_3 + pos_0);
            let u_1_0_ddot = 1.0 / m_1_0 * forcing_2;
            let forcing_3 = multiply_add(m_1_1, g, pull_1 + pos_3 + pos_2);
            let u_1_1_ddot = 1.0 / m_1_1 * forcing_3;
            [u_0_0_ddot, u_0_1_ddot, u_1_0_ddot, u_1_1_ddot]
        }
        /// Mass matrix M, in rows.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f64, q: &[f64; 4]) -> [[f64; 4]; 4] {
            let Self { m: [[m_0_0, m_0_1], [m_1_0, m_1_1]], .. } = *self;
            [
                [m_0_0, 0.0, 0.0, 0.0],
                [0.0, m_0_1, 0.0, 0.0],
                [0.0, 0.0, m_1_0, 0.0],
                [0.0, 0.0, 0.0, m_1_1],
            ]
        }
        /// Right-hand side f of M q̈ = f.
        ///
        /// Takes 16 additions, 10 multiplications.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: f64, q: &[f64; 4], v: &[f64; 4]) -> [f64; 4] {
            let Self {
                m: [[m_0_0,
                m_0_1,
                ],
                [m_1_0,
                m_1_1,
                ],
                ],
                k,
                g,
                pull: [pull_0,
                pull_1,
                ],
            } = *self;
            let [u_0_0, u_0_1, u_1_0, u_1_1] = *q;
            let pos_0 = k * (u_0_0 - u_1_0);
            let pos_1 = k * (u_0_0 - u_0_1);
            let forcing_0 = multiply_add(
                -k,
                u_0_0,
                multiply_add(m_0_0, g, -pos_0) - pos_1,
            );
            let pos_2 = k * (u_0_1 - u_1_1);
            let forcing_1 = multiply_add(
                m_0_1,
                g,
                multiply_add(-k, u_0_1, pos_1 - pos_2),
            );
            let pos_3 = k * (u_1_0 - u_1_1);
            let forcing_2 = multiply_add(m_1_0, g, pull_0 - pos_3 + pos_0);
            let forcing_3 = multiply_add(m_1_1, g, pull_1 + pos_3 + pos_2);
            [forcing_0, forcing_1, forcing_2, forcing_3]
        }
        /// Generalised momenta ∂L/∂v.
        ///
        /// Takes 4 multiplications.
        #[must_use]
        #[inline]
        pub fn momenta(&self, t: f64, q: &[f64; 4], v: &[f64; 4]) -> [f64; 4] {
            let Self { m: [[m_0_0, m_0_1], [m_1_0, m_1_1]], .. } = *self;
            let [u_0_0_dot, u_0_1_dot, u_1_0_dot, u_1_1_dot] = *v;
            [m_0_0 * u_0_0_dot, m_0_1 * u_0_1_dot, m_1_0 * u_1_0_dot, m_1_1 * u_1_1_dot]
        }
        /// Kinetic energy T.
        ///
        /// Takes 3 additions, 9 multiplications.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: f64, q: &[f64; 4], v: &[f64; 4]) -> f64 {
            let Self { m: [[m_0_0, m_0_1], [m_1_0, m_1_1]], .. } = *self;
            let [u_0_0_dot, u_0_1_dot, u_1_0_dot, u_1_1_dot] = *v;
            let u_0_0_dot_sq = u_0_0_dot * u_0_0_dot;
            let u_0_1_dot_sq = u_0_1_dot * u_0_1_dot;
            let u_1_0_dot_sq = u_1_0_dot * u_1_0_dot;
            let vel_0 = multiply_add(m_0_1, u_0_1_dot_sq, m_0_0 * u_0_0_dot_sq);
            let u_1_1_dot_sq = u_1_1_dot * u_1_1_dot;
            let vel_1 = multiply_add(
                m_1_1,
                u_1_1_dot_sq,
                multiply_add(m_1_0, u_1_0_dot_sq, vel_0),
            );
            0.5 * vel_1
        }
        /// Potential energy V.
        ///
        /// Takes 13 additions, 18 multiplications.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, q: &[f64; 4]) -> f64 {
            let Self { m: [[m_0_0, m_0_1], [m_1_0, m_1_1]], k, g, .. } = *self;
            let [u_0_0, u_0_1, u_1_0, u_1_1] = *q;
            let u_0_0_sq = u_0_0 * u_0_0;
            let u_0_1_sq = u_0_1 * u_0_1;
            let u_0_0_minus_u_0_1 = u_0_0 - u_0_1;
            let u_0_0_minus_u_0_1_sq = u_0_0_minus_u_0_1 * u_0_0_minus_u_0_1;
            let u_0_0_minus_u_1_0 = u_0_0 - u_1_0;
            let u_0_0_minus_u_1_0_sq = u_0_0_minus_u_1_0 * u_0_0_minus_u_1_0;
            let pos_0 = multiply_add(
                k,
                u_0_0_minus_u_0_1_sq,
                multiply_add(k, u_0_1_sq, k * u_0_0_sq),
            );
            let u_0_1_minus_u_1_1 = u_0_1 - u_1_1;
            let u_0_1_minus_u_1_1_sq = u_0_1_minus_u_1_1 * u_0_1_minus_u_1_1;
            let pos_1 = multiply_add(k, u_0_0_minus_u_1_0_sq, pos_0);
            let u_1_0_minus_u_1_1 = u_1_0 - u_1_1;
            let u_1_0_minus_u_1_1_sq = u_1_0_minus_u_1_1 * u_1_0_minus_u_1_1;
            let pos_2 = multiply_add(k, u_0_1_minus_u_1_1_sq, pos_1);
            let pos_3 = multiply_add(
                m_1_0,
                u_1_0,
                multiply_add(m_0_1, u_0_1, m_0_0 * u_0_0),
            );
            let pos_4 = 0.5 * multiply_add(k, u_1_0_minus_u_1_1_sq, pos_2);
            multiply_add(-g, multiply_add(m_1_1, u_1_1, pos_3), pos_4)
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 17 additions, 26 multiplications.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 4], v: &[f64; 4]) -> f64 {
            let Self { m: [[m_0_0, m_0_1], [m_1_0, m_1_1]], k, g, .. } = *self;
            let [u_0_0, u_0_1, u_1_0, u_1_1] = *q;
            let [u_0_0_dot, u_0_1_dot, u_1_0_dot, u_1_1_dot] = *v;
            let u_0_0_dot_sq = u_0_0_dot * u_0_0_dot;
            let u_0_1_dot_sq = u_0_1_dot * u_0_1_dot;
            let u_1_0_dot_sq = u_1_0_dot * u_1_0_dot;
            let vel_0 = multiply_add(m_0_1, u_0_1_dot_sq, m_0_0 * u_0_0_dot_sq);
            let u_1_1_dot_sq = u_1_1_dot * u_1_1_dot;
            let u_0_0_sq = u_0_0 * u_0_0;
            let vel_1 = multiply_add(
                m_1_1,
                u_1_1_dot_sq,
                multiply_add(m_1_0, u_1_0_dot_sq, vel_0),
            );
            let u_0_1_sq = u_0_1 * u_0_1;
            let u_0_0_minus_u_0_1 = u_0_0 - u_0_1;
            let u_0_0_minus_u_0_1_sq = u_0_0_minus_u_0_1 * u_0_0_minus_u_0_1;
            let vel_2 = multiply_add(k, u_0_1_sq, multiply_add(k, u_0_0_sq, vel_1));
            let u_0_0_minus_u_1_0 = u_0_0 - u_1_0;
            let u_0_0_minus_u_1_0_sq = u_0_0_minus_u_1_0 * u_0_0_minus_u_1_0;
            let vel_3 = multiply_add(k, u_0_0_minus_u_0_1_sq, vel_2);
            let u_0_1_minus_u_1_1 = u_0_1 - u_1_1;
            let u_0_1_minus_u_1_1_sq = u_0_1_minus_u_1_1 * u_0_1_minus_u_1_1;
            let vel_4 = multiply_add(k, u_0_0_minus_u_1_0_sq, vel_3);
            let u_1_0_minus_u_1_1 = u_1_0 - u_1_1;
            let u_1_0_minus_u_1_1_sq = u_1_0_minus_u_1_1 * u_1_0_minus_u_1_1;
            let vel_5 = multiply_add(k, u_0_1_minus_u_1_1_sq, vel_4);
            let pos_0 = multiply_add(
                m_1_0,
                u_1_0,
                multiply_add(m_0_1, u_0_1, m_0_0 * u_0_0),
            );
            let vel_6 = 0.5 * multiply_add(k, u_1_0_minus_u_1_1_sq, vel_5);
            multiply_add(-g, multiply_add(m_1_1, u_1_1, pos_0), vel_6)
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 20 additions, 14 multiplications.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            q: &[f64; 4],
            v: &[f64; 4],
            a: &[f64; 4],
        ) -> [f64; 4] {
            let Self {
                m: [[m_0_0,
                m_0_1,
                ],
                [m_1_0,
                m_1_1,
                ],
                ],
                k,
                g,
                pull: [pull_0,
                pull_1,
                ],
            } = *self;
            let [u_0_0, u_0_1, u_1_0, u_1_1] = *q;
            let [u_0_0_ddot, u_0_1_ddot, u_1_0_ddot, u_1_1_ddot] = *a;
            let pos_0 = k * (u_0_0 - u_0_1);
            let pos_1 = k * (u_0_0 - u_1_0);
            let pos_2 = multiply_add(-m_0_0, g, multiply_add(k, u_0_0, pos_1 + pos_0));
            let pos_3 = k * (u_0_1 - u_1_1);
            let pos_4 = multiply_add(-m_0_1, g, multiply_add(k, u_0_1, pos_3 - pos_0));
            let pos_5 = k * (u_1_0 - u_1_1);
            [
                multiply_add(m_0_0, u_0_0_ddot, pos_2),
                multiply_add(m_0_1, u_0_1_ddot, pos_4),
                multiply_add(
                    m_1_0,
                    u_1_0_ddot,
                    multiply_add(-m_1_0, g, pos_5 - pull_0 - pos_1),
                ),
                multiply_add(
                    -m_1_1,
                    g,
                    multiply_add(m_1_1, u_1_1_ddot, -pull_1) - pos_5 - pos_3,
                ),
            ]
        }
        /// Output `mean`.
        ///
        /// Takes 3 additions, 1 multiplication.
        #[must_use]
        #[inline]
        pub fn mean(&self, t: f64, q: &[f64; 4], v: &[f64; 4]) -> f64 {
            let [u_0_0, u_0_1, u_1_0, u_1_1] = *q;
            0.25 * (u_0_0 + u_0_1 + u_1_0 + u_1_1)
        }
        /// Output `row_1`.
        #[must_use]
        #[inline]
        pub fn row_1(&self, t: f64, q: &[f64; 4], v: &[f64; 4]) -> [f64; 2] {
            let [_, _, u_1_0, u_1_1] = *q;
            [u_1_0, u_1_1]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, y: &[f64; 8]) -> [f64; 8] {
            let [u_0_0, u_0_1, u_1_0, u_1_1, u_0_0_dot, u_0_1_dot, u_1_0_dot, u_1_1_dot,
            ] = *y;
            let a = self
                .acceleration(
                    t,
                    &[u_0_0, u_0_1, u_1_0, u_1_1],
                    &[u_0_0_dot, u_0_1_dot, u_1_0_dot, u_1_1_dot],
                );
            [u_0_0_dot, u_0_1_dot, u_1_0_dot, u_1_1_dot, a[0], a[1], a[2], a[3]]
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for SpringLattice {
        fn default() -> Self {
            Self {
                m: [[1.0, 2.0], [3.0, 4.0]],
                k: 50.0,
                g: 9.81,
                pull: [0.0, 0.0],
            }
        }
    }
    impl SpringLatticeState {
        /// The coordinates in their order.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [f64; 4] {
            [self.u[0][0], self.u[0][1], self.u[1][0], self.u[1][1]]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [f64; 4] {
            [self.u_dot[0][0], self.u_dot[0][1], self.u_dot[1][0], self.u_dot[1][1]]
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 8]> for SpringLatticeState {
        #[inline]
        fn from(
            [u_0_0,
            u_0_1,
            u_1_0,
            u_1_1,
            u_0_0_dot,
            u_0_1_dot,
            u_1_0_dot,
            u_1_1_dot,
            ]: [f64; 8],
        ) -> Self {
            Self {
                u: [[u_0_0, u_0_1], [u_1_0, u_1_1]],
                u_dot: [[u_0_0_dot, u_0_1_dot], [u_1_0_dot, u_1_1_dot]],
            }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<SpringLatticeState> for [f64; 8] {
        #[inline]
        fn from(state: SpringLatticeState) -> Self {
            [
                state.u[0][0],
                state.u[0][1],
                state.u[1][0],
                state.u[1][1],
                state.u_dot[0][0],
                state.u_dot[0][1],
                state.u_dot[1][0],
                state.u_dot[1][1],
            ]
        }
    }
    impl<C: ::lagrange::system::Columns> SpringLatticeColumns<C> {
        /// Coordinates `u`.
        ///
        /// # Panics
        ///
        /// If an index is out of range.
        #[must_use]
        #[inline]
        pub fn u(
            &self,
            index: ::core::primitive::usize,
            index_2: ::core::primitive::usize,
        ) -> &[C::Scalar] {
            self.0
                .column({
                    ::core::assert!(
                        index < 2 && index_2 < 2, "an index is out of range"
                    );
                    0 + (index) * 2 + index_2
                })
        }
        /// Velocities of `u`.
        ///
        /// # Panics
        ///
        /// If an index is out of range.
        #[must_use]
        #[inline]
        pub fn u_dot(
            &self,
            index: ::core::primitive::usize,
            index_2: ::core::primitive::usize,
        ) -> &[C::Scalar] {
            self.0
                .column({
                    ::core::assert!(
                        index < 2 && index_2 < 2, "an index is out of range"
                    );
                    4 + (index) * 2 + index_2
                })
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for SpringLatticeColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for SpringLatticeColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for SpringLattice {
        type Scalar = f64;
        type State = [f64; 8];
        #[inline]
        fn rhs(&self, t: f64, y: &[f64; 8]) -> [f64; 8] {
            self.rhs(t, y)
        }
        fn undefined(
            &self,
            t: f64,
            y: &[f64; 8],
            rates: &[f64; 8],
        ) -> ::core::option::Option<::lagrange::system::Undefined<f64>> {
            ::lagrange::integrate::undefined(
                self,
                (t, y, rates),
                &[("pull[0]", self.pull[0]), ("pull[1]", self.pull[1])],
                |q, _| ::core::option::Option::Some(self.mass_matrix(t, q)),
            )
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::MechanicalSystem for SpringLattice {
        type Coordinates = [f64; 4];
        type Velocities = [f64; 4];
        type Columns<C> = SpringLatticeColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &[
            "u[0][0]",
            "u[0][1]",
            "u[1][0]",
            "u[1][1]",
        ];
        const FINGERPRINT: ::core::primitive::u64 = 312477746585671471;
        #[inline]
        fn acceleration(&self, t: f64, q: &[f64; 4], v: &[f64; 4]) -> [f64; 4] {
            self.acceleration(t, q, v)
        }
        #[inline]
        fn position_rates(&self, _: f64, _: &[f64; 4], v: &[f64; 4]) -> [f64; 4] {
            *v
        }
        fn parameter(
            &self,
            index: ::core::primitive::usize,
        ) -> ::core::option::Option<(&'static ::core::primitive::str, f64)> {
            [
                ("m[0][0]", self.m[0][0]),
                ("m[0][1]", self.m[0][1]),
                ("m[1][0]", self.m[1][0]),
                ("m[1][1]", self.m[1][1]),
                ("k", self.k),
                ("g", self.g),
            ]
                .get(index)
                .copied()
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for SpringLattice {
        type NamedState = SpringLatticeState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for SpringLattice {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 4], v: &[f64; 4]) -> f64 {
            self.energy(t, q, v)
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::SeparableSystem for SpringLattice {}
    #[automatically_derived]
    impl ::core::convert::From<[f64; 2]> for SpringLatticeInputs {
        #[inline]
        fn from([pull_0, pull_1]: [f64; 2]) -> Self {
            Self { pull: [pull_0, pull_1] }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<SpringLatticeInputs> for [f64; 2] {
        #[inline]
        fn from(inputs: SpringLatticeInputs) -> Self {
            [inputs.pull[0], inputs.pull[1]]
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::ControlledSystem for SpringLattice {
        type Inputs = SpringLatticeInputs;
        type InputVector = [f64; 2];
        const INPUTS: &'static [&'static ::core::primitive::str] = &[
            "pull[0]",
            "pull[1]",
        ];
        #[inline]
        fn inputs(&self) -> SpringLatticeInputs {
            SpringLatticeInputs {
                pull: self.pull,
            }
        }
        #[inline]
        fn with_inputs(&self, inputs: SpringLatticeInputs) -> Self {
            Self {
                pull: inputs.pull,
                m: self.m,
                k: self.k,
                g: self.g,
            }
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OutputSystem for SpringLattice {
        type Outputs = [f64; 3];
        const OUTPUTS: &'static [&'static ::core::primitive::str] = &[
            "mean",
            "row[1].x",
            "row[1].y",
        ];
        #[inline]
        fn outputs(&self, t: f64, q: &[f64; 4], v: &[f64; 4]) -> [f64; 3] {
            let output_0 = self.mean(t, q, v);
            let [output_1, output_2] = self.row_1(t, q, v);
            [output_0, output_1, output_2]
        }
    }
};
/// Reduced from [`SpringLattice`]: `u_0_0 = 0`, `u_0_1 = 0` frozen.
///
/// # Equations of motion
///
/// ```text
/// m_1_0*ddot(u_1_0) = pull_0 + m_1_0*g - k*u_1_0 - k*(u_1_0 - u_1_1)
/// m_1_1*ddot(u_1_1) = pull_1 + m_1_1*g - k*u_1_1 + k*(u_1_0 - u_1_1)
/// ```
///
/// # State and structure
///
/// - State: `[u_1_0, u_1_1, u_1_0_dot, u_1_1_dot]`.
/// - Mass matrix: diagonal, constant.
/// - Separable: explicit symplectic methods take it.
/// - Forward dynamics: each equation divided by its entry of the mass matrix.
/// - Cost of `acceleration`: 7 additions, 7 multiplications, 2 divisions.
pub struct Half {
    /// Masses.
    pub m: [[::core::primitive::f64; 2]; 2],
    /// Masses.
    pub k: ::core::primitive::f64,
    /// Masses.
    pub g: ::core::primitive::f64,
    /// Inputs `pull`.
    pub pull: [::core::primitive::f64; 2],
}
/// State of [`Half`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct HalfState {
    /// Elongations.
    pub u_1_0: ::core::primitive::f64,
    /// Elongations.
    pub u_1_1: ::core::primitive::f64,
    /// Velocity of `u_1_0`.
    pub u_1_0_dot: ::core::primitive::f64,
    /// Velocity of `u_1_1`.
    pub u_1_1_dot: ::core::primitive::f64,
}
/// Columns of a table of states of [`Half`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct HalfColumns<C>(C);
/// Inputs of [`Half`].
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct HalfInputs {
    /// Inputs `pull`.
    pub pull: [::core::primitive::f64; 2],
}
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::multiply_add;
    impl Half {
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 7 additions, 7 multiplications, 2 divisions.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let Self { m: [[_, _], [m_1_0, m_1_1]], k, g, pull: [pull_0, pull_1] } = *self;
            let [u_1_0, u_1_1] = *q;
            let pos_0 = k * (u_1_0 - u_1_1);
            let forcing_0 = multiply_add(
                m_1_0,
                g,
                multiply_add(-k, u_1_0, pull_0) - pos_0,
            );
            let u_1_0_ddot = 1.0 / m_1_0 * forcing_0;
            let forcing_1 = multiply_add(
                m_1_1,
                g,
                multiply_add(-k, u_1_1, pull_1) + pos_0,
            );
            let u_1_1_ddot = 1.0 / m_1_1 * forcing_1;
            [u_1_0_ddot, u_1_1_ddot]
        }
        /// Mass matrix M, in rows.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f64, q: &[f64; 2]) -> [[f64; 2]; 2] {
            let Self { m: [[_, _], [m_1_0, m_1_1]], .. } = *self;
            [[m_1_0, 0.0], [0.0, m_1_1]]
        }
        /// Right-hand side f of M q̈ = f.
        ///
        /// Takes 7 additions, 5 multiplications.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let Self { m: [[_, _], [m_1_0, m_1_1]], k, g, pull: [pull_0, pull_1] } = *self;
            let [u_1_0, u_1_1] = *q;
            let pos_0 = k * (u_1_0 - u_1_1);
            let forcing_0 = multiply_add(
                m_1_0,
                g,
                multiply_add(-k, u_1_0, pull_0) - pos_0,
            );
            let forcing_1 = multiply_add(
                m_1_1,
                g,
                multiply_add(-k, u_1_1, pull_1) + pos_0,
            );
            [forcing_0, forcing_1]
        }
        /// Generalised momenta ∂L/∂v.
        ///
        /// Takes 2 multiplications.
        #[must_use]
        #[inline]
        pub fn momenta(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let Self { m: [[_, _], [m_1_0, m_1_1]], .. } = *self;
            let [u_1_0_dot, u_1_1_dot] = *v;
            [m_1_0 * u_1_0_dot, m_1_1 * u_1_1_dot]
        }
        /// Kinetic energy T.
        ///
        /// Takes 1 addition, 5 multiplications.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
            let Self { m: [[_, _], [m_1_0, m_1_1]], .. } = *self;
            let [u_1_0_dot, u_1_1_dot] = *v;
            let u_1_0_dot_sq = u_1_0_dot * u_1_0_dot;
            let u_1_1_dot_sq = u_1_1_dot * u_1_1_dot;
            0.5 * multiply_add(m_1_1, u_1_1_dot_sq, m_1_0 * u_1_0_dot_sq)
        }
        /// Potential energy V.
        ///
        /// Takes 5 additions, 10 multiplications.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, q: &[f64; 2]) -> f64 {
            let Self { m: [[_, _], [m_1_0, m_1_1]], k, g, .. } = *self;
            let [u_1_0, u_1_1] = *q;
            let u_1_0_minus_u_1_1 = u_1_0 - u_1_1;
            let u_1_0_minus_u_1_1_sq = u_1_0_minus_u_1_1 * u_1_0_minus_u_1_1;
            let u_1_0_sq = u_1_0 * u_1_0;
            let u_1_1_sq = u_1_1 * u_1_1;
            let pos_0 = multiply_add(
                k,
                u_1_1_sq,
                multiply_add(k, u_1_0_sq, k * u_1_0_minus_u_1_1_sq),
            );
            multiply_add(-g, multiply_add(m_1_1, u_1_1, m_1_0 * u_1_0), 0.5 * pos_0)
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 7 additions, 14 multiplications.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
            let Self { m: [[_, _], [m_1_0, m_1_1]], k, g, .. } = *self;
            let [u_1_0, u_1_1] = *q;
            let [u_1_0_dot, u_1_1_dot] = *v;
            let u_1_0_dot_sq = u_1_0_dot * u_1_0_dot;
            let u_1_1_dot_sq = u_1_1_dot * u_1_1_dot;
            let u_1_0_minus_u_1_1 = u_1_0 - u_1_1;
            let u_1_0_minus_u_1_1_sq = u_1_0_minus_u_1_1 * u_1_0_minus_u_1_1;
            let vel_0 = multiply_add(m_1_1, u_1_1_dot_sq, m_1_0 * u_1_0_dot_sq);
            let u_1_0_sq = u_1_0 * u_1_0;
            let u_1_1_sq = u_1_1 * u_1_1;
            let vel_1 = multiply_add(
                k,
                u_1_0_sq,
                multiply_add(k, u_1_0_minus_u_1_1_sq, vel_0),
            );
            let pos_0 = multiply_add(m_1_1, u_1_1, m_1_0 * u_1_0);
            multiply_add(-g, pos_0, 0.5 * multiply_add(k, u_1_1_sq, vel_1))
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 9 additions, 7 multiplications.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            q: &[f64; 2],
            v: &[f64; 2],
            a: &[f64; 2],
        ) -> [f64; 2] {
            let Self { m: [[_, _], [m_1_0, m_1_1]], k, g, pull: [pull_0, pull_1] } = *self;
            let [u_1_0, u_1_1] = *q;
            let [u_1_0_ddot, u_1_1_ddot] = *a;
            let pos_0 = k * (u_1_0 - u_1_1);
            let pos_1 = multiply_add(-m_1_0, g, multiply_add(k, u_1_0, -pull_0) + pos_0);
            let pos_2 = multiply_add(-m_1_1, g, multiply_add(k, u_1_1, -pull_1) - pos_0);
            [
                multiply_add(m_1_0, u_1_0_ddot, pos_1),
                multiply_add(m_1_1, u_1_1_ddot, pos_2),
            ]
        }
        /// Output `mean`.
        ///
        /// Takes 1 addition, 1 multiplication.
        #[must_use]
        #[inline]
        pub fn mean(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
            let [u_1_0, u_1_1] = *q;
            0.25 * (u_1_0 + u_1_1)
        }
        /// Output `row_1`.
        #[must_use]
        #[inline]
        pub fn row_1(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 2] {
            let [u_1_0, u_1_1] = *q;
            [u_1_0, u_1_1]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, y: &[f64; 4]) -> [f64; 4] {
            let [u_1_0, u_1_1, u_1_0_dot, u_1_1_dot] = *y;
            let a = self.acceleration(t, &[u_1_0, u_1_1], &[u_1_0_dot, u_1_1_dot]);
            [u_1_0_dot, u_1_1_dot, a[0], a[1]]
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for Half {
        fn default() -> Self {
            Self {
                m: [[1.0, 2.0], [3.0, 4.0]],
                k: 50.0,
                g: 9.81,
                pull: [0.0, 0.0],
            }
        }
    }
    impl HalfState {
        /// The coordinates in their order.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [f64; 2] {
            [self.u_1_0, self.u_1_1]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [f64; 2] {
            [self.u_1_0_dot, self.u_1_1_dot]
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 4]> for HalfState {
        #[inline]
        fn from([u_1_0, u_1_1, u_1_0_dot, u_1_1_dot]: [f64; 4]) -> Self {
            Self {
                u_1_0,
                u_1_1,
                u_1_0_dot,
                u_1_1_dot,
            }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<HalfState> for [f64; 4] {
        #[inline]
        fn from(state: HalfState) -> Self {
            [state.u_1_0, state.u_1_1, state.u_1_0_dot, state.u_1_1_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> HalfColumns<C> {
        /// Coordinate `u_1_0`.
        #[must_use]
        #[inline]
        pub fn u_1_0(&self) -> &[C::Scalar] {
            self.0.column(0)
        }
        /// Coordinate `u_1_1`.
        #[must_use]
        #[inline]
        pub fn u_1_1(&self) -> &[C::Scalar] {
            self.0.column(1)
        }
        /// Velocity of `u_1_0`.
        #[must_use]
        #[inline]
        pub fn u_1_0_dot(&self) -> &[C::Scalar] {
            self.0.column(2)
        }
        /// Velocity of `u_1_1`.
        #[must_use]
        #[inline]
        pub fn u_1_1_dot(&self) -> &[C::Scalar] {
            self.0.column(3)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for HalfColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for HalfColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for Half {
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
                &[("pull[0]", self.pull[0]), ("pull[1]", self.pull[1])],
                |q, _| ::core::option::Option::Some(self.mass_matrix(t, q)),
            )
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::MechanicalSystem for Half {
        type Coordinates = [f64; 2];
        type Velocities = [f64; 2];
        type Columns<C> = HalfColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &[
            "u[1][0]",
            "u[1][1]",
        ];
        const FINGERPRINT: ::core::primitive::u64 = 9119656166495325480;
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
                ("m[0][0]", self.m[0][0]),
                ("m[0][1]", self.m[0][1]),
                ("m[1][0]", self.m[1][0]),
                ("m[1][1]", self.m[1][1]),
                ("k", self.k),
                ("g", self.g),
            ]
                .get(index)
                .copied()
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for Half {
        type NamedState = HalfState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for Half {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
            self.energy(t, q, v)
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::SeparableSystem for Half {}
    #[automatically_derived]
    impl ::core::convert::From<[f64; 2]> for HalfInputs {
        #[inline]
        fn from([pull_0, pull_1]: [f64; 2]) -> Self {
            Self { pull: [pull_0, pull_1] }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<HalfInputs> for [f64; 2] {
        #[inline]
        fn from(inputs: HalfInputs) -> Self {
            [inputs.pull[0], inputs.pull[1]]
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::ControlledSystem for Half {
        type Inputs = HalfInputs;
        type InputVector = [f64; 2];
        const INPUTS: &'static [&'static ::core::primitive::str] = &[
            "pull[0]",
            "pull[1]",
        ];
        #[inline]
        fn inputs(&self) -> HalfInputs {
            HalfInputs { pull: self.pull }
        }
        #[inline]
        fn with_inputs(&self, inputs: HalfInputs) -> Self {
            Self {
                pull: inputs.pull,
                m: self.m,
                k: self.k,
                g: self.g,
            }
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OutputSystem for Half {
        type Outputs = [f64; 3];
        const OUTPUTS: &'static [&'static ::core::primitive::str] = &[
            "mean",
            "row[1].x",
            "row[1].y",
        ];
        #[inline]
        fn outputs(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> [f64; 3] {
            let output_0 = self.mean(t, q, v);
            let [output_1, output_2] = self.row_1(t, q, v);
            [output_0, output_1, output_2]
        }
    }
};
const _: () = {
    use ::core::primitive::f64;
    #[automatically_derived]
    impl ::core::convert::From<&SpringLattice> for Half {
        #[inline]
        fn from(system: &SpringLattice) -> Self {
            Self {
                m: system.m,
                k: system.k,
                g: system.g,
                pull: system.pull,
            }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<&Half> for SpringLattice {
        #[inline]
        fn from(system: &Half) -> Self {
            Self {
                m: system.m,
                k: system.k,
                g: system.g,
                pull: system.pull,
            }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<SpringLatticeState> for HalfState {
        #[inline]
        fn from(state: SpringLatticeState) -> Self {
            Self {
                u_1_0: state.u[1][0],
                u_1_1: state.u[1][1],
                u_1_0_dot: state.u_dot[1][0],
                u_1_1_dot: state.u_dot[1][1],
            }
        }
    }
    impl Half {
        /// The state of [`SpringLattice`] that belongs to a state of this system:
        /// frozen coordinates have their values, and no velocity.
        #[must_use]
        #[inline]
        pub fn expand(&self, state: HalfState) -> SpringLatticeState {
            SpringLatticeState {
                u: [[0.0, 0.0], [state.u_1_0, state.u_1_1]],
                u_dot: [[0.0, 0.0], [state.u_1_0_dot, state.u_1_1_dot]],
            }
        }
        /// How far a state of [`SpringLattice`] is from those that this system stands for:
        /// differences from their values for coordinates that are frozen or small, their velocities, and
        /// zero for everything else. What is frozen is lost in the reduced state; of what is small, the
        /// third power is neglected in energies.
        #[must_use]
        #[inline]
        pub fn deviation(&self, state: SpringLatticeState) -> SpringLatticeState {
            SpringLatticeState {
                u: [[state.u[0][0], state.u[0][1]], [0.0, 0.0]],
                u_dot: [[state.u_dot[0][0], state.u_dot[0][1]], [0.0, 0.0]],
            }
        }
    }
};
