//! Square brackets after words.

use lagrange_expr::keywords::is_rust_keyword;
use std::collections::BTreeMap;

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

use super::keywords;

/// Square brackets that belong to words, by the indices of the words.
#[derive(Default)]
pub(super) struct SquareBrackets(BTreeMap<usize, Behind>);

/// Square brackets after one word.
#[derive(Default)]
struct Behind {
    groups: Vec<Group>,
    is_read: bool,
}

impl SquareBrackets {
    /// Extracts those after words that can be names from a sequence of tokens.
    pub(super) fn taken_out(stream: TokenStream) -> (Vec<TokenTree>, SquareBrackets) {
        let (mut tokens, mut brackets): (Vec<TokenTree>, _) = (Vec::new(), SquareBrackets::default());
        for token in stream {
            match token {
                TokenTree::Group(group)
                    if group.delimiter() == Delimiter::Bracket && tokens.last().is_some_and(can_be_name) =>
                {
                    brackets.0.entry(tokens.len() - 1).or_default().groups.push(group);
                }
                token => tokens.push(token),
            }
        }
        (tokens, brackets)
    }

    /// Returns the last ones after a word.
    pub(super) fn last(&self, word: usize) -> Option<&Group> {
        self.0.get(&word)?.groups.last()
    }

    /// Reads the groups after a word.
    pub(super) fn read(&mut self, word: usize) -> Vec<Group> {
        let Some(behind) = self.0.get_mut(&word) else { return Vec::new() };
        behind.is_read = true;
        behind.groups.clone()
    }

    /// Returns the first unread ones after a word before this index, and marks all of these as
    /// read.
    pub(super) fn forget(&mut self, end: usize) -> Option<Group> {
        let mut first = None;
        for behind in self.0.range_mut(..end).map(|(_, behind)| behind).filter(|behind| !behind.is_read) {
            behind.is_read = true;
            first = first.or_else(|| behind.groups.first().cloned());
        }
        first
    }
}

/// True for a word that can be indexed by square brackets.
fn can_be_name(token: &TokenTree) -> bool {
    let TokenTree::Ident(word) = token else { return false };
    let word = word.to_string();
    !(keywords::begins_statement(&word) || is_rust_keyword(&word) || keywords::is_function(&word))
}
