//! Every product, for energies of every kind.

lagrange::system! {
    /// A chain of links in absolute angles, long enough for recursive elimination.
    #[derive(Clone, Debug)]
    pub struct Chain;

    param m = 1.0, l = 0.5, g = 9.81, c = 0.01;
    coord q1, q2, q3, q4, q5;
    let (x1, y1) = (l * sin(q1), -l * cos(q1));
    let (x2, y2) = (x1 + l * sin(q2), y1 - l * cos(q2));
    let (x3, y3) = (x2 + l * sin(q3), y2 - l * cos(q3));
    let (x4, y4) = (x3 + l * sin(q4), y3 - l * cos(q4));
    let p5 = (x4 + l * sin(q5), y4 - l * cos(q5));
    kinetic = 1/2 * m * (dot(x1)^2 + dot(y1)^2 + dot(x2)^2 + dot(y2)^2 + dot(x3)^2 + dot(y3)^2);
    kinetic = 1/2 * m * (dot(x4)^2 + dot(y4)^2) + kinetic_energy(m, dot(p5));
    potential = gravitational_energy(m, g, y1 + y2 + y3 + y4 + p5.y);
    dissipation = 1/2 * c * (dot(q1)^2 + dot(q5)^2);
    force (0, -c) at p5;
    torque c * sin(t) on q5 - q4;
    output tip = p5;
    output reach = norm(p5);
    emit { bias, latex, momentum_rates, jacobian, system_matrix, prepared, kernel, lanes }
}

lagrange::system! {
    /// A relativistic particle: the mass matrix depends on the velocity.
    #[derive(Clone, Copy, Debug)]
    pub struct Relativistic;

    param m = 1.0, c = 1.0, k = 1.0;
    coord x, y;
    lagrangian = -m * c^2 * sqrt(1 - (dot(x)^2 + dot(y)^2) / c^2) - 1/2 * k * (x^2 + y^2);
    emit { momentum_rates, jacobian, system_matrix, no parameter_jacobian }
}

lagrange::system! {
    /// Only accelerations.
    #[derive(Clone, Copy, Debug)]
    pub struct Bare<S>;

    param m = 1.0, k = 1.0;
    coord x;
    kinetic = 1/2 * m * dot(x)^2 * (1 + x^2);
    potential = 1/2 * k * x^2;
    emit { no mass_matrix, no forcing, no momenta, no kinetic_energy, no potential_energy, no energy }
    emit { no inverse_dynamics, jacobian, kernel }
}

#[cfg(test)]
mod tests {
    use super::{Bare, Chain, Relativistic};

    #[test]
    fn inverse_dynamics_undoes_the_acceleration() {
        let chain = Chain::default();
        let (q, v) = ([0.1, 0.2, 0.3, 0.4, 0.5], [1.0, -1.0, 0.5, 0.2, 0.0]);
        let a = chain.acceleration(0.3, &q, &v);
        assert!(chain.inverse_dynamics(0.3, &q, &v, &a).iter().all(|force| force.abs() < 1e-12));
        assert!((chain.reach(0.0, &[0.0; 5], &[0.0; 5]) - 2.5).abs() < 1e-15);
    }

    #[test]
    fn a_moving_particle_is_heavier() {
        let particle = Relativistic::default();
        let mass = particle.mass_matrix(0.0, &[0.0, 0.0], &[0.6, 0.0]);
        assert!((mass[0][0] - 1.0 / 0.8_f64.powi(3)).abs() < 1e-14);
        assert!((Bare::<f32>::default().acceleration(0.0, &[1.0], &[0.0])[0] + 0.5).abs() < 1e-6);
    }
}
