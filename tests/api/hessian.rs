//! Second derivatives of the Lagrangian, beside formulas by hand and differences of its slopes.

lagrange::system! {
    /// A bob on a spring.
    #[derive(Debug)]
    struct Spring<S>;

    param m = 2.0, k = 30.0, l = 0.5, g = 9.81;
    coord r, theta;
    kinetic = 1/2 * m * (dot(r)^2 + r^2 * dot(theta)^2);
    potential = 1/2 * k * (r - l)^2 - m * g * r * cos(theta);
    emit { lagrangian_hessian }
}

lagrange::system! {
    /// A double pendulum on a shaken support in a magnetic field, whose lower bob loses charge.
    #[derive(Debug)]
    struct Leaking;

    param l = 0.7, g = 9.81, b = 0.4;
    coord a, d;
    state e = 1.3;
    let p = (l*sin(a) + 0.1*sin(5*t), -l*cos(a));
    let q = p + l*(sin(d), -cos(d));
    lagrangian = 1/2*(dot(p.x)^2 + dot(p.y)^2 + dot(q.x)^2 + dot(q.y)^2) - g*(p.y + q.y)
        + b*(q.x*dot(q.y) - q.y*dot(q.x)) + e^2*q.x;
    dot(e) = -0.1*e;
    emit { lagrangian_hessian, tests }
}

lagrange::system! {
    /// A relativistic particle: the mass matrix depends on the velocity.
    #[derive(Debug)]
    struct Fast;

    coord x;
    lagrangian = -sqrt(1 - dot(x)^2);
    emit { lagrangian_hessian }
}

#[test]
fn a_bob_on_a_spring_has_the_hessian_found_by_hand() {
    let [m, k, g] = [2.0, 30.0, 9.81];
    for [r, theta, speed, spin] in [[0.6, 0.4, -1.0, 2.0], [0.0, 0.0, 0.0, 0.0], [1.5, -3.0, 0.5, 0.0]] {
        let (sin, cos) = f64::sin_cos(theta);
        let expected = [
            [m * spin * spin - k, -m * g * sin, 0.0, 2.0 * m * r * spin],
            [-m * g * sin, -m * g * r * cos, 0.0, 0.0],
            [0.0, 0.0, m, 0.0],
            [2.0 * m * r * spin, 0.0, 0.0, m * r * r],
        ];
        let found = Spring::<f64>::default().lagrangian_hessian(0.0, &[r, theta], &[speed, spin]);
        for (row, expected) in found.iter().zip(expected) {
            for (entry, expected) in row.iter().zip(expected) {
                assert!((entry - expected).abs() < 1e-13, "{found:?}");
            }
        }
        let (q, v) = ([r as f32, theta as f32], [speed as f32, spin as f32]);
        let rounded = Spring::<f32>::default().lagrangian_hessian(0.0, &q, &v);
        assert!((f64::from(rounded[0][3]) - expected[0][3]).abs() < 1e-5);
    }
}

#[test]
fn entries_are_differences_of_slopes_and_the_last_block_is_the_mass_matrix() {
    let (system, t, h) = (Leaking::default(), 0.3, 1e-4);
    for y in [[0.4, -1.1, 1.2, 0.8, -0.5], [0.0; 5], [-2.0, 3.0, 0.7, 0.0, 1.5]] {
        let lagrangian = |y: [f64; 5]| system.lagrangian(t, &[y[0], y[1], y[2]], &[y[3], y[4]]);
        let found = system.lagrangian_hessian(t, &[y[0], y[1], y[2]], &[y[3], y[4]]);
        for i in 0..5 {
            for j in 0..5 {
                let at = |di: f64, dj: f64| {
                    let mut moved = y;
                    moved[i] += di * h;
                    moved[j] += dj * h;
                    lagrangian(moved)
                };
                let difference =
                    (at(1.0, 1.0) - at(1.0, -1.0) - at(-1.0, 1.0) + at(-1.0, -1.0)) / (4.0 * h * h);
                assert!((found[i][j] - difference).abs() < 1e-6, "entry {i} {j} at {y:?}: {found:?}");
                assert_eq!(found[i][j].to_bits(), found[j][i].to_bits());
            }
        }
        let mass = system.mass_matrix(t, &[y[0], y[1], y[2]]);
        for i in 0..2 {
            for j in 0..2 {
                assert!((found[3 + i][3 + j] - mass[i][j]).abs() < 1e-14);
            }
        }
    }
}

#[test]
fn energies_need_not_be_quadratic_in_velocities() {
    for speed in [0.0, 0.6, -0.8_f64] {
        let [[by_place, mixed], [other, by_speed]] = Fast.lagrangian_hessian(0.0, &[1.0], &[speed]);
        assert_eq!([by_place, mixed, other], [0.0; 3]);
        let expected = (1.0 - speed * speed).powf(-1.5);
        assert!((by_speed - expected).abs() < 1e-13 * expected);
    }
}
