use super::{read, statements};
use crate::syntax::ast::{Declaration, StatementKind, TableSource};
use crate::syntax::print;

/// A statement about a function without a formula.
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
            let source = match &table.source {
                TableSource::File { path, .. } => path.text.clone(),
                TableSource::Points(points) => {
                    let component = |id| print::expression(&declaration.expressions, id);
                    let point =
                        |point: &[_]| point.iter().map(|id| component(*id)).collect::<Vec<_>>().join(" ");
                    points.iter().map(|(components, _)| point(components)).collect::<Vec<_>>().join("; ")
                }
            };
            let (interpolation, outside) = (table.interpolation.name(), table.outside.name());
            format!(
                "table {} {} [{source}] {interpolation} {outside}",
                table.name.text,
                table.parameters.len()
            )
        }
        _ => String::new(),
    }
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
        "output function (* table 2)",
    ];
    assert_eq!(statements(&declaration), expected);
    let printed = print::statements(&declaration);
    assert_eq!(statements(&read(&printed)), expected, "{printed}");
}
