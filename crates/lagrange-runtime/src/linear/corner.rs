//! Corners and jumps of the equations: switches whose surface contains the state.

use super::tangent::Blocks;
use crate::linalg::dense::DenseMatrix;
use crate::scalar::{Number, Scalar};
use crate::system::{LinearisedSystem, MAX_LOCATED, values_of_events};

/// Relative to the entries of a matrix, differences between both sides up to this count as
/// rounding.
const SAME: f64 = 1e-9;

/// Returns a description of the switch whose surface contains the state, if rates or derivatives
/// differ between its sides.
pub(super) fn corner<M>(system: &M, t: M::Scalar, y: &M::State) -> Option<&'static str>
where
    M: LinearisedSystem,
    M::Scalar: Into<f64>,
{
    let sided = system.on_sides(t, y)?;
    let events = system.events().iter().enumerate().filter(|(_, event)| event.is_side);
    let (here, rates) = (Blocks::of(&sided, t, y).matrix, sided.rhs(t, y));
    for (index, event) in events.filter(|(index, _)| is_near(&sided, t, y, *index)) {
        let Ok(Some(other)) = sided.react(index, t, M::Scalar::ZERO, y).map(|response| response.system)
        else {
            continue;
        };
        let beyond = other.rhs(t, y);
        let pairs = rates.as_ref().iter().zip(beyond.as_ref());
        let jumps = pairs.into_iter().any(|(&a, &b)| differ(a.into(), b.into(), a.abs().max(b.abs()).into()));
        if jumps || have_changed(&here, &Blocks::of(&other, t, y).matrix) {
            return Some(event.name);
        }
    }
    None
}

/// True if a change of the state or of time by half of its digits crosses the switch of this event.
fn is_near<M: LinearisedSystem>(sided: &M, t: M::Scalar, y: &M::State, event: usize) -> bool {
    let passes = |t: M::Scalar, y: &M::State| {
        // NaN counts as crossing, too.
        let is_kept = values_of_events::<_, MAX_LOCATED>(sided, t, y)[event] > M::Scalar::ZERO;
        !is_kept
    };
    let step = M::Scalar::epsilon().sqrt();
    let reach = |value: M::Scalar| step * value.abs().max(M::Scalar::ONE);
    let signs = [M::Scalar::ONE, -M::Scalar::ONE];
    let displaced = (0..y.as_ref().len()).flat_map(|k| {
        signs.map(|sign| {
            let mut near = *y;
            near.as_mut()[k] = near.as_ref()[k] + sign * reach(near.as_ref()[k]);
            near
        })
    });
    { displaced }.any(|near| passes(t, &near)) || signs.into_iter().any(|sign| passes(t + sign * reach(t), y))
}

fn have_changed(here: &DenseMatrix, there: &DenseMatrix) -> bool {
    let size = here.largest().max(there.largest());
    let places = (0..here.rows()).flat_map(|i| (0..here.columns()).map(move |j| (i, j)));
    { places }.any(|place| differ(here[place], there[place], size))
}

/// True if numbers differ by more than rounding, or only one of them is NaN.
fn differ(a: f64, b: f64, size: f64) -> bool {
    let is_same = (a - b).abs() <= SAME * size || (a.is_nan() && b.is_nan());
    !is_same
}
