//! Branches and functions of all kinds.

lagrange::system! {
    /// A block on a belt: dry friction, an end stop and a soft spring.
    #[derive(Clone, Debug)]
    pub struct Block;

    param m, k, mu, r = 0.1, belt = 0.3;
    param e = 0.123456789012345678901234567890;
    input brake;
    const g = 9.81;
    coord x;
    let slip = dot(x) - belt;
    kinetic = kinetic_energy(m, dot(x));
    potential = if x < r { spring_energy(k, x) } else if x < 2 * r { k * x^3 } else { 0 };
    dissipation = 1/2 * brake * slip^2 * max(abs(x), 0.001)^0.5;
    force x = -mu * m * g * sign(slip) * tanh(slip / e) * min(1, exp(-abs(slip)));
    output side = atan2(x, slip) + hypot(x, slip) + asin(x) + acos(x) + atan(x) + ln(2 + x) + sqrt(x^2);
    output shape = (sinh(x), cosh(x), tan(x)^-3);
    output period = 2 * pi * sqrt(m / k) + sqrt(2);
}

lagrange::system! {
    /// These branches in any number type.
    #[derive(Clone, Copy, Debug)]
    pub struct AnyBlock<S>;

    param m = 1.0, k = 2.0, r = 0.1;
    coord x;
    kinetic = kinetic_energy(m, dot(x));
    potential = if x < r { spring_energy(k, x) } else { k * x^3 * 1.7 };
    output shape = (sinh(x), if dot(x) >= 0 { 1 } else { -1 }, tan(x)^-3);
}

#[cfg(test)]
mod tests {
    use lagrange::event::Switches;

    use super::{AnyBlock, Block};

    #[test]
    fn the_branch_of_the_position_is_taken() {
        let block = Block {
            m: 2.0,
            k: 4.0,
            mu: 0.0,
            r: 0.1,
            belt: 0.3,
            e: 1.0,
            brake: 0.0,
            switches: Switches::FREE,
        };
        assert!((block.acceleration(0.0, &[0.05], &[0.0])[0] + 0.1).abs() < 1e-15);
        assert_eq!(block.acceleration(0.0, &[0.3], &[0.0]).map(f64::abs).map(f64::to_bits), [0]);
        let any = AnyBlock::<f32>::default();
        assert!((any.acceleration(0.0, &[0.05], &[0.0])[0] + 0.1).abs() < 1e-6);
    }
}
