/// A craft that carries a load on a ball joint.
///
/// # Equations of motion
///
/// M q̈ = f, too long to be written out; `mass_matrix` and `forcing` compute the two sides.
///
/// # State and structure
///
/// - State: `[craft_x, craft_y, craft_z, craft_qw, craft_qx, craft_qy, craft_qz, hook_qw, hook_qx, hook_qy, hook_qz, craft_vx, craft_vy, craft_vz, craft_wx, craft_wy, craft_wz, hook_wx, hook_wy, hook_wz]`.
/// - Mass matrix: full, depends on the configuration.
/// - Cyclic coordinates: `craft_x`, `craft_y`.
/// - Forward dynamics: eliminated body by body (counted cost 1127; factorised mass matrix 1262, the kinetic energy is no sum of squares).
/// - Cost of `acceleration`: 227 additions, 369 multiplications, 6 divisions.
///
/// # Statements
///
/// Those about rigid bodies stand for plain ones:
///
/// ```text
/// param m = 0.5, l = 0.4;
/// input thrust, roll;
/// coord craft_x, craft_y, craft_z;
/// quaternion craft;
/// velocity craft_vx = dot(craft_x);
/// velocity craft_vy = dot(craft_y);
/// velocity craft_vz = dot(craft_z);
/// let craft_R_x = (1 - 2 * (craft_qy^2 + craft_qz^2), 2 * (craft_qx * craft_qy - craft_qw * craft_qz), 2 * (craft_qx * craft_qz + craft_qw * craft_qy));
/// let craft_R_y = (2 * (craft_qy * craft_qx + craft_qw * craft_qz), 1 - 2 * (craft_qz^2 + craft_qx^2), 2 * (craft_qy * craft_qz - craft_qw * craft_qx));
/// let craft_R_z = (2 * (craft_qz * craft_qx - craft_qw * craft_qy), 2 * (craft_qz * craft_qy + craft_qw * craft_qx), 1 - 2 * (craft_qx^2 + craft_qy^2));
/// let craft_joint_v = (dot(craft_x), 0, 0);
/// let craft_joint_v_2 = (craft_joint_v.x, dot(craft_y), 0);
/// let craft_joint_v_3 = (craft_joint_v_2.x, craft_joint_v_2.y, dot(craft_z));
/// let craft_v = (craft_R_x.x * craft_joint_v_3.x + craft_R_y.x * craft_joint_v_3.y + craft_R_z.x * craft_joint_v_3.z, craft_R_x.y * craft_joint_v_3.x + craft_R_y.y * craft_joint_v_3.y + craft_R_z.y * craft_joint_v_3.z, craft_R_x.z * craft_joint_v_3.x + craft_R_y.z * craft_joint_v_3.y + craft_R_z.z * craft_joint_v_3.z);
/// let craft_T_translation = kinetic_energy(2, dot((craft_x, craft_y, craft_z)));
/// kinetic = craft_T_translation;
/// let craft_T_rotation = 1/2 * 0.02 * craft_wx^2 + 1/2 * 0.02 * craft_wy^2 + 1/2 * 0.03 * craft_wz^2;
/// kinetic = craft_T_rotation;
/// let craft_V = 2 * (9.81 * craft_z);
/// potential = craft_V;
/// quaternion hook;
/// let hook_R_x = (1 - 2 * (hook_qy^2 + hook_qz^2), 2 * (hook_qx * hook_qy - hook_qw * hook_qz), 2 * (hook_qx * hook_qz + hook_qw * hook_qy));
/// let hook_R_y = (2 * (hook_qy * hook_qx + hook_qw * hook_qz), 1 - 2 * (hook_qz^2 + hook_qx^2), 2 * (hook_qy * hook_qz - hook_qw * hook_qx));
/// let hook_R_z = (2 * (hook_qz * hook_qx - hook_qw * hook_qy), 2 * (hook_qz * hook_qy + hook_qw * hook_qx), 1 - 2 * (hook_qx^2 + hook_qy^2));
/// let load_joint_v = (craft_v.x - craft_wy * 0.1, craft_v.y + craft_wx * 0.1, craft_v.z);
/// let load_joint_origin = (craft_x - 0.1 * craft_R_x.z, craft_y - 0.1 * craft_R_y.z, craft_z - 0.1 * craft_R_z.z);
/// let load_carried_w = (hook_R_x.x * craft_wx + hook_R_y.x * craft_wy + hook_R_z.x * craft_wz, hook_R_x.y * craft_wx + hook_R_y.y * craft_wy + hook_R_z.y * craft_wz, hook_R_x.z * craft_wx + hook_R_y.z * craft_wy + hook_R_z.z * craft_wz);
/// let load_w = (load_carried_w.x + hook_wx, load_carried_w.y + hook_wy, load_carried_w.z + hook_wz);
/// let load_v = (hook_R_x.x * load_joint_v.x + hook_R_y.x * load_joint_v.y + hook_R_z.x * load_joint_v.z, hook_R_x.y * load_joint_v.x + hook_R_y.y * load_joint_v.y + hook_R_z.y * load_joint_v.z, hook_R_x.z * load_joint_v.x + hook_R_y.z * load_joint_v.y + hook_R_z.z * load_joint_v.z);
/// let load_z = (hook_R_x.z * craft_R_x.x + hook_R_y.z * craft_R_x.y + hook_R_z.z * craft_R_x.z, hook_R_x.z * craft_R_y.x + hook_R_y.z * craft_R_y.y + hook_R_z.z * craft_R_y.z, hook_R_x.z * craft_R_z.x + hook_R_y.z * craft_R_z.y + hook_R_z.z * craft_R_z.z);
/// dissipation = 1/2 * 0.01 * (hook_wx^2 + hook_wy^2 + hook_wz^2);
/// let load_center_v = (load_v.x - load_w.y * l, load_v.y + load_w.x * l, load_v.z);
/// let load_T_translation = kinetic_energy(m, load_center_v);
/// kinetic = load_T_translation;
/// let load_T_rotation = 1/2 * 0.001 * load_w.x^2 + 1/2 * 0.001 * load_w.y^2 + 1/2 * 0.001 * load_w.z^2;
/// kinetic = load_T_rotation;
/// let load_V = m * (9.81 * (load_joint_origin.z - l * load_z.z));
/// potential = load_V;
/// force (0, 0, thrust) along craft_v;
/// force craft_wx = roll;
/// emit { no kinetic_energy, no potential_energy, no energy, no momenta, no forcing }
/// let load_moment = (0, 0, -(m * l));
/// let load_J = (0.001 + m * l * l, 0.001 + m * l * l, 0.001);
/// let craft_joint_a = (ddot(craft_x), 0, 9.81);
/// let craft_joint_a_2 = (craft_joint_a.x, ddot(craft_y), 9.81);
/// let craft_joint_a_3 = (craft_joint_a_2.x, craft_joint_a_2.y, 9.81 + ddot(craft_z));
/// let craft_alpha = (dot(craft_wx) + (craft_wy * craft_wz - craft_wz * craft_wy), dot(craft_wy) + (craft_wz * craft_wx - craft_wx * craft_wz), dot(craft_wz) + (craft_wx * craft_wy - craft_wy * craft_wx));
/// let craft_a = (craft_R_x.x * craft_joint_a_3.x + craft_R_y.x * craft_joint_a_3.y + craft_R_z.x * craft_joint_a_3.z, craft_R_x.y * craft_joint_a_3.x + craft_R_y.y * craft_joint_a_3.y + craft_R_z.y * craft_joint_a_3.z, craft_R_x.z * craft_joint_a_3.x + craft_R_y.z * craft_joint_a_3.y + craft_R_z.z * craft_joint_a_3.z);
/// let craft_S = 1/2 * 2 * craft_joint_a_3.x^2 + 1/2 * 2 * craft_joint_a_3.y^2 + 1/2 * 2 * craft_joint_a_3.z^2;
/// let craft_w_squares = (craft_wx^2, craft_wy^2, craft_wz^2);
/// let craft_w_products = (craft_wy * craft_wz, craft_wz * craft_wx, craft_wx * craft_wy);
/// let craft_relative_x = (-(craft_w_squares.y + craft_w_squares.z), craft_w_products.z - craft_alpha.z, craft_w_products.y + craft_alpha.y);
/// let craft_relative_y = (craft_w_products.z + craft_alpha.z, -(craft_w_squares.z + craft_w_squares.x), craft_w_products.x - craft_alpha.x);
/// let craft_relative_z = (craft_w_products.y - craft_alpha.y, craft_w_products.x + craft_alpha.x, -(craft_w_squares.x + craft_w_squares.y));
/// let craft_S_2 = 1/2 * 0.02 * craft_alpha.x^2 + (0.03 - 0.02) * craft_w_products.x * craft_alpha.x + 1/2 * 0.02 * craft_alpha.y^2 + (0.02 - 0.03) * craft_w_products.y * craft_alpha.y + 1/2 * 0.03 * craft_alpha.z^2 + (0.02 - 0.02) * craft_w_products.z * craft_alpha.z;
/// let load_joint_a = (craft_a.x - craft_relative_x.z * 0.1, craft_a.y - craft_relative_y.z * 0.1, craft_a.z - craft_relative_z.z * 0.1);
/// let load_carried_alpha = (hook_R_x.x * craft_alpha.x + hook_R_y.x * craft_alpha.y + hook_R_z.x * craft_alpha.z, hook_R_x.y * craft_alpha.x + hook_R_y.y * craft_alpha.y + hook_R_z.y * craft_alpha.z, hook_R_x.z * craft_alpha.x + hook_R_y.z * craft_alpha.y + hook_R_z.z * craft_alpha.z);
/// let load_alpha = (load_carried_alpha.x + (dot(hook_wx) + (load_w.y * hook_wz - load_w.z * hook_wy)), load_carried_alpha.y + (dot(hook_wy) + (load_w.z * hook_wx - load_w.x * hook_wz)), load_carried_alpha.z + (dot(hook_wz) + (load_w.x * hook_wy - load_w.y * hook_wx)));
/// let load_a = (hook_R_x.x * load_joint_a.x + hook_R_y.x * load_joint_a.y + hook_R_z.x * load_joint_a.z, hook_R_x.y * load_joint_a.x + hook_R_y.y * load_joint_a.y + hook_R_z.y * load_joint_a.z, hook_R_x.z * load_joint_a.x + hook_R_y.z * load_joint_a.y + hook_R_z.z * load_joint_a.z);
/// let load_S = 1/2 * m * load_joint_a.x^2 + 1/2 * m * load_joint_a.y^2 + 1/2 * m * load_joint_a.z^2;
/// let load_w_squares = (load_w.x^2, load_w.y^2, load_w.z^2);
/// let load_w_products = (load_w.y * load_w.z, load_w.z * load_w.x, load_w.x * load_w.y);
/// let load_relative_x = (-(load_w_squares.y + load_w_squares.z), load_w_products.z - load_alpha.z, load_w_products.y + load_alpha.y);
/// let load_relative_y = (load_w_products.z + load_alpha.z, -(load_w_squares.z + load_w_squares.x), load_w_products.x - load_alpha.x);
/// let load_relative_z = (load_w_products.y - load_alpha.y, load_w_products.x + load_alpha.x, -(load_w_squares.x + load_w_squares.y));
/// let load_S_2 = load_a.x * (load_relative_x.z * load_moment.z) + load_a.y * (load_relative_y.z * load_moment.z) + load_a.z * (load_relative_z.z * load_moment.z) + 1/2 * load_J.x * load_alpha.x^2 + (0.001 - load_J.y) * load_w_products.x * load_alpha.x + 1/2 * load_J.y * load_alpha.y^2 + (load_J.x - 0.001) * load_w_products.y * load_alpha.y + 1/2 * 0.001 * load_alpha.z^2 + (load_J.y - load_J.x) * load_w_products.z * load_alpha.z;
/// gibbs = craft_S + craft_S_2 + load_S + load_S_2, for: craft_T_translation + craft_T_rotation - craft_V + (load_T_translation + load_T_rotation - load_V);
/// ```
pub struct FlyingPendulum {
    /// Parameter `m`.
    pub m: ::core::primitive::f64,
    /// Parameter `l`.
    pub l: ::core::primitive::f64,
    /// Input `thrust`.
    pub thrust: ::core::primitive::f64,
    /// Input `roll`.
    pub roll: ::core::primitive::f64,
}
/// State of [`FlyingPendulum`]: positions, then velocities.
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct FlyingPendulumState {
    /// Coordinate `craft_x`.
    pub craft_x: ::core::primitive::f64,
    /// Coordinate `craft_y`.
    pub craft_y: ::core::primitive::f64,
    /// Coordinate `craft_z`.
    pub craft_z: ::core::primitive::f64,
    /// Scalar part of a unit quaternion.
    pub craft_qw: ::core::primitive::f64,
    /// Component of the vector part of a unit quaternion.
    pub craft_qx: ::core::primitive::f64,
    /// Component of the vector part of a unit quaternion.
    pub craft_qy: ::core::primitive::f64,
    /// Component of the vector part of a unit quaternion.
    pub craft_qz: ::core::primitive::f64,
    /// How the load hangs.
    ///
    /// Scalar part of a unit quaternion.
    pub hook_qw: ::core::primitive::f64,
    /// How the load hangs.
    ///
    /// Component of the vector part of a unit quaternion.
    pub hook_qx: ::core::primitive::f64,
    /// How the load hangs.
    ///
    /// Component of the vector part of a unit quaternion.
    pub hook_qy: ::core::primitive::f64,
    /// How the load hangs.
    ///
    /// Component of the vector part of a unit quaternion.
    pub hook_qz: ::core::primitive::f64,
    /// Velocity of `craft_x`.
    pub craft_vx: ::core::primitive::f64,
    /// Velocity of `craft_y`.
    pub craft_vy: ::core::primitive::f64,
    /// Velocity of `craft_z`.
    pub craft_vz: ::core::primitive::f64,
    /// Component of an angular velocity along the turned axes, in rad/s.
    pub craft_wx: ::core::primitive::f64,
    /// Component of an angular velocity along the turned axes, in rad/s.
    pub craft_wy: ::core::primitive::f64,
    /// Component of an angular velocity along the turned axes, in rad/s.
    pub craft_wz: ::core::primitive::f64,
    /// How the load hangs.
    ///
    /// Component of an angular velocity along the turned axes, in rad/s.
    pub hook_wx: ::core::primitive::f64,
    /// How the load hangs.
    ///
    /// Component of an angular velocity along the turned axes, in rad/s.
    pub hook_wy: ::core::primitive::f64,
    /// How the load hangs.
    ///
    /// Component of an angular velocity along the turned axes, in rad/s.
    pub hook_wz: ::core::primitive::f64,
}
/// Columns of a table of states of [`FlyingPendulum`].
#[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug)]
pub struct FlyingPendulumColumns<C>(C);
/// Inputs of [`FlyingPendulum`].
#[derive(
    ::core::clone::Clone,
    ::core::marker::Copy,
    ::core::fmt::Debug,
    ::core::cmp::PartialEq
)]
pub struct FlyingPendulumInputs {
    /// Input `thrust`.
    pub thrust: ::core::primitive::f64,
    /// Input `roll`.
    pub roll: ::core::primitive::f64,
}
::lagrange::private::bring_hints! {}
const _: () = {
    use ::core::primitive::f64;
    use ::lagrange::private::multiply_add;
    impl FlyingPendulum {
        /// Accelerations in the order of the velocities.
        ///
        /// Takes 227 additions, 369 multiplications, 6 divisions.
        #[must_use]
        #[inline]
        pub fn acceleration(&self, t: f64, q: &[f64; 11], v: &[f64; 9]) -> [f64; 9] {
            let Self { m, l, thrust, roll } = *self;
            let [_, _, _, craft_qw, craft_qx, craft_qy, craft_qz, hook_qw, hook_qx,
            hook_qy, hook_qz] = *q;
            let [_, _, _, craft_wx, craft_wy, craft_wz, hook_wx, hook_wy, hook_wz] = *v;
            let hook_qx_sq = hook_qx * hook_qx;
            let hook_qz_sq = hook_qz * hook_qz;
            let hook_R_y_y = multiply_add(-2.0, hook_qz_sq + hook_qx_sq, 1.0);
            let m_l = m * l;
            let m_l_hook_R_y_y = m_l * hook_R_y_y;
            let l_sq = l * l;
            let m_l_sq = m * l_sq;
            let load_J_x = m_l_sq + 0.001;
            let inv_load_J_x = 1.0 / load_J_x;
            let pos_0 = inv_load_J_x * m_l_hook_R_y_y;
            let hook_qw_hook_qz = hook_qw * hook_qz;
            let hook_qx_hook_qy = hook_qx * hook_qy;
            let pos_1 = hook_qx_hook_qy + hook_qw_hook_qz;
            let pos_2 = m_l * pos_1;
            let pos_3 = inv_load_J_x * pos_2;
            let pos_4 = 4.0 * pos_2;
            let pos_5 = multiply_add(
                -pos_4,
                pos_3,
                multiply_add(-m_l_hook_R_y_y, pos_0, m),
            );
            let pos_6 = 0.01 * pos_5;
            let pivot_3 = pos_6 + 0.02;
            let inv_pivot_3 = 1.0 / pivot_3;
            let hook_qy_sq = hook_qy * hook_qy;
            let hook_R_x_x = multiply_add(-2.0, hook_qy_sq + hook_qz_sq, 1.0);
            let m_l_hook_R_x_x = m_l * hook_R_x_x;
            let pos_7 = inv_load_J_x * m_l_hook_R_x_x;
            let pos_8 = hook_qx_hook_qy - hook_qw_hook_qz;
            let pos_9 = m_l * pos_8;
            let pos_10 = inv_load_J_x * pos_9;
            let pos_11 = multiply_add(m_l_hook_R_y_y, pos_10, pos_2 * pos_7);
            let pos_12 = pos_11 * inv_pivot_3;
            let pos_13 = 4.0 * pos_9;
            let pos_14 = multiply_add(
                -pos_13,
                pos_10,
                multiply_add(-m_l_hook_R_x_x, pos_7, m),
            );
            let pos_15 = multiply_add(-0.04 * pos_11, pos_12, pos_14);
            let pos_16 = 0.01 * pos_15;
            let pivot_4 = pos_16 + 0.02;
            let inv_pivot_4 = 1.0 / pivot_4;
            let pos_17 = pos_5 * inv_pivot_3;
            let pos_18 = -0.02 * pos_11;
            let pos_19 = multiply_add(-pos_18, pos_17, -2.0 * pos_11);
            let pos_20 = pos_19 * inv_pivot_4;
            let pos_21 = pos_19 * pos_20;
            let pos_22 = multiply_add(-pos_6, pos_17, pos_5);
            let pos_23 = multiply_add(-0.04, pos_21, 4.0 * pos_22);
            let craft_qw_craft_qz = craft_qw * craft_qz;
            let craft_qx_craft_qy = craft_qx * craft_qy;
            let pos_24 = craft_qx_craft_qy - craft_qw_craft_qz;
            let pos_25 = pos_15 * inv_pivot_4;
            let pos_26 = pos_19 * pos_25;
            let pos_27 = multiply_add(-0.02, pos_26, 2.0 * pos_19);
            let craft_qz_sq = craft_qz * craft_qz;
            let craft_qy_sq = craft_qy * craft_qy;
            let craft_R_x_x = multiply_add(-2.0, craft_qy_sq + craft_qz_sq, 1.0);
            let hook_qw_hook_qy = hook_qw * hook_qy;
            let hook_qx_hook_qz = hook_qx * hook_qz;
            let pos_28 = hook_qx_hook_qz - hook_qw_hook_qy;
            let pos_29 = m_l * pos_28;
            let pos_30 = inv_load_J_x * pos_29;
            let hook_qw_hook_qx = hook_qw * hook_qx;
            let hook_qy_hook_qz = hook_qy * hook_qz;
            let pos_31 = hook_qy_hook_qz + hook_qw_hook_qx;
            let pos_32 = m_l * pos_31;
            let pos_33 = inv_load_J_x * pos_32;
            let pos_34 = multiply_add(-(-2.0 * m_l_hook_R_y_y), pos_33, pos_4 * pos_30);
            let pos_35 = pos_34 * inv_pivot_3;
            let pos_36 = multiply_add(-pos_13, pos_33, -2.0 * m_l_hook_R_x_x * pos_30);
            let pos_37 = multiply_add(pos_18, pos_35, pos_36);
            let pos_38 = pos_37 * pos_20;
            let pos_39 = multiply_add(-0.01 * pos_34, pos_17, pos_34);
            let pos_40 = multiply_add(0.02, pos_38, 2.0 * pos_39);
            let craft_qw_craft_qy = craft_qw * craft_qy;
            let craft_qx_craft_qz = craft_qx * craft_qz;
            let pos_41 = craft_qx_craft_qz + craft_qw_craft_qy;
            let pos_42 = 2.0 * pos_41;
            let pos_43 = multiply_add(
                -pos_42,
                pos_40,
                multiply_add(craft_R_x_x, pos_27, pos_24 * pos_23),
            );
            let pos_44 = multiply_add(-pos_16, pos_25, pos_15);
            let pos_45 = multiply_add(craft_R_x_x, pos_44, pos_24 * pos_27);
            let pos_46 = multiply_add(-0.01 * pos_37, pos_25, pos_37);
            let pos_47 = pos_41 * pos_46;
            let pos_48 = multiply_add(-craft_R_x_x, pos_46, pos_24 * pos_40);
            let pos_49 = pos_37 * inv_pivot_4;
            let pos_50 = multiply_add(
                -4.0,
                multiply_add(pos_32, pos_33, pos_29 * pos_30),
                m,
            );
            let pos_51 = multiply_add(
                -0.01,
                multiply_add(pos_37, pos_49, pos_34 * pos_35),
                pos_50,
            );
            let pos_52 = pos_41 * pos_51;
            let pos_53 = multiply_add(-4.0, pos_52, 2.0 * pos_48);
            let pos_54 = multiply_add(
                craft_R_x_x,
                multiply_add(2.0, pos_47, pos_45),
                pos_24 * pos_43,
            );
            let pivot_0 = multiply_add(-pos_41, pos_53, pos_54) + 2.0;
            let inv_pivot_0 = 1.0 / pivot_0;
            let pos_55 = multiply_add(4.0, pos_47, 2.0 * pos_45);
            let pos_56 = inv_pivot_0 * pos_55;
            let pos_57 = multiply_add(-0.02, pos_21, 2.0 * pos_22);
            let pos_58 = multiply_add(-0.01, pos_26, pos_19);
            let pos_59 = multiply_add(0.01, pos_38, pos_39);
            let pos_60 = multiply_add(
                -pos_42,
                pos_59,
                multiply_add(craft_R_x_x, pos_58, pos_24 * pos_57),
            );
            let pos_61 = multiply_add(-pos_60, pos_56, 2.0 * pos_58);
            let craft_qx_sq = craft_qx * craft_qx;
            let craft_R_y_y = multiply_add(-2.0, craft_qz_sq + craft_qx_sq, 1.0);
            let pos_62 = multiply_add(-pos_55, pos_56, 4.0 * pos_44);
            let pos_63 = craft_qx_craft_qy + craft_qw_craft_qz;
            let pos_64 = multiply_add(pos_53, pos_56, 4.0 * pos_46);
            let craft_qw_craft_qx = craft_qw * craft_qx;
            let craft_qy_craft_qz = craft_qy * craft_qz;
            let pos_65 = craft_qy_craft_qz - craft_qw_craft_qx;
            let pos_66 = multiply_add(
                pos_65,
                pos_64,
                multiply_add(pos_63, pos_62, craft_R_y_y * pos_61),
            );
            let pos_67 = inv_pivot_0 * pos_60;
            let pos_68 = multiply_add(-pos_53, pos_67, 2.0 * pos_59);
            let pos_69 = multiply_add(
                -0.01,
                pos_21,
                multiply_add(-pos_60, pos_67, pos_22),
            );
            let pos_70 = multiply_add(-craft_R_y_y, pos_69, pos_65 * pos_68);
            let pos_71 = multiply_add(-pos_63, pos_61, pos_70);
            let pos_72 = pos_53 * inv_pivot_0;
            let pos_73 = multiply_add(-craft_R_y_y, pos_68, pos_63 * pos_64);
            let pos_74 = multiply_add(
                pos_65,
                multiply_add(-pos_53, pos_72, 4.0 * pos_51),
                pos_73,
            );
            let pos_75 = multiply_add(-craft_R_y_y, pos_71, pos_63 * pos_66);
            let pivot_1 = multiply_add(pos_65, pos_74, pos_75) + 2.0;
            let inv_pivot_1 = 1.0 / pivot_1;
            let pos_76 = pos_43 * inv_pivot_0;
            let pos_77 = pos_65 * multiply_add(-pos_53, pos_76, 2.0 * pos_40);
            let pos_78 = multiply_add(-pos_43, pos_56, 2.0 * pos_27);
            let pos_79 = multiply_add(
                -craft_R_y_y,
                multiply_add(-pos_43, pos_67, pos_57),
                pos_77,
            );
            let pos_80 = multiply_add(-pos_63, pos_78, pos_79);
            let pos_81 = inv_pivot_1 * pos_80;
            let pos_82 = craft_qy_craft_qz + craft_qw_craft_qx;
            let pos_83 = pos_66 * inv_pivot_1;
            let pos_84 = multiply_add(pos_80, pos_83, pos_78);
            let pos_85 = craft_qx_craft_qz - craft_qw_craft_qy;
            let pos_86 = pos_82
                * multiply_add(-pos_80, pos_81, multiply_add(-pos_43, pos_76, pos_23));
            let pos_87 = multiply_add(-2.0, pos_52, pos_48);
            let pos_88 = multiply_add(pos_87, pos_56, 2.0 * pos_46);
            let pos_89 = multiply_add(-pos_87, pos_67, pos_59);
            let pos_90 = multiply_add(-craft_R_y_y, pos_89, pos_63 * pos_88);
            let pos_91 = multiply_add(
                pos_65,
                multiply_add(-pos_87, pos_72, 2.0 * pos_51),
                pos_90,
            );
            let pos_92 = multiply_add(
                -pos_91,
                pos_81,
                multiply_add(-pos_87, pos_76, pos_40),
            );
            let craft_R_z_z = multiply_add(-2.0, craft_qy_sq + craft_qx_sq, 1.0);
            let pos_93 = multiply_add(
                -craft_R_z_z,
                pos_92,
                multiply_add(pos_85, pos_84, pos_86),
            );
            let pos_94 = multiply_add(-pos_91, pos_83, pos_88);
            let pos_95 = multiply_add(
                pos_85,
                multiply_add(-pos_66, pos_83, pos_62),
                pos_82 * pos_84,
            );
            let pos_96 = inv_pivot_1 * pos_91;
            let pos_97 = inv_pivot_0 * pos_87;
            let pos_98 = multiply_add(
                -pos_91,
                pos_96,
                multiply_add(-pos_87, pos_97, pos_51),
            );
            let pos_99 = multiply_add(-pos_85, pos_94, pos_82 * pos_92);
            let pos_100 = multiply_add(
                pos_85,
                multiply_add(craft_R_z_z, pos_94, pos_95),
                pos_82 * pos_93,
            );
            let pos_101 = multiply_add(
                -craft_R_z_z,
                multiply_add(-craft_R_z_z, pos_98, pos_99),
                pos_100,
            );
            let pivot_2 = pos_101 + 2.0;
            let vel_0 = 2.0 * multiply_add(pos_31, craft_wz, pos_8 * craft_wx);
            let load_carried_w_y = multiply_add(hook_R_y_y, craft_wy, vel_0);
            let load_w_y = hook_wy + load_carried_w_y;
            let load_w_squares_y = load_w_y * load_w_y;
            let vel_1 = multiply_add(pos_28, craft_wz, pos_1 * craft_wy);
            let load_w_x = multiply_add(
                2.0,
                vel_1,
                multiply_add(hook_R_x_x, craft_wx, hook_wx),
            );
            let load_w_squares_x = load_w_x * load_w_x;
            let load_relative_z_z = -(load_w_squares_x + load_w_squares_y);
            let vel_2 = m_l * load_relative_z_z;
            let pos_102 = hook_qy_hook_qz - hook_qw_hook_qx;
            let pos_103 = hook_qx_hook_qz + hook_qw_hook_qy;
            let hook_R_z_z = multiply_add(-2.0, hook_qy_sq + hook_qx_sq, 1.0);
            let vel_3 = 2.0 * multiply_add(pos_102, craft_wy, pos_103 * craft_wx);
            let load_carried_w_z = multiply_add(hook_R_z_z, craft_wz, vel_3);
            let load_w_z = hook_wz + load_carried_w_z;
            let vel_4 = multiply_add(-hook_wz, load_w_x, hook_wx * load_w_z);
            let load_w_products_y = load_w_x * load_w_z;
            let vel_5 = m_l * (load_w_products_y + vel_4);
            let craft_w_squares_y = craft_wy * craft_wy;
            let craft_w_squares_x = craft_wx * craft_wx;
            let craft_relative_z_z = -(craft_w_squares_x + craft_w_squares_y);
            let vel_6 = multiply_add(-(-0.1), craft_relative_z_z, -9.81 * craft_R_z_z);
            let craft_w_products_x = craft_wy * craft_wz;
            let vel_7 = multiply_add(-0.1, craft_w_products_x, 19.62 * pos_82);
            let craft_w_products_y = craft_wx * craft_wz;
            let vel_8 = multiply_add(-0.1, craft_w_products_y, 19.62 * pos_85);
            let vel_9 = 2.0 * multiply_add(-pos_1, vel_7, pos_28 * vel_6);
            let vel_10 = multiply_add(
                m_l,
                multiply_add(-hook_R_x_x, vel_8, vel_9),
                0.01 * hook_wy,
            );
            let forcing_7 = -multiply_add(
                load_J_x,
                vel_4,
                multiply_add(m_l_sq, load_w_products_y, vel_10),
            );
            let vel_11 = multiply_add(-hook_wy, load_w_z, hook_wz * load_w_y);
            let load_w_products_x = load_w_y * load_w_z;
            let vel_12 = m_l * (load_w_products_x - vel_11);
            let vel_13 = 2.0 * multiply_add(-pos_31, vel_6, pos_8 * vel_8);
            let vel_14 = multiply_add(-0.01, hook_wx, m_l_sq * load_w_products_x);
            let vel_15 = multiply_add(
                -m_l,
                multiply_add(hook_R_y_y, vel_7, vel_13),
                vel_14,
            );
            let forcing_6 = multiply_add(-load_J_x, vel_11, vel_15);
            let vel_16 = multiply_add(
                pos_0,
                forcing_6,
                multiply_add(-hook_R_y_y, vel_12, m * vel_7),
            );
            let vel_17 = multiply_add(
                pos_3,
                forcing_7,
                multiply_add(pos_1, vel_5, pos_102 * vel_2),
            );
            let vel_18 = multiply_add(-2.0, vel_17, vel_16);
            let vel_19 = multiply_add(
                0.01,
                multiply_add(hook_R_x_x, hook_wx, -craft_w_products_x),
                roll,
            );
            let vel_20 = multiply_add(pos_8, hook_wy, pos_103 * hook_wz);
            let forcing_3 = multiply_add(
                0.02,
                vel_20,
                multiply_add(-0.1, vel_18, vel_19),
            );
            let vel_21 = multiply_add(
                -pos_8,
                vel_12,
                multiply_add(-pos_103, vel_2, pos_10 * forcing_6),
            );
            let vel_22 = multiply_add(
                -pos_7,
                forcing_7,
                multiply_add(-hook_R_x_x, vel_5, m * vel_8),
            );
            let pos_104 = -0.2 * pos_12;
            let vel_23 = multiply_add(
                pos_104,
                forcing_3,
                multiply_add(2.0, vel_21, vel_22),
            );
            let vel_24 = 0.01 * multiply_add(hook_R_y_y, hook_wy, craft_w_products_y);
            let vel_25 = multiply_add(pos_1, hook_wx, pos_102 * hook_wz);
            let forcing_4 = multiply_add(
                0.02,
                vel_25,
                multiply_add(0.1, vel_23, vel_24),
            );
            let vel_26 = multiply_add(
                pos_30,
                forcing_7,
                multiply_add(pos_28, vel_5, pos_31 * vel_12),
            );
            let vel_27 = multiply_add(hook_R_z_z, vel_2, multiply_add(m, vel_6, thrust));
            let vel_28 = multiply_add(
                2.0,
                multiply_add(-pos_33, forcing_6, vel_26),
                vel_27,
            );
            let vel_29 = multiply_add(
                0.1,
                multiply_add(pos_49, forcing_4, pos_35 * forcing_3),
                vel_28,
            );
            let vel_30 = pos_20 * forcing_4;
            let vel_31 = multiply_add(0.1 * pos_17, forcing_3, vel_18);
            let vel_32 = multiply_add(-0.2, vel_30, 2.0 * vel_31);
            let vel_33 = multiply_add(-0.1 * pos_25, forcing_4, vel_23);
            let vel_34 = multiply_add(-pos_24, vel_32, pos_42 * vel_29);
            let forcing_0 = multiply_add(-craft_R_x_x, vel_33, vel_34);
            let vel_35 = multiply_add(
                -0.1,
                vel_30,
                multiply_add(pos_67, forcing_0, vel_31),
            );
            let vel_36 = pos_65 * multiply_add(pos_72, forcing_0, 2.0 * vel_29);
            let vel_37 = multiply_add(pos_56, forcing_0, 2.0 * vel_33);
            let forcing_1 = multiply_add(
                -pos_63,
                vel_37,
                multiply_add(-craft_R_y_y, vel_35, vel_36),
            );
            let vel_38 = multiply_add(
                -pos_96,
                forcing_1,
                multiply_add(pos_97, forcing_0, vel_29),
            );
            let vel_39 = multiply_add(
                -pos_81,
                forcing_1,
                multiply_add(pos_76, forcing_0, vel_32),
            );
            let vel_40 = multiply_add(-pos_82, vel_39, craft_R_z_z * vel_38);
            let forcing_2 = multiply_add(
                -pos_85,
                multiply_add(pos_83, forcing_1, vel_37),
                vel_40,
            ) - 19.62;
            let craft_vz_dot = forcing_2 / pivot_2;
            let vel_41 = pos_85 * craft_vz_dot;
            let vel_42 = pos_82 * craft_vz_dot;
            let vel_43 = multiply_add(-pos_83, vel_41, inv_pivot_1 * forcing_1);
            let vel_44 = craft_R_z_z * craft_vz_dot;
            let craft_vy_dot = multiply_add(
                -pos_96,
                vel_44,
                multiply_add(pos_81, vel_42, vel_43),
            );
            let vel_45 = pos_63 * craft_vy_dot;
            let vel_46 = multiply_add(-pos_56, vel_45, inv_pivot_0 * forcing_0);
            let vel_47 = craft_R_y_y * craft_vy_dot;
            let vel_48 = multiply_add(
                -pos_67,
                vel_47,
                multiply_add(-pos_56, vel_41, vel_46),
            );
            let vel_49 = pos_65 * craft_vy_dot;
            let vel_50 = multiply_add(
                pos_72,
                vel_49,
                multiply_add(-pos_76, vel_42, vel_48),
            );
            let craft_vx_dot = multiply_add(pos_97, vel_44, vel_50);
            let vel_51 = multiply_add(
                craft_R_x_x,
                craft_vx_dot,
                2.0 * (vel_41 + vel_45),
            );
            let vel_52 = multiply_add(
                2.0,
                multiply_add(pos_41, craft_vx_dot, vel_49),
                vel_44,
            );
            let vel_53 = multiply_add(
                pos_49,
                vel_52,
                multiply_add(pos_20, vel_47, pos_25 * vel_51),
            );
            let vel_54 = pos_24 * craft_vx_dot;
            let vel_55 = multiply_add(0.1, vel_53, inv_pivot_4 * forcing_4);
            let craft_wy_dot = multiply_add(
                0.2,
                multiply_add(pos_20, vel_42, pos_20 * vel_54),
                vel_55,
            );
            let vel_56 = multiply_add(0.1, craft_wy_dot, -vel_51);
            let vel_57 = multiply_add(2.0, vel_42 + vel_54, vel_47);
            let vel_58 = multiply_add(-pos_17, vel_57, pos_35 * vel_52);
            let vel_59 = multiply_add(0.1, vel_58, inv_pivot_3 * forcing_3);
            let craft_wx_dot = multiply_add(pos_104, vel_56, vel_59);
            let vel_60 = 0.02 * multiply_add(pos_28, hook_wx, pos_31 * hook_wy);
            let forcing_5 = multiply_add(-(-0.01 * hook_R_z_z), hook_wz, vel_60);
            let craft_wz_dot = 33.333333333333336 * forcing_5;
            let vel_61 = multiply_add(0.1, craft_wx_dot, vel_57);
            let vel_62 = multiply_add(-pos_0, vel_61, inv_load_J_x * forcing_6);
            let vel_63 = multiply_add(-pos_33, vel_52, pos_10 * vel_56);
            let vel_64 = multiply_add(-hook_R_x_x, craft_wx_dot, vel_62);
            let vel_65 = multiply_add(
                2.0,
                multiply_add(-pos_1, craft_wy_dot, vel_63),
                vel_64,
            );
            let hook_wx_dot = multiply_add(
                -66.66666666666667 * pos_28,
                forcing_5,
                vel_65,
            );
            let vel_66 = multiply_add(-pos_7, vel_56, inv_load_J_x * forcing_7);
            let vel_67 = multiply_add(
                -pos_8,
                craft_wx_dot,
                multiply_add(pos_3, vel_61, pos_30 * vel_52),
            );
            let vel_68 = multiply_add(
                2.0,
                vel_67,
                multiply_add(-hook_R_y_y, craft_wy_dot, vel_66),
            );
            let hook_wy_dot = multiply_add(
                -66.66666666666667 * pos_31,
                forcing_5,
                vel_68,
            );
            let vel_69 = multiply_add(-hook_wx, load_w_y, hook_wy * load_w_x);
            let forcing_8 = -multiply_add(0.001, vel_69, 0.01 * hook_wz);
            let vel_70 = multiply_add(
                33.333333333333336 * hook_R_z_z,
                forcing_5,
                -1000.0 * forcing_8,
            );
            let vel_71 = multiply_add(pos_103, craft_wx_dot, pos_102 * craft_wy_dot);
            let hook_wz_dot = -multiply_add(2.0, vel_71, vel_70);
            [
                craft_vx_dot,
                craft_vy_dot,
                craft_vz_dot,
                craft_wx_dot,
                craft_wy_dot,
                craft_wz_dot,
                hook_wx_dot,
                hook_wy_dot,
                hook_wz_dot,
            ]
        }
        /// Rates of the positions: kinematic differential equations.
        #[must_use]
        #[inline]
        pub fn position_rates(&self, t: f64, q: &[f64; 11], v: &[f64; 9]) -> [f64; 11] {
            let [_, _, _, craft_qw, craft_qx, craft_qy, craft_qz, hook_qw, hook_qx,
            hook_qy, hook_qz] = *q;
            let [craft_vx, craft_vy, craft_vz, craft_wx, craft_wy, craft_wz, hook_wx,
            hook_wy, hook_wz] = *v;
            let vel_0 = multiply_add(craft_qy, craft_wy, craft_qx * craft_wx);
            let vel_1 = multiply_add(craft_qy, craft_wz, craft_qw * craft_wx);
            let vel_2 = multiply_add(craft_qz, craft_wx, craft_qw * craft_wy);
            let vel_3 = multiply_add(craft_qx, craft_wy, craft_qw * craft_wz);
            let vel_4 = multiply_add(hook_qy, hook_wy, hook_qx * hook_wx);
            let vel_5 = multiply_add(hook_qy, hook_wz, hook_qw * hook_wx);
            let vel_6 = multiply_add(hook_qz, hook_wx, hook_qw * hook_wy);
            let vel_7 = multiply_add(hook_qx, hook_wy, hook_qw * hook_wz);
            [
                craft_vx,
                craft_vy,
                craft_vz,
                -0.5 * multiply_add(craft_qz, craft_wz, vel_0),
                0.5 * multiply_add(-craft_qz, craft_wy, vel_1),
                0.5 * multiply_add(-craft_qx, craft_wz, vel_2),
                0.5 * multiply_add(-craft_qy, craft_wx, vel_3),
                -0.5 * multiply_add(hook_qz, hook_wz, vel_4),
                0.5 * multiply_add(-hook_qz, hook_wy, vel_5),
                0.5 * multiply_add(-hook_qx, hook_wz, vel_6),
                0.5 * multiply_add(-hook_qy, hook_wx, vel_7),
            ]
        }
        /// Mass matrix M, in rows.
        ///
        /// Takes 97 additions, 195 multiplications.
        #[must_use]
        #[inline]
        pub fn mass_matrix(&self, t: f64, q: &[f64; 11]) -> [[f64; 9]; 9] {
            let Self { m, l, .. } = *self;
            let [_, _, _, craft_qw, craft_qx, craft_qy, craft_qz, hook_qw, hook_qx,
            hook_qy, hook_qz] = *q;
            let craft_qw_craft_qz = craft_qw * craft_qz;
            let craft_qx_craft_qy = craft_qx * craft_qy;
            let pos_0 = craft_qx_craft_qy - craft_qw_craft_qz;
            let pos_1 = m * pos_0;
            let craft_qw_craft_qy = craft_qw * craft_qy;
            let craft_qx_craft_qz = craft_qx * craft_qz;
            let pos_2 = craft_qx_craft_qz + craft_qw_craft_qy;
            let pos_3 = m * pos_2;
            let craft_qz_sq = craft_qz * craft_qz;
            let craft_qy_sq = craft_qy * craft_qy;
            let craft_R_x_x = multiply_add(-2.0, craft_qy_sq + craft_qz_sq, 1.0);
            let m_craft_R_x_x = m * craft_R_x_x;
            let pos_4 = 4.0 * multiply_add(pos_2, pos_3, pos_0 * pos_1);
            let m_0_0 = multiply_add(craft_R_x_x, m_craft_R_x_x, pos_4) + 2.0;
            let craft_qx_sq = craft_qx * craft_qx;
            let craft_R_y_y = multiply_add(-2.0, craft_qz_sq + craft_qx_sq, 1.0);
            let pos_5 = craft_qx_craft_qy + craft_qw_craft_qz;
            let craft_qw_craft_qx = craft_qw * craft_qx;
            let craft_qy_craft_qz = craft_qy * craft_qz;
            let pos_6 = craft_qy_craft_qz - craft_qw_craft_qx;
            let pos_7 = 4.0 * pos_6;
            let pos_8 = 2.0 * multiply_add(pos_5, m_craft_R_x_x, craft_R_y_y * pos_1);
            let m_0_1 = multiply_add(pos_7, pos_3, pos_8);
            let pos_9 = craft_qx_craft_qz - craft_qw_craft_qy;
            let craft_R_z_z = multiply_add(-2.0, craft_qy_sq + craft_qx_sq, 1.0);
            let pos_10 = craft_qy_craft_qz + craft_qw_craft_qx;
            let pos_11 = 4.0 * pos_10;
            let pos_12 = multiply_add(craft_R_z_z, pos_3, pos_9 * m_craft_R_x_x);
            let m_0_2 = multiply_add(2.0, pos_12, pos_11 * pos_1);
            let hook_qx_sq = hook_qx * hook_qx;
            let hook_qz_sq = hook_qz * hook_qz;
            let hook_R_y_y = multiply_add(-2.0, hook_qz_sq + hook_qx_sq, 1.0);
            let m_l = m * l;
            let m_l_hook_R_y_y = m_l * hook_R_y_y;
            let hook_qy_sq = hook_qy * hook_qy;
            let hook_R_x_x = multiply_add(-2.0, hook_qy_sq + hook_qz_sq, 1.0);
            let pos_13 = hook_R_x_x * m_l_hook_R_y_y;
            let hook_qw_hook_qz = hook_qw * hook_qz;
            let hook_qx_hook_qy = hook_qx * hook_qy;
            let pos_14 = hook_qx_hook_qy + hook_qw_hook_qz;
            let pos_15 = m_l * pos_14;
            let pos_16 = hook_qx_hook_qy - hook_qw_hook_qz;
            let pos_17 = pos_16 * pos_15;
            let const_0 = 0.1 * m;
            let pos_18 = multiply_add(-4.0, pos_17, const_0) + pos_13;
            let hook_qw_hook_qy = hook_qw * hook_qy;
            let hook_qx_hook_qz = hook_qx * hook_qz;
            let pos_19 = hook_qx_hook_qz - hook_qw_hook_qy;
            let pos_20 = m_l * pos_19;
            let pos_21 = 4.0 * pos_16;
            let pos_22 = -2.0 * hook_R_x_x;
            let hook_qw_hook_qx = hook_qw * hook_qx;
            let hook_qy_hook_qz = hook_qy * hook_qz;
            let pos_23 = hook_qy_hook_qz + hook_qw_hook_qx;
            let pos_24 = m_l * pos_23;
            let pos_25 = multiply_add(pos_22, pos_24, pos_21 * pos_20);
            let m_0_3 = 2.0 * multiply_add(-pos_2, pos_25, pos_0 * pos_18);
            let pos_26 = -2.0 * hook_R_y_y;
            let pos_27 = 4.0 * pos_14;
            let pos_28 = multiply_add(pos_27, pos_24, pos_26 * pos_20);
            let m_l_hook_R_x_x = m_l * hook_R_x_x;
            let pos_29 = hook_R_y_y * m_l_hook_R_x_x;
            let pos_30 = m_l * pos_16;
            let pos_31 = pos_14 * pos_30;
            let pos_32 = multiply_add(-4.0, pos_31, const_0 + pos_29);
            let m_0_4 = multiply_add(-craft_R_x_x, pos_32, 2.0 * pos_2 * pos_28);
            let pos_33 = multiply_add(
                4.0 * pos_19,
                pos_30,
                -2.0 * pos_23 * m_l_hook_R_x_x,
            );
            let pos_34 = multiply_add(
                -2.0 * pos_19,
                m_l_hook_R_y_y,
                4.0 * pos_23 * pos_15,
            );
            let m_0_5 = multiply_add(-2.0 * pos_0, pos_34, craft_R_x_x * pos_33);
            let pos_35 = 2.0 * multiply_add(craft_R_x_x, pos_30, pos_0 * m_l_hook_R_y_y);
            let m_0_6 = multiply_add(4.0 * pos_2, pos_24, pos_35);
            let pos_36 = 4.0 * multiply_add(pos_2, pos_20, pos_0 * pos_15);
            let m_0_7 = -multiply_add(craft_R_x_x, m_l_hook_R_x_x, pos_36);
            let m_craft_R_y_y = m * craft_R_y_y;
            let pos_37 = m * pos_5;
            let pos_38 = m * pos_6;
            let pos_39 = multiply_add(pos_6, pos_38, pos_5 * pos_37);
            let m_1_1 = multiply_add(4.0, pos_39, craft_R_y_y * m_craft_R_y_y) + 2.0;
            let pos_40 = 4.0 * pos_9;
            let pos_41 = 2.0 * multiply_add(craft_R_z_z, pos_38, pos_10 * m_craft_R_y_y);
            let m_1_2 = multiply_add(pos_40, pos_37, pos_41);
            let m_1_3 = multiply_add(-2.0 * pos_6, pos_25, craft_R_y_y * pos_18);
            let m_1_4 = -2.0 * multiply_add(-pos_6, pos_28, pos_5 * pos_32);
            let m_1_5 = multiply_add(-craft_R_y_y, pos_34, 2.0 * pos_5 * pos_33);
            let pos_42 = multiply_add(pos_6, pos_24, pos_5 * pos_30);
            let m_1_6 = multiply_add(4.0, pos_42, craft_R_y_y * m_l_hook_R_y_y);
            let pos_43 = 2.0 * multiply_add(pos_5, m_l_hook_R_x_x, craft_R_y_y * pos_15);
            let m_1_7 = -multiply_add(pos_7, pos_20, pos_43);
            let pos_44 = 4.0 * multiply_add(m * pos_9, pos_9, m * pos_10 * pos_10);
            let m_2_2 = multiply_add(m * craft_R_z_z, craft_R_z_z, pos_44) + 2.0;
            let m_2_3 = multiply_add(-craft_R_z_z, pos_25, 2.0 * pos_10 * pos_18);
            let m_2_4 = multiply_add(-2.0 * pos_9, pos_32, craft_R_z_z * pos_28);
            let m_2_5 = -2.0 * multiply_add(-pos_9, pos_33, pos_10 * pos_34);
            let pos_45 = 2.0
                * multiply_add(craft_R_z_z, pos_24, pos_10 * m_l_hook_R_y_y);
            let m_2_6 = multiply_add(pos_40, pos_30, pos_45);
            let pos_46 = multiply_add(craft_R_z_z, pos_20, pos_9 * m_l_hook_R_x_x);
            let m_2_7 = -multiply_add(2.0, pos_46, pos_11 * pos_15);
            let const_1 = 0.01 * m;
            let pos_47 = hook_qx_hook_qz + hook_qw_hook_qy;
            let pos_47_sq = pos_47 * pos_47;
            let pos_48 = multiply_add(0.2, pos_13, multiply_add(-0.8, pos_17, const_1));
            let l_sq = l * l;
            let load_J_x = multiply_add(m, l_sq, 0.001);
            let pos_49 = load_J_x * pos_16;
            let load_J_x_hook_R_x_x = load_J_x * hook_R_x_x;
            let pos_50 = multiply_add(
                pos_21,
                pos_49,
                multiply_add(0.004, pos_47_sq, pos_48),
            );
            let m_3_3 = multiply_add(hook_R_x_x, load_J_x_hook_R_x_x, pos_50) + 0.02;
            let m_3_7 = multiply_add(-0.2, pos_15, 2.0 * pos_49);
            let pos_51 = hook_qy_hook_qz - hook_qw_hook_qx;
            let pos_52 = multiply_add(hook_R_y_y, m_3_7, 0.004 * pos_47 * pos_51);
            let pos_53 = multiply_add(-2.0, load_J_x_hook_R_x_x, -0.2 * m_l_hook_R_y_y);
            let m_3_4 = multiply_add(-pos_14, pos_53, pos_52);
            let pos_54 = load_J_x * pos_23;
            let hook_R_z_z = multiply_add(-2.0, hook_qy_sq + hook_qx_sq, 1.0);
            let pos_55 = multiply_add(-0.1, pos_34, pos_21 * pos_54);
            let pos_56 = load_J_x * pos_19;
            let pos_57 = multiply_add(-(-0.002 * pos_47), hook_R_z_z, pos_55);
            let m_3_5 = multiply_add(-pos_22, pos_56, pos_57);
            let m_3_6 = multiply_add(-(-0.1), m_l_hook_R_y_y, load_J_x_hook_R_x_x);
            let m_3_8 = 0.002 * pos_47;
            let pos_51_sq = pos_51 * pos_51;
            let pos_58 = multiply_add(-0.8, pos_31, multiply_add(0.2, pos_29, const_1));
            let load_J_x_hook_R_y_y = load_J_x * hook_R_y_y;
            let pos_59 = multiply_add(0.004, pos_51_sq, pos_58);
            let pos_60 = load_J_x * pos_14;
            let pos_61 = multiply_add(hook_R_y_y, load_J_x_hook_R_y_y, pos_59);
            let m_4_4 = multiply_add(pos_27, pos_60, pos_61) + 0.02;
            let pos_62 = multiply_add(-0.1, pos_33, pos_27 * pos_56);
            let pos_63 = multiply_add(-(-0.002 * pos_51), hook_R_z_z, pos_62);
            let m_4_5 = multiply_add(-pos_26, pos_54, pos_63);
            let m_4_6 = multiply_add(-0.2, pos_30, 2.0 * pos_60);
            let m_4_7 = multiply_add(-(-0.1), m_l_hook_R_x_x, load_J_x_hook_R_y_y);
            let m_4_8 = 0.002 * pos_51;
            let hook_R_z_z_sq = hook_R_z_z * hook_R_z_z;
            let pos_64 = multiply_add(pos_19, pos_56, pos_23 * pos_54);
            let m_5_5 = multiply_add(4.0, pos_64, 0.001 * hook_R_z_z_sq) + 0.03;
            let m_5_6 = 2.0 * pos_56;
            let m_5_7 = 2.0 * pos_54;
            let m_5_8 = 0.001 * hook_R_z_z;
            [
                [m_0_0, m_0_1, m_0_2, m_0_3, m_0_4, m_0_5, m_0_6, m_0_7, 0.0],
                [m_0_1, m_1_1, m_1_2, m_1_3, m_1_4, m_1_5, m_1_6, m_1_7, 0.0],
                [m_0_2, m_1_2, m_2_2, m_2_3, m_2_4, m_2_5, m_2_6, m_2_7, 0.0],
                [m_0_3, m_1_3, m_2_3, m_3_3, m_3_4, m_3_5, m_3_6, m_3_7, m_3_8],
                [m_0_4, m_1_4, m_2_4, m_3_4, m_4_4, m_4_5, m_4_6, m_4_7, m_4_8],
                [m_0_5, m_1_5, m_2_5, m_3_5, m_4_5, m_5_5, m_5_6, m_5_7, m_5_8],
                [m_0_6, m_1_6, m_2_6, m_3_6, m_4_6, m_5_6, load_J_x, 0.0, 0.0],
                [m_0_7, m_1_7, m_2_7, m_3_7, m_4_7, m_5_7, 0.0, load_J_x, 0.0],
                [0.0, 0.0, 0.0, m_3_8, m_4_8, m_5_8, 0.0, 0.0, 0.001],
            ]
        }
        /// Inverse dynamics: the generalised forces that must act, in addition to the declared ones,
        /// to produce given accelerations.
        ///
        /// Takes 109 additions, 150 multiplications.
        #[must_use]
        #[inline]
        pub fn inverse_dynamics(
            &self,
            t: f64,
            q: &[f64; 11],
            v: &[f64; 9],
            a: &[f64; 9],
        ) -> [f64; 9] {
            let Self { m, l, thrust, roll } = *self;
            let [_, _, _, craft_qw, craft_qx, craft_qy, craft_qz, hook_qw, hook_qx,
            hook_qy, hook_qz] = *q;
            let [_, _, _, craft_wx, craft_wy, craft_wz, hook_wx, hook_wy, hook_wz] = *v;
            let [craft_vx_dot, craft_vy_dot, craft_vz_dot, craft_wx_dot, craft_wy_dot,
            craft_wz_dot, hook_wx_dot, hook_wy_dot, hook_wz_dot] = *a;
            let hook_qw_hook_qz = hook_qw * hook_qz;
            let hook_qx_hook_qy = hook_qx * hook_qy;
            let pos_0 = hook_qx_hook_qy - hook_qw_hook_qz;
            let hook_qw_hook_qx = hook_qw * hook_qx;
            let hook_qy_hook_qz = hook_qy * hook_qz;
            let pos_1 = hook_qy_hook_qz + hook_qw_hook_qx;
            let hook_qx_sq = hook_qx * hook_qx;
            let hook_qz_sq = hook_qz * hook_qz;
            let hook_R_y_y = multiply_add(-2.0, hook_qz_sq + hook_qx_sq, 1.0);
            let vel_0 = 2.0 * multiply_add(pos_1, craft_wz, pos_0 * craft_wx);
            let load_carried_w_y = multiply_add(hook_R_y_y, craft_wy, vel_0);
            let load_w_y = hook_wy + load_carried_w_y;
            let hook_qy_sq = hook_qy * hook_qy;
            let hook_R_x_x = multiply_add(-2.0, hook_qy_sq + hook_qz_sq, 1.0);
            let acc_0 = multiply_add(hook_R_x_x, craft_wx_dot, hook_wx_dot);
            let hook_qw_hook_qy = hook_qw * hook_qy;
            let hook_qx_hook_qz = hook_qx * hook_qz;
            let pos_2 = hook_qx_hook_qz + hook_qw_hook_qy;
            let pos_3 = hook_qy_hook_qz - hook_qw_hook_qx;
            let hook_R_z_z = multiply_add(-2.0, hook_qy_sq + hook_qx_sq, 1.0);
            let vel_1 = 2.0 * multiply_add(pos_3, craft_wy, pos_2 * craft_wx);
            let load_carried_w_z = multiply_add(hook_R_z_z, craft_wz, vel_1);
            let load_w_z = hook_wz + load_carried_w_z;
            let pos_4 = hook_qx_hook_qy + hook_qw_hook_qz;
            let pos_5 = hook_qx_hook_qz - hook_qw_hook_qy;
            let acc_1 = multiply_add(
                -hook_wy,
                load_w_z,
                multiply_add(hook_wz, load_w_y, acc_0),
            );
            let acc_2 = multiply_add(pos_5, craft_wz_dot, pos_4 * craft_wy_dot);
            let load_alpha_x = multiply_add(2.0, acc_2, acc_1);
            let load_w_products_x = load_w_y * load_w_z;
            let load_relative_y_z = load_w_products_x - load_alpha_x;
            let m_l = m * l;
            let acc_3 = m_l * load_relative_y_z;
            let craft_qw_craft_qz = craft_qw * craft_qz;
            let craft_qx_craft_qy = craft_qx * craft_qy;
            let pos_6 = craft_qx_craft_qy - craft_qw_craft_qz;
            let craft_qw_craft_qx = craft_qw * craft_qx;
            let craft_qy_craft_qz = craft_qy * craft_qz;
            let pos_7 = craft_qy_craft_qz + craft_qw_craft_qx;
            let craft_joint_a_3_z = craft_vz_dot + 9.81;
            let craft_qx_sq = craft_qx * craft_qx;
            let craft_qz_sq = craft_qz * craft_qz;
            let craft_R_y_y = multiply_add(-2.0, craft_qz_sq + craft_qx_sq, 1.0);
            let acc_4 = 2.0
                * multiply_add(pos_7, craft_joint_a_3_z, pos_6 * craft_vx_dot);
            let craft_a_y = multiply_add(craft_R_y_y, craft_vy_dot, acc_4);
            let craft_w_products_x = craft_wy * craft_wz;
            let craft_relative_y_z = craft_w_products_x - craft_wx_dot;
            let load_joint_a_y = multiply_add(-0.1, craft_relative_y_z, craft_a_y);
            let load_w_squares_y = load_w_y * load_w_y;
            let vel_2 = multiply_add(pos_5, craft_wz, pos_4 * craft_wy);
            let load_w_x = multiply_add(
                2.0,
                vel_2,
                multiply_add(hook_R_x_x, craft_wx, hook_wx),
            );
            let load_w_squares_x = load_w_x * load_w_x;
            let load_relative_z_z = -(load_w_squares_x + load_w_squares_y);
            let vel_3 = m_l * load_relative_z_z;
            let acc_5 = 2.0 * multiply_add(pos_1, craft_wz_dot, pos_0 * craft_wx_dot);
            let load_carried_alpha_y = multiply_add(hook_R_y_y, craft_wy_dot, acc_5);
            let acc_6 = multiply_add(
                hook_wx,
                load_w_z,
                hook_wy_dot + load_carried_alpha_y,
            );
            let load_alpha_y = multiply_add(-hook_wz, load_w_x, acc_6);
            let load_w_products_y = load_w_x * load_w_z;
            let load_relative_x_z = load_alpha_y + load_w_products_y;
            let acc_7 = m_l * load_relative_x_z;
            let acc_8 = multiply_add(-hook_R_y_y, acc_3, m * load_joint_a_y);
            let acc_9 = multiply_add(
                -2.0,
                multiply_add(pos_4, acc_7, pos_3 * vel_3),
                acc_8,
            );
            let craft_qw_craft_qy = craft_qw * craft_qy;
            let craft_qx_craft_qz = craft_qx * craft_qz;
            let pos_8 = craft_qx_craft_qz + craft_qw_craft_qy;
            let pos_9 = craft_qy_craft_qz - craft_qw_craft_qx;
            let craft_qy_sq = craft_qy * craft_qy;
            let craft_R_z_z = multiply_add(-2.0, craft_qy_sq + craft_qx_sq, 1.0);
            let acc_10 = 2.0 * multiply_add(pos_9, craft_vy_dot, pos_8 * craft_vx_dot);
            let craft_a_z = multiply_add(craft_R_z_z, craft_joint_a_3_z, acc_10);
            let craft_w_squares_y = craft_wy * craft_wy;
            let craft_w_squares_x = craft_wx * craft_wx;
            let craft_relative_z_z = -(craft_w_squares_x + craft_w_squares_y);
            let load_joint_a_z = multiply_add(-0.1, craft_relative_z_z, craft_a_z);
            let acc_11 = multiply_add(
                hook_R_z_z,
                vel_3,
                multiply_add(-m, load_joint_a_z, thrust),
            );
            let acc_12 = multiply_add(
                2.0,
                multiply_add(pos_5, acc_7, pos_1 * acc_3),
                acc_11,
            );
            let craft_R_x_x = multiply_add(-2.0, craft_qy_sq + craft_qz_sq, 1.0);
            let pos_10 = craft_qx_craft_qy + craft_qw_craft_qz;
            let pos_11 = craft_qx_craft_qz - craft_qw_craft_qy;
            let acc_13 = multiply_add(pos_11, craft_joint_a_3_z, pos_10 * craft_vy_dot);
            let craft_w_products_y = craft_wx * craft_wz;
            let craft_relative_x_z = craft_wy_dot + craft_w_products_y;
            let acc_14 = multiply_add(2.0, acc_13, craft_R_x_x * craft_vx_dot);
            let load_joint_a_x = multiply_add(-0.1, craft_relative_x_z, acc_14);
            let acc_15 = multiply_add(-m, load_joint_a_x, hook_R_x_x * acc_7);
            let acc_16 = multiply_add(
                2.0,
                multiply_add(pos_0, acc_3, pos_2 * vel_3),
                acc_15,
            );
            let acc_17 = 2.0
                * multiply_add(-pos_8, acc_12, multiply_add(pos_6, acc_9, craft_vx_dot));
            let acc_18 = 2.0
                * multiply_add(
                    -pos_9,
                    acc_12,
                    multiply_add(-pos_10, acc_16, craft_vy_dot),
                );
            let acc_19 = multiply_add(
                -pos_11,
                acc_16,
                multiply_add(pos_7, acc_9, craft_joint_a_3_z),
            );
            let acc_20 = 2.0
                * multiply_add(pos_1, load_joint_a_z, pos_0 * load_joint_a_x);
            let load_a_y = multiply_add(hook_R_y_y, load_joint_a_y, acc_20);
            let l_sq = l * l;
            let m_l_sq = m * l_sq;
            let load_J_x = m_l_sq + 0.001;
            let acc_21 = multiply_add(-m_l, load_a_y, m_l_sq * load_w_products_x);
            let acc_22 = multiply_add(-load_J_x, load_alpha_x, acc_21);
            let acc_23 = multiply_add(
                -hook_R_x_x,
                acc_22,
                multiply_add(0.02, craft_wx_dot, -roll),
            );
            let acc_24 = 2.0 * multiply_add(pos_3, craft_wy_dot, pos_2 * craft_wx_dot);
            let load_carried_alpha_z = multiply_add(hook_R_z_z, craft_wz_dot, acc_24);
            let acc_25 = multiply_add(
                hook_wy,
                load_w_x,
                hook_wz_dot + load_carried_alpha_z,
            );
            let load_alpha_z = multiply_add(-hook_wx, load_w_y, acc_25);
            let acc_26 = multiply_add(
                0.1,
                acc_9,
                multiply_add(0.01, craft_w_products_x, acc_23),
            );
            let acc_27 = multiply_add(pos_5, load_joint_a_z, pos_4 * load_joint_a_y);
            let load_a_x = multiply_add(2.0, acc_27, hook_R_x_x * load_joint_a_x);
            let acc_28 = multiply_add(-load_J_x, load_alpha_y, m_l * load_a_x);
            let acc_29 = multiply_add(-m_l_sq, load_w_products_y, acc_28);
            let acc_30 = multiply_add(0.002 * pos_2, load_alpha_z, acc_26);
            let acc_31 = multiply_add(-0.01, craft_w_products_y, 0.02 * craft_wy_dot);
            let acc_32 = multiply_add(
                0.002 * pos_3,
                load_alpha_z,
                multiply_add(0.1, acc_16, acc_31),
            );
            let acc_33 = multiply_add(
                -(-0.001 * hook_R_z_z),
                load_alpha_z,
                0.03 * craft_wz_dot,
            );
            [
                multiply_add(-craft_R_x_x, acc_16, acc_17),
                multiply_add(craft_R_y_y, acc_9, acc_18),
                multiply_add(-craft_R_z_z, acc_12, 2.0 * acc_19),
                multiply_add(-2.0 * pos_0, acc_29, acc_30),
                multiply_add(
                    -2.0 * pos_4,
                    acc_22,
                    multiply_add(-hook_R_y_y, acc_29, acc_32),
                ),
                multiply_add(-2.0, multiply_add(pos_5, acc_22, pos_1 * acc_29), acc_33),
                multiply_add(0.01, hook_wx, -acc_22),
                multiply_add(0.01, hook_wy, -acc_29),
                multiply_add(0.001, load_alpha_z, 0.01 * hook_wz),
            ]
        }
        /// Rate of the state: rates of the positions, then accelerations.
        #[must_use]
        #[inline]
        pub fn rhs(&self, t: f64, y: &[f64; 20]) -> [f64; 20] {
            let [craft_x, craft_y, craft_z, craft_qw, craft_qx, craft_qy, craft_qz,
            hook_qw, hook_qx, hook_qy, hook_qz, craft_vx, craft_vy, craft_vz, craft_wx,
            craft_wy, craft_wz, hook_wx, hook_wy, hook_wz] = *y;
            let a = self
                .acceleration(
                    t,
                    &[
                        craft_x,
                        craft_y,
                        craft_z,
                        craft_qw,
                        craft_qx,
                        craft_qy,
                        craft_qz,
                        hook_qw,
                        hook_qx,
                        hook_qy,
                        hook_qz,
                    ],
                    &[
                        craft_vx,
                        craft_vy,
                        craft_vz,
                        craft_wx,
                        craft_wy,
                        craft_wz,
                        hook_wx,
                        hook_wy,
                        hook_wz,
                    ],
                );
            let rates = self
                .position_rates(
                    t,
                    &[
                        craft_x,
                        craft_y,
                        craft_z,
                        craft_qw,
                        craft_qx,
                        craft_qy,
                        craft_qz,
                        hook_qw,
                        hook_qx,
                        hook_qy,
                        hook_qz,
                    ],
                    &[
                        craft_vx,
                        craft_vy,
                        craft_vz,
                        craft_wx,
                        craft_wy,
                        craft_wz,
                        hook_wx,
                        hook_wy,
                        hook_wz,
                    ],
                );
            [
                rates[0],
                rates[1],
                rates[2],
                rates[3],
                rates[4],
                rates[5],
                rates[6],
                rates[7],
                rates[8],
                rates[9],
                rates[10],
                a[0],
                a[1],
                a[2],
                a[3],
                a[4],
                a[5],
                a[6],
                a[7],
                a[8],
            ]
        }
    }
    #[automatically_derived]
    impl ::core::default::Default for FlyingPendulum {
        fn default() -> Self {
            Self {
                m: 0.5,
                l: 0.4,
                thrust: 0.0,
                roll: 0.0,
            }
        }
    }
    impl FlyingPendulumState {
        /// The coordinates in their order.
        #[must_use]
        #[inline]
        pub fn coordinates(self) -> [f64; 11] {
            [
                self.craft_x,
                self.craft_y,
                self.craft_z,
                self.craft_qw,
                self.craft_qx,
                self.craft_qy,
                self.craft_qz,
                self.hook_qw,
                self.hook_qx,
                self.hook_qy,
                self.hook_qz,
            ]
        }
        /// The velocities in their order.
        #[must_use]
        #[inline]
        pub fn velocities(self) -> [f64; 9] {
            [
                self.craft_vx,
                self.craft_vy,
                self.craft_vz,
                self.craft_wx,
                self.craft_wy,
                self.craft_wz,
                self.hook_wx,
                self.hook_wy,
                self.hook_wz,
            ]
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 20]> for FlyingPendulumState {
        #[inline]
        fn from(
            [craft_x,
            craft_y,
            craft_z,
            craft_qw,
            craft_qx,
            craft_qy,
            craft_qz,
            hook_qw,
            hook_qx,
            hook_qy,
            hook_qz,
            craft_vx,
            craft_vy,
            craft_vz,
            craft_wx,
            craft_wy,
            craft_wz,
            hook_wx,
            hook_wy,
            hook_wz,
            ]: [f64; 20],
        ) -> Self {
            Self {
                craft_x,
                craft_y,
                craft_z,
                craft_qw,
                craft_qx,
                craft_qy,
                craft_qz,
                hook_qw,
                hook_qx,
                hook_qy,
                hook_qz,
                craft_vx,
                craft_vy,
                craft_vz,
                craft_wx,
                craft_wy,
                craft_wz,
                hook_wx,
                hook_wy,
                hook_wz,
            }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<FlyingPendulumState> for [f64; 20] {
        #[inline]
        fn from(state: FlyingPendulumState) -> Self {
            [
                state.craft_x,
                state.craft_y,
                state.craft_z,
                state.craft_qw,
                state.craft_qx,
                state.craft_qy,
                state.craft_qz,
                state.hook_qw,
                state.hook_qx,
                state.hook_qy,
                state.hook_qz,
                state.craft_vx,
                state.craft_vy,
                state.craft_vz,
                state.craft_wx,
                state.craft_wy,
                state.craft_wz,
                state.hook_wx,
                state.hook_wy,
                state.hook_wz,
            ]
        }
    }
    impl<C: ::lagrange::system::Columns> FlyingPendulumColumns<C> {
        /// Coordinate `craft_x`.
        #[must_use]
        #[inline]
        pub fn craft_x(&self) -> &[C::Scalar] {
            self.0.column(0)
        }
        /// Coordinate `craft_y`.
        #[must_use]
        #[inline]
        pub fn craft_y(&self) -> &[C::Scalar] {
            self.0.column(1)
        }
        /// Coordinate `craft_z`.
        #[must_use]
        #[inline]
        pub fn craft_z(&self) -> &[C::Scalar] {
            self.0.column(2)
        }
        /// Scalar part of a unit quaternion.
        #[must_use]
        #[inline]
        pub fn craft_qw(&self) -> &[C::Scalar] {
            self.0.column(3)
        }
        /// Component of the vector part of a unit quaternion.
        #[must_use]
        #[inline]
        pub fn craft_qx(&self) -> &[C::Scalar] {
            self.0.column(4)
        }
        /// Component of the vector part of a unit quaternion.
        #[must_use]
        #[inline]
        pub fn craft_qy(&self) -> &[C::Scalar] {
            self.0.column(5)
        }
        /// Component of the vector part of a unit quaternion.
        #[must_use]
        #[inline]
        pub fn craft_qz(&self) -> &[C::Scalar] {
            self.0.column(6)
        }
        /// Scalar part of a unit quaternion.
        #[must_use]
        #[inline]
        pub fn hook_qw(&self) -> &[C::Scalar] {
            self.0.column(7)
        }
        /// Component of the vector part of a unit quaternion.
        #[must_use]
        #[inline]
        pub fn hook_qx(&self) -> &[C::Scalar] {
            self.0.column(8)
        }
        /// Component of the vector part of a unit quaternion.
        #[must_use]
        #[inline]
        pub fn hook_qy(&self) -> &[C::Scalar] {
            self.0.column(9)
        }
        /// Component of the vector part of a unit quaternion.
        #[must_use]
        #[inline]
        pub fn hook_qz(&self) -> &[C::Scalar] {
            self.0.column(10)
        }
        /// Velocity of `craft_x`.
        #[must_use]
        #[inline]
        pub fn craft_vx(&self) -> &[C::Scalar] {
            self.0.column(11)
        }
        /// Velocity of `craft_y`.
        #[must_use]
        #[inline]
        pub fn craft_vy(&self) -> &[C::Scalar] {
            self.0.column(12)
        }
        /// Velocity of `craft_z`.
        #[must_use]
        #[inline]
        pub fn craft_vz(&self) -> &[C::Scalar] {
            self.0.column(13)
        }
        /// Component of an angular velocity along the turned axes, in rad/s.
        #[must_use]
        #[inline]
        pub fn craft_wx(&self) -> &[C::Scalar] {
            self.0.column(14)
        }
        /// Component of an angular velocity along the turned axes, in rad/s.
        #[must_use]
        #[inline]
        pub fn craft_wy(&self) -> &[C::Scalar] {
            self.0.column(15)
        }
        /// Component of an angular velocity along the turned axes, in rad/s.
        #[must_use]
        #[inline]
        pub fn craft_wz(&self) -> &[C::Scalar] {
            self.0.column(16)
        }
        /// Component of an angular velocity along the turned axes, in rad/s.
        #[must_use]
        #[inline]
        pub fn hook_wx(&self) -> &[C::Scalar] {
            self.0.column(17)
        }
        /// Component of an angular velocity along the turned axes, in rad/s.
        #[must_use]
        #[inline]
        pub fn hook_wy(&self) -> &[C::Scalar] {
            self.0.column(18)
        }
        /// Component of an angular velocity along the turned axes, in rad/s.
        #[must_use]
        #[inline]
        pub fn hook_wz(&self) -> &[C::Scalar] {
            self.0.column(19)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::From<C> for FlyingPendulumColumns<C> {
        #[inline]
        fn from(columns: C) -> Self {
            Self(columns)
        }
    }
    #[automatically_derived]
    impl<C> ::core::convert::AsRef<C> for FlyingPendulumColumns<C> {
        #[inline]
        fn as_ref(&self) -> &C {
            &self.0
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::OdeSystem for FlyingPendulum {
        type Scalar = f64;
        type State = [f64; 20];
        #[inline]
        fn rhs(&self, t: f64, y: &[f64; 20]) -> [f64; 20] {
            self.rhs(t, y)
        }
        fn undefined(
            &self,
            t: f64,
            y: &[f64; 20],
            rates: &[f64; 20],
        ) -> ::core::option::Option<::lagrange::system::Undefined<f64>> {
            ::lagrange::integrate::undefined(
                self,
                (t, y, rates),
                &[("thrust", self.thrust), ("roll", self.roll)],
                |q, _| ::core::option::Option::Some(self.mass_matrix(t, q)),
            )
        }
        const IS_CONSTRAINED: ::core::primitive::bool = true;
        #[inline]
        fn correct(
            &self,
            t: f64,
            y: &mut [f64; 20],
        ) -> ::core::result::Result<(), ::lagrange::system::StepFailure<f64>> {
            ::lagrange::system::normalise::<Self>(y)?;
            ::core::result::Result::Ok(())
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::MechanicalSystem for FlyingPendulum {
        type Coordinates = [f64; 11];
        type Velocities = [f64; 9];
        type Columns<C> = FlyingPendulumColumns<C>;
        const COORDINATES: &'static [&'static ::core::primitive::str] = &[
            "craft_x",
            "craft_y",
            "craft_z",
            "craft_qw",
            "craft_qx",
            "craft_qy",
            "craft_qz",
            "hook_qw",
            "hook_qx",
            "hook_qy",
            "hook_qz",
        ];
        const FINGERPRINT: ::core::primitive::u64 = 1188035545452573961;
        #[inline]
        fn acceleration(&self, t: f64, q: &[f64; 11], v: &[f64; 9]) -> [f64; 9] {
            self.acceleration(t, q, v)
        }
        #[inline]
        fn position_rates(&self, t: f64, q: &[f64; 11], v: &[f64; 9]) -> [f64; 11] {
            self.position_rates(t, q, v)
        }
        const VELOCITIES: &'static [&'static ::core::primitive::str] = &[
            "craft_vx",
            "craft_vy",
            "craft_vz",
            "craft_wx",
            "craft_wy",
            "craft_wz",
            "hook_wx",
            "hook_wy",
            "hook_wz",
        ];
        const RATES_OF: &'static [&'static ::core::primitive::str] = &[
            "craft_x",
            "craft_y",
            "craft_z",
            "",
            "",
            "",
            "",
            "",
            "",
        ];
        #[inline]
        fn normalise(q: &mut [f64; 11]) {
            ::lagrange::system::quaternion::normalise(q, 3);
            ::lagrange::system::quaternion::normalise(q, 7);
        }
        #[inline]
        fn displacement(&self, _: f64, from: &[f64; 11], to: &[f64; 11]) -> [f64; 9] {
            let turn_0 = ::lagrange::system::quaternion::turn(from, to, 3);
            let turn_1 = ::lagrange::system::quaternion::turn(from, to, 7);
            [
                to[0] - from[0],
                to[1] - from[1],
                to[2] - from[2],
                turn_0[0],
                turn_0[1],
                turn_0[2],
                turn_1[0],
                turn_1[1],
                turn_1[2],
            ]
        }
        fn parameter(
            &self,
            index: ::core::primitive::usize,
        ) -> ::core::option::Option<(&'static ::core::primitive::str, f64)> {
            [("m", self.m), ("l", self.l)].get(index).copied()
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::NamedSystem for FlyingPendulum {
        type NamedState = FlyingPendulumState;
    }
    #[automatically_derived]
    impl ::core::convert::From<[f64; 2]> for FlyingPendulumInputs {
        #[inline]
        fn from([thrust, roll]: [f64; 2]) -> Self {
            Self { thrust, roll }
        }
    }
    #[automatically_derived]
    impl ::core::convert::From<FlyingPendulumInputs> for [f64; 2] {
        #[inline]
        fn from(inputs: FlyingPendulumInputs) -> Self {
            [inputs.thrust, inputs.roll]
        }
    }
    #[automatically_derived]
    impl ::lagrange::system::ControlledSystem for FlyingPendulum {
        type Inputs = FlyingPendulumInputs;
        type InputVector = [f64; 2];
        const INPUTS: &'static [&'static ::core::primitive::str] = &["thrust", "roll"];
        #[inline]
        fn inputs(&self) -> FlyingPendulumInputs {
            FlyingPendulumInputs {
                thrust: self.thrust,
                roll: self.roll,
            }
        }
        #[inline]
        fn with_inputs(&self, inputs: FlyingPendulumInputs) -> Self {
            Self {
                thrust: inputs.thrust,
                roll: inputs.roll,
                m: self.m,
                l: self.l,
            }
        }
    }
};
