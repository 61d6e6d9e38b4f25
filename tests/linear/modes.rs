//! Modes against closed forms: frequencies, damping ratios, shapes, stability.

use std::f64::consts::PI;

use lagrange::linear::{Linearise, Stability};

use super::equilibria::{DoublePendulum, Hanging};

lagrange::system! {
    /// A chain of equal masses between two walls, with springs and dampers.
    #[derive(Clone, Debug)]
    struct Chain;

    const n = 12;
    param m = 0.7, k = 30, c = 0;
    coord x[n];
    kinetic = sum(i in 0..n, 1/2 * m * dot(x[i])^2);
    potential = 1/2 * k * (x[0]^2 + sum(i in 1..n, (x[i] - x[i-1])^2) + x[n-1]^2);
    dissipation = 1/2 * c * sum(i in 0..n, dot(x[i])^2);
    emit { system_matrix }
}

lagrange::system! {
    /// A mass on a spring and a damper, of either sign.
    #[derive(Clone, Debug)]
    pub(crate) struct Oscillator;

    param k = 4, c = 0.4;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * k * x^2;
    dissipation = 1/2 * c * dot(x)^2;
    emit { system_matrix }
}

lagrange::system! {
    /// A point on two equal springs: two modes with the same frequency.
    #[derive(Debug)]
    struct Plane;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = 9/2 * (x^2 + y^2);
    emit { system_matrix }
}

lagrange::system! {
    /// A position whose acceleration is an angle, which turns freely: four integrators in a row, in
    /// coordinates that mix the two.
    #[derive(Debug)]
    struct Integrators;

    coord a, b;
    let (x, angle) = (a + 0.3 * b, b - 0.7 * a);
    kinetic = 1/2 * (dot(x)^2 + dot(angle)^2);
    force a = angle;
    force b = 0.3 * angle;
    emit { system_matrix }
}

#[test]
fn integrators_in_a_row_are_not_decided() {
    // Rounding moves four equal eigenvalues by its fourth root.
    let modes = Integrators.linearise(0.0, [0.0; 4]).expect("smooth").modes().expect("eigenvalues");
    assert_eq!(modes.stability(), Stability::Undecided, "{modes}");
}

#[test]
fn a_chain_has_sines_for_shapes() {
    let chain = Chain::default();
    let modes = chain.linearise(0.0, [0.0; 24]).expect("smooth").modes().expect("eigenvalues");
    assert_eq!((modes.modes().len(), modes.stability()), (12, Stability::Undecided));
    for (index, mode) in modes.modes().iter().enumerate() {
        let half = (index + 1) as f64 * PI / 26.0;
        let frequency = 2.0 * (chain.k / chain.m).sqrt() * half.sin();
        assert!((mode.imaginary - frequency).abs() < 1e-13 * frequency, "{index}: {mode:?} {frequency}");
        assert!(mode.real.abs() < mode.uncertainty && mode.damping_ratio().abs() < 1e-12);
        let sine = |j: usize| (2.0 * half * (j + 1) as f64).sin();
        let largest = (0..12).map(|j| sine(j).abs()).fold(0.0, f64::max);
        for j in 0..12 {
            let (real, imaginary) = modes.component(index, &format!("x[{j}]")).expect("a displacement");
            assert!(((real.abs()) - sine(j).abs() / largest).abs() < 1e-12 && imaginary.abs() < 1e-12);
        }
    }
}

#[test]
fn dampers_take_the_same_share_of_each_mode() {
    let chain = Chain { c: 0.3, ..Chain::default() };
    let modes = chain.linearise(0.0, [0.0; 24]).expect("smooth").modes().expect("eigenvalues");
    assert_eq!(modes.stability(), Stability::AsymptoticallyStable);
    for (index, mode) in modes.modes().iter().enumerate() {
        let frequency = 2.0 * (chain.k / chain.m).sqrt() * ((index + 1) as f64 * PI / 26.0).sin();
        assert!((mode.real + chain.c / (2.0 * chain.m)).abs() < 1e-13, "{mode:?}");
        assert!((mode.natural_frequency() - frequency).abs() < 1e-12 * frequency, "{mode:?}");
        let ratio = chain.c / (2.0 * chain.m * frequency);
        assert!((mode.damping_ratio() - ratio).abs() < 1e-12, "{mode:?}");
    }
}

#[test]
fn the_sign_of_stiffness_and_damping_decides() {
    use Stability::{AsymptoticallyStable, Undecided, Unstable};
    for (k, c, wanted) in [
        (4.0, 0.4, AsymptoticallyStable),
        (4.0, 0.0, Undecided),
        (4.0, -1e-6, Unstable),
        (4.0, 1e-6, AsymptoticallyStable),
        (-4.0, 0.4, Unstable),
        // A double eigenvalue without two eigenvectors, at −2 and at 0.
        (4.0, 4.0, AsymptoticallyStable),
        (0.0, 0.0, Undecided),
        (0.0, 1.0, Undecided),
    ] {
        let oscillator = Oscillator { k, c };
        let modes = oscillator.linearise(0.0, [0.0; 2]).expect("smooth").modes().expect("eigenvalues");
        assert_eq!(modes.stability(), wanted, "{oscillator:?} {modes}");
        assert!(!modes.to_string().contains("NaN"), "zero has no damping ratio: {modes}");
    }
}

#[test]
fn double_pendulums_swing_at_the_textbook_frequencies() {
    let rods = DoublePendulum::<f64>::default();
    let modes = rods.linearise(0.0, [0.0; 4]).expect("smooth").modes().expect("eigenvalues");
    for (mode, (square, ratio)) in modes
        .modes()
        .iter()
        .zip([(2.0 - 2.0_f64.sqrt(), 2.0_f64.sqrt()), (2.0 + 2.0_f64.sqrt(), -2.0_f64.sqrt())])
    {
        let frequency = (rods.g / rods.l * square).sqrt();
        assert!((mode.imaginary - frequency).abs() < 1e-14 * frequency, "{mode:?}");
        let (a, b) = (mode.shape[0].0, mode.shape[1].0);
        assert!((b / a - ratio).abs() < 1e-13, "{mode:?}");
        // Velocities lead displacements by a quarter of a period.
        assert!((mode.shape[2].1 - frequency * a).abs() < 1e-13 && mode.shape[2].0.abs() < 1e-13);
    }
    let up = rods.linearise(0.0, [PI, PI, 0.0, 0.0]).expect("smooth").modes().expect("eigenvalues");
    assert_eq!((up.stability(), up.modes().len()), (Stability::Unstable, 4));
    assert!(up.to_string().ends_with("unstable"), "{up}");
}

#[test]
fn equal_frequencies_have_independent_shapes() {
    let modes = Plane.linearise(0.0, [0.0; 4]).expect("smooth").modes().expect("eigenvalues");
    let [one, other] = modes.modes() else { panic!("{modes:?}") };
    assert!((one.imaginary - 3.0).abs() < 1e-14 && (other.imaginary - 3.0).abs() < 1e-14);
    let dot = |a: usize, b: usize| {
        let ((ar, ai), (br, bi)) = (modes.modes()[a].shape[b], modes.modes()[1 - a].shape[b]);
        (ar * br + ai * bi, ai * br - ar * bi)
    };
    let (x, y) = (dot(0, 0), dot(0, 1));
    assert!((x.0 + y.0).abs() < 1e-12 && (x.1 + y.1).abs() < 1e-12, "{modes}");
}

#[test]
fn a_rotation_that_nothing_resists_has_zero_eigenvalues() {
    let hanging = Hanging;
    let found = hanging.equilibrium([0.1, 0.9, 0.2, -0.1, 0.0, 0.0, 0.0]).solve().expect("an equilibrium");
    let modes = hanging.linearise(0.0, found.state).expect("smooth").modes().expect("eigenvalues");
    assert_eq!(modes.stability(), Stability::Undecided, "{modes}");
    assert!(modes.modes()[0].natural_frequency() < 1e-7, "{modes}");
    assert!(modes.modes()[3].imaginary > 4.0, "{modes}");
}
