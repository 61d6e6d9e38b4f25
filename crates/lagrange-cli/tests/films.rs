//! Films on the command line: formats, curves, and what is refused.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const PENDULUM: &str =
    "struct RodPendulum; param l: m > 0 = 1; coord a: rad = 1; gravity = (0, -9.81 [m/s^2]);
    body rod { mass: 1 [kg]; shape: slender_rod(l); center: l/2 * (sin(a), -cos(a)); angle: a - pi/2; }
    pin rod.point(-l/2, 0) to (0, 0);";
const TOP: &str = "struct Top; gravity = (0, 0, -9.81); body rotor { mass: 0.5; shape: cone(0.05, 0.1); }
    ball tip = ground to rotor;
    start tip_qw = 1, tip_qx = 0.2, tip_qy = 0, tip_qz = 0, tip_wx = 0, tip_wy = 0, tip_wz = 60;";
/// A body that accelerates towards infinity at the time 1.
const ENDING: &str = "struct Ending; coord x = 0; start dot(x) = 1; body b { mass: 1; shape: disk(0.1); center: (x, 0); angle: 0; }
    force x = 2 * dot(x) / (1 - t);";

fn temporary(name: &str) -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(name)
}

fn film(name: &str, declaration: &str, arguments: &[&str]) -> Output {
    let path = temporary(name);
    fs::write(&path, declaration).expect("written");
    let mut command = Command::new(env!("CARGO_BIN_EXE_lagrange"));
    command.arg("film").arg(path).args(arguments).output().expect("the command starts")
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("UTF-8")
}

#[test]
fn films_have_the_format_of_their_extension() {
    let formats = [
        (PENDULUM, "html", &b"<!DOCTYPE html>"[..]),
        (PENDULUM, "gif", b"GIF89a"),
        (PENDULUM, "svg", b"<svg"),
        (TOP, "html", b"<!DOCTYPE html>"),
        (TOP, "gif", b"GIF89a"),
        (TOP, "glb", b"glTF"),
    ];
    for (index, (declaration, extension, start)) in formats.into_iter().enumerate() {
        let path = temporary(&format!("film{index}.{extension}"));
        let output = path.to_str().expect("UTF-8");
        let result = film(&format!("film{index}.lag"), declaration, &["--until", "0.4", "-o", output]);
        assert_eq!((result.status.code(), text(&result.stdout), text(&result.stderr)), (Some(0), "", ""));
        assert!(fs::read(&path).expect("written").starts_with(start), "{extension}");
        if extension == "html" {
            let direct = film(&format!("direct{index}.lag"), declaration, &["--until", "0.4"]);
            assert!(direct.stdout == fs::read(&path).expect("written"), "{extension}");
        }
    }
}

#[test]
fn settings_are_those_of_motions() {
    let page = |arguments: &[&str]| {
        let result = film("settings.lag", PENDULUM, &[&["--until", "1"], arguments].concat());
        assert_eq!((result.status.code(), text(&result.stderr)), (Some(0), ""), "{arguments:?}");
        text(&result.stdout).to_owned()
    };
    let plain = page(&[]);
    assert!(plain.contains("<title>Rod pendulum</title>") && !plain.contains("energy"));
    assert!(page(&["--energy"]).contains("energy"));
    // The weight of the rod, and the force of its pin, which is known to no coordinate.
    assert!(page(&["--forces"]).contains(">G<") && !plain.contains(">G<"));
    assert_eq!(page(&["--every", "40 ms"]), plain);
    for setting in [&["--every", "0.1"][..], &["--set", "l=2"], &["--start", "a=0.1"]] {
        assert_ne!(page(setting), plain, "{setting:?}");
    }
}

#[test]
fn a_motion_that_fails_is_filmed_as_far_as_it_went() {
    let result = film("ending.lag", ENDING, &["--until", "2"]);
    assert_eq!(result.status.code(), Some(3), "{}", text(&result.stderr));
    assert!(
        text(&result.stdout).starts_with("<!DOCTYPE html>") && text(&result.stderr).starts_with("error: ")
    );
}

#[test]
fn what_is_no_film_is_refused() {
    let point = "coord x = 0; kinetic = 1/2 * dot(x)^2;";
    let cases: [(&str, &[&str], i32, &str); 7] = [
        (point, &["--until", "1"], 1, "a film needs bodies, and the declaration has none"),
        ("coord x; kinetic = y;", &["--until", "1"], 1, "unknown name `y`"),
        (PENDULUM, &[], 2, "the end is missing"),
        (PENDULUM, &["--until", "1", "-o", "film.glb"], 2, "the extension must be one of html, gif, svg"),
        (TOP, &["--until", "1", "-o", "film.svg"], 2, "the extension must be one of html, gif, glb"),
        (PENDULUM, &["--until", "1", "--every", "0"], 2, "the sampling interval must be positive"),
        (PENDULUM, &["--until", "101", "--every", "1 ms"], 1, "a film has at most 100000 pictures"),
    ];
    for (index, (declaration, arguments, code, message)) in cases.into_iter().enumerate() {
        let result = film(&format!("refused{index}.lag"), declaration, arguments);
        let errors = text(&result.stderr);
        assert_eq!(result.status.code(), Some(code), "{errors}");
        assert!(errors.contains(message) && result.stdout.is_empty(), "{errors}");
    }
}
