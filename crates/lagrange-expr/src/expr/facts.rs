//! Facts about every expression from its construction on.

use std::ops::BitOr;

use super::{ExprId, Function, Graph, Node};
use crate::elementary::{Domain, row};
use crate::number::Number;
use crate::symbol::Role;

/// The kinds of symbols in an expression.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Dependencies(u16);

impl Dependencies {
    /// Depends on nothing.
    pub const NONE: Dependencies = Dependencies(0);
    /// Depends on a parameter.
    pub const PARAMETER: Dependencies = Dependencies(1);
    /// Depends on an input.
    pub const INPUT: Dependencies = Dependencies(2);
    /// Depends on time.
    pub const TIME: Dependencies = Dependencies(4);
    /// Depends on a coordinate.
    pub const COORDINATE: Dependencies = Dependencies(8);
    /// Depends on a velocity.
    pub const VELOCITY: Dependencies = Dependencies(16);
    /// Depends on an acceleration.
    pub const ACCELERATION: Dependencies = Dependencies(32);
    /// Depends on a multiplier.
    pub const MULTIPLIER: Dependencies = Dependencies(128);
    /// Depends on the force of a contact or of friction.
    pub const REACTION: Dependencies = Dependencies(256);
    /// Depends on a first-order state.
    pub const STATE: Dependencies = Dependencies(512);
    /// Depends on a discrete state.
    pub const DISCRETE: Dependencies = Dependencies(1024);
    /// Depends on a white noise.
    pub const NOISE: Dependencies = Dependencies(2048);
    /// Contains a place holder of an unfinished computation.
    pub const PLACEHOLDER: Dependencies = Dependencies(64);

    /// Returns these and the kinds of `other`.
    pub const fn with(self, other: Dependencies) -> Dependencies {
        Dependencies(self.0 | other.0)
    }

    /// True if any kind of `other` is among these.
    pub fn intersects(self, other: Dependencies) -> bool {
        self.0 & other.0 != 0
    }

    /// True if every kind is among those of `other`.
    pub fn is_within(self, other: Dependencies) -> bool {
        self.0 & !other.0 == 0
    }

    /// True if the value never changes during a motion.
    pub fn is_constant_in_motion(self) -> bool {
        self.is_within(Dependencies::PARAMETER)
    }

    /// True if the value may change during a motion with unchanged inputs: with time or the state.
    pub fn may_change(self) -> bool {
        !self.is_within(Dependencies::PARAMETER | Dependencies::INPUT)
    }

    fn of_role(role: Role) -> Dependencies {
        match role {
            Role::Parameter(_) => Dependencies::PARAMETER,
            Role::Input(_) => Dependencies::INPUT,
            Role::Noise(_) => Dependencies::NOISE,
            Role::Time => Dependencies::TIME,
            Role::Coordinate(_) => Dependencies::COORDINATE,
            Role::State(_) => Dependencies::STATE,
            Role::Discrete(_) => Dependencies::DISCRETE,
            // The side may depend on everything that the state depends on.
            Role::Velocity(_) | Role::Side(_) => Dependencies::VELOCITY,
            Role::Acceleration(_) => Dependencies::ACCELERATION,
            Role::Multiplier(_) => Dependencies::MULTIPLIER,
            Role::Reaction(_) => Dependencies::REACTION,
            Role::Operand(_) | Role::Placeholder(_) => Dependencies::PLACEHOLDER,
        }
    }
}

impl BitOr for Dependencies {
    type Output = Dependencies;
    fn bitor(self, other: Dependencies) -> Dependencies {
        self.with(other)
    }
}

/// Facts about one expression.
#[derive(Clone, Debug)]
pub(super) struct Facts {
    pub(super) dependencies: Dependencies,
    pub(super) nonnegative: bool,
    pub(super) partial: bool,
    /// Names, numbers and function signs of the written-out expression. It saturates: the text of a
    /// graph can be exponentially long.
    pub(super) written_size: u64,
    /// Every x for which the slope s of |x| is a factor with an odd exponent. This may be in |x| =
    /// s x, or in x = s |x| beside other terms with s.
    pub(super) slopes: Box<[ExprId]>,
}

impl Facts {
    pub(super) fn of(graph: &Graph, node: &Node) -> Facts {
        let mut dependencies = match node {
            Node::Symbol(symbol) => Dependencies::of_role(graph.symbols.get(*symbol).role),
            // The value is only known at run time.
            Node::Opaque(function, _) if function.table().is_none() => Dependencies::PARAMETER,
            _ => Dependencies::NONE,
        };
        node.for_each_child(|child| dependencies = dependencies | graph.dependencies(child));
        Facts {
            dependencies,
            nonnegative: is_nonnegative(graph, node),
            partial: is_partial(graph, node),
            written_size: written_size(graph, node),
            slopes: slopes(graph, node).into(),
        }
    }
}

fn is_nonnegative(graph: &Graph, node: &Node) -> bool {
    let known = |id: &ExprId| graph.is_nonnegative(*id);
    match node {
        Node::Number(value) => !value.is_negative(),
        Node::Pi => true,
        Node::Symbol(_) | Node::Opaque(..) => false,
        Node::Sum { constant, terms } => {
            !constant.is_negative() && terms.iter().all(|(term, c)| !c.is_negative() && known(term))
        }
        // A power with a fractional exponent is a principal root: never negative.
        Node::Product(factors) => factors.iter().all(|(base, exponent): &(ExprId, Number)| {
            exponent.is_even() || !exponent.is_integer() || known(base)
        }),
        Node::Call(Function::Max, arguments) => arguments.iter().any(known),
        Node::Call(Function::Min, arguments) => arguments.iter().all(known),
        Node::Call(function, _) => row(*function).is_nonnegative,
        Node::Choose { then, otherwise, .. } => known(then) && known(otherwise),
    }
}

/// True if a function in it restricts an argument that may be outside its domain.
fn is_partial(graph: &Graph, node: &Node) -> bool {
    let unknown = |id: &ExprId| !graph.is_nonnegative(*id);
    let is_own = match node {
        Node::Product(factors) => factors.iter().any(|(base, power)| !power.is_integer() && unknown(base)),
        Node::Call(function, arguments) => match row(*function).domain {
            Domain::Everywhere | Domain::AwayFrom(_) => false,
            Domain::FromZero | Domain::AboveZero | Domain::BaseAboveZero => unknown(&arguments[0]),
            Domain::WithinOne => true,
        },
        _ => false,
    };
    let mut is_partial = is_own;
    node.for_each_child(|child| is_partial |= graph.is_partial(child));
    is_partial
}

fn written_size(graph: &Graph, node: &Node) -> u64 {
    let shown = |weights: &[(ExprId, Number)], shows: fn(&Number) -> bool| {
        weights.iter().filter(|(_, weight)| shows(weight)).count() as u64
    };
    let mut size = match node {
        Node::Sum { constant, terms } => u64::from(!constant.is_zero()) + shown(terms, |c| !c.abs().is_one()),
        Node::Product(factors) => shown(factors, |exponent| !exponent.is_one()),
        _ => 1,
    };
    node.for_each_child(|child| size = size.saturating_add(graph.written_size(child)));
    size
}

fn slopes(graph: &Graph, node: &Node) -> Vec<ExprId> {
    match node {
        Node::Call(Function::MagnitudeSlope | Function::Abs, arguments) => vec![arguments[0]],
        Node::Product(factors) => {
            let odd = factors.iter().filter(|(_, exponent)| exponent.is_odd());
            odd.flat_map(|(base, _)| graph.slope_factors(*base)).copied().collect()
        }
        Node::Sum { constant, terms } if constant.is_zero() => {
            let slopes = terms.iter().flat_map(|(term, _)| graph.slope_factors(*term)).copied();
            let mut slopes = slopes.filter(|&of| is_slope_of_sum(graph, terms, of)).collect::<Vec<_>>();
            slopes.sort_unstable();
            slopes.dedup();
            slopes
        }
        _ => Vec::new(),
    }
}

fn is_slope_of_sum(graph: &Graph, terms: &[(ExprId, Number)], of: ExprId) -> bool {
    let has_slope = |term: ExprId| graph.slope_factors(term).contains(&of);
    // The test that mostly fails at one of the first terms of a large sum comes first.
    terms.iter().all(|(term, _)| has_slope(*term) || graph.has_odd_power(*term, of))
        // In |x| − x = s (x − |x|) the factor would be extracted repeatedly.
        && (terms.iter().all(|(term, _)| has_slope(*term))
            || terms.iter().any(|(term, _)| graph.has_bare_slope(*term, of)))
}
