//! Pages of films in space: their content, and its robustness to arbitrary names.

use std::sync::OnceLock;

use serde_json::Value;

use super::Crane;
use super::walker::{LEGS, Walker, leg};
use crate::DrawError;
use crate::colour::PAPER;
use crate::geometry::{length, subtract};
use crate::picture::Colour;
use crate::space::vector::Vector;
use crate::{Drawing, Film};
use lagrange_plot::colours::LINES;
use lagrange_runtime::scene::Spatial;

pub(super) const NAUGHTY: &str = "</script><!--{{script}} & \"T\"";

pub(super) fn crane(moments: usize) -> Film<Spatial> {
    let drawing =
        Drawing::of(&Crane).title("A crane's load").perspective().forces().velocities().axes().floor(-0.5);
    let drawing = drawing.trace("tip", |_, _, [angle, _]| [2.0 * angle.cos(), 2.0 * angle.sin(), 0.0]);
    let states = (0..moments).map(|k| (0.05 * k as f64, [0.05 * k as f64, 1.0]));
    let film = drawing.film_of(states).expect("draws");
    let height = film.times().iter().map(|time| time.sin()).collect::<Vec<_>>();
    film.with_values("energy", height).expect("one for each moment")
}

/// Returns a film of ten seconds at sixty pictures per second.
pub(super) fn walker() -> &'static Film<Spatial> {
    static FILM: OnceLock<Film<Spatial>> = OnceLock::new();
    FILM.get_or_init(walk)
}

fn walker_page() -> &'static str {
    static PAGE: OnceLock<String> = OnceLock::new();
    PAGE.get_or_init(|| walker().html())
}

fn walk() -> Film<Spatial> {
    let mut drawing =
        Drawing::of(&Walker).title("A walking machine").view(-1.0, 0.35).perspective().nameless().floor(0.0);
    for (index, (name, ..)) in LEGS.iter().enumerate() {
        drawing = drawing.trace(&format!("foot_{name}"), move |_, _, [x, _]| leg(index, *x).0[2]);
    }
    let states = (0..=600).map(|k| (f64::from(k) / 60.0, [f64::from(k) / 600.0 * 2.0, 0.2]));
    let film = drawing.film_of(states).expect("draws");
    let energy = film.times().iter().map(|time| 5.0 + 0.2 * (9.0 * time).sin()).collect::<Vec<_>>();
    film.with_values("energy", energy).expect("one for each moment")
}

fn film(html: &str) -> Value {
    let (_, after) = html.split_once("<script id=\"film\" type=\"application/json\">").expect("has data");
    let (json, _) = after.split_once("</script>").expect("ends");
    serde_json::from_str(json).expect("is JSON")
}

fn numbers(value: &Value) -> Vec<f64> {
    let list = value.as_array().expect("is a list");
    list.iter().map(|number| number.as_f64().expect("is a number")).collect()
}

/// Returns the values at a moment from a list for one moment or for all.
fn at(list: &[f64], width: usize, moment: usize) -> &[f64] {
    let start = if list.len() == width { 0 } else { width * moment };
    &list[start..start + width]
}

#[test]
fn places_are_where_things_are() {
    let film_in_space = crane(40);
    let recording = &film_in_space.recording.recording;
    let data = film(&film_in_space.html());
    let space = &data["space"];
    let times = numbers(&data["times"]);
    assert_eq!(times.len(), film_in_space.times().len());
    assert!(times.iter().zip(film_in_space.times()).all(|(a, b)| (a - b).abs() < 1e-14));
    let things = space["things"].as_array().expect("has things");
    assert_eq!(things.len(), recording.things.len());
    let unit = space["unit"].as_f64().expect("has a unit");
    let places: Vec<Vector> = recording.places().collect::<Vec<_>>();
    let ends = |axis: usize| {
        let along = places.iter().map(|place| place[axis]);
        along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)])
    };
    let middle = [0, 1, 2].map(ends).map(|[low, high]| 0.5 * (low + high));
    let radius = places.iter().map(|place| length(subtract(*place, middle))).fold(0.0, f64::max);
    for (written, thing) in things.iter().zip(&recording.things) {
        let [origins, turns, stretches, scales] =
            ["at", "turn", "stretch", "scale"].map(|name| numbers(&written[name]));
        let mesh = &space["meshes"][written["mesh"].as_u64().expect("has a mesh") as usize];
        let corners = numbers(&mesh["corners"]);
        let mesh_unit = mesh["unit"].as_f64().expect("has a unit");
        for moment in [0, 13, 39] {
            let [x, y, z, w] = [0, 1, 2, 3].map(|k| 1e-4 * at(&turns, 4, moment)[k]);
            let origin = at(&origins, 3, moment);
            let (stretch, scale) = (unit * at(&stretches, 1, moment)[0], 1e-4 * at(&scales, 1, moment)[0]);
            for (corner, wanted) in corners.chunks(4).zip(&thing.mesh.corners) {
                let own = [0, 1, 2].map(|k| scale * mesh_unit * corner[k]);
                let own = [own[0], own[1], own[2] + stretch * 1e-4 * corner[3]];
                let turned = [
                    (1.0 - 2.0 * (y * y + z * z)) * own[0]
                        + 2.0 * (x * y - w * z) * own[1]
                        + 2.0 * (x * z + w * y) * own[2],
                    2.0 * (x * y + w * z) * own[0]
                        + (1.0 - 2.0 * (x * x + z * z)) * own[1]
                        + 2.0 * (y * z - w * x) * own[2],
                    2.0 * (x * z - w * y) * own[0]
                        + 2.0 * (y * z + w * x) * own[1]
                        + (1.0 - 2.0 * (x * x + y * y)) * own[2],
                ];
                let place = [0, 1, 2].map(|k| radius * (unit * origin[k] + turned[k]) + middle[k]);
                let off = length(subtract(place, thing.track[moment].of(wanted)));
                assert!(off < 3e-4 * radius, "{} is off by {off} at {moment}", thing.name);
            }
        }
    }
}

#[test]
fn constants_are_written_once_and_equal_meshes_are_shared() {
    let data = film(walker_page());
    let space = &data["space"];
    let (meshes, things) = (space["meshes"].as_array(), space["things"].as_array());
    // Floor, trunk, hip, thigh, shank, joint.
    assert_eq!((meshes.map(Vec::len), things.map(Vec::len)), (Some(6), Some(1 + 13 + 12)));
    let [floor, trunk] = [0, 1].map(|index| &space["things"][index]);
    let counts = |thing: &Value| ["at", "turn", "stretch", "scale"].map(|name| numbers(&thing[name]).len());
    assert_eq!(counts(floor), [3, 4, 1, 1]);
    assert_eq!(counts(trunk), [3 * 601, 4, 1, 1]);
    for trace in space["traces"].as_array().expect("has traces") {
        assert_eq!(numbers(&trace["points"]).len(), 3 * 601);
    }
}

#[test]
fn surfaces_are_made_of_what_there_is() {
    let data = film(&crane(3).html());
    for mesh in data["space"]["meshes"].as_array().expect("has meshes") {
        let [corners, points, triangles, flat, sharp, smooth, lines] =
            ["corners", "points", "triangles", "flat", "sharp", "smooth", "lines"]
                .map(|name| numbers(&mesh[name]));
        let below = |numbers: &[f64], count: usize| numbers.iter().all(|index| *index < count as f64);
        let (corners, faces) = (corners.len() / 4, flat.len() / 3);
        assert!(points.chunks(4).all(|point| point[0] < corners as f64));
        assert!(below(&triangles, points.len() / 4) && below(&sharp, corners) && below(&lines, corners));
        assert!(smooth.chunks(4).all(|edge| below(&edge[..2], corners) && below(&edge[2..], faces)));
        assert_eq!((triangles.len() % 3, sharp.len() % 2, lines.len() % 2), (0, 0, 0));
    }
}

#[test]
fn a_long_film_of_a_machine_with_four_legs_is_below_two_megabytes() {
    let html = walker_page();
    assert!(html.len() < 2_000_000, "{} bytes", html.len());
}

#[test]
fn every_label_has_an_element_and_no_name_breaks_the_page() {
    let drawing = Drawing::of(&Crane).title(NAUGHTY).velocities().trace(NAUGHTY, |_, _, _| [1.0, 0.0, 0.0]);
    let states = (0..3).map(|k| (f64::from(k), [f64::from(k), 1.0]));
    let html = drawing.film_of(states).expect("is a film").html();
    assert_eq!(html.matches("</script>").count(), 2);
    assert!(!html.contains("<!--") && html.contains("&lt;/script&gt;&lt;!--{{script}}"));
    let space = &film(&html)["space"];
    let of_things = space["things"]
        .as_array()
        .into_iter()
        .flatten()
        .filter_map(|thing| thing["label"]["number"].as_u64());
    let of_traces =
        space["traces"].as_array().into_iter().flatten().filter_map(|trace| trace["label"].as_u64());
    let labels: Vec<u64> = of_things.chain(of_traces).collect::<Vec<_>>();
    assert_eq!(labels, (0..labels.len() as u64).collect::<Vec<_>>());
    assert!(labels.len() > 2);
    assert_eq!(html.matches("<span id=\"label-").count(), labels.len());
}

#[test]
fn needs_nothing_from_elsewhere_and_has_all_it_uses() {
    let html = crane(3).html();
    assert_eq!(html.matches("://").count(), html.matches("http://www.w3.org/2000/svg").count());
    for reference in ["src=", "href=", "@import", "url(", "fetch("] {
        assert!(!html.contains(reference), "{reference}");
    }
    let used = html.split("element(\"").skip(1).filter_map(|rest| rest.split('"').next());
    for id in used.chain(["space", "canvas", "reset", "flat", "no-space"]) {
        assert!(html.contains(&format!("id=\"{id}\"")), "there is no `{id}`");
    }
    assert!(html.contains("class=\"chart\"") && html.contains("<noscript>"));
}

#[test]
fn files_are_written_where_they_are_wanted() {
    let folder = std::env::temp_dir().join(format!("lagrange-films-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    for (extension, start) in [("html", "<!DOCTYPE html>"), ("glb", "glTF"), ("gif", "GIF89a")] {
        let path = folder.join(format!("crane.{extension}"));
        crane(3).save(&path).expect("is written");
        let bytes = std::fs::read(&path).expect("is there");
        assert!(bytes.starts_with(start.as_bytes()), "{extension}");
    }
    let refused = crane(3).save(folder.join("crane.png"));
    assert!(matches!(refused, Err(DrawError::Extension { .. })), "{refused:?}");
    std::fs::remove_dir_all(&folder).expect("is removed");
}

/// Writes pages for `tools/space_check.py` and for inspection, if a folder is specified for them.
#[test]
fn samples_are_saved_in_the_given_folder() {
    let Ok(folder) = std::env::var("LAGRANGE_PICTURES") else { return };
    for (name, film) in [("crane", &crane(121)), ("walker", walker())] {
        for extension in ["html", "glb"] {
            film.save(format!("{folder}/{name}.{extension}")).expect("is written");
        }
    }
}

/// Returns a colour from its pair on paper and on a dark ground.
fn colour(pair: &Value) -> Colour {
    let [light, dark] = [0, 1].map(|side| {
        let digits = pair[side].as_str().and_then(|css| css.strip_prefix('#')).expect("is a colour");
        u32::from_str_radix(digits, 16).expect("has six digits")
    });
    Colour::new(light, dark)
}

#[test]
fn edges_contrast_with_both_grounds_and_names_are_legible() {
    let html = crane(2).html();
    let data = film(&html);
    let space = &data["space"];
    let ground = colour(&space["ground"]);
    assert!(ground == PAPER && ground.pair() == ["#ffffff", "#17191c"]);
    let things = space["things"].as_array().expect("has things");
    for edge in things.iter().map(|thing| colour(&thing["edge"])) {
        assert!(edge.contrast(ground) >= LINES, "{edge:?}");
    }
    let names: Vec<&str> = html.split("color:light-dark(").skip(1).collect();
    assert!(names.len() >= 4, "{} names", names.len());
    for name in names {
        let pair = Value::from(name[..15].split(',').collect::<Vec<_>>());
        assert!(colour(&pair).contrast(ground) >= 4.5, "{pair}");
    }
}
