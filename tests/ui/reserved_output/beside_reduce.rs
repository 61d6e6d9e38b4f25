lagrange::system! {
    struct Ball;

    coord x, y;
    kinetic = 1/2 * (dot(x)^2 + dot(y)^2);
    output expand = x;
    output deviation = (x, y);
    reduce Falling { freeze x = 0; }
}

fn main() {
    let _ = Falling::default().expand(FallingState { y: 1.0, y_dot: 2.0 });
}
