//! Words that begin statements.

/// A word that begins a statement.
#[derive(Clone, Copy, Debug)]
pub struct Keyword {
    /// The word.
    pub word: &'static str,
    /// Form of the statement, as advice; the first text between backquotes is an example.
    pub form: &'static str,
    /// Condition on the following tokens if the word is otherwise a free name.
    pub soft: Option<Soft>,
}

/// The tokens that must follow a word that begins a statement only before certain tokens.
#[derive(Clone, Copy, Debug)]
pub enum Soft {
    /// A name and `=`.
    Definition,
    /// A name or its rate, and `=`.
    Assignment,
    /// Braces, with or without a name before them.
    Braces,
    /// A name.
    Joint,
    /// A name and a semicolon.
    Alone,
    /// A name and a colon.
    Equation,
    /// A name and what may follow it in a list.
    List,
    /// A name and parentheses.
    Function,
    /// A name or names in parentheses, and `=`.
    Coordinates,
    /// A name and `in`.
    Loop,
    /// A name, with or without parentheses, and braces.
    Part,
    /// A colon and a way of computing contacts.
    Way,
    /// Text in quotation marks.
    Path,
}

impl Keyword {
    /// Creates a word that begins a statement in all contexts.
    pub(super) const fn new(word: &'static str, form: &'static str) -> Keyword {
        Keyword { word, form, soft: None }
    }

    /// Restricts a word to begin a statement only before these tokens.
    pub(super) const fn before(self, soft: Soft) -> Keyword {
        Keyword { soft: Some(soft), ..self }
    }
}
