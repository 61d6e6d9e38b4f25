//! Elements of pictures, read from their SVG.

use lagrange::body::Motion;
use lagrange::draw::{Drawing, Picture};
use lagrange::scene::{Item, Outline};
use roxmltree::{Document, Node};

use crate::scenes::{COLLECTION, CORNER, CROWDED, LADDER, Puppet, SLOPE, ladder, part, still};

pub(crate) fn paths(svg: &str) -> Vec<String> {
    let document = Document::parse(svg).expect("is well formed");
    let paths = document.descendants().filter(|node| node.has_tag_name("path"));
    paths.map(|node| node.attribute("d").expect("has lines").to_string()).collect()
}

pub(crate) fn texts(svg: &str) -> Vec<String> {
    let document = Document::parse(svg).expect("is well formed");
    let all = |node: Node<'_, '_>| {
        node.descendants().filter_map(|inner| inner.is_text().then(|| inner.text())?).collect()
    };
    document.descendants().filter(|node| node.has_tag_name("text")).map(all).collect()
}

/// Returns all coordinates of a path.
pub(crate) fn numbers(d: &str) -> Vec<f64> {
    let words = d.split(|c: char| c.is_ascii_alphabetic() || c == ' ').filter(|word| !word.is_empty());
    words.map(|word| word.parse().unwrap_or(f64::NAN)).collect()
}

/// Returns the distance from the first point of a path to its farthest.
pub(crate) fn farthest(d: &str) -> f64 {
    let numbers = numbers(d);
    let away = numbers.chunks(2).map(|p| (p[0] - numbers[0]).hypot(p[1] - numbers[1]));
    away.fold(0.0, f64::max)
}

fn all() -> Vec<Picture> {
    let draw = |drawing: Drawing<'_, Puppet>, s: f64| drawing.picture(0.0, &[s, -1.0]).expect("draws");
    let helped = |system| Drawing::of(system).velocities().accelerations().forces().centers().frames();
    vec![
        draw(ladder(), 0.8),
        draw(helped(&LADDER), 1.2),
        draw(helped(&SLOPE), 0.3),
        draw(helped(&CORNER), 0.7),
        draw(helped(&COLLECTION), 0.4),
    ]
}

#[test]
fn all_numbers_are_finite_and_within_the_picture() {
    for picture in all() {
        let svg = picture.svg();
        for d in paths(&svg) {
            for point in numbers(&d).chunks(2) {
                let [x, y] = point else { panic!("{d}") };
                assert!((0.0..=640.0).contains(x) && (0.0..=400.0).contains(y), "{d}");
            }
        }
    }
}

#[test]
fn what_is_too_small_for_the_numbers_of_its_place_is_within_the_picture() {
    let plate = Puppet(|s, visit| {
        let parts = [part(Outline::Rectangle(1e-9, 1e-9))];
        visit(Item::Body { name: "plate", motion: still([s, -s], 0.3), parts: &parts });
    });
    for place in [1e9, 1e300, -1e300] {
        let svg = Drawing::of(&plate).picture(0.0, &[place, 0.0]).expect("draws").svg();
        let drawn = paths(&svg);
        assert!(!drawn.is_empty());
        for point in drawn.iter().flat_map(|d| numbers(d)).collect::<Vec<_>>().chunks(2) {
            assert!((point[0] - 320.0).abs() < 10.0 && (point[1] - 200.0).abs() < 10.0, "{svg}");
        }
    }
}

#[test]
fn nothing_that_is_written_is_cut_off_in_small_pictures() {
    const NAMES: Puppet = Puppet(|s, visit| {
        for (k, name) in
            ["averylongnameofabodythatgoeson", "the_second_half_of_the_ladder", "b"].iter().enumerate()
        {
            let parts = [part(Outline::Disk(0.5))];
            visit(Item::Body { name, motion: still([1.5 * k as f64, s], 0.3), parts: &parts });
        }
    });
    for [width, height] in [[640.0, 400.0], [320.0, 320.0], [120.0, 90.0]] {
        let drawing = Drawing::of(&NAMES).size(width, height).velocities();
        let svg =
            drawing.title("Two bodies with long names and one with a short name").picture(0.0, &[0.0, 0.0]);
        let svg = svg.expect("draws").svg();
        let document = Document::parse(&svg).expect("is well formed");
        let written: Vec<_> = document.descendants().filter(|node| node.has_tag_name("text")).collect();
        let is_large = width > 320.0;
        assert!(written.len() > if is_large { 3 } else { 1 }, "{svg}");
        for (node, text) in written.iter().zip(texts(&svg)) {
            let number =
                |name| node.attribute(name).and_then(|value| value.parse::<f64>().ok()).expect("is there");
            // Letters are at least a third as wide as high, and the widest lines about half.
            let half = 0.5 * 0.33 * number("font-size") * text.chars().count() as f64;
            assert!(number("x") - half >= 0.0 && number("x") + half <= width, "{text}");
            assert!(number("y") >= 0.7 * number("font-size") && number("y") <= height, "{text}");
        }
    }
}

#[test]
fn documents_tell_what_they_show() {
    let svg = ladder().picture(0.0, &[0.8, -1.0]).expect("draws").svg();
    let document = Document::parse(&svg).expect("is well formed");
    let root = document.root_element();
    assert_eq!(root.attribute("viewBox"), Some("0 0 640 400"));
    let text = |tag| root.children().find(|node| node.has_tag_name(tag)).and_then(|node| node.text());
    assert_eq!(text("title"), Some("The instantaneous centre M of the right half"));
    let description = text("desc").expect("has a description");
    for label in ["M", "B", "C", "φ", "vleft"] {
        assert!(description.contains(label), "{description}");
    }
}

#[test]
fn every_item_has_its_marks() {
    let count =
        |drawing: Drawing<'_, Puppet>| paths(&drawing.picture(0.0, &[0.9, -1.0]).expect("draws").svg()).len();
    // Two rods of two paths each, the floor and its hatching, three paths for the foot on the
    // ground, a pin and a sliding foot.
    assert_eq!(count(Drawing::of(&LADDER)), 2 * 2 + 2 + 3 + 1 + 1);
    assert_eq!(count(Drawing::of(&LADDER).velocities()), 11 + 2);
    assert_eq!(count(Drawing::of(&LADDER).velocities().accelerations()), 11 + 4);
    assert_eq!(count(Drawing::of(&LADDER).frames()), 11 + 4);
    assert_eq!(count(Drawing::of(&LADDER).centers()), 11 + 4, "two rays and two points");
}

#[test]
fn arrows_shorter_than_their_heads_have_no_labels() {
    const RACE: Puppet = Puppet(|slow, visit| {
        for (name, x, velocity) in [("a", 0.0, 1.0), ("b", 2.0, slow)] {
            let motion = Motion { velocity: [0.0, velocity], ..still([x, 0.0], 0.0) };
            visit(Item::Body { name, motion, parts: &[part(Outline::Disk(0.5))] });
        }
    });
    let shown = |slow| {
        let picture = Drawing::of(&RACE).velocities().picture(0.0, &[slow, 0.0]).expect("draws");
        texts(&picture.svg()).into_iter().filter(|text| text.starts_with('v')).collect::<Vec<_>>()
    };
    assert_eq!(shown(1.0), ["va", "vb"]);
    assert_eq!(shown(0.05), ["va"], "an arrow of some pixels");
    assert_eq!(shown(0.0), ["va"]);
}

#[test]
fn labels_are_those_of_formulas() {
    let picture = Drawing::of(&LADDER).velocities().picture(0.0, &[0.9, -1.0]).expect("draws");
    let mut texts = texts(&picture.svg());
    texts.sort();
    assert_eq!(texts, ["left", "right", "vleft", "vright"]);
}

#[test]
fn bodies_keep_their_names_where_something_sits_on_their_centres() {
    for size in [[640.0, 400.0], [320.0, 200.0]] {
        for angle in [0.0, 0.3, 1.2] {
            let drawing = Drawing::of(&CROWDED).size(size[0], size[1]);
            let svg = drawing.picture(0.0, &[angle, 0.0]).expect("draws").svg();
            let mut names = texts(&svg);
            names.sort();
            assert_eq!(names, ["leftrod", "plate", "tube"], "at {angle}");
        }
    }
}

#[test]
fn hidden_items_leave_no_mark() {
    let count =
        |drawing: Drawing<'_, Puppet>| paths(&drawing.picture(0.0, &[0.9, -1.0]).expect("draws").svg()).len();
    assert_eq!(count(Drawing::of(&LADDER).hide("floor").hide("left")), 11 - 2 - 2);
    assert_eq!(count(Drawing::of(&LADDER).hide("foot").hide("hinge")), 11 - 3 - 1);
}

#[test]
fn a_free_body_has_nothing_around_it() {
    let picture = Drawing::of(&SLOPE).free_body("cylinder").picture(0.0, &[0.0, 1.0]).expect("draws");
    let mut labels = texts(&picture.svg());
    labels.sort();
    assert_eq!(labels, ["G", "H", "M", "N"]);
    let arcs = |svg: &str| paths(svg).iter().filter(|d| d.contains('C')).count();
    assert_eq!(arcs(&picture.svg()), 3, "the rim, the area, the moment");
}

#[test]
fn the_normal_force_on_a_free_body_ends_at_its_contact() {
    // The only body is a disk on a floor; its rim and the tip of the upward force coincide.
    const DISK: Puppet = Puppet(|_, visit| {
        visit(Item::Body {
            name: "disk",
            motion: Motion { acceleration: [0.0, 5.0], ..still([0.0, 1.0], 0.0) },
            parts: &[part(Outline::Disk(1.0))],
        });
        let (cause, body) = (lagrange::scene::LoadOrigin::Joint, Some("disk"));
        visit(Item::Force { name: "N", cause, body, at: [0.0, 0.0], force: [0.0, 5.0] });
    });
    let lowest = |d: &String| numbers(d).chunks(2).map(|point| point[1]).fold(0.0, f64::max);
    let svg = Drawing::of(&DISK).free_body("disk").picture(0.0, &[0.0, 0.0]).expect("draws").svg();
    let drawn = paths(&svg);
    let (rim, arrow) = (&drawn[0], drawn.last().expect("has an arrow"));
    let highest = numbers(arrow).chunks(2).map(|point| point[1]).fold(400.0, f64::min);
    assert!((lowest(rim) - highest).abs() < 0.011 && lowest(arrow) > highest + 50.0);
}

#[test]
fn pictures_of_a_film_have_the_same_marks() {
    let states = (0..30).map(|k| (0.1 * f64::from(k), [1.4 - 0.04 * f64::from(k), -1.0]));
    let pictures = ladder().pictures(states).expect("draws");
    assert_eq!(pictures.len(), 30);
    // Only the trace has no line at first.
    let counts: Vec<usize> = pictures.iter().map(|picture| paths(&picture.svg()).len()).collect();
    assert!(counts.iter().all(|count| *count == counts[0]), "{counts:?}");
    let floor = |picture: &Picture| paths(&picture.svg())[1].clone();
    assert!(
        pictures.iter().all(|picture| floor(picture) == floor(&pictures[0])),
        "what is at rest stays in place"
    );
}

#[test]
fn a_trace_shows_the_past_only() {
    let states: Vec<(f64, [f64; 2])> =
        (0..=10).map(|k| (f64::from(k), [1.2 - 0.1 * f64::from(k), -1.0])).collect();
    let drawing = Drawing::of(&LADDER).trace("C", |_, _, y| [2.0 * y[0].cos(), 0.0]);
    let pictures = drawing.pictures(states.clone()).expect("draws");
    let still = drawing.past(states[..10].to_vec()).picture(10.0, &states[10].1).expect("draws");
    assert_eq!(pictures[10].svg(), still.svg());
    let longest = |picture: &Picture| paths(&picture.svg()).iter().map(|d| d.matches('L').count()).max();
    assert!(
        longest(&pictures[10]) > longest(&pictures[1])
            || paths(&pictures[10].svg()) != paths(&pictures[1].svg())
    );
}

#[test]
fn an_instantaneous_centre_is_on_both_normals() {
    // The right half turns about the ends of the rays: (2 L cos φ, 2 L sin φ).
    let phi = 0.9_f64;
    let drawing = Drawing::of(&LADDER).nameless().centers();
    let picture = drawing.clone().annotate(move |sketch, _| {
        sketch.point([2.0 * phi.cos(), 2.0 * phi.sin()], "");
    });
    let svg = picture.picture(0.0, &[phi, -1.0]).expect("draws").svg();
    let drawn = paths(&svg);
    let expected = drawn.last().expect("is there");
    assert_eq!(
        drawn.iter().filter(|d| *d == expected).count(),
        2,
        "the centre and the point lie on each other"
    );
}
