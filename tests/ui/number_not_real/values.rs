lagrange::system! {
    struct Point;

    param k = ln(-1);
    coord x;
    kinetic = 1/2 * k * dot(x)^2;
    potential = sqrt(-2) * x + asin(2) * (1 - pi)^(1/2) * x^2;
    force x = 10^400 * x;
}

fn main() {}
