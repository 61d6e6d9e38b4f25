//! Names with indices, loops and choices between statements as text.

use super::Printer;
use super::expressions::dots;
use crate::syntax::ast::{Enclosure, Name, Range, Repetition, Selection, Statement};

impl Printer<'_> {
    /// A name with what stands in square brackets, behind dots and behind a colon.
    pub(super) fn name(&mut self, name: &Name) {
        self.indexed(name);
        for member in &name.members {
            self.text(".");
            self.indexed(member);
        }
        self.unit(name);
    }

    pub(super) fn indexed(&mut self, name: &Name) {
        self.text(&name.text);
        for index in &name.indices {
            self.labelled("[", *index);
            self.text("]");
        }
    }

    /// The unit behind a name.
    pub(super) fn unit(&mut self, name: &Name) {
        if let Some(unit) = &name.unit {
            self.text(&format!(": {unit}"));
        }
    }

    /// Lines in the loops and conditions around them.
    pub(super) fn enclosed(&mut self, around: &[Enclosure], print: impl FnOnce(&mut Self)) {
        for enclosure in around {
            match enclosure {
                Enclosure::Loop(variable, range) => self.head(variable, range, " for "),
                Enclosure::Condition(condition) => {
                    self.text(" if ");
                    self.index_condition(condition);
                }
            }
            self.text(" {");
        }
        print(self);
        around.iter().for_each(|_| self.text(" }"));
    }

    /// `for i in 0..n`
    fn head(&mut self, variable: &Name, range: &Range, word: &str) {
        self.labelled(&format!("{word}{} in ", variable.text), range.from);
        self.labelled(dots(range), range.to);
    }

    pub(super) fn repetition(&mut self, repetition: &Repetition) {
        let Repetition { variable, range, body } = repetition;
        self.head(variable, range, "for ");
        self.block(body);
    }

    pub(super) fn selection(&mut self, selection: &Selection) {
        for (number, (condition, body)) in selection.branches.iter().enumerate() {
            self.text(if number == 0 { "if " } else { " else if " });
            self.index_condition(condition);
            self.block(body);
        }
        if !selection.otherwise.is_empty() {
            self.text(" else");
            self.block(&selection.otherwise);
        }
    }

    pub(super) fn block(&mut self, statements: &[Statement]) {
        self.text(" {");
        for statement in statements {
            self.text(" ");
            self.statement(&statement.kind);
        }
        self.text(" }");
    }
}
