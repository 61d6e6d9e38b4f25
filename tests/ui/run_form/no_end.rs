use lagrange::Simulate;

lagrange::system! {
    struct Pendulum;

    coord theta;
    kinetic = 1/2 * dot(theta)^2;
    potential = -cos(theta);
}

fn main() {
    let pendulum = Pendulum::default();
    let run = pendulum.simulate([0.5, 0.0]).run().unwrap();
    println!("{:?}", run.theta());
    let fine = pendulum.simulate([0.5, 0.0]).tolerance(1e-9).every(0.1).run().unwrap();
    println!("{:?}", fine.theta());
    let late = pendulum.simulate([0.5, 0.0]).tolerance(1e-9).until(1.0).run().unwrap();
    println!("{:?}", late.theta());
}
