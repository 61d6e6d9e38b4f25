//! Reduced types with names of all kinds.

lagrange::system! {
    /// Parameters and coordinates with the names that conversions use.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Whole;

    param state = 0.5, system = 2.0, stiff = 1.5, L = 0.3, m = 1.0;
    /// A push.
    input u;
    coord a, b, c;
    kinetic = 1/2 * m * (dot(a)^2 + system * dot(b)^2 + dot(c)^2 + stiff * dot(a) * dot(b) / 4);
    potential = state * cos(a - b) + L * c^2 * exp(a);
    force c = u;
    output place = a + b + c;

    /// With a value from a function.
    reduce Held { freeze a = sqrt(state + system) * sin(L), b = pi; }
    reduce Near { small a, b = 1e-3; }
    reduce Both { freeze c = 0; small a = state; }
}

lagrange::system! {
    /// Without parameters, in any number type.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Bare<T>;

    coord x, y;
    kinetic = 1/2 * dot(x)^2 + 3/7 * dot(y)^2;
    potential = cos(x * y);

    reduce Line { freeze x = 1/3; }
    reduce Origin { small x, y; }
}

lagrange::system! {
    /// In single precision.
    #[scalar(f32)]
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Single;

    coord x, y;
    kinetic = 1/2 * dot(x)^2 + 3/7 * dot(y)^2;
    potential = cosh(x - y);

    reduce Shorter { freeze y = 0.1; }
}

lagrange::system! {
    /// Ignored coordinates beside names that conversions use.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Turned<T>;

    param rates = 1.5, momenta = 2, held = 0.25, reduced = 1;
    /// Angles.
    coord own, phi[2], state, system;
    kinetic = rates * dot(own)^2 + momenta * (dot(phi[0]) - dot(own))^2 + 1/2 * dot(phi[1])^2;
    kinetic = 1/2 * reduced * dot(state)^2 + 1/2 * (1 + state^2) * dot(system)^2;
    potential = held * cos(state);

    /// Everything at once.
    reduce Ignoring { ignore phi, system; freeze own = sqrt(held); }
    reduce Nearly { ignore phi, system; small state = 1/3; }
}

lagrange::system! {
    /// Nothing but coordinates.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Plain<T>;

    coord x, y;
    kinetic = 1/2 * dot(x)^2 + 3/7 * (dot(y) + x)^2;

    reduce OnlyX { ignore y; }
}

#[cfg(test)]
mod tests {
    use super::{
        Bare, BareState, Held, HeldState, Ignoring, IgnoringState, Line, LineState, OnlyX, Plain, PlainState,
        Turned, TurnedState, Whole, WholeState,
    };

    #[test]
    fn momenta_are_taken_from_states_and_give_velocities_back() {
        let (turned, plain) = (Turned::<f64>::default(), Plain::<f64>::default());
        let state = TurnedState::from([0.5, 0.1, 0.2, 0.3, 0.4, 0.0, 1.5, 2.5, 3.5, 4.5]);
        let ignoring = Ignoring::from_state(&turned, 0.0, state);
        let close = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-12);
        close(ignoring.phi_0_momentum, 6.0);
        close(ignoring.system_momentum, 1.09 * 4.5);
        let back: [f64; 10] = ignoring.expand(0.0, IgnoringState::from(state)).into();
        for (found, expected) in back.into_iter().zip(<[f64; 10]>::from(state)) {
            close(found, expected);
        }
        for lost in <[f64; 10]>::from(ignoring.deviation(0.0, state)) {
            close(lost, 0.0);
        }
        assert_eq!(Turned::from(&ignoring), turned);
        let only = OnlyX::from_state(&plain, 0.0, PlainState { x: 1.0, y: 2.0, x_dot: 3.0, y_dot: 6.0 });
        close(only.y_momentum, 6.0);
        assert_eq!(Plain::from(&only), plain);
    }

    #[test]
    fn names_mean_what_the_user_means() {
        let whole = Whole::default();
        let held = Held::from(&whole);
        assert_eq!(Whole::from(&held), whole);
        let state = held.expand(HeldState { c: 1.0, c_dot: 2.0 });
        let a = 2.5_f64.sqrt() * 0.3_f64.sin();
        let expected = WholeState { a, b: core::f64::consts::PI, c: 1.0, a_dot: 0.0, b_dot: 0.0, c_dot: 2.0 };
        let deviation = held.deviation(expected);
        assert!((state.a - a).abs() < 1e-15 && deviation.a.abs() < 1e-15);
        assert_eq!(WholeState { a, ..state }, expected);
    }

    #[test]
    fn generic_types_convert() {
        let line = Line::from(&Bare::<f64>::default());
        let state = line.expand(LineState { y: 1.0, y_dot: 2.0 });
        assert_eq!(state, BareState { x: 1.0 / 3.0, y: 1.0, x_dot: 0.0, y_dot: 2.0 });
    }
}
