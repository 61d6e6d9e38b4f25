//! Expressions on the current sides of the switches.

use crate::derive::{Switch, one_sided};
use lagrange_algebra::program::Labels;
use lagrange_expr::expr::{ExprId, Graph};

/// Expressions to be computed, with names for their parts.
pub struct NamedRoots {
    /// The expressions.
    pub roots: Vec<ExprId>,
    /// Names of parts of only these expressions. A name may denote different expressions in
    /// different methods, since each keeps its own domains.
    pub labels: Labels,
}

/// Returns expressions with the sides of switches as symbols. Replacements of named parts have the
/// same names.
pub fn on_sides(graph: &mut Graph, labels: &Labels, switches: &[Switch], roots: &[ExprId]) -> NamedRoots {
    let mut labels = labels.clone();
    if switches.is_empty() {
        return NamedRoots { roots: roots.to_vec(), labels };
    }
    let image = one_sided(graph, switches, roots);
    let names = labels.iter().filter_map(|(id, name)| Some((*image.get(&id)?, name.to_owned())));
    let names = names.collect::<Vec<_>>();
    names.into_iter().for_each(|(id, name)| labels.insert(id, name));
    let roots = roots.iter().map(|root| image.get(root).copied().unwrap_or(*root)).collect();
    NamedRoots { roots, labels }
}
