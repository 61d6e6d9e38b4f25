//! Differences between a derived system and a skeleton.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream};

use super::method::{ArgumentNames, Method};
use crate::derive::DiffusionKind;
use crate::model::EntryLimits;
use lagrange_algebra::code::Names;
use lagrange_expr::opaque::Opaque;

/// Members of the emitted type, its documentation, and data for its traits.
#[derive(Default)]
pub(in crate::emit) struct Members {
    /// Documentation of the struct, after the user's own.
    pub(in crate::emit) docs: Vec<String>,
    /// The body of `Default::default`, if all defaults are known.
    pub(in crate::emit) default: Option<TokenStream>,
    pub(in crate::emit) methods: Vec<Method>,
    /// Methods of `ConstrainedSystem`; none without constraints.
    pub(in crate::emit) constrained: Vec<Method>,
    /// Methods of `CanonicalSystem` that only constrained systems define themselves.
    pub(in crate::emit) canonical: Vec<Method>,
    /// True for each constraint that contains positions.
    pub(in crate::emit) are_holonomic: Vec<bool>,
    /// The body of `ContactSystem::step_terms`, or of `terms` if there are constraints.
    pub(in crate::emit) terms: TokenStream,
    /// Number of slopes of the limits of friction.
    pub(in crate::emit) slopes: usize,
    /// Number of clocks.
    pub(in crate::emit) clocks: usize,
    /// The noises, if there are any.
    pub(in crate::emit) noise: Option<Noisy>,
    /// True if forces and gradients of contacts or friction are divided by the inertia at run time.
    pub(in crate::emit) is_forced: bool,
    /// True if there are dampers in addition to contacts or friction.
    pub(in crate::emit) is_damped: bool,
    /// The body of `SwitchedSystem::switch_times`, if any time is known.
    pub(in crate::emit) switch_times: Option<TokenStream>,
    /// The reason why only steps can simulate a system with contacts.
    pub(in crate::emit) needs_steps: Option<String>,
    /// True for each friction whose limit contains constraint forces.
    pub(in crate::emit) limits_reverse: Vec<bool>,
    /// True for each contact whose gradient jumps.
    pub(in crate::emit) gradients_jump: Vec<bool>,
    /// Methods called only by other methods.
    pub(in crate::emit) hidden: TokenStream,
    /// Methods for the motion of bodies.
    pub(in crate::emit) motions: TokenStream,
    /// Ranges and nominal values of the entries of the state.
    pub(in crate::emit) limits: Vec<EntryLimits>,
    /// The body of `check_parameters`, if any parameter or quantity of a contact has a range.
    pub(in crate::emit) ranges: Option<TokenStream>,
    /// The body of `start`, if initial values are declared.
    pub(in crate::emit) start: Option<TokenStream>,
    /// The body of `Scene::items`, if requested.
    pub(in crate::emit) items: Option<TokenStream>,
    /// Parts of the prepared type, if requested.
    pub(in crate::emit) prepared: Option<Prepared>,
    /// The constants with the text of the kernel, if requested.
    pub(in crate::emit) kernel: Option<TokenStream>,
    /// Parts of the type for numbers in lanes, if requested.
    pub(in crate::emit) lanes: Option<Lanes>,
    /// Parts of the expansion in Taylor series, if requested.
    pub(in crate::emit) taylor: Option<Taylor>,
    /// Associated constants.
    pub(in crate::emit) constants: TokenStream,
    pub(in crate::emit) names: ArgumentNames,
    /// Functions of `lagrange::private` that the methods call.
    pub(in crate::emit) functions: BTreeSet<&'static str>,
    /// Functions without a formula that the methods call, tables among them.
    pub(in crate::emit) callees: Vec<Opaque>,
    /// Functions that solve equations.
    pub(in crate::emit) solvers: TokenStream,
    /// Statements and a list of the unknowns in rates, each with its name and its value.
    pub(in crate::emit) unknowns: Option<TokenStream>,
    /// Statements and a list of the distances of compliant contacts, each with the name of the
    /// contact.
    pub(in crate::emit) distances: Option<TokenStream>,
    /// Parameters of the regressor, if requested.
    pub(in crate::emit) regressor: Option<Regressed>,
    /// True if tests in the user's crate check laws.
    pub(in crate::emit) is_tested: bool,
    /// True if explicit symplectic methods accept the system.
    pub(in crate::emit) is_separable: bool,
    /// True if rates or their derivatives jump between pieces of tables.
    pub(in crate::emit) has_kinks: bool,
    /// True if the methods contain rounded values of irrational constants.
    pub(in crate::emit) has_rounded_constants: bool,
}

impl Members {
    /// Creates empty members.
    pub(in crate::emit) fn new(names: ArgumentNames) -> Members {
        Members { names, ..Members::default() }
    }
}

/// Noises of a system.
#[derive(Clone, Copy)]
pub(in crate::emit) struct Noisy {
    pub(in crate::emit) count: usize,
    pub(in crate::emit) kind: DiffusionKind,
}

/// A type that stores values computed from parameters alone.
pub(in crate::emit) struct Prepared {
    /// Stored fields.
    pub(in crate::emit) fields: PreparedFields,
    /// Statements that compute the stored values, and a value for each field.
    pub(in crate::emit) values: (TokenStream, Vec<TokenStream>),
    pub(in crate::emit) methods: Vec<Method>,
    /// Documentation of the type.
    pub(in crate::emit) docs: String,
}

/// Parameters in which the inverse dynamics is linear.
pub(in crate::emit) struct Regressed {
    pub(in crate::emit) names: Vec<String>,
    /// The body of the method that computes them.
    pub(in crate::emit) body: TokenStream,
}

/// The equations for numbers in lanes.
pub(in crate::emit) struct Lanes {
    /// The body of `Equations::rhs`.
    pub(in crate::emit) rhs: TokenStream,
    /// The body of `Equations::differentiated`, if Jacobians are requested.
    pub(in crate::emit) derivatives: Option<TokenStream>,
    /// The body of the method that returns the side of each motion at the switches, if there are
    /// any.
    pub(in crate::emit) sides: Option<TokenStream>,
    /// Documentation of the type.
    pub(in crate::emit) docs: String,
}

/// The expansion of the motion in Taylor series.
pub(in crate::emit) struct Taylor {
    /// Number of sides that groups of products share.
    pub(in crate::emit) shared: usize,
    /// Number of groups of products.
    pub(in crate::emit) groups: usize,
    /// Tables with the indices of their tracked arguments.
    pub(in crate::emit) followed: Vec<(Opaque, usize)>,
    /// True if the type for numbers in lanes has the body.
    pub(in crate::emit) is_in_lanes: bool,
    /// The body of `TaylorSystem::expand`, or of `Equations::expand`.
    pub(in crate::emit) body: TokenStream,
}

/// Names of the fields of the prepared type besides that of the system.
pub(in crate::emit) struct PreparedFields {
    pub(in crate::emit) names: Vec<Ident>,
    given: Names,
}

impl PreparedFields {
    /// Creates an empty set of fields.
    pub(in crate::emit) fn new() -> PreparedFields {
        PreparedFields { names: Vec::new(), given: Names::new(["system"]) }
    }

    /// Adds a field, and returns its name.
    pub(in crate::emit) fn push(&mut self, wish: Option<&str>) -> String {
        let name = match wish {
            Some(wish) => self.given.fresh(wish),
            None => self.given.numbered("const"),
        };
        let text = name.to_string();
        self.names.push(name);
        text
    }
}
