//! Files of mistakes. Besides comments with `#`, their lines are:
//!
//! ```text
//! base NAME            names the statements that follow
//! in NAME              mistakes that follow are made in a declaration that begins with that base; `in nothing` for whole ones
//! mistake WORDS        a mistake, in the words of its author
//! > STATEMENTS         what is declared, with the place of the error between « and »
//! says WORDS           what the message must contain
//! helps WORDS          what the help must contain
//! because WORDS        why it is not answered like that: the mistake is one of those that are open
//! ```

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// A mistake with its expected answer.
#[derive(Debug, Default)]
pub(crate) struct Mistake {
    pub(crate) file: String,
    pub(crate) name: String,
    /// The whole declaration.
    pub(crate) text: String,
    /// The beginning and the end of the error: lines from one, columns from zero.
    pub(crate) place: [(usize, usize); 2],
    pub(crate) says: Vec<String>,
    pub(crate) helps: Vec<String>,
    /// The reason why there is no good answer yet.
    pub(crate) open: Option<String>,
}

/// Returns every mistake in the files beside this one, in order of name.
pub(crate) fn mistakes() -> Vec<Mistake> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/mistakes");
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let mut files = entries.filter(|path| path.extension().is_some_and(|e| e == "txt")).collect::<Vec<_>>();
    files.sort();
    let read = |path: &Path| fs::read_to_string(path).expect("a file of mistakes");
    files.iter().flat_map(|path| mistakes_of(&path.display().to_string(), &read(path))).collect()
}

fn mistakes_of(file: &str, text: &str) -> Vec<Mistake> {
    let mut bases = BTreeMap::from([("nothing", String::new())]);
    let (mut base, mut new_base) = ("nothing", None);
    let mut mistakes: Vec<Mistake> = Vec::new();
    for (number, line) in
        text.lines().enumerate().filter(|(_, line)| !line.is_empty() && !line.starts_with('#'))
    {
        let complaint = || panic!("{file}:{}: what is `{line}`?", number + 1);
        let (word, rest) = line.split_once(' ').unwrap_or((line, ""));
        assert!(!rest.is_empty() || word == ">", "{file}:{}: nothing stands behind `{word}`", number + 1);
        let last = mistakes.last_mut();
        match (word, new_base, last) {
            ("base", ..) => {
                new_base = Some(rest);
                bases.insert(rest, String::new());
            }
            ("in", ..) => (base, new_base) = (rest, None),
            ("mistake", ..) => {
                let (file, name) = (file.to_owned(), rest.to_owned());
                mistakes.push(Mistake { file, name, text: bases[base].clone(), ..Mistake::default() });
            }
            (">", Some(name), _) => bases.entry(name).or_default().push_str(&format!("{rest}\n")),
            (">", None, Some(mistake)) => mistake.text.push_str(&format!("{rest}\n")),
            ("says", None, Some(mistake)) => mistake.says.push(rest.to_owned()),
            ("helps", None, Some(mistake)) => mistake.helps.push(rest.to_owned()),
            ("because", None, Some(mistake)) => mistake.open = Some(rest.to_owned()),
            _ => complaint(),
        }
    }
    mistakes.into_iter().map(placed).collect()
}

/// Returns the mistake without the marks of its location in the text.
fn placed(mut mistake: Mistake) -> Mistake {
    mistake.place = ['«', '»'].map(|mark| {
        let parts = mistake.text.split(mark).collect::<Vec<_>>();
        let [before, after] = parts[..] else { panic!("{}: one `{mark}` is needed", mistake.name) };
        let line = before.lines().count().max(1) + usize::from(before.ends_with('\n'));
        let column = before.rsplit('\n').next().unwrap_or_default().chars().count();
        mistake.text = format!("{before}{after}");
        (line, column)
    });
    mistake
}
