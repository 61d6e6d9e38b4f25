//! `cargo xtask check`: all checks required for a change to this workspace, in one command that
//! needs only Rust. `cargo xtask sweeps`: the longest tests, for releases and changes to methods or
//! contacts, and the recipes of `ARCHITECTURE.md`, which need Python. `cargo xtask performance`:
//! measures the speed of emitted code and rewrites the tables of docs/performance.md.
//! `cargo xtask performance spatial` only does so for bodies in space, and `… text` for
//! declarations in text. `cargo xtask size [REVISION]`: counts lines of library code by crate.
//! `cargo xtask package`: packages every crate and compiles it from its package.
//! `cargo xtask name NAME`: gives the package of the library another name on the registry.
//! `cargo xtask interface [REVISION]`: lists the public interface, or compares it with a revision.
//! `cargo xtask wrap`: wraps comments and pages at 100 columns. `cargo xtask sentences`: lists
//! sentences of more than 25 words.
#![forbid(unsafe_code)]

mod interface;
mod name;
mod package;
#[cfg(feature = "performance")]
mod performance;
// The rule is a house rule, tested in `tests/house`.
#[path = "../../tests/house/prose.rs"]
mod prose;
mod size;
mod step;
mod wrap;

#[cfg(feature = "performance")]
use performance::performance;
use std::env;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;
use step::Step;

fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new("."));
    let arguments = env::args().skip(1).collect::<Vec<_>>();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["check"] => run(root, checks()),
        ["sweeps"] => run(root, sweeps()),
        ["performance", ref sections @ ..] => code(performance(root, sections)),
        ["package", ref options @ ..] => code(package(root, options)),
        ["interface"] => code(interface::interface(root, None)),
        ["interface", revision] => code(interface::interface(root, Some(revision))),
        ["name", new] => code(name::name(root, new)),
        ["size"] => code(size::size(root, None)),
        ["size", revision] => code(size::size(root, Some(revision))),
        ["wrap"] => code(wrap::wrap(root)),
        ["sentences"] => code(wrap::sentences(root)),
        _ => {
            eprintln!(
                "usage: cargo xtask check | sweeps | performance [chains | spatial | text] | package | interface [REVISION] | name NAME | size [REVISION] | wrap | sentences"
            );
            ExitCode::from(2)
        }
    }
}

/// Measures with a separate build; otherwise all checks would wait for the derivation to compile.
#[cfg(not(feature = "performance"))]
fn performance(root: &Path, sections: &[&str]) -> Result<(), String> {
    let command = "run --quiet --package xtask --features performance --target-dir target/performance";
    let step = Step::new("performance", &format!("{command} -- performance {}", sections.join(" ")));
    if step.run(root) { Ok(()) } else { Err("nothing is measured".to_owned()) }
}

/// Packages every crate, compiles each from its package, and checks the files of the packages.
/// Options are passed to cargo.
fn package(root: &Path, options: &[&str]) -> Result<(), String> {
    package::forget(root);
    let command =
        format!("publish --workspace --dry-run --target-dir {} {}", package::FOLDER, options.join(" "));
    if Step::new("packages", &command).run(root) {
        package::check(root)
    } else {
        Err("not every crate is packaged".to_owned())
    }
}

fn code(result: Result<(), String>) -> ExitCode {
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

/// Runs all steps even if one fails, so that a single run reports every failure.
fn run(root: &Path, steps: Vec<Step>) -> ExitCode {
    let start = Instant::now();
    let mut all_passed = true;
    let mut results = Vec::new();
    for step in steps {
        let begin = Instant::now();
        let passed = step.run(root);
        all_passed &= passed;
        let mark = if passed { "" } else { " FAILED" };
        results.push(format!("{:>6} s  {}{mark}", begin.elapsed().as_secs(), step.title));
    }
    let verdict = if all_passed { "all checks passed" } else { "some checks failed" };
    println!("\n{verdict} in {} s:\n{}", start.elapsed().as_secs(), results.join("\n"));
    if all_passed { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// The algebra takes longer to optimise than a single small declaration gains.
const UNOPTIMISED: &str = "--config profile.dev.package.lagrange-algebra.opt-level=0 \
     --config profile.dev.package.lagrange-expr.opt-level=0";

fn checks() -> Vec<Step> {
    let mut steps = vec![
        Step::new("formatting", "fmt --all --check"),
        // All targets: lints also cover benchmarks. The dependencies of adapters take longest to
        // compile, and are covered below.
        Step::new(
            "lints",
            "clippy --workspace --exclude lagrange-adapters-tests --all-targets --all-features -- -D warnings",
        ),
        // The random cases are the same in every run; plain `cargo verify` draws new ones. The
        // tests include every example, which asserts its own reference values.
        Step::new("tests and doctests", "verify --no-fail-fast").with("PROPTEST_RNG_SEED", "20"),
        // The macro is listed so that its features match the previous step, which compiled it.
        Step::new(
            "messages about missing features",
            "test --package lagrange-tests --package lagrange-macro --test ui missing_features",
        ),
        // One example is included so that the dependencies of examples give the same features as
        // the lints.
        Step::new(
            "documentation",
            "doc --workspace --no-deps --all-features \
             --lib --bin lagrange --bin xtask --example first_steps",
        )
        .with("RUSTDOCFLAGS", "-D warnings"),
        Step::new("no_std", &format!("build --no-default-features {UNOPTIMISED}")),
        Step::new("a user without std", &format!("build --package no_std {UNOPTIMISED}")),
    ];
    if fuses_products() {
        // A separate target folder keeps the other build intact.
        let command = "test --package lagrange-math --target-dir target/fused";
        let step = Step::new("sine and cosine with fused products", command);
        steps.push(step.with("RUSTFLAGS", "-C target-feature=+fma"));
    }
    steps
}

/// Returns steps that take fifteen minutes on two cores, mostly to compile optimised code.
fn sweeps() -> Vec<Step> {
    vec![
        Step::new("long motions", "motions --no-fail-fast"),
        // Compiled with the settings of `cargo verify`.
        Step::new("random texts, laws and trees", "verify --test mutants --test laws --test spatial")
            .with("PROPTEST_CASES", "1024")
            .with("LAGRANGE_MUTANTS", "20000"),
        Step::new(
            "adapters",
            "test --package lagrange-adapters-tests --package lagrange-macro \
             --test diffsol --example differential_equations",
        ),
        Step::new("adapters' lints", "clippy --package lagrange-adapters-tests --all-targets -- -D warnings"),
        Step::script("recipes for additions", "tools/recipes.py"),
    ]
}

/// True if this processor supports the target feature `fma`.
fn fuses_products() -> bool {
    #[cfg(target_arch = "x86_64")]
    let fuses = std::is_x86_feature_detected!("fma");
    #[cfg(not(target_arch = "x86_64"))]
    let fuses = false;
    fuses
}
