lagrange::system! {
    struct Pendulum;

    coord theta;
    kinetic = 1/2 * dot(theta)^2;
    potential = -cos(theta);
}

fn main() {
    let pendulum = Pendulum::default();
    let _ = pendulum.constraints(0.0, &[0.5], &[0.0]);
    let _ = pendulum.constraint_velocity(0.0, &[0.5], &[0.0]);
    let _ = pendulum.constraint_jacobian(0.0, &[0.5]);
}
