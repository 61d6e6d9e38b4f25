//! Construction of systems and states.

lagrange::system! {
    #[derive(Clone, Debug, PartialEq)]
    pub struct Cart;

    param m = 1/3, l = sqrt(2), k;
    input u;
    coord x, theta;
    kinetic = 1/2 * m * (dot(x)^2 + l * dot(theta)^2);
    potential = spring_energy(k, x - theta);
    force x = u;
}

lagrange::system! {
    #[derive(Clone, Debug, PartialEq)]
    pub struct Defaults<S>;

    param a = 0.3, b = 0.3, c = -2 * pi;
    input u = 1e-3;
    coord x;
    kinetic = 1/2 * (a + b^2) * dot(x)^2;
    force x = u * c;
}

#[test]
fn a_system_is_a_plain_struct() {
    let cart = Cart { m: 1.0, l: 2.0, k: 3.0, u: 4.0 };
    let other = Cart { u: 5.0, ..cart.clone() };
    assert_eq!(other, Cart { m: 1.0, l: 2.0, k: 3.0, u: 5.0 });
    assert_eq!(cart.acceleration(0.0, &[0.0, 0.0], &[0.0, 0.0]), [4.0, 0.0]);
}

#[test]
fn defaults_are_the_declared_ones_rounded_once() {
    let double = Defaults { a: 0.3, b: 0.3, c: -core::f64::consts::TAU, u: 1e-3 };
    assert_eq!(Defaults::default(), double);
    let single = Defaults { a: 0.3_f32, b: 0.3, c: -core::f32::consts::TAU, u: 1e-3 };
    assert_eq!(Defaults::default(), single);
}

#[test]
fn states_convert_both_ways() {
    let state = CartState { x: 1.0, theta: 2.0, x_dot: 3.0, theta_dot: 4.0 };
    let array = <[f64; 4]>::from(state);
    assert_eq!(array, [1.0, 2.0, 3.0, 4.0]);
    assert_eq!(CartState::from(array), state);
    let copied: CartState = array.into();
    assert_eq!(format!("{copied:?}"), "CartState { x: 1.0, theta: 2.0, x_dot: 3.0, theta_dot: 4.0 }");
    // A state can hold any type in place of numbers.
    let names: [&str; 2] = DefaultsState { x: "q", x_dot: "v" }.into();
    assert_eq!(names, ["q", "v"]);
}
