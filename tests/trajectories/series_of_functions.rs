//! Taylor series of motions with powers, solutions of equations and tables.

use lagrange::integrate::{Taylor, Verner98, integrate};
use lagrange::system::{OdeSystem, TaylorSystem};
use lagrange::{Number, Simulate};

lagrange::system! {
    /// Powers with exponents from parameters, from the state, and of any ratio.
    #[derive(Clone, Debug)]
    struct Powers<S>;

    param n = 1.7, m = -0.6, k = 2.0;
    coord x, y;
    let distance = 1 + x^2 + y^2;
    kinetic = 1/2 * distance^n * dot(x)^2 + 1/2 * dot(y)^2 * (2 + sin(x))^(1/3);
    potential = k * distance^(7/5) + distance^m + (y/3)^66;
    force y = -(2 + cos(x))^(y / 2);
    emit { taylor }
}

lagrange::system! {
    /// A mass on a spring whose force is a power of the length, with any nonnegative exponent.
    #[derive(Clone, Debug)]
    struct Spring<S>;

    param n = 1.7;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    force x = -sign(x) * pow(abs(x), n);
    emit { taylor }
}

lagrange::system! {
    /// Balls in a row whose forces are powers of their overlap; all but the first touch.
    #[derive(Clone, Debug)]
    struct Beads<S>;

    param n = 3/2;
    const count = 4;
    coord x[count];
    for i in 0..count {
        kinetic = 1/2 * dot(x[i])^2;
    }
    for i in 0..count - 1 {
        force x[i] = -pow(max(x[i] - x[i + 1], 0), n);
        force x[i + 1] = pow(max(x[i] - x[i + 1], 0), n);
    }
    emit { taylor }
}

lagrange::system! {
    /// A radial spring without rest length, by the distance and by its square root.
    #[derive(Clone, Debug)]
    struct Radial;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    force x = -x * hypot(x, y) - x * sqrt(x^2 + y^2);
    force y = -y * hypot(x, y) - y * sqrt(x^2 + y^2);
    emit { taylor }
}

lagrange::system! {
    /// A stiffening shaft, a diode and two coupled angles, all given by equations.
    #[derive(Clone, Debug)]
    struct Solved<S>;

    param soft = 20, hard = 8, stiff = 60, leak = 0.01, volt = 0.05;
    coord theta;
    state charge;
    input source = 2;
    solve twist: 0 = soft * twist + hard * twist^3 - stiff * (theta - twist), start: theta;
    solve drop: 0 = leak * (exp(drop / volt) - 1) - (source - charge - drop) / 3, start: 0.3, iterations: 80;
    solve (coupler, rocker):
        0 = cos(theta) + 4 * cos(coupler) - 7/2 - 3 * cos(rocker),
        0 = sin(theta) + 4 * sin(coupler) - 3 * sin(rocker),
        start: (0.7, 1.5);
    let current = (source - charge - drop) / 3;
    kinetic = 1/2 * dot(theta)^2 + 1/2 * dot(rocker)^2;
    potential = 1/2 * soft * twist^2 + 1/4 * hard * twist^4 + 1/2 * stiff * (theta - twist)^2 + sin(coupler);
    force theta = current;
    dot(charge) = current;
    emit { taylor }
}

lagrange::system! {
    /// A mass pushed by a piecewise linear table of time.
    #[derive(Clone, Debug)]
    struct Pushed<S>;

    coord x;
    table push(time) = [(1, 0), (2, 6), (4, -2), (7, 0)], interpolation: linear, outside: clamp;
    kinetic = 1/2 * dot(x)^2;
    force x = push(t);
    emit { taylor }
}

lagrange::system! {
    /// A mass on a piecewise linear spring, softer on one side.
    #[derive(Clone, Debug)]
    struct Bilinear<S>;

    coord x;
    table pull(x) = [(-1, -1), (0, 0), (1, 9)], interpolation: linear, outside: extend;
    kinetic = 1/2 * dot(x)^2;
    force x = -pull(x);
    emit { taylor }
}

lagrange::system! {
    /// Two masses pushed by two tables, one of which provides values and slopes for both.
    struct Shared;

    coord x, y;
    table bump(x) = [(0, 0), (1, 1), (2, 0)], interpolation: linear, outside: clamp;
    table dip(x) = [(0, 0), (1, -2), (2, 0)], interpolation: natural, outside: extend;
    kinetic = 1/2 * dot(x)^2 + 1/2 * dot(y)^2;
    potential = dip(y);
    force x = bump(x) + dip(x);
    force y = bump(y);
    emit { taylor }
}

lagrange::system! {
    /// A wheel on a road, with a motor, a brake and drag from a table of two arguments.
    #[derive(Clone, Debug)]
    struct Wheel<S>;

    param m = 12, j = 0.4, r = 0.3, g = 9.81;
    coord s;
    table motor(rate) = [(0, 90), (100, 140), (200, 120), (300, 60)], interpolation: monotone, outside: clamp;
    table road(s) = [(0, 0), (3, 0.4), (8, 0.1), (14, -0.2), (20, 0)], interpolation: natural, outside: extend;
    table drag(speed, height) = [
        (0, -1, 0), (0, 1, 0.5), (10, -1, 3), (10, 1, 2.5), (30, -1, 25), (30, 1, 22)
    ], interpolation: natural, outside: extend;
    let height = road(s);
    kinetic = 1/2 * m * (dot(s)^2 + dot(height)^2) + 1/2 * j * (dot(s) / r)^2;
    potential = m * g * height;
    force s = 1/3 * motor(dot(s) / r) / r - drag(dot(s), height);
    emit { taylor }
}

lagrange::system! {
    /// A force built from the slopes of a table, which jumps at its points, until the table ends.
    #[derive(Clone, Debug)]
    struct Jumping;

    coord x;
    table path(x) = [(0, 0), (1, 1), (2, 3), (3, 3)], interpolation: linear, outside: error;
    kinetic = 1/2 * dot(x)^2;
    force x = -dot(path(x));
    emit { taylor }
}

fn end<M: TaylorSystem>(system: &M, start: M::State, t: M::Scalar, method: &Taylor<M::Scalar>) -> M::State {
    integrate(system, M::Scalar::from_f64(0.0), start, t, method, |_, _| {}).expect("reaches the end")
}

fn by_pair<M: OdeSystem<Scalar = f64>>(system: &M, start: M::State, t: f64) -> M::State {
    integrate(system, 0.0, start, t, &Verner98::tolerance(1e-13), |_, _| {}).expect("reaches the end")
}

fn error(found: &[f64], wanted: &[f64]) -> f64 {
    assert!(found.iter().chain(wanted).all(|component| component.is_finite()), "{found:?} {wanted:?}");
    found.iter().zip(wanted).fold(0.0, |largest, (found, wanted)| (found - wanted).abs().max(largest))
}

fn near(found: &[f64], wanted: &[f64], bound: f64) {
    let error = error(found, wanted);
    assert!(error < bound, "{error:e}: {found:?} for {wanted:?}");
}

#[test]
fn powers_have_series() {
    for start in [[0.4, -0.3, 0.1, 0.2], [0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.7, 0.0], [0.0, 2.9, 0.0, 1.0]] {
        for exponents in [[1.7, -0.6], [2.0, -1.0], [0.0, 0.0]] {
            let system = Powers { n: exponents[0], m: exponents[1], ..Powers::<f64>::default() };
            for span in [3.0, -2.0] {
                let found = end(&system, start, span, &Taylor::tolerance(1e-14));
                near(&found, &by_pair(&system, start, span), 2e-11);
            }
        }
    }
    let start = [0.4, -0.3, 0.1, 0.2];
    let single = end(&Powers::<f32>::default(), start.map(|x| x as f32), 3.0, &Taylor::tolerance(1e-5));
    near(&single.map(f64::from), &by_pair(&Powers::<f64>::default(), start, 3.0), 1e-4);
}

/// v²/2 + |x|^(n+1)/(n+1) is conserved. A base that passes zero has no series there; one that stays
/// at zero needs none.
#[test]
fn powers_of_zero_keep_the_energy() {
    for n in [0.3, 1.0, 1.7, 2.0, 3.0] {
        let energy = |[x, v]: [f64; 2]| 0.5 * v * v + x.abs().powf(n + 1.0) / (n + 1.0);
        for start in [[0.0, 1.0], [0.0, -1.0], [0.8, 0.0]] {
            let motion = Spring { n, ..Spring::<f64>::default() }
                .simulate(start)
                .until(6.0)
                .method(Taylor::tolerance(1e-12))
                .run();
            let last = motion.expect("reaches the end").last();
            let change = (energy(last) - energy(start)).abs();
            assert!(change < 1e-9, "{n} from {start:?}: {change:e}");
        }
        assert_eq!(
            end(&Spring { n, ..Spring::<f64>::default() }, [0.0, 0.0], 1.0, &Taylor::tolerance(1e-9)),
            [0.0, 0.0]
        );
    }
}

#[test]
fn touched_points_are_located() {
    let start = [-0.1, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
    for n in [1.5, 1.7, 3.0] {
        let beads = Beads { n, ..Beads::<f64>::default() };
        let run = beads.simulate(start).until(8.0).method(Taylor::tolerance(1e-12)).run().expect("goes on");
        let wanted = beads.simulate(start).until(8.0).tolerance(1e-13).run().expect("goes on");
        near(&run.last(), &wanted.last(), 1e-9);
    }
}

#[test]
fn lengths_start_from_zero() {
    for start in [[0.0, 0.0, 1.0, 0.5], [0.0, 0.0, 0.0, 0.0], [0.3, 0.0, 0.0, 0.0]] {
        let found = end(&Radial, start, 3.0, &Taylor::tolerance(1e-12));
        near(&found, &by_pair(&Radial, start, 3.0), 1e-9);
    }
}

#[test]
fn solutions_of_equations_have_series() {
    let system = Solved::<f64>::default();
    for start in [[0.3, 0.1, 0.5], [0.0, 0.0, 0.0], [1.2, 2.0, -0.4]] {
        for span in [4.0, -0.5] {
            let found = end(&system, start, span, &Taylor::tolerance(1e-14));
            near(&found, &by_pair(&system, start, span), 1e-11);
        }
        let single = end(&Solved::<f32>::default(), start.map(|x| x as f32), 1.0, &Taylor::tolerance(1e-5));
        near(&single.map(f64::from), &by_pair(&system, start, 1.0), 1e-4);
    }
}

/// Pushes are polynomials between the points, so the integrals are known.
#[test]
fn tables_of_the_time_are_integrated_exactly() {
    // Areas of trapezoids, and their moments about the end.
    let line = |[t, u]: [f64; 2], [a, b]: [f64; 2], until: f64| {
        let (h, left) = (u - t, until - u);
        let area = 0.5 * h * (a + b);
        [area, area * left + h * h * (2.0 * a + b) / 6.0]
    };
    let parts = [
        line([1.0, 2.0], [0.0, 6.0], 9.0),
        line([2.0, 4.0], [6.0, -2.0], 9.0),
        line([4.0, 7.0], [-2.0, 0.0], 9.0),
    ];
    let [v, x] = parts.iter().fold([0.0, 0.0], |sum, part| [sum[0] + part[0], sum[1] + part[1]]);
    for tolerance in [1e-6, 1e-12] {
        near(&end(&Pushed::<f64>::default(), [0.0, 0.0], 9.0, &Taylor::tolerance(tolerance)), &[x, v], 1e-13);
    }
    let single = end(&Pushed::<f32>::default(), [0.0, 0.0], 9.0, &Taylor::tolerance(1e-5));
    near(&single.map(f64::from), &[x, v], 1e-4);
    let back = integrate(&Pushed::<f64>::default(), 9.0, [x, v], 0.0, &Taylor::tolerance(1e-12), |_, _| {});
    near(&back.expect("reaches the start"), &[0.0, 0.0], 1e-13);
}

/// Half an oscillation with frequency 1, half with frequency 3.
#[test]
fn springs_of_straight_lines_oscillate_in_parts() {
    let spring = Bilinear::<f64>::default();
    let method = Taylor::tolerance(1e-12);
    let wanted = |t: f64| {
        let t = t % (std::f64::consts::PI * (1.0 + 1.0 / 3.0));
        let until = std::f64::consts::PI / 3.0;
        if t < until {
            [(3.0 * t).sin() / 3.0, (3.0 * t).cos()]
        } else {
            [-(t - until).sin(), -(t - until).cos()]
        }
    };
    // From a point of the table, to either side of it.
    for t in [0.5, 3.0, 20.0, 100.0] {
        near(&end(&spring, [0.0, 1.0], t, &method), &wanted(t), 1e-11);
        let [x, v] = wanted(t);
        near(&end(&spring, [x, -v], t, &method), &[0.0, -1.0], 1e-11);
    }
    assert_eq!(end(&spring, [0.0, 0.0], 5.0, &method), [0.0, 0.0]);
    // Steps are as long as the polynomials allow: two or three for each half.
    let mut steps = 0;
    integrate(&spring, 0.0, [0.0, 1.0], 100.0, &method, |_, _| steps += 1).expect("reaches the end");
    assert!(steps < 200, "{steps}");
}

#[test]
fn tables_of_the_state_have_series() {
    let wheel = Wheel::<f64>::default();
    for start in [[0.0, 0.0], [3.0, 1.0], [-1.0, 4.0]] {
        let found = end(&wheel, start, 4.0, &Taylor::tolerance(1e-13));
        // The pair steps across the points, where it loses digits.
        near(&found, &by_pair(&wheel, start, 4.0), 1e-9);
        let tight = Taylor { order: Some(18), ..Taylor::tolerance(1e-14) };
        near(&found, &end(&wheel, start, 4.0, &tight), 1e-11);
        let single = end(&Wheel::<f32>::default(), start.map(|x| x as f32), 4.0, &Taylor::tolerance(1e-5));
        near(&single.map(f64::from), &found, 2e-3);
    }
}

/// x = v₀ − f(x) along the path: the speed is 3 − x up to 1, and decreases twice as fast beyond.
#[test]
fn several_series_may_follow_one_table() {
    let start = [0.2, 1.5, 0.3, -0.4];
    near(&end(&Shared, start, 3.0, &Taylor::tolerance(1e-12)), &by_pair(&Shared, start, 3.0), 1e-9);
}

#[test]
fn rates_may_jump_at_the_points_of_a_table() {
    // It takes ln(3/2) to x = 1, and from there to x = 3/2 ln 2 at twice the rate.
    let t = 1.5_f64.ln() + 0.5 * 2.0_f64.ln();
    near(&end(&Jumping, [0.0, 3.0], t, &Taylor::tolerance(1e-12)), &[1.5, 1.0], 1e-11);
    let failed = integrate(&Jumping, 0.0, [0.0, 5.0], 9.0, &Taylor::tolerance(1e-9), |_, _| {});
    let failed = failed.expect_err("the table ends at 3");
    assert!((failed.state[0] - 3.0).abs() < 1e-6, "{:?}", failed.state);
    assert!(failed.to_string().contains("NaN"), "{failed}");
}

lagrange::system! {
    /// A pendulum with a motor.
    #[derive(Clone, Debug)]
    struct Arm;

    coord theta;
    input motor;
    kinetic = 1/2 * dot(theta)^2;
    potential = -9.81 * cos(theta);
    force theta = motor;
    emit { taylor }
}

#[test]
fn inputs_of_sampled_controllers_are_held() {
    let arm = Arm::default();
    let law =
        |_: &Arm, _: f64, state: ArmState| ArmInputs { motor: -4.0 * state.theta_dot - 12.0 * state.theta };
    let run = arm.simulate([0.0, 2.0]).until(1.0).sampled(0.05, law).method(Taylor::tolerance(1e-13)).run();
    let wanted = arm.simulate([0.0, 2.0]).until(1.0).sampled(0.05, law).tolerance(1e-13).run();
    let [found, wanted] = [run, wanted].map(|run| run.expect("reaches the end").last());
    near(&found, &wanted, 1e-12);
    assert!(found[0].abs() > 1e-3, "{found:?}");
}
