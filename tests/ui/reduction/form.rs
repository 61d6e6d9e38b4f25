lagrange::system! {
    struct Ball;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);

    reduce { freeze x = 0; }
    reduce Bare;
    reduce Misspelt { frieze x = 0; }
    reduce Other { remove x; }
    reduce Unfinished { freeze x = 0 }
    /// Documented.
    reduce Right { freeze x = 0; };
}

fn main() {
    let _ = Right::default().expand(RightState { y: 1.0, y_dot: 2.0 });
}
