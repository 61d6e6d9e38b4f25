use super::{read, read_wrong, statements};

#[test]
fn names_of_ones_own_are_no_habits() {
    for text in [
        "const d = 4, dt = 2, rate = d/dt;",
        "param d, dt; let rate = d/dt * (d + 1);",
        "coord x; let dx = dot(x); param dt; let rate = dx/dt;",
        "param kg; let a = 2*kg;",
        "let a = (1,5); let b = atan2(1,5);",
        "param log, sec, T, U, PI, diff; let a = log * sec + T - U + PI/diff;",
        "param position, circle, k; body b { mass: k; center: (position, circle); }",
    ] {
        read(text);
    }
}

#[test]
fn habits_leave_the_rest_of_the_text_in_place() {
    let cases = [
        ("coord x y, z;", "coord x y z"),
        ("param m: f64 = 1, l;", "param (m 1) l"),
        ("param m := 1, l;", "param (m 1) l"),
        ("let mut a = 2;", "let a 2"),
        ("constraint c: x;", "constraint c x"),
        ("output a == x;", "output a x"),
        ("potential += x;", "potential x"),
    ];
    for (text, expected) in cases {
        let (declaration, report) = read_wrong(text);
        assert_eq!(report.matches("error").count(), 1, "{report}");
        assert_eq!(statements(&declaration.expect("tokens")), [expected], "{text}");
    }
}
