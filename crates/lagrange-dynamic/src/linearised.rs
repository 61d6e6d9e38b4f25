//! Derivatives of interpreted systems for equilibria and linear models.

use lagrange_runtime::constraint::ConstrainedSystem;
use lagrange_runtime::system::{LinearisedSystem, MatrixLayout};

use crate::inline::Inline;
use crate::system::DynamicSystem;

/// The matrix is NaN unless the declaration has `emit { system_matrix }`.
impl<const CAPACITY: usize> LinearisedSystem for DynamicSystem<CAPACITY> {
    type Row = Vec<f64>;
    type SystemMatrix = Vec<Vec<f64>>;

    const LAYOUT: MatrixLayout =
        MatrixLayout { inputs: &[], outputs: &[], constraints: &[], are_holonomic: &[] };

    fn layout(&self) -> MatrixLayout {
        self.names.layout
    }

    fn system_matrix(&self, t: f64, y: &Inline<CAPACITY>) -> Vec<Vec<f64>> {
        let (layout, states) = (&self.programs().layout, self.names.description.first_order_states);
        let columns = 2 * layout.velocities + states + layout.inputs;
        let rows = columns - layout.inputs + self.names.layout.outputs.len() + layout.multipliers;
        match &self.programs().system_matrix {
            Some(program) => self.evaluate(program, t, y).chunks(columns).map(<[f64]>::to_vec).collect(),
            None => vec![vec![f64::NAN; columns]; rows],
        }
    }

    fn residuals(&self, t: f64, q: &Inline<CAPACITY>, v: &Inline<CAPACITY>) -> [impl AsRef<[f64]>; 2] {
        [self.position_residuals(t, q), self.velocity_residuals(t, q, v)]
    }
}
