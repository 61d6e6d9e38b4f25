//! Equations with linear rates of states, one by one and coupled.

use lagrange::Simulate;

lagrange::system! {
    /// Two equal coils on one core, the second one shorted, with the supplied energy.
    #[derive(Clone, Debug)]
    struct Transformer<S>;

    param l: H = 0.5, m: H = 0.3, r: ohm = 2;
    input u: V = 12;
    state i: A, k: A, supplied: J;
    l * dot(i) + m * dot(k) = u - r * i;
    dot(supplied) = u * i;
    -r * k = m * dot(i) + l * dot(k);
    output voltage: V = m * dot(i) + l * dot(k);
}

lagrange::system! {
    /// The transformer by arrays, with a matrix of inductances.
    struct Coils;

    param L[2][2] = [[0.5, 0.3], [0.3, 0.5]], r = 2;
    input u = 12;
    state i[2];
    L * dot(i) = (u, 0) - r * i;
}

lagrange::system! {
    /// Filters in a row, each an instance of a part, and the sum of their rates.
    struct Filters;

    param tau = 0.1;
    part Filter(of, tau) {
        state y;
        tau * dot(y) + y = of;
    }
    first: Filter { of: 1; tau: tau; }
    more[i in 0..2]: Filter { of: first.y; tau: [tau, 2 * tau]; }
    output total = dot(first.y) + dot(more[0].y) + dot(more[1].y);
}

lagrange::system! {
    /// An equation for two rates, one of which a later statement gives.
    struct Later;

    state a = 1, b = 2;
    dot(a) + 3 * dot(b) = a;
    dot(b) = -b;
}

lagrange::system! {
    /// Rates in parentheses, in sums and on the right-hand side, and one of a member of a part.
    struct Bracketed;

    param l = 2, m = 1;
    input u = 3;
    state a, b, c, d;
    part Filter() { state y; }
    filter: Filter {}
    l * (dot(a) - dot(b)) = u - a;
    (m * (dot(b) + dot(a))) = u;
    dot(c) = 1 - dot(d) + sum(i in 0..3, i * dot(c));
    dot(d) = 2 - 3 * dot(c);
    2 * dot(filter.y) = 2 - filter.y;
}

lagrange::system! {
    /// Vector components, one of which gives a rate that the next one needs.
    struct Triangular;

    const ONE = 1;
    state x[3];
    ((ONE, 0, 0), (1, 2, 0), (0, 0, 1)) * dot(x) = -x;
    output second = dot(x[1]);
}

/// Returns the currents of both coils at a time, by their sum and their difference.
fn currents(t: f64) -> [f64; 2] {
    let (l, m, r, u) = (0.5, 0.3, 2.0, 12.0);
    let rise = |inductance: f64| u / r * (1.0 - (-r * t / inductance).exp());
    let (sum, difference) = (rise(l + m), rise(l - m));
    [(sum + difference) / 2.0, (sum - difference) / 2.0]
}

#[track_caller]
fn assert_all_close(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    let is_close = |(found, expected): (&f64, &f64)| (found - expected).abs() <= tolerance;
    assert!(found.iter().zip(expected).all(is_close), "{found:?} is not {expected:?}");
}

#[test]
fn coupled_coils_follow_their_closed_form() {
    let run =
        Transformer::<f64>::default().simulate([0.0; 3]).until(0.7).tolerance(1e-12).run().expect("runs");
    let expected = currents(0.7);
    assert_all_close(&run.last()[..2], &expected, 1e-11);
    let arrays = Coils::default().simulate([0.0; 2]).until(0.7).tolerance(1e-12).run().expect("runs");
    assert_all_close(&arrays.last(), &expected, 1e-11);
}

#[test]
fn rates_satisfy_the_equations_in_single_precision_too() {
    let (double, single) = (Transformer::<f64>::default(), Transformer::<f32>::default());
    let [i, k, supplied] = double.rhs(0.0, &[1.5, -0.5, 0.0]);
    assert_all_close(&[0.5 * i + 0.3 * k, 0.3 * i + 0.5 * k, supplied], &[12.0 - 3.0, 1.0, 18.0], 1e-14);
    assert_all_close(&[double.voltage(0.0, &[1.5, -0.5, 0.0], &[])], &[1.0], 1e-14);
    let narrow = single.rhs(0.0, &[1.5, -0.5, 0.0]).map(f64::from);
    assert_all_close(&narrow, &[i, k, supplied], 1e-5);
}

#[test]
fn coils_without_leakage_have_no_finite_rates() {
    let ideal = Transformer { m: 0.5, ..Transformer::<f64>::default() };
    let error = ideal.simulate([0.0; 3]).until(0.1).run().expect_err("the determinant is zero");
    assert!(error.to_string().contains("`i_dot` is inf"), "{error}");
}

#[test]
fn equations_in_parts_and_across_statements_give_the_same_rates() {
    let filters = Filters::default();
    let rates = filters.rhs(0.0, &[0.5, 0.2, 0.1]);
    assert_all_close(&rates, &[5.0, 3.0, 2.0], 1e-14);
    assert_all_close(&[filters.total(0.0, &[0.5, 0.2, 0.1], &[])], &[10.0], 1e-14);
    // ȧ − ḃ = (3 − 1)/2 and ȧ + ḃ = 3; ċ = 1 − ḋ + 3 ċ and ḋ = 2 − 3 ċ.
    let bracketed = Bracketed::default().rhs(0.0, &[1.0, 0.0, 0.0, 0.0, 1.0]);
    assert_all_close(&bracketed, &[2.0, 1.0, 0.2, 1.4, 0.5], 1e-14);
    assert_all_close(&Triangular.rhs(0.0, &[1.0, 3.0, 5.0]), &[-1.0, -1.0, -5.0], 1e-14);
    assert_all_close(&[Triangular.second(0.0, &[1.0, 3.0, 5.0], &[])], &[-1.0], 1e-14);
    assert_all_close(&Later.rhs(0.0, &[1.0, 2.0]), &[7.0, -2.0], 1e-14);
}
