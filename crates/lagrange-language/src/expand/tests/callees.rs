//! Arrays of tables and functions.

use super::{assert_same, reported};

#[test]
fn tables_and_functions_have_elements() {
    assert_same(
        r#"coord x[2];
        table wheel[0](s) = "front.csv", interpolation: linear, outside: clamp;
        table wheel[1](s: m): N = [(0, 1), (1, 2)], interpolation: natural, outside: extend;
        for i in 0..2 { let pull[i](u, v) = u * wheel[i](v) + i; force x[i] = pull[i](2, wheel[1 - i](x[i])); }
        output total = sum(i in 0..2, pull[i](1, x[i]));"#,
        r#"coord x_0, x_1;
        table wheel_0(s) = "front.csv", interpolation: linear, outside: clamp;
        table wheel_1(s: m): N = [(0, 1), (1, 2)], interpolation: natural, outside: extend;
        let pull_0(u, v) = u * wheel_0(v) + 0; force x_0 = pull_0(2, wheel_1(x_0));
        let pull_1(u, v) = u * wheel_1(v) + 1; force x_1 = pull_1(2, wheel_0(x_1));
        output total = pull_0(1, x_0) + pull_1(1, x_1);"#,
    );
    assert_same(
        "const f[2] = [1, 4]; coord x; for i in 0..2 { table k(s) = [(0, f[i]), (1, 2)], interpolation: linear, outside: clamp; force x = k(i); }",
        "const f_0 = 1, f_1 = 4; coord x; table k_0(s) = [(0, f_0), (1, 2)], interpolation: linear, outside: clamp; force x = k_0(0);
         table k_1(s) = [(0, f_1), (1, 2)], interpolation: linear, outside: clamp; force x = k_1(1);",
    );
}

#[test]
fn parts_take_arrays_of_functions_and_elements_of_them() {
    assert_same(
        "coord x; let f[0](s) = s; let f[1](s) = 2 * s;
         part P(all, one, n) { let g[0](s) = one(s); for i in 0..n { force y[i] = all[i](g[0](i)); } coord y[n]; }
         p: P { all: f; one: f[1]; n: 2; }",
        "coord x; let f_0(s) = s; let f_1(s) = 2 * s; let p_g_0(s) = f_1(s);
         force p_y_0 = f_0(p_g_0(0)); force p_y_1 = f_1(p_g_0(1)); coord p_y_0, p_y_1;",
    );
}

#[test]
fn mistakes_in_calls_of_elements_are_reported() {
    let mistakes = [
        ("let f[0](s) = s; force x[0] = f(2);", "`f` is an array: specify one of its elements"),
        ("let f[0](s) = s; force x[0] = f[1](2);", "there is no `f[1]`"),
        ("let f[0](s) = s; force x[0] = f[0][0](2);", "elements of `f` have 1 index, not 2"),
        ("let f[0](s) = s; let f[0](s) = 2;", "the name `f[0]` is declared twice"),
        ("let f[0](s) = s; let f(s) = 2;", "`f` is declared both with an index and without"),
        ("let f(s) = s; force x[0] = f[0](2);", "`f` is not an array and has no elements"),
        ("force x[0] = x[1](2);", "`x` is an array of values, which cannot be called"),
        ("function f[0](s);", "functions of the crate and parameters have no elements"),
        ("let f(s[0]) = 1;", "functions of the crate and parameters have no elements"),
        ("force x[0] = g[0](2);", "unknown name `g`"),
        ("let f[0](s) = s; force x[0] = f;", "`f` is an array: specify one of its elements"),
    ];
    for (text, message) in mistakes {
        let found = reported(&format!("coord x[2]; {text}"));
        assert!(found.contains(message), "{text}\n{found}");
        assert_eq!(found.matches("error at").count(), 1, "{text}\n{found}");
    }
}

/// Names of methods belong to no array, although contacts create arrays with these names.
#[test]
fn an_array_may_be_called_like_a_method() {
    let text = "gravity = (0, 0, -9.81); body case { mass: 2; shape: cuboid(0.4, 0.4, 0.4); } free case;";
    for contact in
        ["contact corner = case.corners on ground {}", "contact corner[4] = case.corners on ground {}"]
    {
        assert_eq!(reported(&format!("{text} {contact}")), "", "{contact}");
    }
}
