//! The equations of motion as C, compiled by the machine's C compiler: as plain C, and as CUDA with
//! its keywords defined away. Graphics processors compile the same text (`examples/device`).

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

use lagrange_core::code::{Precision, Surroundings, Target, prelude, statements};
use lagrange_core::derive::StrategyChoice;
use lagrange_core::elementary::ROWS;
use lagrange_core::expr::{Function, Graph, Relation};
use lagrange_core::functions::apply;
use lagrange_core::number::Number;
use lagrange_core::opaque::Opaque;
use lagrange_core::pipeline::{Derived, NumericSystem, parse};
use lagrange_core::program::{Labels, lower, run as interpret};
use lagrange_core::symbol::Role;

use crate::reference::{Reference, names};

/// Definitions that replace what CUDA has and C lacks, for the text alone.
const CUDA: &str = "#define _GNU_SOURCE\n#include <math.h>\n#define __CUDACC__\n#define __device__\n#define __forceinline__ inline\n";
const PRINT: &str = "#include <stdio.h>\n\
    static void print(int n, const double *x) { for (int i = 0; i < n; i++) printf(\"%.17g \", x[i]); printf(\"\\n\"); }\n";

/// A system with the values of its parameters and inputs, and the states of the comparison.
struct Case {
    name: String,
    derived: Derived,
    values: Vec<f64>,
    states: Vec<(f64, Vec<f64>, Vec<f64>)>,
}

#[test]
fn c_computes_what_the_scalar_code_computes() {
    let with_quaternions = models(|name| name == "ball_2");
    check(&[references(), with_quaternions, vec![with_states()]].into_iter().flatten().collect::<Vec<_>>());
}

/// `cargo test --release -p lagrange-core --test oracle -- --ignored kernels`
#[test]
#[ignore = "deriving robots takes seconds"]
fn c_computes_robots() {
    check(&models(|_| true));
}

fn check(cases: &[Case]) {
    let program = format!("{PRINT}{}", program(cases, Precision::Double));
    let printed = ["", CUDA].map(|dialect| run("systems", &format!("{dialect}{program}")));
    for printed in printed {
        let mut lines = printed.lines();
        for Case { name, derived, states, .. } in cases {
            let numeric = NumericSystem::new(derived);
            for (t, q, v) in states {
                let expected = numeric.rhs(*t, &[q.as_slice(), v].concat());
                let (rates, accelerations) = expected.split_at(q.len());
                for expected in [accelerations, rates] {
                    let found = numbers(lines.next().expect("a line for each result"));
                    assert!(agree(&found, expected), "{name} at t = {t}: {found:?}, not {expected:?}");
                }
            }
        }
        assert_eq!(lines.next(), None);
    }
}

/// A `double` would cause a warning.
#[test]
fn single_precision_is_that_throughout() {
    let print = "static void print(int n, const float *x) { (void)n, (void)x; }\n";
    let program = program(&references(), Precision::Single);
    for dialect in ["", CUDA] {
        compile("single", &format!("{dialect}{print}{program}"), &["-fsyntax-only", "-Wdouble-promotion"]);
    }
}

/// The variables x and y of C.
struct TwoNumbers;

impl Surroundings for TwoNumbers {
    fn place(&self, role: Role) -> String {
        if role == Role::Coordinate(0) { "x".to_owned() } else { "y".to_owned() }
    }

    fn name(&self, _role: Role) -> Option<String> {
        None
    }

    fn call(&self, function: &Opaque, _arguments: &[&str]) -> String {
        unreachable!("{function:?}")
    }
}

/// Tests every function, large powers and every relation, inside and outside their domains.
#[test]
fn functions_have_the_limits_of_the_language() {
    let mut graph = Graph::new();
    let (x, y) = (graph.symbol("x", Role::Coordinate(0)), graph.symbol("y", Role::Coordinate(1)));
    let mut roots = ROWS.map(|row| apply(&mut graph, row.function, &[x, y][..row.arity])).to_vec();
    roots.extend([77, -78].map(|exponent| graph.power(x, Number::from(exponent))));
    let relations = [Relation::Less, Relation::LessEqual, Relation::Greater, Relation::GreaterEqual];
    let (one, two) = (graph.number(1), graph.number(2));
    roots.extend(relations.map(|relation| graph.choose(relation, x, y, one, two)));
    let computed = lower(&graph, &roots, &Labels::default());
    let body = statements(&computed, Target::C(Precision::Double), &TwoNumbers, "a").expect("no numbers");
    let special = [0.0, -0.0, 0.5, -0.5, 1.0, 3.0, -2.0, 1e200, f64::INFINITY, -f64::INFINITY, f64::NAN];
    let places = special.iter().flat_map(|x| special.iter().map(|y| [*x, *y])).collect::<Vec<_>>();
    let calls = places.iter().map(|[x, y]| {
        format!("functions({}, {}, a); print({}, a);\n", literal(*x), literal(*y), roots.len())
    });
    let text = format!(
        "{}{PRINT}static void functions(REAL x, REAL y, REAL *a)\n{{\n{body}}}\nint main(void) {{ REAL a[{}];\n{}return 0; }}\n",
        prelude(Precision::Double),
        roots.len(),
        calls.collect::<String>()
    );
    let printed = run("functions", &text);
    assert_eq!(printed.lines().count(), places.len());
    for ([x, y], line) in places.iter().zip(printed.lines()) {
        let expected = interpret(&computed, |role| if role == Role::Coordinate(0) { *x } else { *y });
        for (root, (found, expected)) in numbers(line).into_iter().zip(expected).enumerate() {
            let is_near = (found - expected).abs() <= 1e-13 * expected.abs() && expected.is_finite();
            // Of two equal zeros, either may count as the smaller one.
            let has_sign = !matches!(ROWS.get(root), Some(row) if [Function::Min, Function::Max].contains(&row.function));
            let is_same =
                found == expected && (!has_sign || found.is_sign_negative() == expected.is_sign_negative());
            let agree = is_same || (is_near && expected != 0.0) || (found.is_nan() && expected.is_nan());
            assert!(agree, "function {root} of {x} and {y} is {found}, not {expected}");
        }
    }
}

/// Compares vectors relative to their largest entry.
fn agree(found: &[f64], expected: &[f64]) -> bool {
    let largest = expected.iter().fold(0.0_f64, |largest, value| largest.max(value.abs()));
    let is_near = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-12 * largest;
    found.len() == expected.len() && found.iter().zip(expected).all(is_near)
}

/// Returns the references of accelerations, each at its states.
fn references() -> Vec<Case> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/oracle");
    let cases = names(&directory).into_iter().map(|name| {
        let reference = Reference::read(&directory, &name);
        let states = reference.states().map(|state| (state.t, state.q, state.v)).collect();
        let settings = reference.settings();
        let value = |field: &str| settings.iter().find(|(name, _)| *name == field).expect("every field").1;
        case(name, &reference.declaration, value, states)
    });
    cases.collect()
}

/// Returns the models of robots and chains in space, quaternions among their positions.
fn models(is_wanted: impl Fn(&str) -> bool) -> Vec<Case> {
    let directory = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/spatial/models");
    let entries = fs::read_dir(directory).expect("the directory of models");
    let mut paths = entries.map(|entry| entry.expect("a readable entry").path()).collect::<Vec<PathBuf>>();
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "lag"));
    paths.retain(|path| path.file_stem().is_some_and(|name| is_wanted(&name.to_string_lossy())));
    paths.sort();
    let cases = paths.iter().map(|path| {
        let declaration = fs::read_to_string(path).expect("a declaration");
        let no_field = |field: &str| panic!("{field} has a value");
        let mut case = case(path.display().to_string(), &declaration, no_field, Vec::new());
        let wave = |n: usize, phase: f64| (0..n).map(|i| 0.3 + 0.5 * (phase + i as f64).sin()).collect();
        let model = &case.derived.model;
        case.states.push((0.5, wave(model.coordinates.len(), 0.2), wave(model.speeds.len(), 1.1)));
        case
    });
    cases.collect()
}

/// Returns a motor whose current and whose temperature have rates of their own.
fn with_states() -> Case {
    let motor = "param j = 0.75, k = 0.75, r = 0.75, l = 0.75; state heat; coord theta; state i; input u = 12;
        kinetic = 1/2 * j * dot(theta)^2; force theta = k * i - heat * theta;
        dot(i) = (u - r * i * (1 + heat) - k * dot(theta)) / l; dot(heat) = r * i^2 - abs(heat) + sin(t * theta);";
    let value = |field: &str| if field == "u" { 12.0 } else { 0.75 };
    case("motor".to_owned(), motor, value, vec![(0.5, vec![0.2, -1.5, 2.25], vec![0.7])])
}

fn case(
    name: String,
    declaration: &str,
    value: impl Fn(&str) -> f64,
    states: Vec<(f64, Vec<f64>, Vec<f64>)>,
) -> Case {
    let derived = parse(declaration).and_then(|system| system.derive(StrategyChoice::Cheapest));
    let derived = derived.unwrap_or_else(|report| panic!("{name}: {report}"));
    let fields = derived.model.parameters.iter().chain(&derived.model.inputs);
    let values = fields.map(|field| value(&field.name)).collect();
    Case { name, derived, values, states }
}

/// Returns a program that prints the accelerations and the rates of the positions of all systems at
/// their states.
fn program(cases: &[Case], precision: Precision) -> String {
    const NAMES: [&str; 3] = ["acceleration", "position_rates", "normalise"];
    const SIZES: [&str; 3] = ["POSITIONS", "VELOCITIES", "PARAMETERS"];
    let (mut functions, mut calls) = (String::new(), String::new());
    for (index, Case { name, derived, values, states }) in cases.iter().enumerate() {
        let kernel = derived.kernel(precision).unwrap_or_else(|report| panic!("{name}: {report}"));
        let own =
            NAMES.map(|name| format!("#undef lagrange_{name}\n#define lagrange_{name} {name}_{index}\n"));
        let sizes = SIZES.map(|size| format!("#undef LAGRANGE_{size}\n"));
        writeln!(functions, "{}{}{kernel}", own.concat(), sizes.concat()).expect("a string");
        let (nq, nv) = (derived.model.coordinates.len(), derived.model.speeds.len());
        for (t, q, v) in states {
            let [q, v, p] = [q, v, values].map(|values| {
                let values = values.iter().copied().chain([0.0]).map(literal).collect::<Vec<_>>();
                format!("{{ {} }}", values.join(", "))
            });
            writeln!(
                calls,
                "{{ const REAL t = {}, q[] = {q}, v[] = {v}, p[] = {p}; REAL a[{nv}], rates[{nq}]; \
                 lagrange_acceleration(t, q, v, p, a); lagrange_position_rates(t, q, v, p, rates); \
                 print({nv}, a); print({nq}, rates); }}",
                literal(*t)
            )
            .expect("a string");
        }
        writeln!(functions, "static void compare_{index}(void)\n{{\n{calls}}}").expect("a string");
        calls.clear();
    }
    let calls = (0..cases.len()).map(|index| format!("compare_{index}();\n")).collect::<String>();
    format!("{functions}\nint main(void)\n{{\n{calls}return 0;\n}}\n")
}

/// Returns a number as a C literal, valid in single precision, too.
fn literal(value: f64) -> String {
    match value {
        _ if value.is_nan() => "(REAL)NAN".to_owned(),
        _ if value.is_infinite() => format!("(REAL){}INFINITY", if value < 0.0 { "-" } else { "" }),
        _ => format!("(REAL){value:?}"),
    }
}

fn numbers(line: &str) -> Vec<f64> {
    line.split_whitespace().map(|word| word.parse().expect("a number")).collect()
}

/// Runs a program and returns its output.
fn run(name: &str, text: &str) -> String {
    let program = compile(name, text, &[]);
    let output = Command::new(program).output().expect("the program starts");
    assert!(output.status.success());
    String::from_utf8(output.stdout).expect("numbers")
}

/// Compiles a program with the C compiler, which must not warn.
fn compile(name: &str, text: &str, options: &[&str]) -> PathBuf {
    static NUMBER: AtomicUsize = AtomicUsize::new(0);
    let number = NUMBER.fetch_add(1, Ordering::Relaxed);
    let program = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}_{number}"));
    let source = program.with_extension("c");
    fs::write(&source, text).expect("a file that can be written");
    let mut compiler = Command::new("cc");
    compiler
        .args(["-Wall", "-Wextra", "-Werror"])
        .args(options)
        .arg("-o")
        .args([&program, &source])
        .arg("-lm");
    let output = compiler.output().expect("a C compiler, which linking needs, too");
    assert!(output.status.success(), "{}: {}", source.display(), String::from_utf8_lossy(&output.stderr));
    program
}
