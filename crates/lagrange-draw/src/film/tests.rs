//! Films of a hand-drawn pendulum with every kind of mark: they stay, turn, move, grow, bend,
//! appear and vanish.

mod errors;
mod gif;
mod layers;
mod page;
mod svg;

use crate::film::Film;
use crate::film::trajectory::last_at_each;
use crate::picture::{Colour, Mark, Picture, Point, Segment, Style};
use lagrange_plot::label::Anchor;

#[test]
fn the_last_of_simultaneous_samples_is_shown() {
    assert_eq!(last_at_each(&[0.0, 1.0, 1.0, 2.0]), [0, 2, 3]);
    assert_eq!(last_at_each::<f64>(&[]), [0; 0]);
}

const HINGE: Point = [160.0, 40.0];
const LENGTH: f64 = 120.0;
const INK: Colour = Colour::new(0x22_22_22, 0xdd_dd_dd);
const BLUE: Colour = Colour::new(0x00_72_b2, 0x56_b4_e9);
/// Range of pictures that show the force.
const PUSHED: std::ops::Range<usize> = 5..9;

/// Creates a film of this many pictures, 25 per second.
fn pendulum(pictures: usize) -> Film {
    let times: Vec<f64> = (0..pictures).map(|index| index as f64 / 25.0).collect();
    pendulum_at(&times)
}

fn pendulum_at(times: &[f64]) -> Film {
    let pictures = (0..times.len()).map(|index| picture(index, times)).collect();
    Film::new(pictures, times.to_vec()).expect("is a film")
}

fn angle(time: f64) -> f64 {
    0.9 * (2.0 * time).cos()
}

/// Returns a point at a distance along the rod and a distance from it.
fn on_rod(time: f64, along: f64, beside: f64) -> Point {
    let (sin, cos) = angle(time).sin_cos();
    [HINGE[0] + along * sin + beside * cos, HINGE[1] + along * cos - beside * sin]
}

fn picture(index: usize, times: &[f64]) -> Picture {
    let time = times[index];
    let rod = [(0.0, -4.0), (LENGTH, -4.0), (LENGTH, 4.0), (0.0, 4.0)];
    let path = times[..=index].iter().map(|time| on_rod(*time, LENGTH, 0.0)).collect::<Vec<_>>();
    let force = if PUSHED.contains(&index) { line(&[[20.0, 160.0], [60.0, 160.0]]) } else { Vec::new() };
    let tip = on_rod(time, LENGTH, 0.0);
    let speed = -1.8 * (2.0 * time).sin();
    let marks = vec![
        stroke(line(&[[100.0, 40.0], [220.0, 40.0]])),
        stroke(line(&path)),
        area(closed(&rod.map(|(along, beside)| on_rod(time, along, beside)))),
        area(disk(tip, 14.0)),
        stroke(line(&[tip, on_rod(time, LENGTH, 40.0 * speed)])),
        stroke(force),
        text(on_rod(time, 0.5 * LENGTH, 12.0), "l_1"),
        text([10.0, 20.0], &format!("t = {time:.1} s")),
    ];
    Picture { size: [320.0, 200.0], title: "A pendulum & its <path>".into(), marks }
}

fn line(points: &[Point]) -> Vec<Segment> {
    let start = Segment::Move(points[0]);
    [start].into_iter().chain(points[1..].iter().map(|point| Segment::Line(*point))).collect()
}

fn closed(points: &[Point]) -> Vec<Segment> {
    let mut segments = line(points);
    segments.push(Segment::Close);
    segments
}

fn disk([x, y]: Point, radius: f64) -> Vec<Segment> {
    // Quarter circles: Goldapp, Approximation of circular arcs by cubic polynomials (1991).
    let bow = 0.5519150244935106 * radius;
    let quarter = |[a, b]: [f64; 2]| {
        let at = |along: f64, across: f64| [x + along * a - across * b, y + along * b + across * a];
        Segment::Curve(at(radius, bow), at(bow, radius), at(0.0, radius))
    };
    let quarters = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]].map(quarter);
    [Segment::Move([x + radius, y])].into_iter().chain(quarters).chain([Segment::Close]).collect()
}

fn stroke(segments: Vec<Segment>) -> Mark {
    Mark::Path { segments, style: Style { stroke: Some(INK), width: 2.0, dashes: &[], fill: None } }
}

fn area(segments: Vec<Segment>) -> Mark {
    Mark::Path { segments, style: Style { stroke: Some(INK), width: 1.5, dashes: &[], fill: Some(BLUE) } }
}

fn text(at: Point, text: &str) -> Mark {
    Mark::Text { at, text: String::from(text), size: 14.0, anchor: Anchor::Start, colour: INK }
}
