//! Largest numbers and sizes that a declaration may have, all in one place.
//!
//! Each is checked before the work that it bounds. The table in the description of the language
//! lists them with their messages, and a test provokes every one of these. Budgets inside
//! algorithms, beyond which an expression stays as it is, are not among them.

/// Bracket groups and conditions inside each other. Nothing else is read by recursion, except for
/// the few tokens that are handed to `syn`.
pub const MAX_NESTING: u32 = 64;

/// Indices behind a name. Emitted types hold arrays in arrays, which the compiler of Rust walks by
/// recursion.
pub const MAX_INDICES: usize = 8;

/// Characters of a number, whose value is kept exactly.
pub const MAX_LITERAL_LENGTH: usize = 5_000;

/// Decimal exponent of a number: no scalar can represent more.
pub const MAX_DECIMAL_EXPONENT: i64 = 5_000;

/// Bits of an exact number; the longest literals need fewer.
pub const MAX_NUMBER_BITS: u64 = 20_000;

/// Exponent of a unit.
pub const MAX_UNIT_EXPONENT: i64 = 99;

/// Statements and terms that loops and sums stand for.
pub const MAX_WRITTEN_OUT: u64 = 200_000;

/// Parts in each other.
pub const MAX_PARTS_NESTED: usize = 32;

/// Loops, conditions and parts in each other, as they are expanded: by recursion.
pub const MAX_EXPANDED_NESTING: usize = 256;

/// Placements of parts.
pub const MAX_PLACED: usize = 20_000;

/// Elements of arrays, most of which are fields of the emitted type and names in its methods.
pub const MAX_ELEMENTS: u64 = 20_000;

/// Terms that calls of functions stand for.
pub const MAX_INLINED: u64 = 200_000;

/// Points of a table.
pub const MAX_POINTS: usize = 100_000;

/// Bytes of a table file: enough for the largest table, and read by an unoptimised macro in
/// seconds.
pub const MAX_FILE_BYTES: u64 = 16 << 20;

/// Bytes of all files of parts together.
pub const MAX_PART_BYTES: u64 = 1 << 20;

/// Steps of Newton's method for an algebraic unknown.
pub const MAX_ITERATIONS: i32 = 1_000;

/// Branches of a combined condition, once it is written as choices by one comparison each.
pub const MAX_BRANCHES: u64 = 100;

/// Algebraic unknowns that are solved for together, whose derivatives are written by Cramer's rule.
pub const MAX_COUPLED: usize = 8;

/// Events of a declaration.
pub const MAX_EVENTS: usize = 64;

/// Events and switches together that runs can look for; more switches are stepped across.
pub const MAX_LOCATED: usize = 64;

/// Velocities, as matrices have an entry for each pair of them.
pub const MAX_VELOCITIES: usize = 2_000;

/// First-order states, each of which has an equation as velocities do.
pub const MAX_STATES: usize = 2_000;

/// Constraints, which are compared with each other.
pub const MAX_CONSTRAINTS: usize = 1_000;

/// Constraints beyond the number of velocities: all of them are coupled with each other.
pub const MAX_DEPENDENT_CONSTRAINTS: usize = 20;

/// Outputs, each of which is a method.
pub const MAX_OUTPUTS: usize = 5_000;

/// Operations of emitted code: reading more takes minutes and as much memory as many machines have.
pub const MAX_OPERATIONS: usize = 2_000_000;

/// Operations from which on compiling takes more than about five seconds, which is worth a warning.
pub const MANY_OPERATIONS: usize = 80_000;

/// White noises, whose increments methods of integration keep without a heap.
pub const MAX_NOISES: usize = 16;
