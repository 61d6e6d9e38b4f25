use lagrange::Simulate;

lagrange::system! {
    struct Plane;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = y;
}

fn main() {
    let plane = Plane::default();
    plane.simulate([0.5, 0.0, 1.0]).until(1.0).run().unwrap();
    plane.simulate([1, 0, 0, 0]).until(1.0).run().unwrap();
    plane.simulate((0.5, 0.0)).until(1.0).run().unwrap();
}
