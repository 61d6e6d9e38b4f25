//! Statements read in order: names with their values, and contributions to the sums.

use crate::jet::Jet;
use crate::splines::Spline;
use crate::tree::{Expr, Statement, Unit, Values};

use super::{World, element};

impl World<'_> {
    /// Adds the contributions of a statement.
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
            Statement::StateRate { name, index, rate } => {
                let rate = self.scalar(rate)?;
                self.sums.state_rates.push(rate.value[0].clone());
                let index = index.map(|index| index.at(self.variable.unwrap_or(0)));
                let name = index.map_or_else(|| name.clone(), |index| element(name, index));
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
            // A Gibbs function repeats what the energies state.
            Statement::Coordinate { .. }
            | Statement::State { .. }
            | Statement::Quaternion(_)
            | Statement::Gibbs(..) => {}
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

    /// Adds the work of forces on displacements, which are constant or, from `first` on, rates.
    pub(crate) fn add_work(&mut self, force: &[Jet], moved: &[Jet], first: usize) {
        for i in 0..self.layout.velocities {
            for (force, moved) in force.iter().zip(moved) {
                let change = self.field.change(moved, first + i, 0);
                let work = self.field.product(&force.value[0], &change);
                self.sums.forces[i] = self.field.sum(&self.sums.forces[i], &work);
            }
        }
    }
}
