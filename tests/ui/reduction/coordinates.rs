lagrange::system! {
    struct CartPole;

    param m = 1, l = 1, g = 9.81;
    coord x, theta;
    let (px, py) = (x + l * sin(theta), -l * cos(theta));
    kinetic = kinetic_energy(m, dot(x)) + kinetic_energy(m, dot((px, py)));
    potential = gravitational_energy(m, g, py);

    reduce Misspelt { small thetta; }
    reduce NoCoordinate { freeze l = 1; small phi; }
    reduce Both { freeze theta = 0; small theta; }
    reduce Twice { freeze x = 0, x = 1; }
    reduce Everything { freeze x = 0, theta = 0; }
    reduce Nothing {}
}

lagrange::system! {
    struct Ball;

    coord x;
    reduce TooEarly { freeze y = 0; }
    coord y;
    kinetic = kinetic_energy(1, dot((x, y)));
}

fn main() {}
