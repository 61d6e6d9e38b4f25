//! Random expressions of a given dimension.

use lagrange_core::expr::Function;

use crate::tree::Operator;
use crate::tree::{
    Expr, Statement, Table, add, binary, call, divide, multiply, name, number, power, subtract,
};

use super::quantities::Dimension;
use super::{Atom, Generator, Level};

/// Largest nesting depth of plain expressions.
const DEPTH: usize = 3;

impl Generator {
    /// Returns an expression of a dimension.
    pub(super) fn scalar(&mut self, dimension: Dimension, level: Level) -> Expr {
        let atoms = self.atoms.iter().filter(|atom| atom.dimension == dimension && atom.level <= level);
        let atoms = atoms.map(|atom| atom.expression.clone()).collect::<Vec<_>>();
        match self.random.below(5) {
            0 | 1 if !atoms.is_empty() => self.random.choice(&atoms).clone(),
            2 => {
                let (a, b) = (self.product(dimension, level), self.product(dimension, level));
                if self.chance(2) { add(a, b) } else { subtract(a, b) }
            }
            _ => self.product(dimension, level),
        }
    }

    fn product(&mut self, dimension: Dimension, level: Level) -> Expr {
        let plain = self.plain(level);
        if dimension == Dimension::NONE {
            return plain;
        }
        let quantity = self.signed(dimension, 2.0);
        multiply(quantity, plain)
    }

    /// Returns a plain number of order one.
    pub(super) fn plain(&mut self, level: Level) -> Expr {
        self.nested(level, DEPTH)
    }

    fn nested(&mut self, level: Level, depth: usize) -> Expr {
        if depth == 0 {
            return self.argument(level);
        }
        if level == Level::Force && self.chance(4) {
            return self.kinked(level, depth);
        }
        let x = |generator: &mut Generator| generator.nested(level, depth - 1);
        match self.random.below(19) {
            0 => call(Function::Sin, x(self)),
            1 => call(Function::Cos, x(self)),
            2 => call(Function::Tanh, x(self)),
            3 => call(Function::Atan, x(self)),
            4 => {
                let square = power(x(self), 2);
                call(Function::Exp, Expr::Negative(Box::new(square)))
            }
            5 => divide(number("1"), self.above_one(level, depth)),
            6 => {
                let base = self.above_one(level, depth);
                let (n, m) = *self.random.choice(&[(1, 2), (3, 2), (-1, 2), (2, 3), (-5, 4)]);
                Expr::Power(Box::new(base), n, m)
            }
            7 => call(Function::Ln, self.above_one(level, depth)),
            8 => call(Function::Sqrt, self.above_one(level, depth)),
            9 => Expr::Call(Function::Hypot, vec![number("1"), x(self)]),
            10 => {
                let share = multiply(number("0.9"), call(Function::Sin, x(self)));
                let function = *self.random.choice(&[Function::Asin, Function::Acos]);
                call(function, share)
            }
            11 => Expr::Call(Function::Atan2, vec![x(self), self.above_one(level, depth)]),
            12 => {
                let small = divide(x(self), number("3"));
                let small = call(Function::Sin, small);
                let function = *self.random.choice(&[Function::Sinh, Function::Cosh, Function::Tan]);
                call(function, small)
            }
            13 => {
                Expr::Call(Function::Power, vec![self.above_one(level, depth), call(Function::Cos, x(self))])
            }
            14 | 15 => self.applied(level, depth),
            16 => multiply(x(self), x(self)),
            17 => self.smooth_kink(level, depth),
            _ => add(x(self), multiply(number("0.5"), x(self))),
        }
    }

    /// Returns 1 + x².
    fn above_one(&mut self, level: Level, depth: usize) -> Expr {
        let x = self.nested(level, depth - 1);
        add(number("1"), power(x, 2))
    }

    /// Returns an expression with kinks or jumps.
    fn kinked(&mut self, level: Level, depth: usize) -> Expr {
        let x = self.nested(level, depth - 1);
        match self.random.below(6) {
            0 => call(Function::Abs, x),
            1 => call(Function::Sign, x),
            2 => multiply(call(Function::Abs, x.clone()), x),
            3 | 4 => {
                let other = if self.chance(2) { number("0") } else { self.nested(level, depth - 1) };
                let function = *self.random.choice(&[Function::Min, Function::Max]);
                Expr::Call(function, vec![x, other])
            }
            _ => {
                let [then, otherwise] = [0, 1].map(|_| self.nested(level, depth - 1));
                let bound = if self.chance(2) { number("0") } else { number("0.25") };
                let or_equal = self.chance(2);
                Expr::Choose { or_equal, operands: Box::new([x, bound, then, otherwise]) }
            }
        }
    }

    /// Returns an expression with kinks in derivatives that no equation of motion contains.
    fn smooth_kink(&mut self, level: Level, depth: usize) -> Expr {
        let x = self.nested(level, depth - 1);
        match self.random.below(4) {
            0 => power(call(Function::Abs, x), 3),
            1 => power(Expr::Call(Function::Max, vec![x, number("0")]), 4),
            2 => multiply(power(call(Function::Abs, x.clone()), 3), x),
            _ => {
                let bound = number("0.25");
                let cut = power(subtract(x.clone(), bound.clone()), 4);
                Expr::Choose { or_equal: false, operands: Box::new([x, bound, number("0"), cut]) }
            }
        }
    }

    /// Applies a function or a table of the declaration, an old or a new one.
    fn applied(&mut self, level: Level, depth: usize) -> Expr {
        let argument = self.nested(level, depth - 1);
        let known = self.functions.iter().filter(|(_, least)| *least <= level);
        let known = known.map(|(name, _)| name.clone()).collect::<Vec<_>>();
        let function = match self.random.below(3) {
            0 if !known.is_empty() => self.random.choice(&known).clone(),
            1 => self.function(),
            _ => self.table(level),
        };
        Expr::Apply(function, vec![argument])
    }

    /// Declares a function.
    fn function(&mut self) -> String {
        let (function, parameter) = (self.fresh("f"), "w".to_owned());
        let w = || name("w");
        let factor = self.signed(Dimension::NONE, 1.0);
        let body = match self.random.below(4) {
            0 => multiply(factor, call(Function::Sin, w())),
            1 => divide(factor, add(number("2"), power(w(), 2))),
            2 => add(multiply(factor, w()), divide(power(w(), 3), number("6"))),
            _ => {
                let known = self.functions.iter().filter(|(_, least)| *least == Level::Shape);
                let known = known.map(|(name, _)| name.clone()).collect::<Vec<_>>();
                let inner = call(Function::Cos, multiply(factor, w()));
                match known.first() {
                    Some(known) => Expr::Apply(known.clone(), vec![inner]),
                    None => inner,
                }
            }
        };
        self.say(Statement::LetFunction(function.clone(), vec![parameter], body));
        self.functions.push((function.clone(), Level::Shape));
        function
    }

    /// Declares a table, which is smooth unless it is for forces.
    fn table(&mut self, level: Level) -> String {
        let table = self.fresh("table");
        let count = 3 + self.random.below(4);
        let even = self.chance(2);
        let points = (0..count).map(|i| {
            let shift = if even { 0.0 } else { self.random.between(0.0, 0.6) };
            let x = format!("{:.2}", -2.0 + 4.0 * (i as f64 + shift) / (count - 1) as f64);
            (x, self.decimal(-1.0, 1.0))
        });
        let points = points.collect();
        let is_smooth = level < Level::Force || self.chance(2);
        let interpolation =
            if is_smooth { "natural" } else { *self.random.choice(&["linear", "monotone", "natural"]) };
        let outside = if is_smooth { "extend" } else { *self.random.choice(&["clamp", "extend"]) };
        self.say(Statement::Table(table.clone(), Table { points, interpolation, outside }));
        self.functions.push((table.clone(), if is_smooth { Level::Shape } else { Level::Force }));
        table
    }

    /// Returns a varying quantity as a plain number.
    pub(super) fn argument(&mut self, level: Level) -> Expr {
        let atoms = self.atoms.iter().filter(|atom| atom.level <= level).cloned().collect::<Vec<_>>();
        let Atom { expression, dimension, .. } = self.random.choice(&atoms).clone();
        let scaled = match dimension {
            Dimension::NONE => expression,
            _ => divide(expression, self.quantity(dimension, 0.5, 2.0)),
        };
        match self.random.below(4) {
            0 => add(scaled, self.signed(Dimension::NONE, 1.0)),
            1 => binary(Operator::Multiply, self.signed(Dimension::NONE, 2.0), scaled),
            2 if self.chance(4) => subtract(scaled, divide(Expr::Pi, number("3"))),
            _ => scaled,
        }
    }

    /// Declares the unknown of an equation whose residual increases everywhere.
    pub(super) fn unknown(&mut self, level: Level) {
        let unknown = self.fresh("y");
        let y = || name(&unknown);
        let known = self.plain(level);
        let factor = self.quantity(Dimension::NONE, 0.5, 2.0);
        let rising = match self.random.below(4) {
            0 => add(multiply(factor, y()), power(y(), 3)),
            1 => subtract(y(), multiply(number("0.4"), call(Function::Sin, y()))),
            2 => add(multiply(factor, y()), call(Function::Tanh, y())),
            _ => add(y(), call(Function::Sinh, divide(y(), number("4")))),
        };
        let residual = subtract(rising, known.clone());
        let start = self.chance(2).then_some(divide(known, number("2")));
        self.say(Statement::Solve { name: unknown.clone(), unit: None, residual, start });
        self.atoms.push(Atom { expression: name(&unknown), dimension: Dimension::NONE, level });
    }

    /// Names an expression.
    pub(super) fn variable(&mut self, dimension: Dimension, level: Level) {
        let variable = self.fresh("z");
        let value = self.scalar(dimension, level);
        self.say(Statement::Let(variable.clone(), value));
        self.atoms.push(Atom { expression: name(&variable), dimension, level });
    }
}
