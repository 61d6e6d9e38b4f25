//! Limits, dry friction and contacts: their text, and the motion that follows.

use lagrange_import::urdf::{Options, import};

use crate::writing::robot;

/// Returns options with all limits, friction and contacts.
fn all() -> Options {
    Options {
        has_inputs: true,
        has_limits: true,
        has_friction: true,
        has_contacts: true,
        ..Options::default()
    }
}

/// Returns a leg with a motor, limits that exclude zero, dry friction, a ball as its foot and a
/// box.
fn leg() -> String {
    let shapes = r#"<collision><origin xyz="0 0 -0.2"/><geometry><sphere radius="0.02"/></geometry></collision>
        <collision><origin xyz="0.1 0 0" rpy="0 0 1.5707963267948966"/><geometry><box size="0.4 0.2 0.1"/></geometry></collision>
        <collision><origin xyz="0 0.3 0" rpy="0 -1.5707963267948966 0"/>
            <geometry><cylinder radius="0.1" length="1"/></geometry></collision>"#;
    robot(shapes, r#"<limit lower="-2.5" upper="-0.5" effort="20"/><dynamics friction="0.3"/>"#)
}

#[test]
fn stops_friction_and_contacts_are_written_if_they_are_wanted() {
    let options = Options { corners: vec!["arm".to_owned()], ..all() };
    let imported = import(&leg(), &options).expect("a robot");
    let lines = "
    input u_q;
    force q = max(-20, min(20, u_q));

    event q_lower = q + 2.5, falling => impact(0);
    event q_upper = -0.5 - q, falling => impact(0);
    start q = -1.5;

    friction q_friction = dot(q), 0.3;

    /// Coefficient of friction on the ground; the file states none.
    param mu >= 0 = 0.6;
    contact arm_touch = arm.point(0, 0, -0.2) on ground { friction: mu; radius: 0.02; }
    contact arm_corner[0] = arm.point(0.2, -0.2, -0.05) on ground { friction: mu; }
    contact arm_corner[1] = arm.point(0.2, 0.2, -0.05) on ground { friction: mu; }
    contact arm_corner[2] = arm.point(0, -0.2, -0.05) on ground { friction: mu; }
    contact arm_corner[3] = arm.point(0, 0.2, -0.05) on ground { friction: mu; }
    contact arm_corner[4] = arm.point(0.2, -0.2, 0.05) on ground { friction: mu; }
    contact arm_corner[5] = arm.point(0.2, 0.2, 0.05) on ground { friction: mu; }
    contact arm_corner[6] = arm.point(0, -0.2, 0.05) on ground { friction: mu; }
    contact arm_corner[7] = arm.point(0, 0.2, 0.05) on ground { friction: mu; }
    contact arm_rim[0] = arm.point(0.5, 0.3, 0) on ground { friction: mu; rim: 0.1; axis: (-1, 0, 0); }
    contact arm_rim[1] = arm.point(-0.5, 0.3, 0) on ground { friction: mu; rim: 0.1; axis: (-1, 0, 0); }
}
";
    assert!(imported.declaration.ends_with(lines), "{}", imported.declaration);
    assert!(messages(&leg(), &options).is_empty());
    assert_eq!(
        messages(&leg(), &all()),
        [
            "its collision shape is a box, for which no contact is added",
            "its collision shape is a cylinder, for which no contact is added"
        ]
    );
    let plain = import(&leg(), &Options::default()).expect("a robot").declaration;
    assert!(
        ["event", "friction q", "contact", "start", "max"].iter().all(|word| !plain.contains(word)),
        "{plain}"
    );
}

/// Returns messages without help, of warnings or errors.
fn messages(text: &str, options: &Options) -> Vec<String> {
    let mistakes = import(text, options).map_or_else(|mistakes| mistakes, |imported| imported.warnings);
    mistakes.into_iter().map(|mistake| mistake.message).collect()
}

#[test]
fn impossible_requests_are_reported() {
    let cornered = |link: &str| Options { corners: vec![link.to_owned()], ..Options::default() };
    let free = Options { is_free: true, ..all() };
    let nothing = "no moving link has a sphere as its collision shape";
    let no_effort = r#"<limit lower="-1" upper="1" effort="0"/>"#;
    let boxed = r#"<collision><geometry><box size="1 1 1"/></geometry></collision>"#;
    let base = r#"<link name="base"><inertial><mass value="1"/>
        <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>"#;
    let massive = robot(boxed, "").replace(r#"<link name="base"/>"#, base);
    let cases: [(String, Options, &[&str]); 7] = [
        (
            robot("", r#"<limit lower="0" upper="0"/>"#),
            all(),
            &[nothing, "its limits leave no range of motion, so no stops are added"],
        ),
        (robot("", no_effort), all(), &[nothing, "its effort is not positive, so its input is not limited"]),
        (
            robot("", r#"<dynamics friction="-1"/>"#),
            all(),
            &[nothing, "the dry friction is negative, so the motion would gain energy"],
        ),
        (massive, free, &[nothing, "its collision shape is a box, for which no contact is added"]),
        (robot(boxed, ""), cornered("arm"), &[]),
        (robot(boxed, ""), cornered("arms"), &["unknown link \"arms\" of `--corners`"]),
        (
            robot("", ""),
            cornered("arm"),
            &["it has no moving collision box or cylinder, so there are no corners or rims for contacts"],
        ),
    ];
    for (text, options, expected) in cases {
        assert_eq!(messages(&text, &options), expected, "{text}");
    }
}

#[test]
fn bodies_of_constant_height_have_no_contact_and_those_without_slip_no_friction() {
    let sphere =
        r#"<collision><origin xyz="0 0.1 0"/><geometry><sphere radius="0.1"/></geometry></collision>"#;
    let about_the_vertical = robot(sphere, r#"<axis xyz="0 0 1"/>"#);
    let options = Options { has_contacts: true, ..Options::default() };
    let level = "its collision shape stays at a constant height, so no contact is added";
    assert_eq!(messages(&about_the_vertical, &options), [level]);
    // The axis is horizontal, by rotations written with few digits.
    let turned = robot(sphere, r#"<origin rpy="1.5708 0 0.3"/><axis xyz="0 0 1"/>"#);
    let written = import(&turned, &options).expect("a robot");
    assert!(written.warnings.is_empty() && written.declaration.contains("{ friction: mu; radius: 0.1; }"));
    let lift = robot(sphere, r#"<axis xyz="0 0 1"/>"#).replace("revolute", "prismatic");
    let lift = import(&lift, &options).expect("a robot").declaration;
    assert!(lift.contains("contact arm_touch = arm.point(0, 0.1, 0) on ground { radius: 0.1; }"), "{lift}");
}

#[test]
fn more_contacts_than_runs_locate_are_a_warning() {
    let sphere = r#"<collision><origin xyz="0 1 0"/><geometry><sphere radius="0.1"/></geometry></collision>"#;
    let report = |count: usize| messages(&robot(&sphere.repeat(count), ""), &all());
    assert_eq!(report(32), [""; 0]);
    let message = "its limits, friction and contacts are 66, and with more than 64 the robot needs the method `Stepped`";
    assert_eq!(report(33), [message]);
}

#[test]
fn limits_have_the_defaults_of_the_format() {
    let stops = |limit: &str, kind: &str| {
        let text = robot("", limit).replace("revolute", kind);
        let declaration = import(&text, &all()).expect("a robot").declaration;
        let stops = declaration.lines().filter(|line| line.contains("event") || line.contains("start"));
        stops.map(|line| line.trim().to_owned()).collect::<Vec<_>>()
    };
    let upper = "event q_upper = 0.5 - q, falling => impact(0);";
    let lower = "event q_lower = q, falling => impact(0);";
    assert_eq!(stops(r#"<limit upper="0.5"/>"#, "prismatic"), [lower, upper]);
    let (lower, upper) =
        ("event q_lower = q + 0.5, falling => impact(0);", "event q_upper = -q, falling => impact(0);");
    assert_eq!(stops(r#"<limit lower="-0.5"/>"#, "revolute"), [lower, upper]);
    assert_eq!(stops(r#"<limit lower="-0.5" upper="0.5"/>"#, "continuous"), [""; 0]);
    let continuous = robot("", r#"<limit lower="-0.5" upper="0.5"/>"#).replace("revolute", "continuous");
    let ignored = ["a continuous joint turns without end, so `lower` and `upper` are ignored"];
    assert_eq!(messages(&continuous, &Options::default()), ignored);
}

#[test]
fn joints_that_mimic_others_have_their_stops_there() {
    let link = r#"<link name="finger"><inertial><mass value="1"/>
        <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
        <joint name="p" type="prismatic"><parent link="arm"/><child link="finger"/>"#;
    let with_follower = |leader: &str, follower: &str| {
        let text = robot("", leader).replace("</robot>", &format!("{link}{follower}</joint></robot>"));
        let imported = import(&text, &all()).expect("a robot");
        let ranges = imported.warnings.iter().filter(|warning| warning.message.contains("no range")).count();
        let stops =
            imported.declaration.lines().filter(|line| line.contains("event") || line.contains("start"));
        (stops.map(|line| line.trim().to_owned()).collect::<Vec<_>>(), ranges)
    };
    let mimic = r#"<mimic joint="q" multiplier="-2" offset="0.1"/>"#;
    let (stops, ranges) = with_follower(
        r#"<limit lower="-1" upper="0.02"/>"#,
        &format!(r#"<limit lower="0" upper="1"/>{mimic}"#),
    );
    let tighter = [
        "event q_lower = q + 0.45, falling => impact(0);",
        "event q_upper = 0.02 - q, falling => impact(0);",
        "start p = 0.1;",
    ];
    assert_eq!((stops, ranges), (tighter.map(str::to_owned).to_vec(), 0));
    let (stops, ranges) = with_follower("", &format!(r#"<limit lower="0" upper="0"/>{mimic}"#));
    assert_eq!((stops, ranges), (vec!["start p = 0.1;".to_owned()], 1));
    let (stops, ranges) = with_follower(
        r#"<limit lower="0.5" upper="1"/>"#,
        r#"<limit lower="0.1" upper="0.2"/><mimic joint="q"/>"#,
    );
    assert_eq!((stops.len(), ranges), (0, 1));
}

#[test]
fn dry_friction_of_a_joint_that_mimics_another_acts_there() {
    let finger = r#"<link name="finger"><inertial><mass value="1"/>
        <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
        <joint name="p" type="prismatic"><parent link="arm"/><child link="finger"/>
        <mimic joint="q" multiplier="-2"/><dynamics friction="0.25"/></joint></robot>"#;
    for (leader, limit) in [(r#"<dynamics friction="0.1"/>"#, "0.6"), ("", "0.5")] {
        let declaration =
            import(&robot("", leader).replace("</robot>", finger), &all()).expect("a robot").declaration;
        let lines = declaration.lines().filter(|line| line.contains("friction ")).collect::<Vec<_>>();
        assert_eq!(lines[lines.len() - 1].trim(), format!("friction q_friction = dot(q), {limit};"));
        assert!(!declaration.contains("p_friction"), "{declaration}");
    }
}
