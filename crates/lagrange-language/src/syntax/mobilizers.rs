//! Statements that declare joints with coordinates.

use proc_macro2::Delimiter;

use super::ast::{AstId, ElementaryMotion, Expression, Mobilizer, MobilizerKind, Name, Quaternion};
use super::blocks::BlockLabels;
use super::cursor::Cursor;
use super::messages;
use super::messages::scenes;
use super::parser::{Parsed, Parser};

impl Parser<'_> {
    /// Reads `q = a to b { at: e; … }`, `(a, b) = c to d;`; of a weld `a to b`.
    pub(super) fn mobilizer(&mut self, kind: MobilizerKind, cursor: &mut Cursor) -> Parsed<Mobilizer> {
        let help = scenes::mobilizer_help(kind);
        if kind == MobilizerKind::Free {
            return self.free_body(&help, cursor);
        }
        let mut names = match kind {
            MobilizerKind::Weld => Vec::new(),
            _ => self.made_coordinates(kind, &help, cursor)?,
        };
        let inboard = self.mentioned(&help, cursor)?;
        self.joining("to", &help, cursor)?;
        let outboard = self.mentioned(&help, cursor)?;
        let mut joint = Mobilizer::between(kind, inboard, outboard);
        match kind.motions() {
            [ElementaryMotion::Orientation] => joint.quaternion = names.pop().map(Quaternion::named),
            _ => joint.coordinates = names,
        }
        match cursor.eat_group(Delimiter::Brace) {
            Some(group) => {
                let labels = BlockLabels::new("a joint", &kind.labels());
                let complete = self.values(&group, labels, &mut joint, value_at);
                if !complete && kind.motions().contains(&ElementaryMotion::Advance) {
                    self.missing(&mut joint.pitch, joint.outboard.span.into());
                }
            }
            None if !cursor.at_statement_end() => return Err(self.misplaced("`{` or `;`", &help, cursor)),
            None => {}
        }
        joint.axis = joint.axis.filter(|axis| self.is_vector(*axis));
        Ok(joint)
    }

    /// Returns false, with a report, if an axis is an undefined letter, as in `axis: z;`.
    fn is_vector(&mut self, axis: AstId) -> bool {
        let Expression::Name(letter) = self.expressions.get(axis) else { return true };
        let direction = scenes::direction_of_axis(letter).filter(|_| self.declared(letter).is_none());
        if let Some(direction) = direction {
            self.fail_with_help(self.expressions.origin(axis), scenes::AXIS_LETTER, direction);
        }
        direction.is_none()
    }

    /// Reads `trunk`: three coordinates and an orientation.
    fn free_body(&mut self, help: &str, cursor: &mut Cursor) -> Parsed<Mobilizer> {
        let body = self.mentioned(help, cursor)?;
        if !cursor.at_statement_end() {
            return Err(self.misplaced("`;`", help, cursor));
        }
        Ok(Mobilizer::free(body))
    }

    /// Reads the coordinates that a joint creates, with the `=` after them.
    fn made_coordinates(
        &mut self,
        kind: MobilizerKind,
        help: &str,
        cursor: &mut Cursor,
    ) -> Parsed<Vec<Name>> {
        let here = cursor.here();
        let names = match cursor.eat_group(Delimiter::Parenthesis) {
            None => vec![self.declared_name(cursor)?],
            Some(group) => self.inside(&group, |parser, cursor| {
                let mut names = Vec::new();
                parser.each(cursor, |parser, cursor| {
                    match parser.declared_name(cursor) {
                        Ok(name) => names.push(name),
                        Err(_) => cursor.skip_to(|cursor| cursor.at(',')),
                    }
                    cursor.eat(',');
                });
                Ok(names)
            })?,
        };
        if names.len() != kind.name_count() {
            let message = scenes::coordinate_count(kind.name(), kind.name_count(), names.len());
            return Err(self.fail_with_help(here, message, help));
        }
        self.equals(help, cursor)?;
        if cursor.at_statement_end() {
            let message = messages::expected("a name", cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, help));
        }
        Ok(names)
    }
}

/// Returns the place for the value of a label.
fn value_at<'a>(joint: &'a mut Mobilizer, label: &'static str) -> &'a mut Option<AstId> {
    match label {
        "at" => &mut joint.at,
        "turned" => &mut joint.turned,
        "axis" => &mut joint.axis,
        "pitch" => &mut joint.pitch,
        _ => &mut joint.damping,
    }
}
