use lagrange::system::LinearisedSystem;

lagrange::system! {
    struct Pendulum;

    coord theta;
    kinetic = 1/2 * dot(theta)^2;
    potential = -cos(theta);
}

fn analyse(_: &impl LinearisedSystem) {}

fn main() {
    let pendulum = Pendulum::default();
    analyse(&pendulum);
    let _ = pendulum.system_matrix(0.0, &[0.5, 0.0]);
}
