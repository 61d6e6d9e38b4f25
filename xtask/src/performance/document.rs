//! The generated parts of a document, between `<!-- begin NAME -->` and `<!-- end NAME -->`.

use std::fs;
use std::path::Path;

/// Replaces every named part.
pub(super) fn rewrite(path: &Path, parts: &[(&str, String)]) -> Result<(), String> {
    let failed = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    let text = fs::read_to_string(path).map_err(|error| failed(&error))?;
    let text = parts.iter().try_fold(text, |text, (name, content)| replaced(&text, name, content));
    fs::write(path, text.map_err(|error| failed(&error))?).map_err(|error| failed(&error))
}

fn replaced(text: &str, name: &str, content: &str) -> Result<String, String> {
    let (begin, end) = (format!("<!-- begin {name} -->\n"), format!("<!-- end {name} -->"));
    let (before, rest) = text.split_once(&begin).ok_or_else(|| format!("no part {name}"))?;
    let (_, after) = rest.split_once(&end).ok_or_else(|| format!("part {name} has no end"))?;
    Ok(format!("{before}{begin}\n{content}\n{end}{after}"))
}

#[cfg(test)]
mod tests {
    use super::replaced;

    #[test]
    fn only_the_named_part_is_replaced() {
        let text = "a\n<!-- begin x -->\nold\n<!-- end x -->\nb";
        let new = "a\n<!-- begin x -->\n\nnew\n\n<!-- end x -->\nb";
        assert_eq!(replaced(text, "x", "new\n").as_deref(), Ok(new));
        assert!(replaced(text, "y", "new\n").is_err());
    }
}
