//! Laws as tests: `emit { tests }` adds a module of tests to each system below.

use lagrange::laws::{self, Broken};
use lagrange::system::{EnergyFunction, LagrangianSystem, MechanicalSystem, OdeSystem, Unnamed, join, split};

lagrange::system! {
    /// A cart with a pole, pushed and damped, on an accelerated frame.
    #[derive(Debug)]
    struct Cart;

    param cart = 3, pole = 0.4, l = 0.6, g = 9.81, c = 0.3;
    coord x, theta;
    input u = 2;
    kinetic = 1/2 * cart * dot(x)^2 + kinetic_energy(pole, dot((x + l*sin(theta) + sin(3*t), -l*cos(theta))));
    potential = -pole * g * l * cos(theta);
    dissipation = 1/2 * c * dot(theta)^2;
    force x = u - 0.5 * dot(x);
    emit { tests, jacobian }
}

lagrange::system! {
    /// The cart in any number type.
    #[derive(Debug)]
    struct Generic<S>;

    param l = 0.6, g = 9.81;
    coord theta = 0.4, phi;
    kinetic = 1/2 * l^2 * (dot(theta)^2 + sin(theta)^2 * dot(phi)^2);
    potential = -g * l * cos(theta);
    emit { tests, jacobian }
}

lagrange::system! {
    /// A bead on a ring that is held by a constraint, with a spring that only pulls.
    #[derive(Debug)]
    struct Bead;

    param r = 1.2, k = 30, m = 0.7;
    coord x = 1.2, y;
    kinetic = kinetic_energy(m, dot((x, y)));
    potential = m * 9.81 * y + 1/2 * k * max(0, x - 0.5)^2;
    constraint ring = x^2 + y^2 - r^2;
    emit { tests }
}

lagrange::system! {
    /// A top on a moving ball joint, with a motor whose current is a state.
    #[derive(Debug)]
    struct Top;

    param m = 0.5, l = 0.3, a = 0.02, b = 0.03, c = 0.01, g = 9.81, inductance = 0.1, resistance = 2;
    gravity = (0, 0, -g);
    body rotor { mass: m; centroid: (0, 0, l); inertia: (a, b, c); }
    ball tip = ground to rotor { damping: 0.02; }
    state current = 1;
    force tip_wz = 0.3 * current;
    dot(current) = (5 - resistance * current - 0.3 * tip_wz) / inductance;
    emit { tests, jacobian }
}

lagrange::system! {
    /// A particle in a magnetic field: the Lagrangian has terms linear in velocities.
    #[derive(Debug)]
    struct Charge;

    param m = 2, b = 3;
    coord x, y;
    lagrangian = 1/2 * m * (dot(x)^2 + dot(y)^2) + b/2 * (x * dot(y) - y * dot(x)) - 1/4 * x^4;
    emit { tests }
}

/// An oscillator with an error in its accelerations, its energy or its forces.
#[derive(Debug)]
struct Mistaken {
    acceleration: f64,
    energy: f64,
    force: f64,
}

impl OdeSystem for Mistaken {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, t: f64, y: &[f64; 2]) -> [f64; 2] {
        let (q, v) = split::<Self>(y);
        join::<Self>(&v, &self.acceleration(t, &q, &v))
    }
}

impl MechanicalSystem for Mistaken {
    type Coordinates = [f64; 1];
    type Velocities = [f64; 1];
    type Columns<C> = Unnamed<C>;
    const COORDINATES: &'static [&'static str] = &["x"];

    fn acceleration(&self, _t: f64, [x]: &[f64; 1], [v]: &[f64; 1]) -> [f64; 1] {
        [self.acceleration - 4.0 * x - 0.1 * v]
    }

    fn position_rates(&self, _t: f64, _q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
        *v
    }
}

impl EnergyFunction for Mistaken {
    fn energy(&self, _t: f64, [x]: &[f64; 1], [v]: &[f64; 1]) -> f64 {
        0.5 * v * v + 2.0 * x * x + self.energy
    }
}

impl LagrangianSystem for Mistaken {
    fn lagrangian(&self, _t: f64, [x]: &[f64; 1], [v]: &[f64; 1]) -> f64 {
        0.5 * v * v - 2.0 * x * x
    }

    fn generalised_forces(&self, _t: f64, _q: &[f64; 1], [v]: &[f64; 1]) -> [f64; 1] {
        [self.force - 0.1 * v]
    }
}

fn broken(acceleration: f64, energy: f64, force: f64) -> Vec<String> {
    let report = laws::check(&Mistaken { acceleration, energy, force }, 0.0, &[0.3, -0.8]);
    assert!(report.is_judged());
    report.laws.into_iter().filter(|law| !law.holds()).map(|law| law.name).collect()
}

#[test]
fn mistakes_break_the_laws_that_they_concern() {
    let (equation, energy, power) = ("Lagrange's equation of x", "energy v·∂L/∂v − L", "power of the forces");
    assert_eq!(broken(0.0, 0.0, 0.0), Vec::<String>::new());
    assert_eq!(broken(1e-4, 0.0, 0.0), [equation, power]);
    assert_eq!(broken(0.0, 1e-4, 0.0), [energy]);
    assert_eq!(broken(0.0, 0.0, 1e-4), [equation, power]);
}

#[test]
fn states_with_broken_laws_are_reported() {
    let system = Mistaken { acceleration: 1e-3, energy: 0.0, force: 0.0 };
    let Err(Broken::State { state, report, .. }) = laws::verify(&system, &[0.0, 0.0]) else {
        panic!("a mistake is found");
    };
    assert_eq!(state.len(), 2);
    assert!(report.to_string().contains("BROKEN Lagrange's equation of x: 1.0e-3"), "{report}");
    let nowhere = Mistaken { acceleration: f64::NAN, energy: 0.0, force: 0.0 };
    assert_eq!(laws::verify(&nowhere, &[0.0, 0.0]), Err(Broken::NothingJudged));
}

#[test]
fn laws_hold_in_single_precision() {
    laws::verify(&Generic::<f32>::default(), &[0.4, 0.0, 0.0, 0.0]).unwrap();
}

#[test]
fn corners_are_not_judged() {
    let bead = Bead::default();
    let (x, r) = (0.5, 1.2_f64);
    let report = laws::check(&bead, 0.0, &[x + 1e-4, (r * r - x * x).sqrt(), 0.0, 0.0]);
    assert!(report.holds());
    assert!(!report.is_judged(), "{report}");
}

#[test]
fn equations_of_random_starts_hold_in_units_far_from_one() {
    for scale in [1e-6, 1e6] {
        let cart = Cart { cart: 3.0 * scale, pole: 0.4 * scale, u: scale, c: 0.3 * scale, ..Cart::default() };
        let report = laws::check(&cart, 0.7, &[scale, 0.3, -2.0, 1.0]);
        assert!(report.holds() && report.is_judged(), "{report}");
    }
}
