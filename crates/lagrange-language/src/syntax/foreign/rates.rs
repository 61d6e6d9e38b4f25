//! Spellings of rates: `dx`, `xdot`, `x_ddot`, `ẋ`.

/// Prefixes of the name of a coordinate for its derivatives, with their order; longer ones first.
const BEFORE: &[(&str, usize)] = &[
    ("velocity_", 1),
    ("omega_", 1),
    ("alpha_", 2),
    ("ddot_", 2),
    ("ddot", 2),
    ("vel_", 1),
    ("acc_", 2),
    ("dot_", 1),
    ("dot", 1),
    ("dd_", 2),
    ("d2", 2),
    ("dd", 2),
    ("d_", 1),
    ("v_", 1),
    ("a_", 2),
    ("w_", 1),
    ("d", 1),
    ("D", 1),
    ("v", 1),
    ("a", 2),
];
/// Suffixes of the name of a coordinate for its derivatives, with their order.
const BEHIND: &[(&str, usize)] = &[
    ("_velocity", 1),
    ("_acceleration", 2),
    ("_prime", 1),
    ("_rate", 1),
    ("_ddot", 2),
    ("_dot", 1),
    ("_vel", 1),
    ("_acc", 2),
    ("prime", 1),
    ("_dd", 2),
    ("_tt", 2),
    ("ddot", 2),
    ("DDot", 2),
    ("dot", 1),
    ("Dot", 1),
    ("\u{308}", 2),
    ("\u{307}", 1),
    ("_d", 1),
    ("_t", 1),
    ("_p", 1),
    ("_v", 1),
    ("dd", 2),
    ("pp", 2),
    ("d", 1),
    ("p", 1),
];
/// Letters with built-in dots.
const DOTTED: &[(&str, &str, usize)] = &[
    ("ẋ", "x", 1),
    ("ẏ", "y", 1),
    ("ż", "z", 1),
    ("ṙ", "r", 1),
    ("ṡ", "s", 1),
    ("ẍ", "x", 2),
    ("ÿ", "y", 2),
];

/// Functions that differentiate, with respect to time by default.
const DERIVATIVES: &[&str] = &[
    "dot",
    "diff",
    "d",
    "der",
    "derivative",
    "Derivative",
    "D",
    "Dt",
    "deriv",
    "dt",
    "ddt",
    "d_dt",
    "rate",
    "time_derivative",
];
/// Functions that differentiate twice.
const SECOND_DERIVATIVES: &[&str] = &["dotdot", "der2", "d2dt2", "dddt"];
/// Words for a rate if only one coordinate moves.
const WORDS: &[&str] =
    &["omega", "w", "velocity", "speed", "vel", "v", "qdot", "qd", "thetadot", "phidot", "xdot"];

/// A rate in foreign spelling.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Rate<'a> {
    /// Quantity that changes.
    pub of: &'a str,
    /// Order of the time derivative: once or twice.
    pub order: usize,
}

impl Rate<'_> {
    /// Returns the spelling here.
    pub fn written(self) -> String {
        let function = if self.order == 1 { "dot" } else { "ddot" };
        format!("{function}({})", self.of)
    }
}

/// Returns the rate denoted by a foreign function call: `diff(x, t)`, `der(x)`, `D(x, t, 2)`.
pub(super) fn derivative<'a>(function: &str, arguments: &'a [String]) -> Option<Rate<'a>> {
    let (of, by) = arguments.split_first()?;
    if SECOND_DERIVATIVES.contains(&function) && by.is_empty() {
        return Some(Rate { of, order: 2 });
    }
    let by = by.iter().map(String::as_str).collect::<Vec<_>>();
    let order = match by[..] {
        [] | ["t"] => 1,
        ["2"] if function != "dot" => 2,
        ["t", "t" | "2"] => 2,
        _ => return None,
    };
    DERIVATIVES.contains(&function).then_some(Rate { of, order })
}

/// True if a function denotes a time derivative, here or in other languages.
pub fn derives(function: &str) -> bool {
    DERIVATIVES.contains(&function)
}

/// True if a name is a word for the rate of an unnamed quantity.
pub fn is_word_for_rate(name: &str) -> bool {
    WORDS.contains(&name)
}

/// Returns the rate denoted by a foreign name, if its variable passes the test.
pub fn rate<'a>(name: &'a str, moves: impl Fn(&str) -> bool) -> Option<Rate<'a>> {
    let dotted = DOTTED.iter().filter(|(letter, ..)| *letter == name).map(|&(_, of, order)| (of, order));
    let before = BEFORE.iter().filter_map(|&(mark, order)| Some((name.strip_prefix(mark)?, order)));
    let behind = BEHIND.iter().filter_map(|&(mark, order)| Some((name.strip_suffix(mark)?, order)));
    // A doubled letter is a typo.
    let before = before.filter(|(of, _)| *of != &name[..name.len() - of.len()]);
    let found = dotted.chain(behind).chain(before).find(|(of, _)| moves(of));
    found.map(|(of, order)| Rate { of, order })
}
