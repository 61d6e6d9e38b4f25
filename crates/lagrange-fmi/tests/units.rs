//! Units: descriptions, sources that compile without a warning, motions in closed form, refusals.
#![cfg(unix)]

#[path = "../../lagrange-c/tests/systems/mod.rs"]
mod systems;

use std::collections::HashSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::Arc;

use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, Programs, parse};
use lagrange_fmi::{ExportError, MockupUnit, Start, Version};
use roxmltree::{Document, Node};

use systems::SYSTEMS;

const OPTIONS: [&str; 7] =
    ["-std=c99", "-O1", "-ffp-contract=off", "-Wall", "-Wextra", "-Wpedantic", "-Werror"];

/// Kinds of instances, as in `unit.h`.
const STEPS: &str = "0";
const EXCHANGE: &str = "1";
const STEPS_WITH_EVENTS: &str = "2";

const VERSIONS: [Version; 2] = [Version::Two, Version::Three];

const BOUNCE: &str = "struct Bounce; param g: m/s^2 = 9.81, e in 0..=1 = 0.8; coord h: m = 1;
    kinetic = 1/2 * (1 [kg]) * dot(h)^2; potential = (1 [kg]) * g * h;
    event floor = h, falling => { dot(h) = -e * dot(h); }";

fn programs(text: &str) -> Programs {
    let system = parse(text).unwrap_or_else(|report| panic!("{text}: {report}"));
    let derived = system.with(Product::SystemMatrix).derive(StrategyChoice::Cheapest);
    Programs::new(&derived.unwrap_or_else(|report| panic!("{text}: {report}")))
}

/// Returns defaults and the declared state, 0.3 where nothing is declared.
fn start(programs: &Programs) -> Start {
    let numeric = NumericSystem::of(Arc::new(programs.clone()));
    let states = programs.layout.positions + programs.layout.velocities;
    let declared = programs.start.as_ref().map(|start| numeric.evaluate(start, 0.0, &[], &[]));
    let are_given = vec![declared.is_none(); states];
    let fields = programs.defaults.iter().map(|value| if value.is_nan() { 0.0 } else { *value });
    Start { fields: fields.collect(), state: declared.unwrap_or(vec![0.3; states]), are_given }
}

fn unit(text: &str, version: Version) -> MockupUnit {
    let programs = programs(text);
    MockupUnit::new(&programs, &start(&programs), version).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("units").join(name);
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// Compiles a unit together with a program that calls it.
fn program(name: &str, unit: &MockupUnit, (file, main): (&str, &str), more: &[&str]) -> PathBuf {
    let folder = folder(&format!("{name}_{}", unit.version.number()));
    let tests = [(file, main), ("unit.h", include_str!("unit.h"))];
    for (file, text) in unit.sources.iter().map(|(file, text)| (*file, &**text)).chain(tests) {
        fs::write(folder.join(file), text).expect("a file that can be written");
    }
    let mut command = Command::new("cc");
    command.args(OPTIONS).args(more).args([file, "model.c", "-o", "main", "-lm"]).current_dir(&folder);
    if unit.version == Version::Three {
        command.arg("-DFMI3");
    }
    let output = command.output().expect("a C compiler, which linking needs, too");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    folder.join("main")
}

fn stepper(name: &str, unit: &MockupUnit) -> PathBuf {
    program(name, unit, ("main.c", include_str!("main.c")), &[])
}

fn guid(unit: &MockupUnit) -> String {
    let document = Document::parse(&unit.description).expect("XML");
    let name = if unit.version == Version::Two { "guid" } else { "instantiationToken" };
    document.root_element().attribute(name).expect("a GUID").to_owned()
}

fn run(program: &Path, guid: &str, arguments: &[&str]) -> Output {
    Command::new(program).arg(guid).args(arguments).output().expect("a program")
}

/// Returns status, time, and the first two variables, which must agree between both versions, and
/// with events that the caller handles.
fn stepped(name: &str, text: &str, arguments: &[&str]) -> ([f64; 4], String) {
    let units = VERSIONS.map(|version| unit(text, version));
    let programs = units.each_ref().map(|unit| stepper(name, unit));
    let by = |version: usize, kind| stepped_by(&programs[version], &units[version], kind, arguments);
    let [two, three, handled] = [by(0, STEPS), by(1, STEPS), by(1, STEPS_WITH_EVENTS)];
    assert_eq!(two.0, three.0);
    assert_eq!(two.1, three.1.replace("fmi3", "fmi2"));
    assert_eq!(two.0[0] == 0.0, handled.0[0] == 0.0, "{}", handled.1);
    for (found, wanted) in handled.0.iter().zip(two.0).skip(1) {
        assert!((found - wanted).abs() <= 1e-12 * wanted.abs().max(1.0), "{handled:?} {two:?}");
    }
    two
}

fn stepped_by(program: &Path, unit: &MockupUnit, kind: &str, arguments: &[&str]) -> ([f64; 4], String) {
    let output = run(program, &guid(unit), &[&[kind][..], arguments].concat());
    let printed = String::from_utf8(output.stdout).expect("numbers");
    let numbers =
        printed.split_whitespace().map(|word| word.parse().expect("a number")).collect::<Vec<f64>>();
    let messages = String::from_utf8(output.stderr).expect("text");
    (numbers.try_into().unwrap_or_else(|_| panic!("{printed} {messages}")), messages)
}

fn index(node: Node<'_, '_>, attribute: &str) -> usize {
    node.attribute(attribute).and_then(|text| text.parse().ok()).expect("an index")
}

#[test]
fn units_of_all_systems_compile_and_are_described() {
    for (number, text) in SYSTEMS.into_iter().enumerate() {
        for version in VERSIONS {
            let unit = unit(text, version);
            stepper(&format!("system_{number}"), &unit);
            check_description(&unit);
        }
    }
}

/// Checks properties beyond the schema: references of variables, and definitions of units.
fn check_description(unit: &MockupUnit) {
    let description = &unit.description;
    let document = Document::parse(description).unwrap_or_else(|error| panic!("{error}: {description}"));
    let named = |name: &'static str| document.descendants().filter(move |node| node.has_tag_name(name));
    let is_two = unit.version == Version::Two;
    let variables = named(if is_two { "ScalarVariable" } else { "Float64" }).collect::<Vec<_>>();
    let value = |variable: usize, name: &str| {
        let attributes = variables[variable];
        let attributes = if is_two { attributes.first_element_child().expect("a type") } else { attributes };
        attributes.attribute(name)
    };
    let units = named("Unit").filter_map(|unit| unit.attribute("name")).collect::<HashSet<_>>();
    let mut names = HashSet::new();
    for (reference, variable) in variables.iter().enumerate() {
        assert_eq!(index(*variable, "valueReference"), reference);
        assert!(names.insert(variable.attribute("name").expect("a name")), "{description}");
        assert!(value(reference, "unit").is_none_or(|unit| units.contains(unit)), "{description}");
        let starts = value(reference, "start").map(str::parse::<f64>);
        assert!(starts.is_none_or(|start| start.is_ok_and(f64::is_finite)), "{description}");
    }
    let rates = match is_two {
        true => {
            let rates = named("Derivatives").flat_map(|element| element.children()).filter(Node::is_element);
            rates.map(|unknown| index(unknown, "index") - 1).collect::<Vec<_>>()
        }
        false => named("ContinuousStateDerivative").map(|unknown| index(unknown, "valueReference")).collect(),
    };
    for (state, rate) in rates.into_iter().enumerate() {
        let derivative = value(rate, "derivative").and_then(|text| text.parse::<usize>().ok());
        assert_eq!(derivative, Some(state + usize::from(is_two)));
        let name = variables[state].attribute("name").expect("a name");
        assert_eq!(variables[rate].attribute("name"), Some(&*format!("der({name})")));
    }
}

#[test]
fn dependencies_and_units_are_those_of_the_formulas() {
    let unit = unit(
        "struct Cart; param m: kg = 2, k: N/m = 3; input push: N = 0; coord x: m = 1, a: rad = 0;
        kinetic = 1/2 * m * dot(x)^2 + 1/2 * (1 [kg*m^2]) * dot(a)^2; potential = 1/2 * k * x^2;
        force x = push; output pull: N = push - k * x; output turn: rad/s = dot(a);
        output warmth: degC = x * 1 [K/m];",
        Version::Two,
    );
    let document = Document::parse(&unit.description).expect("XML");
    let base = |name: &str| {
        let unit = document.descendants().find(|node| node.attribute("name") == Some(name)).expect("a unit");
        let base = unit.first_element_child().expect("a base");
        base.attributes().map(|a| format!("{}{}", a.name(), a.value())).collect::<Vec<_>>().join(" ")
    };
    assert_eq!(base("N"), "kg1 m1 s-2");
    assert_eq!(base("N/m"), "kg1 s-2");
    assert_eq!(base("rad/s"), "s-1 rad1");
    assert_eq!(base("degC"), "K1 factor1.0 offset273.15");
    let unknowns = |element: &str| {
        let list = document.descendants().find(|node| node.has_tag_name(element)).expect("a list");
        let unknowns = list.children().filter(Node::is_element);
        unknowns
            .map(|node| {
                [index(node, "index").to_string(), node.attribute("dependencies").unwrap_or("?").to_owned()]
            })
            .collect::<Vec<_>>()
    };
    // 1 to 4 are the state, 5 to 8 its rates, 9 and 10 parameters, 11 the input.
    assert_eq!(unknowns("Outputs"), [["12", "1 11"], ["13", "4"], ["14", "1"]]);
    assert_eq!(unknowns("Derivatives"), [["5", "3"], ["6", "4"], ["7", "1 11"], ["8", ""]]);
}

#[test]
fn ranges_and_nominal_values_are_attributes_of_states() {
    let text = "struct Mirror; coord tilt: mm in -2..=2 nominal 0.1 = 1; state heat: K > 0 = 3;
        kinetic = 1/2 * (1 kg) * dot(tilt)^2; dot(heat) = -0.1 [1/s] * heat;";
    for version in VERSIONS {
        let unit = unit(text, version);
        let of = |name: &str| {
            let named = format!("name=\"{name}\" valueReference");
            let (_, element) = unit.description.split_once(&named).expect("a variable");
            element.split_once(if version == Version::Two { "</Scalar" } else { "/>" }).expect("an end").0
        };
        let limits = "min=\"-0.002\" max=\"0.002\" nominal=\"0.0001\" start=\"0.001\"";
        assert!(of("tilt").contains(limits), "{}", of("tilt"));
        assert!(of("heat").contains("min=\"0.0\" start=\"3.0\""), "{}", of("heat"));
        assert!(of("tilt_dot").contains("nominal=\"0.0001\" start=\"0.0\""), "{}", of("tilt_dot"));
    }
}

/// A small oscillation has the relative error of a large one.
#[test]
fn nominal_values_scale_tolerances() {
    let text = "struct Small; coord x nominal 1e-9 = 1e-9; kinetic = 1/2 * dot(x)^2; potential = 1/2 * x^2;";
    let ([status, time, x, speed], _) = stepped("small", text, &["0.5", "20"]);
    assert_eq!([status, time], [0.0, 10.0]);
    let [cos, sin] = [10.0_f64.cos(), 10.0_f64.sin()];
    assert!((x * 1e9 - cos).abs() < 1e-11 && (speed * 1e9 + sin).abs() < 1e-11, "{x} {speed}");
}

/// Returns the value reference of a variable.
fn reference(unit: &MockupUnit, name: &str) -> String {
    let names = Document::parse(&unit.description).expect("XML");
    let variable = names.descendants().find(|node| node.attribute("name") == Some(name));
    variable.and_then(|node| node.attribute("valueReference")).expect("a variable").to_owned()
}

/// Time does not pass with periods that are too short.
#[test]
fn periods_of_clocks_are_checked() {
    let text = "struct Count; param period = 0.25; coord x = 0; discrete count = 0;
        kinetic = 1/2 * dot(x)^2; every period => { count = count + 1; }";
    let reference = reference(&unit(text, Version::Two), "period");
    for (value, words) in [
        ("0", "the period of a clock = 0 is not positive"),
        ("-1", "the period of a clock = -1 is not positive"),
        ("1e-300", "the period of a clock = 1e-300 is below the spacing of times"),
    ] {
        let ([status, time, ..], messages) = stepped("period", text, &["0.5", "2", &reference, value]);
        assert!(status == 3.0 && time == 0.0 && messages.contains(words), "{messages}");
    }
}

/// The start follows a parameter, and a clock ticks, as if the refused calls had not been made.
#[test]
fn refused_calls_set_nothing() {
    let text = "struct Count; param period = 0.25, e in 0..1 = 0.5; coord x = 2 * e; discrete count = 0;
        kinetic = 1/2 * dot(x)^2; every period => { count = count + 1; }";
    for unit in VERSIONS.map(|version| unit(text, version)) {
        let program = program("refused", &unit, ("refused.c", include_str!("refused.c")), &[]);
        let references = ["x", "e", "period", "count"].map(|name| reference(&unit, name));
        for (kind, end) in [(STEPS, "0 4"), (EXCHANGE, "3 0")] {
            let output = run(&program, kind, &references.each_ref().map(String::as_str));
            let messages = String::from_utf8_lossy(&output.stderr).into_owned();
            let printed = String::from_utf8(output.stdout).expect("numbers");
            assert_eq!(printed, format!("3 3 0 0 3 0.5 0.25 0.25 {end}"), "{messages}");
            assert_eq!(messages.matches("e = 2 is outside the declared range").count(), 3, "{messages}");
        }
    }
}

#[test]
fn balls_bounce_in_closed_form() {
    let ([status, time, h, speed], messages) = stepped("bounce", BOUNCE, &["0.25", "12", "5", "0.9"]);
    let (g, mut t) = (9.81_f64, (2.0_f64 / 9.81).sqrt());
    let mut up = 0.9 * g * t;
    while t + 2.0 * up / g < 3.0 {
        t += 2.0 * up / g;
        up *= 0.9;
    }
    let rest = 3.0 - t;
    assert_eq!([status, time], [0.0, 3.0]);
    assert!((h - up * rest + g * rest * rest / 2.0).abs() < 1e-12, "{h}");
    assert!((speed - up + g * rest).abs() < 1e-11, "{speed}");
    assert!(messages.starts_with("event floor at the time 0.45152364098573"), "{messages}");
}

/// Bounces accumulate at t = √(2h/g) (1 + e)/(1 − e).
#[test]
fn infinitely_many_bounces_end_a_step() {
    let ([status, time, h, _], messages) = stepped("zeno", BOUNCE, &["0.5", "10", "5", "0.5"]);
    let limit = (2.0_f64 / 9.81).sqrt() * 3.0;
    assert!(status == 2.0 && (time - limit).abs() < 1e-4 && h.abs() < 1e-6, "{time} {h}");
    assert!(messages.contains("infinitely many events accumulate there"), "{messages}");
}

#[test]
fn declared_ends_and_lost_numbers_end_a_step() {
    let stop = BOUNCE.replace("{ dot(h) = -e * dot(h); }", "stop;");
    let ([status, time, h, _], _) = stepped("stop", &stop, &["0.5", "10"]);
    assert!(status == 2.0 && (time - (2.0_f64 / 9.81).sqrt()).abs() < 1e-12 && h.abs() < 1e-12, "{time} {h}");
    let root = "struct Root; coord x = 1; kinetic = 1/2 * dot(x)^2; force x = -1 - 0.1 * sqrt(x);";
    let ([status, _, x, speed], messages) = stepped("root", root, &["1", "3"]);
    assert!(
        status == 2.0 && x > 0.0 && speed.is_finite() && messages.contains("not finite"),
        "{x} {messages}"
    );
}

/// Programs try a discarded step again, but not after an error.
#[test]
fn steps_that_do_not_advance_are_errors() {
    let root = "struct Root; coord x = 1; kinetic = 1/2 * dot(x)^2; force x = sqrt(-x);";
    let ([status, time, x, speed], messages) = stepped("never", root, &["1", "3"]);
    assert_eq!([status, time, x, speed], [3.0, 0.0, 1.0, 0.0], "{messages}");
    assert!(messages.contains("stands at the time 0: rates or events are not finite"), "{messages}");
}

/// Kinks are events, too: x = t² up to t = 1/2, then a straight line.
#[test]
fn switches_are_located() {
    let text = "struct Push; coord x = 0; kinetic = dot(x)^2; force x = if t < 0.5 { 4 } else { 0 };";
    let ([status, _, x, speed], _) = stepped("push", text, &["0.4", "3"]);
    assert_eq!(status, 0.0);
    assert!((x - 0.95).abs() < 1e-12 && (speed - 1.0).abs() < 1e-12, "{x} {speed}");
}

/// Events of either direction fire once at each zero, including zeros at the start.
#[test]
fn zeros_fire_once() {
    let text =
        "struct Count; coord x = 0; discrete count = 0; kinetic = 1/2 * dot(x)^2; potential = 1/2 * x^2;
        event zero = x, crossing => { count = count + 1; }";
    let programs = programs(text);
    let names = programs.variables.state_names();
    let speed = names.iter().position(|name| name == "x_dot").expect("a speed").to_string();
    let ([_, _, x, count], messages) = stepped("count", text, &["0.1", "100", &speed, "1"]);
    assert!((x - 10.0_f64.sin()).abs() < 1e-11 && count == 3.0, "{x} {count} {messages}");
    assert_eq!(messages.lines().count(), 3, "{messages}");
}

/// A pendulum in Cartesian coordinates keeps its length in a long motion, and rejects a start with
/// a different length.
#[test]
fn constraints_hold() {
    let rod = "struct Rod; coord x = 0.6, y = -0.8; kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
        potential = 9.81 * y; constraint length = x^2 + y^2 - 1;";
    let ([status, time, x, y], messages) = stepped("rod", rod, &["0.5", "400"]);
    assert!([status, time] == [0.0, 200.0] && (x.hypot(y) - 1.0).abs() < 4e-15, "{x} {y} {messages}");
    let unit = unit(&rod.replace("0.6", "0.7"), Version::Three);
    let output = run(&stepper("off", &unit), &guid(&unit), &[STEPS, "0.5", "1"]);
    let message = String::from_utf8(output.stderr).expect("text");
    assert!(message.contains("the start violates the constraint length"), "{message}");
}

#[test]
fn wrong_requests_are_errors() {
    for unit in VERSIONS.map(|version| unit(BOUNCE, version)) {
        let program = stepper("wrong", &unit);
        let failure = |guid: &str, arguments: &[&str]| {
            let output = run(&program, guid, &[&[STEPS][..], arguments].concat());
            (output.status.code(), String::from_utf8(output.stderr).expect("text"))
        };
        let (code, message) = failure("{0}", &["1", "1"]);
        assert!(code == Some(1) && message.contains("the GUID is not that of this model"), "{message}");
        for (reference, value, words) in [
            ("99", "1", "there is no variable with the value reference 99"),
            ("5", "nan", "e = nan is not finite"),
            ("5", "1.5", "e = 1.5 is outside the declared range"),
            ("2", "1", "der(h) = 1 follows from other variables"),
            ("7", "1", "t = 1 follows from other variables"),
        ] {
            let (code, message) = failure(&guid(&unit), &["1", "1", reference, value]);
            assert!(code == Some(3) && message.contains(words), "{message}");
        }
    }
}

/// Calls in any order, with any numbers, neither leave their memory nor lose the state.
#[test]
fn any_calls_are_survived() {
    const SAFE: [&str; 2] = ["-fsanitize=address,undefined", "-fno-sanitize-recover=all"];
    const SAMPLED: &str = "struct Sampled; param period = 0.17, e in 0..1 = 0.5; input push = 0;
        coord x = 1; discrete held = 0; kinetic = 1/2 * dot(x)^2; force x = held + push - sin(x) + abs(x);
        every period => { held = -2 * x - dot(x); }
        event middle = x, crossing => { dot(x) = e * dot(x); } output pull = held;";
    const ROD: &str = "struct Rod; param m > 0 = 1; input push = 0; coord x = 0.6, y = -0.8;
        kinetic = 1/2 * m * (dot(x)^2 + dot(y)^2); force x = push; constraint length = x^2 + y^2 - 1;";
    for (name, text) in [("bounce", BOUNCE), ("sampled", SAMPLED), ("rod", ROD)] {
        for unit in VERSIONS.map(|version| unit(text, version)) {
            let program =
                program(&format!("calls_{name}"), &unit, ("calls.c", include_str!("calls.c")), &SAFE);
            for kind in [STEPS, EXCHANGE, STEPS_WITH_EVENTS] {
                let output = run(&program, kind, &["20000"]);
                let messages = String::from_utf8_lossy(&output.stderr).into_owned();
                assert!(output.status.success(), "{name} {kind}: {} {messages}", output.status);
                let counts = String::from_utf8(output.stdout).expect("numbers");
                let counts = counts.split_whitespace().map(|count| count.parse::<u32>().expect("a number"));
                assert!(counts.into_iter().all(|count| count > 500), "{name} {kind}");
            }
        }
    }
}

#[test]
fn bytes_depend_on_the_declaration_alone() {
    let [one, two] = [0, 1].map(|_| unit(BOUNCE, Version::Three));
    let packed = |unit: &MockupUnit| {
        let binary = unit.compile("cc").expect("a library");
        unit.archive(Some(&binary)).expect("an archive")
    };
    assert_eq!(packed(&one), packed(&two));
    assert_ne!(guid(&one), guid(&unit(&BOUNCE.replace("0.8", "0.7"), Version::Three)));
}

#[test]
fn refusals_name_what_is_missing() {
    let base = "coord x; kinetic = 1/2 * dot(x)^2;";
    let refused = |text: &str, change: fn(&mut Start)| {
        let programs = programs(text);
        let mut start = start(&programs);
        change(&mut start);
        MockupUnit::new(&programs, &start, Version::Two).expect_err("a refusal").to_string()
    };
    let touching = refused(&format!("{base} event floor = x, falling => impact(0.5);"), |_| {});
    assert_eq!(
        touching,
        "rigid contacts and friction run in Rust, on the command line and in Python only (compliant contacts, with a `stiffness`, run here, too): `floor`"
    );
    let functions = refused(&format!("function road(x); {base} potential = road(x);"), |_| {});
    assert!(functions.contains("`road_derivative`"), "{functions}");
    let missing =
        refused(&format!("param k; {base} potential = k * x^2;"), |start| start.fields[0] = f64::NAN);
    assert_eq!(missing, "no finite value at the start: `k`");
    assert_eq!(refused(base, |start| start.state.truncate(1)), "no finite value at the start: `x_dot`");
    let compiler = unit(BOUNCE, Version::Two).compile("no-such-compiler").expect_err("no compiler");
    assert!(matches!(compiler, ExportError::NoCompiler(..)), "{compiler}");
    assert!(compiler.to_string().contains("`no-such-compiler`"), "{compiler}");
    let rejected = unit(BOUNCE, Version::Two).compile("cc --no-such-option").expect_err("no option");
    assert!(rejected.to_string().contains("no-such-option"), "{rejected}");
}

/// Derivatives with respect to state and inputs are slopes of the rates and of the outputs, even
/// through accelerations, multipliers and quaternions.
#[test]
fn derivatives_are_slopes() {
    let pulled = "struct Pulled; input u = 0.5; coord x, y; kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
        force x = u * y; constraint length = x^2 + y^2 - 1;
        output tension = 2 * length; output a = ddot(x) * u;";
    for text in SYSTEMS.into_iter().chain([pulled]) {
        let programs = programs(text);
        let fields = start(&programs).fields;
        let layout = programs.layout;
        let outputs = programs.outputs.clone();
        let numeric = NumericSystem::of(Arc::new(programs));
        let states = layout.positions + layout.velocities;
        let point = (0..states)
            .map(|i| 0.4 + 0.13 * (i as f64 * 1.7).sin())
            .chain(fields[layout.parameters..].to_vec());
        let point = point.collect::<Vec<f64>>();
        let at = |point: &[f64]| {
            let mut numeric = numeric.clone();
            for (index, value) in fields[..layout.parameters].iter().chain(&point[states..]).enumerate() {
                assert!(numeric.set_field(index, *value));
            }
            (numeric, point[..states].to_vec())
        };
        let values = |point: &[f64]| {
            let (numeric, y) = at(point);
            let (q, v) = y.split_at(layout.positions);
            let outputs = outputs.iter().flat_map(|(_, program)| numeric.evaluate(program, 0.2, q, v));
            numeric.rhs(0.2, &y).into_iter().chain(outputs).collect::<Vec<_>>()
        };
        let (numeric, y) = at(&point);
        let (q, v) = y.split_at(layout.positions);
        let linearised = numeric.programs().linearised.clone().expect("requested");
        let exact = numeric.evaluate(&linearised, 0.2, q, v);
        for column in 0..point.len() {
            let moved = |by: f64| {
                values(
                    &point
                        .iter()
                        .enumerate()
                        .map(|(i, x)| if i == column { x + by } else { *x })
                        .collect::<Vec<_>>(),
                )
            };
            let (ahead, behind) = (moved(1e-5), moved(-1e-5));
            for (row, (ahead, behind)) in ahead.iter().zip(&behind).enumerate() {
                let (slope, found) = ((ahead - behind) / 2e-5, exact[row * point.len() + column]);
                let scale = 1.0 + slope.abs() + ahead.abs();
                assert!(
                    (slope - found).abs() < 1e-6 * scale,
                    "{text}: [{row}][{column}] {found}, not {slope}"
                );
            }
        }
    }
}
