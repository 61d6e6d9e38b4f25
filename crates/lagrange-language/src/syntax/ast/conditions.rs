//! Comparisons in combination, as written.

use super::id::AstId;

/// A condition: it holds if one of several alternatives holds, each of which requires all of its
/// tests.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct CombinedCondition {
    /// Tests with `&&` between them, in groups with `||` between those.
    pub alternatives: Vec<Vec<ConditionTest>>,
}

impl CombinedCondition {
    /// Returns how often choices by single comparisons contain the first and the second branch.
    pub fn copies(&self) -> [u64; 2] {
        let mut whole: [u64; 2] = [0, 1];
        for tests in &self.alternatives {
            let mut all: [u64; 2] = [1, 0];
            for test in tests {
                let mut one = match &test.kind {
                    TestKind::Comparison(..) => [1, 1],
                    TestKind::Nested(condition) => condition.copies(),
                };
                if test.is_negated {
                    one.reverse();
                }
                let otherwise = all[1].saturating_add(all[0].saturating_mul(one[1]));
                all = [all[0].saturating_mul(one[0]), otherwise];
            }
            let then = whole[0].saturating_add(whole[1].saturating_mul(all[0]));
            whole = [then, whole[1].saturating_mul(all[1])];
        }
        whole
    }

    /// Returns the condition of a branch: no previous one holds, and the last one, if there is one,
    /// does.
    pub fn of_branch(former: &[CombinedCondition], last: Option<&CombinedCondition>) -> CombinedCondition {
        if let ([], Some(first)) = (former, last) {
            return first.clone();
        }
        let test = |is_negated, condition: &CombinedCondition| ConditionTest {
            is_negated,
            kind: TestKind::Nested(condition.clone()),
        };
        let former = former.iter().map(|condition| test(true, condition));
        let tests = former.chain(last.map(|condition| test(false, condition))).collect();
        CombinedCondition { alternatives: vec![tests] }
    }

    /// Returns its expressions, in source order.
    pub fn expressions(&self) -> Vec<AstId> {
        let tests = self.alternatives.iter().flatten();
        let expressions = tests.flat_map(|test| match &test.kind {
            TestKind::Comparison(left, _, right) => vec![*left, *right],
            TestKind::Nested(condition) => condition.expressions(),
        });
        expressions.collect()
    }

    /// Returns the expressions for modification.
    pub fn expressions_mut(&mut self) -> Vec<&mut AstId> {
        let tests = self.alternatives.iter_mut().flatten();
        let expressions = tests.flat_map(|test| match &mut test.kind {
            TestKind::Comparison(left, _, right) => vec![left, right],
            TestKind::Nested(condition) => condition.expressions_mut(),
        });
        expressions.collect()
    }
}

/// One test of a condition.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct ConditionTest {
    /// True if it is preceded by `!`.
    pub is_negated: bool,
    /// The test itself.
    pub kind: TestKind,
}

/// The kind of a test.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum TestKind {
    /// `i < n`
    Comparison(AstId, Comparison, AstId),
    /// A condition in parentheses.
    Nested(CombinedCondition),
}

/// A comparison.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Comparison {
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
    /// `==`
    Equal,
    /// `!=`
    Unequal,
}

impl Comparison {
    /// Every comparison with its sign; longer signs come before their prefixes.
    pub const ALL: [(&'static str, Comparison); 6] = [
        ("<=", Comparison::LessEqual),
        (">=", Comparison::GreaterEqual),
        ("==", Comparison::Equal),
        ("!=", Comparison::Unequal),
        ("<", Comparison::Less),
        (">", Comparison::Greater),
    ];

    /// True if it holds for two values in this order.
    pub fn holds(self, order: std::cmp::Ordering) -> bool {
        match self {
            Comparison::Less => order.is_lt(),
            Comparison::LessEqual => order.is_le(),
            Comparison::Greater => order.is_gt(),
            Comparison::GreaterEqual => order.is_ge(),
            Comparison::Equal => order.is_eq(),
            Comparison::Unequal => order.is_ne(),
        }
    }

    /// Returns its sign.
    pub fn sign(self) -> &'static str {
        Comparison::ALL.iter().find(|(_, comparison)| *comparison == self).map_or("", |(sign, _)| sign)
    }
}
