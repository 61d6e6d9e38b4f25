//! T₂ + V₂ = T₁ + V₁ + W₁₂: the work W₁₂ = ∫ F·dr + ∫ M dφ of nonconservative loads is the increase
//! of energy.

use lagrange::integrate::{Verner98, integrate};
use lagrange::system::OdeSystem;

use crate::assert_within;

lagrange::system! {
    /// Two plates on a pivot, with springs, a motor, a brake, a dashpot and a steady pull on a
    /// corner.
    #[derive(Clone, Debug)]
    struct Plates;

    param m = 1.2, a = 0.3, b = 0.8, k = 15.0, c = 0.6, ct = 0.05, motor = 0.7, fx = 1.1, fy = -0.4, g = 9.81;
    coord p, q;
    gravity = (0, -g);
    body upper { shape: rectangle(a, b); mass: m; center: b/2 * (sin(p), -cos(p)); angle: p; }
    body lower {
        shape: rectangle(a, b);
        mass: m;
        center: upper.point(0, -b/2) + b/2 * (sin(q), -cos(q));
        angle: q;
    }
    spring { from: (1, -1); to: lower.point(a/2, 0); stiffness: k; rest: 1/5; }
    torsion_spring { from: ground; to: upper; stiffness: k; rest: 1/3; }
    damper { from: (-1, -1); to: lower; damping: c; }
    torsion_damper { from: upper; to: lower; damping: ct; }
    torque motor on upper;
    force (fx, fy) at lower.point(a/2, -b/2);

    let stretch = norm(lower.center - (-1, -1));
    output pull = inner((fx, fy), velocity(lower.point(a/2, -b/2)));
    output drive = motor * angular_velocity(upper);
    output heat = c * dot(stretch)^2 + ct * (angular_velocity(lower) - angular_velocity(upper))^2;
    emit { motion }
}

/// The plates with the work of all these loads behind their state.
struct WithWork(Plates);

impl WithWork {
    fn power(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> f64 {
        self.0.pull(t, q, v) + self.0.drive(t, q, v) - self.0.heat(t, q, v)
    }
}

impl OdeSystem for WithWork {
    type Scalar = f64;
    type State = [f64; 5];

    fn rhs(&self, t: f64, &[p, q, p_dot, q_dot, _]: &[f64; 5]) -> [f64; 5] {
        let [a, b] = self.0.acceleration(t, &[p, q], &[p_dot, q_dot]);
        [p_dot, q_dot, a, b, self.power(t, &[p, q], &[p_dot, q_dot])]
    }
}

fn assert_balance(plates: Plates) -> f64 {
    let system = WithWork(plates);
    let start = [0.3, 0.9, -0.5, 1.2, 0.0];
    let energy = |y: &[f64; 5]| system.0.energy(0.0, &[y[0], y[1]], &[y[2], y[3]]);
    let end = integrate(&system, 0.0, start, 3.0, &Verner98::tolerance(1e-12), |_, _| {}).expect("it runs");
    assert_within(1e-10, energy(&end), energy(&start) + end[4]);
    end[4]
}

#[test]
fn energy_grows_by_the_work_of_the_loads() {
    let work = assert_balance(Plates::default());
    assert!(work.abs() > 0.1, "{work}");
}

#[test]
fn energy_is_conserved_where_all_loads_are_conservative() {
    let free = Plates { c: 0.0, ct: 0.0, motor: 0.0, fx: 0.0, fy: 0.0, ..Plates::default() };
    assert_eq!(assert_balance(free), 0.0);
}

/// T = ½ m v_S² + ½ J_S ω², and about a fixed axis ½ J_P ω².
#[test]
fn kinetic_energy_is_that_of_the_centers_and_of_turning() {
    let plates = Plates::default();
    let (q, v) = ([0.4, -0.7], [1.3, -0.6]);
    let [upper, lower] = [plates.upper_motion(0.0, &q, &v), plates.lower_motion(0.0, &q, &v)];
    let by_hand = [upper, lower].map(|body| {
        let [x, y] = body.velocity;
        (body.mass * (x * x + y * y) + body.inertia * body.angular_velocity * body.angular_velocity) / 2.0
    });
    assert_within(1e-14, plates.kinetic_energy(0.0, &q, &v), by_hand[0] + by_hand[1]);
    let about_pivot = upper.inertia_about([0.0, plates.b / 2.0]);
    assert_within(1e-14, by_hand[0], about_pivot * v[0] * v[0] / 2.0);
    let j = plates.m * (plates.a * plates.a + plates.b * plates.b) / 12.0;
    assert_within(1e-14, about_pivot, j + plates.m * plates.b * plates.b / 4.0);
}
