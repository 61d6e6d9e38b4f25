use std::fs;
use std::path::Path;

use crate::syntax::parse_text;
use lagrange_expr::diagnostics::Report;

/// Returns name and text of each system in the test data.
pub(super) fn systems() -> Vec<(String, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let directories = ["../../tests/oracle", "../../tests/constrained"].map(|directory| root.join(directory));
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
fn every_system_is_read() {
    let systems = systems();
    assert!(systems.len() >= 25);
    for (name, text) in systems {
        let mut report = Report::default();
        let declaration = parse_text(&text, &mut report).expect("tokens");
        assert!(report.diagnostics().is_empty(), "{name}: {report}");
        let semicolons = text.lines().filter(|line| line.ends_with(';')).count();
        let comments = text.lines().filter(|line| line.starts_with("//") && line.ends_with(';')).count();
        assert_eq!(declaration.statements.len(), semicolons - comments, "{name}");
    }
}
