use super::{read, statements};
use crate::syntax::ast::{AstId, Declaration, Name, StatementKind, TableGrid, TableSource};
use crate::syntax::print;

/// Formats a statement about a function without a formula.
pub(super) fn callable(declaration: &Declaration, kind: &StatementKind) -> String {
    match kind {
        StatementKind::External(function) => {
            let derivatives = function.derivatives.iter().flatten();
            let derivatives = derivatives.map(|one| format!(" {:?} {}", one.orders, one.name.text));
            let is_listed = if function.derivatives.is_some() { " listed" } else { "" };
            let arguments = function.parameters.len();
            format!(
                "function {} {arguments}{is_listed}{}",
                function.name.text,
                derivatives.collect::<String>()
            )
        }
        StatementKind::Table(table) => {
            let number = |id: &AstId| print::expression(&declaration.expressions, *id);
            let numbers = |ids: &[AstId]| ids.iter().map(number).collect::<Vec<_>>().join(" ");
            let source = match &table.source {
                TableSource::File { path, .. } => path.text.clone(),
                TableSource::Points(points) => {
                    points.iter().map(|(components, _)| numbers(components)).collect::<Vec<_>>().join("; ")
                }
                TableSource::Grid(TableGrid { axes: [rows, columns], rows: values }) => {
                    let values = values.iter().map(|row| numbers(row)).collect::<Vec<_>>().join("; ");
                    format!("{} x {}: {values}", numbers(rows), numbers(columns))
                }
            };
            let (interpolation, outside) = (table.interpolation.name(), table.outside.name());
            format!(
                "table {} {} [{source}] {interpolation} {outside}",
                table.name.text,
                table.parameters.len()
            )
        }
        StatementKind::Solve(unknowns) => {
            let named = |name: &Name| {
                let unit = name.unit.as_ref().map_or(String::new(), |unit| format!(" {unit}"));
                format!("{}{unit}", name.text)
            };
            let names = unknowns.names.iter().map(named).collect::<Vec<_>>().join(", ");
            let starts = unknowns.starts.iter().copied().map(Some).chain([None]);
            let starts = starts.take(unknowns.starts.len().max(1));
            let said =
                unknowns.residuals.iter().copied().map(Some).chain(starts).chain([unknowns.iterations]);
            let said = said.map(|id| id.map(|id| print::expression(&declaration.expressions, id)));
            format!("solve {names} {:?}", said.collect::<Vec<_>>())
        }
        _ => String::new(),
    }
}

#[test]
fn equations_have_their_form() {
    let text = "
        solve y: 0 = y - x;
        solve f: N: 0 = f + f^3 - k * x, iterations: 2 * n, start: k * x;
        solve r: 1/s^2: 0 = r - a, start: 1;
        solve y[1]: (m/s)^2: 0 = y[1] - a;
        param solve = 1, start = solve * 2;
    ";
    let expected = [
        "solve y [Some(\"y - x\"), None, None]",
        "solve f N [Some(\"f + f^3 - k * x\"), Some(\"k * x\"), Some(\"2 * n\")]",
        "solve r 1/s^2 [Some(\"r - a\"), Some(\"1\"), None]",
        "solve y m^2/s^2 [Some(\"y[1] - a\"), None, None]",
        "param (solve 1) (start (* solve 2))",
    ];
    assert_eq!(statements(&read(text)), expected);
}

#[test]
fn functions_and_tables_have_their_form() {
    let text = "
        function road(x);
        function lift(alpha, speed) { by alpha: slope; by speed, alpha: mixed; }
        function spring(x) { derivative: force; second_derivative: stiffness; third_derivative: jerk }
        function none(x) { };
        table motor(speed) = [(0, 90), (1000, 1e2 + 40),], interpolation: monotone, outside: clamp;
        table map(x, y) = \"map.csv\", outside: error, interpolation: linear;
        table grid(x, y) = [[1, 2, 3], [4, 5, 6],], columns: [0, 1, 2,], outside: error, rows: [3, 4], interpolation: linear;
        output function = table * 2;
    ";
    let declaration = read(&text.replace("jerk }", "jerk; }"));
    let expected = [
        "function road 1",
        "function lift 2 listed [1, 0] slope [1, 1] mixed",
        "function spring 1 listed [1] force [2] stiffness [3] jerk",
        "function none 1 listed",
        "table motor 1 [0 90; 1000 100 + 40] monotone clamp",
        "table map 2 [map.csv] linear error",
        "table grid 2 [3 4 x 0 1 2: 1 2 3; 4 5 6] linear error",
        "output function (* table 2)",
    ];
    assert_eq!(statements(&declaration), expected);
    let printed = print::statements(&declaration);
    assert_eq!(statements(&read(&printed)), expected, "{printed}");
}
