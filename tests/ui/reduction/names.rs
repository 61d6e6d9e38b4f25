lagrange::system! {
    struct Ball<Real>;

    coord x, y;
    kinetic = kinetic_energy(1, dot((x, y)));

    reduce Ball { freeze x = 0; }
    reduce BallState { freeze x = 0; }
    reduce Real { freeze x = 0; }
    reduce Falling { freeze x = 0; }
    reduce Falling { freeze y = 0; }
    reduce FallingState { freeze y = 0; }
    reduce fn { freeze y = 0; }
}

fn main() {
    let falling = Falling::default();
    let state = falling.expand(FallingState { y: 1.0, y_dot: 2.0 });
    let _ = falling.acceleration(0.0, &[state.y], &[state.y_dot]);
}
