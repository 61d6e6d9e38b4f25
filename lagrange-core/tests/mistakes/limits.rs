//! Limits: a test exceeds each row of the table in the description of the language. Compilation
//! refuses excesses before any work.

use std::fs;
use std::path::Path;
use std::time::Duration;

use lagrange_core::diagnostics::Report;
use lagrange_core::limits::{
    MANY_OPERATIONS, MAX_BRANCHES, MAX_CONSTRAINTS, MAX_CONTACT_PAIRS, MAX_CONTACTS, MAX_COUPLED,
    MAX_DECIMAL_EXPONENT, MAX_DEPENDENT_CONSTRAINTS, MAX_ELEMENTS, MAX_EVENTS, MAX_EXPANDED_NESTING,
    MAX_FILE_BYTES, MAX_INDICES, MAX_INLINED, MAX_ITERATIONS, MAX_LITERAL_LENGTH, MAX_LOCATED, MAX_NESTING,
    MAX_NOISES, MAX_NUMBER_BITS, MAX_OPERATIONS, MAX_OUTPUTS, MAX_PART_BYTES, MAX_PARTS_NESTED, MAX_PLACED,
    MAX_POINTS, MAX_STATES, MAX_TABLE_ARGUMENTS, MAX_UNIT_EXPONENT, MAX_VELOCITIES, MAX_WRITTEN_OUT,
};
use lagrange_core::pipeline::{expand, parse_with};
use lagrange_core::tables::{FileText, decoded};

use crate::processor_time::of_this_thread;
use crate::report;

/// Processor time beyond which a refusal must have done work first; refusals take milliseconds.
const MAX_TIME: Duration = Duration::from_secs(5);
/// Processor time beyond which presenting three bodies counts as hanging; it takes two seconds
/// unoptimised.
const MAX_TIME_OF_PRESENTATION: Duration = Duration::from_secs(30);

/// A row of the table: the limit, and the message beyond it.
struct Row {
    limit: String,
    message: String,
}

/// Returns the rows of the table in the description of the language.
fn rows() -> Vec<Row> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../src/language.md");
    let text = fs::read_to_string(path).expect("the description of the language");
    let section = text.split("\n# Limits\n").nth(1).expect("a section of limits");
    let rows = section.lines().filter(|line| line.starts_with('|')).skip(2);
    let row = |line: &str| {
        let cells = line.trim_matches('|').split(" | ").map(str::trim).collect::<Vec<_>>();
        Row { limit: cells[1].to_owned(), message: cells[2].to_owned() }
    };
    rows.map(row).collect()
}

fn points(count: usize) -> String {
    (0..count).map(|x| format!("({x}, 0)")).collect::<Vec<_>>().join(", ")
}

/// A limit with its name in the sources, and a declaration that exceeds it.
type Excess = (&'static str, String, String);

macro_rules! excess {
    ($limit:ident, $text:expr) => {
        (stringify!($limit), $limit.to_string(), $text)
    };
}

/// Returns a declaration that exceeds each limit, in the order of the table.
fn excesses() -> Vec<Excess> {
    let coordinate = "coord x; kinetic = 1/2 * dot(x)^2;";
    let nested = MAX_NESTING as usize + 1;
    let many = MAX_WRITTEN_OUT + 1;
    // Force, acceleration and related expressions contain each of these terms.
    let terms = MANY_OPERATIONS / 8;
    let each = |count: usize, statement: &str| format!("{coordinate} for i in 0..{count} {{ {statement} }}");
    let jacobian = |count: usize| {
        format!(
            "coord x[{count}]; kinetic = sum(i in 0..{count}, dot(x[i])^2); emit {{ jacobian, no mass_matrix }}"
        )
    };
    let squares = (1..10)
        .fold("const a0 = 3^2000;".to_owned(), |text, i| format!("{text} const a{i} = a{} * a0;", i - 1));
    let calls = (1..20).fold(format!("{coordinate} let f0(x) = x + x;"), |text, i| {
        format!("{text} let f{i}(x) = f{}(x) + f{}(x);", i - 1, i - 1)
    });
    let table = |points: &str| {
        format!("table f(x) = {points}, interpolation: linear, outside: clamp; {coordinate} force x = f(x);")
    };
    let nested_parts = (0..MAX_PARTS_NESTED).map(|i| format!("part P{} {{ p: P{i} {{}} }}", i + 1));
    let nested_parts = nested_parts.collect::<String>();
    let conditions = |i: usize| {
        format!("part P{} {{ {} p: P{i} {{}} {} }}", i + 1, "if 1 > 0 {".repeat(40), "}".repeat(40))
    };
    let nested_conditions = (0..8).map(conditions).collect::<String>();
    let solved = format!("solve y: 0 = y - x, iterations: {};", MAX_ITERATIONS + 1);
    let names = (0..=MAX_COUPLED).map(|i| format!("y{i}")).collect::<Vec<_>>();
    let equations = names.iter().map(|name| format!("0 = {name} - x")).collect::<Vec<_>>().join(", ");
    let coupled = format!("solve ({}): {equations};", names.join(", "));
    let condition = ["(x > 0 || x < 1)"; 7].join(" && ");
    vec![
        excess!(MAX_NESTING, format!("let y = {}1{};", "(".repeat(nested), ")".repeat(nested))),
        excess!(MAX_INDICES, format!("param k{};", "[1]".repeat(MAX_INDICES + 1))),
        excess!(MAX_LITERAL_LENGTH, format!("param k = {};", "1".repeat(MAX_LITERAL_LENGTH + 1))),
        excess!(MAX_DECIMAL_EXPONENT, format!("param k = 1e{};", MAX_DECIMAL_EXPONENT + 1)),
        excess!(MAX_NUMBER_BITS, format!("{squares} {coordinate}")),
        excess!(MAX_UNIT_EXPONENT, format!("param k: m^{};", MAX_UNIT_EXPONENT + 1)),
        excess!(MAX_WRITTEN_OUT, each(many as usize, "potential = x;")),
        excess!(MAX_WRITTEN_OUT, format!("{coordinate} potential = sum(i in 0..{many}, x);")),
        excess!(
            MAX_PARTS_NESTED,
            format!("{coordinate} part P0 {{ param k; }} {nested_parts} p: P{MAX_PARTS_NESTED} {{}}")
        ),
        excess!(
            MAX_EXPANDED_NESTING,
            format!("{coordinate} part P0 {{ param k; }} {nested_conditions} p: P8 {{}}")
        ),
        excess!(MAX_PLACED, format!("{coordinate} part P {{ }} p[i in 0..{}]: P {{}}", MAX_PLACED + 1)),
        excess!(MAX_ELEMENTS, format!("param k[{}]; {coordinate}", MAX_ELEMENTS + 1)),
        excess!(MAX_INLINED, calls + "potential = f19(x);"),
        excess!(MAX_POINTS, table(&format!("[{}]", points(MAX_POINTS + 1)))),
        excess!(
            MAX_TABLE_ARGUMENTS,
            format!("table f(a, b, c, d) = [(0, 0, 0, 0, 1), (1, 1, 1, 1, 2)], interpolation: linear, outside: clamp; {coordinate}")
        ),
        excess!(MAX_FILE_BYTES, table("\"big.csv\"")),
        excess!(MAX_PART_BYTES, format!("include \"big.lag\"; {coordinate}")),
        excess!(MAX_ITERATIONS, format!("{coordinate} {solved} potential = y;")),
        excess!(MAX_BRANCHES, format!("{coordinate} force x = if {condition} {{ 1 }} else {{ 2 }};")),
        excess!(MAX_COUPLED, format!("{coordinate} {coupled} potential = y0;")),
        excess!(MAX_NOISES, format!("{coordinate} noise w[{}], density: 1; force x = w[0];", MAX_NOISES + 1)),
        excess!(MAX_EVENTS, each(MAX_EVENTS + 1, "event e[i] = x - i, rising => stop;")),
        excess!(MAX_CONTACTS, each(MAX_CONTACTS + 1, "event e[i] = x - i, falling => impact(0);")),
        excess!(
            MAX_CONTACT_PAIRS,
            "coord x[129]; kinetic = 1/2 * sum(i in 0..129, dot(x[i])^2); for i in 0..128 { event e[i] = x[i], falling => impact(0); }"
                .to_owned()
        ),
        excess!(MAX_VELOCITIES, format!("coord x[{}];", MAX_VELOCITIES + 1)),
        excess!(MAX_STATES, format!("{coordinate} state z[{}];", MAX_STATES + 1)),
        excess!(MAX_CONSTRAINTS, each(MAX_CONSTRAINTS + 1, "constraint c[i] = x - i;")),
        excess!(
            MAX_DEPENDENT_CONSTRAINTS,
            each(MAX_DEPENDENT_CONSTRAINTS + 2, "constraint c[i] = sin((i + 1) * x);")
        ),
        excess!(MAX_OUTPUTS, each(MAX_OUTPUTS + 1, "output o[i] = x - i;")),
        excess!(MAX_OPERATIONS, jacobian(MAX_OPERATIONS.isqrt() / 2 + 1)),
        excess!(MANY_OPERATIONS, format!("{coordinate} force x = sum(i in 1..{terms}, sin(i * x));")),
        excess!(MAX_LOCATED, format!("{coordinate} force x = sum(i in 0..{}, abs(x - i));", MAX_LOCATED + 1)),
    ]
}

/// Returns the report of a declaration, including warnings if it is accepted. Its files exceed
/// every limit.
fn said(text: &str) -> Report {
    let big = |path: &str| {
        if path.ends_with(".lag") {
            let text = " ".repeat(MAX_PART_BYTES as usize + 1);
            return Ok(FileText { path: String::new(), text });
        }
        let text = decoded(vec![b'0'; MAX_FILE_BYTES as usize + 1])?;
        Ok(FileText { path: String::new(), text })
    };
    let reported = match text.contains(".csv") || text.contains(".lag") {
        true => parse_with(text, &big).err().unwrap_or_default(),
        false => report(text),
    };
    match reported.diagnostics().is_empty() {
        true => warnings(text),
        false => reported,
    }
}

fn warnings(text: &str) -> Report {
    let mut report = Report::default();
    let tokens = format!("struct System; {text}").parse().expect("tokens");
    for line in expand(tokens, &quote::quote!(::lagrange)).to_string().split("note = \"").skip(1) {
        let end = line.find("\"]").or_else(|| line.find('"')).unwrap_or(line.len());
        report.error(proc_macro2::Span::call_site(), line[..end].to_owned());
    }
    report
}

#[test]
fn limits_are_those_of_the_table() {
    let (rows, excesses) = (rows(), excesses());
    assert_eq!(rows.len(), excesses.len());
    for (row, (_, limit, text)) in rows.iter().zip(&excesses) {
        assert_eq!(row.limit, *limit, "{}", row.message);
        let report = said(text).to_string();
        let is_said = row.message.split('…').all(|part| report.contains(part));
        let start = text.chars().take(100).collect::<String>();
        assert!(is_said, "{}\n{start}\n{}", row.message, report.chars().take(500).collect::<String>());
    }
}

/// A new limit in the sources must be added here, and hence to the table.
#[test]
fn every_limit_has_a_row() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let limits = fs::read_to_string(root.join("crates/lagrange-expr/src/limits.rs")).expect("the limits");
    let declared = limits.lines().filter_map(|line| line.strip_prefix("pub const ")?.split(':').next());
    let excesses = excesses();
    let missing =
        declared.filter(|name| excesses.iter().all(|(known, ..)| known != name)).collect::<Vec<_>>();
    assert!(missing.is_empty(), "no row shows {missing:?}");
}

/// Returns declarations that are far too large in one respect.
fn giants() -> Vec<String> {
    let deep = |open: &str, inner: &str, close: &str| {
        format!("coord x; kinetic = {}{inner}{};", open.repeat(5_000), close.repeat(5_000))
    };
    let mut giants = ["coord", "param", "input", "state", "quaternion", "const"]
        .map(|keyword| format!("{keyword} x[999999999999] = 1;"))
        .to_vec();
    giants.extend([
        "coord x[65536];".to_owned(),
        "quaternion x[60000];".to_owned(),
        "coord x[10000][10000][10000];".to_owned(),
        format!("param k{};", "[1]".repeat(5_000)),
        format!("param k = {}1{};", "[".repeat(5_000), "]".repeat(5_000)),
        format!("coord x; kinetic = k{};", "[1]".repeat(5_000)),
        format!("coord x; kinetic = x{};", "[x".repeat(5_000) + &"]".repeat(5_000)),
        "coord x; for i in 0..999999999999 { kinetic = dot(x)^2; }".to_owned(),
        "coord x; for i in 0..1000 { for j in 0..1000 { for k in 0..1000 { kinetic = dot(x)^2; } } }"
            .to_owned(),
        "coord x; for i in 0..99999 { for j in 0..99999 { } }".to_owned(),
        "coord x; kinetic = sum(i in 0..999999999999, dot(x)^2);".to_owned(),
        "coord x; kinetic = sum(i in 0..1000, sum(j in 0..1000, sum(k in 0..1000, dot(x)^2)));".to_owned(),
        "coord x; kinetic = sum(i in -9223372036854775807..9223372036854775807, x);".to_owned(),
        "coord x; kinetic = dot(x)^2 * 2^999999999;".to_owned(),
        "coord x; kinetic = dot(x)^2 * 9^9^9^9^9;".to_owned(),
        "coord x; kinetic = dot(x)^2; param k[2^2^2^2^2];".to_owned(),
        format!("coord x; {}", (0..5_000).map(|i| format!("force x = u{i};")).collect::<String>()),
        format!("coord x; kinetic = {} * dot(x)^2;", "9".repeat(5_001)),
        deep("(", "x", ")"),
        deep("sin(", "x", ")"),
        deep("if x < 1 { x } else {", "x", "}"),
        deep("if sum(i in 0..2, if i == 0 {", "x", "} else { x }) < 0 { x } else { x }"),
        deep("sum(i in 0..1, ", "x", ")"),
        deep("abs(-", "x", ")"),
        format!("coord x; {}kinetic = dot(x)^2;{}", "for i in 0..1 {".repeat(5_000), "}".repeat(5_000)),
        format!("coord x; {}kinetic = dot(x)^2;{}", "if 1 > 0 {".repeat(5_000), "}".repeat(5_000)),
        format!("coord x; if {}1 > 0{} {{ kinetic = dot(x)^2; }}", "(".repeat(5_000), ")".repeat(5_000)),
        format!("body a {{ {} mass: 1; {} }}", "compound {".repeat(5_000), "}".repeat(5_000)),
        format!("coord x: {}m{};", "(".repeat(5_000), ")".repeat(5_000)),
        format!("coord x; kinetic = 1 [{}m{}] * x;", "(".repeat(5_000), ")".repeat(5_000)),
        "solve y: 0 = y, iterations: 999999999999; coord x; kinetic = dot(x)^2;".to_owned(),
        "coord x; kinetic = dot(x)^2; reduce A { freeze x[999999999999] = 0; }".to_owned(),
        "coord x; kinetic = dot(x)^2; emit { jacobian[999999999999] }".to_owned(),
    ]);
    giants
}

/// Limits are checked before work, so that nobody waits for an answer.
#[test]
fn giants_are_answered_quickly() {
    let mut slow = Vec::new();
    for text in giants() {
        let start = of_this_thread();
        let report = report(&text);
        let time = of_this_thread() - start;
        proc_macro2::extra::invalidate_current_thread_spans();
        let beginning = text.chars().take(80).collect::<String>();
        assert!(report.has_errors(), "{beginning}");
        if time > MAX_TIME {
            slow.push(format!("{time:?}: {beginning}"));
        }
    }
    assert!(slow.is_empty(), "{slow:#?}");
}

/// With skew frames, terms of the equations match the rules of presentation in dozens of ways.
#[test]
fn equations_of_skew_frames_are_written_quickly() {
    let text = "coord x, a;
        body cart {
            mass: 2; inertia: (1, 2, 2.5); centroid: (0.2, 0, 0);
            center: (x, 0.1 * t^2, sin(x)); angles: (a, x, t); sequence: zxz;
        }
        body rod { mass: 1; inertia: (0.1, 0.1, 0.01); centroid: (0.2, 0, 0.5); }
        revolute b = cart to rod { at: (0, 0, 1); axis: (1, 2, 0); }
        emit { latex }";
    let start = of_this_thread();
    let report = report(text);
    let time = of_this_thread() - start;
    assert!(!report.has_errors(), "{report}");
    assert!(time < MAX_TIME_OF_PRESENTATION, "{time:?}");
}
