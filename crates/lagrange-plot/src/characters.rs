//! Characters of texts and numbers in pictures, and their encoding in documents.
//!
//! Names and titles come from arbitrary sources. XML 1.0 (section 2.2) does not allow most control
//! characters, nor U+FFFE and U+FFFF, not even as references. Pixels and documents show the same
//! characters, so widths match the displayed text.

/// Returns the characters of a text that a picture shows. Tabs and line ends become blanks; other
/// control characters and noncharacters are dropped.
pub fn shown(text: &str) -> impl Iterator<Item = char> + '_ {
    text.chars().filter_map(|character| match character {
        '\t' | '\n' | '\r' | '\u{85}' => Some(' '),
        _ if character.is_control() || is_noncharacter(character) => None,
        _ => Some(character),
    })
}

/// True for the 66 noncharacters of Unicode.
fn is_noncharacter(character: char) -> bool {
    let code = u32::from(character);
    code & 0xfffe == 0xfffe || (0xfdd0..=0xfdef).contains(&code)
}

/// Escapes a text for XML or HTML, so that no part of it is interpreted as a tag.
pub fn escaped(text: &str) -> String {
    let mut escaped = String::new();
    for character in shown(text) {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            character => escaped.push(character),
        }
    }
    escaped
}

/// Returns a number with at most two decimals.
pub fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

#[cfg(test)]
mod tests {
    use super::{escaped, shown};

    #[test]
    fn documents_hold_every_character_that_is_shown() {
        for code in (0..0x11_0000).filter_map(char::from_u32) {
            let kept = shown(&code.to_string()).collect::<Vec<_>>();
            // The production `Char` of XML 1.0.
            let is_allowed = matches!(code, '\t' | '\n' | '\r' | ' '..='\u{d7ff}' | '\u{e000}'..='\u{fffd}' | '\u{10000}'..);
            assert!(is_allowed || kept.is_empty(), "{code:?}");
            assert!(kept.is_empty() || kept == [code] || kept == [' '], "{code:?}");
            assert!(!kept.is_empty() || code.is_control() || u32::from(code) >= 0xfdd0, "{code:?}");
        }
        assert_eq!(escaped("a<b\u{0}>\t\u{fffe}&\"'\u{1b}[0m\r\n"), "a&lt;b&gt; &amp;&quot;&#39;[0m  ");
    }
}
