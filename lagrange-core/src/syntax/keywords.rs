//! The words of the language, and which of them a declaration cannot use as names of its own.

use crate::functions;

/// Words that begin a statement.
pub(super) const STATEMENTS: &[&str] = &[
    "param",
    "const",
    "coord",
    "input",
    "let",
    "kinetic",
    "potential",
    "lagrangian",
    "gibbs",
    "dissipation",
    "force",
    "torque",
    "constraint",
    "stabilise",
    "event",
    "friction",
    "output",
    "emit",
    "reduce",
    "gravity",
    "body",
    "line",
    "spring",
    "damper",
    "torsion_spring",
    "torsion_damper",
    "pin",
    "slide",
    "roll",
];

/// Words that begin a statement only before certain tokens, and are free as names elsewhere.
const SOFT_STATEMENTS: &[(&str, Soft)] = &[
    ("friction", Soft::Definition),
    ("line", Soft::Braces),
    ("spring", Soft::Braces),
    ("damper", Soft::Braces),
    ("torsion_spring", Soft::Braces),
    ("torsion_damper", Soft::Braces),
    ("pin", Soft::Joint),
    ("slide", Soft::Joint),
    ("roll", Soft::Joint),
];

/// What follows a word that begins a statement only before certain tokens.
#[derive(Clone, Copy)]
pub(super) enum Soft {
    /// A name and `=`.
    Definition,
    /// Braces, with or without a name before them.
    Braces,
    /// A name.
    Joint,
}

/// Words that can follow a name within a statement.
const CONNECTIVES: &[&str] = &["at", "on", "to", "as"];

/// Functions of the language that are no elementary functions, with their number of arguments.
pub const STRUCTURAL_FUNCTIONS: [(&str, usize); 10] = [
    ("dot", 1),
    ("ddot", 1),
    ("norm", 1),
    ("inner", 2),
    ("cross", 2),
    ("kinetic_energy", 2),
    ("gravitational_energy", 3),
    ("spring_energy", 2),
    ("powi", 2),
    ("powf", 2),
];

/// Keywords of Rust, those reserved for later included: none can be a field of the emitted struct.
const RUST: &[&str] = &[
    "Self", "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate", "do",
    "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop",
    "macro", "match", "mod", "move", "mut", "override", "priv", "pub", "ref", "return", "self", "static",
    "struct", "super", "trait", "true", "try", "type", "typeof", "unsafe", "unsized", "use", "virtual",
    "where", "while", "yield",
];

/// Whether a word begins a statement wherever it stands.
pub(super) fn begins_statement(word: &str) -> bool {
    STATEMENTS.contains(&word) && soft_statement(word).is_none()
}

/// Before what a word begins a statement, if it does not everywhere.
pub(super) fn soft_statement(word: &str) -> Option<Soft> {
    SOFT_STATEMENTS.iter().find(|(soft, _)| *soft == word).map(|(_, form)| *form)
}

/// Whether a word can follow a name within a statement.
pub(super) fn is_connective(word: &str) -> bool {
    CONNECTIVES.contains(&word)
}

/// Whether a word is a keyword of Rust.
pub fn is_rust_keyword(word: &str) -> bool {
    RUST.contains(&word)
}

/// Whether a name is that of a function of the language.
pub(super) fn is_function(name: &str) -> bool {
    functions::by_name(name).is_some() || STRUCTURAL_FUNCTIONS.iter().any(|(known, _)| *known == name)
}

/// What a name stands for in every system, if it does: time and the number π.
pub(super) fn built_in(name: &str) -> Option<&'static str> {
    match name {
        "t" => Some("time"),
        "pi" => Some("the number 3.14159…"),
        _ => None,
    }
}
