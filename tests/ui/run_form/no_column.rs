use lagrange::Simulate;

lagrange::system! {
    struct Pendulum;

    coord theta;
    kinetic = 1/2 * dot(theta)^2;
    potential = -cos(theta);
}

fn main() {
    let motion = Pendulum::default().simulate([0.5, 0.0]).until(1.0).run().unwrap();
    let _ = motion.thet();
}
