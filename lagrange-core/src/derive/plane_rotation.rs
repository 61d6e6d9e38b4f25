//! Plane rotations among the affine variables of a form.
//!
//! A joint turns by q, with c = cos q and s = sin q. Components along the axes of the turned body
//! are u₁ = c x₁ + s x₂ and u₂ = c x₂ − s x₁. This holds for its angular velocity and for the
//! velocity of its origin alike. If u₁ and u₂ were substituted separately, the coefficients of x₁
//! and x₂ would contain products with c², c s and s². Because of c² + s² = 1, five products suffice
//! for all three coefficients of a pair,
//!
//! ```text
//! ½ A u₁² + C u₁ u₂ + ½ B u₂² = ½ (A − s t) x₁² + (c t − C) x₁ x₂ + ½ (B + s t) x₂²,
//! t = s (A − B) + 2 c C,
//! ```
//!
//! and four for the four coefficients between two pairs. Rotational invariants remain unchanged: a
//! mass ½ m (v₁² + v₂²), and a moment of mass h (v₁ ω₂ − v₂ ω₁). The inertia of a composite body
//! therefore keeps ten coefficients of twenty-one.
//!
//! # In numbers
//!
//! Let c = 3/5, s = 4/5 and A = 7, B = 2, C = 5/2. Then t = 4/5 · 5 + 2 · 3/5 · 5/2 = 7. The new
//! coefficients are A − s t = 7/5, B + s t = 38/5 and c t − C = 17/10. The sum A + B is 9 on both
//! sides, and A B − C² = 31/4 as well.

use std::collections::BTreeSet;

use lagrange_expr::collections::{HashMap, OrderedMap};
use lagrange_expr::expr::{ExprId, Function, Graph, Node};
use lagrange_expr::number::Number;

/// Two variables that result from rotating two others: u₁ = c x₁ + s x₂ and u₂ = c x₂ − s x₁, up to
/// signs.
#[derive(Clone, Debug)]
pub(super) struct TurnedPair {
    pub(super) cosine: ExprId,
    pub(super) sine: ExprId,
    /// u₁ and u₂, each with its sign.
    pub(super) turned: [(ExprId, Number); 2],
    /// x₁ and x₂, each with its sign.
    pub(super) parts: [(ExprId, Number); 2],
}

impl TurnedPair {
    /// Returns the angle.
    pub(super) fn angle(&self, graph: &Graph) -> ExprId {
        match graph.node(self.cosine) {
            Node::Call(_, arguments) => arguments[0],
            _ => self.cosine,
        }
    }
}

/// A variable c x₁ + s x₂, up to signs.
#[derive(Clone, Copy, Debug)]
struct Component {
    id: ExprId,
    cosine: ExprId,
    sine: ExprId,
    /// Factor of the cosine, and true if the product is subtracted.
    along: (ExprId, bool),
    /// Factor of the sine, and true if the product is subtracted.
    across: (ExprId, bool),
}

/// Finds all turned pairs among variables with given parts. The multiples in a pair must not be
/// used by any other variable.
pub(super) fn turned_pairs(
    graph: &Graph,
    variables: &[ExprId],
    parts_of: impl Fn(ExprId) -> Vec<(ExprId, ExprId)>,
    is_only_part: impl Fn(ExprId) -> bool,
) -> Vec<TurnedPair> {
    let mut components: OrderedMap<(ExprId, ExprId, ExprId), Component> = OrderedMap::default();
    for &id in variables {
        if let Some(component) = component(graph, id, &parts_of, &is_only_part) {
            let Component { cosine, along, across, .. } = component;
            components.get_or_insert_with((cosine, along.0, across.0), || component);
        }
    }
    let partner = |one: &Component| components.get(&(one.cosine, one.across.0, one.along.0));
    let pairs = components.iter().filter_map(|(_, one)| Some((one, partner(one)?)));
    pairs.filter(|(one, other)| one.id < other.id).filter_map(|(one, other)| pair(one, other)).collect()
}

fn component(
    graph: &Graph,
    id: ExprId,
    parts_of: &impl Fn(ExprId) -> Vec<(ExprId, ExprId)>,
    is_only_part: &impl Fn(ExprId) -> bool,
) -> Option<Component> {
    let [first, second] = parts_of(id).try_into().ok()?;
    let multiples = [first, second].map(|(multiple, sign)| {
        let [(target, slope)] = parts_of(multiple).try_into().ok()?;
        let (coefficient, function) = graph.split_coefficient(slope);
        let sign = graph.as_number(sign)? * &coefficient;
        let is_unit = sign.abs().is_one() && is_only_part(multiple);
        is_unit.then_some((function, (target, sign.is_negative())))
    });
    let [Some((f, first)), Some((g, second))] = multiples else { return None };
    let argument = |id: ExprId| match graph.node(id) {
        Node::Call(function, arguments) => Some((*function, arguments[0])),
        _ => None,
    };
    let component = |cosine, along, sine, across| Component { id, cosine, sine, along, across };
    let found = match [argument(f)?, argument(g)?] {
        [(Function::Cos, a), (Function::Sin, b)] if a == b => component(f, first, g, second),
        [(Function::Sin, a), (Function::Cos, b)] if a == b => component(g, second, f, first),
        _ => return None,
    };
    (first.0 != second.0).then_some(found)
}

/// Returns the turned pair of u = α c x₁ + β s x₂ and u' = δ c x₂ + γ s x₁ if α γ = −β δ. It turns
/// α x₁ and β x₂, and u' is β δ times its second component.
fn pair(one: &Component, other: &Component) -> Option<TurnedPair> {
    let [alpha, beta] = [one.along.1, one.across.1];
    let [delta, gamma] = [other.along.1, other.across.1];
    let sign = |is_negative: bool| if is_negative { Number::MINUS_ONE } else { Number::ONE };
    let is_rotation = (alpha != gamma) != (beta != delta);
    is_rotation.then(|| TurnedPair {
        cosine: one.cosine,
        sine: one.sine,
        turned: [(one.id, Number::ONE), (other.id, sign(beta != delta))],
        parts: [(one.along.0, sign(alpha)), (one.across.0, sign(beta))],
    })
}

/// Pairs still to be turned, grouped by angle.
#[derive(Clone, Default, Debug)]
pub(super) struct PendingRotations {
    pairs: Vec<TurnedPair>,
    /// The pair of each variable that is turned.
    pair_of: HashMap<ExprId, usize>,
    /// Pairs with only one variable ready, with the rank of that variable.
    half_ready: HashMap<usize, usize>,
    /// Completed parts of each rotation, by the cosine of the angle.
    ready: HashMap<ExprId, ReadyRotation>,
    /// Rotations with ready pairs, in the order of application, the last one first.
    order: BTreeSet<(bool, usize, ExprId)>,
    /// True if rotations are postponed until nothing else is left.
    are_last: bool,
}

/// Pairs that are ready to be turned by an angle.
#[derive(Clone, Default, Debug)]
struct ReadyRotation {
    pairs: Vec<usize>,
    /// The number of pairs that have not been turned, ready or not.
    remaining: usize,
    /// The lowest rank of the variables of these pairs.
    rank: usize,
}

impl ReadyRotation {
    fn key(&self, cosine: ExprId) -> (bool, usize, ExprId) {
        (self.pairs.len() == self.remaining, self.rank, cosine)
    }
}

impl PendingRotations {
    pub(super) fn new(pairs: Vec<TurnedPair>, are_last: bool) -> PendingRotations {
        let ids =
            pairs.iter().enumerate().flat_map(|(n, pair)| pair.turned.iter().map(move |(id, _)| (*id, n)));
        let pair_of = ids.collect();
        let mut ready: HashMap<ExprId, ReadyRotation> = HashMap::default();
        pairs.iter().for_each(|pair| ready.get_or_insert_with(pair.cosine, Default::default).remaining += 1);
        PendingRotations { pairs, pair_of, ready, are_last, ..PendingRotations::default() }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.pairs.is_empty()
    }

    /// True if a variable belongs to a pair.
    pub(super) fn contains(&self, id: ExprId) -> bool {
        self.pair_of.contains(&id)
    }

    /// Records that a variable of a pair may be substituted.
    pub(super) fn make_ready(&mut self, id: ExprId, rank: usize) {
        let Some(&pair) = self.pair_of.get(&id) else { return };
        let Some(other) = self.half_ready.remove(&pair) else {
            self.half_ready.insert(pair, rank);
            return;
        };
        let cosine = self.pairs[pair].cosine;
        let Some(rotation) = self.ready.get_mut(&cosine) else { return };
        self.order.remove(&rotation.key(cosine));
        let ranks = [rank, other].into_iter().chain((!rotation.pairs.is_empty()).then_some(rotation.rank));
        rotation.rank = ranks.min().unwrap_or(rank);
        rotation.pairs.push(pair);
        self.order.insert(rotation.key(cosine));
    }

    /// Returns the pairs to turn next, unless something else goes first. `highest` is the highest
    /// rank of the other variables that may be substituted. A rotation with pairs that are not
    /// ready waits for them as long as other variables remain.
    pub(super) fn take_next(&mut self, highest: Option<usize>) -> Option<Vec<TurnedPair>> {
        let &(is_complete, rank, cosine) = self.order.last()?;
        if highest.is_some_and(|highest| self.are_last || !is_complete || rank < highest) {
            return None;
        }
        self.order.pop_last();
        let rotation = self.ready.get_mut(&cosine)?;
        let pairs = std::mem::take(&mut rotation.pairs);
        rotation.remaining -= pairs.len();
        Some(pairs.into_iter().map(|pair| self.pairs[pair].clone()).collect())
    }
}

/// Returns the coefficients along x₁ and x₂ from those along u₁ and u₂: c p₁ − s p₂ and s p₁ + c
/// p₂.
pub(super) fn turned_back(
    graph: &mut Graph,
    [c, s]: [ExprId; 2],
    [first, second]: [ExprId; 2],
) -> [ExprId; 2] {
    let [cp, sp] = [c, s].map(|f| graph.multiply(f, first));
    let [cq, sq] = [c, s].map(|f| graph.multiply(f, second));
    [graph.subtract(cp, sq), graph.add(sp, cq)]
}

/// Returns the coefficients of products of the x, in rows, from those of products of the u in two
/// pairs. Each is a list of terms to be added up.
pub(super) fn turned_block(
    graph: &mut Graph,
    [c, s]: [ExprId; 2],
    [[a, b], [d, e]]: [[ExprId; 2]; 2],
) -> [[[ExprId; 2]; 2]; 2] {
    let (difference, total) = (graph.subtract(a, e), graph.add(b, d));
    let [along, across] = [graph.multiply(s, difference), graph.multiply(c, total)];
    let t = graph.add(along, across);
    let (st, ct) = (graph.multiply(s, t), graph.multiply(c, t));
    let opposite = [st, d, b].map(|id| graph.negate(id));
    [[[a, opposite[0]], [ct, opposite[1]]], [[ct, opposite[2]], [e, st]]]
}

#[cfg(test)]
mod tests;
