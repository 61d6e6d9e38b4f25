//! Errors from runs of emitted systems: parameters, components, events and coordinates by name,
//! with values and times.

use lagrange::event::{Action, Direction, Occurrence, integrate_with_events};
use lagrange::integrate::{RungeKutta4, Verner98, integrate};
use lagrange::system::Wrapper;
use lagrange::{Scalar, Simulate};

lagrange::system! {
    /// A cart that carries a pendulum, with a square root that ends at x = 1.
    #[derive(Clone, Debug)]
    struct Cart;

    param mc = 1, mp = 0.5, l = 0.7, g = 9.81, edge = 1;
    coord x, theta;
    input u;
    let (px, py) = (x + l * sin(theta), -l * cos(theta));
    kinetic = 1/2 * mc * dot(x)^2 + 1/2 * mp * (dot(px)^2 + dot(py)^2);
    potential = mp * g * py;
    force x = u + sqrt(edge - x);
    event marked = u * sqrt(2 - t) - 1, rising => record;
}

lagrange::system! {
    /// A spinning coin whose spin becomes the root of −1 when it falls on the floor.
    #[derive(Clone, Debug)]
    struct Thrown;

    param floor = 0;
    coord y, theta;
    kinetic = 1/2 * (dot(y)^2 + dot(theta)^2);
    potential = 9.81 * y;
    event landing = y - floor, falling => { dot(theta) = sqrt(y - floor - 1); }
}

lagrange::system! {
    struct Generic<S>;
    param stiffness = 1;
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = 1/2 * stiffness * x^2;
}

lagrange::system! {
    /// A bead on a rod, in Cartesian coordinates.
    struct Bead;
    param slope = 1, g = 9.81;
    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = g * y;
    constraint rod = y - slope * x;
}

const START: [f64; 4] = [0.1, 0.2, 0.3, 0.4];

/// Returns the message of a run of two seconds.
fn said(cart: &Cart, start: [f64; 4]) -> String {
    cart.simulate(start).until(2.0).run().expect_err("fails").to_string()
}

#[test]
fn a_parameter_that_is_not_finite_is_named() {
    let broken = [
        ("the parameter `mc` is NaN", Cart { mc: f64::NAN, ..Cart::default() }),
        ("the parameter `g` is NaN", Cart { g: f64::NAN, ..Cart::default() }),
        ("the parameter `edge` is NaN", Cart { edge: f64::NAN, ..Cart::default() }),
        ("the input `u` is NaN at time 0.0", Cart { u: f64::NAN, ..Cart::default() }),
    ];
    for (message, cart) in broken {
        let message = format!("{message} (at time 0.0)");
        assert_eq!(said(&cart, START), message);
        let bare = integrate(&cart, 0.0, START, 2.0, &RungeKutta4 { step: 0.01 }, |_, _| {});
        assert_eq!(bare.expect_err("fails").to_string(), message);
    }
    assert_eq!(
        said(&Cart { l: f64::INFINITY, ..Cart::default() }, START),
        "the parameter `l` is inf (at time 0.0)"
    );
    let generic = Generic::<f32> { stiffness: f32::NAN };
    let error = generic.simulate([1.0, 0.0]).from(0.5).until(2.0).run().expect_err("fails");
    assert_eq!(error.to_string(), "the parameter `stiffness` is NaN (at time 0.5)");
    let bead = Bead { slope: f64::NAN, ..Bead::default() };
    let error = bead.simulate([0.0; 4]).until(1.0).run().expect_err("fails");
    assert_eq!(error.to_string(), "the parameter `slope` is NaN (at time 0.0)");
}

#[test]
fn a_component_of_the_start_that_is_not_finite_is_named() {
    for (index, name) in ["x", "theta", "x_dot", "theta_dot"].into_iter().enumerate() {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            let mut start = START;
            start[index] = value;
            let expected = format!("`{name}` of the state is {value:?} (at time 0.0)");
            assert_eq!(said(&Cart::default(), start), expected);
            // It takes precedence over the consequences of an infinite parameter.
            assert_eq!(said(&Cart { g: f64::INFINITY, ..Cart::default() }, start), expected);
            for end in [
                integrate(&Cart::default(), 0.0, start, 2.0, &Verner98::tolerance(1e-9), |_, _| {}).map(drop),
                integrate(&Bead::default(), 0.0, start, 2.0, &Verner98::tolerance(1e-9), |_, _| {}).map(drop),
            ]
            .map(|run| run.expect_err("fails").to_string())
            {
                let velocity = expected.replace("theta", "y");
                assert!(end == expected || end == velocity, "{end}");
            }
        }
    }
    let end = Cart::default().simulate(START).until(f64::INFINITY).run().expect_err("endless");
    assert_eq!(end.to_string(), "the time of the end is inf (at time 0.0)");
}

#[test]
fn an_acceleration_that_is_not_finite_is_named_with_its_time() {
    // At the start, where x is beyond the edge, …
    let beyond = said(&Cart::default(), [1.5, 0.0, 0.0, 0.0]);
    assert_eq!(
        beyond,
        "the acceleration `x_ddot` is NaN at time 0.0 for a finite state; look for roots of negative numbers, negative powers of zero, or \
         functions beyond their guards (at time 0.0)"
    );
    // … and where the motion reaches it, whatever the method.
    let pushed = Cart { u: 5.0, ..Cart::default() };
    let adaptive = pushed.simulate(START).until(5.0).run().expect_err("reaches the edge");
    let fixed = pushed.simulate(START).until(5.0).method(RungeKutta4 { step: 1e-3 }).run().expect_err("too");
    for error in [adaptive, fixed] {
        let message = error.to_string();
        assert!(message.starts_with("the acceleration `x_ddot` is NaN at time "), "{message}");
        let time = message.split("at time ").nth(1).and_then(|rest| rest.split(' ').next());
        let time: f64 = time.expect("a time").parse().expect("a number");
        assert!(time >= error.time() && time < error.time() + 2e-3, "{message}");
        assert!((error.state()[0] - 1.0).abs() < 5e-3, "{:?}", error.state());
    }
}

#[test]
fn a_singular_mass_matrix_is_named_with_the_coordinate_of_its_pivot() {
    let light = Cart { mp: 0.0, mc: 0.0, ..Cart::default() };
    let cart = Cart { mc: 0.0, ..Cart::default() };
    let upright = said(&cart, [0.1, 0.0, 0.0, 0.4]);
    assert!(upright.starts_with("the mass matrix is singular at time 0.0: its pivot for `"), "{upright}");
    let nothing = said(&light, START);
    assert!(nothing.contains("its pivot for `x` is 0.0") || nothing.contains("`theta` is 0.0"), "{nothing}");
    assert!(nothing.contains("_ddot` does not follow from the forces (at time 0.0)"), "{nothing}");
}

#[test]
fn invalid_replacements_by_events_are_named() {
    let expected = "`theta_dot` of the state is NaN (at time ";
    let run = Thrown::default().simulate([1.0, 0.0, 0.0, 1.0]).until(2.0).run().expect_err("a root of -1");
    assert!(run.to_string().starts_with(expected), "{run}");
    assert!((run.time() - (2.0 / 9.81_f64).sqrt()).abs() < 1e-9 && run.state()[3] == 1.0, "{run:?}");
    let method = RungeKutta4 { step: 0.01 };
    let bare = integrate(&Thrown::default(), 0.0, [1.0, 0.0, 0.0, 1.0], 2.0, &method, |_, _| {});
    let bare = bare.expect_err("a root of -1");
    assert!(bare.to_string().starts_with(expected) && bare.state[3] == 1.0, "{bare}");
}

#[test]
fn events_that_accumulate_are_named_as_they_were_given() {
    let high = Thrown { floor: -9.0 };
    let lose = |_: &Thrown, event: &lagrange::simulate::Event<f64, [f64; 4]>| {
        let [y, theta, v, omega] = event.state;
        Action::Replace([y, theta, -0.5 * v, omega])
    };
    let run = high.simulate([1.0, 0.0, 0.0, 0.0]).until(5.0);
    let run = run.event("level", Direction::Rising, |_, _, [y, ..]| y - 10.0);
    let error = run.event_with("ground", Direction::Falling, |_, _, [y, ..]| *y, lose).run();
    let error = error.expect_err("it comes to rest");
    assert_eq!(error.name.as_deref(), Some("ground"));
    assert!(error.to_string().contains(" of event `ground` cannot be distinguished in time"), "{error}");
}

#[test]
fn events_are_named_as_they_were_declared_or_given() {
    let cart = Cart { u: 0.1, edge: 100.0, ..Cart::default() };
    let declared = cart.simulate(START).until(3.0).run().expect_err("no root");
    assert_eq!(declared.name.as_deref(), Some("marked"));
    assert!(
        declared.to_string().starts_with("the function of event `marked` is NaN or infinite"),
        "{declared}"
    );
    let bare = integrate(&cart, 0.0, START, 3.0, &Verner98::tolerance(1e-9), |_, _| {}).expect_err("no root");
    assert!(bare.to_string().starts_with("the function of event `marked` is NaN or infinite"), "{bare}");

    let bad = |_: &Cart, t: f64, _: &[f64; 4]| if t > 1.0 { f64::NAN } else { 1.0 };
    let run = cart.simulate(START).until(1.5);
    let run = run.event("first", Direction::Rising, |_, _, y| y[0]).event("my angle", Direction::Rising, bad);
    let given = run.run().expect_err("NaN");
    assert_eq!(given.name.as_deref(), Some("my angle"));
    assert!(given.to_string().starts_with("the function of event `my angle` is NaN or infinite"), "{given}");

    let watch = ([Direction::Rising; 2], |t: f64, _: &[f64; 4]| [1.0, if t > 1.0 { f64::NAN } else { 1.0 }]);
    let go_on = |_: &Occurrence<f64, [f64; 4]>| Action::Continue;
    let method = RungeKutta4 { step: 0.01 };
    let bare = integrate_with_events(&cart, (0.0, START), 1.5, &method, watch, go_on).expect_err("NaN");
    let expected = "the function of the event at index 1 is NaN or infinite";
    assert!(bare.to_string().starts_with(expected), "{bare}");
}

/// The cart with a first-order filter.
struct Filtered(Cart);

impl Wrapper for Filtered {
    type Inner = Cart;
    type State = [f64; 5];

    fn inner(&self) -> &Cart {
        &self.0
    }

    fn around(&self, inner: Cart) -> Filtered {
        Filtered(inner)
    }

    fn outer_rhs(&self, t: f64, y: &[f64; 5]) -> [f64; 5] {
        let [x, theta, v, omega, filter] = *y;
        let inner = Cart { u: filter, ..self.0.clone() }.rhs(t, &[x, theta, v, omega]);
        [inner[0], inner[1], inner[2], inner[3], (0.5 - filter).sqrt()]
    }
}

#[test]
fn wrappers_name_what_is_inside() {
    let said = |cart: Cart, start: [f64; 5]| {
        let run = integrate(&Filtered(cart), 0.0, start, 2.0, &Verner98::tolerance(1e-9), |_, _| {});
        run.expect_err("fails").cause.to_string()
    };
    let start = [0.1, 0.2, 0.3, 0.4, 0.0];
    assert_eq!(said(Cart { mp: f64::NAN, ..Cart::default() }, start), "the parameter `mp` is NaN");
    assert_eq!(said(Cart::default(), [0.1, 0.2, f64::NAN, 0.4, 0.0]), "`x_dot` of the state is NaN");
    let own = said(Cart::default(), [0.1, 0.2, 0.3, 0.4, f64::NAN]);
    assert_eq!(own, "the component at index 4 of the state is NaN");
    let rate = said(Cart::default(), [0.1, 0.2, 0.3, 0.4, 0.75]);
    assert!(rate.starts_with("the rate of the component at index 4 is NaN at time 0.0"), "{rate}");
}

/// Systems generic over a user's number type report names, too.
#[test]
fn generic_systems_know_their_names() {
    fn said<S: Scalar>(zero: S) -> String {
        let system = Generic::<S> { stiffness: S::NAN };
        let run = integrate(&system, zero, [S::ONE, zero], S::ONE, &RungeKutta4 { step: S::ONE }, |_, _| {});
        run.expect_err("fails").cause.to_string()
    }
    assert_eq!(said(0.0_f64), "the parameter `stiffness` is NaN");
    assert_eq!(said(0.0_f32), "the parameter `stiffness` is NaN");
}
