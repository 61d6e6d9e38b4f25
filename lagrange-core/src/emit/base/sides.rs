//! Expressions on the sides of the switches that a system is on.

use crate::derive::{Switch, one_sided};
use lagrange_algebra::program::Labels;
use lagrange_expr::expr::{ExprId, Graph};

/// Returns expressions with the sides of switches as symbols; names move to the replacements of
/// their owners.
pub fn on_sides(
    graph: &mut Graph,
    labels: &mut Labels,
    switches: &[Switch],
    roots: &[ExprId],
) -> Vec<ExprId> {
    if switches.is_empty() {
        return roots.to_vec();
    }
    let image = one_sided(graph, switches, roots);
    let names = labels.iter().filter_map(|(id, name)| Some((*image.get(&id)?, name.to_owned())));
    let names = names.collect::<Vec<_>>();
    names.into_iter().for_each(|(id, name)| labels.insert(id, name));
    roots.iter().map(|root| image.get(root).copied().unwrap_or(*root)).collect()
}
