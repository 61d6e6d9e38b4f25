//! Notations from paper or other languages: derivatives as quotients, powers of functions, paths.

use proc_macro2::{Delimiter, TokenTree};

use super::cursor::Cursor;
use super::foreign;
use super::keywords;
use super::messages;
use super::messages::habits;
use super::parser::Parser;
use lagrange_expr::diagnostics::Origin;

/// Place of an error, message and advice.
type Habit = (Origin, &'static str, String);

/// Replacement for an argument that is too long to be repeated.
const SOMETHING: &str = "…";

impl Parser<'_> {
    /// Returns the message for the word here and the following tokens, if these are only valid in
    /// other notations.
    pub(super) fn habit(&self, cursor: &Cursor) -> Option<Habit> {
        self.quotient(cursor).or_else(|| power_of_function(cursor)).or_else(|| self.path(cursor))
    }

    /// Detects `d/dt(e)`, `d(e)/dt`, `dx/dt`, `d^2/dt^2(e)`, `d2x/dt2`.
    fn quotient(&self, cursor: &Cursor) -> Option<Habit> {
        let word = cursor.ident()?.to_string();
        if self.declared(&word).is_some() {
            return None;
        }
        let mut tokens = Ahead { cursor, count: 1 };
        let order = if word.starts_with("d2") || tokens.square() { 2 } else { 1 };
        let mut of = match word.strip_prefix("d2").or(word.strip_prefix('d'))? {
            "" => tokens.argument(),
            of => Some(of.to_owned()),
        };
        tokens.is('/').then_some(())?;
        let divisor = tokens.word()?;
        let is_time = divisor == "dt" || divisor == "dt2" && order == 2;
        if !is_time || self.declared(&divisor).is_some() {
            return None;
        }
        if order == 2 {
            tokens.square();
        }
        if of.is_none() {
            of = tokens.argument().or_else(|| tokens.word());
        }
        let function = if order == 1 { "dot" } else { "ddot" };
        let usage = format!("{function}({})", of.unwrap_or_else(|| SOMETHING.to_owned()));
        let help = match order == 1 || self.accepts_accelerations {
            true => habits::written(&usage),
            false => habits::NO_ACCELERATIONS_HELP.to_owned(),
        };
        Some((tokens.origin(), habits::QUOTIENT, help))
    }

    /// Detects `std::f64::consts::PI`, `f64::sin(x)`, `crate::GRAVITY`, `np.cos(x)`.
    pub(super) fn path(&self, cursor: &Cursor) -> Option<Habit> {
        let word = cursor.ident()?.to_string();
        let is_library = foreign::is_library(&word) && self.declared(&word).is_none();
        let mut tokens = Ahead { cursor, count: 1 };
        let mut last = None;
        // Longer paths do not occur; this is not a loop over all tokens.
        for _ in 0..LONGEST_PATH {
            let is_link = tokens.is(':') && tokens.is(':') || is_library && tokens.is('.');
            if !is_link {
                break;
            }
            last = Some(tokens.word()?);
        }
        let last = last?;
        let is_call = tokens.has_argument();
        let help = match foreign::name(&last) {
            Some(meant) if !is_call => habits::written(meant),
            _ if !is_call && keywords::built_in(&last).is_some() => habits::written(&last),
            _ if is_call && (is_library || keywords::is_function(&last)) => messages::PATH_HELP.to_owned(),
            _ if self.declared(&word).is_some() => habits::written(format!("{word}.{last}")),
            _ => habits::RUST_NAME_HELP.to_owned(),
        };
        let message = if is_library { habits::LIBRARY } else { messages::PATH };
        Some((tokens.origin(), message, help))
    }
}

/// Detects `sin^2(x)`, `sin^2 x`, `sin^-1(x)` and `sin^(-1)(x)`.
fn power_of_function(cursor: &Cursor) -> Option<Habit> {
    let word = cursor.ident()?.to_string();
    let mut tokens = Ahead { cursor, count: 1 };
    if !keywords::is_function(&word) || !tokens.is('^') {
        return None;
    }
    let sign = if tokens.is('-') { "-" } else { "" };
    let exponent = match tokens.argument() {
        Some(exponent) => exponent,
        None => tokens.number().or_else(|| tokens.word())?,
    };
    let exponent = format!("{sign}{exponent}").replace(' ', "");
    let argument = tokens.argument().or_else(|| tokens.word()).unwrap_or_else(|| SOMETHING.to_owned());
    let inverse = format!("a{word}");
    let usage = match exponent.as_str() {
        "-1" if keywords::is_function(&inverse) => format!("{inverse}({argument})"),
        "-1" => format!("1/{word}({argument})"),
        _ if exponent.starts_with('-') => format!("{word}({argument})^({exponent})"),
        _ => format!("{word}({argument})^{exponent}"),
    };
    Some((tokens.origin(), habits::POWER_OF_FUNCTION, habits::written(&usage)))
}

/// Maximum number of words that are read of a path.
const LONGEST_PATH: usize = 16;

/// Lookahead over tokens after the cursor, one after the other.
struct Ahead<'a> {
    cursor: &'a Cursor,
    count: usize,
}

impl Ahead<'_> {
    fn peek(&self) -> Option<&TokenTree> {
        self.cursor.peek_past(self.count)
    }

    /// Moves past the next token.
    fn passed<T>(&mut self, found: T) -> T {
        self.count += 1;
        found
    }

    /// True if this character comes next.
    fn is(&mut self, character: char) -> bool {
        let found = matches!(self.peek(), Some(TokenTree::Punct(punct)) if punct.as_char() == character);
        self.count += usize::from(found);
        found
    }

    fn word(&mut self) -> Option<String> {
        let Some(TokenTree::Ident(word)) = self.peek() else { return None };
        let word = word.to_string();
        Some(self.passed(word))
    }

    fn number(&mut self) -> Option<String> {
        let Some(TokenTree::Literal(number)) = self.peek() else { return None };
        let number = number.to_string();
        Some(self.passed(number))
    }

    /// True if `^2` comes next.
    fn square(&mut self) -> bool {
        let before = self.count;
        let found = self.is('^') && self.number().as_deref() == Some("2");
        if !found {
            self.count = before;
        }
        found
    }

    fn has_argument(&self) -> bool {
        matches!(self.peek(), Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis)
    }

    /// Returns the contents of the next parentheses, if they are short.
    fn argument(&mut self) -> Option<String> {
        let Some(TokenTree::Group(group)) = self.peek().filter(|_| self.has_argument()) else { return None };
        let tokens = group.stream().into_iter().collect::<Vec<_>>();
        let text = match &tokens[..] {
            [token] => token.to_string(),
            [sign, token] if sign.to_string() == "-" => format!("-{token}"),
            _ => SOMETHING.to_owned(),
        };
        Some(self.passed(text))
    }

    /// Returns the place from the cursor to the last visited token.
    fn origin(&self) -> Origin {
        self.cursor.reaching(self.count)
    }
}
