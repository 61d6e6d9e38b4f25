lagrange::system! {
    struct Train;

    param g = 9.81;
    part Wagon(m, on = 0) {
        coord x;
        kinetic = 1/2 * m * dot(x)^2;
        potential = m * g * (x - on);
    }
    wagon[i in 0..10]: Wagon { m: 2 + i; }
}

lagrange::system! {
    struct Pair;

    part Wagon(m, on = 0) {
        coord x;
        kinetic = 1/2 * m * dot(x)^2;
        potential = (x - on)^2;
    }
    wagon[i in 0..2]: Wagon { m: 2 + i; }
    output gap = wagon[1].x - wagon[0].xx;
}

lagrange::system! {
    struct Lost;

    part Wagon(m, on = 0) {
        coord x;
        kinetic = 1/2 * m * dot(x)^2;
        potential = (x - on)^2;
    }
    wagon[i in 0..10]: Wagon { on: i; }
}

fn main() {}
