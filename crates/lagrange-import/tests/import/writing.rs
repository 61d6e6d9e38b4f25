//! The text of declarations, which must be read with the intended meaning.
//!
//! `UPDATE_GOLDEN=1 cargo test -p lagrange-import` writes the golden files: review the diff.

use std::{env, fs};

use lagrange_core::diagnostics::Report;
use lagrange_core::syntax::parse_text;
use lagrange_core::syntax::print;
use lagrange_import::urdf::{Options, import};

use crate::files::{imported, path, read};
use crate::reference::statements;

const FILES: [&str; 4] =
    ["every_joint.urdf", "tree_of_30.urdf", "tilted_plane.urdf", "tilted_plane_by_hand.urdf"];

fn options() -> [Options; 3] {
    let plain = Options::default();
    [
        Options { is_free: true, ..plain.clone() },
        Options { has_inputs: true, name: Some("Other".to_owned()), ..plain.clone() },
        plain,
    ]
}

fn assert_golden(name: &str, written: &str) {
    if env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(path(name), written).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
    assert_eq!(written, read(name), "{name} is written in another way; UPDATE_GOLDEN=1 rewrites it");
}

#[test]
fn declarations_are_written_as_they_were_read_and_judged() {
    assert_golden("every_joint.rs", &imported("every_joint.urdf", &Options::default()).declaration);
    let warnings = imported("every_joint.urdf", &Options::default()).warnings;
    let warnings = warnings.iter().map(|warning| format!("{warning}\n")).collect::<String>();
    assert_golden("every_joint.warnings", &warnings);
    assert_golden("tilted_plane.rs", &imported("tilted_plane.urdf", &Options::default()).declaration);
    let options = Options { is_free: true, has_inputs: true, ..Options::default() };
    assert_golden("tree_of_30_free.rs", &imported("tree_of_30.urdf", &options).declaration);
    let options = Options { has_limits: true, has_friction: true, has_contacts: true, ..options };
    assert_golden("walker_standing.rs", &imported("walker.urdf", &options).declaration);
}

#[test]
fn printing_is_idempotent() {
    for file in FILES {
        for options in options() {
            let declaration = imported(file, &options).declaration;
            let printed = printed(statements(&declaration));
            assert_eq!(self::printed(&printed), printed, "{file}");
            assert!(!printed.contains('?'), "{printed}");
        }
    }
}

fn printed(text: &str) -> String {
    let mut report = Report::default();
    let declaration = parse_text(text, &mut report).expect("a declaration");
    assert!(report.diagnostics().is_empty(), "{report}");
    print::statements(&declaration)
}

#[test]
fn declarations_are_as_wide_as_a_screen_and_end_no_line_in_a_blank() {
    for file in FILES {
        let declaration = imported(file, &Options::default()).declaration;
        let wrong = declaration.lines().find(|line| line.chars().count() > 120 || line.ends_with(' '));
        assert_eq!(wrong, None, "{file}");
    }
}

/// Returns a robot with one link on a joint.
pub(crate) fn robot(link: &str, joint: &str) -> String {
    format!(
        r#"<robot name="r"><link name="base"/><link name="arm"><inertial><mass value="1"/>
        <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>{link}</link>
        <joint name="q" type="revolute"><parent link="base"/><child link="arm"/>{joint}</joint></robot>"#
    )
}

fn line_of(joint: &str) -> String {
    let declaration = import(&robot("", joint), &Options::default()).expect("a robot").declaration;
    let line = declaration.lines().find(|line| line.trim_start().starts_with("revolute")).expect("a joint");
    line.trim().to_owned()
}

#[test]
fn quarter_turns_are_exact_and_other_angles_as_they_are() {
    let cases = [
        ("1.57079632679 0 0", "(pi/2, 0, 0)"),
        ("0 -3.14159265359 1.5707963267948966", "(0, -pi, pi/2)"),
        ("1.5708 0 0.50", "(1.5708, 0, 0.5)"),
        ("0 1.570796325 0", "(0, 1.570796325, 0)"),
    ];
    for (rpy, turned) in cases {
        let line = line_of(&format!(r#"<origin rpy="{rpy}"/>"#));
        assert_eq!(line, format!("revolute q = ground to arm {{ turned: {turned}; axis: (1, 0, 0); }}"));
    }
    assert_eq!(
        line_of(r#"<origin rpy="1e-11 0 -2e-10"/>"#),
        "revolute q = ground to arm { axis: (1, 0, 0); }"
    );
}

#[test]
fn axes_are_those_of_the_file_and_coordinate_axes_exact() {
    let cases = [
        ("0 0 1", "revolute q = ground to arm;"),
        ("0 0 -2", "revolute q = ground to arm { axis: (0, 0, -1); }"),
        ("0 1 -4.9e-12", "revolute q = ground to arm { axis: (0, 1, 0); }"),
        ("0.70 0 0.7", "revolute q = ground to arm { axis: (0.7, 0, 0.7); }"),
        ("0 0 1e-3", "revolute q = ground to arm;"),
    ];
    for (xyz, line) in cases {
        assert_eq!(line_of(&format!(r#"<axis xyz="{xyz}"/>"#)), line);
    }
    assert_eq!(line_of(""), "revolute q = ground to arm { axis: (1, 0, 0); }");
}

#[test]
fn bases_with_mass_are_welded_to_the_ground_unless_they_are_free() {
    let massive = robot("", "").replacen(
        r#"<link name="base"/>"#,
        r#"<link name="base"><inertial><mass value="4"/>
        <inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>"#,
        1,
    );
    let fixed = import(&massive, &Options::default()).expect("a robot").declaration;
    assert!(fixed.contains("body base {") && fixed.contains("\n    weld ground to base;\n"), "{fixed}");
    let options = Options { is_free: true, ..Options::default() };
    let free = import(&massive, &options).expect("a robot").declaration;
    assert!(free.contains("\n    free base;\n") && !free.contains("weld"), "{free}");
}

#[test]
fn inertia_that_no_body_has_becomes_parameters_if_it_is_trusted() {
    let wrong = robot("", "").replace(r#"izz="1""#, r#"izz="3""#);
    import(&wrong, &Options::default()).expect_err("no body has it");
    let options = Options { trusts_inertia: true, ..Options::default() };
    let imported = import(&wrong, &options).expect("a robot");
    let lines = [
        "    /// No body has the inertia that the file states of `arm`.",
        "    param arm_xx = 1, arm_yy = 1, arm_zz = 3;",
        "    body arm { mass: 1; inertia: (arm_xx, arm_yy, arm_zz); }",
    ];
    assert!(imported.declaration.contains(&lines.join("\n")), "{}", imported.declaration);
    assert_eq!(imported.warnings.len(), 1);
}
