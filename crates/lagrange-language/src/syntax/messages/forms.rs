//! Written forms of each statement.

use crate::syntax::keywords::statement;

/// Returns the form of the statement that begins with a keyword.
pub(in crate::syntax) fn form(keyword: &str) -> &'static str {
    statement(keyword)
        .map_or("statements are listed in the documentation of `lagrange::system!`", |keyword| keyword.form)
}

/// Returns advice for foreign words: the intended statement.
pub(in crate::syntax) fn meant_form(keyword: &str) -> String {
    format!("use `{keyword}`: {}", form(keyword))
}
