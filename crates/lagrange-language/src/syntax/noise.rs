//! White noise.

use super::ast::Definition;
use super::cursor::Cursor;
use super::messages;
use super::messages::forms::form;
use super::parser::{Declared, Parsed, Parser};
use super::units::at_unit;

impl Parser<'_> {
    /// Reads `w: unit, density: e`.
    pub(super) fn noise(&mut self, cursor: &mut Cursor) -> Parsed<Definition> {
        let mut name = self.declared_name(cursor)?;
        self.declared_names.insert(name.text.clone(), Declared::Other);
        if cursor.at(':') && at_unit(cursor) {
            name.unit = self.unit_behind_colon(cursor);
        }
        let is_labelled = cursor.eat(',').is_some() && cursor.eat_word("density").is_some();
        if !is_labelled || cursor.eat(':').is_none() {
            let message = messages::noise_without_density(&name.text);
            return Err(self.fail_with_help(name.span, message, form("noise")));
        }
        let is_array = !name.indices.is_empty();
        Ok(Definition { value: Some(self.default(is_array, cursor)), ..Definition::of(name) })
    }
}
