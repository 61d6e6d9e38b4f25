//! Signatures and values of the methods, against handwritten formulas.

use crate::assert_close;

lagrange::system! {
    #[derive(Clone, Copy, Debug)]
    pub struct CartPole;

    param mc = 1.0, mp = 0.1, l = 0.5, c = 0.2, g = 9.81;
    coord x, theta;
    input u;

    let (px, py) = (x + l * sin(theta), -l * cos(theta));
    kinetic = 1/2 * mc * dot(x)^2 + 1/2 * mp * (dot(px)^2 + dot(py)^2);
    potential = mp * g * py;
    dissipation = 1/2 * c * dot(theta)^2;
    force x = u;
    output tip = (px, py);
    output height = py;
    output felt = (ddot(px), ddot(py) + g, 0);
    output push = ddot(x);
}

const Q: [f64; 2] = [0.3, 0.7];
const V: [f64; 2] = [-0.4, 1.1];

#[test]
fn methods_have_the_documented_signatures() {
    type Vector = [f64; 2];
    let _: fn(&CartPole, f64, &Vector, &Vector) -> Vector = CartPole::acceleration;
    let _: fn(&CartPole, f64, &[f64; 4]) -> [f64; 4] = CartPole::rhs;
    let _: fn(&CartPole, f64, &Vector) -> [[f64; 2]; 2] = CartPole::mass_matrix;
    let _: fn(&CartPole, f64, &Vector, &Vector) -> Vector = CartPole::forcing;
    let _: fn(&CartPole, f64, &Vector, &Vector) -> Vector = CartPole::momenta;
    let _: fn(&CartPole, f64, &Vector, &Vector) -> f64 = CartPole::kinetic_energy;
    let _: fn(&CartPole, f64, &Vector) -> f64 = CartPole::potential_energy;
    let _: fn(&CartPole, f64, &Vector, &Vector) -> f64 = CartPole::energy;
    let _: fn(&CartPole, f64, &Vector, &Vector, &Vector) -> Vector = CartPole::inverse_dynamics;
    let _: fn(&CartPole, f64, &Vector, &Vector) -> [f64; 2] = CartPole::tip;
    let _: fn(&CartPole, f64, &Vector, &Vector) -> f64 = CartPole::height;
    let _: fn(&CartPole, f64, &Vector, &Vector) -> [f64; 3] = CartPole::felt;
}

#[test]
fn the_equations_are_those_of_the_textbook() {
    let system = CartPole { u: 0.8, ..CartPole::default() };
    let CartPole { mc, mp, l, c, g, u } = system;
    let ((sin, cos), w) = (Q[1].sin_cos(), V[1]);
    let mass = system.mass_matrix(0.0, &Q);
    let expected = [[mc + mp, mp * l * cos], [mp * l * cos, mp * l * l]];
    for (found, expected) in mass.concat().into_iter().zip(expected.concat()) {
        assert_close(found, expected);
    }
    let forcing = system.forcing(0.0, &Q, &V);
    assert_close(forcing[0], u + mp * l * w * w * sin);
    assert_close(forcing[1], -mp * g * l * sin - c * w);
    let a = system.acceleration(0.0, &Q, &V);
    for (row, force) in mass.iter().zip(forcing) {
        assert_close(row[0] * a[0] + row[1] * a[1], force);
    }
    assert_eq!(system.rhs(0.0, &[Q[0], Q[1], V[0], V[1]]), [V[0], V[1], a[0], a[1]]);
    assert_close(system.momenta(0.0, &Q, &V)[0], (mc + mp) * V[0] + mp * l * cos * w);
    let kinetic = 0.5 * (mc + mp) * V[0] * V[0] + mp * l * cos * V[0] * w + 0.5 * mp * l * l * w * w;
    assert_close(system.kinetic_energy(0.0, &Q, &V), kinetic);
    assert_close(system.potential_energy(0.0, &Q), -mp * g * l * cos);
    assert_close(system.energy(0.0, &Q, &V), kinetic - mp * g * l * cos);
}

#[test]
fn inverse_dynamics_adds_to_the_declared_forces() {
    let system = CartPole { u: 0.8, ..CartPole::default() };
    let mut a = system.acceleration(0.0, &Q, &V);
    system.inverse_dynamics(0.0, &Q, &V, &a).iter().for_each(|&force| assert_close(force, 0.0));
    a[0] += 1.0;
    let force = system.inverse_dynamics(0.0, &Q, &V, &a);
    assert_close(force[0], system.mc + system.mp);
}

#[test]
fn outputs_are_methods() {
    let system = CartPole::default();
    let (sin, cos) = Q[1].sin_cos();
    let tip = system.tip(0.0, &Q, &V);
    assert_close(tip[0], Q[0] + system.l * sin);
    assert_close(tip[1], system.height(0.0, &Q, &V));
    let [x, theta] = system.acceleration(0.0, &Q, &V);
    assert_close(system.push(0.0, &Q, &V), x);
    let felt = system.felt(0.0, &Q, &V);
    assert_close(felt[0], x + system.l * (cos * theta - sin * V[1] * V[1]));
    assert_eq!(felt[2], 0.0);
}
