//! Arrays and members of parts, after they have been replaced by their elements.

use super::{Declaration, Name};

/// An array that has been replaced by its elements.
#[derive(Clone, Debug)]
pub struct DeclaredArray {
    /// Name of the array.
    pub name: Name,
    /// Numbers of elements in each direction, if none is missing.
    pub sizes: Option<Vec<usize>>,
    /// Elements, the last index changing fastest.
    pub elements: Vec<ArrayElement>,
    /// The part that contains it, and its name in the part. A member that is not an array has one
    /// element without indices.
    pub member_of: Option<[String; 2]>,
}

/// An element of an array.
#[derive(Clone, Debug)]
pub struct ArrayElement {
    /// Name in expanded declarations: `theta_2`.
    pub name: String,
    /// Spelling in the declaration: `theta[2]`.
    pub written: String,
}

impl Declaration {
    /// Returns a name as it is written: `theta[2]` or `leg[0].knee` for an element or a member.
    pub fn written<'n>(&'n self, name: &'n str) -> &'n str {
        let mut elements = self.arrays.iter().flat_map(|array| &array.elements);
        elements.find(|element| element.name == name).map_or(name, |element| &element.written)
    }
}
