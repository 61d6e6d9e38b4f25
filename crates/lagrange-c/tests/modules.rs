//! Modules of C, compiled by the machine's C compiler without a warning. All functions return the
//! results of the interpreter, bit by bit. Where the machine has Node.js, scripts return them up to
//! the rounding of elementary functions.
#![cfg(unix)]

mod systems;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Arc;

use lagrange_c::{Module, Refusal, Script};
use lagrange_core::derive::StrategyChoice;
use lagrange_core::model::Product;
use lagrange_core::pipeline::{NumericSystem, Programs, Reaction, parse};
use lagrange_core::program::Program;

use systems::SYSTEMS;

/// Number of states at which each system is compared.
const STATES: usize = 40;
const OPTIONS: [&str; 6] = ["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"];

/// Time, state and p, followed by the residuals of constraints.
struct Sample {
    t: f64,
    y: Vec<f64>,
    p: Vec<f64>,
}

/// A system with its module and the states of the comparison.
struct Case {
    numeric: NumericSystem,
    module: Module,
    samples: Vec<Sample>,
}

fn programs(text: &str) -> Programs {
    let system = parse(text).unwrap_or_else(|report| panic!("{text}: {report}"));
    let system = system.with(Product::Jacobian).with(Product::SystemMatrix);
    let derived = system.derive(StrategyChoice::Cheapest);
    Programs::new(&derived.unwrap_or_else(|report| panic!("{text}: {report}")))
}

fn refusal(text: &str) -> Refusal {
    Module::new(&programs(text), None).expect_err("C cannot say this")
}

/// Returns numbers between −1 and 1 by a linear congruential generator.
fn random(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
}

impl Case {
    fn new(text: &str) -> Case {
        let programs = programs(text);
        let module = Module::new(&programs, None).unwrap_or_else(|refusal| panic!("{text}: {refusal}"));
        let (layout, defaults, mut seed) = (programs.layout, programs.defaults.clone(), 1);
        let samples = (0..STATES).map(|_| Sample {
            t: 2.0 + 2.0 * random(&mut seed),
            y: (0..layout.positions + layout.velocities).map(|_| 1.5 * random(&mut seed)).collect(),
            p: defaults
                .iter()
                .map(|value| value * (1.0 + 0.3 * random(&mut seed)))
                .chain((0..layout.multipliers).map(|index| 0.1 * (index + 1) as f64))
                .collect(),
        });
        let samples = samples.collect();
        Case { numeric: NumericSystem::of(Arc::new(programs)), module, samples }
    }

    /// Returns the functions that the header declares, without their prefix.
    fn functions(&self) -> Vec<&str> {
        let head = format!("void {}_", self.module.name);
        let lines = self.module.header.lines().filter(|line| line.contains("(double t,"));
        lines.filter_map(|line| line.strip_prefix(&head)?.split('(').next()).collect()
    }

    /// Computes the values of a function of the module by the interpreter.
    fn expected(&self, function: &str, Sample { t, y, p }: &Sample) -> Vec<f64> {
        let mut numeric = self.numeric.clone();
        let programs = numeric.programs().clone();
        let (fields, residuals) = p.split_at(programs.layout.fields());
        fields.iter().enumerate().for_each(|(index, value)| assert!(numeric.set_field(index, *value)));
        let (q, v) = y.split_at(programs.layout.positions);
        let run = |program: &Program| numeric.evaluate(program, *t, q, v);
        let numbered = |prefix: &str| function.strip_prefix(prefix).map(str::parse::<usize>);
        if let Some(index) = numbered("after_event_") {
            let Reaction::Replace(program) = &programs.reactions[index.expect("an index")] else {
                panic!("{function} replaces nothing")
            };
            return run(program);
        }
        if let Some(index) = numbered("after_clock_") {
            return run(&programs.clocks[index.expect("an index")].after);
        }
        match function {
            "rhs" => numeric.rhs(*t, y),
            "position_rates" => numeric.position_rates(*t, q, v),
            "accelerations" => numeric.acceleration(*t, q, v),
            "position_residuals" => run(&programs.position_residuals),
            "correction" => numeric.correction(*t, q, v, residuals),
            "multipliers" => numeric.multipliers(*t, q, v),
            "jacobian" => run(programs.jacobian.as_ref().expect("requested")),
            "linearised" => run(programs.linearised.as_ref().expect("requested")),
            "outputs" => programs.outputs.iter().flat_map(|(_, program)| run(program)).collect(),
            "events" => run(&programs.event_functions),
            "switches" => run(&programs.switches),
            "start" => run(programs.start.as_ref().expect("declared")),
            "clock_periods" => programs.clocks.iter().flat_map(|clock| run(&clock.period)).collect(),
            name => {
                let product = Product::by_name(name).unwrap_or_else(|| panic!("{name} is not compared"));
                numeric.product(product, *t, q, v).expect("a product of the module")
            }
        }
    }
}

/// Returns a program that prints the results of all functions at all states.
fn main_of(cases: &[Case]) -> String {
    let list = |values: &[f64]| {
        values.iter().chain(&[0.0]).map(|value| format!("{value:?}")).collect::<Vec<_>>().join(", ")
    };
    // Each call is a function behind a pointer, since compilers need minutes for a single one.
    let mut calls = Vec::new();
    for case in cases {
        for (Sample { t, y, p }, function) in
            case.samples.iter().flat_map(|sample| case.functions().into_iter().map(move |f| (sample, f)))
        {
            let count = case.expected(function, &case.samples[0]).len();
            calls.push(format!(
                "static void call_{}(void)\n{{\n    const double y[] = {{ {} }}, p[] = {{ {} }};\n    \
                 double out[{count}];\n    {}_{function}({t:?}, y, p, out);\n    print({count}, out);\n}}\n",
                calls.len(),
                list(y),
                list(p),
                case.module.name
            ));
        }
    }
    let names = (0..calls.len()).map(|call| format!("    call_{call},\n")).collect::<String>();
    let calls = calls.concat();
    let includes = cases.iter().map(|case| format!("#include \"{}.h\"\n", case.module.name));
    format!(
        "#include <stdio.h>\n{}\nstatic void print(int n, const double *x)\n{{\n    for (int i = 0; i < n; i++)\n        \
         printf(\"%.17g \", x[i]);\n    printf(\"\\n\");\n}}\n\n{calls}\n\
         static void (*const calls[])(void) = {{\n{names}}};\n\nint main(void)\n{{\n    \
         for (unsigned i = 0; i < sizeof calls / sizeof *calls; i++)\n        calls[i]();\n    return 0;\n}}\n",
        includes.collect::<String>()
    )
}

fn compile(compiler: &str, folder: &Path, sources: &[PathBuf]) -> PathBuf {
    let program = folder.join(compiler);
    let mut command = Command::new(compiler);
    command.args(OPTIONS).arg("-O1").arg("-o").arg(&program).args(sources).arg("-lm");
    let output = command.output().expect("a C compiler, which linking needs, too");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    program
}

fn written(folder: &Path, name: &str, text: &str) -> PathBuf {
    let path = folder.join(name);
    fs::write(&path, text).expect("a file that can be written");
    path
}

/// Returns a script that prints the results of all functions at all states.
fn script_of(case: &Case) -> String {
    let script = Script::new(case.numeric.programs(), |_| true).expect("what C computes");
    assert_eq!(script.functions, case.functions());
    let list = |values: &[f64]| format!("{values:?}").replace("inf", "Infinity");
    let fields = case.numeric.programs().layout.fields();
    let calls = case.samples.iter().map(|sample| {
        let Sample { t, y, p } = sample;
        let sides = case.expected("switches", sample).into_iter().map(f64::signum).collect::<Vec<_>>();
        let p = [&p[..fields], &sides, &p[fields..]].concat();
        format!("  for (const f of functions) print(f, {t:?}, {}, {});\n", list(y), list(&p))
    });
    format!(
        "(() => {{\n\"use strict\";\n{}const functions = [{}];\nfunction print(f, t, y, p) {{\n  const out = [];\n  \
         f(t, y, p, out);\n  console.log(out.join(\" \"));\n}}\n{}}})();\n",
        script.text,
        script.functions.iter().map(|name| format!("system_{name}")).collect::<Vec<_>>().join(", "),
        calls.collect::<String>()
    )
}

/// Elementary functions of both differ by an ulp or two, which cancellation amplifies.
#[test]
fn scripts_have_the_numbers_of_the_interpreter() {
    const NEAR: f64 = 256.0 * f64::EPSILON;
    if Command::new("node").arg("--version").output().is_err() {
        eprintln!("skipped: there is no `node` to run scripts");
        return;
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("scripts");
    fs::create_dir_all(&folder).expect("a folder");
    let cases = SYSTEMS.map(Case::new);
    let path = written(&folder, "main.js", &cases.iter().map(script_of).collect::<String>());
    let output = Command::new("node").arg(path).output().expect("a script");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    compare(&cases, &String::from_utf8(output.stdout).expect("numbers"), |a, b, size| {
        (a - b).abs() <= NEAR * size
    });
}

#[test]
fn functions_of_modules_have_the_bits_of_the_interpreter() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("modules");
    let cases = SYSTEMS.map(Case::new);
    let has_clang = Command::new("clang").arg("--version").output().is_ok();
    for compiler in ["cc"].into_iter().chain(has_clang.then_some("clang")) {
        compare(&cases, &run(&folder, &cases, compiler), |a, b, _| a == b);
    }
}

/// Runs the functions of all cases, and returns their values, a line for each.
fn run(folder: &Path, cases: &[Case], compiler: &str) -> String {
    fs::create_dir_all(folder).expect("a folder");
    let mut sources = vec![written(folder, "main.c", &main_of(cases))];
    for Case { module, .. } in cases {
        written(folder, &format!("{}.h", module.name), &module.header);
        sources.push(written(folder, &format!("{}.c", module.name), &module.source));
    }
    let output = Command::new(compile(compiler, folder, &sources)).output().expect("a program");
    assert!(output.status.success());
    String::from_utf8(output.stdout).expect("numbers")
}

fn numbers(line: &str) -> Vec<f64> {
    line.split_whitespace().map(|word| word.parse().expect("a number")).collect()
}

/// Compares numbers. The third argument of `is_same` is the magnitude of the largest result of a
/// function.
fn compare(cases: &[Case], printed: &str, is_same: impl Fn(f64, f64, f64) -> bool) {
    let mut lines = printed.lines();
    let mut compared = 0;
    for case in cases {
        for sample in &case.samples {
            for function in case.functions() {
                let found = numbers(lines.next().expect("a line for each function"));
                let expected = case.expected(function, sample);
                let size = expected.iter().map(|value| value.abs()).fold(0.0, f64::max);
                let is_same = |(a, b): (&f64, &f64)| is_same(*a, *b, size) || a.is_nan() && b.is_nan();
                let are_same = found.len() == expected.len() && found.iter().zip(&expected).all(is_same);
                assert!(are_same, "{}_{function}: {found:?}, not {expected:?}", case.module.name);
                compared += found.iter().filter(|value| value.is_finite()).count();
            }
        }
    }
    assert!(lines.next().is_none() && compared > 10_000, "{compared} finite numbers are compared");
}

/// The gradients of constraints are parallel at y = 0, and C has no alternative to elimination.
#[test]
fn nothing_is_plausible_where_elimination_fails() {
    let mut case = Case::new(
        "struct Pinned; coord x, y; kinetic = 1/2 * (dot(x)^2 + dot(y)^2); potential = y;
        constraint a = x^2 + y^2 - 1; constraint b = x^2 + 2 * y^2 - 1;",
    );
    let at = |y: f64| Sample { t: 0.0, y: vec![1.0, y, 0.0, 0.5], p: vec![0.1, 0.2] };
    case.samples = vec![at(0.5), at(0.0), at(1e-13)];
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("pinned");
    let printed = run(&folder, std::slice::from_ref(&case), "cc");
    let per_sample = case.functions().len();
    let lines = printed.lines().collect::<Vec<_>>();
    let row = case.functions().iter().position(|name| *name == "accelerations").expect("a function");
    let [regular, singular, near] = [0, 1, 2].map(|sample| numbers(lines[sample * per_sample + row]));
    assert_eq!(regular, case.expected("accelerations", &case.samples[0]));
    assert!(regular.iter().all(|value| value.is_finite()), "{regular:?}");
    assert!(singular.iter().chain(&near).all(|value| value.is_nan()), "{singular:?}, {near:?}");
}

#[test]
fn ranges_and_nominal_values_are_arrays() {
    let text = "struct Mirror; coord tilt in -2..=2 nominal 0.5, free; kinetic = dot(tilt)^2 + dot(free)^2;";
    let Module { header, source, .. } = Module::new(&programs(text), None).expect("a module");
    let arrays = [
        ("nominal", "0.5, 1.0, 0.5, 1.0"),
        ("min", "-2.0, -INFINITY, -INFINITY, -INFINITY"),
        ("max", "2.0, INFINITY, INFINITY, INFINITY"),
    ];
    for (name, values) in arrays {
        let array = format!("const double mirror_state_{name}[4]");
        assert!(header.contains(&format!("extern {array};")), "{header}");
        assert!(source.contains(&format!("{array} = {{ {values} }};")), "{source}");
    }
    let plain = Module::new(&programs("coord x; kinetic = dot(x)^2;"), None).expect("a module");
    assert!(!plain.header.contains("state_m") && !plain.header.contains("state_nominal"));
}

#[test]
fn headers_say_the_units_of_results_if_any_are_declared() {
    let header = |text: &str| Module::new(&programs(text), None).expect("a module").header;
    let units =
        header("param m: kg = 2; coord x: m; kinetic = 1/2 * m * dot(x)^2; emit { inverse_mass_matrix }");
    for (function, unit) in [
        ("energy", "In J."),
        ("momenta", "Each entry is in J over the unit of its velocity."),
        ("mass_matrix", "Each entry is in J over the units of the velocities of its row and of its column."),
        (
            "inverse_mass_matrix",
            "Each entry is in 1/J times the units of the velocities of its row and of its column.",
        ),
    ] {
        let (before, _) = units.split_once(&format!("_{function}(")).expect("a function");
        let docs = before.rsplit("\n\n").next().unwrap_or_default();
        assert!(docs.contains(unit), "{function}: {docs}");
    }
    assert!(!header("param m = 2; coord x; kinetic = 1/2 * m * dot(x)^2;").contains("In J"));
}

#[test]
fn systems_that_c_cannot_compute_are_refused_by_name() {
    let base = "coord x; kinetic = 1/2 * dot(x)^2;";
    let functions = refusal(&format!("function road(x); {base} potential = road(x);"));
    assert!(functions.to_string().contains("`road_derivative`"), "{functions}");
    let touching = refusal(&format!("{base} event floor = x, falling => impact(0.5);"));
    assert_eq!(touching, Refusal::Touching(vec!["floor".to_owned()]));
    let delayed = refusal(&format!("{base} let past = delay(x, 1); force x = -past;"));
    assert_eq!(delayed, Refusal::Delays(vec!["past".to_owned()]));
    let noisy = refusal(&format!("{base} noise w, density: 1; force x = w;"));
    assert_eq!(noisy, Refusal::Noise(vec!["w".to_owned()]));
    assert!(noisy.to_string().contains("`lagrange simulate`"), "{noisy}");
    let constants = refusal("coord x; kinetic = 1e-200 * dot(x)^2; potential = 1e200 * x;");
    assert!(matches!(constants, Refusal::Constants(_)), "{constants}");
    let beam = "coord x; kinetic = 1/2 * dot(x)^2; constraint a = x - 1; constraint b = sin(x) - 1/2;";
    assert_eq!(refusal(beam), Refusal::Redundant(vec!["a".to_owned(), "b".to_owned()]));
}
