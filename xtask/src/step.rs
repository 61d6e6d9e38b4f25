//! Commands of cargo, and scripts in Python, with titles.

use std::env;
use std::ffi::OsString;
use std::path::Path;
use std::process::Command;

/// One check: its title, and the arguments of its program.
pub(crate) struct Step {
    pub(crate) title: String,
    program: OsString,
    arguments: Vec<String>,
    environment: Vec<(&'static str, String)>,
}

impl Step {
    pub(crate) fn new(title: &str, command: &str) -> Step {
        Step::of(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()), title, command)
    }

    /// Creates a check by a script that needs only the standard library of Python.
    pub(crate) fn script(title: &str, command: &str) -> Step {
        Step::of("python3".into(), title, command)
    }

    fn of(program: OsString, title: &str, command: &str) -> Step {
        let arguments = command.split_whitespace().map(str::to_owned).collect();
        Step { title: title.to_owned(), program, arguments, environment: Vec::new() }
    }

    pub(crate) fn with(mut self, variable: &'static str, value: impl Into<String>) -> Step {
        self.environment.push((variable, value.into()));
        self
    }

    pub(crate) fn run(&self, root: &Path) -> bool {
        let program = Path::new(&self.program).file_name().unwrap_or_default().display();
        println!("\n== {}: {program} {}", self.title, self.arguments.join(" "));
        let mut command = Command::new(&self.program);
        command
            .args(&self.arguments)
            .current_dir(root)
            .envs(self.environment.iter().map(|(name, value)| (name, value)));
        match command.status() {
            Ok(status) => status.success(),
            Err(error) => {
                eprintln!("{program} cannot be started: {error}");
                false
            }
        }
    }
}
