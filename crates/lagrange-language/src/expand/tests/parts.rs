//! Parts, compared with the same statements written by hand.

use super::{assert_same, written_out};
use crate::expand::without_arrays;
use crate::syntax::{parse_text, print};
use lagrange_expr::diagnostics::Report;

#[test]
fn members_have_the_name_of_the_placement_before_theirs() {
    assert_same(
        "part Cart { param m = 1; coord x; kinetic = m * dot(x)^2; output place = x; } front: Cart {}",
        "param front_m = 1; coord front_x; kinetic = front_m * dot(front_x)^2; output front_place = front_x;",
    );
    // The order is that of the placements, and equal names outside are distinct.
    assert_same(
        "coord x; part P { coord x; kinetic = dot(x); } b: P {} kinetic = dot(x) * b.x; a: P {}",
        "coord x; coord b_x; kinetic = dot(b_x); kinetic = dot(x) * b_x; coord a_x; kinetic = dot(a_x);",
    );
}

#[test]
fn arguments_are_given_or_have_defaults_that_know_earlier_ones() {
    assert_same(
        "param m; coord y; part P(mass, l = 2, w = l / 2, on = 0) { coord x; kinetic = mass * dot(x * w + on)^2 * l; }
         a: P { mass: m; } b: P { l: 3 + y; mass: 2 * m; on: y^2; }",
        "param m; coord y; coord a_x; kinetic = m * dot(a_x * (2 / 2) + 0)^2 * 2;
         coord b_x; kinetic = 2 * m * dot(b_x * ((3 + y) / 2) + y^2)^2 * (3 + y);",
    );
}

#[test]
fn arguments_stand_for_names_wherever_names_stand() {
    assert_same(
        "input u; coord q; state z; let f(x) = x^2; const n = 2; param k[3];
         part P(on, drive, store, shape, count, gain) {
             force on = drive; dot(store) = drive; start dot(on) = 1; kinetic = shape(dot(on));
             event low = on, falling => { on = 0; dot(on) = 1; }
             for i in 0..count { potential = gain[i] * on; }
         }
         p: P { on: q; drive: u; store: z; shape: f; count: n; gain: k; }",
        "input u; coord q; state z; let f(x) = x^2; const n = 2; param k[3];
         force q = u; dot(z) = u; start dot(q) = 1; kinetic = f(dot(q));
         event p_low = q, falling => { q = 0; dot(q) = 1; }
         potential = k[0] * q; potential = k[1] * q;",
    );
    let plane = "param m; coord a, b; body cart { mass: m; center: (a, 0); } line floor { angle: 0; }";
    assert_same(
        &format!(
            "{plane} part P(on, way) {{ body bob {{ mass: 1; center: on + (1, 2); }} pin hold = bob to on.point(1, 2); slide on.center on way; }} p: P {{ on: cart; way: floor; }}"
        ),
        &format!(
            "{plane} body p_bob {{ mass: 1; center: cart + (1, 2); }} pin p_hold = p_bob to point(cart, 1, 2); slide cart.center on floor;"
        ),
    );
}

#[test]
fn joints_connect_bodies_of_different_parts() {
    assert_same(
        "part Link(on, at = 0) { body rod { mass: 1; inertia: (1, 1, 1); } revolute q = on to rod { at: (at, 0, 0); } }
         first: Link { on: ground; } second: Link { on: first.rod; at: 2; } force second.q = first.q;
         start first.q = 1; body load { mass: 1; inertia: (1, 1, 1); } weld second.rod to load;",
        "body first_rod { mass: 1; inertia: (1, 1, 1); } revolute first_q = ground to first_rod { at: (0, 0, 0); }
         body second_rod { mass: 1; inertia: (1, 1, 1); } revolute second_q = first_rod to second_rod { at: (2, 0, 0); }
         force second_q = first_q; start first_q = 1; body load { mass: 1; inertia: (1, 1, 1); } weld second_rod to load;",
    );
    assert_same(
        "part Leg { body shin { mass: 1; inertia: (1, 1, 1); } free shin; ball hip = shin to foot; body foot { mass: 1; inertia: (1, 1, 1); } }
         leg[i in 0..1]: Leg {} output spin = leg[0].hip_wx + leg[0].shin_x;",
        "body leg_0_shin { mass: 1; inertia: (1, 1, 1); } free leg_0_shin; ball leg_0_hip = leg_0_shin to leg_0_foot;
         body leg_0_foot { mass: 1; inertia: (1, 1, 1); } output spin = leg_0_hip_wx + leg_0_shin_x;",
    );
}

#[test]
fn parts_are_placed_in_arrays_and_loops() {
    let cart = "part Cart(k) { coord x; kinetic = k * dot(x)^2; }";
    let flat = "coord c_0_x; kinetic = 0 * dot(c_0_x)^2; coord c_1_x; kinetic = 1 * dot(c_1_x)^2;";
    for placed in [
        "c[i in 0..2]: Cart { k: [0, 1]; }",
        "c[i in 0..=1]: Cart { k: i; }",
        "for i in 0..2 { c[i]: Cart { k: i; } }",
        "c[0]: Cart { k: 0; } if 1 > 0 { c[1]: Cart { k: 1; } } else { c[2]: Cart { k: 7; } }",
    ] {
        assert_same(&format!("{cart} {placed}"), flat);
        assert_same(
            &format!("{cart} {placed} output s = sum(i in 0..2, c[i].x);"),
            &format!("{flat} output s = c_0_x + c_1_x;"),
        );
    }
    assert_same(
        "part P { param k[2] = [1, 2]; coord x[2]; for i in 0..2 { let y[i] = k[i] * x[i]; } }
         p[i in 0..2]: P {} output s = p[1].y[0] + p[0].k[1] * p[1].x[1];",
        "param p_0_k[2] = [1, 2]; coord p_0_x[2]; let p_0_y[0] = p_0_k[0] * p_0_x[0]; let p_0_y[1] = p_0_k[1] * p_0_x[1];
         param p_1_k[2] = [1, 2]; coord p_1_x[2]; let p_1_y[0] = p_1_k[0] * p_1_x[0]; let p_1_y[1] = p_1_k[1] * p_1_x[1];
         output s = p_1_y[0] + p_0_k[1] * p_1_x[1];",
    );
}

#[test]
fn parts_hold_parts() {
    assert_same(
        "part Cell(gap, number) { const n = number; coord x[n]; for i in 0..n { kinetic = gap * dot(x[i])^2; } }
         part Row(gap, count) { for i in 0..count { cell[i]: Cell { gap: gap + i; number: i + 1; } } output last = cell[count - 1].x[count - 1]; }
         row[i in 0..2]: Row { gap: [3, 4]; count: 2; } output far = row[1].cell[1].x[0];",
        "const row_0_cell_0_n = 0 + 1; coord row_0_cell_0_x[1]; kinetic = (3 + 0) * dot(row_0_cell_0_x[0])^2;
         const row_0_cell_1_n = 1 + 1; coord row_0_cell_1_x[2]; kinetic = (3 + 1) * dot(row_0_cell_1_x[0])^2; kinetic = (3 + 1) * dot(row_0_cell_1_x[1])^2;
         output row_0_last = row_0_cell_1_x[1];
         const row_1_cell_0_n = 0 + 1; coord row_1_cell_0_x[1]; kinetic = (4 + 0) * dot(row_1_cell_0_x[0])^2;
         const row_1_cell_1_n = 1 + 1; coord row_1_cell_1_x[2]; kinetic = (4 + 1) * dot(row_1_cell_1_x[0])^2; kinetic = (4 + 1) * dot(row_1_cell_1_x[1])^2;
         output row_1_last = row_1_cell_1_x[1];
         output far = row_1_cell_1_x[0];",
    );
    // A part can also be an argument.
    assert_same(
        "part Shaft { coord q; kinetic = dot(q)^2; param k[2]; }
         part Spring(a, b) { potential = a.k[1] * (a.q - b.q)^2; }
         s[i in 0..2]: Shaft {} c: Spring { a: s[0]; b: s[1]; }",
        "coord s_0_q; kinetic = dot(s_0_q)^2; param s_0_k[2]; coord s_1_q; kinetic = dot(s_1_q)^2; param s_1_k[2];
         potential = s_0_k[1] * (s_0_q - s_1_q)^2;",
    );
}

#[test]
fn functions_and_tables_in_parts_are_their_own_but_functions_of_the_crate_keep_their_names() {
    assert_same(
        "part P { let f(x) = x^2 + k; param k; function drag(v); table g(v) = [(0, 1), (1, 2)], interpolation: linear, outside: clamp;
                  coord x; kinetic = f(dot(x)) + drag(x) + g(x); }
         a: P {} b: P {}",
        "let a_f(x) = x^2 + a_k; param a_k; function drag(v); table a_g(v) = [(0, 1), (1, 2)], interpolation: linear, outside: clamp;
         coord a_x; kinetic = a_f(dot(a_x)) + drag(a_x) + a_g(a_x);
         let b_f(x) = x^2 + b_k; param b_k; table b_g(v) = [(0, 1), (1, 2)], interpolation: linear, outside: clamp;
         coord b_x; kinetic = b_f(dot(b_x)) + drag(b_x) + b_g(b_x);",
    );
}

#[test]
fn members_are_known_as_they_are_written() {
    let text = "part P { param k[2]; coord x; quaternion hip; } leg[i in 0..2]: P {} front: P {}";
    let mut report = Report::default();
    let declaration = without_arrays(parse_text(text, &mut report).expect("tokens"), &mut report);
    let written = declaration.arrays.iter().flat_map(|array| &array.elements);
    let written =
        written.map(|element| (element.name.as_str(), element.written.as_str())).collect::<Vec<_>>();
    for pair in [
        ("leg_0_k_1", "leg[0].k[1]"),
        ("leg_1_x", "leg[1].x"),
        ("leg_1_hip_qw", "leg[1].hip_qw"),
        ("front_hip_wz", "front.hip_wz"),
    ] {
        assert!(written.contains(&pair), "{pair:?}: {written:?}");
    }
}

/// Copies of an argument count like terms of sums, and nested parts are counted before their
/// expansion.
#[test]
fn unbounded_expansion_is_refused() {
    let doubling = (0..30).map(|i| format!("part P{} (a) {{ p: P{i} {{ a: a * a; }} }}", i + 1));
    let doubling = doubling.collect::<String>();
    let cases = [
        (
            format!("part P0(a) {{ coord x; kinetic = a * dot(x); }} {doubling} coord y; p: P30 {{ a: y; }}"),
            "loops and sums up to this one expand to more than 200000 terms",
        ),
        (
            "part A { coord x; } part B { a[i in 0..1000]: A {} } part C { b[i in 0..1000]: B {} } c: C {}"
                .to_owned(),
            "placements up to this one are more than 20000",
        ),
        (
            "part A { coord x; } a[i in 0..1000000000]: A {}".to_owned(),
            "placements up to this one are more than 20000",
        ),
        (
            {
                let nested =
                    (0..33).map(|i| format!("part P{}{{ p: P{i} {{}} }}", i + 1)).collect::<String>();
                format!("part P0 {{ coord x; }} {nested} p: P33 {{}}")
            },
            "parts are nested more than 32 deep",
        ),
    ];
    for (text, message) in cases {
        let mut report = Report::default();
        let declaration = parse_text(&text, &mut report).expect("tokens");
        let declaration = without_arrays(declaration, &mut report);
        let errors = report.diagnostics().iter().map(|one| one.message.as_str()).collect::<Vec<_>>();
        assert_eq!(errors, [message], "{}", print::statements(&declaration).len());
    }
}

#[test]
fn expansion_is_idempotent() {
    let text =
        "part P(k = 1) { coord x; kinetic = k * dot(x)^2; } p[i in 0..3]: P { k: i; } output o = p[2].x;";
    let once = written_out(text);
    assert_eq!(written_out(&once), once);
}
