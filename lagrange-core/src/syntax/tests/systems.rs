use std::fs;
use std::path::Path;

use super::errors;
use crate::diagnostics::Report;
use crate::syntax::parse_text;

/// Name and text of each system that is kept as test data.
fn systems() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let directories = ["../tests/oracle", "../tests/constrained"].map(|directory| root.join(directory));
    let mut paths = directories
        .iter()
        .flat_map(|directory| fs::read_dir(directory).expect("the test data is in place"))
        .map(|entry| entry.expect("a readable entry").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "lag"))
        .collect::<Vec<_>>();
    paths.sort();
    let read = |path: &Path| fs::read_to_string(path).expect("readable text");
    paths.iter().map(|path| (path.display().to_string(), read(path))).collect()
}

#[test]
fn every_system_is_read_except_its_constraints() {
    let systems = systems();
    assert!(systems.len() >= 25);
    for (name, text) in systems {
        let mut report = Report::default();
        let declaration = parse_text(&text, &mut report).expect("tokens");
        let constraints = text.lines().enumerate().filter(|(_, line)| line.starts_with("constraint "));
        let expected = constraints.map(|(line, _)| {
            format!("error at {}:1: `constraint` statements are not available yet", line + 1)
        });
        assert_eq!(errors(&text), expected.collect::<Vec<_>>(), "{name}");
        let semicolons = text.lines().filter(|line| line.ends_with(';')).count();
        let comments = text.lines().filter(|line| line.starts_with("//") && line.ends_with(';')).count();
        let read = declaration.statements.len() + report.diagnostics().len();
        assert_eq!(read, semicolons - comments, "{name}");
    }
}
