lagrange::system! {
    struct Cart;

    param k = 1.0;
    coord x, y;
    kinetic = kinetic_energy(1, dot(x)) + kinetic_energy(dot(y));
    potential = sin(x, y) + atan2(x) + spring_energy() + x.hypot() + gravitational_energy(k, x);
    potential = norm((x, y), 2) + inner((x, y)) + dot() + ln(x, 2) + min(x) + x.powi();
}

fn main() {}
