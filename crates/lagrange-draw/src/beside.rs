//! Pictures next to each other.

use crate::geometry::{add, moved};
use crate::picture::{Mark, Picture, Point};

/// Maximum number of pictures in a row.
const ROW: usize = 3;
/// Separator between the titles in the combined title.
pub(super) const SEPARATOR: &str = "; ";

impl Picture {
    /// Arranges pictures next to each other, each with its title above; more than three are split
    /// into rows.
    pub fn beside(pictures: &[Picture]) -> Picture {
        let columns = columns(pictures.len());
        let (mut size, mut marks) = ([0.0_f64, 0.0_f64], Vec::new());
        for row in pictures.chunks(columns) {
            let mut left = 0.0;
            for picture in row {
                marks.extend(picture.marks.iter().map(|mark| shifted(mark, [left, size[1]])));
                left += picture.size[0];
            }
            size[0] = size[0].max(left);
            size[1] += row.iter().map(|picture| picture.size[1]).fold(0.0, f64::max);
        }
        let titles = pictures.iter().map(|picture| picture.title.as_str()).filter(|title| !title.is_empty());
        Picture { size, title: titles.collect::<Vec<&str>>().join(SEPARATOR), marks }
    }
}

fn columns(count: usize) -> usize {
    if count <= ROW { count.max(1) } else { (1..=count).find(|side| side * side >= count).unwrap_or(count) }
}

fn shifted(mark: &Mark, by: Point) -> Mark {
    let mut mark = mark.clone();
    match &mut mark {
        Mark::Path { segments, .. } => *segments = moved(segments, |p| add(p, by)),
        Mark::Text { at, .. } => *at = add(*at, by),
    }
    mark
}

#[cfg(test)]
mod tests {

    use crate::colour::INK;
    use crate::picture::{Mark, Picture};
    use lagrange_plot::label::Anchor;

    #[test]
    fn captions_are_the_title_and_no_labels() {
        let text = |text: &str, size| Mark::Text {
            at: [50.0, 20.0],
            text: text.into(),
            size,
            anchor: Anchor::Middle,
            colour: INK,
        };
        let picture = |title: &str| Picture {
            size: [100.0, 80.0],
            title: title.into(),
            marks: vec![text(title, 15.0), text("M", 14.0)],
        };
        let svg = Picture::beside(&[picture("Start"), picture("The centre M")]).svg();
        assert!(svg.contains("<title>Start; The centre M</title>"), "{svg}");
        assert!(svg.contains("<desc>Labels: M.</desc>"), "{svg}");
    }

    #[test]
    fn three_are_in_a_row_and_four_in_a_square() {
        let picture =
            |title: &str| Picture { size: [100.0, 80.0], title: title.into(), ..Picture::default() };
        let all = [picture("a"), picture("b"), picture("c"), picture("d")];
        assert_eq!(Picture::beside(&all[..3]).size, [300.0, 80.0]);
        let square = Picture::beside(&all);
        assert_eq!((square.size, &*square.title), ([200.0, 160.0], "a; b; c; d"));
    }
}
