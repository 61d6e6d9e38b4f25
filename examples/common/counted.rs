//! A number type that counts its operations.

use std::cell::Cell;
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use lagrange::{Number, Scalar};

/// Operations on numbers.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub(crate) struct Counts {
    /// Sums, differences, products and quotients.
    pub(crate) arithmetic: u32,
    /// Elementary functions; a sine and its cosine count as one.
    pub(crate) functions: u32,
}

impl Counts {
    pub(crate) fn total(self) -> u32 {
        self.arithmetic + self.functions
    }
}

thread_local! {
    static COUNTS: Cell<Counts> = const { Cell::new(Counts { arithmetic: 0, functions: 0 }) };
}

/// Counts the operations of `run` on this thread.
pub(crate) fn counted<T>(run: impl FnOnce() -> T) -> Counts {
    COUNTS.set(Counts::default());
    run();
    COUNTS.get()
}

fn arithmetic(value: f64) -> Counted {
    COUNTS.set(Counts { arithmetic: COUNTS.get().arithmetic + 1, ..COUNTS.get() });
    Counted(value)
}

fn function(value: f64) -> Counted {
    COUNTS.set(Counts { functions: COUNTS.get().functions + 1, ..COUNTS.get() });
    Counted(value)
}

/// A number in double precision.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(crate) struct Counted(f64);

impl PartialOrd for Counted {
    fn partial_cmp(&self, other: &Counted) -> Option<Ordering> {
        self.0.partial_cmp(&other.0)
    }
}

impl Add for Counted {
    type Output = Counted;
    fn add(self, other: Counted) -> Counted {
        arithmetic(self.0 + other.0)
    }
}

impl Sub for Counted {
    type Output = Counted;
    fn sub(self, other: Counted) -> Counted {
        arithmetic(self.0 - other.0)
    }
}

impl Mul for Counted {
    type Output = Counted;
    fn mul(self, other: Counted) -> Counted {
        arithmetic(self.0 * other.0)
    }
}

impl Div for Counted {
    type Output = Counted;
    fn div(self, other: Counted) -> Counted {
        arithmetic(self.0 / other.0)
    }
}

impl Neg for Counted {
    type Output = Counted;
    fn neg(self) -> Counted {
        Counted(-self.0)
    }
}

/// Functions of one argument.
macro_rules! functions {
    ($($name:ident)*) => {
        $(fn $name(self) -> Counted {
            function(self.0.$name())
        })*
    };
}

impl Scalar for Counted {
    fn is_finite(self) -> bool {
        self.0.is_finite()
    }
}

impl Number for Counted {
    type Mask = bool;

    const ZERO: Counted = Counted(0.0);
    const ONE: Counted = Counted(1.0);
    const NAN: Counted = Counted(f64::NAN);

    fn from_f64(value: f64) -> Counted {
        Counted(value)
    }

    fn less(self, other: Counted) -> bool {
        self < other
    }

    fn less_equal(self, other: Counted) -> bool {
        self <= other
    }

    fn select(mask: bool, then: Counted, otherwise: Counted) -> Counted {
        if mask { then } else { otherwise }
    }

    fn sin_cos(self) -> (Counted, Counted) {
        let (sine, cosine) = self.0.sin_cos();
        (function(sine), Counted(cosine))
    }

    functions! { sin cos tan asin acos atan sinh cosh tanh exp ln sqrt }

    fn abs(self) -> Counted {
        Counted(self.0.abs())
    }

    fn atan2(self, abscissa: Counted) -> Counted {
        function(self.0.atan2(abscissa.0))
    }

    fn hypot(self, other: Counted) -> Counted {
        function(self.0.hypot(other.0))
    }

    fn powf(self, exponent: Counted) -> Counted {
        function(Number::powf(self.0, exponent.0))
    }
}
