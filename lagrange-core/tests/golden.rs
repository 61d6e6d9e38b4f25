//! Output of every stage for the declarations in `golden`, as text under review.
//!
//! A test is a directory with a `declaration.lag`. `UPDATE_GOLDEN=1` writes the other files. Six
//! systems, one for each kind of output, keep their whole code. The others keep a line of counts
//! for each method.

#[path = "common/methods.rs"]
mod methods;

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use lagrange_core::derive::{Strategy, StrategyChoice};
use lagrange_core::formula::text;
use lagrange_core::pipeline::{Derived, parse};
use lagrange_core::program::{Labels, OperationCounts, listing, lower, optimise};
use quote::quote;

/// Systems whose emitted code is kept whole: a plain one, constraints with bodies in space,
/// friction, kernels, lanes and prepared parameters.
const WHOLE: [&str; 6] =
    ["double_pendulum", "friction_patch", "hung_arm", "kernel_pendulum", "lanes_winch", "prepared_pendulum"];

#[test]
fn every_stage_matches_its_reviewed_output() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    let mut systems = fs::read_dir(&root).expect("a directory").map(|entry| entry.expect("an entry").path());
    let mut systems = systems.by_ref().collect::<Vec<PathBuf>>();
    systems.sort();
    let stages = systems.iter().flat_map(|directory| stages(directory));
    let changed = stages.filter(|(path, found)| differs(path, found)).map(|(path, found)| {
        if std::env::var_os("UPDATE_GOLDEN").is_some() {
            fs::write(&path, &found).expect("a file that can be written");
        }
        let first = first_difference(&fs::read_to_string(&path).unwrap_or_default(), &found);
        format!("{}: {first}", path.strip_prefix(&root).unwrap_or(&path).display())
    });
    let changed = changed.collect::<Vec<_>>();
    let updated = std::env::var_os("UPDATE_GOLDEN").is_some();
    assert!(updated || changed.is_empty(), "UPDATE_GOLDEN=1 accepts:\n{}", changed.join("\n"));
}

/// Returns the files of one system with their expected contents.
fn stages(directory: &Path) -> [(PathBuf, String); 3] {
    let declaration = fs::read_to_string(directory.join("declaration.lag")).expect("a declaration");
    let system = parse(&declaration).unwrap_or_else(|report| panic!("{}: {report:?}", directory.display()));
    let derived = system.derive(StrategyChoice::Cheapest).expect("a regular mass matrix");
    [
        (directory.join("equations.txt"), equations(&derived)),
        (directory.join("program.txt"), program(&derived)),
        emitted(directory, derived),
    ]
}

fn equations(derived: &Derived) -> String {
    let (model, equations) = (&derived.model, &derived.equations);
    let graph = &model.graph;
    let mut out = String::new();
    let rows = equations.mass_matrix.iter().zip(&equations.forcing);
    for (i, (row, forcing)) in rows.enumerate() {
        for (j, entry) in row.iter().enumerate().skip(i) {
            writeln!(out, "M[{i}][{j}] = {}", text::text(graph, *entry)).expect("a string");
        }
        writeln!(out, "f[{i}] = {}", text::text(graph, *forcing)).expect("a string");
    }
    for (noise, column) in model.noises.iter().zip(&equations.diffusion.columns) {
        let column = column.iter().map(|entry| text::text(graph, *entry)).collect::<Vec<_>>();
        writeln!(out, "{}: {:?} ({})", noise.name, equations.diffusion.kind, column.join(", "))
            .expect("a string");
    }
    let structure = &equations.structure;
    writeln!(out, "\n{:?}", structure.mass).expect("a string");
    writeln!(out, "cyclic: {:?}", structure.cyclic).expect("a string");
    writeln!(out, "conserved: {:?}", structure.conserved).expect("a string");
    let costs =
        Strategy::ALL.iter().zip(equations.costs).map(|(strategy, cost)| format!("{strategy:?} {cost:?}"));
    let costs = costs.collect::<Vec<_>>().join(", ");
    writeln!(out, "strategy: {:?} ({costs})", equations.strategy).expect("a string");
    out
}

/// Returns the program of the accelerations.
fn program(derived: &Derived) -> String {
    let mut labels = Labels::default();
    derived.equations.labels.iter().for_each(|(id, name)| labels.insert(*id, name.as_str()));
    let graph = &derived.model.graph;
    let program = optimise(&lower(graph, &derived.equations.accelerations, &labels), derived.model.accuracy);
    format!("{}# {}\n", listing(&program, graph.symbols()), OperationCounts::of(&program))
}

/// Returns the emitted code, or the counts of its methods, with the file that holds it.
fn emitted(directory: &Path, derived: Derived) -> (PathBuf, String) {
    let items = derived.emit(&quote!(::lagrange)).expect("constants that fit");
    let file = syn::parse2(items).expect("items");
    let is_whole = directory.file_name().is_some_and(|name| WHOLE.iter().any(|whole| name == *whole));
    if is_whole {
        (directory.join("code.rs"), prettyplease::unparse(&file))
    } else {
        (directory.join("methods.txt"), methods::summary(&file))
    }
}

fn differs(path: &Path, found: &str) -> bool {
    fs::read_to_string(path).ok().as_deref() != Some(found)
}

fn first_difference(known: &str, found: &str) -> String {
    let lines = known.lines().map(Some).chain(std::iter::repeat(None));
    let first = found.lines().zip(lines).enumerate().find(|(_, (found, known))| Some(*found) != *known);
    first.map_or("shorter than it was".to_owned(), |(number, (found, known))| {
        format!("line {}:\n  - {}\n  + {found}", number + 1, known.unwrap_or_default())
    })
}

/// Returns the declarations of all golden systems with their names.
fn declarations() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    let systems = fs::read_dir(&root).expect("a directory").map(|entry| entry.expect("an entry").path());
    let read = |path: PathBuf| {
        let text = fs::read_to_string(path.join("declaration.lag")).expect("a declaration");
        (path.display().to_string(), text)
    };
    systems.map(read).collect()
}

#[test]
fn comments_and_layout_leave_the_fingerprint_as_it_is() {
    let fingerprint = |text: &str| parse(text).expect("a correct declaration").fingerprint();
    let spread = |line: &str| match line.trim_start().starts_with("//") {
        true => format!("{line}, or so"),
        false => line.replace(", ", " , /* and */\n\n ").replace(';', "; // so far\n"),
    };
    for (name, text) in declarations() {
        let spread = text.lines().map(spread).collect::<Vec<_>>().join("\n");
        assert_eq!(fingerprint(&spread), fingerprint(&text), "{name}");
    }
}

/// The test changes one of this many places in a declaration.
const ONE_IN: usize = if cfg!(large) { 1 } else { 29 };

/// A number or a sign is changed by itself wherever that is possible.
#[test]
fn another_meaning_has_another_fingerprint() {
    let mut changed = 0;
    for (name, text) in declarations() {
        let system = parse(&text).expect("a correct declaration");
        let head = text.find("struct").expect("a head");
        let can_change = |(place, sign): &(usize, char)| *place > head && "0123456789+-*/".contains(*sign);
        for (place, sign) in text.char_indices().filter(can_change).step_by(ONE_IN) {
            let others: &[&str] = match sign {
                '0'..='9' => &["7", "4"],
                '+' => &["-"],
                '-' => &["+"],
                '*' => &["/"],
                _ => &["*"],
            };
            for other in others {
                let text = [&text[..place], other, &text[place + 1..]].concat();
                let Ok(another) = parse(&text) else { continue };
                let is_same = another.statements() == system.statements();
                assert_eq!(another.fingerprint() == system.fingerprint(), is_same, "{name}: {text}");
                changed += usize::from(!is_same);
            }
        }
    }
    assert!(changed > 500 / ONE_IN, "{changed}");
}
