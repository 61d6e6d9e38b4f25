//! Keywords of Rust.

/// Keywords of Rust, including reserved ones: none can be a field of the emitted struct.
const RUST: &[&str] = &[
    "Self", "abstract", "as", "async", "await", "become", "box", "break", "const", "continue", "crate", "do",
    "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if", "impl", "in", "let", "loop",
    "macro", "match", "mod", "move", "mut", "override", "priv", "pub", "ref", "return", "self", "static",
    "struct", "super", "trait", "true", "try", "type", "typeof", "unsafe", "unsized", "use", "virtual",
    "where", "while", "yield",
];

/// True if a word is a keyword of Rust.
pub fn is_rust_keyword(word: &str) -> bool {
    RUST.contains(&word)
}
