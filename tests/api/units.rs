//! Units of a declaration are available from the emitted type, and numbers are in coherent units.

use lagrange::Simulate;
use lagrange::system::{MechanicalSystem, OdeSystem, Wrapper};

lagrange::system! {
    /// A trolley that carries links, pushed by a force.
    #[derive(Clone, Debug)]
    struct Train;

    const n = 2;
    param m[n]: g = [500, 1500], l: mm = 250, slope: deg = 30, mu = 0.1, g: m/s^2 = 9.81;
    coord x: m, theta[n]: rad;
    input push: kN = 0.002;
    let p[0] = (x, 0);
    kinetic = kinetic_energy(m[0], dot(x));
    potential = m[0] * g * sin(slope) * x;
    for i in 0..n {
        let p[i+1] = p[i] + l * (sin(theta[i]), -cos(theta[i]));
        kinetic = kinetic_energy(m[i], dot(p[i+1]));
        potential = gravitational_energy(m[i], g, p[i+1].y);
    }
    force x = (1 - mu) * push;
    output tip: m = p[n];
    emit { prepared, momentum_rates, jacobian }
    reduce Held { freeze x = 0; }
}

lagrange::system! {
    struct Plain;
    coord x;
    kinetic = 1/2 * dot(x)^2;
}

/// A train inside another type.
struct Around(Train);

impl Wrapper for Around {
    type Inner = Train;
    type State = [f64; 6];

    fn inner(&self) -> &Train {
        &self.0
    }

    fn around(&self, inner: Train) -> Around {
        Around(inner)
    }

    fn outer_rhs(&self, t: f64, y: &[f64; 6]) -> [f64; 6] {
        OdeSystem::rhs(&self.0, t, y)
    }
}

fn unit<M: MechanicalSystem>(name: &str) -> Option<&'static str> {
    M::UNITS.iter().find(|(known, _)| *known == name).map(|(_, unit)| *unit)
}

#[test]
fn every_name_has_its_coherent_unit() {
    let units = ["x", "theta", "x_dot", "theta_dot", "m", "l", "slope", "g", "push", "tip.x", "tip.y"];
    let expected = ["m", "rad", "m/s", "rad/s", "kg", "m", "rad", "m/s^2", "N", "m", "m"];
    assert_eq!(units.map(unit::<Train>), expected.map(Some));
    assert_eq!(
        (unit::<Held>("x"), unit::<Held>("theta"), unit::<Held>("m")),
        (None, Some("rad"), Some("kg"))
    );
    assert_eq!(TrainPrepared::UNITS, Train::UNITS);
    assert_eq!(Around::UNITS, Train::UNITS);
    assert!(Plain::UNITS.is_empty());
}

#[test]
fn defaults_are_in_coherent_units() {
    let Train { m, l, slope, mu, g, push } = Train::default();
    assert_eq!((m, l, mu, g, push), ([0.5, 1.5], 0.25, 0.1, 9.81, 2.0));
    assert_eq!(slope.to_bits(), 30.0_f64.to_radians().to_bits());
}

#[test]
fn columns_of_arrays_and_outputs_have_their_units() {
    let train = Train::default();
    let run = train.simulate([0.0; 6]).until(0.1).outputs().energy().momenta().run().expect("runs");
    let mut bytes = Vec::new();
    run.write_csv(&mut bytes).expect("memory takes everything");
    let text = String::from_utf8(bytes).expect("text");
    let head = "t in s,x in m,theta[0] in rad,theta[1] in rad,x_dot in m/s,theta_dot[0] in rad/s,theta_dot[1] in rad/s,\
                tip.x in m,tip.y in m,energy in J,p_x in N*s,p_theta[0] in J*s,p_theta[1] in J*s";
    assert_eq!(text.lines().next(), Some(head));
}
