//! Functions that are known by their values alone: those of the user's crate, tables, and solutions
//! of equations.
//!
//! Functions of the crate are only assumed to return equal values for equal arguments. A derivative
//! is another function, which the user names or [`default_name`] does. Its values are known at run
//! time only. Tables are differentiated piece by piece, and emitted code has functions of the same
//! default names for them. Solutions of equations have derivatives with a formula, by implicit
//! differentiation (`calculus::implicit`).

mod spline;
mod surface;
mod table;

use std::hash::{Hash, Hasher};
use std::sync::Arc;

pub use spline::{Interpolation, Outside};
pub use table::{Axis, Table};

/// A function without a formula.
#[derive(Clone, PartialEq, Debug)]
pub struct OpaqueFunction {
    /// Its name in the declaration.
    pub name: String,
    /// The names of its arguments.
    pub parameters: Vec<String>,
    /// Source of its values.
    pub source: Source,
}

/// Source of the values of an opaque function.
#[derive(Clone, PartialEq, Debug)]
pub enum Source {
    /// A function of the user's crate.
    Crate {
        /// Derivatives that it has, with the functions that compute them; `None` if every
        /// derivative has its default name.
        derivatives: Option<Vec<(Orders, String)>>,
    },
    /// A table with as many axes as the function has arguments.
    Table(Table),
    /// Equations that the graph keeps: the function is a part of their solution. It has no orders,
    /// derivatives being formulas.
    Equation {
        /// The names of all that the equations define together.
        unknowns: Vec<String>,
        /// The place of this one among them.
        place: usize,
    },
    /// A function of the run time that computes contact points of two blocks. Its values are those
    /// of features of the blocks: their derivatives count as zero.
    ContactPoints {
        /// The names of all that it computes.
        numbers: Vec<String>,
        /// The place of this one among them.
        place: usize,
    },
}

/// Order of differentiation by each argument of a function.
pub type Orders = Vec<u8>;

/// The value of an opaque function, or one of its derivatives. Equal are those with the same name
/// and the same orders: no declaration has two functions of one name.
#[derive(Clone, Debug)]
pub struct Opaque {
    function: Arc<OpaqueFunction>,
    orders: Orders,
}

impl PartialEq for Opaque {
    fn eq(&self, other: &Opaque) -> bool {
        self.orders == other.orders && self.function.name == other.function.name
    }
}

impl Eq for Opaque {}

impl Hash for Opaque {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.function.name.hash(state);
        self.orders.hash(state);
    }
}

impl Opaque {
    /// Returns the function itself.
    pub fn value_of(function: OpaqueFunction) -> Opaque {
        let orders = vec![0; function.parameters.len()];
        Opaque { function: Arc::new(function), orders }
    }

    /// Returns the function of which this is the value or a derivative.
    pub fn function(&self) -> &OpaqueFunction {
        &self.function
    }

    /// Returns the number of arguments.
    pub fn arity(&self) -> usize {
        self.orders.len()
    }

    /// Returns the order of differentiation by each argument.
    pub fn orders(&self) -> &[u8] {
        &self.orders
    }

    /// Returns the total order of differentiation.
    pub fn order(&self) -> usize {
        self.orders.iter().map(|order| usize::from(*order)).sum()
    }

    /// Returns the partial derivative with respect to an argument.
    pub fn derivative(&self, argument: usize) -> Opaque {
        let mut derivative = self.clone();
        derivative.orders[argument] = derivative.orders[argument].saturating_add(1);
        derivative
    }

    /// True if it is the solution of an equation.
    pub fn is_solution(&self) -> bool {
        matches!(self.function.source, Source::Equation { .. })
    }

    /// True if the run time computes it as a number of contact points.
    pub fn is_contact_point(&self) -> bool {
        matches!(self.function.source, Source::ContactPoints { .. })
    }

    /// Returns the place among the values that are computed together: those of several equations,
    /// or of contact points. It is 0 for others.
    pub fn place(&self) -> usize {
        match self.function.source {
            Source::Equation { place, .. } | Source::ContactPoints { place, .. } => place,
            _ => 0,
        }
    }

    /// Returns the names of all unknowns that are solved for together, or of all numbers of contact
    /// points; none for other functions.
    pub fn unknowns(&self) -> &[String] {
        match &self.function.source {
            Source::Equation { unknowns, .. } => unknowns,
            Source::ContactPoints { numbers, .. } => numbers,
            _ => &[],
        }
    }

    /// Returns the name of the Rust function that computes it: the user's, or the default.
    pub fn rust_name(&self) -> String {
        if self.is_solution() {
            return format!("solve_{}", self.unknowns().join("_"));
        }
        if self.is_contact_point() {
            return format!("contact_points_of_{}_numbers", self.unknowns().len());
        }
        let default = || default_name(&self.function.name, &self.function.parameters, &self.orders);
        self.declared().map_or_else(default, str::to_owned)
    }

    /// True if there is no such function: the user lists the derivatives, and this one is not among
    /// them.
    pub fn is_missing(&self) -> bool {
        let are_listed = matches!(self.function.source, Source::Crate { derivatives: Some(_) });
        are_listed && self.order() > 0 && self.declared().is_none()
    }

    fn declared(&self) -> Option<&str> {
        let Source::Crate { derivatives: Some(derivatives) } = &self.function.source else { return None };
        let declared = derivatives.iter().find(|(orders, _)| *orders == self.orders);
        declared.map(|(_, name)| name.as_str())
    }

    /// Returns the table, if it is one.
    pub fn table(&self) -> Option<&Table> {
        match &self.function.source {
            Source::Table(table) => Some(table),
            Source::Crate { .. } | Source::Equation { .. } | Source::ContactPoints { .. } => None,
        }
    }

    /// True if it is zero everywhere: a derivative of a table of higher order than its polynomials,
    /// or of a number of a contact point.
    pub fn vanishes(&self) -> bool {
        self.is_contact_point() && self.order() > 0
            || self.table().is_some_and(|table| table.vanishes(&self.orders))
    }

    /// True if it jumps between pieces of a table: a derivative of higher order than are
    /// continuous.
    pub fn jumps(&self) -> bool {
        let is_higher = |table: &Table| self.orders.iter().any(|order| *order > table.continuous_orders());
        self.table().is_some_and(is_higher)
    }

    /// Returns its value, if it is a table.
    pub fn known_value(&self, arguments: &[f64]) -> Option<f64> {
        self.table().map(|table| table.value(&self.orders, arguments))
    }

    /// Returns a value in place of the unknown one, to find at one point whether expressions may
    /// differ. It is a number between 1/2 and 3/2 determined by the function, the orders and the
    /// arguments, and NaN if an argument is.
    pub fn stand_in(&self, arguments: &[f64]) -> f64 {
        let name = self.function.name.bytes().map(f64::from);
        let orders = self.orders.iter().map(|order| f64::from(*order));
        let known = name.chain(orders).chain(arguments.iter().copied());
        // Multiples of the golden ratio keep apart.
        let mixed =
            known.fold(1.0, |mixed, next| (mixed * 1.618_033_988_749_895 + next * 0.754_877_666).fract());
        1.0 + 0.5 * mixed
    }

    /// Returns the name as written in formulas: with primes, or with the arguments of
    /// differentiation.
    pub fn text(&self) -> String {
        let name = &self.function.name;
        match self.orders[..] {
            [order] => format!("{name}{}", "'".repeat(usize::from(order))),
            _ => default_name(name, &self.function.parameters, &self.orders),
        }
    }

    /// Returns the name in LaTeX.
    pub fn latex(&self) -> String {
        let name = format!(r"\operatorname{{{}}}", self.function.name.replace('_', r"\_"));
        match self.orders[..] {
            [order] => format!("{name}{}", "'".repeat(usize::from(order))),
            _ => {
                let by = self.orders.iter().enumerate().filter(|(_, order)| **order > 0);
                let by = by.map(|(argument, order)| match order {
                    1 => format!(r"\partial_{{{}}}", argument + 1),
                    _ => format!(r"\partial_{{{}}}^{{{order}}}", argument + 1),
                });
                by.collect::<String>() + &name
            }
        }
    }

    /// Returns the label in a declaration: `second_derivative`, or `by alpha, speed`.
    pub fn label(&self) -> String {
        match self.orders[..] {
            [order] if ordinal(order).is_some() => {
                default_name("", &[], &self.orders).trim_start_matches('_').to_owned()
            }
            _ => {
                let by = arguments(&self.function.parameters, &self.orders).collect::<Vec<_>>();
                format!("by {}", by.join(", "))
            }
        }
    }

    /// Describes it in words: "the second derivative of `road`", or "the derivative of `lift` by
    /// `alpha`, `speed`".
    pub fn describe(&self) -> String {
        let name = &self.function.name;
        if self.order() == 0 {
            return format!("`{name}`");
        }
        if let [order] = self.orders[..] {
            return match ordinal(order) {
                None => format!("the derivative of order {order} of `{name}`"),
                Some("") => format!("the derivative of `{name}`"),
                Some(ordinal) => format!("the {ordinal} derivative of `{name}`"),
            };
        }
        let by = arguments(&self.function.parameters, &self.orders).map(|parameter| format!("`{parameter}`"));
        format!("the derivative of `{name}` by {}", by.collect::<Vec<_>>().join(", "))
    }
}

/// Returns the name of the function that computes a derivative. With one argument it is
/// `f_derivative`, `f_second_derivative`, …, with several `f_by_x`, `f_by_x_x`, `f_by_x_y`, ….
pub fn default_name(name: &str, parameters: &[String], orders: &[u8]) -> String {
    match orders {
        [0] => name.to_owned(),
        &[order] => match ordinal(order) {
            Some("") => format!("{name}_derivative"),
            Some(ordinal) => format!("{name}_{ordinal}_derivative"),
            None => format!("{name}_derivative_{order}"),
        },
        _ if orders.iter().all(|order| *order == 0) => name.to_owned(),
        _ => {
            let by = arguments(parameters, orders).collect::<Vec<_>>();
            format!("{name}_by_{}", by.join("_"))
        }
    }
}

/// Returns the arguments by which a function is differentiated, each as often as that is done.
fn arguments<'a>(parameters: &'a [String], orders: &'a [u8]) -> impl Iterator<Item = &'a str> {
    let repeated = parameters.iter().zip(orders);
    repeated.flat_map(|(parameter, order)| std::iter::repeat_n(parameter.as_str(), usize::from(*order)))
}

/// Returns the word before "derivative"; none for the first.
fn ordinal(order: u8) -> Option<&'static str> {
    ["", "second", "third"].get(usize::from(order).checked_sub(1)?).copied()
}

#[cfg(test)]
mod tests;
