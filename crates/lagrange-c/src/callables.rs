//! Functions without a formula: tables, and solutions of equations.

use lagrange_core::code::{Surroundings, Target, Unrepresentable, statements};
use lagrange_core::limits::MAX_TABLE_ARGUMENTS;
use lagrange_core::opaque::{Opaque, Table};
use lagrange_core::pipeline::Programs;
use lagrange_core::program::{NewtonProgram, Op, Program};
use lagrange_core::symbol::Role;

use crate::functions::Function;
use crate::names::number;
use crate::syntax::{constants, head, in_language, list};

/// The functions without a formula that a module calls.
pub(crate) struct Callables<'a> {
    /// Distinct tables and their derivatives.
    tables: Vec<&'a Opaque>,
    solutions: &'a [NewtonProgram],
    /// The language of the module.
    pub(crate) target: Target,
}

impl<'a> Callables<'a> {
    pub(crate) fn new(programs: &'a Programs, functions: &[Function<'a>], target: Target) -> Callables<'a> {
        let solutions = &programs.solutions[..];
        let of_solutions = solutions.iter().flat_map(|solution| [&solution.start, &solution.equation]);
        let of_functions = functions.iter().flat_map(|function| &function.parts).map(|part| part.program);
        let mut tables: Vec<&Opaque> = Vec::new();
        for (_, op) in of_functions.chain(of_solutions).flat_map(Program::values) {
            if let Op::Opaque(function, _) = op
                && function.table().is_some()
                && !tables.contains(&function)
            {
                tables.push(function);
            }
        }
        Callables { tables, solutions, target }
    }

    /// Returns a call of a function for these arguments.
    pub(crate) fn call(&self, function: &Opaque, arguments: &[&str]) -> String {
        match self.tables.iter().position(|known| *known == function) {
            Some(index) => format!("table_{index}({})", arguments.join(", ")),
            None => {
                let index = self.solutions.iter().position(|solution| solution.functions.contains(function));
                let index = index.unwrap_or_else(|| unreachable!("refused before: {function:?}"));
                let (arguments, results) = match function.unknowns().len() {
                    1 => (arguments, None),
                    _ => (&arguments[..arguments.len() - 1], arguments.last()),
                };
                let known = if arguments.is_empty() { "0".to_owned() } else { arguments.join(", ") };
                let results = results.map_or_else(String::new, |results| format!(", {results}"));
                format!("solution_{index}({}{results})", list(self.target, &known))
            }
        }
    }

    /// Returns the definitions of all these functions.
    pub(crate) fn definitions(&self) -> Result<String, Unrepresentable> {
        let target = self.target;
        let mut out = String::new();
        let mut include = |is_needed: bool, texts: [&str; 2]| {
            if is_needed {
                out += &format!("\n{}", in_language(target, texts));
            }
        };
        let counts = || self.solutions.iter().map(|solution| solution.values.len());
        include(!self.tables.is_empty(), [include_str!("tables.h"), include_str!("tables.js")]);
        include(counts().any(|count| count == 1), [include_str!("newton.h"), include_str!("newton.js")]);
        include(counts().any(|count| count > 1), [include_str!("coupled.h"), include_str!("coupled.js")]);
        for (index, function) in self.tables.iter().enumerate() {
            let first =
                self.tables.iter().position(|table| table.function().name == function.function().name);
            out += &definition(target, index, first.unwrap_or(index), function);
        }
        for (index, solution) in self.solutions.iter().enumerate() {
            out +=
                &in_language(target, [format!("\n{};", signature(target, index, solution)), String::new()]);
        }
        for (index, solution) in self.solutions.iter().enumerate() {
            out += &self.solution(index, solution)?;
        }
        Ok(out)
    }

    fn solution(&self, index: usize, solution: &NewtonProgram) -> Result<String, Unrepresentable> {
        let equation = Equation { solution, callables: self };
        let target = self.target;
        let [start, residual] = [&solution.start, &solution.equation]
            .map(|program| statements(program, target, &equation, "out"));
        let (start, residual, iterations) = (start?, residual?, solution.iterations);
        let count = solution.values.len();
        let (what, unknown, declared, found) = match count {
            1 => (
                "residual",
                "double y",
                target.array("out", 1),
                format!("return newton(out[0], {iterations}, equation_{index}, x);"),
            ),
            _ => (
                "residuals",
                "const double *y",
                String::new(),
                format!("coupled({count}, {iterations}, equation_{index}, x, out);"),
            ),
        };
        let names =
            solution.functions.iter().map(|function| function.function().name.escape_default().to_string());
        let parameters = format!("{unknown}, const double *x, double *out");
        let [unused, unused_known] =
            in_language(target, [["    (void)y, (void)x;\n", "    (void)x;\n"], ["", ""]]);
        Ok(format!(
            "\n// The {what} of {}, slopes and rounding errors.\n\
             {}\n\
             {{\n{unused}{residual}}}\n\
             \n{}\n\
             {{\n    {declared}\n{unused_known}{start}\
             \x20   {found}\n}}\n",
            names.collect::<Vec<_>>().join(", "),
            head(target, "LAGRANGE_FUNCTION void", &format!("equation_{index}"), &parameters),
            signature(target, index, solution)
        ))
    }
}

/// Returns the head of the function that solves equations. A single value is returned; several
/// values are stored.
fn signature(target: Target, index: usize, solution: &NewtonProgram) -> String {
    let (result, parameters) = match solution.values.len() {
        1 => ("double", "const double *x"),
        _ => ("void", "const double *x, double *out"),
    };
    head(target, &format!("LAGRANGE_FUNCTION {result}"), &format!("solution_{index}"), parameters)
}

/// Returns the definition of a table or of one of its derivatives; derivatives use the numbers of
/// the table with the index `first`.
fn definition(target: Target, index: usize, first: usize, function: &Opaque) -> String {
    let Some(table) = function.table() else { return String::new() };
    let size = table.interpolation.coefficients();
    let mut out = format!("\n// {}\n", function.describe().replace('`', "").escape_default());
    if first == index {
        for (argument, axis) in table.axes.iter().enumerate() {
            out += &constants(target, &format!("knots_{index}_{argument}"), &axis.knots);
        }
        out += &constants(target, &format!("coefficients_{index}"), &table.coefficients);
    }
    let parameters = ARGUMENTS[..table.axes.len()].iter().map(|argument| format!("double {argument}"));
    let parameters = parameters.collect::<Vec<_>>().join(", ");
    let [axes, values] = lookup(target, first, function, table);
    let count = table.axes.len();
    let head = head(target, "LAGRANGE_FUNCTION double", &format!("table_{index}"), &parameters);
    let call = in_language(
        target,
        [
            format!("lookup({count}, {axes}, {values}, coefficients_{first}, {size})"),
            format!("lookup({axes}, {values}, coefficients_{first}, {size})"),
        ],
    );
    out + &format!("{head}\n{{\n    return {call};\n}}\n")
}

/// Names of the arguments of tables.
const ARGUMENTS: [&str; MAX_TABLE_ARGUMENTS] = ["x", "y", "z"];

/// Returns the lists of the axes and of the arguments of a table.
fn lookup(target: Target, first: usize, function: &Opaque, table: &Table) -> [String; 2] {
    let axes = table.axes.iter().zip(function.orders()).enumerate().map(|(argument, (axis, order))| {
        let (density, knots) = (number(axis.density), format!("knots_{first}_{argument}"));
        let count = axis.knots.len();
        in_language(
            target,
            [
                format!("{{ {knots}, {count}, {density}, {order} }}"),
                format!("{{ knots: {knots}, density: {density}, order: {order} }}"),
            ],
        )
    });
    let axes = axes.collect::<Vec<_>>().join(", ");
    let values = ARGUMENTS[..table.axes.len()].join(", ");
    [
        in_language(target, [format!("(const Axis[]){{ {axes} }}"), format!("[{axes}]")]),
        in_language(target, [format!("(const double[]){{ {values} }}"), format!("[{values}]")]),
    ]
}

/// The arguments of the equation of an algebraic unknown.
struct Equation<'a> {
    solution: &'a NewtonProgram,
    callables: &'a Callables<'a>,
}

impl Surroundings for Equation<'_> {
    fn place(&self, role: Role) -> String {
        let place = |roles: &[Role]| roles.iter().position(|known| *known == role);
        match (place(&self.solution.arguments), place(&self.solution.values)) {
            (Some(index), _) => format!("x[{index}]"),
            (None, Some(index)) if self.solution.values.len() > 1 => format!("y[{index}]"),
            (None, _) => "y".to_owned(),
        }
    }

    fn name(&self, role: Role) -> Option<String> {
        let place = self.solution.values.iter().position(|value| *value == role)?;
        Some(self.solution.functions[place].function().name.clone())
    }

    fn call(&self, function: &Opaque, arguments: &[&str]) -> String {
        self.callables.call(function, arguments)
    }
}
