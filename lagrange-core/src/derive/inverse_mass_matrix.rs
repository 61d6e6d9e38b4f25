//! Products with the inverse of the mass matrix, and that inverse itself.

use super::cost::cost;
use super::elimination::order::{eliminate_dense, eliminate_recursive};
use super::forms::Forms;
use super::least_constraint::SplitLagrangian;
use super::sweep::Rotations;
use crate::model::Model;
use lagrange_expr::expr::{ExprId, Graph};

/// Maximum number of velocities for which a full matrix is tried although there is a recursion.
const LARGEST_TRIAL: usize = 20;

/// Returns M⁻¹ in rows, without constraints; `None` if M is structurally singular. Either half of
/// the columns determines it, and the cheaper one is kept, of the cheaper factorisation.
pub(super) fn inverse_mass_matrix(model: &mut Model, split: &SplitLagrangian) -> Option<Vec<ExprId>> {
    let count = model.speeds.len();
    let [zero, opposite] = [0, -1].map(|number| model.graph.number(number));
    let unit = |column| (0..count).map(|row| if row == column { opposite } else { zero }).collect();
    let units = (0..count).map(unit).collect::<Vec<Vec<_>>>();
    let mut forms = Forms::without_constraints(model, split);
    let found = solved_each_way(model, &mut forms, &units);
    let of_half = |columns: &[Vec<ExprId>], of: fn(usize, usize) -> usize| {
        let entry = |row: usize, column: usize| columns[of(row, column)][row + column - of(row, column)];
        (0..count).map(|row| (0..count).map(|column| entry(row, column)).collect()).collect::<Vec<Vec<_>>>()
    };
    let halves =
        found.iter().flat_map(|columns| [of_half(columns, usize::min), of_half(columns, usize::max)]);
    cheapest(&model.graph, halves.collect()).map(|rows| rows.concat())
}

/// Returns −M⁻¹ u for each u of `linear`, by each factorisation of M that is worth a trial. Forms
/// must be free of constraints.
pub(super) fn solved_each_way(
    model: &mut Model,
    forms: &mut Forms,
    linear: &[Vec<ExprId>],
) -> Vec<Vec<Vec<ExprId>>> {
    let velocities = model.velocities();
    if velocities.is_empty() {
        return vec![linear.to_vec()];
    }
    let form = forms.form.clone();
    let recursive = eliminate_recursive(&mut model.graph, form, &velocities, Rotations::Last);
    let mut ways = recursive.into_iter().collect::<Vec<_>>();
    if ways.is_empty() || velocities.len() <= LARGEST_TRIAL {
        let pushed = forms.pushed(model).clone();
        ways.extend(eliminate_dense(&mut model.graph, pushed, &velocities));
    }
    let graph = &mut model.graph;
    let found = ways.iter().map(|way| {
        let columns = linear.iter().map(|linear| way.solve_again(graph, linear, &velocities));
        columns.collect()
    });
    found.collect()
}

/// Returns the cheapest of several ways to compute the same vectors. In a tie, the first is kept.
pub(super) fn cheapest(graph: &Graph, ways: Vec<Vec<Vec<ExprId>>>) -> Option<Vec<Vec<ExprId>>> {
    let costs = ways.iter().map(|vectors| cost(graph, &vectors.concat())).collect::<Vec<_>>();
    let cheapest = costs.into_iter().zip(ways).min_by(|(one, _), (other, _)| one.total_cmp(other));
    cheapest.map(|(_, vectors)| vectors)
}
