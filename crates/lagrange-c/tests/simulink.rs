//! The S-function of `examples/simulink`, run by a stand-in for Simulink and compared with a closed
//! form.
#![cfg(unix)]

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use lagrange_c::Module;
use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::{Programs, parse};

const CART: &str = "struct Cart; param m = 2, k = 8; input push = 0; coord x = k / 16;
    kinetic = 1/2 * m * dot(x)^2; potential = 1/2 * k * x^2; force x = push;
    output pull = push - k * x; event middle = x - push, rising => record;";

/// Compiles the block of a module with a compiler, without a warning.
fn compile(folder: &Path, compiler: &str) -> std::path::PathBuf {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    let program = folder.join(compiler);
    let mut command = Command::new(compiler);
    command.args(["-std=c99", "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-DMODEL_HEADER=\"cart.h\""]);
    command.args(["-DMODEL(function)=cart_##function", "-DSIZE(what)=CART_##what", "-I"]);
    command.arg(here.join("tests/simulink")).arg("-I").arg(folder).arg("-o").arg(&program);
    command.arg(here.join("../../examples/simulink/sfunction.c")).arg(folder.join("cart.c")).arg("-lm");
    let output = command.output().expect("a C compiler, which linking needs, too");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    program
}

fn run(program: &Path, parameters: &[&str]) -> (Output, Vec<f64>) {
    let output = Command::new(program).args(parameters).output().expect("a program");
    let printed = String::from_utf8_lossy(&output.stdout).into_owned();
    (output, printed.split_whitespace().filter_map(|word| word.parse().ok()).collect())
}

/// x = u/k + (x₀ − u/k) cos(√(k/m) t) under the constant input u = 3, from x₀ = k/16.
#[test]
fn blocks_move_in_closed_form() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("simulink");
    fs::create_dir_all(&folder).expect("a folder");
    let derived = parse(CART).and_then(|system| system.derive(StrategyChoice::Cheapest));
    let programs = Programs::new(&derived.unwrap_or_else(|report| panic!("{report}")));
    let module = Module::new(&programs, Some("cart")).expect("a module");
    for (name, text) in [("cart.h", &module.header), ("cart.c", &module.source)] {
        fs::write(folder.join(name), text).expect("written");
    }
    let has_clang = Command::new("clang").arg("--version").output().is_ok();
    for compiler in ["cc"].into_iter().chain(has_clang.then_some("clang")) {
        let program = compile(&folder, compiler);
        for (parameters, m, k) in [(&[][..], 2.0, 8.0), (&["1", "4"], 1.0, 4.0)] {
            let (_, numbers) = run(&program, parameters);
            let (rate, rest) = (f64::sqrt(k / m), 3.0 / k);
            let (sin, cos) = (2.0 * rate).sin_cos();
            let x = rest + (k / 16.0 - rest) * cos;
            let expected = [2.0, 1.0, 1.0, 1.0, x, (rest - k / 16.0) * rate * sin, 3.0 - k * x, x - 3.0];
            assert_eq!(numbers.len(), expected.len());
            for (found, expected) in numbers.iter().zip(expected) {
                assert!((found - expected).abs() < 1e-9, "{numbers:?}, not {expected}");
            }
        }
        for wrong in [&["1"][..], &["1", "nan"], &["1", "2", "3"]] {
            let (output, _) = run(&program, wrong);
            let message = String::from_utf8_lossy(&output.stdout).into_owned();
            assert!(output.status.code() == Some(1) && message.contains("parameter"), "{wrong:?}: {message}");
        }
    }
}
