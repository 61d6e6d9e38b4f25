//! Randomly damaged files, and files larger than anyone writes: every import ends, and imported
//! declarations compile.

use std::env;
use std::time::Instant;

use lagrange_import::listing;
use lagrange_import::urdf::{Options, import};

use crate::files::read;
use crate::judge::{judged, options};

/// Number of damaged files of each kind;
/// `EDITS=10000 cargo test --release -p lagrange-import edits` tests more.
const COUNT: usize = 100;

/// Pieces that files are likely to contain in the wrong places.
const PIECES: [&str; 30] = [
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
    "\u{202e}",
    "&#x2067;",
    "&#0;",
    "drake:",
    "<drake:joint/>",
    " xmlns=\"x\"",
    "quat_xyzw=\"0 1 0 1\"",
    "rpy=\"1 2 3\"",
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

/// Returns the last boundary between two characters up to an index.
fn boundary(text: &str, mut place: usize) -> usize {
    while !text.is_char_boundary(place) {
        place -= 1;
    }
    place
}

/// Replaces a range of bytes by a piece.
fn damaged(text: &str, random: &mut Random) -> String {
    let start = boundary(text, random.below(text.len()));
    let end = boundary(text, (start + random.below(12)).min(text.len())).max(start);
    let piece = PIECES[random.below(PIECES.len())];
    [&text[..start], piece, &text[end..]].concat()
}

/// Removes, doubles or moves a line, or changes the value of an attribute.
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
    let part = whole.split("<!-- A carriage").next().expect("a part").to_owned() + "</robot>";
    let small = read("hook.urdf");
    let mut random = Random(seed);
    let (mut accepted, mut refused) = (0, 0);
    for round in 0..count {
        let mut text = match round % 20 {
            0 => whole.clone(),
            1..5 => part.clone(),
            _ => small.clone(),
        };
        for _ in 0..=random.below(2) {
            text = edit(&text, &mut random);
        }
        if judged(&text, &options(round)) { accepted += 1 } else { refused += 1 }
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

/// Seconds allowed for a file of 10,000 links with a mistake in each. Quadratic work would take
/// minutes.
const MAX_SECONDS: f64 = 30.0;

/// Returns a robot with this number of links and joints and this text for each, in which `#` is its
/// number.
fn many(count: usize, each: &str) -> String {
    let parts = (0..count).map(|number| each.replace('#', &number.to_string()));
    format!("<robot name=\"many\">{}</robot>", parts.collect::<String>())
}

#[test]
fn many_mistakes_take_as_long_as_as_many_files_with_one() {
    let count = 10_000;
    let files = [
        // All on one line, and one per line.
        many(
            count,
            "<link name=\"a#\"><inertial><mass value=\"x\"/><inertia ixx=\"1\"/></inertial><none#/></link>",
        ),
        many(count, "<link name=\"a#\" b=\"1\"/>\n"),
        many(count, "<link name=\"a\"/>\n"),
        // Names that are all unknown, and all alike.
        many(
            count,
            "<link name=\"a#\"/><joint name=\"j#\" type=\"fixed\"><parent link=\"b#\"/><child link=\"c#\"/></joint>\n",
        ),
        // Joints in circles: a single one, and many.
        many(
            count,
            "<link name=\"a#\"/><joint name=\"j#\" type=\"fixed\"><parent link=\"a#\"/><child link=\"a#\"/><mimic joint=\"j#\"/></joint>",
        ),
        mimicking(count),
        format!(
            "<robot name=\"r\"><link name=\"{}\">{}</link></robot>",
            "long ".repeat(count),
            "<x y=\"\"/>".repeat(count)
        ),
        format!(
            "<robot name=\"r\"><link name=\"a\"><inertial {}/></link></robot>",
            (0..count).map(|i| format!(" a{i}=\"\"")).collect::<String>()
        ),
        format!("<robot name=\"r\"><link name=\"a\">{}</link></robot>", "<inertial/>".repeat(count)),
    ];
    for text in files {
        let start = Instant::now();
        let mistakes = import(&text, &Options::default()).expect_err("mistakes");
        let seconds = start.elapsed().as_secs_f64();
        println!("{} mistakes in {seconds:.1} s", mistakes.len());
        assert!(seconds < MAX_SECONDS, "{seconds} s: {}", &text[..200]);
        let listed = listing("many.urdf", &mistakes);
        assert!(listed.lines().count() < 250 && listed.len() < 50_000, "{listed}");
    }
}

/// Returns a chain of joints, each of which mimics the next, and the last one the first.
fn mimicking(count: usize) -> String {
    let joint = |number: usize| {
        format!(
            "<link name=\"a{number}\"/><joint name=\"j{number}\" type=\"revolute\"><parent link=\"base\"/>\
             <child link=\"a{number}\"/><mimic joint=\"j{}\"/></joint>\n",
            (number + 1) % count
        )
    };
    format!("<robot name=\"r\"><link name=\"base\"/>{}</robot>", (0..count).map(joint).collect::<String>())
}

#[test]
fn listings_show_some_mistakes_and_count_the_others() {
    let text = many(200, "<link name=\"a#\" b#=\"1\"><inertial/></link>\n");
    let mistakes = import(&text, &Options::default()).expect_err("no mass");
    let errors = mistakes.iter().filter(|mistake| mistake.is_error).count();
    let listed = listing("many.urdf", &mistakes);
    assert!(listed.contains("many.urdf:1:43: error: link \"a0\""), "{listed}");
    assert!(listed.contains("many.urdf: not shown: 150 more warnings\n"), "{listed}");
    assert!(listed.ends_with(&format!("many.urdf: not shown: {} more errors\n", errors - 50)), "{listed}");
    assert_eq!(
        listing("a", &mistakes[..1]).lines().next(),
        Some(format!("a:{}", mistakes[0]).lines().next().expect("a line"))
    );
}

/// Links are numbered if their names contain no letters of identifiers.
#[test]
fn many_equal_names_take_as_long_as_others() {
    let links = many(3000, "<link name=\"関\u{4e00}#\u{4e01}\"/>")
        .replace(|digit: char| digit.is_ascii_digit(), "関");
    assert!(import(&links, &Options::default()).is_err());
    let mass = "<inertial><mass value=\"1\"/><inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>";
    let joints = (0..300).map(|number| {
        let name = char::from_u32(0x4e00 + number).expect("a letter");
        format!(
            "<link name=\"{name}\">{mass}</link><joint name=\"{name}\" type=\"revolute\"><parent link=\"base\"/><child link=\"{name}\"/></joint>"
        )
    });
    let text = format!("<robot name=\"r\"><link name=\"base\"/>{}</robot>", joints.collect::<String>());
    let declaration = import(&text, &Options::default()).expect("a robot").declaration;
    assert!(declaration.contains("link_link_299") && declaration.contains("joint_joint_299"));
}
