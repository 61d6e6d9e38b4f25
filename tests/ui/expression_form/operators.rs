lagrange::system! {
    struct Cart;

    param m = 1.0;
    coord x, y;
    kinetic = 1/2 m dot(x)^2;
    kinetic = 1/2 * m * dot(y)**2;
    potential = x % 2;
    potential = m * (x y);
    potential = 2x;
    potential = m * ;
    potential = + x;
    potential = x +* y;
    potential = -;
}

fn main() {}
