mod callees;
mod enclosures;
mod locals;
mod parts;

use super::without_arrays;
use crate::syntax::{parse_text, print};
use lagrange_expr::diagnostics::Report;

/// Returns the printed expansion of a text.
fn written_out(text: &str) -> String {
    let mut report = Report::default();
    let declaration = parse_text(text, &mut report).expect("consists of tokens");
    let printed = print::statements(&declaration);
    let again = parse_text(&printed, &mut report).expect("what was printed consists of tokens");
    assert_eq!(print::statements(&again), printed);
    let [declaration, again] =
        [declaration, again].map(|declaration| without_arrays(declaration, &mut report));
    assert!(!report.has_errors(), "{text}\n{report}");
    assert_eq!(print::statements(&again), print::statements(&declaration));
    print::statements(&declaration)
}

/// Returns the messages and help texts for a text.
fn reported(text: &str) -> String {
    let mut report = Report::default();
    let declaration = parse_text(text, &mut report).expect("consists of tokens");
    without_arrays(declaration, &mut report);
    report.to_string()
}

fn assert_same(with_arrays: &str, without: &str) {
    assert_eq!(written_out(with_arrays), written_out(without), "{with_arrays}");
}

#[test]
fn arrays_are_declared_as_a_whole() {
    assert_same("coord theta[3], x;", "coord theta_0, theta_1, theta_2, x;");
    assert_same(
        "const n = 2; param m[n] = 1, l[n + 1] = [1, 1/2, 1/4];",
        "const n = 2; param m_0 = 1, m_1 = 1, l_0 = 1, l_1 = 1/2, l_2 = 1/4;",
    );
    assert_same("input u[2][2];", "input u_0_0, u_0_1, u_1_0, u_1_1;");
    assert_same("param k[2][2] = [[1, 2], 3];", "param k_0_0 = 1, k_0_1 = 2, k_1_0 = 3, k_1_1 = 3;");
    assert_same(
        "quaternion hip[2]; kinetic = hip_wx[1]^2;",
        "quaternion hip_0; quaternion hip_1; kinetic = hip_1_wx^2;",
    );
    assert_same(
        "const c[2] = [0, 1]; coord x[2]; kinetic = dot(x[c[1]]);",
        "const c_0 = 0, c_1 = 1; coord x_0, x_1; kinetic = dot(x_1);",
    );
}

/// Conditions on indices in expressions may contain everything allowed between statements.
#[test]
fn indices_choose_between_values() {
    assert_same(
        "coord x[4]; kinetic = sum(i in 0..4, (if i % 2 == 0 && i != 2 { 5 } else { 7 }) * dot(x[i])^2);",
        "coord x_0, x_1, x_2, x_3; kinetic = 5 * dot(x_0)^2 + 7 * dot(x_1)^2 + 7 * dot(x_2)^2 + 7 * dot(x_3)^2;",
    );
    assert_same(
        "coord x[3]; for i in 0..3 { kinetic = if i == 0 || !(i < 2) { dot(x[i]) } else if i == 1 { x[i] } else { x[i + 9] }; }",
        "coord x_0, x_1, x_2; kinetic = dot(x_0); kinetic = x_1; kinetic = dot(x_2);",
    );
    // A moving quantity compared with an index is still compared during the motion.
    assert_same(
        "coord x[2]; for i in 0..2 { potential = if x[i] < i { 1 } else { 2 }; }",
        "coord x_0, x_1; potential = if x_0 < 0 { 1 } else { 2 }; potential = if x_1 < 1 { 1 } else { 2 };",
    );
}

#[test]
fn loops_stand_for_statements() {
    assert_same(
        "const n = 2; param l[n]; coord theta[n];
         let p[0] = (0, 0);
         for i in 0..n {
             let p[i+1] = p[i] + l[i] * (sin(theta[i]), -cos(theta[i]));
             kinetic = kinetic_energy(i + 1, dot(p[i+1]));
         }
         output tip = p[n];",
        "const n = 2; param l_0, l_1; coord theta_0, theta_1;
         let p_0 = (0, 0);
         let p_1 = p_0 + l_0 * (sin(theta_0), -cos(theta_0));
         kinetic = kinetic_energy(0 + 1, dot(p_1));
         let p_2 = p_1 + l_1 * (sin(theta_1), -cos(theta_1));
         kinetic = kinetic_energy(1 + 1, dot(p_2));
         output tip = p_2;",
    );
    assert_same(
        "coord x[2]; for i in 0..=1 { for j in 0..i { potential = x[i] * x[j]; } }",
        "coord x_0, x_1; potential = x_1 * x_0;",
    );
    assert_same("coord x; for i in 2..2 { potential = x; }", "coord x;");
}

#[test]
fn sums_are_written_from_left_to_right() {
    assert_same(
        "coord x[3]; potential = sum(i in 0..3, x[i]^2);",
        "coord x_0, x_1, x_2; potential = x_0^2 + x_1^2 + x_2^2;",
    );
    assert_same(
        "coord x[2]; potential = 2 * sum(i in 0..2, sum(j in i..2, x[j]));",
        "coord x_0, x_1; potential = 2*(x_0 + x_1 + x_1);",
    );
    assert_same("potential = sum(i in 0..0, x[i]);", "potential = 0;");
    assert_same(
        "let sum(a, b) = a + b; potential = sum(1, 2);",
        "let sum(a, b) = a + b; potential = sum(1, 2);",
    );
}

#[test]
fn conditions_choose_between_statements() {
    let text = "coord x[4]; for i in 0..4 {
        if i == 0 { potential = x[i]; } else if i % 2 == 1 && !(i > 2 || i < 1) { kinetic = x[i-1]; } else { force x[i] = i/2; }
    }";
    assert_same(
        text,
        "coord x_0, x_1, x_2, x_3; potential = x_0; kinetic = x_0; force x_2 = 2/2; force x_3 = 3/2;",
    );
    assert_same(
        "coord x[2]; for i in 0..2 { potential = if i > 0 { x[i - 1] } else { x[i + 1] }; }",
        "coord x_0, x_1; potential = x_1; potential = x_0;",
    );
    assert_same(
        "coord x; for i in 0..1 { potential = if x > i { x } else { 0 }; }",
        "coord x; potential = if x > 0 { x } else { 0 };",
    );
}

#[test]
fn indices_are_counted_exactly() {
    assert_same(
        "coord x[3]; potential = x[(7 - 1)/3] + x[-1 % 3] + x[2^1 - 1] + x[0.5*2];",
        "coord x_0, x_1, x_2; potential = x_2 + x_2 + x_1 + x_1;",
    );
}

#[test]
fn all_statements_may_stand_in_loops() {
    assert_same(
        "for i in 0..1 {
            velocity w[i] = dot(x[i]); let (a[i], b[i]) = (i, x[i]); lagrangian = a[i]; dissipation = b[i];
            force x[i] = 1; force (1, a[i]) at (b[i], 1); force a[i] along w[i]; torque a[i] on b[i];
            constraint c[i] = x[i]; event e[i] = x[i], rising => { x[i] = 0; } friction f[i] = w[i], a[i];
            output o[i] = x[i]; reduce Held { freeze x[i] = i; small y; }
            gibbs = a[i], for: b[i]; stabilise = i;
         } coord x[1], y;",
        "velocity w_0 = dot(x_0); let (a_0, b_0) = (0, x_0); lagrangian = a_0; dissipation = b_0;
         force x_0 = 1; force (1, a_0) at (b_0, 1); force a_0 along w_0; torque a_0 on b_0;
         constraint c_0 = x_0; event e_0 = x_0, rising => { x_0 = 0; } friction f_0 = w_0, a_0;
         output o_0 = x_0; reduce Held { freeze x_0 = 0; small y; }
         gibbs = a_0, for: b_0; stabilise = 0; coord x_0, y;",
    );
}

#[test]
fn bodies_and_joints_may_stand_in_loops() {
    assert_same(
        "for i in 0..2 {
            body link[i] { mass: 1; inertia: (i, 1, 2); visual { solid_sphere(i), at: (i, 0, 0); } } frame foot[i];
            if i == 0 { revolute q[i] = ground to link[i] { axis: (0, 0, 1); damping: i; } }
            else { ball hip[i] = link[i-1] to link[i]; }
            weld link[i] to foot[i]; free trunk[i];
         }
         potential = q[0] + hip_qw[1] + trunk_vx[1]; output o = (1, 2, 3) in link[1]; output r = link[0].point(1, 2, 3);",
        "body link_0 { mass: 1; inertia: (0, 1, 2); visual { solid_sphere(0), at: (0, 0, 0); } } frame foot_0;
         revolute q_0 = ground to link_0 { axis: (0, 0, 1); damping: 0; } weld link_0 to foot_0; free trunk_0;
         body link_1 { mass: 1; inertia: (1, 1, 2); visual { solid_sphere(1), at: (1, 0, 0); } } frame foot_1;
         ball hip_1 = link_0 to link_1; weld link_1 to foot_1; free trunk_1;
         potential = q_0 + hip_1_qw + trunk_1_vx; output o = (1, 2, 3) in link_1; output r = link_0.point(1, 2, 3);",
    );
    assert_same(
        "for i in 0..1 {
            line floor[i] { on: cart[i]; through: (0, i); angle: 0; }
            spring s[i] { from: (0, i); to: cart[i]; stiffness: k[i]; } damper { from: (0, i); to: cart[i]; damping: 1; }
            pin hinge[i] = cart[i] to (0, i); slide cart[i] on floor[i]; roll r[i] = cart[i] on floor[i], radius: i;
            body cart[i] { mass: i; compound { disk(i), mass: i; } }
         } param k[1];",
        "line floor_0 { on: cart_0; through: (0, 0); angle: 0; }
         spring s_0 { from: (0, 0); to: cart_0; stiffness: k_0; } damper { from: (0, 0); to: cart_0; damping: 1; }
         pin hinge_0 = cart_0 to (0, 0); slide cart_0 on floor_0; roll r_0 = cart_0 on floor_0, radius: 0;
         body cart_0 { mass: 0; compound { disk(0), mass: 0; } } param k_0;",
    );
}

#[test]
fn parameters_of_functions_hide_arrays_and_variables_hide_nothing() {
    assert_same(
        "coord p[1]; let f(p) = p^2 + 1; potential = f(p[0]);",
        "coord p_0; let f(p) = p^2 + 1; potential = f(p_0);",
    );
    assert_same(
        "let f(i) = i; coord x[1]; for i in 0..1 { potential = f(x[i]) + i; }",
        "let f(i) = i; coord x_0; potential = f(x_0) + 0;",
    );
}

#[test]
fn loops_within_loops_come_to_an_end() {
    let mut nested = "potential = 1;".to_owned();
    for variable in ["a", "b", "c", "d"] {
        nested = format!("for {variable} in 0..10000 {{ {nested} }}");
    }
    let mut sum = "1".to_owned();
    for variable in ["a", "b", "c", "d"] {
        sum = format!("sum({variable} in 0..10000, {sum})");
    }
    let many = (0..30).map(|i| format!("coord x{i}[100000]; const c{i}[100000] = 1;")).collect::<String>();
    for text in [nested, format!("potential = {sum};"), many] {
        let mut report = Report::default();
        let declaration = parse_text(&text, &mut report).expect("consists of tokens");
        without_arrays(declaration, &mut report);
        assert_eq!(report.diagnostics().len(), 1, "{report}");
        assert!(report.to_string().contains("more than"), "{report}");
    }
}
