//! Layout of statements for human readers.

/// Maximum width of a line; longer ones are broken.
const WIDEST: usize = 120;
/// Maximum width of a comment; longer ones are wrapped, as in this workspace.
const WIDEST_COMMENT: usize = 100;
/// Indentation of every statement.
const INDENT: &str = "    ";

/// Statements, comments and empty lines.
#[derive(Debug, Default)]
pub(super) struct Page {
    lines: Vec<String>,
}

impl Page {
    pub(super) fn line(&mut self, text: &str) {
        self.lines.push(format!("{INDENT}{text}"));
    }

    /// Adds a comment, on as many lines as necessary.
    pub(super) fn comment(&mut self, mark: &str, text: &str) {
        let mut line = mark.to_owned();
        for word in text.split_whitespace() {
            if line.chars().count() + word.chars().count() + INDENT.len() >= WIDEST_COMMENT && line != mark {
                self.line(&line);
                mark.clone_into(&mut line);
            }
            line = format!("{line} {word}");
        }
        self.line(&line);
    }

    /// Adds an empty line, unless the last line is empty.
    pub(super) fn gap(&mut self) {
        if self.lines.last().is_some_and(|line| !line.is_empty()) {
            self.lines.push(String::new());
        }
    }

    /// Adds a statement with properties in braces, on one line if they fit.
    pub(super) fn block(&mut self, head: &str, properties: &[String]) {
        if properties.is_empty() {
            return self.line(&format!("{head};"));
        }
        let line = format!("{head} {{ {} }}", properties.join(" "));
        if line.chars().count() + INDENT.len() <= WIDEST {
            return self.line(&line);
        }
        self.line(&format!("{head} {{"));
        properties.iter().for_each(|property| self.property(property));
        self.line("}");
    }

    /// Adds a property on a separate line, or on two lines if it is a long list.
    fn property(&mut self, property: &str) {
        let line = format!("{INDENT}{property}");
        let commas = line.match_indices(", ").map(|(index, _)| index + 1).collect::<Vec<_>>();
        match commas.get(commas.len() / 2) {
            Some(&middle) if line.chars().count() + INDENT.len() > WIDEST => {
                let (first, second) = line.split_at(middle);
                self.line(first);
                self.line(&format!("{INDENT}{INDENT}{}", second.trim_start()));
            }
            _ => self.line(&line),
        }
    }

    /// Adds a statement of several parts, separated by commas.
    pub(super) fn list(&mut self, head: &str, parts: &[String]) {
        let mut line = head.to_owned();
        for (i, part) in parts.iter().enumerate() {
            let part = format!(" {part}{}", if i + 1 == parts.len() { ";" } else { "," });
            if line.chars().count() + part.chars().count() + INDENT.len() > WIDEST {
                self.line(&line);
                line = INDENT.to_owned();
            }
            line.push_str(&part);
        }
        self.line(&line);
    }

    /// Returns all lines, without empty ones at the end.
    pub(super) fn text(mut self) -> String {
        while self.lines.last().is_some_and(String::is_empty) {
            self.lines.pop();
        }
        self.lines.iter().map(|line| format!("{line}\n")).collect()
    }
}

/// Formats a vector as `(x, y, z)`.
pub(super) fn vector<T: ToString>(components: impl IntoIterator<Item = T>) -> String {
    let components = components.into_iter().map(|component| component.to_string()).collect::<Vec<_>>();
    format!("({})", components.join(", "))
}
