//! Sines and cosines that are computed together.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote_spanned;

use super::fragment::Fragment;
use super::parts::LetStatement;
use super::writer::{BodyWriter, Written};
use crate::program::ValueId;

/// Writes `let (sin_x, cos_x) = sin_cos(x);`.
pub(super) fn pair(writer: &mut BodyWriter<'_>, id: ValueId, argument: ValueId) -> Written {
    let name = writer.names.name_of_angle(argument);
    let angle = writer.take(argument);
    let pair = writer.call("sin_cos", vec![angle]).tokens;
    let [sine, cosine] = name_parts(writer, id, 0, name.as_deref());
    let tokens = quote_spanned!(Span::mixed_site()=> let (#sine, #cosine) = #pair;);
    define_pairs(writer, id, tokens, vec![[sine, cosine]])
}

/// Writes `let [(sin_x, cos_x), (sin_y, cos_y)] = sin_cos_each([x, y]);`.
pub(super) fn batch(writer: &mut BodyWriter<'_>, id: ValueId, arguments: &[ValueId]) -> Written {
    let op = writer.program.op(id);
    let names = arguments.iter().map(|argument| writer.names.name_of_angle(*argument)).collect::<Vec<_>>();
    let angles = writer.operands(op);
    let together = writer.call("sin_cos_each", vec![Fragment::array(angles)]).tokens;
    let places = names.iter().enumerate();
    let pairs = places.map(|(place, name)| name_parts(writer, id, place as u32, name.as_deref()));
    let pairs = pairs.collect::<Vec<_>>();
    let patterns = pairs.iter().map(|[sine, cosine]| quote_spanned!(Span::mixed_site()=> (#sine, #cosine)));
    let tokens = quote_spanned!(Span::mixed_site()=> let [#(#patterns),*] = #together;);
    define_pairs(writer, id, tokens, pairs)
}

/// Adds the statement that defines the variables of a pair or a batch.
fn define_pairs(
    writer: &mut BodyWriter<'_>,
    id: ValueId,
    tokens: TokenStream,
    pairs: Vec<[Ident; 2]>,
) -> Written {
    let parts = |place: usize| writer.sines_and_cosines.get(&(id, place as u32)).copied().unwrap_or_default();
    let named = pairs.iter().enumerate().flat_map(|(place, names)| parts(place).into_iter().zip(names));
    let variables = named.filter_map(|(part, name)| Some((part?, name.clone()))).collect();
    writer.statements.push(LetStatement { tokens, variables });
    Written::Pairs(pairs)
}

/// Returns variables for the sine and the cosine at a place in a batch.
fn name_parts(writer: &mut BodyWriter<'_>, id: ValueId, place: u32, argument: Option<&str>) -> [Ident; 2] {
    let parts = writer.sines_and_cosines.get(&(id, place)).copied().unwrap_or_default();
    let [sine, cosine] = [("sin", parts[0]), ("cos", parts[1])];
    [sine, cosine].map(|(function, part)| writer.names.name_part(function, part, argument))
}

pub(super) fn part(writer: &mut BodyWriter<'_>, pairs: ValueId, place: u32, part: usize) -> Written {
    match &writer.written[pairs] {
        Written::Pairs(names) => Written::Variable(names[place as usize][part].clone()),
        _ => unreachable!("{pairs:?} is a pair"),
    }
}
