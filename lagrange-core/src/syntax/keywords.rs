//! The words of the language, and which of them a declaration cannot use as names of its own.

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
];

/// Words that begin a statement only before a name and `=`, and are free as names elsewhere.
const SOFT_STATEMENTS: &[&str] = &["friction"];

/// Words set aside for statements that do not exist yet.
pub(super) const FUTURE_STATEMENTS: &[&str] = &["body", "gravity"];

/// Functions of the language, also those that are only written behind a dot.
const FUNCTIONS: &[&str] = &[
    "sin",
    "cos",
    "tan",
    "asin",
    "acos",
    "atan",
    "atan2",
    "sinh",
    "cosh",
    "tanh",
    "exp",
    "ln",
    "sqrt",
    "abs",
    "sign",
    "min",
    "max",
    "pow",
    "powi",
    "powf",
    "hypot",
    "dot",
    "ddot",
    "norm",
    "inner",
    "cross",
    "kinetic_energy",
    "gravitational_energy",
    "spring_energy",
];

/// Keywords of Rust, those reserved for later included: none can be a field of the emitted struct.
const RUST: &[&str] = &[
    "Self", "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate", "do",
    "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop",
    "macro", "match", "mod", "move", "mut", "override", "priv", "pub", "ref", "return", "self", "static",
    "struct", "super", "trait", "true", "try", "type", "typeof", "unsafe", "unsized", "use", "virtual",
    "where", "while", "yield",
];

/// Whether a word begins a statement wherever it stands, now or in future.
pub(super) fn begins_statement(word: &str) -> bool {
    let is_known = STATEMENTS.contains(&word) || FUTURE_STATEMENTS.contains(&word);
    is_known && !begins_named_statement(word)
}

/// Whether a word begins a statement before a name and `=`, but not elsewhere.
pub(super) fn begins_named_statement(word: &str) -> bool {
    SOFT_STATEMENTS.contains(&word)
}

/// Whether a word is a keyword of Rust.
pub fn is_rust_keyword(word: &str) -> bool {
    RUST.contains(&word)
}

/// Whether a name is that of a function of the language.
pub(super) fn is_function(name: &str) -> bool {
    FUNCTIONS.contains(&name)
}

/// What a name stands for in every system, if it does: time and the number π.
pub(super) fn built_in(name: &str) -> Option<&'static str> {
    match name {
        "t" => Some("time"),
        "pi" => Some("the number 3.14159…"),
        _ => None,
    }
}
