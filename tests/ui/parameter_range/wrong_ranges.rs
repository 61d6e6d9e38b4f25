lagrange::system! {
    struct Slider;

    param m: kg > 0 = -1, mu in 0..=1 = 1.5, k: N/m in 2..=1, l: mm in 10 = 20;
    coord x: m in 0..1 nominal -1;
    kinetic = kinetic_energy(m, dot(x));
    potential = spring_energy(mu * k, x - l);
}

fn main() {}
