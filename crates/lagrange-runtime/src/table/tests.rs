use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use super::{Axis, Table};
use crate::scalar::{Mask, Number};

const EVEN: Axis = Axis { knots: &[0.0, 0.5, 1.0, 1.5], density: 2.0 };
const UNEVEN: Axis = Axis { knots: &[-1.0, 0.0, 2.0], density: 0.0 };

/// Each piece has the value of its index.
const STEPS: Table<1, 1> = Table { axes: [EVEN], rows: &[[0.0], [1.0], [2.0], [3.0], [4.0]] };

#[test]
fn pieces_are_found() {
    let expected = [(-0.1, 0.0), (0.0, 1.0), (0.49, 1.0), (0.5, 2.0), (1.2, 3.0), (1.5, 3.0), (1.6, 4.0)];
    for (x, piece) in expected {
        assert_eq!(STEPS.value([x]), piece, "{x}");
        assert_eq!(STEPS.value([x as f32]), piece as f32, "{x}");
        let searched = Table { axes: [Axis { density: 0.0, ..EVEN }], ..STEPS };
        assert_eq!(searched.value([x]), piece, "{x}");
    }
    let ends = [-0.1, 0.0, 0.7, 1.5, 1.6].map(|x| EVEN.piece(x));
    let inf = f64::INFINITY;
    assert_eq!(ends, [[-inf, 0.0], [0.0, 0.5], [0.5, 1.0], [1.0, 1.5], [1.5, inf]]);
    assert!(EVEN.piece(f64::NAN)[0].is_nan());
    assert!(STEPS.value([f64::NAN]).is_nan() && STEPS.derivative([1], [f64::NAN]).is_nan());
}

#[test]
fn derivatives_are_those_of_the_polynomials() {
    let curve = Table {
        axes: [UNEVEN],
        rows: &[[0.0; 4], [1.0, -2.0, 3.0, 5.0], [0.0, 1.0, 0.0, 2.0], [f64::NAN; 4]],
    };
    let s = 0.25;
    let expected = [
        1.0 - 2.0 * s + 3.0 * s * s + 5.0 * s * s * s,
        -2.0 + 6.0 * s + 15.0 * s * s,
        6.0 + 30.0 * s,
        30.0,
        0.0,
    ];
    for (order, expected) in expected.into_iter().enumerate() {
        assert_eq!(curve.derivative([order], [-0.75]), expected);
    }
    assert_eq!(curve.value([2.0]), 2.0 + 16.0);
    assert!(curve.value([2.1_f64]).is_nan() && curve.derivative([3], [2.1_f64]).is_nan());
}

#[test]
fn tables_of_several_arguments_are_products() {
    // (1 + 2 s) (3 − r) on every piece.
    const ROWS: [[f64; 2]; 40] = rows();
    const fn rows() -> [[f64; 2]; 40] {
        let mut rows = [[3.0, -1.0]; 40];
        let mut piece = 0;
        while piece < 20 {
            rows[2 * piece + 1] = [6.0, -2.0];
            piece += 1;
        }
        rows
    }
    let surface = Table { axes: [UNEVEN, EVEN], rows: &ROWS };
    let (s, r) = (0.5, 0.25);
    assert_eq!(surface.value([-0.5, 0.75]), (1.0 + 2.0 * s) * (3.0 - r));
    assert_eq!(surface.derivative([1, 0], [-0.5, 0.75]), 2.0 * (3.0 - r));
    assert_eq!(surface.derivative([0, 1], [-0.5, 0.75]), -(1.0 + 2.0 * s));
    assert_eq!(surface.derivative([1, 1], [-0.5, 0.75]), -2.0);
    assert!(surface.value([f64::NAN, 0.0]).is_nan() && surface.value([0.0, f64::NAN]).is_nan());
    // The number of each piece, of three arguments.
    const NUMBERS: [[f64; 1]; 80] = numbers();
    const fn numbers() -> [[f64; 1]; 80] {
        let mut numbers = [[0.0]; 80];
        let mut piece = 0;
        while piece < 80 {
            numbers[piece][0] = piece as f64;
            piece += 1;
        }
        numbers
    }
    let numbers = Table { axes: [UNEVEN, UNEVEN, EVEN], rows: &NUMBERS };
    assert_eq!(numbers.value([0.5, -2.0, 1.7]), 44.0);
    assert_eq!(numbers.value([2.5, 0.5, 0.2_f32]), 71.0);
}

/// Two numbers in lanes.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Pair(f64, f64);

/// Two truth values in lanes.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Both(bool, bool);

macro_rules! in_pairs {
    ($($trait:ident $method:ident $type:ident;)*) => {
        $(impl $trait for $type {
            type Output = $type;
            fn $method(self, other: $type) -> $type {
                $type(self.0.$method(other.0), self.1.$method(other.1))
            }
        })*
    };
}

in_pairs! { Add add Pair; Sub sub Pair; Mul mul Pair; Div div Pair; BitAnd bitand Both; BitOr bitor Both; }

impl Neg for Pair {
    type Output = Pair;
    fn neg(self) -> Pair {
        Pair(-self.0, -self.1)
    }
}

impl Not for Both {
    type Output = Both;
    fn not(self) -> Both {
        Both(!self.0, !self.1)
    }
}

impl Mask for Both {
    fn splat(value: bool) -> Both {
        Both(value, value)
    }
    fn any(self) -> bool {
        self.0 || self.1
    }
    fn all(self) -> bool {
        self.0 && self.1
    }
    fn lane(self, lane: usize) -> bool {
        [self.0, self.1][lane]
    }
}

/// Defines functions of one argument, and of two, lane by lane.
macro_rules! number_by_number {
    ($($unary:ident)*; $($binary:ident)*) => {
        $(fn $unary(self) -> Pair {
            Pair(Number::$unary(self.0), Number::$unary(self.1))
        })*
        $(fn $binary(self, other: Pair) -> Pair {
            Pair(Number::$binary(self.0, other.0), Number::$binary(self.1, other.1))
        })*
    };
}

impl Number for Pair {
    type Mask = Both;
    const ZERO: Pair = Pair(0.0, 0.0);
    const ONE: Pair = Pair(1.0, 1.0);
    const NAN: Pair = Pair(f64::NAN, f64::NAN);
    fn from_f64(value: f64) -> Pair {
        Pair(value, value)
    }
    fn less(self, other: Pair) -> Both {
        Both(self.0 < other.0, self.1 < other.1)
    }
    fn less_equal(self, other: Pair) -> Both {
        Both(self.0 <= other.0, self.1 <= other.1)
    }
    fn select(mask: Both, then: Pair, otherwise: Pair) -> Pair {
        Pair(if mask.0 { then.0 } else { otherwise.0 }, if mask.1 { then.1 } else { otherwise.1 })
    }
    fn sin_cos(self) -> (Pair, Pair) {
        (self.sin(), self.cos())
    }
    number_by_number! { sin cos tan asin acos atan sinh cosh tanh exp ln sqrt abs; atan2 hypot powf }
}

#[test]
fn numbers_side_by_side_have_the_values_of_each() {
    let axis = Axis { knots: &[0.0, 0.5, 1.0, 1.5], density: 2.0 };
    let rows: &[[f64; 2]; 5] = &[[0.0, 0.0], [0.0, 3.0], [1.5, -1.0], [1.0, 2.0], [f64::NAN, f64::NAN]];
    let surface = Table { axes: [axis, UNEVEN], rows: &[[1.5, 2.0]; 40] };
    let arguments = [-0.1, 0.0, 0.3, 0.5, 0.77, 1.5, 1.6, f64::NAN];
    let same = |a: f64, b: f64| a == b || a.is_nan() && b.is_nan();
    for density in [2.0, 0.0] {
        let curve = Table { axes: [Axis { density, ..axis }], rows };
        for (a, b) in arguments.iter().flat_map(|a| arguments.iter().map(move |b| (*a, *b))) {
            for order in 0..3 {
                let Pair(first, second) = curve.derivative([order], [Pair(a, b)]);
                assert!(same(first, curve.derivative([order], [a])), "{a} beside {b}");
                assert!(same(second, curve.derivative([order], [b])), "{b} beside {a}");
            }
            let Pair(first, second) = surface.value([Pair(a, b), Pair(b, a)]);
            assert!(same(first, surface.value([a, b])) && same(second, surface.value([b, a])), "{a}, {b}");
        }
    }
}
