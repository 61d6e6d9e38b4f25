//! Common state and helpers of the readers of statements and expressions.

use proc_macro2::{Group, TokenTree};

use super::ast::{AstId, Expression, Expressions, StatementKind};
use super::cursor::{Cursor, group_origin};
use super::messages;
use lagrange_expr::collections::HashMap;
use lagrange_expr::collections::HashSet;
use lagrange_expr::diagnostics::Origin;
use lagrange_expr::diagnostics::Report;
use lagrange_expr::limits::MAX_NESTING;

/// Parser of one declaration; the grammar is spread over modules named after its parts.
pub(super) struct Parser<'r> {
    pub(super) report: &'r mut Report,
    pub(super) expressions: Expressions,
    /// True if tokens of the current statement have been skipped, so that nothing is reported about
    /// its end.
    pub(super) skipped: bool,
    /// True while indices are read, which support the operator `%`.
    pub(super) counts: bool,
    /// Variables of the enclosing loops and sums.
    pub(super) variables: Vec<String>,
    /// Words in text that was omitted from the syntax tree.
    pub(super) unreadable_words: HashSet<String>,
    /// Names that were declared in readable text.
    pub(super) declared_names: HashMap<String, Declared>,
    /// True if something is declared without a name.
    pub(super) lacks_names: bool,
    /// True if a unit of measurement is written anywhere.
    pub(super) has_units: bool,
    /// True if one of the units is not that of plain numbers or angles.
    pub(super) has_dimensions: bool,
    /// True in bounds of ranges, which an equals sign may follow.
    pub(super) precedes_default: bool,
    /// True in statements that accept accelerations.
    pub(super) accepts_accelerations: bool,
    /// Messages that are only reported once per statement.
    said: HashSet<String>,
    depth: u32,
}

/// Kind of a declared name that affects reading.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Declared {
    Parameter,
    Coordinate,
    State,
    Other,
}

impl Declared {
    /// Returns the kind of the names that a statement declares.
    pub(super) fn by(kind: &StatementKind) -> Declared {
        match kind {
            StatementKind::Parameters(_) | StatementKind::Inputs(_) | StatementKind::Constants(_) => {
                Declared::Parameter
            }
            StatementKind::Coordinates(_) => Declared::Coordinate,
            StatementKind::States(..) | StatementKind::Mode(_) => Declared::State,
            _ => Declared::Other,
        }
    }
}

/// An error has been reported that makes a part of the input unreadable.
pub(super) struct Reported;

/// Result of reading, unless an error was reported instead.
pub(super) type Parsed<T> = Result<T, Reported>;

impl<'r> Parser<'r> {
    pub(super) fn new(report: &'r mut Report) -> Parser<'r> {
        Parser {
            report,
            expressions: Expressions::default(),
            skipped: false,
            counts: false,
            variables: Vec::new(),
            unreadable_words: HashSet::default(),
            declared_names: HashMap::default(),
            lacks_names: false,
            has_units: false,
            has_dimensions: false,
            precedes_default: false,
            accepts_accelerations: false,
            said: HashSet::default(),
            depth: 0,
        }
    }

    /// Reports an error with help.
    pub(super) fn fail_with_help(
        &mut self,
        origin: impl Into<Origin>,
        message: impl Into<String>,
        help: impl Into<String>,
    ) -> Reported {
        self.report.error(origin, message).help(help);
        Reported
    }

    /// Reports an error that is likely to occur repeatedly in a statement, only at its first place.
    pub(super) fn fail_once(&mut self, origin: impl Into<Origin>, message: &str, help: &str) -> Reported {
        if self.said.insert(message.to_owned()) {
            self.report.error(origin, message).help(help);
        }
        Reported
    }

    /// True if [`Parser::fail_once`] has reported this for the statement.
    pub(super) fn has_said(&self, message: &str) -> bool {
        self.said.contains(&message.to_owned())
    }

    /// Clears the record of reports on the last statement.
    pub(super) fn begin_statement(&mut self) {
        self.skipped = false;
        self.said = HashSet::default();
    }

    /// Returns the kind that a name was declared as in readable text.
    pub(super) fn declared(&self, name: &str) -> Option<Declared> {
        self.declared_names.get(&name.to_owned()).copied()
    }

    /// Returns a placeholder for the tokens since a position, which are unreadable after a reported
    /// error.
    pub(super) fn unreadable(&mut self, cursor: &Cursor, start: usize) -> AstId {
        self.expressions.add(Expression::Invalid, cursor.since(start))
    }

    /// Records the words since a position, which are omitted from the syntax tree. Variables of
    /// loops are not: they are declared where the loop begins.
    pub(super) fn leave_out(&mut self, cursor: &Cursor, start: usize) {
        let mut pending = cursor.taken_since(start).to_vec();
        while let Some(token) = pending.pop() {
            match token {
                TokenTree::Ident(word) if self.variables.contains(&word.to_string()) => {}
                TokenTree::Ident(word) => drop(self.unreadable_words.insert(word.to_string())),
                TokenTree::Group(group) => pending.extend(group.stream()),
                TokenTree::Punct(_) | TokenTree::Literal(_) => {}
            }
        }
    }

    /// Reads the content of a group.
    pub(super) fn inside<T>(
        &mut self,
        group: &Group,
        read: impl FnOnce(&mut Self, &mut Cursor) -> Parsed<T>,
    ) -> Parsed<T> {
        self.nested(group_origin(group), |parser| {
            let (mut cursor, mistakes) = (Cursor::inside(group), parser.report.diagnostics().len());
            let content = read(parser, &mut cursor);
            parser.refuse_brackets(&mut cursor, mistakes);
            content
        })
    }

    /// Reports square brackets after a word that cannot have any, unless there are other errors
    /// around it.
    pub(super) fn refuse_brackets(&mut self, cursor: &mut Cursor, mistakes: usize) {
        let unread = cursor.forget_brackets();
        if let Some(group) = unread.filter(|_| self.report.diagnostics().len() == mistakes) {
            self.fail_with_help(group_origin(&group), messages::INDEX, messages::INDEX_HELP);
        }
    }

    /// Checks that tokens that are kept as they are can be traversed recursively.
    pub(super) fn shallow(&mut self, cursor: &mut Cursor) -> Parsed<()> {
        for token in cursor.rest() {
            if let TokenTree::Group(group) = token {
                self.inside(group, Self::shallow)?;
            }
        }
        Ok(())
    }

    /// Reads something that may contain others of its kind.
    pub(super) fn nested<T>(
        &mut self,
        origin: Origin,
        read: impl FnOnce(&mut Self) -> Parsed<T>,
    ) -> Parsed<T> {
        if self.depth == MAX_NESTING {
            let help = messages::NESTED_TOO_DEEPLY_HELP;
            return Err(self.fail_with_help(origin, messages::NESTED_TOO_DEEPLY, help));
        }
        self.depth += 1;
        let result = read(self);
        self.depth -= 1;
        result
    }
}
