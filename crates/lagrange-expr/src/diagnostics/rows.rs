//! Messages as rows: a name, the gaps to be filled in, and the text.

/// Writes a table of messages, all with the visibility on its first line.
///
/// A row without gaps is a constant. A row with gaps is a function that fills them with displayable
/// values; the text is followed by values for `{}`, as in `format!`.
///
/// ```
/// mod words {
///     lagrange_expr::diagnostics::messages! {
///         pub(super):
///
///         NO_WHEELS = "there are no wheels";
///         too_few(noun, least) = "at least {least} {noun} are needed";
///     }
/// }
///
/// assert_eq!(words::NO_WHEELS, "there are no wheels");
/// assert_eq!(words::too_few("wheels", 3), "at least 3 wheels are needed");
/// ```
#[macro_export]
#[doc(hidden)]
macro_rules! messages {
    (@row [$($head:tt)*] $name:ident = $text:literal) => {
        $($head)* const $name: &str = $text;
    };
    (@row [$($head:tt)*] $name:ident ($($gap:ident),+) = $text:literal $(, $value:expr)*) => {
        $($head)* fn $name($($gap: impl ::std::fmt::Display),+) -> String {
            format!($text $(, $value)*)
        }
    };
    (pub $scope:tt:
        $($(#[$meta:meta])* $name:ident $(($($gap:ident),+))? = $text:literal $(, $value:expr)*;)*) => {
        $($crate::messages! {
            @row [$(#[$meta])* pub $scope] $name $(($($gap),+))? = $text $(, $value)*
        })*
    };
}
