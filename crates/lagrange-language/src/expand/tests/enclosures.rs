//! Loops and conditions in events, clocks and reductions.

use super::{assert_same, reported};

#[test]
fn loops_in_events_and_clocks_stand_for_assignments() {
    assert_same(
        "coord x[3]; discrete n[3]; event hit = x[0], rising => {
             for i in 0..3 { dot(x[i]) = -dot(x[i]); if i > 1 { x[i] = i; } else if i == 0 { x[i] = 7; } else { n[i] = 5; } }
             n[2] = 4;
         }",
        "coord x_0, x_1, x_2; discrete n_0, n_1, n_2; event hit = x_0, rising => {
             dot(x_0) = -dot(x_0); dot(x_1) = -dot(x_1); dot(x_2) = -dot(x_2); x_2 = 2; x_0 = 7; n_1 = 5; n_2 = 4;
         }",
    );
    assert_same(
        "coord x; discrete n[2][2]; every 2 => { for i in 0..2 { for j in 0..=i { n[i][j] = x + sum(k in 0..i, j); } } }",
        "coord x; discrete n_0_0, n_0_1, n_1_0, n_1_1; every 2 => { n_0_0 = x + 0; n_1_0 = x + 0; n_1_1 = x + 1; }",
    );
    assert_same(
        "coord x; event hit = x, rising => { for i in 3..4 { dot(x) = i; } }",
        "coord x; event hit = x, rising => { dot(x) = 3; }",
    );
}

/// The spelling of local names avoids declared names, including those in parts.
#[test]
fn local_names_avoid_declared_ones() {
    assert_same(
        "coord x; param v_0, v_2; event hit = x, rising => { let v = 3 * v_0; let w = v; x = v + w; }
         event fall = x, falling => { let v = v_2; x = v; }",
        "coord x; param v_0, v_2; let v_1 = 3 * v_0; let w_0 = v_1; event hit = x, rising => { x = v_1 + w_0; }
         let v_3 = v_2; event fall = x, falling => { x = v_3; }",
    );
    assert_same(
        "part Leg() { coord y; param v_0; event hit = y, rising => { let v = v_0; y = v; } } leg: Leg {}",
        "coord leg_y; param leg_v_0; let leg_v_1 = leg_v_0; event leg_hit = leg_y, rising => { leg_y = leg_v_1; }",
    );
}

/// Loops around an event enclose the loops within.
#[test]
fn loops_around_and_within_events_know_each_other() {
    assert_same(
        "coord x[2]; for i in 0..2 { let r = x[i]; event hit[i] = r, rising => { for j in 0..2 { if j != i { dot(x[j]) = r; } } } }",
        "coord x_0, x_1; let r_0 = x_0; event hit_0 = r_0, rising => { dot(x_1) = r_0; }
         let r_1 = x_1; event hit_1 = r_1, rising => { dot(x_0) = r_1; }",
    );
    assert_same(
        "part Leg(n) { coord y[2]; event hit = y[0], rising => { for j in 0..n { dot(y[j]) = 0; } } } leg: Leg { n: 2; }",
        "coord leg_y_0, leg_y_1; event leg_hit = leg_y_0, rising => { dot(leg_y_0) = 0; dot(leg_y_1) = 0; }",
    );
}

#[test]
fn loops_in_reductions_stand_for_their_lines() {
    assert_same(
        "coord x[3], y[3]; reduce Held { for i in 0..3 { if i > 0 { freeze x[i] = i, y[i] = 0; } else { small y[i]; } } }",
        "coord x_0, x_1, x_2, y_0, y_1, y_2; reduce Held { freeze x_1 = 1, x_2 = 2, y_1 = 0, y_2 = 0; small y_0; }",
    );
}

/// A `let` between braces becomes a `let` before the statement, separate for each iteration.
#[test]
fn local_names_stand_in_front_of_the_statement() {
    assert_same(
        "coord x; event hit = x, rising => { let r = 2 * x; dot(x) = r; x = r^2; } every 1 => { let r = x; dot(x) = r; }",
        "coord x; let r_0 = 2 * x; event hit = x, rising => { dot(x) = r_0; x = r_0^2; } let r_1 = x; every 1 => { dot(x) = r_1; }",
    );
    assert_same(
        "coord x[2]; event hit = x[0], rising => {
             let (a, b) = (x[0], x[1]); let f(z) = a * z;
             for i in 0..2 { let r = f(i); dot(x[i]) = r; if i > 0 { let s = r + b; x[i] = s; } }
         }",
        "coord x_0, x_1; let (a_0, b_0) = (x_0, x_1); let f_0(z) = a_0 * z;
         let r_0 = f_0(0); let r_1 = f_0(1); let s_0 = r_1 + b_0;
         event hit = x_0, rising => { dot(x_0) = r_0; dot(x_1) = r_1; x_1 = s_0; }",
    );
    assert_same(
        "part Leg(n) { coord y; event hit = y, rising => { let r = n * y; dot(y) = r; } } leg[i in 0..2]: Leg { n: i; }",
        "coord leg_0_y; let leg_0_r_0 = 0 * leg_0_y; event leg_0_hit = leg_0_y, rising => { dot(leg_0_y) = leg_0_r_0; }
         coord leg_1_y; let leg_1_r_0 = 1 * leg_1_y; event leg_1_hit = leg_1_y, rising => { dot(leg_1_y) = leg_1_r_0; }",
    );
    assert_same(
        "coord x, y; reduce Held { let r = 2; freeze x = r; }",
        "coord x, y; let r_0 = 2; reduce Held { freeze x = r_0; }",
    );
}

#[test]
fn mistakes_in_enclosed_lines_are_reported() {
    let mistakes = [
        ("event e = x[0], rising => { for i in 0..0 { x[i] = 1; } }", "the braces are empty"),
        ("event e = x[0], rising => { if 1 > 2 { x[0] = 1; } }", "the braces are empty"),
        ("reduce R { for i in 1..1 { freeze x[i] = 1; } }", "the braces are empty"),
        ("event e = x[0], rising => { for i in 0..3 { x[i] = 1; } }", "there is no `x[2]`, for i = 2"),
        ("event e = x[0], rising => { for x in 0..2 { dot(x) = 1; } }", "cannot be the variable of a loop"),
        ("event e = x[0], rising => { for i in 0..x { x[i] = 1; } }", "`x` cannot be an index"),
        ("event e = x[0], rising => { if x[0] > 0 { x[1] = 1; } }", "can only use indices"),
        ("event e = x[0], rising => { for i in 0..2 { force x[i] = 1; } }", "an event can only assign"),
        ("event e = x[0], rising => { for i 0..2 { x[i] = 1; } }", "expected `in`"),
        ("event e = x[0], rising => { for i in 0..2 x[i] = 1; }", "expected `{`"),
        ("event e = x[0], rising => { for i in 0..2 { x[i] = 1 } }", "`;`"),
        (
            "event e = x[0], rising => { for i in 0..3000000000 { for j in 0..2 { x[i] = 1; } } }",
            "more than 200000 statements",
        ),
        ("every 1 => { for i in 0..2 { } }", "nothing is assigned"),
        ("every 1 => { let r = x[0]; }", "no line behind this `let`"),
        ("every 1 => { x[0] = 1; let r = x[1]; }", "no line behind this `let`"),
        ("every 1 => { for i in 0..2 { x[i] = 1; let r = x[i]; } }", "no line behind this `let`"),
        ("every 1 => { let r = 1, dot(x[0]) = r; }", "found `,`"),
        ("every 1 => { let r[0] = 2; x[0] = r[0]; }", "has no index"),
        ("every 1 => { let x = 2; dot(x[0]) = x; }", "and a local name must be new"),
        ("every 1 => { let r = 2; for r in 0..2 { x[r] = 1; } }", "cannot be the variable of a loop"),
        ("every 1 => { let r = 2; x[0] = r; } force x[0] = r;", "known only inside its loop or braces"),
        ("every 1 => { for i in 0..2 { let r = 2; x[i] = r; } dot(x[0]) = r; }", "known only inside"),
        ("reduce R { for i in 0..2 { held x[i] = 1; } }", "expected"),
    ];
    let branches = "if 1 > 2 { x[0] = 1; } else ".repeat(101);
    let long = format!("event e = x[0], rising => {{ {branches} {{ x[0] = 1; }} }}");
    for (text, message) in mistakes.into_iter().chain([(long.as_str(), "more than 100 choices")]) {
        let found = reported(&format!("coord x[2]; {text}"));
        assert!(found.contains(message), "{text}\n{found}");
        assert_eq!(found.matches("error at").count(), 1, "{text}\n{found}");
    }
}
