//! Values of expressions, as series along the motion.

use lagrange_core::number::Number;

use crate::jet::Jet;
use crate::tree::{Expr, Operator, Unit};

use super::{World, element};

impl World<'_> {
    pub(crate) fn scalar(&mut self, expression: &Expr) -> Option<Jet> {
        self.value(expression)?.into_iter().next()
    }

    pub(crate) fn scalars(&mut self, expressions: &[Expr]) -> Option<Vec<Jet>> {
        expressions.iter().map(|expression| self.scalar(expression)).collect()
    }

    /// Returns the components of an expression; a number has one.
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
            Expr::EveryNth(n, operands) => {
                let [then, otherwise] = &**operands;
                return self.value(if self.variable? % n == 0 { then } else { otherwise });
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

    /// Returns a b / 2.
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
