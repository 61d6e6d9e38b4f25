//! Included files of parts.

use lagrange_expr::diagnostics::Report;
use lagrange_language::tables::FileText;
use quote::quote;

use crate::derive::StrategyChoice;
use crate::pipeline::{expand_with, parse_with};

/// Returns a reader of the given files with their paths.
fn files<'f>(files: &'f [(&str, &str)]) -> impl Fn(&str) -> Result<FileText, String> + 'f {
    |path| match files.iter().find(|(known, _)| *known == path) {
        Some((_, text)) => Ok(FileText { path: format!("/crate/{path}"), text: (*text).to_owned() }),
        None => Err("it is not there".to_owned()),
    }
}

fn emitted(text: &str, of: &[(&str, &str)]) -> String {
    let derived = parse_with(text, &files(of)).and_then(|system| system.derive(StrategyChoice::Cheapest));
    let tokens = derived.and_then(|derived| derived.emit(&quote!(::lagrange)));
    tokens.unwrap_or_else(|report: Report| panic!("{text}\n{report}")).to_string()
}

const SPRING: &str = "part Spring(on) { param k = 2; potential = 1/2 * k * on^2; }";
const FOOT: &str = "include \"spring.lag\";\n/// A foot.\npart Foot(on) { spring: Spring { on: on; } }";
const HOPPER: &str =
    "coord x, y; kinetic = dot(x)^2 + dot(y)^2; foot: Foot { on: x; } extra: Spring { on: y; }";

#[test]
fn parts_of_files_are_those_of_the_declaration_and_files_are_watched() {
    let of = [("spring.lag", SPRING), ("foot.lag", FOOT)];
    // Each file is read only once, however often it is included.
    let included = emitted(&format!("include \"foot.lag\"; include \"spring.lag\"; {HOPPER}"), &of);
    for path in ["/crate/spring.lag", "/crate/foot.lag"] {
        assert_eq!(included.matches(&format!("include_bytes ! (\"{path}\")")).count(), 1, "{path}");
    }
    let foot = FOOT.replace("include \"spring.lag\";", "");
    let whole = emitted(&format!("{SPRING} {foot} {HOPPER}"), &[]);
    let watching = "const _ : & [u8] = :: core :: include_bytes !";
    let rest =
        included.split(watching).map(|part| part.split_once(';').filter(|_| part.starts_with(" (\"/crate")));
    let first = included.split(watching).next().unwrap_or_default();
    let rest = rest.flatten().map(|(_, rest)| rest).collect::<String>();
    assert_eq!(format!("{first}{}", rest.trim_start()).replace(' ', ""), whole.replace(' ', ""));
}

/// Returns all messages about a declaration, each with the position of its error.
fn mistakes(text: &str, of: &[(&str, &str)]) -> Vec<String> {
    let report = parse_with(text, &files(of)).err().unwrap_or_default();
    let place = |origin: lagrange_expr::diagnostics::Origin| {
        origin.position().map_or_else(String::new, |[line, column]| format!("{line}:{column} "))
    };
    let line = |one: &lagrange_expr::diagnostics::Diagnostic| {
        let notes = one.related.iter().map(|(origin, note)| format!("; {}{note}", place(*origin)));
        format!("{}{}{}", place(one.origin), one.message, notes.collect::<String>())
    };
    report.diagnostics().iter().map(line).collect()
}

#[test]
fn mistakes_in_files_name_file_line_and_column_and_where_the_part_is_placed() {
    let body = "coord y; kinetic = dot(y)^2;";
    let cases = [
        (
            "part P {\n  coord x;\n  kinetic = mm * dot(x)^2;\n}",
            "a[i in 0..10]: P {}",
            "1:9 p.lag:3:13: unknown name `mm` in the part `P`; 2:1 in the part `P`, placed here as `a[0]` and 9 times more",
        ),
        (
            "part P {\n  coord x\n}",
            "a: P {}",
            "1:9 p.lag:2:9: missing `;` after this; 2:1 in the part `P`, placed here as `a`",
        ),
        ("part P {\n  coord x;", "", "1:9 p.lag:1:8: `{` is never closed"),
        ("part P { }\n param k = 1;", "", "1:9 p.lag:2:2: an included file contains parts only"),
        ("include \"p.lag\";", "", "1:9 p.lag:1:9: `p.lag` includes itself"),
        ("include \"q.lag\";", "", "1:9 p.lag:1:9: `q.lag` cannot be read: it is not there"),
    ];
    for (file, placed, expected) in cases {
        let found = mistakes(&format!("include \"p.lag\"; {body}\n{placed}"), &[("p.lag", file)]);
        assert_eq!(found, [expected], "{file}");
    }
    let circle = [("a.lag", "include \"b.lag\";"), ("b.lag", "\ninclude \"a.lag\";")];
    assert_eq!(
        mistakes(&format!("include \"a.lag\"; {body}"), &circle),
        ["1:9 b.lag:2:9: `a.lag` includes itself"]
    );
    let inside = mistakes(&format!("for i in 0..1 {{ include \"p.lag\"; }} {body}"), &[]);
    assert_eq!(inside, ["1:25 a file is included inside of a loop or a condition"]);
}

#[test]
fn chains_of_files_end() {
    let texts = (0..40).map(|i| format!("include \"f{}.lag\";", i + 1)).collect::<Vec<_>>();
    let paths = (0..40).map(|i| format!("f{i}.lag")).collect::<Vec<_>>();
    let of = paths.iter().zip(&texts).map(|(path, text)| (path.as_str(), text.as_str())).collect::<Vec<_>>();
    let found = mistakes("include \"f0.lag\"; coord y; kinetic = dot(y)^2;", &of);
    assert_eq!(found, ["1:9 f31.lag:1:9: files include each other more than 32 deep"]);
}

/// The macro reads tokens; positions in files come from a second reading.
#[test]
fn errors_of_the_macro_name_files_lines_and_columns() {
    let tokens = "struct S; include \"p.lag\"; a: P {}".parse().expect("tokens");
    let of = [("p.lag", "part P {\n  coord x;\n  kinetic = mm * dot(x)^2;\n}")];
    let items = expand_with(tokens, &quote!(::lagrange), &files(&of)).to_string();
    assert!(items.contains("p.lag:3:13: unknown name `mm` in the part `P`"), "{items}");
    assert!(items.contains("struct S"));
}
