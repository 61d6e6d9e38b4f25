//! Functions of the standard library, or of `libm` without it.

/// Defines a function for each row of the list.
macro_rules! of_platform {
    ($(
        $name:ident($($argument:ident),*) C($libm:ident, $libmf:ident) lanes $lanes:tt $method:tt
    )*) => {
        $(#[allow(dead_code, reason = "not every function has a formula that needs it")]
        pub(crate) fn $name($($argument: f64),*) -> f64 {
            #[cfg(feature = "std")]
            let value = f64::$name($($argument),*);
            #[cfg(not(feature = "std"))]
            let value = libm::$libm($($argument),*);
            value
        })*
    };
}

crate::functions!(of_platform);
