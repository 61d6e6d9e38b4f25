use super::{errors, read_wrong, statements};

#[test]
fn all_mistakes_of_a_text_are_reported_where_they_are() {
    let text = "
param m = 1.0, type, l = 2.0f32, g;
coord x, y = 1
kinetc = 1/2 * m * dot(x)^2;
let a = x +;
potential = m * g * (y;
";
    assert_eq!(errors(text), ["error at 6:21: `(` is never closed"]);
    let text = text.replace("(y;", "(y z);");
    let (declaration, report) = read_wrong(&text);
    let expected = "\
error at 2:16: `type` is a Rust keyword and cannot be a name
  help: choose another name
error at 2:26: numbers have no individual types here
  help: write `2.0`
error at 3:14: missing `;` after this
  help: statements end in `;`
error at 4:1: unknown statement `kinetc`
  help: did you mean `kinetic`?
error at 5:12: expected an expression, found `;`
  help: write an operand after `+`, or remove it
error at 6:24: expected an operator, `,` or `)`, found `z`
  help: write `*` between the factors of a product
";
    assert_eq!(report, expected);
    let expected = ["param (m 1) (l ?) g", "coord x (y 1)", "let a ?", "potential (* (* m g) ?)"];
    assert_eq!(statements(&declaration.expect("tokens")), expected);
}

#[test]
fn a_forgotten_semicolon_is_seen_at_the_next_statement() {
    let text = "coord x\nkinetic = dot(x)^2\nlet a = x\nforce (a, a) at (a, a)\noutput b = a";
    let (declaration, report) = read_wrong(text);
    let expected = "\
error at 1:7: missing `;` after this
  note at 2:1: the next statement begins here
  help: statements end in `;`
error at 2:18: missing `;` after this
  note at 3:1: the next statement begins here
  help: statements end in `;`
error at 3:9: missing `;` after this
  note at 4:1: the next statement begins here
  help: statements end in `;`
error at 4:22: missing `;` after this
  note at 5:1: the next statement begins here
  help: statements end in `;`
error at 5:12: missing `;` after this
  help: statements end in `;`
";
    assert_eq!(report, expected);
    assert_eq!(declaration.expect("tokens").statements.len(), 5);
}

#[test]
fn reading_continues_at_the_next_statement() {
    let text = "let a = x +\nlet b = 2;\nparam c,\ncoord d;\n+ 3;\nlet = 4;\nlet let e = 5;";
    let (declaration, report) = read_wrong(text);
    let expected = "\
error at 2:1: expected an expression, found `let`
  help: write an operand after `+`, or remove it
error at 3:8: missing `;` after this
  note at 4:1: the next statement begins here
  help: statements end in `;`
error at 5:1: expected a statement, found `+`
  help: statements begin with one of `param`, `const`, `coord`, `state`, `discrete`, `mode`, `start`, `history`, `range`, `quaternion`, `velocity`, `input`, `noise`, `let`, `function`, `table`, `solve`, `kinetic`, `potential`, `lagrangian`, `gibbs`, `dissipation`, `force`, `torque`, `constraint`, `stabilise`, `event`, `every`, `friction`, `output`, `emit`, `reduce`, `for`, `part`, `include`, `gravity`, `body`, `frame`, `line`, `plane`, `circle`, `sphere`, `cylinder`, `terrain`, `contact`, `contacts`, `spring`, `damper`, `torsion_spring`, `torsion_damper`, `pin`, `slide`, `roll`, `revolute`, `prismatic`, `screw`, `cylindrical`, `universal`, `planar`, `ball`, `free`, `weld`
error at 6:5: expected a name, found `=`
  help: write `let name = e;`, `let (a, b) = (e, f);` for the components of a vector, or `let f(x, y) = e;` for a function
error at 7:5: `let` begins a statement and cannot be a name
  help: choose another name
";
    assert_eq!(report, expected);
    assert_eq!(statements(&declaration.expect("tokens")), ["let a ?", "let b 2", "param c", "coord d"]);
}

#[test]
fn skipped_statements_are_recorded_by_their_words() {
    let declaration = read_wrong("paran m = 1.0;\nparam type, l;\nlet e = a +;").0.expect("tokens");
    let words = ["m", "type", "l", "a"].map(|word| declaration.unreadable_words.contains(&word.to_owned()));
    assert_eq!(words, [true, true, false, false]);
    // The variable of a loop is declared before its lines.
    let declaration = read_wrong("for i in 0..2 { start a[i] b = i; let c[i] = i; }").0.expect("tokens");
    assert!(!declaration.unreadable_words.contains(&"i".to_owned()));
    // A coordinate keeps its position, so that vectors have the length that the user expects.
    let declaration = read_wrong("coord x, type, y;").0.expect("tokens");
    assert_eq!(statements(&declaration), ["coord x __coordinate_3 y"]);
}

#[test]
fn unknown_statements_get_the_nearest_keyword() {
    let helps = [
        ("kinetc = 1;", "did you mean `kinetic`?"),
        ("parameter a;", "did you mean `param`?"),
        ("coords x;", "did you mean `coord`?"),
        ("speed = 1;", "to name an expression, write `let speed = …;`"),
        ("speed limit;", "statements begin with one of `param`, `const`, `coord`"),
    ];
    for (text, help) in helps {
        let report = read_wrong(text).1;
        assert!(report.starts_with("error at 1:1: unknown statement"), "{report}");
        assert!(report.contains(help), "{report}");
    }
}

#[test]
fn undeclarable_names_are_explained() {
    let cases = [
        ("fn", "`fn` is a Rust keyword and cannot be a name"),
        ("self", "`self` is a Rust keyword and cannot be a name"),
        ("gen", "`gen` is a Rust keyword and cannot be a name"),
        ("const", "`const` begins a statement and cannot be a name"),
        ("body", "`body` begins a statement and cannot be a name"),
        ("sin", "`sin` is a function and cannot be declared"),
        ("powi", "`powi` is a function and cannot be declared"),
        ("t", "`t` is time and cannot be declared"),
        ("pi", "`pi` is the number 3.14159… and cannot be declared"),
        ("_", "`_` is not a name"),
        ("__a", "`__a` begins with two underscores, which are reserved for generated code"),
        ("r#type", "`r#type` is a raw identifier, which cannot be used as a name here"),
    ];
    for (name, message) in cases {
        for statement in ["param {}, b;", "coord {};", "let {} = 1;", "let (a, {}) = e;", "output {} = 1;"] {
            let text = statement.replace("{}", name);
            let found = errors(&text);
            assert_eq!(found.len(), 1, "{text}: {found:#?}");
            assert!(found[0].ends_with(message), "{text}: {found:#?}");
        }
    }
}

#[test]
fn missing_pieces_of_statements_are_reported() {
    let cases = [
        ("const k, l = 1;", "error at 1:7: the constant `k` needs a value"),
        ("param 3 = 1;", "error at 1:7: expected a name, found `3`"),
        ("param a = 1 b = 2;", "error at 1:13: missing `,` before this"),
        ("kinetic 1;", "error at 1:9: expected `=`, found `1`"),
        ("kinetic == 1;", "error at 1:9: expected `=`, found `==`"),
        ("let (a) = b;", "error at 1:5: a vector has two or more components, not 1"),
        ("let (a b) = e;", "error at 1:8: expected `,` or `)`, found `b`"),
        ("let () = e;", "error at 1:6: expected a name, found nothing"),
        ("force (a, b);", "error at 1:13: expected `at`, found `;`"),
        ("force (a, b) = c;", "error at 1:14: expected `at`, found `=`"),
        ("torque m;", "error at 1:9: expected `on`, found `;`"),
        ("torque m at a;", "error at 1:10: expected `on`, found `at`"),
        ("emit a, b;", "error at 1:6: expected `{`, found `a`"),
        ("emit { a b }", "error at 1:10: expected `,` or `}`, found `b`"),
        ("emit { 1 }", "error at 1:8: expected a name, found `1`"),
        ("/// doc\nkinetic = 1;", "error at 1:1: attributes are not allowed here"),
        ("#[inline]\ncoord x;", "error at 1:1: attributes are not allowed here"),
        ("coord x; /// doc", "error at 1:10: attributes are not allowed here"),
        ("let a = b /// doc\n;", "error at 1:11: expected an operator or `;`, found `#`"),
    ];
    for (text, message) in cases {
        assert_eq!(errors(text), [message], "{text}");
    }
}

#[test]
fn an_index_before_the_end_of_a_name_is_reported() {
    let text = "let a = case[0]_z;\nlet b = c _z;\nstart case[0]_z = 1;\nstart case[0]_w = case[1]_z;";
    let (_, report) = read_wrong(text);
    let expected = "\
error at 1:16: expected an operator or `;`, found `_z`
  help: indices are at the end of names: `case_z[i]` for `z` of `case[i]`
error at 2:11: expected an operator or `;`, found `_z`
  help: write `*` between the factors of a product
error at 3:14: expected `=`, found `_z`
  help: indices are at the end of names: `case_z[i]` for `z` of `case[i]`
error at 4:14: expected `=`, found `_w`
  help: indices are at the end of names: `case_z[i]` for `z` of `case[i]`
";
    assert_eq!(report, expected);
}

#[test]
fn untokenisable_texts_are_located() {
    let cases = [
        ("let a = (b", "error at 1:9: `(` is never closed"),
        ("let a = b)", "error at 1:10: `)` has no matching opening bracket"),
        ("let a = (b]", "error at 1:11: `]` has no matching opening bracket"),
        ("let θ = x²;", "error at 1:10: unexpected character `²`"),
        ("let a = \"b;", "error at 1:9: this quotation mark does not begin a readable string"),
        ("\u{feff}let a = x\u{0};", "error at 1:11: unexpected character `\\0`"),
    ];
    for (text, message) in cases {
        assert_eq!(errors(text), [message], "{text}");
        assert!(read_wrong(text).0.is_none());
    }
}

#[test]
fn long_words_are_cut_in_messages() {
    let report = read_wrong(&format!("{} = 1;", "a".repeat(10_000))).1;
    assert!(report.len() < 300, "{report}");
}

#[test]
fn reductions_continue_after_a_mistake() {
    let text = "
reduce near;
reduce Near { frieze x = 0; small y + 1; freeze x; 3; small z; }
coord x;
";
    let (declaration, report) = read_wrong(text);
    let expected = "\
error at 2:12: expected `{`, found `;`
  help: write `reduce Name { freeze x = 0; small theta; }`
error at 3:15: expected `freeze`, `small` or `ignore`, found `frieze`
  help: did you mean `freeze`?
error at 3:37: expected an operator, `,` or `;`, found `+`
  help: expressions are made of numbers, names, calls such as `sin(x)`, parentheses and the operators `+ - * / ^`
error at 3:49: the frozen coordinate `x` needs a value
  help: write `freeze x = 0;`, or a parameter after `=`, which is set when the program runs
error at 3:52: expected `freeze`, `small` or `ignore`, found `3`
  help: write `reduce Name { freeze x = 0; small theta; }`
";
    assert_eq!(report, expected);
    let expected = ["reduce Near (Small y) (Frozen x) (Small z)", "coord x"];
    assert_eq!(statements(&declaration.expect("tokens")), expected);
}

#[test]
fn missing_pieces_of_events_are_reported() {
    let cases = [
        ("event a;", "error at 1:8: expected `=`, found `;`"),
        ("event a = x;", "error at 1:12: the event `a` has no action"),
        ("event a = x,;", "error at 1:13: the event `a` has no direction"),
        ("event a = x => stop;", "error at 1:13: the event `a` has no direction"),
        ("event a = x falling => stop;", "error at 1:13: the event `a` has no direction"),
        ("event a = x, up => stop;", "error at 1:14: expected `rising`, `falling` or `crossing`, found `up`"),
        ("event a = x, falling;", "error at 1:21: the event `a` has no action"),
        ("event a = x, falling stop;", "error at 1:22: expected `=>`, found `stop`"),
        ("event a = x, falling = stop;", "error at 1:22: expected `=>`, found `=`"),
        ("event a = x, falling =>;", "error at 1:24: the event `a` has no action"),
        (
            "event a = x, falling => end;",
            "error at 1:25: expected `stop`, `record`, `impact(e)` or `{`, found `end`",
        ),
        ("event a = x, falling => stop b;", "error at 1:30: expected `;`, found `b`"),
        ("event a = x, falling => impact;", "error at 1:25: an impact needs a coefficient of restitution"),
        ("event a = x, falling => impact();", "error at 1:31: an impact needs a coefficient of restitution"),
        ("event a = x, falling => impact(0, 1);", "error at 1:33: expected an operator or `)`, found `,`"),
        ("event a = x, falling => {};", "error at 1:25: nothing is assigned between these braces"),
        ("event a = x, falling => { x };", "error at 1:29: expected `=`, found nothing"),
        ("event a = x, falling => stop", "error at 1:25: missing `;` after this"),
    ];
    for (text, message) in cases {
        assert_eq!(errors(text), [message], "{text}");
    }
}

#[test]
fn missing_pieces_of_friction_are_reported() {
    let cases = [
        ("friction a;", "error at 1:11: expected `=`, found `;`"),
        ("friction = 1;", "error at 1:10: expected a name, found `=`"),
        ("friction a = v;", "error at 1:15: the friction `a` has no limit"),
        ("friction a = v,;", "error at 1:16: the friction `a` has no limit"),
        ("friction a = v 1;", "error at 1:16: expected an operator or `,`, found `1`"),
        ("friction a = v, 1, 2;", "error at 1:20: this friction has two limits without labels"),
        ("friction a = v, kinetic: 1;", "error at 1:17: `kinetic` without `static`"),
        ("friction a = v, static: 1;", "error at 1:17: `static` without `kinetic`"),
        ("friction a = v, 1, static: 2;", "error at 1:17: a limit without a label beside one with a label"),
        ("friction a = v, 1, kinetic: 2;", "error at 1:17: a limit without a label beside one with a label"),
        ("friction a = v, smooth: 1;", "error at 1:26: the friction `a` has no limit"),
        ("friction a = v, 1, smooth: 2, smooth: 3;", "error at 1:31: `smooth` is given twice"),
        ("friction a = v, mu: 1;", "error at 1:17: unknown label `mu` for friction"),
        (
            "friction a = v, kinetic: 1, static: 2, smooth: 3;",
            "error at 1:29: smooth friction never sticks, so it has no static limit",
        ),
    ];
    for (text, message) in cases {
        assert_eq!(errors(text), [message], "{text}");
    }
}

#[test]
fn reading_continues_after_an_event() {
    let text = "
coord x, y;
event a = x, fallling => { y = 1; };
event b = x, falling => { y = ; x 3; dot(x) = y }
event c = x, rising => stop
friction d = x +, 1, kinetic 3;
stabilise 1;
event e = x, crossing => record;
";
    let (declaration, report) = read_wrong(text);
    let expected = "\
error at 3:14: expected `rising`, `falling` or `crossing`, found `fallling`
  help: did you mean `falling`?
error at 4:31: expected an expression, found `;`
  help: write an expression here, such as `0`
error at 4:35: expected `=`, found `3`
  help: write `dot(x) = e;` or `x = e;`
error at 4:47: missing `;` after this
  help: statements end in `;`
error at 5:24: missing `;` after this
  note at 6:1: the next statement begins here
  help: statements end in `;`
error at 6:17: expected an expression, found `,`
  help: write an operand after `+`, or remove it
error at 7:11: expected `=`, found `1`
  help: write `stabilise = rate;`
";
    assert_eq!(report, expected);
    let expected = [
        "coord x y",
        "event b x Falling (y ?) ((dot x) y)",
        "event c x Rising stop",
        "event e x Crossing record",
    ];
    assert_eq!(statements(&declaration.expect("tokens")), expected);
}

#[test]
fn skipped_statements_hide_no_mistakes_about_known_names() {
    let text = "coord x;\nevent a = x;\nlet b = x +;\nlet c = a +;\nevent sin = x;\nlet d = sin(x) +;";
    let report = [
        "error at 2:12: the event `a` has no action",
        "error at 3:12: expected an expression, found `;`",
        "error at 5:7: `sin` is a function and cannot be declared",
        "error at 6:17: expected an expression, found `;`",
    ];
    assert_eq!(errors(text), report);
}

#[test]
fn contents_of_event_braces_are_described() {
    let text = "coord x;\nevent wall = x - 3, rising => { const v = 1; dot(x) = -v / 2; }\nkinetic = x * y;";
    let (declaration, report) = read_wrong(text);
    let expected = "\
error at 2:33: an event can only assign coordinates and velocities
  help: write the `const` before the event; the braces contain only `dot(x) = e;` or `x = e;`
";
    assert_eq!(report, expected);
    let expected = ["coord x", "event wall (- x 3) Rising ((dot x) ?)", "kinetic (* x y)"];
    assert_eq!(statements(&declaration.expect("tokens")), expected);
    let text = "event wall = x, rising => { kinetic = 1; x = 2; potential = 3 }";
    let places = ["error at 1:29: an event can only assign", "error at 1:49: an event can only assign"];
    assert!(errors(text).iter().zip(places).all(|(error, place)| error.starts_with(place)));
}
