lagrange::system! {
    struct Cart;

    params m = 1.0;
    coord x;
    kinetc = 1/2 * m * dot(x)^2;
    energy = 3;
    gibberish here;
    /// A comment on a statement.
    potential = x;
    #[cfg(test)]
    param k = 1.0;
    3 + 4;
}

fn main() {}
