//! Names that are local to loops.

use super::{assert_same, reported, written_out};

#[test]
fn a_name_in_a_loop_is_new_in_each_iteration() {
    assert_same(
        "coord x[3]; for i in 0..3 { let r = 2 * x[i]; force x[i] = r; }",
        "coord x_0, x_1, x_2; let r_0 = 2 * x_0; force x_0 = r_0; let r_1 = 2 * x_1; force x_1 = r_1;
         let r_2 = 2 * x_2; force x_2 = r_2;",
    );
    // The names are new in every iteration of the inner loop, and again in a separate loop.
    assert_same(
        "coord x[2]; for i in 0..2 { for j in 0..=i { let (a, b) = (x[i], x[j]); potential = a * b; } }
         for i in 5..6 { let a = x[i - 5]; kinetic = a; }",
        "coord x_0, x_1; let (a_0, b_0) = (x_0, x_0); potential = a_0 * b_0;
         let (a_1, b_1) = (x_1, x_0); potential = a_1 * b_1; let (a_2, b_2) = (x_1, x_1); potential = a_2 * b_2;
         let a_3 = x_0; kinetic = a_3;",
    );
}

#[test]
fn local_names_may_be_vectors_functions_unknowns_and_constants() {
    assert_same(
        "coord x[2]; for i in 0..2 { let p: m = (x[i], i); let f(r) = r * p[0]; force x[i] = f(p.y) + f(sum(k in 0..2, p[k])); }",
        "coord x_0, x_1; let p_0: m = (x_0, 0); let f_0(r) = r * p_0[0]; force x_0 = f_0(p_0.y) + f_0(p_0[0] + p_0[1]);
         let p_1: m = (x_1, 1); let f_1(r) = r * p_1[0]; force x_1 = f_1(p_1.y) + f_1(p_1[0] + p_1[1]);",
    );
    assert_same(
        "coord x[2]; for i in 0..2 { solve y: 0 = y^3 + y - x[i], start: x[i]; force x[i] = y; }",
        "coord x_0, x_1; solve y_0: 0 = y_0^3 + y_0 - x_0, start: x_0; force x_0 = y_0;
         solve y_1: 0 = y_1^3 + y_1 - x_1, start: x_1; force x_1 = y_1;",
    );
    assert_same(
        "coord x[3]; for i in 0..3 { const next = i + 1; if next < 3 { potential = x[i] * x[next]; } }",
        "coord x_0, x_1, x_2; const next_0 = 0 + 1; potential = x_0 * x_1; const next_1 = 1 + 1; potential = x_1 * x_2; const next_2 = 2 + 1;",
    );
}

#[test]
fn inner_loops_conditions_and_parts_know_local_names() {
    assert_same(
        "coord x[2]; for i in 0..2 { if i == 0 { let r = x[1]; } else { let r = x[0]; } for j in 0..2 { force x[j] = r; } }",
        "coord x_0, x_1; let r_0 = x_1; force x_0 = r_0; force x_1 = r_0; let r_1 = x_0; force x_0 = r_1; force x_1 = r_1;",
    );
    assert_same(
        "part Leg(at) { coord y; for i in 0..2 { let r = at * i; force y = r; } let s = at; } coord x;
         for k in 0..2 { let r = k * x; leg[k]: Leg { at: r; } }",
        "coord x; let r_0 = 0 * x; coord leg_0_y; let leg_0_r_0 = r_0 * 0; force leg_0_y = leg_0_r_0;
         let leg_0_r_1 = r_0 * 1; force leg_0_y = leg_0_r_1; let leg_0_s = r_0;
         let r_1 = 1 * x; coord leg_1_y; let leg_1_r_0 = r_1 * 0; force leg_1_y = leg_1_r_0;
         let leg_1_r_1 = r_1 * 1; force leg_1_y = leg_1_r_1; let leg_1_s = r_1;",
    );
}

/// Outside of loops, conditions do not limit the scope of names.
#[test]
fn conditions_do_not_limit_names() {
    let text = "const n = 2; coord x; if n > 1 { let r = x; } else { let r = 2 * x; } force x = r;";
    assert!(written_out(text).contains("let r = x;\nforce x = r;"));
}

#[test]
fn a_local_name_is_new_and_unknown_outside() {
    let mistakes = [
        ("let r = x[0]; for i in 0..2 { let r = x[i]; }", "`r` is already declared, and a local name"),
        ("for i in 0..2 { let x = i; }", "`x` is already declared, and a local name"),
        (
            "for i in 0..2 { let r = i; for j in 0..2 { let r = j; } }",
            "`r` is already declared, and a local name",
        ),
        ("for i in 0..2 { let r = i; let r = x[i]; }", "`r` is already declared, and a local name"),
        ("for i in 0..2 { let i = x[0]; }", "`i` is already the variable of an enclosing loop"),
        (
            "for i in 0..2 { let r = i; for r in 0..2 { force x[i] = r; } }",
            "cannot be the variable of a loop",
        ),
        ("for i in 0..2 { let r = i; let p[i] = sum(r in 0..2, r); }", "cannot be the variable of a loop"),
        ("for i in 0..2 { let r = x[i]; } force x[0] = r;", "`r` is known only inside its loop or braces"),
        ("for i in 0..2 { let r = x[i]; } force x[0] = x[r];", "`r` is known only inside its loop or braces"),
        ("for i in 0..2 { let r(z) = z; } force x[0] = r(2);", "`r` is known only inside its loop or braces"),
        ("for i in 0..2 { let r = x[i]; } force x[0] = r_1;", "unknown name `r_1`\n  help: write `r`"),
        (
            "part P { coord y; for i in 0..2 { let r = y; } force y = r; } p: P {}",
            "known only inside its loop or braces",
        ),
        ("part P { coord y; for i in 0..2 { let r = y; } } p: P {} force x[0] = p.r;", "there is no `p.r`"),
        (
            "part P(r) { coord y; for i in 0..2 { let r = y; } } p: P { r: 1; }",
            "`r` is an argument of the part",
        ),
        (
            "part P { coord y; } p: P {} for i in 0..2 { let p = i; }",
            "`p` is already declared, and a local name",
        ),
        (
            "part P { coord y; } for i in 0..2 { let p = i; } p: P {}",
            "`p` is both a placed part and another name",
        ),
        ("for i in 0..2 { constraint r = x[i]; }", "`r` is declared again in every iteration"),
    ];
    for (text, message) in mistakes {
        let found = reported(&format!("coord x[2]; {text}"));
        assert!(found.contains(message), "{text}\n{found}");
        assert_eq!(found.matches("error at").count(), 1, "{text}\n{found}");
    }
}

/// The variable of a sum in the height of terrain is not one of its coordinates.
#[test]
fn mistakes_in_heights_are_reported_as_they_are_written() {
    let mistakes = [
        ("height(s): sum(s in 0..3, s);", "`s` is a parameter of the function or height and"),
        ("height(s) = s;", "write `height(x): …;`, or `height(x, y): …;` in space"),
    ];
    for (text, message) in mistakes {
        let found = reported(&format!("coord x[2]; terrain road {{ {text} }}"));
        assert!(found.contains(message), "{text}\n{found}");
    }
}
