//! Files that are damaged at random: nothing panics, and what is imported is what the language accepts.

use std::env;

use lagrange_core::pipeline::parse;
use lagrange_import::urdf::{Options, import};

use crate::files::read;
use crate::reference::statements;

/// Damaged files of each kind; `EDITS=10000 cargo test --release -p lagrange-import edits` tries more.
const COUNT: usize = 100;
/// Accepted files of which the declaration is read again.
const READ_AGAIN: usize = 20;

/// Pieces that files are likely to hold at the wrong places.
const PIECES: [&str; 22] = [
    "",
    "0",
    "-1",
    "1e-9",
    "1e300",
    "nan",
    "\"",
    "<",
    ">",
    "/>",
    "&amp;",
    "&x;",
    "<inertial/>",
    "<origin/>",
    "</link>",
    "name=\"x\"",
    "xyz=\"0 0 1\"",
    "type=\"floating\"",
    "type=\"planar\"",
    "type=\"fixed\"",
    "<mimic joint=\"Finger-A\"/>",
    "関",
];

/// Numbers from a seed (Marsaglia's xorshift, with 64 bits).
struct Random(u64);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % count.max(1) as u64) as usize
    }
}

/// The nearest place up to here between two characters.
fn boundary(text: &str, mut place: usize) -> usize {
    while !text.is_char_boundary(place) {
        place -= 1;
    }
    place
}

/// A stretch of bytes replaced by a piece.
fn damaged(text: &str, random: &mut Random) -> String {
    let start = boundary(text, random.below(text.len()));
    let end = boundary(text, (start + random.below(12)).min(text.len())).max(start);
    let piece = PIECES[random.below(PIECES.len())];
    [&text[..start], piece, &text[end..]].concat()
}

/// A line left out, doubled, moved, or with another value of an attribute.
fn edited(text: &str, random: &mut Random) -> String {
    let mut lines = text.lines().map(str::to_owned).collect::<Vec<_>>();
    let index = random.below(lines.len());
    match random.below(4) {
        0 => drop(lines.remove(index)),
        1 => lines.insert(index, lines[index].clone()),
        2 => {
            let line = lines.remove(index);
            lines.insert(random.below(lines.len()), line);
        }
        _ => {
            let parts = lines[index].split('"').map(str::to_owned).collect::<Vec<_>>();
            let value = 2 * random.below(parts.len() / 2) + 1;
            let other = PIECES[random.below(6)];
            let replaced =
                |(i, part): (usize, &String)| if i == value { other.to_owned() } else { part.clone() };
            lines[index] = parts.iter().enumerate().map(replaced).collect::<Vec<_>>().join("\"");
        }
    }
    lines.join("\n")
}

fn assert_nothing_panics(edit: fn(&str, &mut Random) -> String, seed: u64) {
    let count = env::var("EDITS").map_or(COUNT, |count| count.parse().expect("a number"));
    let whole = read("every_joint.urdf");
    let small = whole.split("<!-- A carriage").next().expect("a part").to_owned() + "</robot>";
    let mut random = Random(seed);
    let (mut accepted, mut refused) = (0, 0);
    for round in 0..count {
        let mut text = if round % 20 == 0 { whole.clone() } else { small.clone() };
        for _ in 0..=random.below(2) {
            text = edit(&text, &mut random);
        }
        let options = Options {
            is_free: round % 3 == 0,
            has_inputs: round % 2 == 0,
            trusts_inertia: round % 5 == 0,
            name: None,
        };
        match import(&text, &options) {
            Ok(imported) => {
                accepted += 1;
                let is_read = || parse(statements(&imported.declaration)).is_ok();
                assert!(accepted > READ_AGAIN || is_read(), "{}", imported.declaration);
            }
            Err(mistakes) => {
                refused += 1;
                let is_told = mistakes.iter().any(|mistake| mistake.is_error && !mistake.message.is_empty());
                let refused_late = mistakes.iter().find(|mistake| mistake.message.contains("is refused"));
                assert!(is_told && refused_late.is_none(), "{mistakes:?}\n{text}");
            }
        }
    }
    println!("{accepted} accepted, {refused} refused");
    assert!(accepted > count / 20 && refused > count / 20);
}

#[test]
fn damaged_bytes_are_no_panic() {
    assert_nothing_panics(damaged, 0x5eed);
}

#[test]
fn edited_lines_are_no_panic() {
    assert_nothing_panics(edited, 0xfeed);
}

#[test]
fn deep_and_long_files_come_to_an_end() {
    let deep = "<robot name=\"r\">".to_owned() + &"<link>".repeat(100_000);
    import(&deep, &Options::default()).expect_err("nothing closes them");
    let closed = deep + &"</link>".repeat(100_000) + "</robot>";
    import(&closed, &Options::default()).expect_err("the link has no name");
    let number = format!(
        "<robot name=\"r\"><link name=\"a\"><inertial><mass value=\"1{}\"/></inertial></link></robot>",
        "0".repeat(100_000)
    );
    import(&number, &Options::default()).expect_err("too large for a number");
}
