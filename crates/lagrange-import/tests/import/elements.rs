//! Elements that affect the motion are read or refused, whatever tool wrote them. Others are
//! skipped with a warning.

use lagrange_import::urdf::{Options, import};

use crate::judge::judged;
use crate::mistakes::{GOOD, said};

/// Returns the good file with one piece replaced by another.
fn edited(piece: &str, other: &str) -> String {
    assert!(GOOD.contains(piece), "{piece}");
    GOOD.replacen(piece, other, 1)
}

/// Elements and attributes that change the motion are errors where they are unknown.
#[test]
fn nothing_that_changes_the_motion_is_left_out() {
    let cases = [
        ("<parent", "<orgin xyz=\"1 0 0\"/><parent"),
        ("<parent", "<axsi xyz=\"1 0 0\"/><parent"),
        ("<parent", "<dynamic damping=\"1\"/><parent"),
        ("<parent", "<dynamics dampng=\"1\"/><parent"),
        ("<parent", "<inertial><mass value=\"1\"/></inertial><parent"),
        ("<parent link=\"base\"/>", "<parent link=\"base\" frame=\"tool\"/>"),
        ("xyz=\"0 0 0.1\"", "xyz=\"0 0 0.1\" rpy_deg=\"90 0 0\""),
        ("xyz=\"0 0 0.1\"", "xyz=\"0 0 0.1\" quat_wxyz=\"1 0 0 0\""),
        ("value=\"1\"", "value=\"1\" unit=\"lb\""),
        ("ixx=\"1\"", "ixx=\"1\" about=\"link\""),
        ("<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 0 1\" expressed_in=\"world\"/>"),
        ("<link name=\"base\"/>", "<link name=\"base\"><mass value=\"1\"/></link>"),
        ("<link name=\"base\"/>", "<link name=\"base\"><inertia ixx=\"1\"/></link>"),
        ("<link name=\"base\"/>", "<link name=\"base\"><origin xyz=\"0 1 0\"/></link>"),
        ("<link name=\"base\"/>", "<link name=\"base\"><joint name=\"j\"/></link>"),
        ("<link name=\"base\"/>", "<link name=\"base\"/><origin rpy=\"0 1 0\"/>"),
        ("<link name=\"base\"/>", "<link name=\"base\"/><jiont name=\"j\"/>"),
        ("<link name=\"base\"/>", "<link name=\"base\"/><linc name=\"j\"/>"),
        ("<robot name=\"r\">", "<robot name=\"r\" version=\"2.0\">"),
    ];
    for (piece, other) in cases {
        let said = said(&edited(piece, other));
        assert!(said.iter().any(|line| line.contains(": error: ")), "{other}: {said:?}");
    }
}

#[test]
fn elements_of_other_programs_are_skipped_with_a_warning() {
    let cases = [
        ("<parent", "<hardwareInterface/><parent"),
        ("<parent", "<dynamics damping=\"0\" K=\"7000\"/><parent"),
        ("<inertial>", "<gravity>1</gravity><inertial>"),
        ("<inertial>", "<origin xyz=\"0 0 0\" rpy=\"0 -0 0\"/><inertial>"),
        ("type=\"revolute\"", "type=\"revolute\" dont_collapse=\"true\""),
        ("<robot name=\"r\">", "<robot name=\"r\" version=\"1.0\"><muscle/>"),
    ];
    for (piece, other) in cases {
        let said = said(&edited(piece, other));
        assert!(said.len() == 1 && said[0].contains(": warning: "), "{other}: {said:?}");
    }
}

#[test]
fn elements_of_other_namespaces_are_not_part_of_the_robot() {
    let drake = "<robot name=\"r\" xmlns:drake=\"http://drake.mit.edu\">";
    let plain = import(GOOD, &Options::default()).expect("a robot").declaration;
    let foreign = "<drake:joint name=\"p\" type=\"ball\"/><drake:link name=\"l\"><inertial/></drake:link>";
    let text = edited("<robot name=\"r\">", drake)
        .replacen("</robot>", &format!("{foreign}</robot>"), 1)
        .replacen("<mass value=\"1\"/>", "<drake:mass value=\"2\"/><mass drake:value=\"3\" value=\"1\"/>", 1)
        .replacen("<axis", "<drake:axis xyz=\"1 0 0\"/><axis", 1);
    let imported = import(&text, &Options::default()).expect("a robot");
    assert_eq!(imported.declaration, plain);
    let warnings = imported.warnings.iter().map(ToString::to_string).collect::<Vec<_>>();
    assert_eq!(
        warnings,
        [
            "6:1: warning: names with the prefix `drake:` belong to another program and are ignored, here and in 4 more places"
        ]
    );
    let undeclared = import(&edited("</robot>", foreign), &Options::default()).expect_err("no such prefix");
    assert_eq!(undeclared[0].help.as_deref(), Some("declare the prefix: `<robot xmlns:drake=\"drake\" …>`"));
    // A namespace of the whole file is also that of its links.
    let whole = edited("<robot name=\"r\">", "<robot name=\"r\" xmlns=\"http://www.ros.org\">");
    assert_eq!(import(&whole, &Options::default()).expect("a robot").declaration, plain);
}

/// Returns the line of the joint whose origin has these attributes.
fn joint(attributes: &str) -> String {
    let text = edited("xyz=\"0 0 1\" rpy=\"0 0 0\"", attributes);
    let declaration = import(&text, &Options::default()).expect("a robot").declaration;
    declaration.lines().find(|line| line.contains("revolute")).expect("a joint").trim().to_owned()
}

#[test]
fn quaternions_turn_as_roll_pitch_and_yaw_do() {
    for rpy in [
        [0.3, -0.4, 0.5],
        [3.0, 1.5, -3.0],
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, -1.2, 0.0],
        [0.0, 0.0, 2.5],
        [0.0, std::f64::consts::FRAC_PI_2, 0.7],
    ] {
        // The product of three rotations about coordinate axes, by half angles.
        let [(sr, cr), (sp, cp), (sy, cy)] = rpy.map(|angle: f64| (0.5 * angle).sin_cos());
        let quaternion = [
            sr * cp * cy - cr * sp * sy,
            cr * sp * cy + sr * cp * sy,
            cr * cp * sy - sr * sp * cy,
            cr * cp * cy + sr * sp * sy,
        ];
        for scale in [1.0, -1.0, 1e-200, 1e200] {
            let [x, y, z, w] = quaternion.map(|component| scale * component);
            let read = angles(&joint(&format!("quat_xyzw=\"{x:e} {y:e} {z:e} {w:e}\"")));
            let distance = read.iter().zip(&rpy).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(distance < 4e-15, "{rpy:?} {read:?}");
        }
    }
    assert_eq!(
        joint("quat_xyzw=\"0 0 0.7071067811865476 0.7071067811865476\""),
        joint("rpy=\"0 0 1.5707963267948966\"")
    );
}

/// Returns roll, pitch and yaw of a joint as written.
fn angles(line: &str) -> [f64; 3] {
    let Some((_, behind)) = line.split_once("turned: (") else { return [0.0; 3] };
    let (list, _) = behind.split_once(')').expect("a list");
    let angle = |text: &str| match text {
        "pi/2" => std::f64::consts::FRAC_PI_2,
        _ => text.parse::<f64>().expect("a number"),
    };
    list.split(", ").map(angle).collect::<Vec<_>>().try_into().expect("three")
}

#[test]
fn impossible_orientations_are_mistakes() {
    let cases = [
        ("quat_xyzw=\"0 0 0 0\"", "11:9: error: joint \"q\", <origin>: the quaternion is zero"),
        (
            "quat_xyzw=\"0 0 1\"",
            "11:9: error: joint \"q\", <origin>: `quat_xyzw` must be four numbers, but these are 3",
        ),
        (
            "quat_xyzw=\"0 0 0 1\" rpy=\"0 0 0\"",
            "11:1: error: joint \"q\", <origin>: `rpy` and `quat_xyzw` both state the orientation",
        ),
        (
            "quat_xyzw=\"0 0 0 nan\"",
            "11:9: error: joint \"q\", <origin>: `quat_xyzw` must be a number, but this is \"nan\"",
        ),
    ];
    for (attributes, expected) in cases {
        assert_eq!(said(&edited("xyz=\"0 0 1\" rpy=\"0 0 0\"", attributes)), [expected]);
    }
}

/// The compiler refuses characters in comments that reverse the direction of text.
#[test]
fn names_reach_the_declaration_in_letters_that_are_seen() {
    let names = ["a\u{202e}b", "\u{2066}x\u{2069}", "n\u{200b}n", "\u{feff}", "ok\u{85}\u{ad}", "`*/ \n//"];
    for name in names {
        let text = GOOD.replace("\"r\"", &format!("\"{name}\"")).replace("\"arm\"", &format!("\"{name}\""));
        let text = text.replace("name=\"q\"", &format!("name=\"{name}\""));
        for kind in ["revolute", "floating", "planar"] {
            let text = text.replace("revolute", kind);
            let declaration = import(&text, &Options::default()).expect("a robot").declaration;
            let is_seen =
                |letter: char| letter == '\n' || !letter.is_control() && letter.is_ascii() || letter == '…';
            assert!(declaration.chars().all(is_seen), "{declaration:?}");
            judged(&text, &Options::default());
        }
    }
    let name = "Gelenk-ä-関節-e\u{301}";
    let declaration = import(&GOOD.replace("\"q\"", &format!("\"{name}\"")), &Options::default());
    assert!(declaration.expect("a robot").declaration.contains(&format!("Joint `{name}` of the file.")));
}

/// Returns one link on a joint, with an empty base and these moments of inertia.
fn thin(moments: [&str; 3], joint: &str) -> String {
    let [xx, yy, zz] = moments;
    edited("ixx=\"1\" iyy=\"1\" izz=\"1\"", &format!("ixx=\"{xx}\" iyy=\"{yy}\" izz=\"{zz}\""))
        .replacen("xyz=\"0 0 0.1\"", "xyz=\"0 0 0\"", 1)
        .replacen("type=\"revolute\"", &format!("type=\"{joint}\""), 1)
}

#[test]
fn motions_without_inertia_are_mistakes_of_the_file() {
    let free = Options { is_free: true, ..Options::default() };
    let cases = [
        (
            thin(["1", "1", "1"], "revolute"),
            &free,
            Some("link \"base\": it lacks mass or moments of inertia"),
        ),
        (thin(["0", "0", "0"], "revolute"), &Options::default(), Some("link \"arm\": it lacks mass")),
        (thin(["1", "1", "0"], "revolute"), &Options::default(), Some("link \"arm\": it lacks mass")),
        (thin(["1", "1", "0"], "floating"), &Options::default(), Some("link \"arm\": it lacks mass")),
        (thin(["0", "0", "0"], "prismatic"), &Options::default(), None),
        (
            thin(["1", "1", "0"], "revolute").replace("axis xyz=\"0 0 1\"", "axis xyz=\"1 0 0\""),
            &Options::default(),
            None,
        ),
        (thin(["1", "1", "1"], "fixed"), &free, None),
    ];
    for (text, options, expected) in cases {
        let result = import(&text, options);
        match expected {
            None => assert!(result.is_ok(), "{text}\n{result:?}"),
            Some(expected) => {
                let mistakes = result.expect_err(&text);
                let told = mistakes.iter().map(ToString::to_string).collect::<Vec<_>>();
                assert!(told.len() == 1 && told[0].contains(expected), "{told:?}");
                assert!(mistakes[0].help.is_some(), "{told:?}");
            }
        }
        judged(&text, options);
    }
}
