//! Sines and cosines that are computed together.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote_spanned;

use super::fragment::Fragment;
use super::parts::LetStatement;
use super::writer::{BodyWriter, Written};
use crate::program::ValueId;

impl BodyWriter<'_> {
    /// `let (sin_x, cos_x) = sin_cos(x);`
    pub(super) fn pair(&mut self, id: ValueId, argument: ValueId) -> Written {
        let name = self.name_of_angle(argument);
        let angle = self.take(argument);
        let pair = self.call("sin_cos", vec![angle]).tokens;
        let [sine, cosine] = self.name_parts(id, 0, name.as_deref());
        let tokens = quote_spanned!(Span::mixed_site()=> let (#sine, #cosine) = #pair;);
        self.define_pairs(id, tokens, vec![[sine, cosine]])
    }

    /// `let [(sin_x, cos_x), (sin_y, cos_y)] = sin_cos_each([x, y]);`
    pub(super) fn batch(&mut self, id: ValueId, arguments: &[ValueId]) -> Written {
        let op = self.program.op(id);
        let names = arguments.iter().map(|argument| self.name_of_angle(*argument)).collect::<Vec<_>>();
        let angles = self.operands(op);
        let together = self.call("sin_cos_each", vec![Fragment::array(angles)]).tokens;
        let places = names.iter().enumerate();
        let pairs = places.map(|(place, name)| self.name_parts(id, place as u32, name.as_deref()));
        let pairs = pairs.collect::<Vec<_>>();
        let patterns =
            pairs.iter().map(|[sine, cosine]| quote_spanned!(Span::mixed_site()=> (#sine, #cosine)));
        let tokens = quote_spanned!(Span::mixed_site()=> let [#(#patterns),*] = #together;);
        self.define_pairs(id, tokens, pairs)
    }

    /// Adds the statement that defines the variables of a pair or a batch.
    fn define_pairs(&mut self, id: ValueId, tokens: TokenStream, pairs: Vec<[Ident; 2]>) -> Written {
        let parts =
            |place: usize| self.sines_and_cosines.get(&(id, place as u32)).copied().unwrap_or_default();
        let named = pairs.iter().enumerate().flat_map(|(place, names)| parts(place).into_iter().zip(names));
        let variables = named.filter_map(|(part, name)| Some((part?, name.clone()))).collect();
        self.statements.push(LetStatement { tokens, variables });
        Written::Pairs(pairs)
    }

    /// Variables for the sine and the cosine at a place in a batch.
    fn name_parts(&mut self, id: ValueId, place: u32, argument: Option<&str>) -> [Ident; 2] {
        let parts = self.sines_and_cosines.get(&(id, place)).copied().unwrap_or_default();
        let [sine, cosine] = [("sin", parts[0]), ("cos", parts[1])];
        [sine, cosine].map(|(function, part)| self.name_part(function, part, argument))
    }

    pub(super) fn part(&mut self, pairs: ValueId, place: u32, part: usize) -> Written {
        match &self.written[pairs] {
            Written::Pairs(names) => Written::Variable(names[place as usize][part].clone()),
            _ => unreachable!("{pairs:?} is a pair"),
        }
    }
}
