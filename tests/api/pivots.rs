//! Emitted code where a pivot vanishes although the motion is determined.

lagrange::system! {
    /// The mass matrix [sin x, 1; 1, 0] is regular everywhere.
    #[derive(Clone, Debug)]
    struct Indefinite;
    coord x, y;
    lagrangian = 1/2*sin(x)*dot(x)^2 + dot(x)*dot(y) - 1/2*y^2 - x;
}

lagrange::system! {
    /// Neither diagonal entry has a sign: [x, 1; 1, y].
    #[derive(Clone, Debug)]
    struct Saddle;
    coord x, y;
    lagrangian = 1/2*x*dot(x)^2 + dot(x)*dot(y) + 1/2*y*dot(y)^2 - x - 2*y;
}

lagrange::system! {
    /// Only y needs a mass.
    #[derive(Clone, Debug)]
    struct Carried;
    param m0 = 0, push = 3;
    coord x, y;
    kinetic = 1/2*m0*dot(x)^2 + 1/2*dot(y)^2;
    potential = y;
    constraint c = x - y;
    force x = push;
}

lagrange::system! {
    /// Only y has a mass where x is large.
    #[derive(Clone, Debug)]
    struct Switched;
    coord x, y;
    kinetic = (if x < 1 { 1/2 } else { 0 })*dot(x)^2 + 1/2*dot(y)^2;
    potential = y;
    constraint c = x - y;
}

fn assert_near(found: &[f64], expected: &[f64]) {
    assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-10), "{found:?}, not {expected:?}");
}

#[test]
fn a_regular_matrix_may_have_pivots_that_vanish() {
    let [y, v] = [0.2, 0.3];
    for x in [0.0, 1e-300, 1e-12, -1e-7, 1e-5, 0.4, -1.3] {
        // sin x ẍ + ½ cos x ẋ² + ÿ + 1 = 0 and ẍ + y = 0
        let expected = [-y, -1.0 - 0.5 * f64::cos(x) * v * v + f64::sin(x) * y];
        assert_near(&Indefinite.acceleration(0.0, &[x, y], &[v, 0.7]), &expected);
    }
    for [x, y] in [[0.0, 0.0], [0.0, 3.0], [3.0, 0.0], [1e-9, 2.0], [2.0, 3.0]] {
        // x ẍ + ÿ = −½ ẋ² − 1 and ẍ + y ÿ = −½ ẏ² − 2
        let (f, g) = (-0.5 * 0.09 - 1.0, -0.5 * 0.49 - 2.0);
        let determinant = x * y - 1.0;
        let expected = [(f * y - g) / determinant, (x * g - f) / determinant];
        assert_near(&Saddle.acceleration(0.0, &[x, y], &[0.3, 0.7]), &expected);
    }
    // Here the matrix is singular; at the other state some accelerations are NaN.
    let singular = Saddle.acceleration(0.0, &[1.0, 1.0], &[0.0; 2]);
    let unknown = Saddle.acceleration(0.0, &[0.0, 1.0], &[f64::NAN, 0.0]);
    assert!([singular, unknown].iter().flatten().all(|a| a.is_nan()), "{singular:?}, {unknown:?}");
}

#[test]
fn constraints_make_up_for_inertia_that_is_missing() {
    let carried = Carried::default();
    assert_near(&carried.acceleration(0.0, &[0.0; 2], &[0.0; 2]), &[2.0, 2.0]);
    assert_near(&carried.multipliers(0.0, &[0.0; 2], &[0.0; 2]), &[-3.0]);
    let free = Carried { push: 0.0, ..carried };
    assert_near(&free.acceleration(0.0, &[0.0; 2], &[0.0; 2]), &[-1.0, -1.0]);
    assert_near(&free.multipliers(0.0, &[0.0; 2], &[0.0; 2]), &[0.0]);
    let (mut q, mut v) = ([0.5, 0.3], [1.0, 2.0]);
    free.project(0.0, &mut q, &mut v).expect("y is where it is");
    assert_near(&[q, v].concat(), &[0.3, 0.3, 2.0, 2.0]);
    let switched = Switched::default();
    assert_near(&switched.acceleration(0.0, &[2.0; 2], &[0.5; 2]), &[-1.0, -1.0]);
    assert_near(&switched.acceleration(0.0, &[0.5; 2], &[0.5; 2]), &[-0.5, -0.5]);
    assert_near(&switched.multipliers(0.0, &[2.0; 2], &[0.5; 2]), &[0.0]);
    assert_near(&switched.multipliers(0.0, &[0.5; 2], &[0.5; 2]), &[-0.5]);
}
