//! Names with indices, loops and choices between statements as text.

use super::Printer;
use super::expressions::dots;
use crate::syntax::ast::{Enclosure, Name, Range, Repetition, Selection, Statement};

impl Printer<'_> {
    /// Prints a name with its square brackets, its members and its unit.
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

    /// Prints the unit of a name.
    pub(super) fn unit(&mut self, name: &Name) {
        if let Some(unit) = &name.unit {
            self.text(&format!(": {unit}"));
        }
    }

    /// Prints lines, each in its enclosures. A common enclosure of consecutive lines is printed
    /// once.
    pub(super) fn enclosed_lines<'l, T>(
        &mut self,
        lines: impl IntoIterator<Item = (&'l [Enclosure], T)>,
        mut print: impl FnMut(&mut Self, T),
    ) {
        let mut open: &[Enclosure] = &[];
        for (around, line) in lines {
            let shared = open.iter().zip(around).take_while(|(a, b)| a.is_same(b)).count();
            self.close(&open[shared..]);
            around[shared..].iter().for_each(|enclosure| self.open(enclosure));
            print(self, line);
            open = around;
        }
        self.close(open);
    }

    fn open(&mut self, enclosure: &Enclosure) {
        match enclosure {
            Enclosure::Local(statement, _) => {
                self.text(" ");
                return self.statement(&statement.kind);
            }
            Enclosure::Loop(variable, range) => self.head(variable, range, " for "),
            Enclosure::Condition(condition) => {
                self.text(" if ");
                self.index_condition(condition);
            }
        }
        self.text(" {");
    }

    fn close(&mut self, enclosures: &[Enclosure]) {
        let has_braces = |enclosure: &&Enclosure| !matches!(enclosure, Enclosure::Local(..));
        enclosures.iter().filter(has_braces).for_each(|_| self.text(" }"));
    }

    /// Prints `for i in 0..n`.
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
