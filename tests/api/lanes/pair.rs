//! Two numbers side by side.

use core::array::from_fn;
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

use lagrange::Number;
use lagrange::scalar::Mask;
use lagrange::system::SideBySide;

/// Two numbers that undergo the same operations.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pair(pub(super) [f64; 2]);

/// Two truth values.
#[derive(Clone, Copy, Debug)]
pub(super) struct PairMask([bool; 2]);

macro_rules! operators {
    ($type:ident; $($operator:ident::$method:ident),*) => {
        $(impl $operator for $type {
            type Output = $type;
            fn $method(self, other: $type) -> $type {
                $type(from_fn(|lane| self.0[lane].$method(other.0[lane])))
            }
        })*
    };
}

operators!(Pair; Add::add, Sub::sub, Mul::mul, Div::div);
operators!(PairMask; BitAnd::bitand, BitOr::bitor);

impl Neg for Pair {
    type Output = Pair;
    fn neg(self) -> Pair {
        Pair(self.0.map(|number| -number))
    }
}

impl Not for PairMask {
    type Output = PairMask;
    fn not(self) -> PairMask {
        PairMask(self.0.map(|value| !value))
    }
}

impl Mask for PairMask {
    fn splat(value: bool) -> PairMask {
        PairMask([value; 2])
    }

    fn any(self) -> bool {
        self.0[0] || self.0[1]
    }

    fn all(self) -> bool {
        self.0[0] && self.0[1]
    }

    fn lane(self, lane: usize) -> bool {
        self.0[lane]
    }
}

impl SideBySide for Pair {
    type Element = f64;
    type One = Pair;
    const LANES: usize = 2;

    fn lane(self, lane: usize) -> f64 {
        self.0[lane]
    }

    fn set_lane(&mut self, lane: usize, value: f64) {
        self.0[lane] = value;
    }
}

/// Forwards methods of `Number` to each number, without or with a second one.
macro_rules! number_by_number {
    ($($method:ident),*; $($binary:ident),*) => {
        $(fn $method(self) -> Pair {
            Pair(self.0.map(<f64 as Number>::$method))
        })*
        $(fn $binary(self, other: Pair) -> Pair {
            Pair(from_fn(|lane| <f64 as Number>::$binary(self.0[lane], other.0[lane])))
        })*
    };
}

impl Number for Pair {
    type Mask = PairMask;

    const ZERO: Pair = Pair([0.0; 2]);
    const ONE: Pair = Pair([1.0; 2]);
    const NAN: Pair = Pair([f64::NAN; 2]);

    fn from_f64(value: f64) -> Pair {
        Pair([value; 2])
    }

    fn less(self, other: Pair) -> PairMask {
        PairMask(from_fn(|lane| self.0[lane] < other.0[lane]))
    }

    fn less_equal(self, other: Pair) -> PairMask {
        PairMask(from_fn(|lane| self.0[lane] <= other.0[lane]))
    }

    fn select(mask: PairMask, then: Pair, otherwise: Pair) -> Pair {
        Pair(from_fn(|lane| if mask.0[lane] { then.0[lane] } else { otherwise.0[lane] }))
    }

    fn sin_cos(self) -> (Pair, Pair) {
        (self.sin(), self.cos())
    }

    number_by_number!(sin, cos, tan, asin, acos, atan, sinh, cosh, tanh, exp, ln, sqrt, abs; atan2, hypot, powf);
}
