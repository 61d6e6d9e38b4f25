//! Declarations in both forms.

/// Compiles a declaration and keeps its text.
macro_rules! both_ways {
    ($($(#[$attribute:meta])* $System:ident = $TEXT:ident { $($statements:tt)* })*) => {$(
        lagrange::system! {
            $(#[$attribute])*
            #[derive(Clone, Debug)]
            pub(crate) struct $System;
            $($statements)*
        }
        pub(crate) const $TEXT: &str =
            concat!("pub(crate) struct ", stringify!($System), ";", stringify!($($statements)*));
    )*};
}
