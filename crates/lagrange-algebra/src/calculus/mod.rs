//! Calculus on the graph: every result is again a graph of about the size of its input.

mod adjoint;
mod degree;
mod expansion;
mod grades;
mod implicit;
mod jacobian;
mod linear;
mod local;
mod minors;
mod partial;
mod rate;
mod rounding;
mod substitute;
mod transplant;

pub use adjoint::{adjoint, gradient};
pub use degree::{Degree, Degrees, homogeneity, polynomial_degree};
pub use expansion::{Expansion, Series};
pub use grades::{Grades, keeps_units};
pub use implicit::residuals;
pub use jacobian::jacobian;
pub use linear::{LinearFailure, linear_solution};
pub use local::{partials, second_partials};
pub use minors::jacobian_determinant;
pub use partial::partial;
pub use rate::{AccelerationTerms, Rates};
pub use rounding::rounding;
pub use substitute::{rebuild, substitute, substitute_all};
pub use transplant::transplant;

#[cfg(test)]
mod tests;
