//! Arbitrary titles and names in all formats of a drawing.

use serde_json::Value;

use super::Crane;
use crate::heading;
use crate::raster::rasterise;
use crate::svg::tests::{assert_plain, hostile};
use crate::{Drawing, Film};

#[test]
fn any_title_is_written_in_every_format() {
    for title in hostile() {
        let drawing = Drawing::of(&Crane)
            .title(&title)
            .forces()
            .trace(&title, |_, _, [angle, _]| [angle.cos(), 0.0, 0.0]);
        let picture = drawing.picture(0.1, &[0.1, 1.0]).expect("draws");
        assert_plain(&picture.svg());
        rasterise(&picture, 0.5).expect("has pixels");
        let film = Film::new(vec![picture], vec![0.0]).expect("is a film");
        assert_plain(&film.svg());
        assert_plain(first_picture(&film.html()));
        let film = drawing.film_of([(0.0, [0.0, 1.0]), (0.1, [0.1, 1.0])]).expect("draws");
        let film = film.with_values(&title, vec![0.0, 1.0]).expect("one for each moment");
        assert!(!film.html().contains("alert(\"1\")</script>"));
        // A header of 12 bytes, then a chunk header of 8 bytes that starts with the length of the
        // JSON.
        let file = film.glb().expect("is written");
        let length = u32::from_le_bytes(file[12..16].try_into().expect("four bytes")) as usize;
        serde_json::from_slice::<Value>(&file[20..20 + length]).expect("is JSON");
    }
}

fn first_picture(html: &str) -> &str {
    let start = html.find("<svg").expect("has a picture");
    let end = start + html[start..].find("</svg>").expect("ends") + "</svg>".len();
    &html[start..end]
}

/// Unclosed braces keep words together.
#[test]
fn titles_of_many_words_are_set_at_once() {
    let start = std::time::Instant::now();
    for title in ["{ a ".repeat(2_500), "a ".repeat(5_000), "{".repeat(10_000)] {
        heading::lines(&title, [640.0, 400.0]);
    }
    let seconds = start.elapsed().as_secs_f64();
    assert!(seconds < 60.0, "{seconds} s");
}
