//! Files of declarations with expected results. Besides comments with `#`, their lines are:
//!
//! ```text
//! system WORDS         a system follows
//! > STATEMENTS         its declaration
//! state T              one of its states at the time T follows; its numbers stand in lines that begin with a word:
//! q X …                positions, unit quaternions among them
//! v X …                velocities, of which a quaternion has three
//! wanted X …           accelerations that a force must produce, which inverse dynamics has to find
//! condition X          condition number of the matrix by which the accelerations are found
//! WORD X …             a result, such as `accelerations` or `output NAME`
//! ```

use std::fs;
use std::path::Path;

/// A declaration with states.
#[derive(Debug, Default)]
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) text: String,
    pub(crate) states: Vec<State>,
}

/// Numbers at a state, each under its word.
#[derive(Debug, Default)]
pub(crate) struct State {
    numbers: Vec<(String, Vec<f64>)>,
}

impl State {
    /// Returns the numbers of a word, or none if the line is missing.
    pub(crate) fn numbers(&self, word: &str) -> &[f64] {
        self.numbers.iter().find(|(known, _)| known == word).map_or(&[], |(_, numbers)| numbers)
    }

    /// Returns the numbers of a word for modification.
    pub(crate) fn numbers_mut(&mut self, word: &str) -> &mut Vec<f64> {
        let found = self.numbers.iter_mut().find(|(known, _)| known == word);
        &mut found.expect("a line with this word").1
    }

    /// Returns the only number of a word.
    pub(crate) fn number(&self, word: &str) -> Option<f64> {
        self.numbers(word).first().copied()
    }

    /// Returns names of columns of the regressor with their entries.
    pub(crate) fn columns(&self) -> impl Iterator<Item = (&str, &[f64])> {
        self.numbers
            .iter()
            .filter_map(|(word, numbers)| Some((word.strip_prefix("column ")?, numbers.as_slice())))
    }

    /// Returns names of outputs with their components.
    pub(crate) fn outputs(&self) -> impl Iterator<Item = (&str, &[f64])> {
        self.numbers
            .iter()
            .filter_map(|(word, numbers)| Some((word.strip_prefix("output ")?, numbers.as_slice())))
    }
}

/// Returns the text of a file beside this one.
pub(crate) fn read(path: &str) -> String {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/spatial");
    fs::read_to_string(folder.join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Returns the systems of a file.
pub(crate) fn cases(path: &str) -> Vec<Case> {
    let text = read(path);
    let mut cases: Vec<Case> = Vec::new();
    for line in text.lines().filter(|line| !line.is_empty() && !line.starts_with('#')) {
        let (word, rest) = line.split_once(' ').unwrap_or((line, ""));
        if word == "system" {
            cases.push(Case { name: rest.to_owned(), ..Case::default() });
            continue;
        }
        let case = cases.last_mut().expect("a system");
        if word == ">" {
            case.text.push_str(rest);
            case.text.push('\n');
            continue;
        }
        if word == "state" {
            case.states.push(State::default());
        }
        let state = case.states.last_mut().expect("a state");
        state.numbers.push(numbers_of(line));
    }
    cases
}

/// Splits a line before its first number: everything up to it is the word.
fn numbers_of(line: &str) -> (String, Vec<f64>) {
    let parts = line.split(' ').collect::<Vec<_>>();
    let first = parts.iter().position(|part| part.parse::<f64>().is_ok()).expect("a number");
    let numbers = parts[first..].iter().map(|part| part.parse().expect("a number")).collect();
    (parts[..first].join(" "), numbers)
}
