lagrange::system! {
    struct Pendulum;

    coord theta;
    kinetic = 1/2 * dot(theta)^2;
    potential = -cos(theta);
}

fn main() {
    println!("{}", Pendulum::EQUATIONS_LATEX);
    println!("{}", Pendulum::KERNEL_F64);
    println!("{:?}", Pendulum::PARAMETERS);
    println!("{}", Pendulum::STATEMENTS);
}
