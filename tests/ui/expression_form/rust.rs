lagrange::system! {
    struct Cart;

    coord x, y;
    let p = (x, y);
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    potential = &x;
    potential = f64::sin(x);
    potential = x as f64;
    potential = p[0];
    potential = p.0;
    potential = max!(x, y);
    potential = { x };
    potential = [x, y];
    potential = |x|;
    potential = x.cos;
    potential = x # y;
    potential = x...y;
    potential = -x.max(y;);
}

fn main() {}
