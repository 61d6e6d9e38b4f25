//! Contacts as events and frictions, or as energies and forces.

use lagrange_core::pipeline::parse;
use lagrange_core::syntax::print;

use super::derive;

/// Returns the plain events, frictions and forces, and the `let`s whose names contain a word.
fn plain(text: &str, word: &str) -> Vec<String> {
    let system = parse(text).unwrap_or_else(|report| panic!("{report}"));
    let text = print::statements(&system.declaration);
    let is_wanted = |line: &&str| {
        ["event", "friction", "force"].iter().any(|start| line.starts_with(start))
            || line.starts_with("let") && line.split('=').next().is_some_and(|name| name.contains(word))
    };
    text.lines().filter(is_wanted).map(str::to_owned).collect()
}

#[test]
fn a_disk_on_a_line_is_a_gap_and_a_slip_velocity() {
    let found = plain(
        "param r = 0.3, mu = 0.4, e = 0.1;
        coord x, y, phi;
        line slope { angle: 0.2; }
        body wheel { mass: 2; center: (x, y); angle: phi; shape: disk(r); }
        contact touch = wheel on slope { friction: mu; restitution: e; }",
        "touch",
    );
    let wanted = [
        "let touch_gap = -(sin(0.2) * wheel_center.x) + cos(0.2) * wheel_center.y - r;",
        "event touch = touch_gap, falling => impact(e);",
        "let touch_slip = cos(0.2) * dot(wheel_center.x) + sin(0.2) * dot(wheel_center.y) + r * dot(phi);",
        "friction touch_friction = touch_slip, mu * touch;",
    ];
    assert_eq!(found, wanted);
}

#[test]
fn a_point_on_the_ground_without_friction_is_an_event() {
    let found = plain(
        "coord x, y;
        body mass { mass: 2; center: (x, y); }
        contact touch = mass on ground;",
        "touch",
    );
    assert_eq!(found, ["let touch_gap = mass_center.y;", "event touch = touch_gap, falling => impact(0);"]);
}

#[test]
fn a_surface_that_moves_by_itself_moves_against_what_touches_it() {
    let found = plain(
        "param v = 2;
        coord x, y;
        line belt { through: (v * t, sin(t)); }
        circle drum { center: (cos(t), -3); radius: 2; }
        body mass { mass: 2; center: (x, y); }
        contact touch = mass on belt { friction: 0.2; }
        contact other = mass on drum { friction: 0.2; }",
        "slip",
    );
    assert_eq!(found[1], "let touch_slip = dot(mass_center.x) - dot(v * t);");
    let slip = "let other_slip = other_normal.y * (dot(mass_center.x) - dot(cos(t))) - other_normal.x * dot(mass_center.y);";
    assert_eq!(found[4], slip);
}

#[test]
fn corners_are_an_array_of_contacts_also_of_bodies_in_a_loop() {
    let text = "param mu = 0.4;
        coord x[2], y[2], phi[2];
        for i in 0..2 {
            body case[i] { mass: 2; center: (x[i], y[i]); angle: phi[i]; shape: rectangle(0.4, 0.2); }
            contact foot[i] = case[i] on ground { kinetic: mu; static: 2 * mu; }
        }
        output load = foot[1][3] + foot[0][2].gap;";
    let found = plain(text, "nothing");
    assert_eq!(found.len(), 16);
    assert!(found.contains(&"event foot_1_3 = foot_1_3_gap, falling => impact(0);".to_owned()));
    let friction =
        "friction foot_0_2_friction = foot_0_2_slip, kinetic: mu * foot_0_2, static: 2 * mu * foot_0_2;";
    assert!(found.contains(&friction.to_owned()), "{found:?}");
    derive(text);
}

#[test]
fn a_contact_with_a_stiffness_is_a_potential_and_forces() {
    let text = "param k = 1e4, d = 0.5, v = 0.001;
        gravity = (0, 0, -9.81);
        body ball { mass: 2; shape: solid_sphere(0.1); }
        free ball;
        contact touch = ball on ground { friction: 0.4; stiffness: k; dissipation: d; stiction: v; }";
    let wanted = [
        "let touch_gap = ball_z - 0.1;",
        "let touch_depth = if 0 < -touch_gap { -touch_gap } else { 0 };",
        "let touch_dissipation = k * touch_depth * max(d * dot(touch_depth), -1);",
        "force touch_dissipation along dot(touch_gap);",
        "let touch = k * touch_depth + touch_dissipation;",
        "let touch_slip = (dot(ball_x) - 0.1 * (ball_wx * ball_R_y.x + ball_wy * ball_R_y.y + ball_wz * ball_R_y.z), dot(ball_y) + 0.1 * (ball_wx * ball_R_x.x + ball_wy * ball_R_x.y + ball_wz * ball_R_x.z));",
        "let touch_friction_grip = 0.4 * touch / sqrt(touch_slip.x^2 + touch_slip.y^2 + v^2);",
        "let touch_friction = (-(touch_friction_grip * touch_slip.x), -(touch_friction_grip * touch_slip.y));",
        "force touch_friction along touch_slip;",
    ];
    assert_eq!(plain(text, "touch"), wanted);
    let system = parse(text).unwrap_or_else(|report| panic!("{report}"));
    let statements = print::statements(&system.declaration);
    assert!(statements.contains("potential = 1/2 * k * touch_depth^2;"));
    let derived = derive(&format!("{text} emit {{ power }}"));
    let powers = derived.model.outputs.iter().map(|output| output.name.as_str()).collect::<Vec<_>>();
    assert_eq!(powers, ["power_touch_dissipation", "power_touch_friction", "power_balance"]);
}

#[test]
fn friction_against_turning_is_a_friction_along_angular_velocities() {
    let text = "param mu = 0.4;
        gravity = (0, 0, -9.81);
        body ball { mass: 2; shape: solid_sphere(0.1); }
        free ball;
        contact touch = ball on ground { friction: mu; rolling: 0.002; spinning: mu / 100; }";
    let found = plain(text, "touch_s");
    let wanted = [
        "friction touch_friction = touch_slip, mu * touch;",
        "friction touch_rolling = touch_turning, 0.002 * touch;",
        "friction touch_spinning = touch_spin, mu/100 * touch;",
    ];
    wanted.iter().for_each(|line| assert!(found.contains(&line.to_string()), "{found:?}"));
    let spin = "let touch_spin = ball_wx * ball_R_z.x + ball_wy * ball_R_z.y + ball_wz * ball_R_z.z;";
    assert!(found.contains(&spin.to_owned()), "{found:?}");
    let names = derive(text).model.reactions.into_iter().map(|reaction| reaction.name).collect::<Vec<_>>();
    let wanted = [
        "touch",
        "touch_friction_x",
        "touch_friction_y",
        "touch_rolling_x",
        "touch_rolling_y",
        "touch_spinning",
    ];
    assert_eq!(names, wanted);
    let flat = "coord x, y, phi;
        body wheel { mass: 2; center: (x, y); angle: phi; shape: disk(0.1); }
        contact touch = wheel on ground { friction: 0.4; rolling: 0.002; }
        contact smooth = wheel on ground { rolling: 0.002; stiffness: 1e4; stiction_rate: 0.01; }";
    let found = plain(flat, "smooth_");
    for line in [
        "friction touch_rolling = touch_turning, 0.002 * touch;",
        "let smooth_turning = dot(phi);",
        "let smooth_rolling = -(smooth_rolling_grip * smooth_turning);",
        "force smooth_rolling along smooth_turning;",
    ] {
        assert!(found.contains(&line.to_owned()), "{line} {found:?}");
    }
}

/// Labels of all contacts, written in each contact, declare the same system.
#[test]
fn labels_of_all_contacts_are_those_of_each() {
    let text = |all: &str, first: &str, second: &str, third: &str| {
        format!(
            "{all} param k = 1e4, k_foot = 2e4;
            part Foot {{
                param k_foot = 5;
                body toe {{ mass: 1; shape: solid_sphere(0.1); }}
                free toe;
                contact touch = toe on ground {{ rolling: 0.01; {third} }}
            }}
            gravity = (0, 0, -9.81);
            body ball {{ mass: 2; shape: solid_sphere(0.1); }}
            body case {{ mass: 2; shape: cuboid(0.1, 0.1, 0.1); }}
            free ball; free case;
            contact touch = ball on ground {{ friction: 0.4; {first} }}
            contact foot = case on ground {{ {second} }}
            a: Foot {{}}"
        )
    };
    let statements = |text: &str| {
        let system = parse(text).unwrap_or_else(|report| panic!("{report}"));
        print::statements(&system.declaration)
    };
    let block = "contacts: compliant { penetration: 1e-3; load: k * 1e-3; dissipation: 0.5; stiction: 0.01; stiction_rate: 0.1; }";
    let found = statements(&text(block, "", "stiffness: k_foot; dissipation: 0;", "dissipation: 2;"));
    let law = "penetration: 1e-3; load: k * 1e-3;";
    let touch = format!("{law} dissipation: 0.5; stiction: 0.01;");
    let third = "penetration: 1e-3; load: 1e4 * 1e-3; dissipation: 2; stiction_rate: 0.1;";
    let wanted = statements(&text("", &touch, "stiffness: k_foot; dissipation: 0;", third));
    let in_numbers = |text: &str| text.replace("k * 0.001", "10000 * 0.001");
    assert_eq!(in_numbers(&found), in_numbers(&wanted));
    // Rigid contacts are the default.
    let rigid = statements(&text("contacts: rigid;", "", "", ""));
    assert_eq!(rigid, statements(&text("", "", "", "")));
}

#[test]
fn a_load_over_a_penetration_has_the_unit_of_a_stiffness() {
    let text = |law: &str| {
        format!(
            "param m: kg = 2, g: m/s^2 = 9.81, depth: m = 1e-4;
            coord x: m, y: m, phi: rad;
            gravity = (0, -g);
            contacts: compliant {{ {law} dissipation: 1 [s/m]; stiction: 1 [mm/s]; stiction_rate: 0.01; }}
            body wheel {{ mass: m; center: (x, y); angle: phi; shape: disk(0.1 [m]); }}
            contact touch = wheel on ground {{ friction: 0.4; rolling: 1 [mm]; }}
            output moment: N*m = touch.rolling;"
        )
    };
    derive(&text("penetration: depth; load: m * g;"));
    derive(&text("penetration: 0.1 [mm]; load: 20;"));
    for law in ["penetration: m; load: m * g;", "penetration: depth; load: m;", "stiffness: m;"] {
        assert!(parse(&text(law)).is_err(), "{law}");
    }
    let rigid = text("").replace(
        "contacts: compliant {  dissipation: 1 [s/m]; stiction: 1 [mm/s]; stiction_rate: 0.01; }",
        "",
    );
    derive(&rigid);
    assert!(parse(&rigid.replace("1 [mm]", "1 [N]")).is_err());
}

/// Each gap has one surface and, with dissipation, another where the force would pull.
#[test]
fn sixteen_compliant_contacts_have_32_surfaces() {
    let text = |dissipation: &str| {
        format!(
            "gravity = (0, 0, -9.81);
            for i in 0..2 {{
                body case[i] {{ mass: 2; shape: cuboid(0.4, 0.2, 0.1); }}
                free case[i];
                contact foot[i] = case[i] on ground {{ friction: 0.4; stiffness: 1e4; {dissipation} stiction: 0.01; }}
            }}"
        )
    };
    for (dissipation, surfaces) in [("", 16), ("dissipation: 0.5;", 32)] {
        let derived = derive(&text(dissipation));
        assert_eq!(derived.equations.switches.len(), surfaces);
        assert!(derived.model.reactions.is_empty());
    }
}

/// Names that a contact declares cause no warning if nothing uses them.
#[test]
fn a_contact_need_not_be_mentioned() {
    for contact in ["inside bowl;", "inside bowl { stiffness: 1e4; }", "on ground { stiffness: 1e4; }"] {
        let text = format!(
            "coord x, y;
            circle bowl {{ radius: 1; }}
            body ball {{ mass: 0.5; center: (x, y); angle: 0; shape: disk(0.1); }}
            contact touch = ball {contact}"
        );
        let system = parse(&text).unwrap_or_else(|report| panic!("{report}"));
        assert!(print::statements(&system.declaration).contains("touch_gap"));
        let diagnostics = system.report.diagnostics();
        assert!(diagnostics.is_empty(), "{diagnostics:?}");
    }
}

/// Under a point, terrain has its slope. The coordinate of a height does not capture a parameter of
/// the same name in a function.
#[test]
fn a_point_on_terrain_is_a_height_over_a_slope() {
    let found = plain(
        "param a = 0.3, x = 2;
        let wave(s) = a * sin(x * s);
        coord u, w;
        terrain road { height(x): wave(x) + sum(i in 1..3, i); }
        body bead { mass: 2; center: (u, w); }
        contact touch = bead on road { friction: 0.1; }",
        "touch",
    );
    let height = "a * sin(x * touch_x) + (1 + 2)";
    let wanted = [
        "let touch_x = bead_center.x;",
        &format!("let touch_slope_x = partial({height}, touch_x);"),
        "let touch_steepness = sqrt(1 + touch_slope_x^2);",
        "let touch_normal = (-(touch_slope_x/touch_steepness), 1/touch_steepness);",
        &format!("let touch_gap = (bead_center.y - ({height})) / touch_steepness;"),
        "event touch = touch_gap, falling => impact(0);",
        "let touch_slip = touch_normal.y * dot(bead_center.x) - touch_normal.x * dot(bead_center.y);",
        "friction touch_friction = touch_slip, 0.1 * touch;",
    ];
    assert_eq!(found, wanted);
}

#[test]
fn terrain_in_parts_has_the_names_of_its_part() {
    let found = plain(
        "part Road(on, size) {
            param a = 5;
            let square(s) = s^2;
            for i in 0..2 { terrain lane[i] { on: on; height(x): size * (a * square(x) + i); } }
        }
        coord s, u, w;
        body cart { mass: 1; origin: (s, 0); }
        road: Road { on: cart; size: 2 * s; }
        body bead { mass: 2; center: (u, w); }
        contact touch = bead on road.lane[1];",
        "touch_slope",
    );
    let slope = "let touch_slope_x = partial(2 * s * (road_a * touch_x^2 + 1), touch_x);";
    assert_eq!(found, [slope, "event touch = touch_gap, falling => impact(0);"]);
}

#[test]
fn the_words_of_contacts_are_free_as_names() {
    derive(
        "param contact = 1, plane = 2, circle = 3, sphere = 4, cylinder = 5, inside = 6, terrain = 7;
        coord x;
        kinetic = 1/2 * (contact + plane + circle + sphere + cylinder + inside + terrain) * dot(x)^2;",
    );
}
