//! One system in every number type.

use core::ops::{Add, Div, Mul, Neg, Sub};

use lagrange::{Number, Scalar};

lagrange::system! {
    #[derive(Clone, Copy, Debug)]
    struct Double;

    param m = 0.7, k = 1/3;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + exp(x) * dot(y)^2);
    potential = spring_energy(k, hypot(x, y) - 1);
    output ratio = if x < y { x / y } else { 2/3 };
}

lagrange::system! {
    #[scalar(f32)]
    #[derive(Clone, Copy, Debug)]
    struct Single;

    param m = 0.7, k = 1/3;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + exp(x) * dot(y)^2);
    potential = spring_energy(k, hypot(x, y) - 1);
    output ratio = if x < y { x / y } else { 2/3 };
}

lagrange::system! {
    #[derive(Clone, Copy, Debug)]
    struct Any<S>;

    param m = 0.7, k = 1/3;
    coord x, y;
    kinetic = 1/2 * m * (dot(x)^2 + exp(x) * dot(y)^2);
    potential = spring_energy(k, hypot(x, y) - 1);
    output ratio = if x < y { x / y } else { 2/3 };
}

/// Computes accelerations through the trait bound alone.
fn at_rest<S: Scalar>(system: &Any<S>, x: S, y: S) -> [S; 2] {
    system.acceleration(S::ZERO, &[x, y], &[S::ZERO; 2])
}

#[test]
fn all_number_types_compute_the_same() {
    let double = Double::default().acceleration(0.0, &[0.5, 0.8], &[0.1, -0.2]);
    let generic = Any::<f64>::default().acceleration(0.0, &[0.5, 0.8], &[0.1, -0.2]);
    assert_eq!(double, generic);
    let single: [f32; 2] = Single::default().acceleration(0.0, &[0.5, 0.8], &[0.1, -0.2]);
    assert_eq!(single, Any::<f32>::default().acceleration(0.0, &[0.5, 0.8], &[0.1, -0.2]));
    for (single, double) in single.into_iter().zip(double) {
        assert!((f64::from(single) - double).abs() < 1e-6);
    }
    assert_eq!(at_rest(&Any::default(), 0.0, 1.0), [0.0, 0.0]);
    assert_eq!(Single::default().ratio(0.0, &[1.0, 0.0], &[0.0; 2]), 2.0 / 3.0);
}

#[test]
fn branches_do_not_hide_what_is_not_a_number() {
    assert!(Double::default().ratio(0.0, &[f64::NAN, 0.0], &[0.0; 2]).is_nan());
    assert!(Any::<f32>::default().ratio(0.0, &[0.0, f32::NAN], &[0.0; 2]).is_nan());
}

/// A number type of the user: a value with its derivative, for sensitivities.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Dual(f64, f64);

impl PartialOrd for Dual {
    fn partial_cmp(&self, other: &Dual) -> Option<core::cmp::Ordering> {
        self.0.partial_cmp(&other.0)
    }
}

impl Add for Dual {
    type Output = Dual;
    fn add(self, other: Dual) -> Dual {
        Dual(self.0 + other.0, self.1 + other.1)
    }
}

impl Sub for Dual {
    type Output = Dual;
    fn sub(self, other: Dual) -> Dual {
        self + -other
    }
}

impl Mul for Dual {
    type Output = Dual;
    fn mul(self, other: Dual) -> Dual {
        Dual(self.0 * other.0, self.0 * other.1 + self.1 * other.0)
    }
}

impl Div for Dual {
    type Output = Dual;
    fn div(self, other: Dual) -> Dual {
        Dual(self.0 / other.0, (self.1 - self.0 / other.0 * other.1) / other.0)
    }
}

impl Neg for Dual {
    type Output = Dual;
    fn neg(self) -> Dual {
        Dual(-self.0, -self.1)
    }
}

/// Implements a function with its derivative.
macro_rules! elementary {
    ($($name:ident: $x:ident => $slope:expr;)*) => {
        $(fn $name(self) -> Dual {
            let Dual($x, rate) = self;
            Dual($x.$name(), rate * $slope)
        })*
    };
}

impl Scalar for Dual {
    fn is_finite(self) -> bool {
        self.0.is_finite() && self.1.is_finite()
    }
}

impl Number for Dual {
    type Mask = bool;

    const ZERO: Dual = Dual(0.0, 0.0);
    const ONE: Dual = Dual(1.0, 0.0);
    const NAN: Dual = Dual(f64::NAN, f64::NAN);

    fn from_f64(value: f64) -> Dual {
        Dual(value, 0.0)
    }

    fn less(self, other: Dual) -> bool {
        self < other
    }

    fn less_equal(self, other: Dual) -> bool {
        self <= other
    }

    fn select(mask: bool, then: Dual, otherwise: Dual) -> Dual {
        if mask { then } else { otherwise }
    }

    fn sin_cos(self) -> (Dual, Dual) {
        (self.sin(), self.cos())
    }

    elementary! {
        sin: x => x.cos();
        cos: x => -x.sin();
        tan: x => 1.0 / x.cos().powi(2);
        asin: x => 1.0 / (1.0 - x * x).sqrt();
        acos: x => -1.0 / (1.0 - x * x).sqrt();
        atan: x => 1.0 / (1.0 + x * x);
        sinh: x => x.cosh();
        cosh: x => x.sinh();
        tanh: x => 1.0 / x.cosh().powi(2);
        exp: x => x.exp();
        ln: x => 1.0 / x;
        sqrt: x => 0.5 / x.sqrt();
        abs: x => x.signum();
    }

    fn atan2(self, x: Dual) -> Dual {
        (self / x).atan()
    }

    fn hypot(self, other: Dual) -> Dual {
        (self * self + other * other).sqrt()
    }

    fn powf(self, exponent: Dual) -> Dual {
        (self.ln() * exponent).exp()
    }
}

#[test]
fn a_number_type_of_the_user_computes_sensitivities() {
    let [stiff, h] = [1.0 / 3.0, 1e-6];
    let sensitive = Any { m: Dual(0.7, 0.0), k: Dual(stiff, 1.0) };
    let [Dual(value, slope), _] = at_rest(&sensitive, Dual(0.5, 0.0), Dual(0.8, 0.0));
    let at = |k: f64| at_rest(&Any { m: 0.7, k }, 0.5, 0.8)[0];
    assert!((value - at(stiff)).abs() < 1e-15);
    assert!((slope - (at(stiff + h) - at(stiff - h)) / (2.0 * h)).abs() < 1e-8);
}
