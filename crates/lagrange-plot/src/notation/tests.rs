//! Names as symbols.

use super::{Columns, formula, unit};
use crate::lettering::{Slope, outline};

#[test]
fn names_are_written_as_in_formulas() {
    let pairs = [
        ("phi", "φ"),
        ("omega_rod", "ω_rod"),
        ("k1", "k_1"),
        ("phi2", "φ_2"),
        ("rod", "rod"),
        ("rod1", "rod1"),
        ("v_P'", "v_P′"),
        ("left_half", "left half"),
        ("left_arm", "left_arm"),
        ("wheel_2", "wheel_2"),
        ("v_left", "v_left"),
        ("omega_wheel", "ω_wheel"),
        ("torsion_spring_1", "torsion spring 1"),
        ("front_l_wheel", "front l wheel"),
        ("v_P_max", "v_{P max}"),
        ("k1_left", "k_{1 left}"),
        ("v_P1", "v_P1"),
        ("a_Q = b_longer", "a_Q = b_longer"),
        ("J_{S P}", "J_{S P}"),
        ("a__b", "a__b"),
        ("_", "_"),
        ("Delta phi", "Δ φ"),
        ("", ""),
    ];
    for (name, written) in pairs {
        assert_eq!(formula(name), written);
    }
}

#[test]
fn every_greek_letter_has_a_glyph_of_its_own() {
    for slope in [Slope::Upright, Slope::Italic] {
        let unknown = outline("\u{f8ff}", slope);
        for (name, letter) in super::GREEK {
            assert_ne!(outline(&formula(name), slope), unknown, "{name} {letter}");
        }
    }
}

/// Names of columns and their notation: a subscript in braces, a dot above as `'`.
#[test]
fn columns_are_symbols_where_their_names_are() {
    let pairs = [
        ("theta", "θ"),
        ("theta1", "θ_{1}"),
        ("theta1_dot", "θ'_{1}"),
        ("theta1_ddot", "θ''_{1}"),
        ("x_ddot", "x''"),
        ("x[2]", "x_{2}"),
        ("theta_dot[12]", "θ'_{12}"),
        ("u[1][0]", "u_{1, 0}"),
        ("x1[2]", "x_{1, 2}"),
        ("p_theta1", "p_{θ1}"),
        ("v_P", "v_{P}"),
        ("w_x_dot", "w'_{x}"),
        ("omega_rod", "ω_{rod}"),
        ("v_left_half", "v_{left half}"),
        ("Omega", "Ω"),
        ("i_dot", "ı'"),
        ("j1_ddot", "ȷ''_{1}"),
        ("i", "i"),
        ("φ_dot", "φ'"),
        ("E", "E"),
    ];
    for (name, written) in pairs {
        let label = Columns::default().label(name);
        let piece = |run: &crate::label::Run| {
            let text = run.text.replace('\u{307}', "'").replace('\u{308}', "''");
            if run.is_subscript { format!("_{{{text}}}") } else { text }
        };
        assert_eq!(label.runs().iter().map(piece).collect::<String>(), written, "{name}");
        assert!(label.runs()[0].is_symbol(), "{name}");
    }
}

#[test]
fn words_stay_as_they_are_written() {
    for name in [
        "energy",
        "angle_dot",
        "rod1",
        "wheel_2",
        "left_half",
        "current[1]",
        "a__b",
        "x_",
        "_x",
        "_",
        "",
        "_dot",
        "x_dot_dot",
        "time squared",
        "E kin",
        "Delta phi",
        "x[i]",
        "x[1",
        "x]1[",
        "x[1]a",
        "[1]",
        "v_{P}",
        "x'",
        "2",
        "θ_{1}",
        "kinetic_energy",
    ] {
        let label = Columns::default().label(name);
        assert_eq!((label.plain().as_str(), label.has_subscript()), (name, false));
    }
}

#[test]
fn names_that_would_look_alike_stay_as_they_are_written() {
    let names = ["x1", "x_1", "x[1]", "theta", "phi", "φ", "y1", "energy"];
    let columns = Columns::new(names);
    let written = names.map(|name| columns.label(name).plain());
    assert_eq!(written, ["x1", "x_1", "x[1]", "θ", "phi", "φ", "y1", "energy"]);
    let marked = names.map(|name| columns.label(name).has_subscript());
    assert_eq!(marked, [false, false, false, false, false, false, true, false]);
    // A name may be specified twice, and a name that is not a column may look like one.
    assert_eq!(Columns::new(["theta", "theta"]).label("theta").plain(), "θ");
    assert!(!Columns::new(["x1"]).label("x_1").has_subscript());
}

/// All names that look different have different labels.
#[test]
fn no_two_columns_have_the_same_label() {
    let stems =
        ["x", "x1", "x_1", "theta", "θ", "rod", "rod1", "i", "j", "x_dot", "p_x", "p_x1", "x1_2", "x_12"];
    let ends = ["", "_dot", "_ddot", "[1]", "[1][2]", "_dot[1]", "1", "2", "_P"];
    let names: Vec<String> = stems.iter().flat_map(|stem| ends.map(|end| format!("{stem}{end}"))).collect();
    let columns = Columns::new(names.iter().map(String::as_str));
    let mut labels: Vec<_> = names.iter().map(|name| (columns.label(name), name)).collect();
    labels.sort_by_key(|(label, name)| (label.content(10.0), *name));
    labels.dedup_by_key(|(_, name)| *name);
    for pair in labels.windows(2) {
        assert_ne!(pair[0].0, pair[1].0, "{} {}", pair[0].1, pair[1].1);
    }
}

#[test]
fn dotted_symbols_have_glyphs() {
    for slope in [Slope::Upright, Slope::Italic] {
        let unknown = outline("\u{f8ff}", slope);
        for name in super::GREEK.map(|(name, _)| name).into_iter().chain(["i_dot", "j_ddot", "x_dot"]) {
            for character in Columns::default().label(&format!("{name}_ddot")).plain().chars() {
                assert_ne!(outline(&character.to_string(), slope), unknown, "{name} {character:?}");
            }
        }
    }
}

#[test]
fn units_are_written_as_in_formulas() {
    let pairs = [
        ("m", "m"),
        ("rad/s", "rad/s"),
        ("m/s^2", "m/s²"),
        ("kg*m^2/s^2", "kg·m²/s²"),
        ("1/(m*s)", "1/(m·s)"),
        ("m^-12*s", "m⁻¹²·s"),
        ("m^(1/2)*s^2", "m^(1/2)·s^2"),
        ("°", "°"),
    ];
    for (spelt, written) in pairs {
        assert_eq!(unit(spelt), written);
    }
}
