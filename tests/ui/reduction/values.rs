lagrange::system! {
    struct Ball;

    param l = 1;
    const half = 1/2;
    coord x, y;
    input u;
    let (a, b) = (x, y);
    kinetic = kinetic_energy(1, dot((a, b)));
    potential = spring_energy(l, u - b);

    reduce Right { freeze x = half * l + pi; }
    reduce OnCoordinate { freeze x = 2 * b; }
    reduce OnVelocity { small x = dot(y); }
    reduce OnTime { freeze x = l + sin(t); }
    reduce OnInput { freeze x = u; }
    reduce Vector { freeze x = (1, 2); }
    reduce Valueless { freeze x; }
}

fn main() {}
