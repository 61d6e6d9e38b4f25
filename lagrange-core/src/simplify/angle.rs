//! Angles as linear combinations, for adding and comparing them.

use std::collections::BTreeMap;

use crate::collections::HashMap;
use crate::expr::{ExprId, Graph, Node};
use crate::number::Number;

/// `constant + Σ coefficient · part`, without zero coefficients; parts are no sums.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) struct Angle {
    parts: BTreeMap<ExprId, Number>,
    constant: Number,
}

/// sin or cos of an angle whose first coefficient is positive.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Wave {
    pub(super) is_sine: bool,
    pub(super) angle: Angle,
}

/// Angles that have been written, so that each is written in one way.
#[derive(Default, Debug)]
pub struct Angles {
    written: HashMap<Angle, ExprId>,
}

impl Default for Angle {
    fn default() -> Angle {
        Angle { parts: BTreeMap::new(), constant: Number::ZERO }
    }
}

impl Angle {
    pub(super) fn plus(&self, other: &Angle) -> Angle {
        let mut sum = self.clone();
        sum.add(other, &Number::ONE);
        sum
    }

    pub(super) fn minus(&self, other: &Angle) -> Angle {
        let mut difference = self.clone();
        difference.add(other, &Number::MINUS_ONE);
        difference
    }

    pub(super) fn scaled(&self, scale: &Number) -> Angle {
        let mut scaled = Angle::default();
        scaled.add(self, scale);
        scaled
    }

    fn add(&mut self, other: &Angle, scale: &Number) {
        for (part, coefficient) in &other.parts {
            self.add_part(*part, &(coefficient * scale));
        }
        self.constant = &self.constant + &(&other.constant * scale);
    }

    fn add_part(&mut self, part: ExprId, coefficient: &Number) {
        let total = self.parts.entry(part).or_insert(Number::ZERO);
        *total = &*total + coefficient;
        if total.is_zero() {
            self.parts.remove(&part);
        }
    }

    fn is_zero(&self) -> bool {
        self.parts.is_empty() && self.constant.is_zero()
    }

    /// Whether the first coefficient is negative.
    fn is_reversed(&self) -> bool {
        self.parts.values().next().unwrap_or(&self.constant).is_negative()
    }
}

impl Wave {
    /// cos 0
    pub(super) fn one() -> Wave {
        Wave { is_sine: false, angle: Angle::default() }
    }

    /// sin or cos of any angle, with the coefficient it then has.
    pub(super) fn signed(is_sine: bool, angle: Angle, coefficient: Number) -> (Wave, Number) {
        if !angle.is_reversed() {
            return (Wave { is_sine, angle }, coefficient);
        }
        let coefficient = if is_sine { -&coefficient } else { coefficient };
        (Wave { is_sine, angle: angle.scaled(&Number::MINUS_ONE) }, coefficient)
    }

    /// Whether this is cos 0.
    pub(super) fn is_one(&self) -> bool {
        !self.is_sine && self.angle.is_zero()
    }

    /// Whether this is sin 0.
    pub(super) fn is_zero(&self) -> bool {
        self.is_sine && self.angle.is_zero()
    }
}

impl Angles {
    /// The linear combination that an expression is.
    pub(super) fn read(&mut self, graph: &Graph, id: ExprId) -> Angle {
        let mut angle = Angle::default();
        // Parents are larger than children: what several sums share is opened once, with all its coefficients added up.
        let mut pending = BTreeMap::from([(id, Number::ONE)]);
        while let Some((id, scale)) = pending.pop_last() {
            match graph.node(id) {
                Node::Number(value) => angle.constant = &angle.constant + &(value * &scale),
                Node::Sum { constant, terms } => {
                    angle.constant = &angle.constant + &(constant * &scale);
                    for (term, c) in terms {
                        let total = pending.entry(*term).or_insert(Number::ZERO);
                        *total = &*total + &(c * &scale);
                    }
                }
                _ => angle.add_part(id, &scale),
            }
        }
        self.written.get_or_insert_with(angle.clone(), || id);
        angle
    }

    /// An expression for a linear combination.
    pub(super) fn write(&mut self, graph: &mut Graph, angle: &Angle) -> ExprId {
        let sum = || graph.sum(angle.constant.clone(), angle.parts.iter().map(|(id, c)| (*id, c.clone())));
        *self.written.get_or_insert_with(angle.clone(), sum)
    }
}
