//! Included files of parts.

use lagrange_expr::diagnostics::Report;
use lagrange_language::tables::FileText;
use quote::quote;

use crate::derive::StrategyChoice;
use crate::model::Product;
use crate::pipeline::{NumericSystem, expand_with, parse_adding, parse_with};

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

/// A declaration in a folder of its own, which includes parts and a table from there.
const ARM: [(&str, &str); 3] = [
    (
        "models/arm.lag",
        "/// An arm.\nstruct Arm;\ninclude \"spring.lag\";\ncoord x;\nkinetic = dot(x)^2;\n\
         table load(x) = \"load.csv\", interpolation: linear, outside: clamp;\nforce x = load(x);\nspring: Spring { on: x; }",
    ),
    ("models/spring.lag", SPRING),
    ("models/load.csv", "0, 1\n1, 3\n"),
];

#[test]
fn a_file_may_be_the_whole_declaration() {
    let included = emitted("include \"models/arm.lag\";", &ARM);
    for (path, _) in ARM {
        assert_eq!(included.matches(&format!("include_bytes ! (\"/crate/{path}\")")).count(), 1, "{path}");
    }
    let beside = ARM.map(|(path, text)| (path.trim_start_matches("models/"), text));
    let written = emitted(ARM[0].1, &beside);
    let unwatched = |code: &str| {
        let lines = code.replace("const _ : & [u8] = :: core :: include_bytes !", "\n").replace("; ", ";\n");
        lines.lines().filter(|line| !line.trim().starts_with("(\"/crate/")).collect::<String>()
    };
    assert_eq!(unwatched(&included), unwatched(&written));
    let again = [("all.lag", "include \"models/arm.lag\";"), ARM[0], ARM[1], ARM[2]];
    assert_eq!(unwatched(&emitted("include \"all.lag\";", &again)), unwatched(&written));
    let tokens = "include \"models/arm.lag\"".parse().expect("tokens");
    let items = expand_with(tokens, &quote!(::lagrange), &files(&ARM)).to_string();
    assert!(items.contains("missing `;`") && items.contains("struct Arm"), "{items}");
    let tokens = "include \"models/arm.lag\";".parse().expect("tokens");
    let items = expand_with(tokens, &quote!(::lagrange), &files(&ARM)).to_string();
    assert_eq!(unwatched(&items), unwatched(&written));
}

#[test]
fn products_are_added_to_the_declaration_in_a_file() {
    let parsed = |text: &str, of: &[(&str, &str)]| {
        let system = parse_adding((text, "emit { bias }"), &files(of)).expect("a system");
        let derived = system.derive(StrategyChoice::Cheapest).expect("equations");
        NumericSystem::new(&derived).product(Product::Bias, 0.0, &[0.5], &[1.0]).expect("is emitted")
    };
    let beside = ARM.map(|(path, text)| (path.trim_start_matches("models/"), text));
    assert_eq!(parsed("include \"models/arm.lag\";", &ARM), parsed(ARM[0].1, &beside));
}

#[test]
fn a_file_has_one_spelling() {
    let of = [("models/spring.lag", SPRING), ("models/arm.lag", ARM[0].1), ("models/load.csv", ARM[2].1)];
    let spelt = ARM[0].1.replace("\"spring.lag\"", "\"./spring.lag\"");
    let twice = spelt.replace("coord x;", "include \"../models/spring.lag\"; coord x;");
    for text in [spelt, twice] {
        let of = [of[0], (of[1].0, &text[..]), of[2]];
        assert!(emitted("include \"./models/arm.lag\";", &of).contains("spring_k"));
    }
    let itself = [("models/arm.lag", "include \"../models/arm.lag\";")];
    let found = mistakes("include \"models/arm.lag\";", &itself);
    assert_eq!(found, ["1:9 models/arm.lag:1:9: `../models/arm.lag` includes itself"]);
}

#[test]
fn mistakes_in_a_whole_declaration_name_their_file() {
    let cases = [
        ("struct Arm;\ncoord x;\nkinetic = mm * dot(x)^2;", "1:9 arm.lag:3:11: unknown name `mm`"),
        ("coord x;\nkinetic = (dot(x)^2;", "1:9 arm.lag:2:11: `(` is never closed"),
        (
            "struct Arm {}\ncoord x; kinetic = dot(x)^2;",
            "1:9 arm.lag:1:12: fields come from `param` and `input` statements, not from the struct",
        ),
        ("struct;", "1:9 arm.lag:1:7: expected a name, found `;`"),
        ("include \"arm.lag\";", "1:9 arm.lag:1:9: `arm.lag` includes itself"),
        (
            "struct Arm;\ninclude \"arm.lag\";\ncoord x; kinetic = dot(x)^2;",
            "1:9 arm.lag:2:9: `arm.lag` includes itself",
        ),
        (
            "struct Arm;\ninclude \"p.lag\";\ncoord x; kinetic = dot(x)^2;",
            "1:9 arm.lag:2:9: `p.lag` cannot be read: it is not there",
        ),
        ("include \"p.lag\";", "1:9 arm.lag:1:9: `p.lag` cannot be read: it is not there"),
        ("part P {}", "a system needs at least one generalised coordinate"),
    ];
    for (file, expected) in cases {
        let text = "include \"arm.lag\";";
        assert_eq!(mistakes(text, &[("arm.lag", file)]), [expected], "{file}");
        let items =
            expand_with(text.parse().expect("tokens"), &quote!(::lagrange), &files(&[("arm.lag", file)]));
        let message = expected.trim_start_matches("1:9 ").replace('"', "\\\"");
        assert!(items.to_string().contains(&message), "{file}: {items}");
    }
}
