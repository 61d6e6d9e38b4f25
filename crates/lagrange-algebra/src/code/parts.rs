//! Long bodies in parts.
//!
//! For each `let`, the compiler opens a scope that ends with the block, and it traverses nested
//! scopes recursively. Some thousands of statements in one block exceed the stack of rustc 1.95
//! when it writes debug information. Long bodies are therefore written in blocks, each of which
//! returns the values that later ones need:
//!
//! ```text
//! let [a, b] = { let c = …; let a = … c …; let b = … c …; [a, b] };
//! ```
//!
//! A few long parts pass on fewer values than many short ones, and run as fast as one block. With
//! several thousand statements, tuples instead of arrays make the optimiser five times slower.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote_spanned;

use crate::program::{Program, ValueId, ValueTable};

/// Maximum number of statements in one block of a body of moderate length. The compiler overflows
/// its stack between 2500 and 3000.
const LONGEST_BLOCK: usize = 1000;

/// A `let`.
pub(super) struct LetStatement {
    pub(super) tokens: TokenStream,
    /// Variables that the part defines.
    pub(super) variables: Vec<(ValueId, Ident)>,
}

/// Joins the statements, in parts if there are many.
pub(super) fn assemble(program: &Program, statements: &[LetStatement]) -> TokenStream {
    if statements.len() <= LONGEST_BLOCK {
        return statements.iter().map(|statement| statement.tokens.clone()).collect();
    }
    // If the number of parts equals the number of statements in each, neither is nested deeply.
    let length = LONGEST_BLOCK.max(statements.len().isqrt());
    let last_uses = last_uses(program, statements);
    let parts = statements.chunks(length).enumerate();
    parts.map(|(n, part)| block(part, &last_uses, (n + 1) * length)).collect()
}

/// Writes a part as a block that returns the values used in the statement `next` or later.
fn block(part: &[LetStatement], last_uses: &ValueTable<usize>, next: usize) -> TokenStream {
    let variables = part.iter().flat_map(|statement| &statement.variables);
    let kept = variables.filter(|(id, _)| last_uses[*id] >= next).map(|(_, name)| name).collect::<Vec<_>>();
    let statements = part.iter().map(|statement| &statement.tokens);
    quote_spanned!(Span::mixed_site()=> let [#(#kept),*] = { #(#statements)* [#(#kept),*] };)
}

/// Finds the last statement that uses each value; results are used after all statements.
fn last_uses(program: &Program, statements: &[LetStatement]) -> ValueTable<usize> {
    let mut definitions = ValueTable::filled(program.len(), None);
    for (index, statement) in statements.iter().enumerate() {
        statement.variables.iter().for_each(|(id, _)| definitions[*id] = Some(index));
    }
    let mut last_uses = ValueTable::filled(program.len(), 0);
    program.outputs().iter().for_each(|&output| last_uses[output] = usize::MAX);
    for (id, op) in program.values().rev() {
        // A value without a variable is written where it is used.
        let place = definitions[id].unwrap_or(last_uses[id]);
        op.for_each_operand(|operand| last_uses[operand] = last_uses[operand].max(place));
    }
    last_uses
}
