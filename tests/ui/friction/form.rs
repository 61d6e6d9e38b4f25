lagrange::system! {
    struct Forms;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    friction dot(x), 1;
    friction slope;
    friction lone = dot(x);
    friction gap = dot(x) 1;
    friction two = dot(x), 1, 2;
    friction half = dot(x), kinetic: 1;
    friction hold = dot(x), static: 1;
    friction mixed = dot(x), 1, static: 2;
    friction again = dot(x), kinetic: 1, static: 2, kinetic: 3;
    friction misspelt = dot(x), kinetik: 1, static: 2;
    friction strange = dot(x), mu: 1;
    friction both = dot(x), kinetic: 1, static: 2, smooth: 1;
    friction width = dot(x), smooth: 1;
    friction fine = dot(x), 1;
}

fn main() {}
