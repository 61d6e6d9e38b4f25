//! Short chains in the programs of a step.
//!
//! Each order depends on the previous one, so the time of an expansion is that of the longest chain
//! of operations through a step. All results of a step are linear in sums and in coefficients of
//! earlier steps, with factors of order zero. Such factors are multiplied together before the first
//! step, and powers of k + 1 in parallel with the chain. A factor k + 1 of an integral cancels.
//!
//! # In numbers
//!
//! Let F = (k+1) m (l x + n y) with x = p + v i, where i = u/(k+1). Its longest chain has four
//! products and two sums. If it is written as (k+1)(m l) p + (m l v) u + (k+1)(m n) y, the chain is
//! one product and two sums.

use super::slots::{Slot, Slots};
use crate::program::{Builder, Op, Program, ValueId, ValueTable};
use lagrange_expr::collections::{HashMap, OrderedMap};
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;

/// Maximum number of terms of a value that is not computed separately.
const MAX_TERMS: usize = 8;
/// Maximum number of repeated products of a value with several uses.
const MAX_REPEATED: usize = 4;

/// A number of order zero times a power of k + 1.
#[derive(Clone, Copy, Debug)]
struct Factor {
    /// Value in the program of factors.
    at_start: ValueId,
    /// Power of k + 1.
    power: i32,
}

/// A multiple of a value of the new program.
#[derive(Clone, Copy, Debug)]
struct Term {
    of: ValueId,
    factor: Factor,
}

/// A value of the old program.
#[derive(Clone, Debug)]
enum Image {
    Factor(Factor),
    Sum(Vec<Term>),
}

/// Factors that programs of a step use and that are computed at the start.
#[derive(Default)]
pub(super) struct Factors {
    builder: Builder,
    used: OrderedMap<ValueId, ()>,
}

impl Factors {
    /// Returns the program that computes all factors from initial values.
    pub(super) fn program(self) -> Program {
        let used = self.used.iter().map(|(value, ())| *value).collect::<Vec<_>>();
        self.builder.finish(&used)
    }
}

/// A program of a step under construction.
struct Flattening<'a> {
    slots: &'a mut Slots,
    /// Number of initial values, which factors come after.
    initials: usize,
    factors: &'a mut Factors,
    builder: Builder,
    images: ValueTable<Image>,
    /// Length of the longest chain of operations before each value of the new program.
    depths: HashMap<ValueId, u32>,
    /// The slots that are divided by k + 1.
    integrals: HashMap<ValueId, Slot>,
}

/// Returns a program with the same outputs and shorter chains.
pub(super) fn flatten(
    program: &Program,
    slots: &mut Slots,
    initials: usize,
    factors: &mut Factors,
) -> Program {
    let (builder, depths, integrals) = (Builder::new(), HashMap::default(), HashMap::default());
    let images = ValueTable::with_capacity(program.len());
    let mut flattening = Flattening { slots, initials, factors, builder, images, depths, integrals };
    let uses = program.uses();
    for (id, op) in program.values() {
        let image = flattening.image(op);
        let image = flattening.limited(image, uses[id]);
        flattening.images.push(image);
    }
    let outputs = program.outputs().iter().map(|&output| flattening.value_of(output)).collect::<Vec<_>>();
    flattening.builder.finish(&outputs)
}

impl Flattening<'_> {
    fn image(&mut self, op: &Op) -> Image {
        match *op {
            Op::Input(role) => self.input(role),
            Op::Constant(_) | Op::Float(_) => {
                Image::Factor(Factor { at_start: self.factors.builder.push(op.clone()), power: 0 })
            }
            Op::Add(a, b) => self.sum(a, b, Number::ONE),
            Op::Subtract(a, b) => self.sum(a, b, Number::MINUS_ONE),
            Op::Negate(a) => {
                let factor = self.number(Number::MINUS_ONE);
                self.scaled(a, factor)
            }
            Op::Multiply(a, b) => match (&self.images[a], &self.images[b]) {
                (&Image::Factor(factor), _) => self.scaled(b, factor),
                (_, &Image::Factor(factor)) => self.scaled(a, factor),
                _ => self.copied(op),
            },
            _ => self.copied(op),
        }
    }

    fn input(&mut self, role: Role) -> Image {
        let slot = self.slots.of(role);
        let power = match slot {
            Some(Slot::Order) => 1,
            Some(Slot::Reciprocal) => -1,
            Some(Slot::Initial(_)) => {
                return Image::Factor(Factor {
                    at_start: self.factors.builder.push(Op::Input(role)),
                    power: 0,
                });
            }
            _ => {
                let of = self.builder.push(Op::Input(role));
                self.depths.insert(of, slot.map_or(0, depth));
                if let Some(dividend) = slot.and_then(Slot::dividend) {
                    self.integrals.insert(of, dividend);
                }
                return self.single(of);
            }
        };
        Image::Factor(Factor { power, ..self.number(Number::ONE) })
    }

    /// Returns the image of a value that is computed separately.
    fn single(&mut self, of: ValueId) -> Image {
        Image::Sum(vec![Term { of, factor: self.number(Number::ONE) }])
    }

    fn number(&mut self, number: Number) -> Factor {
        Factor { at_start: self.factors.builder.constant(number), power: 0 }
    }

    /// Returns the image of an operation on new values. It is computed before the first step if
    /// these are known by then.
    fn copied(&mut self, op: &Op) -> Image {
        let mut is_known = true;
        op.for_each_operand(|operand| is_known &= self.at_start(operand).is_some());
        if is_known {
            let op = op.map_operands(|operand| self.at_start(operand).unwrap_or(operand));
            return Image::Factor(Factor { at_start: self.factors.builder.push(op), power: 0 });
        }
        let mut operands = Vec::new();
        op.for_each_operand(|operand| operands.push(operand));
        let depth = operands.iter().map(|&operand| self.value_of(operand)).collect::<Vec<_>>();
        let depth = depth.iter().map(|of| self.depth_of(*of)).max().unwrap_or(0) + 1;
        let op = op.map_operands(|operand| self.value_of(operand));
        let of = self.builder.push(op);
        self.depths.insert(of, depth);
        self.single(of)
    }

    fn at_start(&self, of: ValueId) -> Option<ValueId> {
        match self.images[of] {
            Image::Factor(Factor { at_start, power: 0 }) => Some(at_start),
            _ => None,
        }
    }

    fn scaled(&mut self, of: ValueId, by: Factor) -> Image {
        match self.images[of].clone() {
            Image::Factor(factor) => Image::Factor(self.product(factor, by)),
            Image::Sum(mut terms) => {
                terms.iter_mut().for_each(|term| *term = self.multiplied(*term, by));
                Image::Sum(terms)
            }
        }
    }

    /// Returns a multiple of a term, where k + 1 times an integral is what was integrated.
    fn multiplied(&mut self, term: Term, by: Factor) -> Term {
        let factor = self.product(term.factor, by);
        match self.integrals.get(&term.of) {
            Some(&dividend) if factor.power > 0 => {
                let of = self.slots.input(&mut self.builder, dividend);
                self.depths.insert(of, depth(dividend));
                Term { of, factor: Factor { power: factor.power - 1, ..factor } }
            }
            _ => Term { factor, ..term },
        }
    }

    fn product(&mut self, a: Factor, b: Factor) -> Factor {
        let at_start = self.factors.builder.multiply(a.at_start, b.at_start);
        Factor { at_start, power: a.power + b.power }
    }

    /// Returns a + `sign` b.
    fn sum(&mut self, a: ValueId, b: ValueId, sign: Number) -> Image {
        let sign = self.number(sign);
        let b = self.scaled(b, sign);
        match (self.images[a].clone(), b) {
            (Image::Factor(a), Image::Factor(b)) if a.power == b.power => {
                let at_start = self.factors.builder.add(a.at_start, b.at_start);
                Image::Factor(Factor { at_start, power: a.power })
            }
            (a, b) => {
                let mut terms = self.terms(a);
                for term in self.terms(b) {
                    self.add(&mut terms, term);
                }
                Image::Sum(terms)
            }
        }
    }

    fn terms(&mut self, image: Image) -> Vec<Term> {
        match image {
            Image::Factor(factor) => {
                let of = self.builder.constant(Number::ONE);
                vec![Term { of, factor }]
            }
            Image::Sum(terms) => terms,
        }
    }

    fn add(&mut self, terms: &mut Vec<Term>, term: Term) {
        let like = |known: &&mut Term| known.of == term.of && known.factor.power == term.factor.power;
        match terms.iter_mut().find(like) {
            Some(known) => {
                let both = [known.factor.at_start, term.factor.at_start];
                known.factor.at_start = self.factors.builder.add(both[0], both[1]);
            }
            None => terms.push(term),
        }
    }

    /// Returns the image of a value, which is computed separately if this makes its uses cheaper.
    fn limited(&mut self, image: Image, uses: usize) -> Image {
        match image {
            Image::Sum(terms) if is_long(&terms, uses) => {
                let of = self.total(&terms);
                self.single(of)
            }
            image => image,
        }
    }

    fn value_of(&mut self, old: ValueId) -> ValueId {
        match self.images[old].clone() {
            Image::Factor(factor) => self.written(factor),
            Image::Sum(terms) => self.total(&terms),
        }
    }

    /// Writes a factor in the new program.
    fn written(&mut self, factor: Factor) -> ValueId {
        let op = self.factors.builder.op(factor.at_start);
        let mut value = match op.is_constant() {
            true => self.builder.push(op.clone()),
            false => {
                let place = self.factors.used.index_or_insert_with(factor.at_start, || ());
                self.slots.input(&mut self.builder, Slot::Initial(self.initials + place))
            }
        };
        let slot = if factor.power > 0 { Slot::Order } else { Slot::Reciprocal };
        for _ in 0..factor.power.unsigned_abs() {
            let power = self.slots.input(&mut self.builder, slot);
            value = self.builder.multiply(power, value);
        }
        value
    }

    fn depth_of(&self, value: ValueId) -> u32 {
        self.depths.get(&value).copied().unwrap_or(0)
    }

    /// Adds up terms in the order in which they become known.
    fn total(&mut self, terms: &[Term]) -> ValueId {
        let mut pending = terms.iter().map(|term| self.multiple(*term)).collect::<Vec<_>>();
        let first = |pending: &mut Vec<(u32, ValueId)>| {
            let place = (0..pending.len()).min_by_key(|&place| pending[place].0)?;
            Some(pending.remove(place))
        };
        while let Some((_, one)) = first(&mut pending) {
            let Some((depth, other)) = first(&mut pending) else { return one };
            let sum = self.builder.add(one, other);
            self.depths.insert(sum, depth + 1);
            pending.push((depth + 1, sum));
        }
        self.builder.constant(Number::ZERO)
    }

    fn multiple(&mut self, term: Term) -> (u32, ValueId) {
        let factor = self.written(term.factor);
        let value = self.builder.multiply(factor, term.of);
        let depth = self.depth_of(term.of) + u32::from(value != term.of);
        self.depths.insert(value, depth);
        (depth, value)
    }
}

/// True if a value with this number of uses is cheaper if computed separately.
fn is_long(terms: &[Term], uses: usize) -> bool {
    let repeated = uses.saturating_sub(1) * terms.len().saturating_sub(1);
    terms.len() > MAX_TERMS || repeated > MAX_REPEATED
}

/// Returns the number of operations before an input: sums contain the newest coefficients.
fn depth(slot: Slot) -> u32 {
    match slot {
        Slot::Sum(_) | Slot::Acceleration(_) | Slot::Velocity(_) => 3,
        Slot::Integral(_) => 1,
        _ => 0,
    }
}
