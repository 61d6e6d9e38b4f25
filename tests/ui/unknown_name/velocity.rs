lagrange::system! {
    pub struct Oscillator;

    param m = 1.0;
    coord x;
    kinetic = 1/2 * m * x_dot^2;
    output acceleration_of_x = x_ddot;
}

fn main() {}
