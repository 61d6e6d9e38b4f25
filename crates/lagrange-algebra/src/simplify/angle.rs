//! Angles as linear combinations, for adding and comparing them.

use std::collections::BTreeMap;
use std::rc::Rc;

use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{ExprId, Graph, Node};
use lagrange_expr::number::Number;

/// `constant + Σ coefficient · part`, without zero coefficients; parts are not sums.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) struct Angle {
    /// In ascending order. Angles of long chains have many parts, and sorted vectors are added in
    /// one pass.
    parts: Vec<(ExprId, Number)>,
    constant: Number,
}

/// sin or cos of an angle whose first coefficient is positive.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Wave {
    pub(super) is_sine: bool,
    pub(super) angle: Rc<Angle>,
}

/// Angles that have been read and written: each is expanded once and has a unique form.
#[derive(Default, Debug)]
pub struct Angles {
    read: HashMap<ExprId, Rc<Angle>>,
    written: HashMap<Rc<Angle>, ExprId>,
}

impl Default for Angle {
    fn default() -> Angle {
        Angle { parts: Vec::new(), constant: Number::ZERO }
    }
}

impl Angle {
    pub(super) fn plus(&self, other: &Angle) -> Angle {
        self.plus_scaled(other, &Number::ONE)
    }

    pub(super) fn minus(&self, other: &Angle) -> Angle {
        self.plus_scaled(other, &Number::MINUS_ONE)
    }

    pub(super) fn scaled(&self, scale: &Number) -> Angle {
        Angle::default().plus_scaled(self, scale)
    }

    /// Returns `self + scale · other` for a nonzero scale.
    fn plus_scaled(&self, other: &Angle, scale: &Number) -> Angle {
        let mut parts = Vec::with_capacity(self.parts.len() + other.parts.len());
        let mut added = other.parts.iter().peekable();
        for (part, coefficient) in &self.parts {
            while let Some((before, c)) = added.next_if(|(other, _)| other < part) {
                parts.push((*before, c * scale));
            }
            let same = added.next_if(|(other, _)| other == part);
            let total = same.map_or_else(|| coefficient.clone(), |(_, c)| coefficient + &(c * scale));
            if !total.is_zero() {
                parts.push((*part, total));
            }
        }
        parts.extend(added.map(|(part, c)| (*part, c * scale)));
        Angle { parts, constant: &self.constant + &(&other.constant * scale) }
    }

    fn is_zero(&self) -> bool {
        self.parts.is_empty() && self.constant.is_zero()
    }

    /// True if the first coefficient is negative.
    fn is_reversed(&self) -> bool {
        self.parts.first().map_or(&self.constant, |(_, coefficient)| coefficient).is_negative()
    }
}

impl Wave {
    /// Returns cos 0.
    pub(super) fn one() -> Wave {
        Wave { is_sine: false, angle: Rc::default() }
    }

    /// Returns sin or cos of any angle, with the resulting coefficient.
    pub(super) fn signed(is_sine: bool, angle: Angle, coefficient: Number) -> (Wave, Number) {
        if !angle.is_reversed() {
            return (Wave { is_sine, angle: Rc::new(angle) }, coefficient);
        }
        let coefficient = if is_sine { -&coefficient } else { coefficient };
        (Wave { is_sine, angle: Rc::new(angle.scaled(&Number::MINUS_ONE)) }, coefficient)
    }

    /// True if this is cos 0.
    pub(super) fn is_one(&self) -> bool {
        !self.is_sine && self.angle.is_zero()
    }

    /// True if this is sin 0.
    pub(super) fn is_zero(&self) -> bool {
        self.is_sine && self.angle.is_zero()
    }
}

impl Angles {
    /// Returns an expression as a linear combination.
    pub(super) fn read(&mut self, graph: &Graph, id: ExprId) -> Rc<Angle> {
        if let Some(known) = self.read.get(&id) {
            return known.clone();
        }
        let angle = Rc::new(opened(graph, id));
        self.read.insert(id, angle.clone());
        self.written.get_or_insert_with(angle.clone(), || id);
        angle
    }

    /// Returns the expression of a linear combination.
    pub(super) fn write(&mut self, graph: &mut Graph, angle: &Rc<Angle>) -> ExprId {
        let sum = || graph.sum(angle.constant.clone(), angle.parts.iter().cloned());
        *self.written.get_or_insert_with(angle.clone(), sum)
    }
}

/// Expands an expression to a linear combination of parts that are not sums.
fn opened(graph: &Graph, id: ExprId) -> Angle {
    let mut angle = Angle::default();
    // Parents are larger than children, so shared parts of sums are expanded once, with all their
    // coefficients added up.
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
            _ if !scale.is_zero() => angle.parts.push((id, scale)),
            _ => {}
        }
    }
    angle.parts.reverse();
    angle
}
