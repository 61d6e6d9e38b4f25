lagrange::system! {
    struct Pendulum;

    param l = 1;
    coord theta;
    kinetic = 1/2 * l^2 * dot(theta)^2;
    potential = -l * cos(theta);
    emit { regressor }
}

lagrange::system! {
    struct Weighing;

    param m = 1;
    coord x;
    kinetic = 1/2 * m * dot(x)^2;
    output regressor_parameters = x;
    emit { regressor }
}

fn main() {
    let _ = Pendulum::default().regressor(0.0, &[0.1], &[0.0], &[0.0]);
}
