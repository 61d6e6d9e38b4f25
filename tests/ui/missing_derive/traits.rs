lagrange::system! {
    /// A point mass on a rod.
    pub struct Pendulum;

    param length;
    coord theta;
    kinetic = 1/2 * (length * dot(theta))^2;
    potential = -length * cos(theta);
}

fn print(value: impl std::fmt::Debug) {
    println!("{value:?}");
}

fn main() {
    let pendulum = Pendulum { length: 1.0 };
    let other = pendulum.clone();
    print(pendulum);
    println!("{}", other == Pendulum { length: 1.0 });
    let usual = Pendulum::default();
}
