//! Coupled unknowns.

use proc_macro2::{Ident, Span};
use quote::{ToTokens, quote_spanned};

use super::parts::LetStatement;
use super::writer::{BodyWriter, Written};
use crate::program::{Op, ValueId, solution_key};
use lagrange_expr::opaque::Opaque;

/// Writes `let [y, z] = solve_y_z(x);` at the first of the unknowns.
pub(super) fn solved(writer: &mut BodyWriter<'_>, id: ValueId, function: &Opaque) -> Written {
    if let Some(name) = writer.solved.get(&id) {
        return Written::Variable(name.clone());
    }
    let op = writer.program.op(id);
    let key = solution_key(op);
    let mut ids = vec![None; function.unknowns().len()];
    for (other, op) in writer.program.values().filter(|(_, op)| solution_key(op) == key) {
        if let Op::Opaque(function, _) = op {
            ids[function.place()] = Some(other);
        }
    }
    let operands = writer.operands(op);
    let solution = writer.call_opaque(function, operands).tokens;
    let (mut pattern, mut variables) = (Vec::new(), Vec::new());
    for id in ids {
        let name: Option<Ident> = id.map(|id| writer.names.choose(id));
        pattern.push(match &name {
            Some(name) => name.to_token_stream(),
            None => quote_spanned!(Span::mixed_site()=> _),
        });
        variables.extend(id.zip(name));
    }
    for (id, name) in &variables {
        writer.solved.insert(*id, name.clone());
    }
    let tokens = quote_spanned!(Span::mixed_site()=> let [#(#pattern),*] = #solution;);
    writer.statements.push(LetStatement { tokens, variables });
    match writer.solved.get(&id) {
        Some(name) => Written::Variable(name.clone()),
        None => unreachable!("{id:?} is one of them"),
    }
}
