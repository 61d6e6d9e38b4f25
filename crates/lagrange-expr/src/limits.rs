//! Limits on the numbers and sizes of a declaration, all in one place.
//!
//! Each limit is checked before the work that it bounds. The table in the language reference lists
//! them with their messages, and a test triggers each of these. Budgets inside algorithms, beyond
//! which an expression stays unchanged, are not included.

/// Nesting of bracket groups and conditions. Nothing else is parsed recursively, except for the few
/// tokens passed to `syn`.
pub const MAX_NESTING: u32 = 64;

/// Indices after a name. Emitted types contain nested arrays, which the Rust compiler traverses
/// recursively.
pub const MAX_INDICES: usize = 8;

/// Characters of a number, whose value is kept exactly.
pub const MAX_LITERAL_LENGTH: usize = 5_000;

/// Decimal exponent of a number: no scalar can represent more.
pub const MAX_DECIMAL_EXPONENT: i64 = 5_000;

/// Bits of an exact number; the longest literals need fewer.
pub const MAX_NUMBER_BITS: u64 = 20_000;

/// Exponent of a unit.
pub const MAX_UNIT_EXPONENT: i64 = 99;

/// Statements and terms in the expansion of loops and sums.
pub const MAX_WRITTEN_OUT: u64 = 200_000;

/// Nesting of parts.
pub const MAX_PARTS_NESTED: usize = 32;

/// Nesting of loops, conditions and parts, which are expanded recursively.
pub const MAX_EXPANDED_NESTING: usize = 256;

/// Placements of parts.
pub const MAX_PLACED: usize = 20_000;

/// Elements of arrays, most of which are fields of the emitted type and names in its methods.
pub const MAX_ELEMENTS: u64 = 20_000;

/// Terms in the expansion of function calls.
pub const MAX_INLINED: u64 = 200_000;

/// Points of a table.
pub const MAX_POINTS: usize = 100_000;

/// Arguments of a table.
pub const MAX_TABLE_ARGUMENTS: usize = 3;

/// Bytes of a table file: sufficient for the largest table, which an unoptimised macro reads in
/// seconds.
pub const MAX_FILE_BYTES: u64 = 16 << 20;

/// Total bytes of all files of parts.
pub const MAX_PART_BYTES: u64 = 1 << 20;

/// Steps of Newton's method for an algebraic unknown.
pub const MAX_ITERATIONS: i32 = 1_000;

/// Branches of a combined condition after its conversion to choices by single comparisons.
pub const MAX_BRANCHES: u64 = 100;

/// Jointly solved algebraic unknowns, whose derivatives are written by Cramer's rule.
pub const MAX_COUPLED: usize = 8;

/// Events of a declaration, except those of contacts and friction.
pub const MAX_EVENTS: usize = 448;

/// Contacts and friction. Steps store several numbers for each pair of one and a velocity.
pub const MAX_CONTACTS: usize = 1_000;

/// Product of the numbers of contacts and velocities if contacts have no events of their own. Steps
/// store about ten numbers for each pair on the stack.
pub const MAX_CONTACT_PAIRS: usize = 16_384;

/// Total number of events and switches located by runs; further switches are stepped across.
pub const MAX_LOCATED: usize = 512;

/// Velocities, since matrices have an entry for each pair.
pub const MAX_VELOCITIES: usize = 2_000;

/// First-order states, each with an equation like a velocity.
pub const MAX_STATES: usize = 2_000;

/// Constraints, which are compared with each other.
pub const MAX_CONSTRAINTS: usize = 1_000;

/// Constraints in excess of the number of velocities, all of which are coupled with each other.
pub const MAX_DEPENDENT_CONSTRAINTS: usize = 20;

/// Outputs, each of which is a method.
pub const MAX_OUTPUTS: usize = 5_000;

/// Operations of emitted code; parsing more takes minutes, and exhausts the memory of many
/// machines.
pub const MAX_OPERATIONS: usize = 2_000_000;

/// Operations above which compilation takes more than about five seconds, which triggers a warning.
pub const MANY_OPERATIONS: usize = 80_000;

/// White noises, whose increments are stored without heap allocation.
pub const MAX_NOISES: usize = 16;
