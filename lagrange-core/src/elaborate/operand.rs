//! Scalars and vectors, and the operations of the language on them.

use lagrange_expr::expr::{ExprId, Function, Graph};
use lagrange_expr::functions;
use lagrange_expr::number::Number;

/// The value of an expression of the language.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Operand {
    Scalar(ExprId),
    /// Two or three components.
    Vector(Vec<ExprId>),
}

impl Operand {
    /// One component for a scalar, all of them for a vector.
    pub(super) fn components(&self) -> &[ExprId] {
        match self {
            Operand::Scalar(id) => std::slice::from_ref(id),
            Operand::Vector(components) => components,
        }
    }

    /// Operand of the same kind with every component mapped.
    pub(super) fn map(&self, mut f: impl FnMut(ExprId) -> ExprId) -> Operand {
        match self {
            Operand::Scalar(id) => Operand::Scalar(f(*id)),
            Operand::Vector(components) => Operand::Vector(components.iter().map(|&id| f(id)).collect()),
        }
    }

    /// Description in the user's words.
    pub(super) fn kind(&self) -> String {
        match self {
            Operand::Scalar(_) => "a scalar".to_owned(),
            Operand::Vector(components) => format!("a vector of {} components", components.len()),
        }
    }

    /// True if both are scalars or vectors of the same length.
    pub(super) fn same_kind(&self, other: &Operand) -> bool {
        match (self, other) {
            (Operand::Scalar(_), Operand::Scalar(_)) => true,
            (Operand::Vector(a), Operand::Vector(b)) => a.len() == b.len(),
            _ => false,
        }
    }
}

/// Σ aᵢ·bᵢ
pub(super) fn inner(graph: &mut Graph, a: &[ExprId], b: &[ExprId]) -> ExprId {
    let products = a.iter().zip(b).map(|(&a, &b)| graph.multiply(a, b)).collect::<Vec<_>>();
    graph.total(products)
}

/// Σ aᵢ²
pub(super) fn norm_squared(graph: &mut Graph, a: &[ExprId]) -> ExprId {
    inner(graph, a, a)
}

/// (Σ aᵢ²)^½, without a root where all components but one are zero.
pub(super) fn norm(graph: &mut Graph, a: &[ExprId]) -> ExprId {
    let others = a.iter().copied().filter(|&component| !graph.is_zero(component)).collect::<Vec<_>>();
    match others.as_slice() {
        [] => graph.number(0),
        &[single] => functions::apply(graph, Function::Abs, &[single]),
        _ => {
            let square = norm_squared(graph, a);
            functions::apply(graph, Function::Sqrt, &[square])
        }
    }
}

/// a × b: the out-of-plane component for plane vectors, a vector in space.
pub(super) fn cross(graph: &mut Graph, a: &[ExprId], b: &[ExprId]) -> Operand {
    let mut minor = |i: usize, j: usize| {
        let (forward, backward) = (graph.multiply(a[i], b[j]), graph.multiply(a[j], b[i]));
        graph.subtract(forward, backward)
    };
    match a.len() {
        2 => Operand::Scalar(minor(0, 1)),
        _ => Operand::Vector(vec![minor(1, 2), minor(2, 0), minor(0, 1)]),
    }
}

/// ½·weight·Σ aᵢ²
pub(super) fn half_square(graph: &mut Graph, weight: ExprId, a: &[ExprId]) -> ExprId {
    let square = norm_squared(graph, a);
    let product = graph.multiply(weight, square);
    graph.scale(Number::HALF, product)
}

/// An operand of the kind of `like` with these components.
pub(super) fn rebuild(like: &Operand, components: Vec<ExprId>) -> Operand {
    match like {
        Operand::Scalar(_) => Operand::Scalar(components[0]),
        Operand::Vector(_) => Operand::Vector(components),
    }
}
