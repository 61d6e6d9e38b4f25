//! A system declared through a renamed dependency.
#![forbid(unsafe_code)]

mechanics::system! {
    /// A mass on a spring.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Oscillator;

    param m = 2.0, k = 8.0;
    coord x;
    kinetic = kinetic_energy(m, dot(x));
    potential = spring_energy(k, x);
    output period = 2 * pi * sqrt(m / k);
}

mechanics::system! {
    /// A disk that turns against friction, in any number type.
    pub struct Disk<S>;

    param j = 1.0;
    input u;
    coord phi;
    kinetic = 1/2 * j * dot(phi)^2;
    force phi = if u < 1 { u } else { 1 };
    output braking = -u * abs(dot(phi));
}

mechanics::system! {
    /// A wheel that rolls along a line.
    pub struct Wheel;

    param r = 1/2;
    coord x, y, a;
    line floor {}
    body wheel { mass: 2; shape: disk(r); center: (x, y); angle: a; }
    roll wheel on floor;
    emit { motion, drawing, statements }
}

#[cfg(test)]
mod tests {
    use super::{Disk, Oscillator, Wheel};
    use mechanics::integrate::{RungeKutta4, integrate};
    use mechanics::system::{EnergyFunction, OdeSystem};

    #[test]
    fn wheels_turn_about_the_place_where_they_touch() {
        let motion = Wheel::default().wheel_motion(0.0, &[3.0, 0.5, 0.0], &[1.0, 0.0, -2.0]);
        assert_eq!(motion.instant_center(), Some([3.0, 0.0]));
    }

    fn energy_and_rate<T>(system: &T, y: &[f64; 2]) -> (f64, [f64; 2])
    where
        T: EnergyFunction<Coordinates = [f64; 1], Velocities = [f64; 1]>
            + OdeSystem<Scalar = f64, State = [f64; 2]>,
    {
        (system.energy(0.0, &[y[0]], &[y[1]]), system.rhs(0.0, y))
    }

    #[test]
    fn systems_compute_and_implement_the_traits_of_the_renamed_crate() {
        let oscillator = Oscillator::default();
        assert_eq!(energy_and_rate(&oscillator, &[0.5, 1.0]), (2.0, [1.0, -2.0]));
        let period = oscillator.period(0.0, &[0.0], &[0.0]);
        let method = RungeKutta4 { step: period / 1000.0 };
        let end = integrate(&oscillator, 0.0, [0.5, 0.0], period, &method, |_, _| {}).expect("finite");
        assert!((end[0] - 0.5).abs() < 1e-9);
        let disk = Disk { j: 0.5, u: 3.0, ..Disk::<f64>::default() };
        assert_eq!(disk.acceleration(0.0, &[0.0], &[1.0]), [2.0]);
        assert_eq!(disk.braking(0.0, &[0.0], &[-2.0]), -6.0);
    }
}
