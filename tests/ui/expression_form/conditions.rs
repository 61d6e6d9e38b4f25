lagrange::system! {
    struct Cart;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = if x < 0 { x };
    potential = if x = 0 { x } else { y };
    potential = if 0 < x < 1 { x } else { y };
    potential = if !x { x } else { y };
    potential = if x { x } else { y };
    potential = if x < 0 { } else { y };
    potential = if x < 0 { let z = x; z } else { y };
    potential = x < y;
    potential = if x < 0 { x } else { };
    potential = x ? y : 0;
}

fn main() {}
