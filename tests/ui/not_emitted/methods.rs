lagrange::system! {
    struct Pendulum;

    coord theta;
    kinetic = 1/2 * dot(theta)^2;
    potential = -cos(theta);
    emit { no energy, no mass_matrix }
}

fn main() {
    let pendulum = Pendulum::default();
    let matrix = pendulum.jacobian(0.0, &[0.5, 0.0]);
    println!("{}", matrix[0][1]);
    let bias = pendulum.bias(0.0, &[0.5], &[0.0]);
    println!("{}", bias[0]);
    let _ = pendulum.momentum_rates(0.0, &[0.5], &[0.0]);
    let _ = pendulum.parameter_jacobian(0.0, &[0.5, 0.0]);
    let _ = pendulum.prepared();
    let _ = pendulum.lanes(|parameter| parameter);
    let _ = pendulum.start();
    let energy: f64 = pendulum.energy(0.0, &[0.5], &[0.0]);
    println!("{energy} {:?}", pendulum.mass_matrix(0.0, &[0.5]));
}
