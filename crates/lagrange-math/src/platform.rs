//! Functions of the standard library, or of `libm` without it.

/// Defines functions, each a row of its arguments and its names in the standard library and in `libm`.
macro_rules! functions {
    ($($name:ident($($argument:ident),*): $libm:ident;)*) => {
        $(pub(crate) fn $name($($argument: f64),*) -> f64 {
            #[cfg(feature = "std")]
            let value = f64::$name($($argument),*);
            #[cfg(not(feature = "std"))]
            let value = libm::$libm($($argument),*);
            value
        })*
    };
}

functions! {
    sqrt(x): sqrt;
    tan(x): tan;
    sinh(x): sinh;
    cosh(x): cosh;
    atan2(y, x): atan2;
    hypot(x, y): hypot;
}
