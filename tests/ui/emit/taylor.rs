use lagrange::Simulate;
use lagrange::integrate::{Taylor, integrate};

lagrange::system! {
    struct Bob;

    coord x, y;
    kinetic = kinetic_energy(1, dot((x, y)));
    potential = 9.81 * y;
    constraint left = x;
    constraint below = y;
    constraint aslant = x + y;
    emit { taylor }
}

lagrange::system! {
    struct Ball;

    coord y;
    kinetic = 1/2 * dot(y)^2;
    potential = 9.81 * y;
    event floor = y, falling => impact(0.5);
    emit { taylor }
}

lagrange::system! {
    struct Slope;

    function height(x) { derivative: slope; }
    coord x;
    kinetic = 1/2 * dot(x)^2;
    potential = height(x);
    emit { taylor }
}

lagrange::system! {
    #[derive(Clone, Debug)]
    struct Cart;

    coord x;
    input push;
    kinetic = 1/2 * dot(x)^2;
    force x = push;
    emit { taylor }
}

lagrange::system! {
    struct Pendulum;

    coord theta;
    kinetic = 1/2 * dot(theta)^2;
    potential = -cos(theta);
}

fn height(x: f64) -> f64 {
    x
}

fn slope(_: f64) -> f64 {
    1.0
}

fn main() {
    let end = integrate(&Pendulum::default(), 0.0, [0.1, 0.0], 1.0, &Taylor::tolerance(1e-9), |_, _| {});
    println!("{end:?}");
    let cart = Cart::default();
    let driven = cart.simulate([0.0, 0.0]).until(1.0).drive(|_, t, _| CartInputs { push: t });
    let run = driven.method(Taylor::tolerance(1e-9)).run();
    println!("{run:?}");
}
