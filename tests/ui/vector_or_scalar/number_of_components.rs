lagrange::system! {
    struct Point;

    coord x, y;
    let (a) = (x, y);
    let p = (x,);
    let r = ();
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
}

fn main() {}
