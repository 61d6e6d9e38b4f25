//! Constraints, contacts, friction and events of all kinds.

lagrange::system! {
    /// A crate on a conveyor belt, held by a rail.
    #[derive(Clone, Debug)]
    pub struct Parcel;

    param m = 2.0, L = 1.5, mu = 0.2, belt = 0.3, g = 9.81;
    coord x, y, z;
    kinetic = kinetic_energy(m, dot((x, y, z)));
    potential = gravitational_energy(m, g, y);
    constraint rail = z - x / 3;
    constraint blade = dot(z) * cos(t) - dot(x) * cos(t) / 3;
    /// The conveyor belt.
    event ground = y - sin(t) / 10, falling => impact(1 / (2 + dot(y)^2));
    event ceiling = y - L, rising => impact(0.5);
    event turn = x - L, crossing => { dot(x) = -dot(x) / 2; x = 2 * L - x; }
    event apex = dot(y), falling => record;
    event late = t - 10, rising => stop;
    /// Friction on the belt.
    friction rub = dot(x) - belt, kinetic: mu * ground, static: 1.2 * mu * ground;
    friction brush = dot(y), mu * abs(x), smooth: 1e-3;
    output load = (ground, rail, brush);
    emit { momentum_rates, latex }
}

lagrange::system! {
    /// A pendulum on a string, in any number type.
    #[derive(Clone, Copy, Debug)]
    pub struct Tied<S>;

    param m = 1.0, l = 2.0, g = 9.81;
    coord x, y;
    kinetic = kinetic_energy(m, dot((x, y)));
    potential = gravitational_energy(m, g, y);
    constraint string = hypot(x, y) - l;
    stabilise = 10;
    event slack = string, rising => stop;
    emit { system_matrix }
}

lagrange::system! {
    /// A ball in single precision.
    #[scalar(f32)]
    #[derive(Clone, Copy, Debug)]
    pub struct Ball;

    coord y;
    kinetic = kinetic_energy(1, dot(y));
    potential = gravitational_energy(1, 9.81, y);
    event floor = y, falling => impact(0.8);
}

lagrange::system! {
    /// A ball in any number type.
    #[derive(Clone, Copy, Debug)]
    pub struct AnyBall<T>;

    coord y;
    kinetic = kinetic_energy(1, dot(y));
    potential = gravitational_energy(1, 9.81, y);
    event floor = y, falling => impact(0.8);
    event F = dot(y), crossing => record;
    friction _Air = dot(y), 0.1;
}

#[cfg(test)]
mod tests {
    use super::{AnyBall, Ball, Parcel, Tied};
    use lagrange::contact::Contact;

    #[test]
    fn what_is_open_falls_freely_and_what_is_closed_does_not() {
        let falls = |y: f32| y.to_bits() == (-9.81_f32).to_bits();
        let ball = Ball::default();
        assert!(falls(ball.acceleration(0.0, &[1.0], &[0.0])[0]));
        let lying = Ball { floor: Contact::Closed };
        assert!(lying.acceleration(0.0, &[0.0], &[0.0])[0].abs() < 1e-6);
        assert!(falls(AnyBall::<f32>::default().acceleration(0.0, &[1.0], &[0.0])[0]));
    }

    #[test]
    fn strings_hold_what_hangs() {
        let tied = Tied::<f64>::default();
        assert!((tied.multipliers(0.0, &[0.0, -2.0], &[0.0, 0.0])[0] + 9.81).abs() < 1e-12);
        assert!(Parcel::default().acceleration(0.0, &[0.0, 1.0, 0.0], &[0.0; 3])[1] < -9.0);
    }
}
