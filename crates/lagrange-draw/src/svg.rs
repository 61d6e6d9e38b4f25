//! Pictures as SVG: a document of paths and texts without scripts or external resources. Its only
//! style sheet contains the colours for readers who prefer a dark ground.

use crate::beside::SEPARATOR;
use crate::colour::PAPER;
use crate::picture::{Colour, Mark, Picture, Segment, Style};
use lagrange_plot::characters::{escaped, number};
use lagrange_plot::colours::{self, CLASS};
use lagrange_plot::label::Label;
use lagrange_plot::lettering::FAMILY;

/// Returns a picture as an SVG document.
pub(crate) fn document(picture: &Picture) -> String {
    format!("{}{}</svg>\n", opening(std::slice::from_ref(picture)), marks(picture))
}

/// Returns the elements of all marks of a picture.
pub(crate) fn marks(picture: &Picture) -> String {
    picture.marks.iter().filter(|mark| !is_empty(mark)).map(mark).collect()
}

/// Returns the start of the document of pictures with the same size; empty without pictures. It has
/// the title and description of the first, and the common attributes and colours of all marks.
/// Blanks at the ends of text pieces are preserved, since some viewers would drop them.
pub(crate) fn opening(pictures: &[Picture]) -> String {
    let Some(picture) = pictures.first() else { return String::new() };
    let [width, height] = picture.size.map(number);
    format!(
        "<svg class=\"{CLASS}\" xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" role=\"img\" xml:space=\"preserve\" font-family=\"{FAMILY}\" stroke-linecap=\"round\" \
         stroke-linejoin=\"round\" fill-rule=\"evenodd\">\n<title>{}</title>\n<desc>{}</desc>\n{}\
         <rect width=\"{width}\" height=\"{height}\"{}/>\n",
        escaped(&Label::parse(&picture.title).plain()),
        escaped(&description(picture)),
        colours::style(pictures.iter().flat_map(|picture| &picture.marks).flat_map(colours_of)),
        PAPER.paint("fill"),
    )
}

fn colours_of(mark: &Mark) -> impl Iterator<Item = Colour> + use<> {
    let colours = match mark {
        Mark::Path { style, .. } => [style.fill, style.stroke],
        Mark::Text { colour, .. } => [Some(*colour), None],
    };
    colours.into_iter().flatten()
}

/// Returns the description written into the picture for readers who cannot see it.
fn description(picture: &Picture) -> String {
    let mut labels: Vec<String> = Vec::new();
    for mark in &picture.marks {
        if let Mark::Text { text, .. } = mark {
            let label = Label::parse(text).plain();
            // Titles and their lines are not labels.
            let is_caption = picture.title.split(SEPARATOR).any(|part| part == text);
            let is_title = is_caption || (text.contains(' ') && picture.title.contains(text));
            if !label.is_empty() && !is_title && !labels.contains(&label) {
                labels.push(label);
            }
        }
    }
    if labels.is_empty() {
        "A drawing without labels.".into()
    } else {
        format!("Labels: {}.", labels.join(", "))
    }
}

/// True if a mark has no content.
pub(crate) fn is_empty(mark: &Mark) -> bool {
    match mark {
        Mark::Path { segments, .. } => segments.is_empty(),
        Mark::Text { text, .. } => text.is_empty(),
    }
}

/// Returns the element of a mark.
pub(crate) fn mark(mark: &Mark) -> String {
    match mark {
        Mark::Path { segments, style: how } => {
            format!("<path d=\"{}\"{}/>\n", path_data(segments), style(how))
        }
        Mark::Text { at, text, size, anchor, colour } => {
            Label::parse(text).element(*at, *size, *anchor, &paint("fill", Some(*colour)))
        }
    }
}

/// Returns the attribute `d` of a path.
pub(crate) fn path_data(segments: &[Segment]) -> String {
    let point = |[x, y]: [f64; 2]| format!("{} {}", number(x), number(y));
    let command = |segment: &Segment| match *segment {
        Segment::Move(to) => format!("M{}", point(to)),
        Segment::Line(to) => format!("L{}", point(to)),
        Segment::Curve(a, b, to) => format!("C{} {} {}", point(a), point(b), point(to)),
        Segment::Close => "Z".into(),
    };
    segments.iter().map(command).collect()
}

/// Returns the attributes for the style of a path, each preceded by a blank.
pub(crate) fn style(style: &Style) -> String {
    let mut attributes = paint("fill", style.fill);
    if style.stroke.is_some() {
        attributes += &paint("stroke", style.stroke);
        attributes += &format!(" stroke-width=\"{}\"", number(style.width));
        if !style.dashes.is_empty() {
            let lengths: Vec<String> = style.dashes.iter().map(|length| number(*length)).collect();
            attributes += &format!(" stroke-dasharray=\"{}\"", lengths.join(" "));
        }
    }
    attributes
}

fn paint(attribute: &str, colour: Option<Colour>) -> String {
    colour.map_or_else(|| format!(" {attribute}=\"none\""), |colour| colour.paint(attribute))
}

#[cfg(test)]
pub(crate) mod tests;
