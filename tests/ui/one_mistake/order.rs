lagrange::system! {
    struct TooEarly;
    param l = 1.0;
    coord theta;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = y;
    let x = l * sin(theta);
    let y = -l * cos(theta);
}

lagrange::system! {
    struct First;
    coord x;
    kinetic = 1/2 * dot(x)^2;

    pub struct Second;
    coord y;
    kinetic = 1/2 * dot(y)^2;
}

lagrange::system! {
    struct WithoutSemicolon;
    coord x
    kinetic = 1/2 * dot(x)^2;
}

fn main() {}
