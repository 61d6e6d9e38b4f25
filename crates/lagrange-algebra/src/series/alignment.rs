//! Products of parts that a system repeats, such as pairs of planets, lane by lane.
//!
//! The values between sums and factors are computed number by number. If each lane of a group
//! belongs to one of four like parts, they are the same in all lanes. Compilers then perform them
//! side by side. Otherwise, moving numbers between lanes takes most of the time of an
//! order.
//!
//! # Three distances
//!
//! Let r = √(x² + y²) for each of four points. The four products r r are alike, so they form a
//! group. Their factors are computed from sums of x x and y y, which therefore also form groups,
//! with the same point in each lane. If these were chosen by themselves, x and y could be in any
//! order, since they are alike too.

use std::mem::{Discriminant, discriminant};

use super::SeriesPrograms;
use super::slots::Slot;
use crate::program::{Op, ValueId, ValueTable};
use lagrange_expr::collections::{HashMap, HashSet, OrderedMap};
use lagrange_expr::symbol::Role;

/// Number of products in a group.
pub(super) const GROUP: usize = 4;
/// Number of products through which values must be computed alike.
const ROUNDS: usize = 3;

/// At most four products, as shared factor, other factor and index.
pub(super) type Group = Vec<(usize, usize, usize)>;

/// Returns groups of products of like parts. Other products are in no group.
pub(super) fn aligned(programs: &SeriesPrograms) -> Vec<Group> {
    let mut alignment = Alignment::new(programs);
    for class in alignment.classes() {
        alignment.group(&class);
        alignment.combine_sides();
    }
    alignment.groups
}

/// Groups under construction.
struct Alignment<'a> {
    programs: &'a SeriesPrograms,
    /// For each kept value, a number that is equal for values computed alike.
    colours: Vec<usize>,
    indices: HashMap<[usize; 2], usize>,
    /// The products with each kept value.
    products_of: Vec<Vec<usize>>,
    is_grouped: Vec<bool>,
    groups: Vec<Group>,
    /// Factors that are in the lanes of a group, and whether groups share them.
    sides: OrderedMap<Vec<usize>, bool>,
    /// Values of four parts that were followed to their operands.
    followed: HashSet<Vec<ValueId>>,
}

impl<'a> Alignment<'a> {
    fn new(programs: &'a SeriesPrograms) -> Alignment<'a> {
        let mut products_of = vec![Vec::new(); programs.kept];
        for (product, &[a, b]) in programs.sums.iter().enumerate() {
            products_of[a].push(product);
            if a != b {
                products_of[b].push(product);
            }
        }
        Alignment {
            programs,
            colours: colours(programs),
            indices: programs.sums.iter().enumerate().map(|(index, factors)| (*factors, index)).collect(),
            products_of,
            is_grouped: vec![false; programs.sums.len()],
            groups: Vec::new(),
            sides: OrderedMap::default(),
            followed: HashSet::default(),
        }
    }

    /// Returns the products of like factors, the smallest classes first. The products of the
    /// largest ones have several roles in a part.
    fn classes(&self) -> Vec<Vec<usize>> {
        let mut classes: OrderedMap<[usize; 2], Vec<usize>> = OrderedMap::default();
        for (product, factors) in self.programs.sums.iter().enumerate() {
            let mut colours = factors.map(|factor| self.colours[factor]);
            colours.sort_unstable();
            classes.get_or_insert_with(colours, Vec::new).push(product);
        }
        let mut classes = classes.iter().map(|(_, class)| class.clone()).collect::<Vec<_>>();
        classes.sort_by_key(Vec::len);
        classes
    }

    /// Groups like products and those from which their factors are computed.
    fn group(&mut self, class: &[usize]) {
        let mut lanes = Vec::new();
        for (place, &product) in class.iter().enumerate() {
            if !self.is_grouped[product] {
                lanes.push(product);
            }
            let is_last = place + 1 == class.len();
            if lanes.len() == GROUP || (is_last && lanes.len() > GROUP / 2) {
                self.follow(&lanes);
                lanes.clear();
            }
        }
    }

    fn follow(&mut self, products: &[usize]) {
        let mut pending = self.add(products);
        while let Some(values) = pending.pop() {
            let is_same = values.windows(2).all(|pair| pair[0] == pair[1]);
            if is_same || !self.followed.insert(values.clone()) {
                continue;
            }
            match values.iter().map(|&value| self.sum(value)).collect::<Option<Vec<_>>>() {
                Some(products) => pending.extend(self.add(&products)),
                None => pending.extend(self.operands(&values)),
            }
        }
    }

    /// Returns the product whose sum a value is.
    fn sum(&self, value: ValueId) -> Option<usize> {
        match slot(self.programs, self.programs.expansion.op(value)) {
            Some(Slot::Sum(product)) => Some(product),
            _ => None,
        }
    }

    /// Returns the operands of values in all lanes, in order, if the values are computed alike.
    fn operands(&self, values: &[ValueId]) -> Vec<Vec<ValueId>> {
        let ops = values.iter().map(|&value| self.programs.expansion.op(value)).collect::<Vec<_>>();
        let mut operands: Vec<Vec<ValueId>> = Vec::new();
        for op in &ops {
            let mut place = 0;
            op.for_each_operand(|operand| {
                operands.resize_with(operands.len().max(place + 1), Vec::new);
                operands[place].push(operand);
                place += 1;
            });
        }
        let are_alike = ops.iter().all(|op| discriminant(*op) == discriminant(ops[0]));
        operands.retain(|lanes| are_alike && lanes.len() == values.len());
        operands
    }

    /// Makes a group, and returns the values of both factors; nothing if a product has a group.
    fn add(&mut self, products: &[usize]) -> Vec<Vec<ValueId>> {
        let distinct = products.iter().collect::<HashSet<_>>();
        if distinct.len() < products.len() || products.iter().any(|&product| self.is_grouped[product]) {
            return Vec::new();
        }
        let first = self.programs.sums[products[0]].map(|factor| self.colours[factor]);
        let mut sides = [Vec::new(), Vec::new()];
        for &product in products {
            let [a, b] = self.programs.sums[product];
            let is_swapped =
                [b, a].map(|factor| self.colours[factor]) == first && self.colours[a] != first[0];
            let [a, b] = if is_swapped { [b, a] } else { [a, b] };
            sides[0].push(a);
            sides[1].push(b);
        }
        self.insert(products, &sides);
        let value_of = |&place: &usize| self.programs.expansion.outputs()[place];
        sides.iter().map(|side| side.iter().map(value_of).collect()).collect()
    }

    /// Makes a group whose factors are these. Groups share the more frequent factors.
    fn insert(&mut self, products: &[usize], sides: &[Vec<usize>; 2]) {
        let uses = |side: &Vec<usize>| {
            let is_shared = self.sides.get(side).is_some_and(|is_shared| *is_shared);
            (is_shared, self.products_of[side[0]].len())
        };
        let is_swapped = uses(&sides[1]) > uses(&sides[0]);
        let [shared, others] = if is_swapped { [&sides[1], &sides[0]] } else { [&sides[0], &sides[1]] };
        let lanes = shared.iter().zip(others).zip(products);
        self.groups.push(lanes.map(|((shared, other), product)| (*shared, *other, *product)).collect());
        self.sides.get_or_insert_with(others.clone(), || false);
        *self.sides.get_or_insert_with(shared.clone(), || true) = true;
        products.iter().for_each(|&product| self.is_grouped[product] = true);
    }

    /// Groups the products of factors that are in lanes already.
    fn combine_sides(&mut self) {
        let sides = self.sides.iter().map(|(side, _)| side.clone()).collect::<Vec<_>>();
        let mut starting: HashMap<usize, Vec<usize>> = HashMap::default();
        for (index, side) in sides.iter().enumerate() {
            starting.get_or_insert_with(side[0], Vec::new).push(index);
        }
        for side in &sides {
            for product in self.products_of[side[0]].clone() {
                let [a, b] = self.programs.sums[product];
                let other = if a == side[0] { b } else { a };
                for &other in starting.get(&other).into_iter().flatten() {
                    self.combine(side, &sides[other]);
                }
            }
        }
    }

    fn combine(&mut self, side: &[usize], other: &[usize]) {
        let product = |(&a, &b): (&usize, &usize)| {
            let product = *self.indices.get(&[a.min(b), a.max(b)])?;
            (!self.is_grouped[product]).then_some(product)
        };
        let products = side.iter().zip(other).map(product).collect::<Option<Vec<_>>>();
        let distinct = products.iter().flatten().collect::<HashSet<_>>().len();
        if let Some(products) = products.filter(|_| distinct == side.len() && other.len() == distinct) {
            self.insert(&products, &[side.to_vec(), other.to_vec()]);
        }
    }
}

/// An operation, the slot it reads, and numbers for its operands.
type Shape = (Discriminant<Op>, Option<Discriminant<Slot>>, Vec<usize>);

/// Returns, for each kept value, a number that is equal for values computed alike.
fn colours(programs: &SeriesPrograms) -> Vec<usize> {
    let mut of_kept = vec![0; programs.kept];
    for _ in 0..ROUNDS {
        let mut shapes: OrderedMap<Shape, ()> = OrderedMap::default();
        let mut of_values = ValueTable::with_capacity(programs.expansion.len());
        for (_, op) in programs.expansion.values() {
            let slot = slot(programs, op);
            let mut operands = slot.map_or(Vec::new(), |slot| of_slot(programs, slot, &of_kept));
            op.for_each_operand(|operand| operands.push(of_values[operand]));
            let shape = (discriminant(op), slot.as_ref().map(discriminant), operands);
            of_values.push(shapes.index_or_insert_with(shape, || ()));
        }
        let kept = &programs.expansion.outputs()[..programs.kept];
        of_kept = kept.iter().map(|&value| of_values[value]).collect();
    }
    of_kept
}

/// Returns the colours of the kept values that determine a slot.
fn of_slot(programs: &SeriesPrograms, slot: Slot, of_kept: &[usize]) -> Vec<usize> {
    let mut colours = match slot {
        Slot::Sum(product) => programs.sums[product].map(|factor| of_kept[factor]).to_vec(),
        Slot::Carried(carried) | Slot::Integral(carried) => vec![of_kept[programs.carried[carried].0]],
        _ => Vec::new(),
    };
    colours.sort_unstable();
    colours
}

/// Returns the slot that an operation reads.
fn slot(programs: &SeriesPrograms, op: &Op) -> Option<Slot> {
    match op {
        Op::Input(Role::Placeholder(index)) => programs.slots.get(*index as usize).copied(),
        _ => None,
    }
}

#[cfg(test)]
mod tests;
