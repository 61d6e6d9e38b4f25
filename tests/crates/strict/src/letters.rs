//! Names with the letters of formulas, where constants and types have the same names.

/// A constant with the name of a parameter.
pub const G: f64 = 6.674e-11;
/// A unit struct with the name of a coordinate.
#[derive(Clone, Copy, Debug)]
pub struct X;
/// A static with the name of a coordinate.
pub static Y_1: f64 = 0.0;

lagrange::system! {
    /// Capitals, Greek letters, subscripts and accents.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct Letters;

    param M = 2.0, G = 1.0, λ = 1.0, größe = 1.0, a__b = 1.0, _unused = 0.0;
    coord θ, X, Y_1, x_;
    let Lz = M * dot(X) * Y_1;
    kinetic = 1/2 * M * (λ^2 * dot(θ)^2 + dot(X)^2 + dot(Y_1)^2 + größe * dot(x_)^2);
    potential = M * G * λ * sin(θ) * cos(X) + a__b * sin(Y_1)^2 + sin(x_) * Y_1;
    output L = Lz^2 + G;
    emit { bias, latex, prepared, lanes }
}

lagrange::system! {
    /// One capital letter as a type and as a value.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub struct Capital<S>;

    param S = 1.0, Self_ = 2.0;
    coord T;
    kinetic = 1/2 * S * Self_ * dot(T)^2;
}

#[cfg(test)]
mod tests {
    use super::{Capital, CapitalState, G, Letters, X, Y_1};

    #[test]
    fn fields_are_not_taken_for_constants() {
        let letters = Letters::default();
        let momentum = letters.L(0.0, &[0.0, 0.0, 3.0, 0.0], &[0.0, 1.0, 0.0, 0.0]);
        assert!((momentum - 37.0).abs() < 1e-12);
        assert!(G < 1.0 && Y_1 < 1.0);
        let _: X = X;
        assert!(Letters::EQUATIONS_LATEX.contains("θ"));
        let state = CapitalState::from([1.0, 2.0]);
        assert_eq!(state, CapitalState { T: 1.0, T_dot: 2.0 });
        let inertia = Capital::<f32> { S: 2.0, Self_: 0.5 }.mass_matrix(0.0, &[0.0]);
        assert!((inertia[0][0] - 1.0).abs() < 1e-6);
    }
}
