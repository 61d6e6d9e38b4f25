use roxmltree::{Document, Node};

use crate::film::tests::{PUSHED, pendulum, pendulum_at};

fn animations<'a>(document: &'a Document<'a>) -> impl Iterator<Item = Node<'a, 'a>> {
    document.descendants().filter(|node| node.tag_name().name().starts_with("animate"))
}

fn numbers(list: &str) -> Vec<f64> {
    list.split(';').map(|number| number.parse().expect("a number")).collect()
}

#[test]
fn has_a_time_for_each_value() {
    // The last interval is shorter, as after an event that ends the motion.
    let times: Vec<f64> = (0..24).map(|index| f64::from(index) / 25.0).chain([0.9301]).collect();
    let text = pendulum_at(&times).svg();
    let document = Document::parse(&text).expect("is well formed");
    assert!(animations(&document).count() > 5);
    for animation in animations(&document) {
        let values = animation.attribute("values").expect("has values").split(';').count();
        let keys = numbers(animation.attribute("keyTimes").expect("has times"));
        assert_eq!(keys.len(), values);
        assert!(keys[0] == 0.0 && keys.windows(2).all(|pair| pair[0] < pair[1]));
        let is_discrete = animation.attribute("calcMode") == Some("discrete");
        assert!(is_discrete || keys[keys.len() - 1] == 1.0, "{keys:?}");
        assert_eq!(animation.attribute("dur"), Some(".9301s"));
        assert_eq!(animation.attribute("repeatCount"), Some("indefinite"));
        for (key, time) in keys.iter().zip(&times).filter(|_| values == times.len()) {
            assert!((key * 0.9301 - time).abs() < 1e-4, "{key} for {time}");
        }
    }
}

#[test]
fn leaves_out_times_that_follow_from_the_number_of_values() {
    let text = pendulum(26).svg();
    let document = Document::parse(&text).expect("is well formed");
    let is_smooth = |animation: &Node<'_, '_>| animation.attribute("calcMode").is_none();
    let smooth: Vec<Node<'_, '_>> = animations(&document).filter(is_smooth).collect();
    for animation in &smooth {
        let values = animation.attribute("values").expect("has values").split(';').count();
        assert_eq!((values, animation.attribute("keyTimes")), (26, None));
    }
    // The path; two for each of rod, disk and label, apart from constant angles; the velocity.
    assert_eq!(smooth.len(), 1 + 2 + 1 + 1 + 1);
}

#[test]
fn shows_marks_only_while_they_are_there() {
    let text = pendulum(26).svg();
    let document = Document::parse(&text).expect("is well formed");
    let force = document.descendants().find(|node| node.attribute("d") == Some("M20 160L60 160"));
    let group = force.and_then(|force| force.parent_element()).expect("is in a group");
    assert_eq!(group.attribute("visibility"), Some("hidden"));
    let animation = group.first_element_child().expect("is animated");
    assert_eq!(animation.attribute("values"), Some("hidden;visible;hidden"));
    let keys = numbers(animation.attribute("keyTimes").expect("has times"));
    let wanted = [0.0, PUSHED.start as f64 / 25.0, PUSHED.end as f64 / 25.0];
    assert!(keys.iter().zip(wanted).all(|(key, wanted)| (key - wanted).abs() < 1e-4), "{keys:?}");
}

#[test]
fn is_a_still_picture_if_there_is_one_only() {
    let film = pendulum(1);
    assert_eq!(film.svg(), film.recording[0].svg());
}

#[test]
fn looks_like_its_first_picture_where_nothing_is_animated() {
    let film = pendulum(26);
    let (text, still) = (film.svg(), film.recording[0].svg());
    let (document, still) = (Document::parse(&text), Document::parse(&still));
    let (document, still) = (document.expect("is well formed"), still.expect("is well formed"));
    let title = |document: &Document<'_>| {
        document
            .descendants()
            .find(|node| node.has_tag_name("title"))
            .and_then(|node| node.text().map(ToString::to_string))
    };
    assert_eq!(title(&document), title(&still));
    assert_eq!(document.root_element().attribute("viewBox"), still.root_element().attribute("viewBox"));
    let is_hidden = |node: &Node<'_, '_>| {
        let has = |name, value| node.ancestors().any(|above| above.attribute(name) == Some(value));
        has("visibility", "hidden") || has("display", "none")
    };
    let shown = document.descendants().filter(|node| ["path", "text"].contains(&node.tag_name().name()));
    let styles = |nodes: Vec<Node<'_, '_>>| {
        let style = |node: &Node<'_, '_>| {
            ["fill", "stroke", "stroke-width", "font-size"]
                .map(|name| node.attribute(name).map(ToString::to_string))
        };
        nodes.iter().map(style).collect::<Vec<_>>()
    };
    let wanted = still.descendants().filter(|node| ["path", "text"].contains(&node.tag_name().name()));
    assert_eq!(styles(shown.filter(|node| !is_hidden(node)).collect()), styles(wanted.collect()));
}

#[test]
fn is_its_first_picture_if_the_reader_prefers_reduced_motion() {
    let film = pendulum(26);
    let (text, first) = (film.svg(), film.recording[0].svg());
    let (_, still) = text.split_once("<g class=\"still\" display=\"none\">\n").expect("a still picture");
    let (still, moving) = still.split_once("</g>\n<g class=\"moving\">\n").expect("a moving one");
    assert!(!still.is_empty() && first.ends_with(&format!("{still}</svg>\n")), "{still}");
    assert!(moving.contains("<animate") && !still.contains("<animate"));
    let style = "{.lagrange .still{display:inline}.lagrange .moving{display:none}}";
    assert!(text.contains(&format!("@media (prefers-reduced-motion:reduce){style}")), "{text}");
}

#[test]
fn grows_by_moves_and_not_by_pictures() {
    let (short, long) = (pendulum(26).svg().len(), pendulum(251).svg().len());
    // 225 more pictures cost less than a quarter of the size of their marks.
    let mark = pendulum(26).recording[0].svg().len();
    assert!(long - short < 225 * mark / 4, "{short} {long} {mark}");
}
