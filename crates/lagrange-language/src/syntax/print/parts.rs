//! Parts and their placements as text.

use super::Printer;
use super::expressions::dots;
use crate::syntax::ast::{PartDefinition, Placement};

impl Printer<'_> {
    pub(super) fn part_definition(&mut self, part: &PartDefinition) {
        self.text(&format!("part {}", part.name.text));
        if !part.arguments.is_empty() {
            self.text("(");
            self.list(&part.arguments, |printer, argument| {
                printer.text(&argument.name.text);
                printer.assigned(argument.default);
            });
            self.text(")");
        }
        self.block(&part.body);
    }

    pub(super) fn placement(&mut self, placement: &Placement) {
        self.indexed(&placement.name);
        if let Some((variable, range)) = &placement.count {
            self.labelled(&format!("[{} in ", variable.text), range.from);
            self.labelled(dots(range), range.to);
            self.text("]");
        }
        self.text(&format!(": {} {{", placement.part.text));
        for (name, value) in &placement.arguments {
            self.labelled(&format!(" {}: ", name.text), *value);
            self.text(";");
        }
        self.text(" }");
    }
}
