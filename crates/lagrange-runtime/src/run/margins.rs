//! Margins of switches, which are located slightly beyond their surfaces.
//!
//! Otherwise rounding on a surface would cross it again and again. The rounding error of a
//! switching function is estimated from its largest value so far and its change under rounding of
//! the state. Entries that it does not depend on have no effect, unless constraints couple them.

use crate::event::rounded;
use crate::scalar::Scalar;
use crate::system::{DeclaredEvent, OdeSystem, values_of_events};
use crate::tolerance::SURFACE;

/// The distances beyond their surfaces at which switches change their sides; zero for other events.
#[derive(Clone, Copy, Debug)]
pub(super) struct Margins<S, const C: usize> {
    /// Time at which the margins were computed.
    pub(super) time: S,
    margins: [S; C],
    /// True if events that change modes of contacts and friction are not searched for.
    finds_modes: bool,
}

impl<S: Scalar, const C: usize> Margins<S, C> {
    /// Computes the margins at a state, for functions with magnitudes up to `ranges` so far.
    pub(super) fn new<M>(system: &M, time: S, y: &M::State, ranges: &[S; C]) -> Self
    where
        M: OdeSystem<Scalar = S>,
    {
        let mut margins = [S::ZERO; C];
        if have_sides(system.events()) {
            let here = values_of_events(system, time, y);
            let rounded = values_of_events(system, time, &rounded(y));
            let shared = if system.is_constrained() { largest(y.as_ref()) } else { S::ZERO };
            margins = of_sides(system.events(), [&here, &rounded, ranges], shared);
        }
        Margins { time, margins, finds_modes: false }
    }

    /// Omits the events that change modes of contacts and friction, if steps find them.
    pub(super) fn without_modes(self, finds_modes: bool) -> Self {
        Margins { finds_modes, ..self }
    }

    /// Computes the margins at another state.
    pub(super) fn again<M>(&self, system: &M, time: S, y: &M::State, ranges: &[S; C]) -> Self
    where
        M: OdeSystem<Scalar = S>,
    {
        Margins::new(system, time, y, ranges).without_modes(self.finds_modes)
    }

    /// Returns the values of all declared events, padded with ones. The values of switches vanish
    /// slightly beyond their surfaces.
    pub(super) fn values<M>(&self, system: &M, t: S, y: &M::State) -> [S; C]
    where
        M: OdeSystem<Scalar = S>,
    {
        self.beyond(system.events(), values_of_events(system, t, y))
    }

    /// Adds the margins to these values of the events.
    fn beyond(&self, events: &[DeclaredEvent], mut values: [S; C]) -> [S; C] {
        for (k, value) in values.iter_mut().enumerate() {
            let is_left_out = self.finds_modes && events.get(k).is_some_and(DeclaredEvent::is_of_mode);
            *value = if is_left_out { S::ONE } else { *value + self.margins[k] };
        }
        values
    }
}

/// True if one of these events is a change of sides.
fn have_sides(events: &[DeclaredEvent]) -> bool {
    events.iter().any(|event| event.is_side)
}

/// Returns the margins of sides from their values here, their values at the rounded state, and
/// their ranges. Constraints share the rounding of the largest entry.
fn of_sides<S: Scalar, const C: usize>(
    events: &[DeclaredEvent],
    [here, rounded, ranges]: [&[S; C]; 3],
    shared: S,
) -> [S; C] {
    let mut margins = [S::ZERO; C];
    for (k, _) in events.iter().enumerate().filter(|(_, event)| event.is_side) {
        let own = ranges[k].max(here[k].abs()).max(shared);
        let change = (rounded[k] - here[k]).abs();
        margins[k] = SURFACE.part::<S>() * own + if change.is_finite() { change } else { S::ZERO };
    }
    margins
}

fn largest<S: Scalar>(y: &[S]) -> S {
    y.iter().fold(S::ZERO, |size, entry| size.max(entry.abs()))
}

#[cfg(test)]
mod tests {
    use super::Margins;
    use crate::system::{DeclaredEvent, OdeSystem};

    /// A system whose equations change at y = 1.
    struct Surface;

    impl OdeSystem for Surface {
        type Scalar = f64;
        type State = [f64; 1];

        fn rhs(&self, _t: f64, _y: &[f64; 1]) -> [f64; 1] {
            [1.0]
        }

        const EVENTS: &'static [DeclaredEvent] = &[DeclaredEvent::side("surface")];

        fn event_values(&self, _t: f64, y: &[f64; 1], values: &mut [f64]) {
            values[0] = y[0] - 1.0;
        }
    }

    #[test]
    fn a_switch_changes_its_side_a_few_roundings_beyond_its_surface() {
        let margins = Margins::new(&Surface, 0.0, &[1.0], &[1.0]);
        let margin = margins.values(&Surface, 0.0, &[1.0])[0] / f64::EPSILON;
        assert!((4.0..400.0).contains(&margin), "{margin}");
    }
}
