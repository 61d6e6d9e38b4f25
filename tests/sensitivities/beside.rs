//! Gradients beside forward derivatives and differences.

use lagrange::simulate::Gradient;
use lagrange::system::{OdeSystem, ParametricSystem};

/// States of samples, and their derivatives with respect to each variable.
pub(crate) type Samples = (Vec<Vec<f64>>, Vec<Vec<Vec<f64>>>);

/// Compares the derivatives of half the sum of squares of all entries, over all samples.
pub(crate) fn compare((states, derivatives): Samples, (value, found): (f64, &[f64]), tolerance: f64) {
    let expected: f64 = states.iter().flatten().map(|entry| 0.5 * entry * entry).sum();
    assert!((value - expected).abs() < tolerance * expected, "{value} {expected}");
    for (index, found) in found.iter().enumerate() {
        let along = |(y, slopes): (&Vec<f64>, &Vec<Vec<f64>>)| -> f64 {
            y.iter().zip(&slopes[index]).map(|(entry, slope)| entry * slope).sum()
        };
        let expected: f64 = states.iter().zip(&derivatives).map(along).sum();
        assert!((found - expected).abs() < tolerance * (1.0 + expected.abs()), "{index}: {found} {expected}");
    }
}

macro_rules! samples {
    ($simulation:expr, $names:expr) => {{
        let motion = $simulation.sensitivities($names).run().expect("a motion");
        let slopes =
            |row| motion.sensitivities(row).expect("a row").iter().map(|slope| slope.to_vec()).collect();
        let states = motion.states().map(|y| y.to_vec()).collect();
        (states, (0..motion.len()).map(slopes).collect())
    }};
}

/// Compares the gradient with forward derivatives, by parameters and by these states at the start.
macro_rules! compare {
    ($simulation:expr, $names:expr, $states:expr, $tolerance:expr) => {{
        let gradient = $simulation.gradient($names, |_, y, slope| {
            *slope = *y;
            y.iter().map(|entry| 0.5 * entry * entry).sum()
        });
        let gradient = gradient.expect("a gradient");
        assert_eq!(gradient.by.len(), $names.len());
        let table = $simulation.run().expect("a motion");
        let place = |state| table.names().iter().position(|name| *name == state).expect("a state");
        let by_start = $states.map(|state| gradient.by_start[place(state)]);
        $crate::beside::compare(samples!($simulation, $names), (gradient.value, &gradient.by), $tolerance);
        $crate::beside::compare(samples!($simulation, $states), (gradient.value, &by_start), $tolerance);
        gradient
    }};
}

/// Compares derivatives with respect to parameters with extrapolated differences of costs, relative
/// to one or to the cost.
pub(crate) fn compare_with_differences<M, const N: usize>(
    system: &M,
    names: &[&str],
    gradient: &Gradient<f64, N>,
    cost: impl Fn(&M) -> f64,
    tolerance: f64,
) where
    M: ParametricSystem + OdeSystem<Scalar = f64, State = [f64; N]>,
{
    assert!((gradient.value - cost(system)).abs() < 1e-12 * gradient.value.abs().max(1.0));
    assert_eq!(names.len(), gradient.by.len());
    for (name, found) in names.iter().zip(&gradient.by) {
        let index = M::NUMBERS.iter().position(|number| number == name).expect("a parameter");
        let value = system.number(index).expect("a parameter");
        let size = if value == 0.0 { 1.0 } else { value };
        let moved = |by: f64| cost(&system.with_number(index, value + by));
        let central = |h: f64| (moved(h) - moved(-h)) / (2.0 * h);
        let [wide, middle, narrow] = [4e-3, 2e-3, 1e-3].map(|part| central(part * size));
        let (first, second) = ((4.0 * middle - wide) / 3.0, (4.0 * narrow - middle) / 3.0);
        let wanted = (16.0 * second - first) / 15.0;
        let scale = wanted.abs().max(gradient.value.abs()).max(1.0);
        assert!((found - wanted).abs() < tolerance * scale, "{name}: {found} {wanted}");
    }
}
