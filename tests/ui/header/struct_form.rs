lagrange::system! {
    struct Body { m: f64 }

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

lagrange::system! {
    struct Bounds<S: Scalar>;

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

lagrange::system! {
    struct Several<S, T>;

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

lagrange::system! {
    struct Unfinished

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

lagrange::system! {
    enum Choice;

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

lagrange::system! {
    pub struct Single<f32>;

    coord x;
    kinetic = 1/2 * dot(x)^2;
}

fn main() {}
