//! Systems of first-order states alone.

use lagrange::Simulate;
use lagrange::integrate::{GaussLegendre4, Radau5, RungeKutta4, Taylor};

lagrange::system! {
    /// Two RC circuits in a row, at a source.
    #[derive(Clone, Debug)]
    struct Ladder;

    param r = 2, c = 0.5, source = 5;
    state v = 1, w;
    dot(v) = ((source - v) / r - (v - w) / r) / c;
    dot(w) = (v - w) / (r * c);
    output current = (source - v) / r;
    event half = w - source / 2, rising => record;
    emit { jacobian, taylor, prepared }
}

lagrange::system! {
    /// The Lorenz attractor.
    #[derive(Clone, Debug)]
    struct Lorenz<S>;

    param sigma = 10, rho = 28, beta = 8/3;
    state x = 1, y = 1, z = 1;
    dot(x) = sigma * (y - x);
    dot(y) = x * (rho - z) - y;
    dot(z) = x * y - beta * z;
    emit { lanes, kernel }
}

lagrange::system! {
    /// A relay that discharges a capacitor: states that an event sets.
    #[derive(Debug)]
    struct Relaxation;

    input u = 1;
    state v;
    discrete count = 0;
    dot(v) = u;
    event full = v - 1, rising => { v = 0; count = count + 1; }
}

/// Returns voltages by the eigenvalues −(3 ± √5)/2 of the two circuits with r c = 1.
fn ladder(t: f64) -> [f64; 2] {
    let root = 5.0_f64.sqrt();
    let [fast, slow] = [-(3.0 + root) / 2.0, -(3.0 - root) / 2.0];
    // From (1, 0) to (5, 5): the deviation (−4, −5) as a sum of eigenvectors (λ + 1, 1).
    let along = |a: f64, b: f64| (-4.0 + 5.0 * (b + 1.0)) / (a - b);
    let parts = [along(fast, slow) * (fast * t).exp(), along(slow, fast) * (slow * t).exp()];
    [5.0 + parts[0] * (fast + 1.0) + parts[1] * (slow + 1.0), 5.0 + parts[0] + parts[1]]
}

#[test]
fn circuits_charge_as_their_solution() {
    let circuit = Ladder::default();
    let run =
        circuit.simulate(circuit.start()).until(3.0).every(0.25).tolerance(1e-12).outputs().run().unwrap();
    for (k, &t) in run.times().iter().enumerate() {
        let [v, w] = ladder(t);
        assert!((run.v()[k] - v).abs() < 1e-10 && (run.w()[k] - w).abs() < 1e-10, "at {t}");
        assert_eq!(run.column("current").unwrap()[k], (5.0 - run.v()[k]) / 2.0);
    }
    let event = &run.events()[0];
    assert!((ladder(event.time)[1] - 2.5).abs() < 1e-10);
    assert_eq!(run.events().len(), 1);
}

#[test]
fn every_method_takes_them() {
    let circuit = Ladder::default();
    let expected = ladder(2.0);
    let close = |end: [f64; 2], bound: f64| (0..2).all(|i| (end[i] - expected[i]).abs() < bound);
    let run = || circuit.simulate(circuit.start()).until(2.0);
    assert!(close(run().method(RungeKutta4 { step: 1e-2 }).run().unwrap().last(), 1e-7));
    assert!(close(run().method(GaussLegendre4 { step: 1e-2 }.plain()).run().unwrap().last(), 1e-6));
    assert!(close(run().method(Radau5::tolerance(1e-9)).run().unwrap().last(), 1e-8));
    assert!(close(run().method(Taylor::tolerance(1e-12)).run().unwrap().last(), 1e-11));
    let prepared = circuit.prepared();
    assert!(close(
        prepared.simulate(circuit.start()).until(2.0).tolerance(1e-11).run().unwrap().last(),
        1e-9
    ));
}

#[test]
fn chaos_in_two_numbers_begins_alike() {
    let (double, single) = (Lorenz::<f64>::default(), Lorenz::<f32>::default());
    let reference = double.simulate([1.0; 3]).until(2.0).tolerance(1e-12).run().unwrap().last();
    let rough = single.simulate([1.0; 3]).until(2.0).run().unwrap().last();
    assert!((0..3).all(|i| (f64::from(rough[i]) - reference[i]).abs() < 1e-2));
    // Divergence of the flow: −(σ + 1 + β), by differences of `rhs`.
    let h = 1e-6;
    let divergence: f64 = (0..3)
        .map(|i| {
            let at = |by: f64| {
                let mut state = [2.0, -1.0, 20.0];
                state[i] += by;
                double.rhs(0.0, &state)[i]
            };
            (at(h) - at(-h)) / (2.0 * h)
        })
        .sum();
    assert!((divergence + 11.0 + 8.0 / 3.0).abs() < 1e-7);
}

#[test]
fn events_set_them() {
    let relaxation = Relaxation::default();
    let run = relaxation.simulate([0.0, 0.0]).until(3.5).run().unwrap();
    assert_eq!(run.events().len(), 3);
    let [v, count] = run.last();
    assert!((v - 0.5).abs() < 1e-12 && count == 3.0);
}
