//! Messages for unexpected tokens in expressions.

use proc_macro2::{Delimiter, TokenTree};

use super::cursor::Cursor;
use super::keywords;
use super::messages;
use super::messages::habits;
use super::messages::ranges;
use super::messages::units;
use super::parser::{Parser, Reported};
use lagrange_expr::units::{meaning, meant};

/// A message and help.
type Mistake = (String, String);

impl Parser<'_> {
    /// Reports a range after the default of a parameter.
    pub(super) fn range_behind_value(&mut self, cursor: &Cursor) -> Reported {
        self.fail_with_help(cursor.here_to_pair(), ranges::BEHIND_VALUE, ranges::BEHIND_VALUE_HELP)
    }

    /// Reports the next token, which should begin an operand but does not.
    pub(super) fn no_operand(&mut self, cursor: &Cursor) -> Reported {
        if let (Some(TokenTree::Punct(operator)), true) = (cursor.previous(), cursor.equals_past(0))
            && "+-*/^".contains(operator.as_char())
        {
            let origin = cursor.before().to(cursor.here());
            let message = habits::compound_assignment(operator.as_char());
            return self.fail_with_help(origin, message, habits::COMPOUND_ASSIGNMENT_HELP);
        }
        if cursor.ident().is_some_and(|word| self.unreadable_words.contains(&word.to_string())) {
            // A keyword as a name has been reported where it was declared.
            return Reported;
        }
        let (message, help) = operand_mistake(cursor)
            .unwrap_or_else(|| (messages::expected(messages::OPERAND, cursor.peek()), operand_help(cursor)));
        self.fail_with_help(cursor.here(), message, help)
    }

    /// Reports the next token, which should continue the previous expression or be the expected
    /// token.
    pub(super) fn no_operator(&mut self, cursor: &Cursor, wanted: &str) -> Reported {
        if let Some((origin, number)) = cursor.decimal_comma(0) {
            return self.fail_with_help(origin, habits::DECIMAL_COMMA, habits::decimal_point(&number));
        }
        let (message, help) =
            self.unit_mistake(cursor, wanted).or_else(|| operator_mistake(cursor)).unwrap_or_else(|| {
                (messages::expected_operator_or(wanted, cursor.peek()), operator_help(cursor, wanted))
            });
        self.fail_with_help(cursor.here_to_pair(), message, help)
    }

    /// Returns the error for a word after a number that is the name of both a unit and something
    /// declared, or of no unit.
    fn unit_mistake(&self, cursor: &Cursor, wanted: &str) -> Option<Mistake> {
        let (Some(TokenTree::Literal(number)), Some(word)) = (cursor.previous(), cursor.ident()) else {
            return None;
        };
        let (number, word) = (number.to_string(), word.to_string());
        if meaning(&word).is_none() {
            let unit = meant(&word).filter(|_| self.is_free_unit(&word))?;
            return Some((units::unknown(&word), units::with_space(&number, unit)));
        }
        if let Some((_, help)) = self.several_factors(cursor) {
            return Some((units::SEVERAL_FACTORS.to_owned(), help));
        }
        let message = messages::expected_operator_or(wanted, cursor.peek());
        self.declared(&word).map(|_| (message, units::product_or_unit(&number, &word)))
    }
}

fn mistake(message: &str, help: &str) -> Option<Mistake> {
    Some((message.to_owned(), help.to_owned()))
}

fn operand_mistake(cursor: &Cursor) -> Option<Mistake> {
    match character(cursor)? {
        '+' if is_doubled(cursor) => mistake(habits::INCREMENT, habits::INCREMENT_HELP),
        '+' => mistake(messages::UNARY_PLUS, messages::UNARY_PLUS_HELP),
        '&' => mistake(messages::REFERENCE, messages::REFERENCE_HELP),
        '!' => mistake(messages::LOGIC, messages::LOGIC_HELP),
        ':' if cursor.at_pair(':', ':') => mistake(messages::PATH, messages::PATH_HELP),
        _ => None,
    }
}

/// True at the end of a statement after a second plus sign.
fn is_doubled(cursor: &Cursor) -> bool {
    let is_plus = matches!(cursor.previous(), Some(TokenTree::Punct(plus)) if plus.as_char() == '+');
    let is_end = |token: &TokenTree| matches!(token, TokenTree::Punct(end) if end.as_char() == ';');
    is_plus && cursor.peek_past(1).is_none_or(is_end)
}

fn operand_help(cursor: &Cursor) -> String {
    let help = match cursor.peek() {
        Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Bracket => messages::VECTOR_HELP,
        Some(TokenTree::Group(_)) => messages::PARENTHESES_HELP,
        Some(TokenTree::Punct(punct)) => match punct.as_char() {
            '|' => messages::MAGNITUDE_HELP,
            '#' => messages::COMMENT_HELP,
            '.' if matches!(cursor.peek_past(1), Some(TokenTree::Literal(_))) => messages::LEADING_ZERO_HELP,
            _ => return missing_operand_help(cursor),
        },
        _ => return missing_operand_help(cursor),
    };
    help.to_owned()
}

/// Returns advice for a token that should be followed by an operand.
fn missing_operand_help(cursor: &Cursor) -> String {
    match cursor.previous() {
        Some(TokenTree::Punct(punct)) if "+-*/^.".contains(punct.as_char()) => {
            habits::missing_operand(punct.as_char().to_string())
        }
        _ => habits::MISSING_EXPRESSION.to_owned(),
    }
}

fn operator_mistake(cursor: &Cursor) -> Option<Mistake> {
    if cursor.at_word("as") {
        return mistake(messages::CONVERSION, messages::CONVERSION_HELP);
    }
    if let Some(group) = cursor.group(Delimiter::Bracket) {
        let first = group.stream().into_iter().next();
        let is_unit = first.is_some_and(|word| meaning(&word.to_string()).is_some());
        return mistake(messages::INDEX, if is_unit { units::BRACKETS_HELP } else { messages::INDEX_HELP });
    }
    match character(cursor)? {
        ':' if cursor.at_pair(':', ':') => mistake(messages::PATH, messages::PATH_HELP),
        '<' | '>' => mistake(messages::COMPARISON_PLACE, messages::COMPARISON_PLACE_HELP),
        '=' if !cursor.equals_past(0) => mistake(messages::COMPARISON_PLACE, messages::COMPARISON_PLACE_HELP),
        '!' if cursor.at_pair('!', '=') => {
            mistake(messages::COMPARISON_PLACE, messages::COMPARISON_PLACE_HELP)
        }
        '!' if matches!(cursor.peek_past(1), Some(TokenTree::Group(_))) => {
            mistake(messages::MACRO, messages::MACRO_HELP)
        }
        '!' => mistake(messages::FACTORIAL, messages::FACTORIAL_HELP),
        '%' => mistake(messages::REMAINDER, messages::REMAINDER_HELP),
        _ => None,
    }
}

fn operator_help(cursor: &Cursor, wanted: &str) -> String {
    if let Some(TokenTree::Ident(word)) = cursor.previous()
        && keywords::is_function(&word.to_string())
    {
        return messages::ARGUMENT_HELP.to_owned();
    }
    let help = match cursor.peek() {
        _ if wanted.contains('{') => messages::COMPARISON_PLACE_HELP,
        None => habits::LONELY_CHARACTER_HELP,
        _ if cursor.at_suffix() => messages::INDEX_LAST_HELP,
        Some(TokenTree::Ident(word))
            if ["if", "else", "then", "where", "when"].iter().any(|other| word == other) =>
        {
            messages::COMPARISON_PLACE_HELP
        }
        Some(TokenTree::Ident(word)) if word == "and" || word == "or" => messages::LOGIC_HELP,
        Some(TokenTree::Ident(word)) if word == "for" => habits::SUM_HELP,
        Some(TokenTree::Ident(word)) if word == "mod" => messages::REMAINDER_HELP,
        Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Brace => messages::PARENTHESES_HELP,
        Some(TokenTree::Ident(_) | TokenTree::Literal(_) | TokenTree::Group(_)) => messages::PRODUCT_HELP,
        Some(TokenTree::Punct(punct)) => match punct.as_char() {
            '#' => messages::COMMENT_HELP,
            ':' => messages::TYPE_HELP,
            '?' => habits::QUESTION_HELP,
            ',' if cursor.equals_past(2) => habits::SECOND_DEFINITION_HELP,
            ',' => habits::LIST_HELP,
            '=' => messages::SECOND_EQUALS_HELP,
            '|' => messages::MAGNITUDE_HELP,
            '&' => messages::LOGIC_HELP,
            '@' => messages::MATRIX_PRODUCT_HELP,
            _ => habits::LONELY_CHARACTER_HELP,
        },
    };
    help.to_owned()
}

fn character(cursor: &Cursor) -> Option<char> {
    match cursor.peek()? {
        TokenTree::Punct(punct) => Some(punct.as_char()),
        _ => None,
    }
}

/// True at `in` and bounds with two dots between them.
pub(super) fn at_range(cursor: &Cursor) -> bool {
    let rest = cursor.rest();
    let is = |token: &TokenTree, signs: &str| matches!(token, TokenTree::Punct(punct) if signs.contains(punct.as_char()));
    let item = rest.iter().take_while(|token| !is(token, ",;")).collect::<Vec<_>>();
    item.windows(2).any(|pair| pair.iter().all(|token| is(token, ".")))
}
