//! Points and angles carried by each other, with energies and loads of every kind.

use lagrange_core::expr::Function;

use crate::tree::{Expr, Statement, add, call, divide, multiply, name, number, power, rate, subtract};

use super::quantities::Dimension;
use super::{Generator, Level};

/// A point for masses and forces, and its coordinates beside those of its carrier.
struct Point {
    expression: Expr,
    dimension: usize,
    angle: Option<Expr>,
    own: Vec<(Expr, Dimension)>,
}

const MAX_POINTS: usize = 4;
/// Number of coordinates above which no point is added.
const ENOUGH: usize = 5;

fn half(of: Expr) -> Expr {
    multiply(divide(number("1"), number("2")), of)
}

impl Generator {
    /// Declares a machine.
    pub(super) fn machine(&mut self) {
        let is_lagrangian = self.chance(4);
        let dimension = if self.chance(3) { 3 } else { 2 };
        let mut points = vec![self.support(dimension)];
        let count = 1 + self.random.below(MAX_POINTS);
        while points.len() <= count && points.iter().map(|point| point.own.len()).sum::<usize>() < ENOUGH {
            let carrier = self.random.below(points.len());
            let point = self.point_on(&points[carrier]);
            points.push(point);
        }
        if self.chance(3) {
            self.orientation(is_lagrangian);
        }
        let states = if self.chance(3) { 1 + self.random.below(2) } else { 0 };
        let states = (0..states).map(|_| self.state()).collect::<Vec<_>>();
        for level in [Level::Shape, Level::Potential, Level::Force] {
            if self.chance(4) {
                self.unknown(level);
            }
            if self.chance(4) {
                self.variable(Dimension::NONE, level);
            }
        }
        for point in &points[1..] {
            self.energies(point, is_lagrangian);
        }
        for _ in 0..self.random.below(4) {
            let point = 1 + self.random.below(points.len() - 1);
            self.load(&points[point]);
        }
        if self.chance(4) {
            self.constraint(&points);
        }
        for (state, dimension) in states {
            let value = self.scalar(dimension.rate(), Level::Force);
            self.say(Statement::StateRate { name: state, index: None, rate: value });
        }
        for _ in 0..self.random.below(3) {
            self.output(&points);
        }
    }

    /// Returns the ground, or a support whose motion is a function of time.
    fn support(&mut self, dimension: usize) -> Point {
        let mut components = vec![multiply(self.length(), number("0")); dimension];
        if self.chance(4) {
            let (size, period) = (self.length(), self.quantity(Dimension::TIME, 0.5, 2.0));
            components[0] = multiply(size, call(Function::Sin, divide(Expr::Time, period)));
        }
        Point { expression: Expr::Vector(components), dimension, angle: None, own: Vec::new() }
    }

    fn length(&mut self) -> Expr {
        self.quantity(Dimension::LENGTH, 0.5, 2.0)
    }

    fn angle_coordinate(&mut self) -> Expr {
        self.coordinate("a", Dimension::NONE)
    }

    fn length_coordinate(&mut self) -> Expr {
        self.coordinate("x", Dimension::LENGTH)
    }

    /// Declares a point that moves relative to another one.
    fn point_on(&mut self, carrier: &Point) -> Point {
        let zero = |generator: &mut Generator| multiply(generator.length(), number("0"));
        let [cosine, sine] = [Function::Cos, Function::Sin];
        let mut own = Vec::new();
        let mut angle = None;
        let mut components = match self.random.below(7) {
            0..3 => {
                let (length, a) = (self.length(), self.angle_coordinate());
                own.push((a.clone(), Dimension::NONE));
                let total = match &carrier.angle {
                    Some(before) if self.chance(2) => add(before.clone(), a),
                    _ => a,
                };
                angle = Some(total.clone());
                let down = Expr::Negative(Box::new(multiply(length.clone(), call(cosine, total.clone()))));
                vec![multiply(length, call(sine, total)), down]
            }
            3 => {
                let x = self.length_coordinate();
                own.push((x.clone(), Dimension::LENGTH));
                let tilt = self.quantity(Dimension::NONE, 0.1, 1.5);
                vec![multiply(x.clone(), call(cosine, tilt.clone())), multiply(x, call(sine, tilt))]
            }
            4 => {
                let (x, height) = (self.length_coordinate(), self.length());
                let scaled = divide(x.clone(), self.length());
                own.push((x.clone(), Dimension::LENGTH));
                let road = match self.random.below(3) {
                    0 => call(sine, scaled),
                    1 => call(Function::Tanh, scaled),
                    _ => self.plain(Level::Shape),
                };
                vec![x, multiply(height, road)]
            }
            5 => {
                let (x, a, length) = (
                    self.length_coordinate(),
                    self.angle_coordinate(),
                    self.quantity(Dimension::LENGTH, 2.0, 4.0),
                );
                own.extend([(x.clone(), Dimension::LENGTH), (a.clone(), Dimension::NONE)]);
                angle = Some(a.clone());
                let r = add(length, x);
                vec![multiply(r.clone(), call(sine, a.clone())), multiply(r, call(cosine, a))]
            }
            _ => {
                let (x, y) = (self.length_coordinate(), self.length_coordinate());
                own.extend([(x.clone(), Dimension::LENGTH), (y.clone(), Dimension::LENGTH)]);
                vec![x, y]
            }
        };
        if carrier.dimension == 3 {
            let z = if self.chance(2) {
                let z = self.length_coordinate();
                own.push((z.clone(), Dimension::LENGTH));
                z
            } else {
                zero(self)
            };
            components.insert(self.random.below(3), z);
        }
        let point = self.fresh("r");
        let place = add(carrier.expression.clone(), Expr::Vector(components));
        self.say(Statement::Let(point.clone(), place));
        Point { expression: name(&point), dimension: carrier.dimension, angle, own }
    }

    /// Adds an energy to T, or to L.
    fn add_kinetic(&mut self, is_lagrangian: bool, energy: Expr) {
        self.say(Statement::Energy(if is_lagrangian { "lagrangian" } else { "kinetic" }, energy));
    }

    fn add_potential(&mut self, is_lagrangian: bool, energy: Expr) {
        if is_lagrangian {
            self.say(Statement::Energy("lagrangian", Expr::Negative(Box::new(energy))));
        } else {
            self.say(Statement::Energy("potential", energy));
        }
    }

    fn energies(&mut self, point: &Point, is_lagrangian: bool) {
        let mass = self.parameter(Dimension::MASS, 0.3, 3.0);
        let velocity = rate(point.expression.clone());
        let kinetic = if self.chance(3) {
            half(multiply(mass.clone(), Expr::Inner(Box::new(velocity.clone()), Box::new(velocity))))
        } else {
            Expr::KineticEnergy(Box::new(mass.clone()), Box::new(velocity))
        };
        self.add_kinetic(is_lagrangian, kinetic);
        for (q, dimension) in point.own.clone() {
            let inertia = Dimension::ENERGY.over(dimension.rate()).over(dimension.rate());
            // An inertia of its own keeps every coordinate from being idle.
            if self.chance(2) || point.own.len() > 1 {
                let inertia = self.parameter(inertia, 0.2, 1.0);
                let turning = half(multiply(inertia, power(rate(q.clone()), 2)));
                self.add_kinetic(is_lagrangian, turning);
            }
            if self.chance(6) {
                let factor = add(number("1"), power(self.plain(Level::Shape), 2));
                let inertia = self.parameter(inertia, 0.2, 1.0);
                let varying = multiply(multiply(half(inertia), factor), power(rate(q.clone()), 2));
                self.add_kinetic(is_lagrangian, varying);
            }
            if self.chance(12) {
                let rates = dimension.rate();
                let factor = self.parameter(
                    Dimension::ENERGY.over(rates.times(rates).times(rates.times(rates))),
                    0.05,
                    0.2,
                );
                self.add_kinetic(is_lagrangian, multiply(factor, power(rate(q.clone()), 4)));
            }
            if is_lagrangian && self.chance(3) {
                let factor = self.scalar(Dimension::ENERGY.over(dimension.rate()), Level::Shape);
                self.add_kinetic(true, multiply(factor, rate(q.clone())));
            }
            if self.chance(3) {
                let stiffness = self.parameter(Dimension::ENERGY.over(dimension.times(dimension)), 0.5, 5.0);
                let stretch = subtract(q.clone(), self.signed(dimension, 0.5));
                let spring = Expr::SpringEnergy(Box::new(stiffness), Box::new(stretch));
                self.add_potential(is_lagrangian, spring);
            }
        }
        if self.chance(2) {
            let gravity = self.quantity(Dimension::GRAVITY, 9.0, 10.0);
            let height = Expr::Component(Box::new(point.expression.clone()), point.dimension - 1);
            self.add_potential(is_lagrangian, multiply(multiply(mass, gravity), height));
        }
        if self.chance(4) {
            let stiffness = self.parameter(Dimension::FORCE.over(Dimension::LENGTH), 0.5, 5.0);
            let fixed = (0..point.dimension).map(|_| self.signed(Dimension::LENGTH, 3.0)).collect();
            let span = subtract(point.expression.clone(), Expr::Vector(fixed));
            let stretch = subtract(Expr::Norm(Box::new(span)), self.length());
            let spring = Expr::SpringEnergy(Box::new(stiffness), Box::new(stretch));
            self.add_potential(is_lagrangian, spring);
        }
        if self.chance(3) {
            let potential = self.scalar(Dimension::ENERGY, Level::Potential);
            self.add_potential(is_lagrangian, potential);
        }
    }

    /// Adds a force or a loss.
    fn load(&mut self, point: &Point) {
        let Some((q, dimension)) = point.own.first().cloned() else { return };
        let force = Dimension::ENERGY.over(dimension);
        match self.random.below(6) {
            0 => {
                let damping = self.parameter(force.over(dimension.rate()), 0.1, 1.0);
                let loss = half(multiply(damping, power(rate(q), 2)));
                self.say(Statement::Energy("dissipation", loss));
            }
            1 => {
                let Expr::Name(q) = q else { return };
                let value = self.scalar(force, Level::Force);
                self.say(Statement::Force(q, value));
            }
            2 => {
                let value = self.scalar(force, Level::Force);
                let factor = self.plain(Level::Shape);
                self.say(Statement::ForceAlong(value, multiply(factor, rate(q))));
            }
            3 => {
                let value =
                    (0..point.dimension).map(|_| self.scalar(Dimension::FORCE, Level::Force)).collect();
                self.say(Statement::ForceAt(Expr::Vector(value), point.expression.clone()));
            }
            4 => {
                let moment = self.scalar(force, Level::Force);
                let turned = if dimension == Dimension::NONE { q } else { return };
                self.say(Statement::Torque(moment, turned));
            }
            _ => {
                let power_ = Dimension::ENERGY.rate();
                let rates = dimension.rate();
                let factor = self.parameter(power_.over(rates.times(rates)), 0.1, 1.0);
                let base = add(power(self.plain(Level::Shape), 2), number("1"));
                self.say(Statement::Energy(
                    "dissipation",
                    multiply(multiply(factor, base), power(rate(q), 2)),
                ));
            }
        }
    }

    /// Constrains coordinates of a point, or their rates.
    fn constraint(&mut self, points: &[Point]) {
        let own = points.iter().flat_map(|point| point.own.clone()).collect::<Vec<_>>();
        if own.len() < 3 {
            return;
        }
        let (a, of_a) = self.random.choice(&own).clone();
        let (b, of_b) = self.random.choice(&own).clone();
        let held = self.fresh("hold");
        let factor = self.quantity(of_a.over(of_b), 0.5, 2.0);
        let (holds_rates, zero) = match self.random.below(3) {
            0 => {
                let curve = self.scalar(of_a, Level::Shape);
                if self.without_names(&curve) == a.to_string() {
                    return;
                }
                (false, subtract(a, curve))
            }
            1 => {
                let size = if of_b == Dimension::NONE { factor } else { self.quantity(of_a, 0.5, 2.0) };
                let wave = call(Function::Sin, divide(b, self.quantity(of_b, 0.5, 2.0)));
                (false, subtract(a, multiply(size, wave)))
            }
            _ => {
                let shape = self.plain(Level::Shape);
                (true, subtract(rate(a), multiply(multiply(factor, shape), rate(b))))
            }
        };
        self.say(Statement::Constraint { name: held, holds_rates, zero });
    }

    /// Returns the text of an expression. If that is a name, the definition replaces it,
    /// repeatedly.
    fn without_names(&self, expression: &Expr) -> String {
        let text = expression.to_string();
        let named = self.statements.iter().find_map(|statement| match statement {
            Statement::Let(name, value) if *name == text => Some(value),
            _ => None,
        });
        named.map_or(text, |value| self.without_names(value))
    }

    /// Declares a first-order state, whose rate is stated after everything on which it may depend.
    fn state(&mut self) -> (String, Dimension) {
        let state = self.fresh("s");
        let dimension = *self.random.choice(&[Dimension::NONE, Dimension::FORCE, Dimension::LENGTH]);
        let unit = self.coherent_unit(dimension);
        self.say(Statement::State { name: state.clone(), unit, count: None });
        let atom = super::Atom { expression: name(&state), dimension, level: Level::Potential };
        self.atoms.push(atom);
        (state, dimension)
    }

    /// Declares a quaternion with energies in its angular velocity.
    fn orientation(&mut self, is_lagrangian: bool) {
        let hip = self.fresh("hip");
        self.say(Statement::Quaternion(hip.clone()));
        for axis in ["x", "y", "z"] {
            let rate = name(&format!("{hip}_w{axis}"));
            let inertia = self.parameter(Dimension::INERTIA, 0.5, 2.0);
            self.add_kinetic(is_lagrangian, half(multiply(inertia, power(rate.clone(), 2))));
            let dimension = Dimension::NONE.rate();
            self.atoms.push(super::Atom { expression: rate, dimension, level: Level::Force });
        }
        let part = |part: &str| name(&format!("{hip}_q{part}"));
        let tilt = subtract(multiply(part("w"), part("y")), multiply(part("x"), part("z")));
        self.atoms.push(super::Atom {
            expression: tilt.clone(),
            dimension: Dimension::NONE,
            level: Level::Shape,
        });
        let size = self.signed(Dimension::ENERGY, 3.0);
        self.add_potential(is_lagrangian, multiply(size, tilt));
    }

    fn output(&mut self, points: &[Point]) {
        let output = self.fresh("out");
        let point = points[1 + self.random.below(points.len() - 1)].expression.clone();
        let value = match self.random.below(4) {
            0 => point,
            1 => rate(point),
            2 => rate(rate(point)),
            _ => self.scalar(Dimension::FORCE, Level::Force),
        };
        self.say(Statement::Output(output, value));
    }
}
