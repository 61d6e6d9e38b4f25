//! Names of elements: the array of each, and its name in the expanded declaration.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::Span;

use super::messages;
use crate::syntax::ast::{ArrayElement, DeclaredArray, Name};
use lagrange_expr::collections::{HashMap, OrderedMap};

/// All elements of a declaration.
#[derive(Default)]
pub(super) struct ElementNames {
    pub(super) arrays: OrderedMap<String, Array>,
    /// Names that are only declared with suffixes, with the suffix of the first such name.
    pub(super) owners: HashMap<String, String>,
    /// Names without indices.
    pub(super) plain: HashMap<String, Plain>,
    /// Names of elements, with the place of the declaration and their spelling.
    pub(super) texts: HashMap<String, (Span, String)>,
    /// Members of parts that are not arrays.
    pub(super) members: Vec<DeclaredArray>,
    /// Names that are local to loops, by their declaring statements.
    pub(super) locals: OrderedMap<(usize, String), DeclaredArray>,
}

/// A name without indices.
#[derive(Clone)]
pub(super) struct Plain {
    pub(super) span: Span,
    /// Identifier of the declaring statement.
    pub(super) statement: usize,
    pub(super) written: String,
    /// True for a `let`, whose value may be a vector.
    pub(super) is_let: bool,
}

/// Elements of one array.
pub(super) struct Array {
    pub(super) name: Name,
    /// Its name as written, with the part that it is a member of.
    pub(super) written: String,
    pub(super) member_of: Option<[String; 2]>,
    /// Numbers of elements, if they are declared together.
    pub(super) sizes: Option<Vec<i64>>,
    /// The number of indices.
    pub(super) rank: usize,
    /// True if its elements have values.
    pub(super) has_values: bool,
    /// True if elements can be called.
    pub(super) is_callable: bool,
    /// Places of elements, by their indices, with their names.
    pub(super) elements: BTreeMap<Vec<i64>, (Span, String)>,
}

impl Array {
    /// Returns the number of elements in each dimension, if none is missing.
    fn extents(&self) -> Option<Vec<usize>> {
        let end =
            |direction: usize| self.elements.keys().map(|indices| indices[direction] + 1).max().unwrap_or(0);
        let extents = (0..self.rank).map(|direction| usize::try_from(end(direction)));
        let extents = extents.collect::<Result<Vec<_>, _>>().ok()?;
        let count = extents.iter().fold(1, |count: usize, extent| count.saturating_mul(*extent));
        (count == self.elements.len()).then_some(extents)
    }

    fn element(&self, indices: &[i64], name: &str) -> ArrayElement {
        ArrayElement { name: name.to_owned(), written: messages::written(&self.written, indices) }
    }
}

impl ElementNames {
    /// True if a name belongs to an array.
    pub(super) fn is_array(&self, name: &str) -> bool {
        self.arrays.get(&name.to_owned()).is_some()
    }

    /// True if a name belongs to an array whose elements can be called.
    pub(super) fn is_callable(&self, name: &str) -> bool {
        self.arrays.get(&name.to_owned()).is_some_and(|array| array.is_callable)
    }

    /// Returns the name of an element.
    pub(super) fn text(&self, name: &str, indices: &[i64]) -> Option<&str> {
        let array = self.array(name)?;
        let suffix = self.owners.get(&name.to_owned()).map_or("", String::as_str);
        array.elements.get(indices).and_then(|(_, text)| text.strip_suffix(suffix))
    }

    /// True if elements have this name, including names that only own others, such as quaternions.
    pub(super) fn is_indexed(&self, name: &str) -> bool {
        self.array(name).is_some()
    }

    fn array(&self, name: &str) -> Option<&Array> {
        let owned = self.owners.get(&name.to_owned()).map(|suffix| format!("{name}{suffix}"));
        self.arrays.get(&owned.unwrap_or_else(|| name.to_owned()))
    }

    /// True if something is declared under a name; `names` are those without arrays and parts.
    pub(super) fn is_declared(&self, text: &str, names: &BTreeSet<String>) -> bool {
        names.contains(text) || self.plain.contains(&text.to_owned())
    }

    /// Returns the spelling of an element with this name.
    pub(super) fn as_written(&self, text: &str) -> Option<&str> {
        self.texts.get(&text.to_owned()).map(|(_, written)| written.as_str())
    }

    /// Returns the spelling of the local name with this expanded name.
    pub(super) fn local(&self, text: &str) -> Option<&str> {
        let mut elements = self.locals.iter().flat_map(|(_, local)| &local.elements);
        elements.find(|element| element.name == text).map(|element| element.written.as_str())
    }

    /// Returns the number of indices of an array whose elements have values.
    pub(super) fn rank_of_values(&self, name: &str) -> Option<usize> {
        self.arrays.get(&name.to_owned()).filter(|array| array.has_values).map(|array| array.rank)
    }

    /// Returns the sizes of an array of values without gaps.
    pub(super) fn sizes_of_values(&self, name: &str) -> Option<Vec<usize>> {
        self.arrays.get(&name.to_owned()).filter(|array| array.has_values)?.extents()
    }

    /// Returns the indices and names of all elements of an array.
    pub(super) fn all_of(&self, name: &str) -> Vec<(Vec<i64>, String)> {
        let elements = self.arrays.get(&name.to_owned()).into_iter().flat_map(|array| &array.elements);
        elements.map(|(indices, (_, text))| (indices.clone(), text.clone())).collect()
    }

    /// Returns the name of an element of an array of values.
    pub(super) fn text_of_value(&self, name: &str, indices: &[i64]) -> Option<&str> {
        self.arrays.get(&name.to_owned())?.elements.get(indices).map(|(_, text)| text.as_str())
    }

    /// True if a name without indices belongs to a `let`.
    pub(super) fn is_let(&self, name: &str) -> bool {
        self.plain.get(&name.to_owned()).is_some_and(|plain| plain.is_let)
    }

    /// Returns an example of the use of an array.
    pub(super) fn example(&self, name: &str) -> String {
        let first = self.array(name).and_then(|array| array.elements.keys().next());
        let written = self.array(name).map_or(name, |array| array.written.as_str());
        messages::written(written, first.map_or(&[0], |first| first))
    }

    /// Explains why an element does not exist; `None` if there is no such array.
    pub(super) fn objection(&self, name: &str, indices: &[i64]) -> Option<(String, String)> {
        let array = self.array(name)?;
        let name = array.written.as_str();
        if array.rank != indices.len() {
            return Some((
                messages::index_count(name, array.rank, indices.len()),
                messages::written_help(self.example(&array.name.text)),
            ));
        }
        let ends = array.elements.keys().next().zip(array.elements.keys().next_back());
        let (first, last) = ends?;
        let (first, last) = (messages::written(name, first), messages::written(name, last));
        let is_negative = indices.iter().any(|index| *index < 0);
        let message = match is_negative {
            true => messages::negative_index(messages::written(name, indices)),
            false => messages::no_element(messages::written(name, indices)),
        };
        let help = match &array.sizes {
            Some(_) => messages::elements_are(name, &first, &last),
            None => messages::elements_lie_between(name, &first, &last),
        };
        Some((message, help))
    }

    /// Returns the arrays in the order of their declarations.
    pub(super) fn arrays(&self) -> Vec<DeclaredArray> {
        let arrays = self.arrays.iter().map(|(_, array)| DeclaredArray {
            name: array.name.clone(),
            sizes: array.extents(),
            elements: array
                .elements
                .iter()
                .map(|(indices, (_, name))| array.element(indices, name))
                .collect(),
            member_of: array.member_of.clone(),
        });
        let locals = self.locals.iter().map(|(_, local)| local.clone());
        arrays.chain(self.members.iter().cloned()).chain(locals).collect()
    }
}
