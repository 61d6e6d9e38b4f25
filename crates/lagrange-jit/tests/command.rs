//! The command with machine code writes what the interpreter computes.

use std::path::Path;
use std::process::{Command, Output};

use lagrange_core::derive::StrategyChoice;
use lagrange_core::pipeline::Programs;
use lagrange_dynamic::DeclaredSystem;
use lagrange_dynamic::{DynamicSystem, MethodChoice, RunSettings, Source, Visitor};

const SWING: &str = "../lagrange-cli/tests/data/swing.lag";

fn lagrange(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_lagrange")).args(arguments).output().expect("the command starts")
}

/// A motion of the interpreter, as CSV.
struct Written(RunSettings);

impl Visitor for Written {
    type Output = Vec<u8>;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Vec<u8> {
        let mut csv = Vec::new();
        self.0.run(system).expect("a motion").write_csv(&mut csv).expect("written");
        csv
    }
}

#[test]
fn motions_have_the_bits_of_the_interpreter() {
    let source = Source::read(Path::new(SWING)).expect("a file");
    let derived =
        source.system().and_then(|system| system.derive(StrategyChoice::Cheapest)).expect("regular");
    let system = DeclaredSystem::new(Programs::new(&derived)).expect("runs");
    let start = system.start().expect("declared");
    for (name, method) in [
        ("verner", MethodChoice::Verner { tolerance: 1e-11 }),
        ("radau", MethodChoice::Radau { tolerance: 1e-11 }),
    ] {
        let settings = RunSettings {
            start: start.clone(),
            from: 0.0,
            until: 2.0,
            every: Some(0.25),
            method,
            has_energy: true,
        };
        let options =
            ["--until", "2", "--every", "0.25", "--energy", "--tolerance", "1e-11", "--method", name];
        let output = lagrange(&[&["simulate", SWING][..], &options].concat());
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        assert_eq!(output.stdout, system.visit(Written(settings)), "{name}");
    }
}

#[test]
fn it_names_its_machine_code_and_keeps_exit_codes() {
    let version = lagrange(&["--version"]);
    assert!(String::from_utf8_lossy(&version.stdout).ends_with(", with machine code\n"));
    let failed = lagrange(&["simulate", SWING, "--until", "1", "--set", "nothing=1"]);
    assert_eq!(failed.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&failed.stderr).contains("there is no `nothing`"));
}
