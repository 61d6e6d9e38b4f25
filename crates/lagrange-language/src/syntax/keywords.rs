//! The words of the language, and the subset that cannot be used as names.

use super::ast::{Keyword, Soft, bodies, mobilizers, statements};
use lagrange_expr::elementary;

/// Tables of words that begin a statement.
const TABLES: [&[Keyword]; 3] = [&statements::KEYWORDS, &bodies::KEYWORDS, &mobilizers::KEYWORDS];

/// Number of words that begin a statement.
const COUNT: usize = TABLES[0].len() + TABLES[1].len() + TABLES[2].len();

/// Words that begin a statement.
pub(super) const STATEMENTS: [&str; COUNT] = words_from((0, 0), 0, [""; COUNT]);

/// Fills in the keywords, starting from a row of a table.
const fn words_from(
    (table, row): (usize, usize),
    index: usize,
    mut words: [&'static str; COUNT],
) -> [&'static str; COUNT] {
    if index == COUNT {
        return words;
    }
    if row == TABLES[table].len() {
        return words_from((table + 1, 0), index, words);
    }
    words[index] = TABLES[table][row].word;
    words_from((table, row + 1), index + 1, words)
}

/// Words that can follow a name within a statement.
const CONNECTIVES: &[&str] = &["at", "on", "to", "as", "in", "along", "inside"];

/// Functions of the language that are not elementary functions, with their number of arguments.
pub const STRUCTURAL_FUNCTIONS: [(&str, usize); 12] = [
    ("dot", 1),
    ("ddot", 1),
    ("partial", 2),
    ("norm", 1),
    ("inner", 2),
    ("cross", 2),
    ("transpose", 1),
    ("kinetic_energy", 2),
    ("gravitational_energy", 3),
    ("spring_energy", 2),
    ("powi", 2),
    ("powf", 2),
];

/// Functions of the language whose names declarations may reuse.
pub const NAMEABLE_FUNCTIONS: [(&str, usize); 1] = [("delay", 2)];

/// Returns the statement that a word begins, even if only before certain tokens.
pub(super) fn statement(word: &str) -> Option<&'static Keyword> {
    TABLES.iter().copied().flatten().find(|keyword| keyword.word == word)
}

/// True if a word begins a statement in all contexts.
pub(super) fn begins_statement(word: &str) -> bool {
    statement(word).is_some_and(|keyword| keyword.soft.is_none())
}

/// True if a word begins a statement that accepts accelerations.
pub(super) fn accepts_accelerations(word: &str) -> bool {
    matches!(word, "event" | "gibbs" | "let" | "output")
}

/// Returns the tokens that must follow a word that begins a statement, if there is a restriction.
pub(super) fn soft_statement(word: &str) -> Option<Soft> {
    statement(word)?.soft
}

/// True if a word can follow a name within a statement.
pub(super) fn is_connective(word: &str) -> bool {
    CONNECTIVES.contains(&word)
}

/// True if a name is that of a function of the language.
pub fn is_function(name: &str) -> bool {
    elementary::by_name(name).is_some() || STRUCTURAL_FUNCTIONS.iter().any(|(known, _)| *known == name)
}

/// Returns the built-in meaning of a name: time or the number π.
pub(super) fn built_in(name: &str) -> Option<&'static str> {
    match name {
        "t" => Some("time"),
        "pi" => Some("the number 3.14159…"),
        _ => None,
    }
}
