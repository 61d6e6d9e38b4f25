//! Conserved quantities as methods and columns, along motions.

use lagrange::Simulate;
use lagrange::system::OutputSystem;

lagrange::system! {
    /// Two bodies that attract each other.
    #[derive(Debug)]
    struct Binary;

    param m = 1, M = 2, k = 3;
    coord x1, y1, x2, y2;
    kinetic = kinetic_energy(m, dot((x1, y1))) + kinetic_energy(M, dot((x2, y2)));
    potential = -k / sqrt((x1 - x2)^2 + (y1 - y2)^2);
    emit { conserved }
}

lagrange::system! {
    /// A symmetric top on its tip.
    #[derive(Debug)]
    struct Top;

    param m = 0.5 [kg], l = 0.1 [m], i1 = 2e-3 [kg*m^2], i3 = 1e-3 [kg*m^2], g = 9.81 [m/s^2];
    gravity = (0, 0, -g);
    body rotor { mass: m; centroid: (0 [m], 0 [m], l); inertia: (i1, i1, i3); }
    ball tip = ground to rotor;
    output spin = angular_momentum(rotor, (0 [m], 0 [m], 0 [m]));
    emit { conserved }
}

/// Returns the largest change of each column since its start, relative to `scale`.
fn drift(columns: &[&[f64]], scale: f64) -> f64 {
    let changes = columns.iter().flat_map(|column| column.iter().map(|value| value - column[0]));
    changes.fold(0.0, |largest: f64, change| largest.max(change.abs() / scale))
}

#[test]
fn binaries_keep_their_momenta() {
    let names = ["conserved_energy", "conserved_x1_x2", "conserved_y1_y2", "conserved_angular_momentum"];
    assert_eq!(Binary::OUTPUTS, names);
    let binary = Binary::default();
    let start = [1.0, 0.2, -0.5, 0.1, 0.3, 1.1, -0.2, -0.4];
    let run = binary.simulate(start).until(10.0).every(0.1).tolerance(1e-12).outputs().run().unwrap();
    let columns = names.map(|name| run.column(name).unwrap());
    assert!(drift(&columns, 1.0) < 1e-10, "{}", drift(&columns, 1.0));
    // By hand: m (x ẏ − y ẋ) of each body.
    let expected = (1.1 - 0.2 * 0.3) + 2.0 * (0.5 * 0.4 + 0.1 * 0.2);
    assert!((columns[3][0] - expected).abs() < 1e-15);
    let at = |values: [f64; 8]| {
        binary.conserved_x1_x2(0.0, values.first_chunk().unwrap(), values.last_chunk().unwrap())
    };
    assert!((at(start) - (0.3 - 2.0 * 0.2)).abs() < 1e-15);
}

#[test]
fn tops_keep_the_moment_about_the_vertical_and_their_spin() {
    let (sine, cosine) = 0.3_f64.sin_cos();
    let top = Top::default();
    let start = [cosine, sine, 0.0, 0.0, 0.4, -0.3, 150.0];
    let run = top.simulate(start).until(1.0).every(0.01).tolerance(1e-12).outputs().run().unwrap();
    let [energy, vertical, spin] =
        ["conserved_energy", "conserved_angular_momentum", "conserved_angular_momentum_2"]
            .map(|name| run.column(name).unwrap());
    assert!(drift(&[energy, vertical, spin], 1.0) < 1e-9);
    // The angular momentum of the body, computed from its motion.
    let of_body = run.column("spin.z").unwrap();
    assert!(vertical.iter().zip(of_body).all(|(a, b)| (a - b).abs() < 1e-13));
    assert!((spin[0] - 1e-3 * 150.0).abs() < 1e-15);
}
