//! Repeated structures: arrays, loops and sums.

use lagrange_core::expr::Function;

use crate::tree::{
    Expr, Index, Statement, Values, add, call, divide, multiply, number, power, rate, subtract,
};

use super::Generator;
use super::quantities::Dimension;

impl Generator {
    /// Declares a chain or a ring of masses, or a chain of links.
    pub(super) fn lattice(&mut self) {
        let count = 2 + self.random.below(4) as i64;
        if self.chance(2) { self.masses(count) } else { self.links(count) }
    }

    /// Returns values for all elements, or for each.
    fn array(&mut self, stem: &str, count: i64, dimension: Dimension, [low, high]: [f64; 2]) -> String {
        let array = self.fresh(stem);
        let unit = self.coherent_unit(dimension);
        let values = match self.random.below(2) {
            0 => Values::All(count, self.decimal(low, high)),
            _ => Values::Each((0..count).map(|_| self.decimal(low, high)).collect()),
        };
        let word = if self.chance(4) { "const" } else { "param" };
        self.say(Statement::Values { word, name: array.clone(), unit, values });
        array
    }

    fn coordinates(&mut self, stem: &str, count: i64, dimension: Dimension) -> String {
        let array = self.fresh(stem);
        let unit = self.coherent_unit(dimension);
        self.say(Statement::Coordinate { name: array.clone(), unit, count: Some(count) });
        array
    }

    /// Declares masses on a line between stiffening springs.
    fn masses(&mut self, count: i64) {
        let stiffness = Dimension::FORCE.over(Dimension::LENGTH);
        let x = self.coordinates("x", count, Dimension::LENGTH);
        let m = self.array("m", count, Dimension::MASS, [0.5, 2.0]);
        let k = self.array("k", count, stiffness, [1.0, 5.0]);
        let at = |array: &str| Expr::Element(array.to_owned(), Index::VARIABLE);
        let is_ring = self.chance(2);
        let next = Index { offset: 1, ring: is_ring.then_some(count), ..Index::VARIABLE };
        let stretch = subtract(Expr::Element(x.clone(), next), at(&x));
        let kinetic = Expr::KineticEnergy(Box::new(at(&m)), Box::new(rate(at(&x))));
        let springs = if is_ring { count } else { count - 1 };
        let stiffness_here = if self.chance(3) {
            let stiffer = multiply(number("1.5"), at(&k));
            Expr::EveryNth(2 + self.random.below(2) as i64, Box::new([stiffer, at(&k)]))
        } else {
            at(&k)
        };
        let spring = Expr::SpringEnergy(Box::new(stiffness_here), Box::new(stretch.clone()));
        if self.chance(2) {
            self.say(Statement::Energy("kinetic", Expr::Sum(count, Box::new(kinetic))));
            self.say(Statement::Energy("potential", Expr::Sum(springs, Box::new(spring))));
        } else {
            self.say(Statement::Loop(count, vec![Statement::Energy("kinetic", kinetic)]));
            self.say(Statement::Loop(springs, vec![Statement::Energy("potential", spring)]));
        }
        let stiffening = self.quantity(stiffness.over(Dimension::LENGTH).over(Dimension::LENGTH), 0.1, 1.0);
        let quartic = multiply(stiffening, power(stretch.clone(), 4));
        self.say(Statement::Loop(springs, vec![Statement::Energy("potential", quartic)]));
        let damping = self.quantity(stiffness.times(Dimension::TIME), 0.1, 1.0);
        let loss = multiply(multiply(damping, add(number("1"), Expr::Variable)), power(rate(stretch), 2));
        self.say(Statement::Loop(springs, vec![Statement::Energy("dissipation", loss)]));
        let coupled =
            multiply(at(&m), rate(Expr::Element(x.clone(), Index { is_variable: false, ..Index::VARIABLE })));
        let coupled = divide(multiply(coupled, rate(at(&x))), number("10"));
        if self.chance(2) {
            self.say(Statement::Loop(count, vec![Statement::Energy("kinetic", coupled)]));
        }
        if self.chance(3) {
            let acceleration = rate(rate(at(&x)));
            let function = Expr::KineticEnergy(Box::new(at(&m)), Box::new(acceleration));
            let stated = Expr::KineticEnergy(Box::new(at(&m)), Box::new(rate(at(&x))));
            self.say(Statement::Loop(count, vec![Statement::Gibbs(function, stated)]));
        }
        if self.chance(3) {
            self.filters(&x, count);
        }
        if self.chance(3) && count > 2 {
            let [first, last] = [0, count - 1].map(|offset| Index { is_variable: false, offset, ring: None });
            let sum = add(Expr::Element(x.clone(), first), Expr::Element(x, last));
            let held = self.fresh("hold");
            self.say(Statement::Constraint { name: held, holds_rates: false, zero: sum });
        }
    }

    /// Declares states that follow the coordinates, each with a force on its coordinate.
    fn filters(&mut self, x: &str, count: i64) {
        let z = self.fresh("z");
        let unit = self.coherent_unit(Dimension::LENGTH);
        self.say(Statement::State { name: z.clone(), unit, count: Some(count) });
        let at = |array: &str| Expr::Element(array.to_owned(), Index::VARIABLE);
        let lag = subtract(at(x), at(&z));
        let time = self.quantity(Dimension::TIME, 0.5, 2.0);
        let change = divide(lag.clone(), multiply(time, add(number("1"), Expr::Variable)));
        let stiffness = self.quantity(Dimension::FORCE.over(Dimension::LENGTH), 0.5, 2.0);
        let pull = Expr::Negative(Box::new(multiply(stiffness, lag)));
        let index = Some(Index::VARIABLE);
        let statements = vec![
            Statement::StateRate { name: z, index, rate: change },
            Statement::ForceAlong(pull, rate(at(x))),
        ];
        self.say(Statement::Loop(count, statements));
    }

    /// Declares links that hang from each other, by angles relative to the vertical or to each
    /// other.
    fn links(&mut self, count: i64) {
        let a = self.coordinates("a", count, Dimension::NONE);
        let m = self.array("m", count, Dimension::MASS, [0.5, 2.0]);
        let l = self.array("l", count, Dimension::LENGTH, [0.5, 1.5]);
        let gravity = self.quantity(Dimension::GRAVITY, 9.0, 10.0);
        let at = |array: &str| Expr::Element(array.to_owned(), Index::VARIABLE);
        let (p, b) = (self.fresh("p"), self.fresh("b"));
        let next = Index { offset: 1, ..Index::VARIABLE };
        let first = Index { is_variable: false, offset: 0, ring: None };
        let zero = || Expr::Number("0".to_owned(), None);
        self.say(Statement::LetElement(p.clone(), first, Expr::Vector(vec![zero(), zero()])));
        self.say(Statement::LetElement(b.clone(), first, zero()));
        let is_relative = self.chance(2);
        let before = if is_relative { at(&b) } else { multiply(zero(), at(&b)) };
        let angle = add(before, at(&a));
        let total = Expr::Element(b.clone(), next);
        let down = Expr::Negative(Box::new(call(Function::Cos, total.clone())));
        let step = multiply(at(&l), Expr::Vector(vec![call(Function::Sin, total), down]));
        let end = Expr::Element(p.clone(), next);
        let velocity = rate(end.clone());
        let height = Expr::Component(Box::new(end), 1);
        let statements = vec![
            Statement::LetElement(b, next, angle),
            Statement::LetElement(p.clone(), next, add(at(&p), step)),
            Statement::Energy("kinetic", Expr::KineticEnergy(Box::new(at(&m)), Box::new(velocity.clone()))),
            Statement::Energy("potential", multiply(multiply(at(&m), gravity), height)),
        ];
        let gibbs = Statement::Gibbs(
            Expr::KineticEnergy(Box::new(at(&m)), Box::new(rate(velocity.clone()))),
            Expr::KineticEnergy(Box::new(at(&m)), Box::new(velocity)),
        );
        let statements = statements.into_iter().chain(self.chance(3).then_some(gibbs)).collect();
        self.say(Statement::Loop(count, statements));
        let tip = Expr::Element(p, Index { is_variable: false, offset: count, ring: None });
        self.say(Statement::Output("tip".to_owned(), rate(rate(tip.clone()))));
        if self.chance(3) && count > 2 {
            let span = Expr::Component(Box::new(tip), 1);
            self.say(Statement::Constraint { name: "hold".to_owned(), holds_rates: false, zero: span });
        }
    }
}
