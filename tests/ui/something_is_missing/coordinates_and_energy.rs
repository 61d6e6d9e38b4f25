lagrange::system! {
    struct Nothing;

    param m = 1.0;
    potential = m;
}

fn main() {}
