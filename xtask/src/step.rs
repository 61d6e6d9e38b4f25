//! Commands of cargo with titles.

use std::env;
use std::path::Path;
use std::process::Command;

/// One check: its title, and its `cargo` command.
pub(crate) struct Step {
    pub(crate) title: String,
    arguments: Vec<String>,
    environment: Vec<(&'static str, String)>,
}

impl Step {
    pub(crate) fn new(title: &str, command: &str) -> Step {
        let arguments = command.split_whitespace().map(str::to_owned).collect();
        Step { title: title.to_owned(), arguments, environment: Vec::new() }
    }

    pub(crate) fn with(mut self, variable: &'static str, value: impl Into<String>) -> Step {
        self.environment.push((variable, value.into()));
        self
    }

    pub(crate) fn run(&self, root: &Path) -> bool {
        println!("\n== {}: cargo {}", self.title, self.arguments.join(" "));
        let cargo = env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let mut command = Command::new(cargo);
        command
            .args(&self.arguments)
            .current_dir(root)
            .envs(self.environment.iter().map(|(name, value)| (name, value)));
        match command.status() {
            Ok(status) => status.success(),
            Err(error) => {
                eprintln!("cargo cannot be started: {error}");
                false
            }
        }
    }
}
