//! Hamilton's equations, beside differences of the Hamiltonian.

use lagrange::integrate::Hamiltonian;

lagrange::system! {
    /// A double pendulum on a support that is shaken, in a magnetic field.
    #[derive(Debug)]
    struct Double;

    param m = 1.3, l = 0.7, g = 9.81, b = 0.4, c = 0.2;
    coord a, d;
    let p = (l*sin(a) + 0.1*sin(5*t), -l*cos(a));
    let q = p + l*(sin(d), -cos(d));
    lagrangian = 1/2*m*(dot(p.x)^2 + dot(p.y)^2 + dot(q.x)^2 + dot(q.y)^2) - m*g*(p.y + q.y)
        + b*(q.x*dot(q.y) - q.y*dot(q.x));
    dissipation = 1/2*c*dot(a)^2;
    emit { momentum_rates }
}

lagrange::system! {
    /// A relativistic particle: the momentum is not linear in the velocity.
    #[derive(Debug)]
    struct Fast;

    param k = 2;
    coord x;
    lagrangian = -sqrt(1 - dot(x)^2) - 1/2*k*x^2;
    emit { momentum_rates }
}

#[test]
fn rates_are_slopes_of_the_hamiltonian() {
    let (system, t) = (Double::default(), 0.3);
    let (q, p) = ([0.4, -1.1], [0.8, -0.5]);
    let (rates, forces) = system.hamilton_equations(t, &q, &p).unwrap();
    let h = 1e-3;
    let slope = |of: &dyn Fn(f64) -> f64| {
        let pair = |n: f64| of(n * h) - of(-n * h);
        (0.75 * pair(1.0) - 0.15 * pair(2.0) + pair(3.0) / 60.0) / h
    };
    for i in 0..2 {
        let moved =
            |from: [f64; 2], by: f64| std::array::from_fn(|j| from[j] + if i == j { by } else { 0.0 });
        let by_momentum = slope(&|by| system.hamiltonian(t, &q, &moved(p, by)).unwrap());
        let by_place = slope(&|by| system.hamiltonian(t, &moved(q, by), &p).unwrap());
        let applied = if i == 0 { -0.2 * rates[0] } else { 0.0 };
        assert!((rates[i] - by_momentum).abs() < 1e-10);
        assert!((forces[i] - applied + by_place).abs() < 1e-10);
    }
    let v = system.velocities_of(t, &q, &p).unwrap();
    let back = system.momenta(t, &q, &v);
    assert!((0..2).all(|i| (back[i] - p[i]).abs() < 1e-14));
}

#[test]
fn momenta_need_not_be_linear_in_velocities() {
    let fast = Fast::default();
    for p in [-0.9, 0.0, 1e-9, 0.7, 1.2] {
        // p = v/√(1 − v²), H = √(1 + p²) + k x²/2
        let v = fast.velocities_of(0.0, &[0.5], &[p]).unwrap();
        assert!((v[0] - p / (1.0 + p * p).sqrt()).abs() < 1e-15, "{p}: {v:?}");
        let energy = fast.hamiltonian(0.0, &[0.5], &[p]).unwrap();
        assert!((energy - (1.0 + p * p).sqrt() - 0.25).abs() < 1e-15);
    }
    assert!(fast.velocities_of(0.0, &[0.5], &[f64::NAN]).is_err());
}
