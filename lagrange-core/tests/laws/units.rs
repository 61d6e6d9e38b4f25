//! Units of the examples agree, and disagree when two of them are swapped.

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use lagrange_core::pipeline::parse_with;
use lagrange_core::tables::FileText;

/// Locations of the declarations of examples, relative to the root of the repository.
const PLACES: [&str; 3] = ["examples", "tests/mechanisms/four_bar.rs", "tests/mechanisms/squeezer.rs"];
const TABLE: &str = "table";
/// Statements whose names have units.
const DECLARING: [&str; 10] =
    ["param", "coord", "input", "const", "state", "output", "let", "velocity", "function", TABLE];
/// A declaration of an example.
struct Declaration {
    /// Names of the example and of the type.
    name: String,
    text: String,
}

/// A name with its unit.
struct Annotation {
    name: String,
    /// Location of the unit.
    unit: Range<usize>,
}

#[test]
fn examples_declare_units_that_agree() {
    let declarations = declarations();
    assert!(declarations.len() > 40, "{} declarations", declarations.len());
    let unitless = declarations.iter().filter(|one| annotations(&one.text).is_empty());
    assert_eq!(unitless.map(|one| one.name.as_str()).collect::<Vec<_>>(), [""; 0]);
    let wrong = declarations.iter().filter_map(|one| Some(format!("{}: {}", one.name, errors(&one.text)?)));
    let wrong = wrong.collect::<Vec<_>>();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Swaps each name with one that has a different unit.
#[test]
fn swapped_units_are_seen() {
    let next = |index: usize, units: &[&str]| {
        let others = (index + 1..units.len()).chain(0..index);
        others.filter(|&other| units[other] != units[index]).take(1).collect()
    };
    assert_eq!(unseen(next), "");
}

/// Swaps any two names with different units:
/// `cargo test --release -p lagrange-core --test laws swapped -- --ignored`.
#[test]
#[ignore = "takes a minute"]
fn any_two_swapped_units_are_seen() {
    let all = |index: usize, units: &[&str]| {
        (index + 1..units.len()).filter(|&other| units[other] != units[index]).collect()
    };
    assert_eq!(unseen(all), "");
}

/// Returns the swaps that cause no error, among those of each name with its given partners.
fn unseen(partners: impl Fn(usize, &[&str]) -> Vec<usize>) -> String {
    let mut unseen = Vec::new();
    for Declaration { name, text } in declarations() {
        let annotations = annotations(&text);
        let units = annotations.iter().map(|one| &text[one.unit.clone()]).collect::<Vec<_>>();
        for (index, one) in annotations.iter().enumerate() {
            for partner in partners(index, &units) {
                let other = &annotations[partner];
                let swapped =
                    if index < partner { swapped(&text, one, other) } else { swapped(&text, other, one) };
                if errors(&swapped).is_none() {
                    unseen.push(format!("{name}: {} and {}", one.name, other.name));
                }
            }
        }
    }
    unseen.join("\n")
}

/// Returns a declaration in which two names have exchanged their units.
fn swapped(text: &str, one: &Annotation, other: &Annotation) -> String {
    let (first, second) = (&text[one.unit.clone()], &text[other.unit.clone()]);
    let (before, between, behind) =
        (&text[..one.unit.start], &text[one.unit.end..other.unit.start], &text[other.unit.end..]);
    [before, second, between, first, behind].concat()
}

/// Returns all errors of a declaration, or `None` if there are none.
fn errors(text: &str) -> Option<String> {
    let root = root();
    let read = |path: &str| {
        let text = fs::read_to_string(root.join(path)).map_err(|error| error.to_string())?;
        Ok(FileText { path: String::new(), text })
    };
    parse_with(text, &read).err().map(|report| report.to_string())
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Returns the declarations of all examples, in the order of their files.
fn declarations() -> Vec<Declaration> {
    let mut files = Vec::new();
    for place in PLACES.map(|place| root().join(place)) {
        match fs::read_dir(&place) {
            Ok(entries) => files.extend(entries.map(|entry| entry.expect("an entry").path())),
            Err(_) => files.push(place),
        }
    }
    files.retain(|file| file.extension().is_some_and(|extension| extension == "rs"));
    files.sort();
    files.iter().flat_map(|file| of_file(file)).collect()
}

fn of_file(file: &Path) -> Vec<Declaration> {
    let source = fs::read_to_string(file).expect("readable text");
    let stem = file.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let uncommented = source.lines().map(|line| line.split("//").next().unwrap_or_default());
    let source = uncommented.collect::<Vec<_>>().join("\n");
    let mut found = Vec::new();
    for begin in ["lagrange::system! {", "compiled_with_text! {"] {
        for text in source.split(begin).skip(1).map(body).filter(|text| !text.contains('$')) {
            let name = text.split("pub").nth(1).and_then(|rest| rest.split("struct").nth(1));
            let name = name.and_then(|name| name.split([';', '<']).next()).unwrap_or_default().trim();
            found.push(Declaration { name: format!("{stem}, {name}"), text: text.to_owned() });
        }
    }
    for text in source.split("\nvariants! {").skip(1) {
        if let Some((name, rest)) = text.split_once('{') {
            let text = format!("pub struct Variant; {}", body(rest));
            found.push(Declaration { name: format!("{stem}, {}", name.trim()), text });
        }
    }
    found
}

/// Returns the text before the closing brace.
fn body(text: &str) -> &str {
    let mut open = 1;
    let end = text.find(|character| {
        open += i32::from(character == '{') - i32::from(character == '}');
        open == 0
    });
    &text[..end.unwrap_or(text.len())]
}

/// Returns the units of a declaration in order.
fn annotations(text: &str) -> Vec<Annotation> {
    let (mut start, mut depth, mut found) = (0, 0, Vec::new());
    for (place, character) in text.char_indices() {
        depth += depth_change(character);
        if depth == 0 && matches!(character, ';' | '}') {
            let keyword = text[start..place].split_whitespace().next().unwrap_or_default();
            // The settings of a table follow its points.
            let end =
                text[start..place].find('=').filter(|_| keyword == TABLE).map_or(place, |end| start + end);
            if DECLARING.contains(&keyword) {
                found.extend(
                    text[start..end].match_indices(':').map(|(colon, _)| annotation(text, start + colon)),
                );
            }
            start = place + 1;
        }
    }
    found
}

/// Returns the annotation between a colon and a value or another name.
fn annotation(text: &str, colon: usize) -> Annotation {
    let (mut depth, rest) = (0, &text[colon + 1..]);
    let end = rest.find(|character| {
        let ends = depth == 0 && matches!(character, '=' | ',' | ';' | ')');
        depth += depth_change(character);
        ends
    });
    let unit = &rest[..end.unwrap_or(rest.len())];
    let start = colon + 1 + unit.len() - unit.trim_start().len();
    Annotation { name: name_before(&text[..colon]), unit: start..start + unit.trim().len() }
}

fn depth_change(character: char) -> i32 {
    match character {
        '(' | '[' | '{' => 1,
        ')' | ']' | '}' => -1,
        _ => 0,
    }
}

/// Returns the last name, before the indices of an array or the arguments of a function.
fn name_before(text: &str) -> String {
    let mut depth = 0;
    let is_inside = |character: char| {
        depth -= depth_change(character);
        depth > 0 || matches!(character, '(' | '[')
    };
    let text = text.trim_end_matches(is_inside);
    let name = text.rsplit(|character: char| !character.is_alphanumeric() && character != '_').next();
    name.unwrap_or_default().to_owned()
}
