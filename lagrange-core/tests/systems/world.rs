//! Trees evaluated along a motion.
//!
//! At a state with accelerations every coordinate is a [`Jet`] with two variations for each velocity: a displacement that stays, and one
//! that grows as τ. Expressions follow by arithmetic with jets; what statements add up to is in [`Sums`].

use std::collections::HashMap;

use lagrange_core::number::Number;

use crate::digits::Real;
use crate::jet::{Field, Jet};
use crate::layout::{Layout, Slot};
use crate::splines::Spline;
use crate::tree::{Expr, Operator, Statement, Unit, Values};

/// Time, positions and velocities in the order of emitted code.
#[derive(Clone, Debug)]
pub(crate) struct State {
    pub(crate) t: f64,
    pub(crate) q: Vec<f64>,
    pub(crate) v: Vec<f64>,
}

/// What statements add up to.
pub(crate) struct Sums {
    pub(crate) kinetic: Jet,
    pub(crate) potential: Jet,
    /// What is declared as a Lagrangian.
    pub(crate) lagrangian: Jet,
    pub(crate) dissipation: Jet,
    /// Forces along the velocities.
    pub(crate) forces: Vec<Real>,
    pub(crate) constraints: Vec<(Jet, bool)>,
    pub(crate) state_rates: Vec<Real>,
    pub(crate) outputs: Vec<(String, Vec<Jet>)>,
}

/// A rigid body or a frame where it is.
#[derive(Clone)]
pub(crate) struct Placed {
    pub(crate) rotation: Vec<Vec<Jet>>,
    pub(crate) origin: Vec<Jet>,
    pub(crate) centroid: Vec<Jet>,
}

/// Names with their values. Where a name is missing, everything made of it is `None`.
pub(crate) struct World<'a> {
    pub(crate) field: &'a mut Field,
    pub(crate) layout: &'a Layout,
    pub(crate) sums: Sums,
    pub(crate) scope: HashMap<String, Vec<Jet>>,
    pub(crate) placed: HashMap<String, Placed>,
    pub(crate) gravity: Vec<Jet>,
    functions: HashMap<String, (Vec<String>, Expr)>,
    splines: HashMap<String, Spline>,
    variable: Option<i64>,
    /// True if loads and outputs are passed over, which no acceleration changes.
    pub(crate) only_energies: bool,
    /// Unknowns as they were found before.
    pub(crate) roots: HashMap<String, Real>,
}

impl<'a> World<'a> {
    /// The world at a state with accelerations, and with rates of first-order states if they are known.
    pub(crate) fn new(
        field: &'a mut Field,
        layout: &'a Layout,
        state: &State,
        accelerations: &[Real],
        state_rates: Option<&[Real]>,
    ) -> World<'a> {
        let zero = field.whole(0);
        let sums = Sums {
            kinetic: zero.clone(),
            potential: zero.clone(),
            lagrangian: zero.clone(),
            dissipation: zero,
            forces: vec![field.integer(0); layout.velocities],
            constraints: Vec::new(),
            state_rates: Vec::new(),
            outputs: Vec::new(),
        };
        let mut world = World {
            field,
            layout,
            sums,
            scope: HashMap::new(),
            placed: HashMap::new(),
            gravity: Vec::new(),
            functions: HashMap::new(),
            splines: HashMap::new(),
            variable: None,
            only_energies: false,
            roots: HashMap::new(),
        };
        world.set_positions(state, accelerations);
        world.set_states(state, state_rates);
        world
    }

    fn float(&mut self, value: f64) -> Real {
        let value = self.field.arithmetic.float(value);
        self.field.rounded(value)
    }

    fn set_positions(&mut self, state: &State, accelerations: &[Real]) {
        let layout = self.layout;
        for slot in &layout.slots {
            match slot {
                Slot::Coordinate { name, position, velocity } => {
                    let (q, v) = (self.float(state.q[*position]), self.float(state.v[*velocity]));
                    let half = self.field.arithmetic.float(0.5);
                    let bend = self.field.product(&half, &accelerations[*velocity]);
                    let jet = Jet { value: vec![q, v, bend], ..self.field.whole(0) };
                    let jet = self.displaced(jet, *velocity);
                    self.scope.insert(name.clone(), vec![jet]);
                }
                Slot::Orientation { name, position, velocity } => {
                    let q = [0, 1, 2, 3].map(|k| self.float(state.q[position + k]));
                    let w = [0, 1, 2].map(|k| self.float(state.v[velocity + k]));
                    self.set_orientation(name, *velocity, &q, &w, &accelerations[*velocity..velocity + 3]);
                }
            }
        }
        let t = self.float(state.t);
        let time = self.field.series(&[t, self.field.integer(1)]);
        self.scope.insert("t".to_owned(), vec![time]);
    }

    /// The coordinate itself is displaced.
    fn displaced(&self, mut jet: Jet, velocity: usize) -> Jet {
        let one = self.field.integer(1);
        let zero = self.field.integer(0);
        jet.variations[velocity] = vec![one.clone(), zero.clone(), zero.clone()];
        jet.variations[self.layout.velocities + velocity] = vec![zero.clone(), one, zero];
        jet
    }

    /// A first-order state along its rate. Unless that is known only the value is.
    fn set_states(&mut self, state: &State, rates: Option<&[Real]>) {
        let first = self.layout.positions;
        for (k, name) in self.layout.states.iter().enumerate() {
            let value = self.float(state.q[first + k]);
            let rate = rates.map_or_else(|| self.field.integer(0), |rates| rates[k].clone());
            let jet = self.field.series(&[value, rate]);
            self.scope.insert(name.clone(), vec![jet]);
        }
    }

    /// Adds what a statement says.
    pub(crate) fn read(&mut self, statement: &Statement) -> Option<()> {
        if self.only_energies && statement.is_load_or_output() {
            return Some(());
        }
        match statement {
            Statement::Values { word, name, unit, values } => {
                let values = match values {
                    Values::One(value) => vec![(name.clone(), value)],
                    Values::Each(values) => {
                        values.iter().enumerate().map(|(i, value)| (element(name, i as i64), value)).collect()
                    }
                    Values::All(count, value) => (0..*count).map(|i| (element(name, i), value)).collect(),
                };
                for (name, decimal) in values {
                    let coherent = Unit::coherent(unit.as_ref(), decimal);
                    // Fields of emitted types are floats, constants are exact.
                    let value = match *word {
                        "const" => self.field.decimal(&coherent),
                        _ => {
                            let value = self.field.arithmetic.float(coherent.parse().ok()?);
                            self.field.constant(value)
                        }
                    };
                    self.scope.insert(name, vec![value]);
                }
            }
            Statement::Let(name, value) => {
                let value = self.value(value)?;
                self.scope.insert(name.clone(), value);
            }
            Statement::LetElement(name, index, value) => {
                let name = element(name, index.at(self.variable.unwrap_or(0)));
                let value = self.value(value)?;
                self.scope.insert(name, value);
            }
            Statement::LetFunction(name, parameters, value) => {
                self.functions.insert(name.clone(), (parameters.clone(), value.clone()));
            }
            Statement::Table(name, table) => {
                let spline = Spline::new(&mut self.field.arithmetic, table);
                self.splines.insert(name.clone(), spline);
            }
            Statement::Solve { name, residual, .. } => self.solve(name, residual)?,
            Statement::Energy(word, value) => self.add_energy(word, value)?,
            Statement::Force(name, force) => {
                let force = self.scalar(force)?;
                let velocity = self.layout.velocity(name)?;
                self.sums.forces[velocity] = self.field.sum(&self.sums.forces[velocity], &force.value[0]);
            }
            Statement::ForceAlong(force, velocity) => {
                let (force, velocity) = (self.value(force)?, self.value(velocity)?);
                self.add_work(&force, &velocity, self.layout.velocities);
            }
            Statement::ForceAt(force, point) | Statement::Torque(force, point) => {
                let (force, point) = (self.value(force)?, self.value(point)?);
                self.add_work(&force, &point, 0);
            }
            Statement::TorqueOn(moment, body) => {
                let (moment, spin) = (self.value(moment)?, self.spin(body)?);
                self.add_work(&moment, &spin, self.layout.velocities);
            }
            Statement::Constraint { holds_rates, zero, .. } => {
                let zero = self.scalar(zero)?;
                self.sums.constraints.push((zero, *holds_rates));
            }
            Statement::StateRate { name, rate } => {
                let rate = self.scalar(rate)?;
                self.sums.state_rates.push(rate.value[0].clone());
                self.scope.insert(format!("dot {name}"), vec![rate]);
            }
            Statement::Output(name, value) => {
                let value = self.value(value)?;
                self.sums.outputs.push((name.clone(), value));
            }
            Statement::Loop(count, statements) => {
                for i in 0..*count {
                    self.variable = Some(i);
                    statements.iter().try_for_each(|statement| self.read(statement))?;
                }
                self.variable = None;
            }
            Statement::Coordinate { .. } | Statement::State { .. } | Statement::Quaternion(_) => {}
            _ => self.read_scene(statement)?,
        }
        Some(())
    }

    fn add_energy(&mut self, word: &str, value: &Expr) -> Option<()> {
        let value = self.scalar(value)?;
        let sum = match word {
            "kinetic" => &mut self.sums.kinetic,
            "potential" => &mut self.sums.potential,
            "lagrangian" => &mut self.sums.lagrangian,
            _ => &mut self.sums.dissipation,
        };
        *sum = self.field.add(sum, &value);
        Some(())
    }

    /// Adds forces times what they move, as displacements that stay or, from `first` on, as rates.
    pub(crate) fn add_work(&mut self, force: &[Jet], moved: &[Jet], first: usize) {
        for i in 0..self.layout.velocities {
            for (force, moved) in force.iter().zip(moved) {
                let change = self.field.change(moved, first + i, 0);
                let work = self.field.product(&force.value[0], &change);
                self.sums.forces[i] = self.field.sum(&self.sums.forces[i], &work);
            }
        }
    }

    pub(crate) fn scalar(&mut self, expression: &Expr) -> Option<Jet> {
        self.value(expression)?.into_iter().next()
    }

    pub(crate) fn scalars(&mut self, expressions: &[Expr]) -> Option<Vec<Jet>> {
        expressions.iter().map(|expression| self.scalar(expression)).collect()
    }

    /// The components of an expression, of which a number has one.
    pub(crate) fn value(&mut self, expression: &Expr) -> Option<Vec<Jet>> {
        let value = match expression {
            Expr::Number(decimal, unit) => {
                let coherent = Unit::coherent(unit.as_ref(), decimal);
                self.field.decimal(&coherent)
            }
            Expr::Pi => {
                let pi = self.field.arithmetic.pi();
                self.field.constant(pi)
            }
            Expr::Time => return self.scope.get("t").cloned(),
            Expr::Name(name) => return self.scope.get(name).cloned(),
            Expr::Element(name, index) => {
                return self.scope.get(&element(name, index.at(self.variable.unwrap_or(0)))).cloned();
            }
            Expr::Variable => self.field.whole(self.variable? as i32),
            Expr::Binary(operator, a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                return Some(self.combined(*operator, &a, &b));
            }
            Expr::Negative(a) => {
                return Some(self.value(a)?.iter().map(|a| self.field.negate(a)).collect());
            }
            Expr::Power(a, n, m) => {
                let a = self.scalar(a)?;
                self.field.power(&a, &Number::ratio(*n, *m)?)
            }
            Expr::Call(function, arguments) => {
                let arguments = self.scalars(arguments)?;
                self.field.call(*function, &arguments)
            }
            Expr::Apply(name, arguments) => self.applied(name, arguments)?,
            Expr::Rate(of) => return self.rate(of),
            Expr::Choose { or_equal, operands } => {
                let [a, b, then, otherwise] = &**operands;
                let (a, b) = (self.scalar(a)?, self.scalar(b)?);
                let order = a.value[0].cmp(&b.value[0])?;
                let holds = order < 0 || *or_equal && order == 0;
                return self.value(if holds { then } else { otherwise });
            }
            Expr::Sum(count, term) => {
                let outer = self.variable;
                let mut sum = self.field.whole(0);
                for i in 0..*count {
                    self.variable = Some(i);
                    let term = self.scalar(term)?;
                    sum = self.field.add(&sum, &term);
                }
                self.variable = outer;
                sum
            }
            Expr::Vector(components) => return self.scalars(components),
            Expr::Component(a, k) => self.value(a)?.get(*k)?.clone(),
            Expr::Norm(a) => {
                let a = self.value(a)?;
                self.field.norm(&a)
            }
            Expr::Inner(a, b) => {
                let (a, b) = (self.value(a)?, self.value(b)?);
                self.field.dot(&a, &b)
            }
            Expr::KineticEnergy(factor, of) | Expr::SpringEnergy(factor, of) => {
                let (factor, of) = (self.scalar(factor)?, self.value(of)?);
                let square = self.field.dot(&of, &of);
                self.half_product(&factor, &square)
            }
            Expr::Point(body, own) => {
                let own = self.scalars(own)?;
                return self.point(body, &own);
            }
            Expr::Direction(body, own) => {
                let own = self.scalars(own)?;
                let rotation = self.placed.get(body)?.rotation.clone();
                return Some(rotation.iter().map(|row| self.field.dot(row, &own)).collect());
            }
            Expr::Center(body) => {
                let own = self.placed.get(body)?.centroid.clone();
                return self.point(body, &own);
            }
            Expr::Spin(body) => return self.spin(body),
        };
        Some(vec![value])
    }

    /// a b / 2
    pub(crate) fn half_product(&mut self, a: &Jet, b: &Jet) -> Jet {
        let half = self.field.series(&[self.field.arithmetic.float(0.5)]);
        let product = self.field.multiply(a, b);
        self.field.multiply(&half, &product)
    }

    fn rate(&mut self, of: &Expr) -> Option<Vec<Jet>> {
        if let Expr::Name(name) = of
            && let Some(rate) = self.scope.get(&format!("dot {name}"))
        {
            return Some(rate.clone());
        }
        Some(self.value(of)?.iter().map(|of| self.field.rate(of)).collect())
    }

    fn combined(&mut self, operator: Operator, a: &[Jet], b: &[Jet]) -> Vec<Jet> {
        let count = a.len().max(b.len());
        let component = |of: &[Jet], k: usize| of[k.min(of.len() - 1)].clone();
        let each = |k| {
            let (a, b) = (component(a, k), component(b, k));
            match operator {
                Operator::Add => self.field.add(&a, &b),
                Operator::Subtract => self.field.subtract(&a, &b),
                Operator::Multiply => self.field.multiply(&a, &b),
                Operator::Divide => self.field.divide(&a, &b),
            }
        };
        (0..count).map(each).collect()
    }

    fn applied(&mut self, name: &str, arguments: &[Expr]) -> Option<Jet> {
        let arguments = self.scalars(arguments)?;
        if let Some(spline) = self.splines.get(name) {
            return spline.value(self.field, &arguments[0]);
        }
        let (parameters, body) = self.functions.get(name)?.clone();
        let bound = parameters.iter().cloned().zip(arguments.into_iter().map(|argument| vec![argument]));
        let hidden = bound.map(|(name, value)| (name.clone(), self.scope.insert(name, value)));
        let hidden = hidden.collect::<Vec<_>>();
        let value = self.scalar(&body);
        for (name, before) in hidden {
            match before {
                Some(before) => self.scope.insert(name, before),
                None => self.scope.remove(&name),
            };
        }
        value
    }
}

/// The name of an element of an array.
pub(crate) fn element(name: &str, index: i64) -> String {
    format!("{name}[{index}]")
}
