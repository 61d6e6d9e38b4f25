use lagrange::scene::Scene;

lagrange::system! {
    struct Sled;

    coord x;
    body runner { mass: 2; center: (x, 0); }
}

fn show(_: &impl Scene) {}

fn main() {
    let sled = Sled::default();
    show(&sled);
}
