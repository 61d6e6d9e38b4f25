//! Fragments of Rust expressions with the information needed to parenthesise them.

use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use quote::{ToTokens, quote_spanned};

/// Binding strength of the outermost operation.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) enum Precedence {
    /// Additions and subtractions.
    Sum,
    /// Multiplications and divisions.
    Product,
    /// A change of sign.
    Sign,
    /// Names, literals, calls, parentheses.
    Atom,
}

/// An expression with the data needed to insert it into a larger one.
#[derive(Clone, Debug)]
pub(super) struct Fragment {
    pub(super) tokens: TokenStream,
    precedence: Precedence,
    starts_with_minus: bool,
    /// Number of operations.
    pub(super) operations: usize,
    /// Approximate length in characters.
    pub(super) width: usize,
}

impl Fragment {
    /// Creates a fragment that never needs parentheses and costs nothing.
    pub(super) fn atom(tokens: TokenStream, width: usize) -> Fragment {
        Fragment { tokens, precedence: Precedence::Atom, starts_with_minus: false, operations: 0, width }
    }

    /// Creates a variable.
    pub(super) fn name(ident: &Ident) -> Fragment {
        Fragment::atom(ident.to_token_stream(), ident.to_string().chars().count())
    }

    /// Creates a number from its text.
    pub(super) fn number(text: &str) -> Fragment {
        let magnitude: Literal = super::literal::literal(text.trim_start_matches('-'));
        let atom = Fragment::atom(magnitude.into_token_stream(), text.len());
        if text.starts_with('-') { atom.negated().free() } else { atom }
    }

    /// Creates `[a, b, …]`.
    pub(super) fn array(elements: Vec<Fragment>) -> Fragment {
        let operations = elements.iter().map(|element| element.operations).sum::<usize>();
        let width = elements.iter().map(|element| element.width + 2).sum::<usize>();
        let elements = elements.into_iter().map(|element| element.tokens);
        let tokens = quote_spanned!(Span::mixed_site()=> [#(#elements),*]);
        Fragment { operations, ..Fragment::atom(tokens, width) }
    }

    /// Creates a choice, which is either enclosed in braces or the right side of a `let`.
    pub(super) fn block(tokens: TokenStream) -> Fragment {
        Fragment { operations: 1, ..Fragment::atom(tokens, usize::MAX / 4) }
    }

    /// Marks a fragment as free of cost.
    pub(super) fn free(self) -> Fragment {
        Fragment { operations: 0, ..self }
    }

    /// True if it can be written several times without being computed several times.
    pub(super) fn is_free(&self) -> bool {
        self.operations == 0
    }

    /// Creates `left + right`, with the chain on the left if only one operand is a chain.
    pub(super) fn sum(left: Fragment, right: Fragment) -> Fragment {
        let swap = right.precedence == Precedence::Sum && left.precedence != Precedence::Sum;
        let (left, right) = if swap { (right, left) } else { (left, right) };
        Fragment::binary(left, '+', right, Precedence::Sum)
    }

    /// Creates `left - right`.
    pub(super) fn difference(left: Fragment, right: Fragment) -> Fragment {
        Fragment::binary(left, '-', right, Precedence::Sum)
    }

    /// Creates `left * right`, with the chain on the left if only one operand is a chain.
    pub(super) fn product(left: Fragment, right: Fragment) -> Fragment {
        let swap = right.precedence == Precedence::Product && left.precedence != Precedence::Product;
        let (left, right) = if swap { (right, left) } else { (left, right) };
        Fragment::binary(left, '*', right, Precedence::Product)
    }

    /// Creates `left / right`.
    pub(super) fn quotient(left: Fragment, right: Fragment) -> Fragment {
        Fragment::binary(left, '/', right, Precedence::Product)
    }

    /// Creates a binary operation. Operators associate to the left, so a right operand of the same
    /// precedence needs parentheses.
    fn binary(left: Fragment, operator: char, right: Fragment, precedence: Precedence) -> Fragment {
        let left = if left.precedence < precedence { left.parenthesised() } else { left };
        let bare = right.precedence > precedence && !right.starts_with_minus;
        let right = if bare { right } else { right.parenthesised() };
        let mut tokens = left.tokens;
        tokens.extend([TokenTree::from(punct(operator))]);
        tokens.extend(right.tokens);
        Fragment {
            tokens,
            precedence,
            starts_with_minus: left.starts_with_minus,
            operations: left.operations + right.operations + 1,
            width: left.width + right.width + 3,
        }
    }

    /// Creates `-self`. In front of a product, the sign applies to the first factor, which gives
    /// the same bits.
    pub(super) fn negated(self) -> Fragment {
        let bare = self.precedence >= Precedence::Product && !self.starts_with_minus;
        let operand = if bare { self } else { self.parenthesised() };
        let mut tokens = TokenStream::from(TokenTree::from(punct('-')));
        tokens.extend(operand.tokens);
        Fragment {
            tokens,
            precedence: operand.precedence.min(Precedence::Sign),
            starts_with_minus: true,
            operations: operand.operations + 1,
            width: operand.width + 1,
        }
    }

    fn parenthesised(self) -> Fragment {
        let group = Group::new(Delimiter::Parenthesis, self.tokens);
        let (tokens, width) = (TokenTree::from(group).into(), self.width + 2);
        Fragment { operations: self.operations, ..Fragment::atom(tokens, width) }
    }

    /// Creates `path(arguments)`.
    pub(super) fn call(path: &Fragment, arguments: Vec<Fragment>) -> Fragment {
        let operations = 1 + arguments.iter().map(|argument| argument.operations).sum::<usize>();
        let width = arguments.iter().map(|argument| argument.width + 2).sum::<usize>() + path.width;
        let (path, arguments) = (&path.tokens, arguments.into_iter().map(|argument| argument.tokens));
        Fragment {
            operations,
            ..Fragment::atom(quote_spanned!(Span::mixed_site()=> #path(#(#arguments),*)), width)
        }
    }
}

fn punct(operator: char) -> Punct {
    let mut punct = Punct::new(operator, Spacing::Alone);
    punct.set_span(Span::mixed_site());
    punct
}
