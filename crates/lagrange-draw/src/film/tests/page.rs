use serde_json::Value;

use crate::film::Film;
use crate::film::tests::{pendulum, pendulum_at};

const NAUGHTY: &str = "</script>{{script}} & \"T\"";

fn film(html: &str) -> Value {
    let (_, after) = html.split_once("<script id=\"film\" type=\"application/json\">").expect("has data");
    let (json, _) = after.split_once("</script>").expect("ends");
    serde_json::from_str(json).expect("is JSON")
}

fn with_curve(values: Vec<f64>) -> Film {
    pendulum(values.len()).with_values(NAUGHTY, values).expect("one for each picture")
}

#[test]
fn moves_each_layer_in_each_picture() {
    let html = pendulum(26).html();
    let data = film(&html);
    assert_eq!(data["times"].as_array().map(Vec::len), Some(26));
    let layers = data["layers"].as_array().expect("has layers");
    assert!(layers.len() > 6);
    for (index, layer) in layers.iter().enumerate() {
        assert!(html.contains(&format!("id=\"layer-{index}\"")));
        let track = layer["track"].as_array().expect("has a track");
        assert!(layer["change"] == "shows" || track.len() == 26);
    }
}

#[test]
fn draws_bent_lines_by_as_many_numbers_as_their_pieces_have() {
    let data = film(&pendulum(26).html());
    let layers = data["layers"].as_array().expect("has layers");
    let bent: Vec<&Value> = layers.iter().filter(|layer| layer["change"] == "bends").collect();
    assert_eq!(bent.len(), 1);
    assert_eq!(bent[0]["kinds"], "ML");
    for shape in bent[0]["track"].as_array().expect("has a track") {
        assert_eq!(shape.as_array().map(Vec::len), Some(4));
    }
}

#[test]
fn has_the_first_picture_without_its_script() {
    let html = pendulum(26).html();
    let start = html.find("<svg").expect("has a picture");
    let end = start + html[start..].find("</svg>").expect("ends") + "</svg>".len();
    let picture = roxmltree::Document::parse(&html[start..end]).expect("is well formed");
    let shown = |node: &roxmltree::Node<'_, '_>| {
        !node.ancestors().any(|above| above.attribute("visibility") == Some("hidden"))
    };
    let marks = picture.descendants().filter(|node| ["path", "text"].contains(&node.tag_name().name()));
    let drawn = pendulum(26).recording[0].marks.iter().filter(|mark| !crate::svg::is_empty(mark)).count();
    assert_eq!(marks.filter(shown).count(), drawn);
}

#[test]
fn needs_nothing_from_elsewhere() {
    let html = with_curve(vec![1.0, 2.0]).html();
    let addresses = html.match_indices("://").count();
    let names = html.matches("http://www.w3.org/2000/svg").count();
    assert_eq!(addresses, names);
    for reference in ["src=", "href=", "@import", "url(", "fetch("] {
        assert!(!html.contains(reference), "{reference}");
    }
}

#[test]
fn takes_no_name_for_a_part_of_itself() {
    let html = with_curve(vec![1.0, 2.0]).html();
    assert_eq!(html.matches("</script>").count(), 2);
    assert_eq!(film(&html)["curves"][0]["name"], NAUGHTY);
    assert!(html.contains("&lt;/script&gt;{{script}}"));
}

#[test]
fn leaves_gaps_where_values_are_not_finite() {
    let html = with_curve(vec![1.0, 2.0, f64::NAN, 3.0, f64::INFINITY]).html();
    let values = &film(&html)["curves"][0]["values"];
    assert_eq!(values.to_string(), "[1.0,2.0,null,3.0,null]");
    let (_, curve) = html.split_once("class=\"curve curve-0\" d=\"").expect("has a curve");
    let data: String = curve.chars().take_while(|letter| *letter != '"').collect();
    assert_eq!(data.matches('M').count(), 2, "{data}");
    assert_eq!(data.matches('L').count(), 1, "{data}");
}

#[test]
fn shows_rounding_errors_of_an_energy_as_level() {
    let html = with_curve(vec![5.0, 5.0 + 4e-15, 5.0 - 4e-15]).html();
    let chart = &film(&html)["chart"];
    let height = |name: &str| chart[name].as_f64().expect("a number");
    assert!((height("low") - 4.5).abs() < 1e-9 && (height("high") - 5.5).abs() < 1e-9, "{chart}");
}

#[test]
fn labels_of_tiny_values_have_a_power_of_ten_beside_the_axis() {
    let html = with_curve(vec![0.0, 1e-9, 3e-9]).html();
    assert!(html.contains(">×10⁻⁹</text>") && html.contains(">2</text>"), "{html}");
    assert!(!with_curve(vec![0.0, 1.0, 3.0]).html().contains("×10"));
}

#[test]
fn time_runs_to_the_right_in_films_that_ran_backwards() {
    let film = pendulum_at(&[2.0, 1.0, 0.0]).with_values("energy", vec![5.0, 6.0, 7.0]).expect("fits");
    let html = film.html();
    let x = |label: &str| -> f64 {
        let (before, _) =
            html.split_once(&format!("text-anchor=\"middle\">{label}</text>")).expect("is a label");
        let (_, place) = before.rsplit_once("<text x=\"").expect("has a place");
        place.split('"').next().and_then(|number| number.parse().ok()).expect("is a number")
    };
    assert!(x("2.0") < x("1.0") && x("1.0") < x("0"), "{html}");
}

#[test]
fn has_no_plot_without_curves() {
    let html = pendulum_at(&[0.0, 0.1]).html();
    assert!(film(&html)["chart"].is_null());
    assert!(!html.contains("class=\"chart\""));
}

#[test]
fn names_what_it_shows() {
    let html = pendulum(2).html();
    assert!(html.contains("<title>A pendulum &amp; its &lt;path&gt;</title>"));
    assert!(html.contains("aria-label=\"Time\"") && html.contains(&"prefers-reduced-motion".to_string()));
}

#[test]
fn has_a_look_for_every_curve() {
    let mut film = pendulum(2);
    for number in 0..9 {
        film = film.with_values(&format!("curve {number}"), vec![0.0, f64::from(number)]).expect("fits");
    }
    let html = film.html();
    let looks: Vec<&str> =
        html.split("class=\"curve ").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    assert_eq!(looks.len(), 9);
    assert!(looks.iter().all(|look| html.contains(&format!(".{look} {{ stroke: "))), "{looks:?}");
}
