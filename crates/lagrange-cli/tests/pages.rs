//! Live pages: their motions against those of `lagrange simulate`, where the machine has Node.js,
//! and refusals.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::{Value, from_value};

/// Systems with the times of the comparison. They have events, a stop, switches in time and state,
/// a closed loop, a quaternion, clocks, a table, an unknown or a rolling constraint.
const SYSTEMS: [(&str, &str, f64); 9] = [
    (
        "double",
        "struct DoublePendulum; param l: m > 0 = 1, g: m/s^2 = 9.81; coord a: rad = 1, b: rad = 0.5;
        gravity = (0, -g);
        body upper { mass: 1 [kg]; shape: slender_rod(l); center: l/2 * (sin(a), -cos(a)); angle: a - pi/2; }
        body lower { mass: 1 [kg]; shape: slender_rod(l); center: upper.point(l/2, 0) + l/2 * (sin(b), -cos(b)); angle: b - pi/2; }
        pin upper.point(-l/2, 0) to (0, 0); pin upper.point(l/2, 0) to lower.point(-l/2, 0);",
        2.0,
    ),
    (
        "bounce",
        "struct Ball; param e = 0.7; coord x = 0, y = 1; start dot(x) = 0.5;
        kinetic = 1/2 * (dot(x)^2 + dot(y)^2); potential = 9.81 * y;
        event floor = y, falling => { dot(y) = -e * dot(y); } event end = t - 1.7, rising => stop;",
        1.7,
    ),
    (
        "kinks",
        "struct Kinks; coord x = 1; kinetic = 1/2 * dot(x)^2; potential = 3 * abs(x);
        force x = if t > 1.25 { 0.7 } else { -0.2 * max(dot(x), 0) };",
        4.0,
    ),
    (
        "loop",
        "struct FourBar; coord a = 0, b = pi/3, c = 2*pi/3; start dot(a) = 30, dot(b) = -10, dot(c) = -10;
        let x = 0.1 * cos(a) + 0.3 * cos(b) - 0.3 * cos(c) - 0.4; let y = 0.1 * sin(a) + 0.3 * sin(b) - 0.3 * sin(c);
        kinetic = 0.01 * dot(a)^2 + 0.1 * dot(b)^2 + 0.05 * dot(c)^2; potential = 3 * sin(b) + 2 * sin(c);
        constraint along = x; constraint across = y; output pull = along;",
        1.0,
    ),
    (
        "top",
        "struct Top; gravity = (0, 0, -9.81); body rotor { mass: 0.5; centroid: (0, 0, 0.1); inertia: (2e-3, 2e-3, 1e-3); }
        ball tip = ground to rotor; start tip_qw = 1, tip_qx = 0.2, tip_qy = 0, tip_qz = 0, tip_wx = 0, tip_wy = 0, tip_wz = 60;",
        1.0,
    ),
    (
        "room",
        "struct Room; param period = 0.1; coord x = 0; state warmth = 20; discrete held = 0; mode heater = off | on;
        kinetic = 1/2 * dot(x)^2; force x = held - x; dot(warmth) = 1 * (5 - warmth) + if heater == on { 30 } else { 0 };
        event cold = warmth - 19, falling => { heater = on; } event warm = warmth - 21, rising => { heater = off; }
        every period => { held = warmth - 20 - x - dot(x); }",
        1.05,
    ),
    (
        "wind",
        "struct Wind; table gust(time) = [(0, 0), (1, 2), (1.5, -1), (3, 0.5)], interpolation: monotone, outside: clamp;
        coord x = 0; kinetic = 1/2 * dot(x)^2; potential = 2 * x^2; force x = gust(t);",
        2.0,
    ),
    (
        "implicit",
        "struct Implicit; coord x = 1; solve y: 0 = y^3 + y - x, start: x; kinetic = 1/2 * dot(x)^2; potential = 2 * y^2;",
        2.0,
    ),
    (
        "skate",
        "struct Skate; coord x = 0, y = 0, phi = 0.3; start dot(phi) = 1, dot(x) = cos(0.3), dot(y) = sin(0.3);
        kinetic = 1/2 * (dot(x)^2 + dot(y)^2) + 1/2 * dot(phi)^2; potential = 2 * y;
        constraint edge = dot(x) * sin(phi) - dot(y) * cos(phi);",
        2.0,
    ),
];

/// A script that runs the motion of a page without a browser, and prints its end.
const RUN: &str = "
const motion = startsMotion(model, functions);
motion.start(model.states.map((state) => state.value), model.quantities.map((field) => field.value));
const first = motion.energy();
for (let k = 1; k <= 100; k++) motion.advance(k * END / 100);
console.log(JSON.stringify([motion.t, motion.y, motion.failure]));
";

fn lagrange(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_lagrange")).args(arguments).output().expect("the command starts")
}

fn folder() -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pages");
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// Returns the file of a declaration, and that of its page.
fn written(name: &str, declaration: &str) -> [String; 2] {
    let paths = ["lag", "html"].map(|extension| folder().join(format!("{name}.{extension}")));
    fs::write(&paths[0], declaration).expect("a file that can be written");
    paths.map(|path| path.to_str().expect("UTF-8").to_owned())
}

fn page(name: &str, declaration: &str) -> String {
    let [declared, page] = written(name, declaration);
    let result = lagrange(&["page", &declared, "-o", &page]);
    assert!(result.status.success(), "{name}: {}", String::from_utf8_lossy(&result.stderr));
    fs::read_to_string(page).expect("a page")
}

/// Runs a page to its end, and returns time, state and message, or `None` without Node.js.
fn run(name: &str, page: &str, end: f64) -> Option<(f64, Vec<f64>, Option<String>)> {
    let end = printed(name, page, &RUN.replace("END", &end.to_string()))?;
    Some(from_value(end).expect("time, state and message"))
}

/// Runs a script after the functions of a page, and returns what it prints, or `None` without
/// Node.js.
fn printed(name: &str, page: &str, script: &str) -> Option<Value> {
    let (_, whole) = page.rsplit_once("<script>").expect("a script");
    let (motion, _) = whole.split_once("// The page:").expect("the motion stands before the page");
    let path = folder().join(format!("{name}.js"));
    fs::write(&path, format!("{motion}{script}")).expect("written");
    let Ok(output) = Command::new("node").arg(path).output() else {
        eprintln!("skipped: there is no `node` to run pages");
        return None;
    };
    assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
    Some(serde_json::from_slice(&output.stdout).expect("what the script prints"))
}

#[test]
fn pages_move_as_the_interpreter_does() {
    for (name, declaration, end) in SYSTEMS {
        let page = page(name, declaration);
        assert!(page.len() < 121_000, "{name}: {} bytes", page.len());
        let loads =
            ["src=", "href=", "fetch(", "import", "url("].into_iter().find(|word| page.contains(word));
        assert_eq!(loads, None, "{name} needs more than its file");
        let Some((t, y, failure)) = run(name, &page, end) else { return };
        let [declared, _] = written(name, declaration);
        let until = end.to_string();
        let simulated = lagrange(&["simulate", &declared, "--until", &until, "--tolerance", "1e-12"]);
        let rows = String::from_utf8(simulated.stdout).expect("rows");
        let last = rows.lines().last().expect("an end").split(',').map(str::parse::<f64>);
        let last = last.collect::<Result<Vec<_>, _>>().expect("numbers");
        assert!(
            (t - last[0]).abs() < 1e-9 && (failure.is_some() == (name == "bounce")),
            "{name}: {failure:?} at {t}"
        );
        for (found, wanted) in y.iter().zip(&last[1..]) {
            assert!((found - wanted).abs() < 2e-7 * (1.0 + wanted.abs()), "{name}: {y:?}, not {last:?}");
        }
    }
}

/// Returns the coordinates in which the last body is as near to a place as a page finds by
/// dragging. The point is at this distance from the centre of mass.
fn dragged(name: &str, page: &str, reach: f64, [x, y]: [f64; 2]) -> Option<Vec<f64>> {
    let script = format!(
        "const sizes = model.scene.items.map((item) => (item.kind === 'body' ? item.parts.reduce((sum, part) => sum + part.count + 3, 5) : 0));
        const last = sizes.findLastIndex((size) => size > 0);
        const from = sizes.slice(0, last).reduce((sum, size) => sum + size, 0);
        const point = (scene) => [Math.cos, Math.sin].map((part, k) => scene[from + 2 + k] + {reach} * part(scene[from + 4]));
        const start = model.states.map((state) => state.value);
        console.log(JSON.stringify(reaches(model, functions, point).to(start, model.quantities.map((field) => field.value), [{x}, {y}])));"
    );
    Some(from_value(printed(name, page, &script)?).expect("a state"))
}

#[test]
fn bodies_follow_the_pointer() {
    let (name, double, _) = SYSTEMS[0];
    let page = page(name, double);
    let tip = |y: &[f64]| [y[0].sin() + y[1].sin(), -y[0].cos() - y[1].cos()];
    let Some(within) = dragged(name, &page, 0.5, [0.6, -1.1]) else { return };
    assert!((tip(&within)[0] - 0.6).hypot(tip(&within)[1] + 1.1) < 1e-9, "{within:?}");
    assert_eq!(within[2..], [0.0, 0.0], "velocities stay");
    // Out of reach, both rods point at the place.
    let beyond = dragged(name, &page, 0.5, [3.0, -4.0]).expect("there is Node.js");
    assert!((tip(&beyond)[0] - 1.2).hypot(tip(&beyond)[1] + 1.6) < 1e-3, "{beyond:?}");
}

#[test]
fn bodies_that_follow_the_pointer_keep_constraints() {
    let bead = "struct Bead; coord x = 0, y = -1; constraint wire = x^2 + y^2 - 1; gravity = (0, -9.81);
        body ball { mass: 1; shape: disk(0.1); center: (x, y); angle: 0; }";
    let Some(y) = dragged("bead", &page("bead", bead), 0.0, [3.0, 4.0]) else { return };
    assert!((y[0] - 0.6).hypot(y[1] - 0.8) < 1e-5, "{y:?}");
    assert!((y[0].hypot(y[1]) - 1.0).abs() < 1e-10, "{y:?}");
}

/// A swing of a plank on two rods with ball joints, a closed loop with three quaternions.
const SWING: &str = "struct Swing; gravity = (0, 0, -9.81);
    body left { mass: 1; shape: slender_rod(0.1); centroid: (0, 0, -0.25); }
    body right { mass: 2; shape: slender_rod(0.1); centroid: (0, 0, -0.25); }
    body plank { mass: 3; shape: cuboid(1, 0.2, 0.05); }
    ball a = ground to left { at: (-0.5, 0, 1); } ball b = ground to right { at: (0.5, 0, 1); } free plank;
    pin left.point(0, 0, -0.5) to plank.point(-0.5, 0, 0); pin right.point(0, 0, -0.5) to plank.point(0.5, 0, 0);
    start a_qw = 1, a_qx = 0, a_qy = 0, a_qz = 0, b_qw = 1, b_qx = 0, b_qy = 0, b_qz = 0;
    start plank_qw = 1, plank_qx = 0, plank_qy = 0, plank_qz = 0, plank_x = 0, plank_y = 0, plank_z = 0.5;
    start a_wx = 0.5, a_wy = 0, a_wz = 0, b_wx = 0, b_wy = 0, b_wz = 0;
    start plank_vx = 0, plank_vy = 0, plank_vz = 0, plank_wx = 0, plank_wy = 0, plank_wz = 0;";

/// The middle of the plank follows on the sphere of the rods, with the point beside it at the same
/// height.
#[test]
fn bodies_in_space_that_follow_the_pointer_keep_constraints_and_quaternions() {
    let place = [0.1_f64, 0.2, 1.0 - (0.25_f64 - 0.05).sqrt()];
    let script = format!(
        "const point = (scene) => scene.slice(59, 62);
        const start = model.states.map((state) => state.value);
        const hand = reaches(model, functions, point);
        const y = hand.to(start, [], {place:?});
        console.log(JSON.stringify([y, hand.isFree(start, []), reaches(model, functions, () => [1, 2]).isFree(start, [])]));"
    );
    let Some(printed) = printed("swing", &page("swing", SWING), &script) else { return };
    let (y, is_free, is_fixed_free): (Vec<f64>, bool, bool) = from_value(printed).expect("a state");
    assert!(is_free && !is_fixed_free, "a point that no coordinate moves");
    for (found, wanted) in y[8..11].iter().zip(place) {
        assert!((found - wanted).abs() < 1e-5, "{y:?}");
    }
    let turned = |q: &[f64], [x, z]: [f64; 2]| {
        let [w, a, b, c] = [q[0], q[1], q[2], q[3]];
        [
            x * (1.0 - 2.0 * (b * b + c * c)) + 2.0 * z * (a * c + w * b),
            2.0 * x * (a * b + w * c) + 2.0 * z * (b * c - w * a),
            2.0 * x * (a * c - w * b) + z * (1.0 - 2.0 * (a * a + b * b)),
        ]
    };
    for (side, rod) in [(-0.5, &y[0..4]), (0.5, &y[4..8])] {
        let [end, hung] = [turned(&y[11..15], [side, 0.0]), turned(rod, [0.0, -0.5])];
        let fixed = [side, 0.0, 1.0];
        for axis in 0..3 {
            assert!((y[8 + axis] + end[axis] - fixed[axis] - hung[axis]).abs() < 1e-9, "{y:?}");
        }
    }
    for q in [&y[0..4], &y[4..8], &y[11..15]] {
        assert!((q.iter().map(|part| part * part).sum::<f64>() - 1.0).abs() < 1e-12, "{y:?}");
    }
    assert_eq!(y[15], 0.5, "velocities of the start stay");
}

#[test]
fn a_page_stops_at_the_last_state_that_is_a_number() {
    let falling = "struct Falling; coord x = 1; kinetic = 1/2 * dot(x)^2; force x = -sqrt(x) - 1;";
    let Some((t, y, failure)) = run("falling", &page("falling", falling), 5.0) else { return };
    let failure = failure.expect("a square root of a negative number");
    assert!(failure.starts_with("The accelerations are no longer finite numbers"), "{failure}");
    assert!(0.5 < t && t < 2.0 && y.iter().all(|value| value.is_finite()) && y[0].abs() < 1e-3, "{t}: {y:?}");
}

#[test]
fn a_motion_that_slides_along_a_switch_ends_in_words() {
    let rubbing = "struct Rubbing; coord x = 0; start dot(x) = 1; kinetic = 1/2 * dot(x)^2; force x = -2 * sign(dot(x));";
    let Some((t, _, failure)) = run("rubbing", &page("rubbing", rubbing), 2.0) else { return };
    let failure = failure.expect("at rest nothing determines the force");
    assert!((t - 0.5).abs() < 1e-6 && failure.contains("slides along a switch"), "{failure} at {t}");
}

/// Bounces end at v/g (1 + e)/(1 − e) after the first fall. The ball does not fall through the
/// floor.
#[test]
fn bounces_that_accumulate_end_in_words() {
    for e in [0.0_f64, 0.05, 0.3, 0.8] {
        let ball = format!(
            "struct Ball; coord y = 1.1; kinetic = 1/2 * dot(y)^2; potential = 9.81 * y;
            event floor = y - 0.1, falling => {{ dot(y) = -{e} * dot(y); }} event top = dot(y), falling => record;"
        );
        let Some((t, y, failure)) = run("ball", &page("ball", &ball), 30.0) else { return };
        let (failure, end) = (failure.expect("an end"), (2.0 / 9.81_f64).sqrt() * (1.0 + e) / (1.0 - e));
        assert!(failure.starts_with("Events follow each other without end"), "{failure}");
        assert!((t - end).abs() < 1e-6 && (y[0] - 0.1).abs() < 1e-9, "e = {e}: {y:?} at {t}, not {end}");
    }
}

#[test]
fn systems_beyond_pages_are_refused_by_name() {
    let base = "coord x = 0; kinetic = 1/2 * dot(x)^2;";
    for (declaration, wanted) in [
        (format!("{base} event floor = x, falling => impact(0.5);"), "`floor`"),
        (format!("function road(x); {base} potential = road(x);"), "`road"),
        (format!("{base} constraint a = x; constraint b = sin(x);"), "`a`, `b`"),
        ("coord x; kinetic = 1/2 * dot(x)^2;".to_owned(), "the start of `x` is missing"),
    ] {
        let [declared, _] = written("refused", &declaration);
        let result = lagrange(&["page", &declared]);
        let message = String::from_utf8_lossy(&result.stderr).into_owned();
        assert!(!result.status.success() && message.contains(wanted), "{declaration}: {message}");
        assert!(result.stdout.is_empty(), "nothing is written");
    }
}

#[test]
fn starts_out_of_a_range_are_refused() {
    let [declared, page] = written("range", "coord x in ..=1; kinetic = 1/2 * dot(x)^2;");
    for command in ["page", "fmu"] {
        let result = lagrange(&[command, &declared, "--start", "x=2", "-o", &page]);
        let message = String::from_utf8_lossy(&result.stderr).into_owned();
        let expected = "--start: the coordinate `x` is 2.0, but it must be at most 1.0";
        assert!(!result.status.success() && message.contains(expected), "{command}: {message}");
    }
}
