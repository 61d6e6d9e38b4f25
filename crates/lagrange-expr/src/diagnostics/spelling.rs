//! Suggestion of the intended name.

/// Maximum length of compared names; longer ones are rarely mistyped by a letter.
const LONGEST_COMPARED: usize = 64;
/// Minimum number of shared letters for which a name is near a prefix of it.
const SHORTEST_PREFIX: usize = 3;

/// Returns the candidate nearest to an unknown name, if it is near enough to be worth suggesting.
///
/// The distance is the number of letters to insert, delete, replace or swap with their neighbour,
/// at most a third of the longer name. Case is ignored. Otherwise, a candidate is near if it
/// abbreviates the name or is abbreviated by it. Among equally near candidates, the first one is
/// chosen.
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let letters = lower_case(name);
    if letters.len() > LONGEST_COMPARED {
        return None;
    }
    let mut best: Option<(usize, &'a str)> = None;
    let mut abbreviation = None;
    for candidate in candidates {
        let other = lower_case(candidate);
        if let Some(distance) = small_distance(&letters, &other)
            && best.is_none_or(|(least, _)| distance < least)
        {
            best = Some((distance, candidate));
        }
        if abbreviation.is_none() && abbreviates(&letters, &other) {
            abbreviation = Some(candidate);
        }
    }
    best.map(|(_, candidate)| candidate).or(abbreviation)
}

fn lower_case(name: &str) -> Vec<char> {
    name.chars().flat_map(char::to_lowercase).take(LONGEST_COMPARED + 1).collect()
}

fn abbreviates(a: &[char], b: &[char]) -> bool {
    a.len().min(b.len()) >= SHORTEST_PREFIX && (a.starts_with(b) || b.starts_with(a))
}

fn small_distance(a: &[char], b: &[char]) -> Option<usize> {
    let longer = a.len().max(b.len());
    let tolerance = (longer / 3).max(1);
    if a.len().abs_diff(b.len()) > tolerance {
        return None;
    }
    // If every letter were replaced, nothing would remain of the name: `x` is not near `y`.
    Some(distance(a, b)).filter(|&distance| distance <= tolerance && distance < longer)
}

/// Computes the optimal string alignment distance, row by row.
fn distance(a: &[char], b: &[char]) -> usize {
    let mut before_last: Vec<usize> = Vec::new();
    let mut last: Vec<usize> = (0..=b.len()).collect();
    for i in 0..a.len() {
        let mut row = vec![i + 1];
        for j in 0..b.len() {
            let replaced = last[j] + usize::from(a[i] != b[j]);
            let mut least = replaced.min(last[j + 1] + 1).min(row[j] + 1);
            if i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j] {
                least = least.min(before_last[j - 1] + 1);
            }
            row.push(least);
        }
        before_last = std::mem::replace(&mut last, row);
    }
    last[b.len()]
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn slips_of_the_pen_are_recognised() {
        let known = ["theta", "kinetic", "potential", "param", "x1"];
        assert_eq!(nearest("tehta", known), Some("theta"));
        assert_eq!(nearest("Theta", known), Some("theta"));
        assert_eq!(nearest("potental", known), Some("potential"));
        assert_eq!(nearest("parameter", known), Some("param"));
        assert_eq!(nearest("x", known), Some("x1"));
    }

    #[test]
    fn unlike_names_are_not_suggested() {
        assert_eq!(nearest("x", ["y", "z"]), None);
        assert_eq!(nearest("mass", ["theta", "length"]), None);
        assert_eq!(nearest("", ["a", "b"]), None);
        assert_eq!(nearest(&"a".repeat(100_000), ["a"]), None);
        assert_eq!(nearest("a", [&*"a".repeat(100_000)]), None);
    }

    #[test]
    fn the_first_of_equally_near_names_wins() {
        assert_eq!(nearest("m3", ["m1", "m2"]), Some("m1"));
    }
}
