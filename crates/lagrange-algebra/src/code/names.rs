//! Names of the local variables of one function.

use proc_macro2::{Ident, Span};

use lagrange_expr::collections::HashMap;
use lagrange_expr::collections::HashSet;
use lagrange_expr::keywords::is_rust_keyword;
use lagrange_expr::opaque::Opaque;
use lagrange_expr::symbol::Role;
use lagrange_expr::symbol::Symbols;

/// Allocates unique local names.
///
/// All identifiers have mixed-site spans, so they cannot clash with names outside the macro's
/// output.
#[derive(Clone, Default, Debug)]
pub struct Names {
    taken: HashSet<String>,
    roles: HashMap<Role, Ident>,
    next: HashMap<String, usize>,
    /// Spans at which the declaration names functions of the user's crate.
    callees: HashMap<String, Span>,
}

impl Names {
    /// Creates an allocator that never returns one of the `reserved` names.
    pub fn new<'a>(reserved: impl IntoIterator<Item = &'a str>) -> Names {
        let taken = reserved.into_iter().map(ToOwned::to_owned).collect();
        Names { taken, ..Names::default() }
    }

    /// Reserves a name, so that it is not used for a variable.
    pub fn reserve(&mut self, name: &str) {
        self.taken.insert(name.to_owned());
    }

    /// Records the place where the user names a function.
    pub fn place_callee(&mut self, name: &str, span: Span) {
        self.callees.insert(name.to_owned(), span);
    }

    /// Returns the name of a function of the user's crate. Unlike a variable, it is resolved at the
    /// place where the declaration names it or the function whose derivative it is.
    pub fn callee(&self, function: &Opaque) -> Ident {
        let name = function.rust_name();
        let place = self.callees.get(&name).or_else(|| self.callees.get(&function.function().name));
        Ident::new(&name, place.copied().unwrap_or_else(Span::call_site))
    }

    /// Returns the variable that holds the symbol in `role`: its own name, `x_dot` and `x_ddot` for
    /// the rates of `x`, `t` for time. If the name is taken, underscores are appended.
    pub fn role(&mut self, symbols: &Symbols, role: Role) -> Ident {
        if let Some(known) = self.roles.get(&role) {
            return known.clone();
        }
        let symbol = symbols.find(role).map(|id| symbols.get(id).identifier());
        let mut name = sanitise(&match (role, symbol) {
            (Role::Time, _) => "t".to_owned(),
            (_, symbol) => symbol.unwrap_or_else(|| "value".to_owned()),
        });
        while self.taken.contains(&name) {
            name.push('_');
        }
        let ident = self.take(name);
        self.roles.insert(role, ident.clone());
        ident
    }

    /// Assigns a variable to a symbol without its own name: `wish`, or a similar name if that is
    /// taken.
    pub fn assign(&mut self, role: Role, wish: &str) {
        let ident = self.fresh(wish);
        self.roles.insert(role, ident);
    }

    /// Allocates a variable called `wish`, or `wish_2`, `wish_3` … if that is taken.
    pub fn fresh(&mut self, wish: &str) -> Ident {
        let wish = sanitise(wish);
        if self.taken.contains(&wish) { self.count_up(&wish, 2) } else { self.take(wish) }
    }

    /// Allocates a variable called `stem_0`, `stem_1` …
    pub fn numbered(&mut self, stem: &str) -> Ident {
        self.count_up(stem, 0)
    }

    fn count_up(&mut self, stem: &str, first: usize) -> Ident {
        loop {
            let next = self.next.get_or_insert_with(stem.to_owned(), || first);
            let name = sanitise(&format!("{stem}_{next}"));
            *next += 1;
            if !self.taken.contains(&name) {
                return self.take(name);
            }
        }
    }

    fn take(&mut self, name: String) -> Ident {
        let ident = Ident::new(&name, Span::mixed_site());
        self.taken.insert(name);
        ident
    }
}

/// Converts `name`, which consists of the user's identifiers and suffixes, to the most similar
/// valid identifier.
fn sanitise(name: &str) -> String {
    let mut name = name.replace(|c: char| c != '_' && !c.is_alphabetic() && !c.is_ascii_digit(), "_");
    if name.starts_with(|c: char| c.is_ascii_digit()) {
        name.insert(0, '_');
    }
    if matches!(name.as_str(), "" | "_") {
        return "value".to_owned();
    }
    if is_rust_keyword(&name) || may_be_constant(&name) {
        name.push('_');
    }
    name
}

/// True if a name is spelt like a constant or a unit struct. A variable with this name could be
/// mistaken for one in scope, since hygiene does not cover constants.
fn may_be_constant(name: &str) -> bool {
    let is_type = name.starts_with(char::is_uppercase) && !name.contains('_');
    is_type || (name.contains(char::is_uppercase) && !name.contains(char::is_lowercase))
}

#[cfg(test)]
mod tests {
    use super::Names;
    use lagrange_expr::symbol::{Role, Symbols};

    #[test]
    fn names_are_unique_and_valid() {
        let mut names = Names::new(["q"]);
        let wishes = ["x", "x", "x_2", "x", "q", "self", "m[0]", "2nd", "", "_", "θ", "a²", "M"];
        let given = wishes.map(|wish| names.fresh(wish).to_string());
        let expected =
            ["x", "x_2", "x_2_2", "x_3", "q_2", "self_", "m_0_", "_2nd", "value", "value_2", "θ", "a_", "M_"];
        assert_eq!(given, expected);
        assert_eq!(names.numbered("pos").to_string(), "pos_0");
        assert_eq!(names.numbered("pos").to_string(), "pos_1");
        assert_eq!(names.numbered("const").to_string(), "const_0");
    }

    #[test]
    fn symbols_keep_their_names_and_rates_add_to_them() {
        let mut symbols = Symbols::default();
        let roles = [
            ("x", Role::Coordinate(0)),
            ("x", Role::Velocity(0)),
            ("x", Role::Acceleration(0)),
            ("x_dot", Role::Parameter(0)),
            ("t", Role::Time),
            ("t", Role::Input(0)),
        ];
        let mut names = Names::default();
        let given = roles.map(|(name, role)| {
            symbols.intern(name, role);
            names.role(&symbols, role).to_string()
        });
        assert_eq!(given, ["x", "x_dot", "x_ddot", "x_dot_", "t", "t_"]);
        assert_eq!(names.role(&symbols, Role::Coordinate(0)).to_string(), "x");
    }
}
