//! Parameters, coordinates and outputs with names that generated code might use.

lagrange::system! {
    /// Coordinates with the names of method arguments.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Arguments;

    param y = 2.0, s = 0.5, f = 1.5, m = 1.0, state = 0.1;
    input u = 0.25;
    coord q, v, a;
    let tilt = sin(q) * cos(q);
    kinetic = 1/2 * y * (dot(q)^2 + (dot(v) + tilt * dot(q))^2) + 1/2 * m * dot(a)^2;
    potential = s * cos(q - v) + f * a^2 + state * sin(q)^4 * cos(v)^3;
    force a = u * sin(t);
    output x = a + q + v;
    output b = (dot(a), ddot(q), y);
}

lagrange::system! {
    /// Parameters with the names of functions that generated code calls.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Functions;

    param sin_cos = 1.0, multiply_add = 2.0, f64 = 1.0, private = 1.0, core = 1.0, lagrange = 1.0;
    coord sin_theta, theta;
    kinetic = 1/2 * sin_cos * dot(sin_theta)^2 + 1/2 * multiply_add * dot(theta)^2 + core * lagrange * dot(theta)^2;
    potential = f64 * sin(theta) * cos(sin_theta) * private * sin(theta + sin_theta);
}

lagrange::system! {
    /// Nothing depends on anything, so that all arguments are unused.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Free;

    coord x;
    kinetic = 1/2 * dot(x)^2;
    output one = 1;
}

lagrange::system! {
    /// Generic, without fields, and with a type parameter other than `S`.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Empty<T>;

    coord x, y;
    kinetic = 1/2 * dot(x)^2 + 3/7 * dot(y)^2;
    potential = 3/7 * x * y;
}

#[cfg(test)]
mod tests {
    use super::{Arguments, ArgumentsState, Empty, Free, Functions};

    #[test]
    fn names_mean_what_the_user_means() {
        let system = Arguments::default();
        let state = ArgumentsState { q: 0.1, v: 0.2, a: 0.3, q_dot: 1.0, v_dot: 2.0, a_dot: 3.0 };
        let y: [f64; 6] = state.into();
        let rate = system.rhs(0.0, &y);
        let output = system.b(0.0, &[0.1, 0.2, 0.3], &[1.0, 2.0, 3.0]);
        assert_eq!(
            [output[0], output[1], output[2]].map(f64::to_bits),
            [3.0, rate[3], 2.0].map(f64::to_bits)
        );
        let total = system.x(0.0, &[0.1, 0.2, 0.3], &[0.0; 3]);
        assert!((total - 0.6).abs() < 1e-15);
        // m ä = −2 f a + u sin t
        let acceleration = system.acceleration(1.0, &[0.0, 0.0, 0.5], &[0.0; 3]);
        assert!((acceleration[2] - 0.25_f64.mul_add(1.0_f64.sin(), -1.5)).abs() < 1e-15);
    }

    #[test]
    fn functions_are_not_taken_for_parameters() {
        let [first, second] = Functions::default().acceleration(0.0, &[0.3, 0.4], &[1.0, 1.0]);
        let force = 0.3_f64.sin().mul_add(0.7_f64.sin(), -(0.3_f64.cos() * 0.7_f64.cos())) * 0.4_f64.sin();
        assert!((first - force).abs() < 1e-15);
        assert!(second.is_finite());
    }

    #[test]
    fn what_depends_on_nothing_is_constant() {
        assert_eq!(Free.acceleration(1.0, &[2.0], &[3.0]).map(f64::to_bits), [0]);
        let empty = Empty::<f64>::default();
        assert_eq!(empty, Empty { scalar: core::marker::PhantomData });
        assert!((empty.acceleration(0.0, &[1.0, 2.0], &[0.0; 2])[1] + 0.5).abs() < 1e-15);
    }
}
