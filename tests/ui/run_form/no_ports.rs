use lagrange::Simulate;

lagrange::system! {
    struct Pendulum;

    coord theta;
    kinetic = 1/2 * dot(theta)^2;
    potential = -cos(theta);
}

fn main() {
    let pendulum = Pendulum::default();
    let run = pendulum.simulate([0.5, 0.0]).until(1.0);
    let _ = run.drive(|_: &Pendulum, _, _| ()).run();
    let _ = pendulum.simulate([0.5, 0.0]).until(1.0).outputs().run();
    let _ = pendulum.simulate([0.5, 0.0]).until(1.0).record("tip").run();
}
