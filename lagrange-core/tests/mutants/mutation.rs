//! Changes of a list of tokens.

use std::ops::Range;

use crate::corpus::Declaration;
use crate::random::Random;

/// Numbers at the boundaries of what is meaningful.
const NUMBERS: [&str; 16] = [
    "0",
    "1",
    "(-1)",
    "2",
    "(1/2)",
    "(-1/2)",
    "1e400",
    "1e-400",
    "1e5000",
    "1000000000",
    "2147483648",
    "(10^400)",
    "(2^1000000000)",
    "(0/0)",
    "0.1",
    "9007199254740993",
];
/// Contexts of an expression.
const AROUND: [(&str, &str); 15] = [
    ("(", ")"),
    ("sin(", ")"),
    ("cos(", ")"),
    ("sqrt(", ")"),
    ("ln(", ")"),
    ("asin(", ")"),
    ("-", ""),
    ("dot(", ")"),
    ("(", ", 1)"),
    ("(1 + ", ")"),
    ("1/(", ")"),
    ("norm((", ", 2))"),
    ("if ", " < 0 { 1 } else { 2 }"),
    ("abs(", ")"),
    ("max(0, ", ")"),
];
const DEEPEST: usize = 80;

/// Makes one change, in place.
pub(crate) fn change(pieces: &mut Vec<String>, corpus: &[Declaration], random: &mut Random) {
    if pieces.is_empty() {
        return;
    }
    match random.below(16) {
        0 | 1 => drop(pieces.drain(part(pieces, random))),
        2 => {
            let range = part(pieces, random);
            let copy = pieces[range.clone()].to_vec();
            insert(pieces, range.end, copy);
        }
        3 | 4 => swap(pieces, random),
        5..=7 => {
            let donor = &random.choice(corpus).pieces;
            let gift = donor[part(donor, random)].to_vec();
            pieces.splice(part(pieces, random), gift);
        }
        8 | 9 => {
            let digit = |piece: &String| piece.starts_with(|c: char| c.is_ascii_digit());
            let numbers = (0..pieces.len()).filter(|&i| digit(&pieces[i])).collect::<Vec<_>>();
            if !numbers.is_empty() {
                pieces[*random.choice(&numbers)] = (*random.choice(&NUMBERS)).to_owned();
            }
        }
        10 => {
            let end = part(pieces, random).end;
            insert(pieces, end, ["^".to_owned(), (*random.choice(&NUMBERS)).to_owned()]);
        }
        11 => nest(pieces, random),
        12 => {
            let donor = &random.choice(corpus).pieces;
            let middle = pieces.len() / 2;
            pieces.truncate(middle);
            pieces.extend(donor[donor.len() / 2..].iter().cloned());
        }
        13 => {
            let donor = statements(&random.choice(corpus).pieces);
            let gift = random.choice(&donor).clone();
            let places = statements(pieces);
            let place = places[..random.below(places.len() + 1)].iter().map(Vec::len).sum();
            insert(pieces, place, gift);
        }
        14 => {
            let mut list = statements(pieces);
            let (i, j) = (random.below(list.len()), random.below(list.len()));
            list.swap(i, j);
            *pieces = list.concat();
        }
        // A bracket or a letter, so that brackets no longer match.
        _ => {
            let place = random.below(pieces.len());
            pieces[place].pop();
        }
    }
}

/// Returns the text of the tokens.
pub(crate) fn text(pieces: &[String]) -> String {
    pieces.join(" ")
}

fn insert(pieces: &mut Vec<String>, place: usize, new: impl IntoIterator<Item = String>) {
    pieces.splice(place..place, new);
}

/// Chooses a token, or everything from bracket to bracket.
fn part(pieces: &[String], random: &mut Random) -> Range<usize> {
    let start = random.below(pieces.len());
    let mut open = 0;
    for (i, piece) in pieces.iter().enumerate().skip(start) {
        open += bracket(piece);
        if open <= 0 {
            return start..i + 1;
        }
    }
    start..start + 1
}

fn bracket(piece: &str) -> i32 {
    match piece {
        "(" | "[" | "{" => 1,
        ")" | "]" | "}" => -1,
        _ => 0,
    }
}

fn swap(pieces: &mut Vec<String>, random: &mut Random) {
    let (a, b) = (part(pieces, random), part(pieces, random));
    let (a, b) = if a.start < b.start { (a, b) } else { (b, a) };
    if a.end <= b.start {
        let between = pieces[a.end..b.start].to_vec();
        let swapped = [&pieces[b.clone()], &between, &pieces[a.clone()]].concat();
        pieces.splice(a.start..b.end, swapped);
    }
}

/// Nests an expression in others, a few or many times.
fn nest(pieces: &mut Vec<String>, random: &mut Random) {
    let (before, behind) = *random.choice(&AROUND);
    let depth = 1 + if random.below(4) == 0 { random.below(DEEPEST) } else { random.below(4) };
    let range = part(pieces, random);
    insert(pieces, range.end, [behind.repeat(depth)]);
    insert(pieces, range.start, [before.repeat(depth)]);
}

/// Returns the tokens up to each semicolon outside brackets.
fn statements(pieces: &[String]) -> Vec<Vec<String>> {
    let mut open = 0;
    let list = pieces.split_inclusive(|piece| {
        open += bracket(piece);
        open == 0 && piece == ";"
    });
    list.map(<[String]>::to_vec).collect()
}
