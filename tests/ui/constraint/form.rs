lagrange::system! {
    struct Forms;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    constraint x - y;
    constraint ring x^2 + y^2 - 1;
    constraint line = x - y = 0;
    constraint pair = (x, y);
}

fn main() {}
