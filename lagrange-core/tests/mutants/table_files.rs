//! Files of tables, changed at random in a few places.

use std::env;

use super::guard::{self, Answer, Case};
use super::random::Random;
use super::table_judge::judged;

/// Number of cases by default.
const USUAL: usize = 500;
/// Stands for bytes that are not UTF-8.
const NO_TEXT: char = '\u{fffd}';

const FILES: [&str; 9] = [
    "0, 1\n1, 2\n2, 4\n3, 8\n",
    "# a road\nx / m; height / m\n\n0; 1.5\n0.25; -2e-3 # dip\n1.0; +7\n",
    "\u{feff}\"x\"\t\"y\"\r\n0\t.5\r\n1e3\t5.\r\n2e3\t-0\r\n",
    "0 0 1\n0 1 2\n1 0 3\n1 1 5\n",
    "x, y, z\n-1, 0, 1e-300\n-1, 2, 0\n5, 0, 2\n5, 2, 1e300\n-2, 0, 1\n-2, 2, 0\n",
    "load, 0, 1, 2\n-1, 1, 2, 3\n5, 4, 5, 7\n",
    "\t0\t0.5\r\n# a map\n0\t1\t2\r\n1e3\t3\t-5\r\n",
    "time value\n1e-9 1\n2e-9 1.5\n3e9 1\n",
    "",
];
const PIECES: [&str; 34] = [
    "",
    "0",
    "1",
    "-1",
    "+",
    "−",
    ".",
    ",",
    ";",
    "\t",
    " ",
    "#",
    "# note",
    "\n",
    "\r",
    "\r\n",
    "\0",
    "\u{fffd}",
    "\u{feff}",
    "\u{1b}[31m",
    "nan",
    "NaN",
    "inf",
    "-infinity",
    "1e999",
    "1e-999",
    "1e308",
    "5e-324",
    "1e",
    "0x10",
    "1_000",
    "1,5",
    "'",
    "99999999999999999999",
];

fn file(case: usize) -> String {
    let random = &mut Random::new(case as u64);
    let mut text = (*random.choice(&FILES)).to_owned();
    for _ in 0..*random.choice(&[0, 1, 1, 2, 3]) {
        let lines = text.lines().count();
        match random.below(3) {
            0 if lines > 0 => text = with_lines_changed(&text, lines, random),
            _ => {
                let places =
                    text.char_indices().map(|(place, _)| place).chain([text.len()]).collect::<Vec<_>>();
                let (start, end) = (random.below(places.len()), random.below(3));
                let end = (start + end).min(places.len() - 1);
                text.replace_range(places[start]..places[end], random.choice::<&str>(&PIECES));
            }
        }
    }
    text
}

/// Doubles or removes a line, or moves it to the place of another.
fn with_lines_changed(text: &str, count: usize, random: &mut Random) -> String {
    let mut lines = text.split_inclusive('\n').collect::<Vec<_>>();
    let (one, other) = (random.below(count), random.below(count));
    match random.below(3) {
        0 => lines.insert(other, lines[one]),
        1 => drop(lines.remove(one)),
        _ => lines.swap(one, other),
    }
    lines.concat()
}

/// Chooses the kind of table by the length of the file, as in the fuzz target.
fn answer(text: &str) -> Result<Answer, String> {
    let bytes = text.split(NO_TEXT).map(str::as_bytes).collect::<Vec<_>>().join(&0xff);
    Ok(if judged(&bytes, bytes.len()) { Answer::Accepted } else { Answer::Refused })
}

#[test]
fn every_file_of_a_table_is_read_or_refused() {
    let count = env::var("LAGRANGE_TABLES").map_or(USUAL, |count| count.parse().expect("a number"));
    let verdicts = guard::run(0..count, |case| Case { text: file(case), judge: answer });
    let accepted = verdicts.iter().filter(|verdict| verdict.answer == Some(Answer::Accepted)).count();
    let failures = verdicts.iter().filter_map(|verdict| Some((verdict.failure.as_ref()?, &verdict.text)));
    let failures = failures.collect::<Vec<_>>();
    println!("{count} files, {accepted} accepted");
    assert!(failures.is_empty(), "{} failures: {failures:#?}", failures.len());
    assert!(accepted > count / 20 && accepted < count, "{accepted} of {count}");
}

/// The files have more rows than a table may have, and are refused in the time of reading them.
#[test]
fn long_files_come_to_an_end() {
    let rows = (0..700_000).map(|row| format!("{row}, {}\n", row % 7)).collect::<String>();
    let wide = format!("0, 1\n{}\n", "1,".repeat(1_000_000));
    let verdicts = guard::run(0..2, move |case| Case { text: [&rows, &wide][case].clone(), judge: refused });
    for verdict in verdicts {
        assert_eq!(verdict.failure, None, "{:.1} s", verdict.seconds);
        println!("{:.1} s, {:.0} MB", verdict.seconds, verdict.bytes as f64 / 1e6);
    }
}

fn refused(text: &str) -> Result<Answer, String> {
    if judged(text.as_bytes(), 0) { Err("it is too long".to_owned()) } else { Ok(Answer::Refused) }
}
