//! Statements that declare joints.

use super::ast::{AstId, Joint, JointKind, Name};
use super::blocks::BlockLabels;
use super::cursor::Cursor;
use super::messages;
use super::messages::forms::form;
use super::parser::{Parsed, Parser, Reported};

impl Parser<'_> {
    /// Reads `name = p to q`, with or without the name.
    pub(super) fn pin(&mut self, cursor: &mut Cursor) -> Parsed<Joint> {
        let name = self.joint_name(cursor)?;
        let first = self.expression(cursor)?;
        self.joining("to", form("pin"), cursor)?;
        Ok(Joint { name, kind: JointKind::Pin { first, second: self.value(cursor) } })
    }

    /// Reads `name = p on line`, with or without the name.
    pub(super) fn slide(&mut self, cursor: &mut Cursor) -> Parsed<Joint> {
        let name = self.joint_name(cursor)?;
        let point = self.expression(cursor)?;
        self.joining("on", form("slide"), cursor)?;
        let line = self.mentioned(form("slide"), cursor)?;
        if !cursor.at_statement_end() {
            return Err(self.misplaced("`;`", form("slide"), cursor));
        }
        Ok(Joint { name, kind: JointKind::Slide { point, line } })
    }

    /// Reads `name = body on line, radius: e`, with or without the name and the radius.
    pub(super) fn roll(&mut self, cursor: &mut Cursor) -> Parsed<Joint> {
        let name = self.joint_name(cursor)?;
        let body = self.mentioned(form("roll"), cursor)?;
        self.joining("on", form("roll"), cursor)?;
        let line = self.mentioned(form("roll"), cursor)?;
        let radius = self.radius(cursor)?;
        Ok(Joint { name, kind: JointKind::Roll { body, line, radius } })
    }

    /// Reads `, radius: e`, if present.
    fn radius(&mut self, cursor: &mut Cursor) -> Parsed<Option<AstId>> {
        if cursor.at_statement_end() {
            return Ok(None);
        }
        if cursor.eat(',').is_none() {
            return Err(self.misplaced("`,` or `;`", form("roll"), cursor));
        }
        if cursor.ident().is_none() {
            return Err(self.misplaced("`radius`", form("roll"), cursor));
        }
        let label = self.label_of(&mut BlockLabels::new("rolling", &["radius"]), cursor)?;
        self.colon(label, cursor)?;
        Ok(Some(self.value(cursor)))
    }

    /// Consumes the word between the joined objects.
    pub(super) fn joining(&mut self, word: &str, help: &str, cursor: &mut Cursor) -> Parsed<()> {
        match cursor.eat_word(word) {
            Some(_) => Ok(()),
            None => Err(self.misplaced(&format!("`{word}`"), help, cursor)),
        }
    }

    fn joint_name(&mut self, cursor: &mut Cursor) -> Parsed<Option<Name>> {
        if !cursor.equals_past(1) || cursor.ident().is_none() {
            return Ok(None);
        }
        let name = self.declared_name(cursor)?;
        cursor.eat_equals();
        Ok(Some(name))
    }

    /// Reads the name of a declared object, which may be a member of a part.
    pub(super) fn mentioned(&mut self, help: &str, cursor: &mut Cursor) -> Parsed<Name> {
        match cursor.ident() {
            Some(_) if !cursor.at_statement() => {
                let name = self.name(cursor)?;
                let name = self.indexed(name, cursor)?;
                self.with_members(name, cursor)
            }
            _ => Err(self.misplaced("a name", help, cursor)),
        }
    }

    pub(super) fn misplaced(&mut self, wanted: &str, help: &str, cursor: &Cursor) -> Reported {
        self.fail_with_help(cursor.here(), messages::expected(wanted, cursor.peek()), help)
    }
}
