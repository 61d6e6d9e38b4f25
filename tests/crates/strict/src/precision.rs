//! Number types and visibilities.

lagrange::system! {
    /// In single precision.
    #[scalar(f32)]
    #[derive(Clone, Copy, Debug)]
    pub struct Single;

    param m = 0.1, g = 9.806_65;
    coord x, z;
    kinetic = 1/2 * m * (dot(x)^2 + dot(z)^2 * (1 + x^2));
    potential = m * g * z + 1.23456789012345 * cos(x * z);
}

lagrange::system! {
    /// With sines and cosines of several angles at a time.
    #[accuracy(fast)]
    #[derive(Clone, Copy, Debug)]
    pub struct Fast;

    param m = 0.1;
    coord alpha, beta;
    kinetic = 1/2 * m * (dot(alpha)^2 + dot(beta)^2 * (2 + sin(alpha)));
    potential = m * cos(2 * beta + alpha) * sin(alpha + cos(beta));
}

lagrange::system! {
    /// With sines and cosines of several angles at a time, in any number type.
    #[accuracy(fast)]
    #[derive(Clone, Copy, Debug)]
    pub struct FastAny<S>;

    param m = 0.1;
    coord alpha, beta;
    kinetic = 1/2 * m * (dot(alpha)^2 + dot(beta)^2 * (2 + sin(alpha)));
    potential = m * cos(2 * beta + alpha) * sin(alpha + cos(beta));
}

lagrange::system! {
    /// Returns visible in this crate only.
    #[derive(Clone, Copy, Debug)]
    pub(crate) struct Inner;

    param m = 1.0;
    coord x;
    kinetic = 1/2 * m * dot(x)^2;
}

lagrange::system! {
    /// Visible in this module only, and partly unused.
    struct Hidden;

    param m = 1.0;
    coord x;
    kinetic = 1/2 * m * dot(x)^2;
}

/// Returns an acceleration of a system declared in a function.
#[inline]
#[must_use]
pub fn acceleration(force: f64) -> f64 {
    lagrange::system! {
        struct Local;

        input push;
        coord x;
        kinetic = 1/2 * dot(x)^2;
        force x = push;
    }
    let [local] = Local { push: force }.acceleration(0.0, &[0.0], &[0.0]);
    let [inner] = Inner::default().acceleration(0.0, &[0.0], &[0.0]);
    let hidden = Hidden::default();
    local + inner + hidden.energy(0.0, &[0.0], &[0.0])
}

#[cfg(test)]
mod tests {
    use super::{Single, acceleration};

    #[test]
    fn constants_are_rounded_to_the_scalar() {
        let [_, fall] = Single::default().acceleration(0.0, &[0.0, 0.0], &[0.0, 0.0]);
        assert!((fall + 9.806_65_f32).abs() < 1e-5);
        assert!((acceleration(2.0) - 2.0).abs() < 1e-15);
    }
}
