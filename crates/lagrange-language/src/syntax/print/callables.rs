//! Functions of the user's crate as text.

use super::Printer;
use crate::syntax::ast::{
    AstId, ExternalFunction, Name, TableDefinition, TableGrid, TableSource, UnknownDefinition,
};

impl Printer<'_> {
    /// Prints `function f(x) { derivative: slope; }`.
    pub(super) fn external(&mut self, function: &ExternalFunction) {
        self.text("function ");
        self.signature(&function.name, &function.parameters);
        let Some(derivatives) = &function.derivatives else {
            self.text(";");
            return;
        };
        self.text(" {");
        for derivative in derivatives {
            let by = function.parameters.iter().zip(&derivative.orders);
            let by = by.flat_map(|(name, order)| std::iter::repeat_n(name, usize::from(*order)));
            self.text(" by ");
            self.list(&by.collect::<Vec<_>>(), |printer, name| printer.text(&name.text));
            self.text(": ");
            self.text(&derivative.name.text);
            self.text(";");
        }
        self.text(" }");
    }

    /// Prints `table f(x) = [(a, b), (c, d)], interpolation: natural, outside: extend;`.
    pub(super) fn table(&mut self, table: &TableDefinition) {
        self.text("table ");
        self.signature(&table.name, &table.parameters);
        self.text(" = ");
        match &table.source {
            TableSource::File { path, .. } => self.text(&format!("{:?}", path.text)),
            TableSource::Points(points) => {
                self.text("[");
                self.list(points, |printer, (point, _)| {
                    printer.text("(");
                    printer.list(point, |printer, component| printer.expression(*component));
                    printer.text(")");
                });
                self.text("]");
            }
            TableSource::Grid(grid) => self.grid(grid),
        }
        let (interpolation, outside) = (table.interpolation.name(), table.outside.name());
        self.text(&format!(", interpolation: {interpolation}, outside: {outside};"));
    }

    /// Prints `[[a, b], [c, d]], rows: [x, y], columns: [z, w]`.
    fn grid(&mut self, grid: &TableGrid) {
        self.text("[");
        self.list(&grid.rows, |printer, row| printer.numbers("", row));
        self.text("]");
        let [rows, columns] = &grid.axes;
        self.numbers(", rows: ", rows);
        self.numbers(", columns: ", columns);
    }

    /// Prints a text and `[a, b]`.
    fn numbers(&mut self, label: &str, numbers: &[AstId]) {
        self.text(label);
        self.text("[");
        self.list(numbers, |printer, number| printer.expression(*number));
        self.text("]");
    }

    /// Prints `solve y: 0 = e, start: e, iterations: n;`.
    pub(super) fn unknowns(&mut self, unknowns: &UnknownDefinition) {
        let UnknownDefinition { names, residuals, starts, iterations } = unknowns;
        self.text("solve ");
        self.one_or_tuple(names, Self::name);
        self.text(": ");
        self.list(residuals, |printer, residual| printer.labelled("0 = ", *residual));
        if !starts.is_empty() {
            self.text(", start: ");
            self.one_or_tuple(starts, |printer, start| printer.expression(*start));
        }
        iterations.iter().for_each(|iterations| self.labelled(", iterations: ", *iterations));
        self.text(";");
    }

    /// Prints `y` or `(y, z)`.
    fn one_or_tuple<T>(&mut self, items: &[T], print: impl FnMut(&mut Self, &T)) {
        let brackets = if items.len() > 1 { ["(", ")"] } else { [""; 2] };
        self.text(brackets[0]);
        self.list(items, print);
        self.text(brackets[1]);
    }

    /// Prints `f(x, y)`.
    pub(super) fn signature(&mut self, name: &Name, parameters: &[Name]) {
        self.indexed(name);
        self.text("(");
        self.list(parameters, Self::name);
        self.text(")");
        self.unit(name);
    }
}
