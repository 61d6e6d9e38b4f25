//! What differs between a derived system and a skeleton.

use std::collections::BTreeSet;

use proc_macro2::TokenStream;

use super::method::{ArgumentNames, Method};

/// Members of the emitted type, its documentation, and what its traits need to know of them.
pub(in crate::emit) struct Members {
    /// Documentation of the struct, after the user's own.
    pub(in crate::emit) docs: Vec<String>,
    /// The body of `Default::default`, if all defaults are known.
    pub(in crate::emit) default: Option<TokenStream>,
    pub(in crate::emit) methods: Vec<Method>,
    /// Methods of `ConstrainedSystem`; none without constraints.
    pub(in crate::emit) constrained: Vec<Method>,
    /// Methods of `CanonicalSystem` that only constrained systems have of their own.
    pub(in crate::emit) canonical: Vec<Method>,
    /// Of each constraint, whether it holds positions.
    pub(in crate::emit) are_holonomic: Vec<bool>,
    /// The body of `ContactSystem::terms`.
    pub(in crate::emit) terms: TokenStream,
    /// The body of `SwitchedSystem::switch_times`, if there is a time to tell.
    pub(in crate::emit) switch_times: Option<TokenStream>,
    /// Of each reaction, whether it has a coefficient of restitution that depends on time or the state.
    pub(in crate::emit) restitutions_vary: Vec<bool>,
    /// Methods that only others call.
    pub(in crate::emit) hidden: TokenStream,
    /// Methods that say how bodies move.
    pub(in crate::emit) motions: TokenStream,
    /// The body of `Scene::items`, if that is asked for.
    pub(in crate::emit) items: Option<TokenStream>,
    /// Associated constants.
    pub(in crate::emit) constants: TokenStream,
    pub(in crate::emit) names: ArgumentNames,
    /// Functions of `lagrange::private` that the methods call.
    pub(in crate::emit) functions: BTreeSet<&'static str>,
    /// Whether explicit symplectic methods take the system.
    pub(in crate::emit) is_separable: bool,
    /// Whether the methods hold rounded values of irrational constants.
    pub(in crate::emit) has_rounded_constants: bool,
}

impl Members {
    /// No members yet.
    pub(in crate::emit) fn new(names: ArgumentNames) -> Members {
        Members {
            docs: Vec::new(),
            default: None,
            methods: Vec::new(),
            constrained: Vec::new(),
            canonical: Vec::new(),
            are_holonomic: Vec::new(),
            terms: TokenStream::new(),
            switch_times: None,
            restitutions_vary: Vec::new(),
            hidden: TokenStream::new(),
            motions: TokenStream::new(),
            items: None,
            constants: TokenStream::new(),
            names,
            functions: BTreeSet::new(),
            is_separable: false,
            has_rounded_constants: false,
        }
    }
}
