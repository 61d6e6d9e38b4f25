//! Programs as the body of a function in C or JavaScript, for targets that rustc does not support.
//!
//! The C text is valid C99, OpenCL C 1.2 and CUDA C++. Where their names differ, it uses a macro
//! from their common [`prelude`]. Each value is a statement with a numbered variable, since every
//! language has its own reserved words. The name in the declaration is in a comment.

mod target;

use super::body::Unrepresentable;
use super::literal::Constant;
use crate::program::{Op, Program, SolutionKey, ValueId, ValueTable, solution_key};
use lagrange_expr::collections::HashMap;
use lagrange_expr::elementary::row;
use lagrange_expr::expr::Relation;
use lagrange_expr::opaque::Opaque;
use lagrange_expr::symbol::Role;

pub use target::{Precision, Target};

/// The functions that bodies in JavaScript call, in addition to those of `Math`.
pub const SCRIPT_PRELUDE: &str = include_str!("prelude.js");

/// Returns the definition of a C macro for each row of the list of elementary functions.
macro_rules! definitions {
    ($(
        $name:ident($($argument:ident),*) C($libm:ident, $libmf:ident) lanes $lanes:tt $method:tt
    )*) => {
        [$((stringify!($name), [$(stringify!($argument)),*].join(", "), stringify!($libm))),*]
            .map(|(name, arguments, c)| {
                let head = Target::C(Precision::Double).call(name, &arguments);
                format!("#define {head} LAGRANGE_OF({c})({arguments})\n")
            })
            .concat()
    };
}

/// Returns the text before all functions: the number type `REAL` and every function that bodies
/// call, for OpenCL C, CUDA C++ and C.
pub fn prelude(precision: Precision) -> String {
    let (real, is_single) = match precision {
        Precision::Double => ("double", 0),
        Precision::Single => ("float", 1),
    };
    let text =
        include_str!("prelude.h").replace("/* FUNCTIONS */\n", &lagrange_math::functions!(definitions));
    format!("typedef {real} REAL;\n#define LAGRANGE_SINGLE {is_single}\n{text}")
}

/// The names that a body refers to.
pub trait Surroundings {
    /// Returns the expression that the body uses for a symbol.
    fn place(&self, role: Role) -> String;

    /// Returns the name of a symbol in the declaration.
    fn name(&self, role: Role) -> Option<String>;

    /// Returns a call of a function without a formula, for these arguments. For a function that
    /// solves for several unknowns, the last argument is the array of their values.
    fn call(&self, function: &Opaque, arguments: &[&str]) -> String;
}

/// Writes the statements of a function that computes a program, each on a separate line, indented
/// once.
///
/// `surroundings` provides symbols and functions without a formula. The results are stored in the
/// elements of `results`.
///
/// # Errors
/// If a constant of the program is out of the range of the numbers.
pub fn statements(
    program: &Program,
    target: Target,
    surroundings: &dyn Surroundings,
    results: &str,
) -> Result<String, Unrepresentable> {
    let names = ValueNames::new(program);
    let mut writer = StatementWriter { program, target, surroundings, names, out: String::new() };
    let mut unrepresentable = Vec::new();
    for (id, op) in program.values() {
        match op {
            Op::Constant(number) => writer.constant(Constant::Exact(number), &mut unrepresentable),
            Op::Float(value) => writer.constant(Constant::Rounded(*value), &mut unrepresentable),
            Op::Input(role) => {
                writer.define(&surroundings.place(*role), surroundings.name(*role).as_deref());
            }
            _ => writer.value(id, op),
        }
    }
    for (index, output) in program.outputs().iter().enumerate() {
        let value = &writer.names.values[*output];
        writer.out += &format!("    {results}[{index}] = {value};\n");
    }
    match unrepresentable.is_empty() {
        true => Ok(writer.out),
        false => Err(Unrepresentable { constants: unrepresentable }),
    }
}

/// The names of the values of a program.
struct ValueNames {
    /// Variables and literals.
    values: ValueTable<String>,
    /// The sine and the cosine at a place of a pair or a batch.
    pairs: HashMap<(ValueId, u32), [String; 2]>,
    /// The arrays of coupled unknowns.
    solutions: HashMap<SolutionKey, String>,
    next: usize,
}

impl ValueNames {
    fn new(program: &Program) -> ValueNames {
        ValueNames {
            values: ValueTable::with_capacity(program.len()),
            pairs: HashMap::default(),
            solutions: HashMap::default(),
            next: 0,
        }
    }

    fn fresh(&mut self) -> String {
        self.next += 1;
        format!("x{}", self.next - 1)
    }
}

/// A body under construction.
struct StatementWriter<'a> {
    program: &'a Program,
    target: Target,
    surroundings: &'a dyn Surroundings,
    names: ValueNames,
    out: String,
}

impl StatementWriter<'_> {
    /// Writes a constant where it is used.
    fn constant(&mut self, constant: Constant<'_>, unrepresentable: &mut Vec<String>) {
        let text = self.target.constant(constant).unwrap_or_else(|| {
            let words = constant.describe();
            if !unrepresentable.contains(&words) {
                unrepresentable.push(words);
            }
            String::new()
        });
        let is_negative = text.starts_with('-');
        self.names.values.push(if is_negative { format!("({text})") } else { text });
    }

    /// Writes a variable for a value, with its name in the declaration as a comment.
    fn define(&mut self, expression: &str, name: Option<&str>) {
        let variable = self.names.fresh();
        // Some C compilers reject other letters, even in comments.
        let comment = name.map_or_else(String::new, |name| format!(" // {}", name.escape_default()));
        let definition = self.target.define(&variable, expression);
        self.out += &format!("    {definition}{comment}\n");
        self.names.values.push(variable);
    }

    /// Writes a value that is neither a constant nor a symbol.
    fn value(&mut self, id: ValueId, op: &Op) {
        match op {
            Op::SinCos(angle) => self.pairs(id, &[*angle]),
            Op::SinCosEach(angles) => self.pairs(id, angles),
            Op::SinOf(pair) => self.part(*pair, 0, 0),
            Op::CosOf(pair) => self.part(*pair, 0, 1),
            Op::SinIn(batch, place) => self.part(*batch, *place, 0),
            Op::CosIn(batch, place) => self.part(*batch, *place, 1),
            Op::Opaque(function, _) if function.unknowns().len() > 1 => self.solved(id, op, function),
            _ => {
                let expression = self.expression(op);
                self.define(&expression, self.program.hint(id));
            }
        }
    }

    /// Writes coupled unknowns at the first of them.
    fn solved(&mut self, id: ValueId, op: &Op, function: &Opaque) {
        let Some(key) = solution_key(op) else { unreachable!("{op:?} has several unknowns") };
        let values = match self.names.solutions.get(&key) {
            Some(values) => values.clone(),
            None => {
                let values = self.names.fresh();
                let arguments = key.1.iter().map(|argument| self.names.values[*argument].as_str());
                let arguments = arguments.chain([values.as_str()]).collect::<Vec<_>>();
                let call = self.surroundings.call(function, &arguments);
                let array = self.target.array(&values, function.unknowns().len());
                self.out += &format!("    {array}\n    {call};\n");
                self.names.solutions.insert(key, values.clone());
                values
            }
        };
        self.define(&format!("{values}[{}]", function.place()), self.program.hint(id));
    }

    /// Writes sines and cosines of several angles.
    fn pairs(&mut self, id: ValueId, angles: &[ValueId]) {
        for (place, angle) in angles.iter().enumerate() {
            let [sine, cosine] = [self.names.fresh(), self.names.fresh()];
            let angle = &self.names.values[*angle];
            self.out += &self.target.sine_and_cosine(angle, [&sine, &cosine]);
            self.names.pairs.insert((id, place as u32), [sine, cosine]);
        }
        // The pair itself is not a number.
        self.names.values.push(String::new());
    }

    /// Refers to a sine or a cosine, which is already in a variable.
    fn part(&mut self, pairs: ValueId, place: u32, part: usize) {
        let name = self.names.pairs.get(&(pairs, place)).map(|names| names[part].clone());
        self.names.values.push(name.unwrap_or_else(|| unreachable!("{pairs:?} is a pair")));
    }

    fn expression(&self, op: &Op) -> String {
        let (target, at) = (self.target, |id: &ValueId| self.names.values[*id].as_str());
        let minus = |id: &ValueId| format!("-{}", at(id));
        match op {
            Op::Add(a, b) => format!("{} + {}", at(a), at(b)),
            Op::Subtract(a, b) => format!("{} - {}", at(a), at(b)),
            Op::Multiply(a, b) => format!("{} * {}", at(a), at(b)),
            Op::Divide(a, b) => format!("{} / {}", at(a), at(b)),
            Op::Negate(a) => minus(a),
            Op::MultiplyAdd(a, b, c) => target.multiply_add([at(a), at(b), at(c)]),
            Op::MultiplySubtract(a, b, c) => target.multiply_add([at(a), at(b), &minus(c)]),
            Op::SubtractProduct(a, b, c) => target.multiply_add([&minus(a), at(b), at(c)]),
            Op::Power(a, exponent) => target.power(at(a), *exponent),
            Op::Call(function, arguments) => {
                target.call(row(*function).rust, &arguments.iter().map(at).collect::<Vec<_>>().join(", "))
            }
            Op::Opaque(function, arguments) => {
                self.surroundings.call(function, &arguments.iter().map(at).collect::<Vec<_>>())
            }
            Op::Select { relation, left, right, then, otherwise } => {
                let (holds, fails) = relations(*relation);
                let [left, right, then, otherwise] = [left, right, then, otherwise].map(at);
                // If both comparisons fail, one of the sides is NaN, and so is their sum.
                format!(
                    "{left} {holds} {right} ? {then} : {left} {fails} {right} ? {otherwise} : {left} + {right}"
                )
            }
            _ => unreachable!("{op:?} is no expression"),
        }
    }
}

/// Returns a relation and its opposite.
fn relations(relation: Relation) -> (&'static str, &'static str) {
    match relation {
        Relation::Less => ("<", ">="),
        Relation::LessEqual => ("<=", ">"),
        Relation::Greater => (">", "<="),
        Relation::GreaterEqual => (">=", "<"),
    }
}

#[cfg(test)]
mod tests;
