/// A wheel on a road from a table, driven by a motor with a measured torque, in air whose drag is a table of two arguments.
///
/// # Equations of motion
///
/// ```text
/// (m + m*road'(s)^2 + j/r^2)*ddot(s) = throttle*motor(dot(s)/r)/r - m*road'(s)*road''(s)*dot(s)^2
///     - brake(dot(s)) - drag(dot(s), road(s)) - m*g*road'(s)
/// ```
///
/// # State and structure
///
/// - State: `[s, s_dot]`.
/// - Mass matrix: diagonal, depends on the configuration.
/// - Forward dynamics: each equation divided by its entry of the mass matrix.
/// - Cost of `acceleration`: 6 additions, 13 multiplications, 2 divisions, 6 functions.
pub struct DrivenWheel {
    /// Parameter `m`.
    pub m: ::core::primitive::f64,
    /// Parameter `j`.
    pub j: ::core::primitive::f64,
    /// Parameter `r`.
    pub r: ::core::primitive::f64,
    /// Parameter `g`.
    pub g: ::core::primitive::f64,
    /// Input `throttle`.
    pub throttle: ::core::primitive::f64,
}
/// State of [`DrivenWheel`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct DrivenWheelState {
    /// Coordinate `s`.
    pub s: ::core::primitive::f64,
    /// Velocity of `s`.
    pub s_dot: ::core::primitive::f64,
}
/// Columns of a table of states of [`DrivenWheel`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct DrivenWheelColumns<C>(C);
/// Inputs of [`DrivenWheel`].
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct DrivenWheelInputs {
    /// Input `throttle`.
    pub throttle: ::core::primitive::f64,
}
::lagrange::private::bring_hints! {}
#[allow(clippy::approx_constant, reason = "constants are rounded to the scalar once")]
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::multiply_add;
    static BRAKE: ::lagrange::table::Curve<2> = ::lagrange::table::Curve {
        axis: ::lagrange::table::Axis {
            knots: &[-2.0, 0.0, 1.0, 5.0],
            density: 0.0,
        },
        pieces: &[[1.0, 0.0], [1.0, -0.5], [0.0, 0.5], [0.5, 0.125], [1.0, 0.0]],
    };
    /// Table: `brake`.
    #[inline]
    fn brake<S: ::lagrange::Number>(rate: S) -> S {
        BRAKE.value(rate)
    }
    /// Table: the derivative of `brake`.
    #[inline]
    fn brake_derivative<S: ::lagrange::Number>(rate: S) -> S {
        BRAKE.derivative(1, rate)
    }
    static DRAG: ::lagrange::table::Surface<2> = ::lagrange::table::Surface {
        axes: [
            ::lagrange::table::Axis {
                knots: &[0.0, 10.0, 30.0],
                density: 0.0,
            },
            ::lagrange::table::Axis {
                knots: &[-1.0, 1.0],
                density: 0.5,
            },
        ],
        pieces: &[
            [[::core::primitive::f64::NAN; 2]; 2],
            [[::core::primitive::f64::NAN; 2]; 2],
            [[::core::primitive::f64::NAN; 2]; 2],
            [[::core::primitive::f64::NAN; 2]; 2],
            [[0.0, 0.0], [0.3, -0.025]],
            [[::core::primitive::f64::NAN; 2]; 2],
            [[::core::primitive::f64::NAN; 2]; 2],
            [[3.0, -0.25], [1.1, -0.0625]],
            [[::core::primitive::f64::NAN; 2]; 2],
            [[::core::primitive::f64::NAN; 2]; 2],
            [[::core::primitive::f64::NAN; 2]; 2],
            [[::core::primitive::f64::NAN; 2]; 2],
        ],
    };
    /// Table: `drag`.
    #[inline]
    fn drag<S: ::lagrange::Number>(speed: S, height: S) -> S {
        DRAG.value(speed, height)
    }
    /// Table: the derivative of `drag` by `height`.
    #[inline]
    fn drag_by_height<S: ::lagrange::Number>(speed: S, height: S) -> S {
        DRAG.derivative([0, 1], [speed, height])
    }
    /// Table: the derivative of `drag` by `speed`.
    #[inline]
    fn drag_by_speed<S: ::lagrange::Number>(speed: S, height: S) -> S {
        DRAG.derivative([1, 0], [speed, height])
    }
    static MOTOR: ::lagrange::table::Curve<4> = ::lagrange::table::Curve {
        axis: ::lagrange::table::Axis {
            knots: &[0.0, 100.0, 200.0, 300.0],
            density: 0.01,
        },
        pieces: &[
            [90.0, 0.0, 0.0, 0.0],
            [90.0, 0.5, 0.005, -5e-5],
            [140.0, 0.0, -0.0020000000000000005, 0.0],
            [120.0, -0.4, -0.003999999999999998, 1.9999999999999995e-5],
            [60.0, 0.0, 0.0, 0.0],
        ],
    };
    /// Table: `motor`.
    #[inline]
    fn motor<S: ::lagrange::Number>(rate: S) -> S {
        MOTOR.value(rate)
    }
    /// Table: the derivative of `motor`.
    #[inline]
    fn motor_derivative<S: ::lagrange::Number>(rate: S) -> S {
        MOTOR.derivative(1, rate)
    }
    static ROAD: ::lagrange::table::Curve<4> = ::lagrange::table::Curve {
        axis: ::lagrange::table::Axis {
            knots: &[0.0, 3.0, 8.0, 14.0, 20.0],
            density: 0.0,
        },
        pieces: &[
            [0.0, 0.17203795379537956, 0.0, 0.0],
            [0.0, 0.17203795379537956, 0.0, -0.0043005133846718],
            [0.4, 0.0559240924092409, -0.03870462046204621, 0.0031039603960396045],
            [0.1, -0.09832508250825081, 0.007854785478547848, 3.323248991565891e-5],
            [-0.2, -0.0004785478547854882, 0.008452970297029705, -0.0004696094609460946],
            [0.0, 0.05023927392739275, 0.0, 0.0],
        ],
    };
    /// Table: `road`.
    #[inline]
    fn road<S: ::lagrange::Number>(s: S) -> S {
        ROAD.value(s)
    }
    /// Table: the derivative of `road`.
    #[inline]
    fn road_derivative<S: ::lagrange::Number>(s: S) -> S {
        ROAD.derivative(1, s)
    }
    /// Table: the second derivative of `road`.
    #[inline]
    fn road_second_derivative<S: ::lagrange::Number>(s: S) -> S {
        ROAD.derivative(2, s)
    }
    /// Table: the third derivative of `road`.
    #[inline]
    fn road_third_derivative<S: ::lagrange::Number>(s: S) -> S {
        ROAD.derivative(3, s)
    }
    impl DrivenWheel {
        /// Parameters, then inputs: the columns of `parameter_jacobian`.
        pub const PARAMETERS: [&'static ::core::primitive::str; 5] = [
            "m",
            "j",
            "r",
            "g",
            "throttle",
        ];
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 6 additions, 13 multiplications, 2 divisions, 6 functions.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let Self { m, j, r, g, throttle } = *self;
            let [s] = *q;
            let [s_dot] = *v;
            let inv_r = 1.0 / r;
            let height = road(s);
            let vel_0 = multiply_add(
                inv_r * throttle,
                motor(inv_r * s_dot),
                -brake(s_dot),
            );
            let road_derivative_s = road_derivative(s);
            let s_dot_sq = s_dot * s_dot;
            let vel_1 = multiply_add(
                -m * g,
                road_derivative_s,
                vel_0 - drag(s_dot, height),
            );
            let forcing_0 = multiply_add(
                -m * road_derivative_s * road_second_derivative(s),
                s_dot_sq,
                vel_1,
            );
            let inv_r_sq = inv_r * inv_r;
            let road_derivative_s_sq = road_derivative_s * road_derivative_s;
            let m_0_0 = multiply_add(
                m,
                road_derivative_s_sq,
                multiply_add(j, inv_r_sq, m),
            );
            let s_ddot = forcing_0 / m_0_0;
            [s_ddot]
        }
        /// Mass matrix M, in rows.
        ///
        /// Takes 2 additions, 3 multiplications, 1 division, 1 function.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f64, q: &[f64; 1]) -> [[f64; 1]; 1] {
            let Self { m, j, r, .. } = *self;
            let [s] = *q;
            let r_sq = r * r;
            let road_derivative_s = road_derivative(s);
            let road_derivative_s_sq = road_derivative_s * road_derivative_s;
            let m_0_0 = multiply_add(m, road_derivative_s_sq, m + j / r_sq);
            [[m_0_0]]
        }
        /// Right-hand side f of M q̈ = f.
        ///
        /// Takes 4 additions, 9 multiplications, 1 division, 6 functions.
        #[must_use]
        #[inline]
        pub fn forcing(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let Self { m, r, g, throttle, .. } = *self;
            let [s] = *q;
            let [s_dot] = *v;
            let inv_r = 1.0 / r;
            let height = road(s);
            let vel_0 = multiply_add(
                inv_r * throttle,
                motor(inv_r * s_dot),
                -brake(s_dot),
            );
            let road_derivative_s = road_derivative(s);
            let s_dot_sq = s_dot * s_dot;
            let vel_1 = multiply_add(
                -m * g,
                road_derivative_s,
                vel_0 - drag(s_dot, height),
            );
            let forcing_0 = multiply_add(
                -m * road_derivative_s * road_second_derivative(s),
                s_dot_sq,
                vel_1,
            );
            [forcing_0]
        }
        /// Generalised momenta ∂L/∂v.
        ///
        /// Takes 2 additions, 7 multiplications, 1 division, 1 function.
        #[must_use]
        #[inline]
        pub fn momenta(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
            let Self { m, j, r, .. } = *self;
            let [s] = *q;
            let [s_dot] = *v;
            let inv_r = 1.0 / r;
            let road_derivative_s = road_derivative(s);
            let height_dot = road_derivative_s * s_dot;
            let vel_0 = multiply_add(m, s_dot, inv_r * j * inv_r * s_dot);
            [multiply_add(m * road_derivative_s, height_dot, vel_0)]
        }
        /// Kinetic energy T.
        ///
        /// Takes 2 additions, 8 multiplications, 1 division, 1 function.
        #[must_use]
        #[inline]
        pub fn kinetic_energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            let Self { m, j, r, .. } = *self;
            let [s] = *q;
            let [s_dot] = *v;
            let height_dot = road_derivative(s) * s_dot;
            let vel_0 = 1.0 / r * s_dot;
            let vel_0_sq = vel_0 * vel_0;
            let vel_1 = m * multiply_add(height_dot, height_dot, s_dot * s_dot);
            0.5 * multiply_add(j, vel_0_sq, vel_1)
        }
        /// Potential energy V.
        ///
        /// Takes 2 multiplications, 1 function.
        #[must_use]
        #[inline]
        pub fn potential_energy(&self, t: f64, q: &[f64; 1]) -> f64 {
            let Self { m, g, .. } = *self;
            let [s] = *q;
            let height = road(s);
            m * g * height
        }
        /// Energy function v·∂L/∂v − L.
        ///
        /// Takes 3 additions, 10 multiplications, 1 division, 2 functions.
        #[must_use]
        #[inline]
        pub fn energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            let Self { m, j, r, g, .. } = *self;
            let [s] = *q;
            let [s_dot] = *v;
            let height_dot = road_derivative(s) * s_dot;
            let vel_0 = 1.0 / r * s_dot;
            let vel_0_sq = vel_0 * vel_0;
            let vel_1 = m * multiply_add(height_dot, height_dot, s_dot * s_dot);
            let height = road(s);
            multiply_add(m * g, height, 0.5 * multiply_add(j, vel_0_sq, vel_1))
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 7 additions, 13 multiplications, 1 division, 6 functions.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            q: &[f64; 1],
            v: &[f64; 1],
            a: &[f64; 1],
        ) -> [f64; 1] {
            let Self { m, j, r, g, throttle } = *self;
            let [s] = *q;
            let [s_dot] = *v;
            let [s_ddot] = *a;
            let inv_r = 1.0 / r;
            let height = road(s);
            let vel_0 = multiply_add(
                -inv_r * throttle,
                motor(inv_r * s_dot),
                brake(s_dot),
            );
            let acc_0 = multiply_add(m, s_ddot, vel_0 + drag(s_dot, height));
            let road_derivative_s = road_derivative(s);
            let vel_1 = road_second_derivative(s) * s_dot * s_dot;
            let acc_1 = multiply_add(
                m,
                multiply_add(road_derivative_s, s_ddot, vel_1),
                m * g,
            );
            let acc_2 = multiply_add(inv_r * j * inv_r, s_ddot, acc_0);
            [multiply_add(road_derivative_s, acc_1, acc_2)]
        }
        /// Jacobian of `rhs`, in rows: entry `[i][j]` is the derivative of its entry `i` by entry `j`
        /// of the state.
        ///
        /// Takes 13 additions, 34 multiplications, 2 divisions, 11 functions.
        #[must_use]
        #[inline]
        pub fn jacobian(&self, t: f64, y: &[f64; 2]) -> [[f64; 2]; 2] {
            let Self { m, j, r, g, throttle } = *self;
            let [s, s_dot] = *y;
            let inv_r = 1.0 / r;
            let inv_r_s_dot = inv_r * s_dot;
            let height = road(s);
            let vel_0 = multiply_add(
                inv_r * throttle,
                motor(inv_r_s_dot),
                -brake(s_dot),
            );
            let road_derivative_s = road_derivative(s);
            let m_g = m * g;
            let road_second_derivative_s = road_second_derivative(s);
            let s_dot_sq = s_dot * s_dot;
            let vel_1 = multiply_add(
                -m_g,
                road_derivative_s,
                vel_0 - drag(s_dot, height),
            );
            let forcing_0 = multiply_add(
                -m * road_derivative_s * road_second_derivative_s,
                s_dot_sq,
                vel_1,
            );
            let inv_r_sq = inv_r * inv_r;
            let road_derivative_s_sq = road_derivative_s * road_derivative_s;
            let m_0_0 = multiply_add(
                m,
                road_derivative_s_sq,
                multiply_add(j, inv_r_sq, m),
            );
            let inv_m_0_0 = 1.0 / m_0_0;
            let const_0 = 2.0 * m;
            let inv_m_0_0_sq = inv_m_0_0 * inv_m_0_0;
            let pos_0 = const_0 * road_second_derivative_s * road_derivative_s
                * inv_m_0_0_sq;
            let vel_2 = road_derivative_s * drag_by_height(s_dot, height);
            let pos_1 = m * road_second_derivative_s * road_second_derivative_s;
            let vel_3 = multiply_add(m_g, road_second_derivative_s, vel_2);
            let pos_2 = m * road_third_derivative(s) * road_derivative_s;
            let vel_4 = multiply_add(
                pos_2,
                s_dot_sq,
                multiply_add(pos_1, s_dot_sq, vel_3),
            );
            let motor_derivative_inv_r_s_dot = motor_derivative(inv_r_s_dot);
            let drag_by_speed_s_dot = drag_by_speed(s_dot, height);
            let inv_r_sq_throttle = inv_r_sq * throttle;
            let vel_5 = multiply_add(
                -inv_r_sq_throttle,
                motor_derivative_inv_r_s_dot,
                drag_by_speed_s_dot,
            );
            let pos_3 = const_0 * road_derivative_s * road_second_derivative_s;
            [
                [0.0, 1.0],
                [
                    -multiply_add(inv_m_0_0, vel_4, pos_0 * forcing_0),
                    -inv_m_0_0
                        * multiply_add(pos_3, s_dot, vel_5 + brake_derivative(s_dot)),
                ],
            ]
        }
        /// Derivatives of `rhs` by the fields in the order of `PARAMETERS`, in rows: entry `[i][j]`
        /// is that of its entry `i` by field `j`.
        ///
        /// Takes 11 additions, 34 multiplications, 2 divisions, 7 functions.
        #[must_use]
        #[inline]
        pub fn parameter_jacobian(&self, t: f64, y: &[f64; 2]) -> [[f64; 5]; 2] {
            let Self { m, j, r, g, throttle } = *self;
            let [s, s_dot] = *y;
            let inv_r = 1.0 / r;
            let inv_r_s_dot = inv_r * s_dot;
            let motor_inv_r_s_dot = motor(inv_r_s_dot);
            let height = road(s);
            let vel_0 = multiply_add(inv_r * throttle, motor_inv_r_s_dot, -brake(s_dot));
            let road_derivative_s = road_derivative(s);
            let m_road_derivative_s = m * road_derivative_s;
            let road_second_derivative_s = road_second_derivative(s);
            let s_dot_sq = s_dot * s_dot;
            let vel_1 = multiply_add(
                -m * g,
                road_derivative_s,
                vel_0 - drag(s_dot, height),
            );
            let forcing_0 = multiply_add(
                -m_road_derivative_s * road_second_derivative_s,
                s_dot_sq,
                vel_1,
            );
            let inv_r_sq = inv_r * inv_r;
            let road_derivative_s_sq = road_derivative_s * road_derivative_s;
            let m_0_0 = multiply_add(
                m,
                road_derivative_s_sq,
                multiply_add(j, inv_r_sq, m),
            );
            let inv_m_0_0 = 1.0 / m_0_0;
            let inv_m_0_0_sq = inv_m_0_0 * inv_m_0_0;
            let vel_2 = inv_m_0_0_sq * forcing_0;
            let pos_0 = road_derivative_s * road_second_derivative_s;
            let vel_3 = multiply_add(pos_0, s_dot_sq, g * road_derivative_s);
            let inv_r_inv_r_sq = inv_r * inv_r_sq;
            let vel_4 = inv_r_sq * throttle * motor_inv_r_s_dot;
            let vel_5 = inv_r_inv_r_sq * throttle * s_dot;
            let vel_6 = 2.0 * j * inv_r_inv_r_sq * vel_2;
            let vel_7 = multiply_add(vel_5, motor_derivative(inv_r_s_dot), vel_4);
            [
                [0.0, 0.0, 0.0, 0.0, 0.0],
                [
                    -multiply_add(
                        inv_m_0_0,
                        vel_3,
                        (road_derivative_s_sq + 1.0) * vel_2,
                    ),
                    -inv_r_sq * vel_2,
                    multiply_add(-inv_m_0_0, vel_7, vel_6),
                    -m_road_derivative_s * inv_m_0_0,
                    inv_r * inv_m_0_0 * motor_inv_r_s_dot,
                ],
            ]
        }
        /// Rate of the state: velocities, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, y: &[f64; 2]) -> [f64; 2] {
            let [s, s_dot] = *y;
            let a = self.acceleration(t, &[s], &[s_dot]);
            [s_dot, a[0]]
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for DrivenWheel {
        fn default() -> Self {
            Self {
                m: 12.0,
                j: 0.4,
                r: 0.3,
                g: 9.81,
                throttle: 1.0,
            }
        }
    }
    impl DrivenWheelState {
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
    impl ::core::convert::From<[f64; 2]> for DrivenWheelState {
        #[inline]
        fn from([s, s_dot]: [f64; 2]) -> Self {
            Self { s, s_dot }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<DrivenWheelState> for [f64; 2] {
        #[inline]
        fn from(state: DrivenWheelState) -> Self {
            [state.s, state.s_dot]
        }
    }
    impl<C: ::lagrange::system::Columns> DrivenWheelColumns<C> {
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
    impl<C> ::core::convert::From<C> for DrivenWheelColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for DrivenWheelColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for DrivenWheel {
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
                &[("throttle", self.throttle)],
                |q, _| ::core::option::Option::Some(self.mass_matrix(t, q)),
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
    impl ::lagrange::system::MechanicalSystem for DrivenWheel {
        type Coordinates = [f64; 1];
        type Velocities = [f64; 1];
        type Columns<C> = DrivenWheelColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &["s"];
        const FINGERPRINT: ::core::primitive::u64 = 5091839350589530418;
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
            [("m", self.m), ("j", self.j), ("r", self.r), ("g", self.g)]
                .get(index)
                .copied()
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for DrivenWheel {
        type NamedState = DrivenWheelState;
    }
    #[automatically_derived]
    impl ::lagrange::system::EnergyFunction for DrivenWheel {
        #[inline]
        fn energy(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> f64 {
            self.energy(t, q, v)
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 1]> for DrivenWheelInputs {
        #[inline]
        fn from([throttle]: [f64; 1]) -> Self {
            Self { throttle }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<DrivenWheelInputs> for [f64; 1] {
        #[inline]
        fn from(inputs: DrivenWheelInputs) -> Self {
            [inputs.throttle]
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::ControlledSystem for DrivenWheel {
        type Inputs = DrivenWheelInputs;
        type InputVector = [f64; 1];
        const INPUTS: &'static [&'static ::core::primitive::str] = &["throttle"];
        #[inline]
        fn inputs(&self) -> DrivenWheelInputs {
            DrivenWheelInputs {
                throttle: self.throttle,
            }
        }
        #[inline]
        fn with_inputs(&self, inputs: DrivenWheelInputs) -> Self {
            Self {
                throttle: inputs.throttle,
                m: self.m,
                j: self.j,
                r: self.r,
                g: self.g,
            }
        }
    }
};
