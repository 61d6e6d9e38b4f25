//! Numbers that distinguish declarations.

use lagrange_language::syntax::ast::{Declaration, StatementKind};
use lagrange_language::syntax::print;

/// Returns a number that distinguishes declarations by their statements with the numbers of tables,
/// and by their accuracy.
///
/// Comments, documentation, pictures and the layout of the source do not affect it.
pub fn fingerprint(declaration: &Declaration) -> u64 {
    let mut said = declaration.clone();
    said.statements.retain(|statement| !matches!(statement.kind, StatementKind::Scene(_)));
    said.statements.extend(said.reduction.take());
    fnv1a(&[declaration.accuracy.name(), &print::statements(&said)].join("\n"))
}

/// Returns the 64-bit FNV-1a hash, which is the same on every platform and in every version of
/// Rust.
///
/// Source: Fowler, Noll, Vo, Eastlake, Hansen, *The FNV Non-Cryptographic Hash Algorithm*,
/// draft-eastlake-fnv, §2.
fn fnv1a(text: &str) -> u64 {
    const BASIS: u64 = 0xcbf2_9ce4_8422_2325;
    const PRIME: u64 = 0x0000_0100_0000_01b3;
    text.bytes().fold(BASIS, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(PRIME))
}

#[cfg(test)]
mod tests {
    use super::fnv1a;

    /// Test vectors of the authors' reference program.
    #[test]
    fn hashes_are_those_that_are_published() {
        for (text, hash) in
            [("", 0xcbf2_9ce4_8422_2325), ("a", 0xaf63_dc4c_8601_ec8c), ("foobar", 0x8594_4171_f739_67e8)]
        {
            assert_eq!(fnv1a(text), hash, "{text}");
        }
    }
}
