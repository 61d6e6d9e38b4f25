//! Accepted mutants as modules of a crate that the compiler checks.

use std::env;
use std::fmt::Write;

use crate::project::project;

/// Compiles the given number of cases, evenly spread, with all warnings denied.
pub(crate) fn without_warnings(cases: &[usize], text: impl Fn(usize) -> String) {
    let Ok(wanted) = env::var("LAGRANGE_MUTANTS_COMPILED") else { return };
    let wanted: usize = wanted.parse().expect("LAGRANGE_MUTANTS_COMPILED is a number");
    let chosen = cases.iter().step_by((cases.len() / wanted.max(1)).max(1)).take(wanted);
    // Dead code is not the subject of this test.
    let mut code = "#![deny(warnings)]\n#![allow(dead_code)]\n".to_owned();
    for &case in chosen {
        let declaration = text(case);
        writeln!(code, "pub mod mutant_{case} {{\n    lagrange::system! {{ {declaration} }}\n}}")
            .expect("a string");
    }
    let status = project("mutants", &code).args(["check", "--offline"]).status();
    assert!(status.expect("cargo runs").success());
}
