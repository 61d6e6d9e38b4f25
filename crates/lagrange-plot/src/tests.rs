//! Content and positions of drawings.

mod cells;
mod documents;

use std::ops::Range;

use crate::axis::{Axis, Scale};
use crate::lettering::{Slope, width};
use crate::pixels::Pixels;
use crate::thin::thin;
use crate::{Curve, Figure, Limit, Panel, PlotError};

fn figure(curves: Vec<Curve>) -> Figure {
    let panel = Panel { x: "time".into(), y: "height".into(), curves, ..Panel::default() };
    Figure { panels: vec![panel], columns: 1, size: (400, 300) }
}

fn curve(name: &str, points: impl Iterator<Item = (f64, f64)>) -> Curve {
    Curve { name: name.into(), points: points.collect() }
}

/// Returns the points of the polylines with the width of curves.
fn polylines(svg: &str) -> Vec<Vec<(f64, f64)>> {
    let curves =
        svg.lines().filter(|line| line.contains("<polyline") && line.contains("stroke-width=\"14\""));
    let points = |line: &str| {
        let list = line.split("points=\"").nth(1).and_then(|rest| rest.split('"').next()).expect("points");
        let pair = |pair: &str| {
            let (x, y) = pair.split_once(',').expect("a pair");
            (x.parse().expect("a number"), y.parse().expect("a number"))
        };
        list.split_whitespace().map(pair).collect()
    };
    curves.map(points).collect()
}

fn labels(range: (f64, f64)) -> (Vec<String>, String) {
    let axis = Axis::new(Scale::Linear, Some(range), 0.0, 5);
    (axis.marks.into_iter().map(|mark| mark.label).collect(), axis.note)
}

#[test]
fn every_sample_of_a_short_curve_is_drawn() {
    let parabola = || (0..50).map(|k| (f64::from(k), f64::from(k * k)));
    let svg = figure(vec![curve("y", parabola())]).svg().expect("draws");
    let lines = polylines(&svg);
    assert_eq!(lines.iter().map(Vec::len).collect::<Vec<_>>(), [50]);
    let line = &lines[0];
    assert!(line.windows(2).all(|pair| pair[0].0 < pair[1].0 && pair[0].1 >= pair[1].1), "upwards");
    // The margins, in tenths of the unit.
    assert_eq!((line[0].0, line[49].0), (740.0, 3820.0));
    for text in ["time", "height", "2000"] {
        assert!(svg.contains(&format!(">{text}<")), "{text}");
    }
    assert!(svg.contains("width=\"400\" height=\"300\" viewBox=\"0 0 4000 3000\""));
    assert!(!svg.contains(">y<"), "a single curve needs no legend");
}

#[test]
fn several_curves_have_a_legend() {
    let curves = ["one", "two", "three"].map(|name| curve(name, (0..3).map(|k| (f64::from(k), 0.0))));
    let svg = figure(curves.to_vec()).svg().expect("draws");
    assert_eq!(polylines(&svg).len(), 3);
    assert!(["one", "two", "three"].iter().all(|name| svg.contains(&format!(">{name}<"))));
}

#[test]
fn many_curves_have_different_colours() {
    let curves: Vec<_> =
        (0..20).map(|k| curve(&k.to_string(), [(0.0, 0.0), (1.0, f64::from(k))].into_iter())).collect();
    let svg = figure(curves).svg().expect("draws");
    let lines = svg.lines().filter(|line| line.contains("stroke-width=\"14\""));
    let mut colors: Vec<_> = lines.filter_map(|line| line.split("stroke=\"").nth(1)?.get(..7)).collect();
    colors.sort_unstable();
    colors.dedup();
    assert_eq!(colors.len(), 20);
}

#[test]
fn a_curve_is_broken_where_it_is_not_finite() {
    let gap = |k: i32| if k == 5 { f64::NAN } else { 1.0 };
    let svg = figure(vec![curve("y", (0..10).map(|k| (f64::from(k), gap(k))))]).svg().expect("draws");
    assert_eq!(polylines(&svg).iter().map(Vec::len).collect::<Vec<_>>(), [5, 4]);
    assert!(!svg.contains("NaN"));
}

/// A curve from −1 to 1 on an axis without limits ends 1/22 of the height below its top.
#[test]
fn limits_are_dashed_lines_unless_they_are_far_away() {
    let drawn = |limit: Limit| {
        let mut figure = figure(vec![curve("a", (0..9).map(|k| (f64::from(k), f64::from(k) / 4.0 - 1.0)))]);
        figure.panels[0].limits = vec![limit];
        let svg = figure.svg().expect("a document");
        let ends = polylines(&svg)[0].iter().map(|point| point.1).fold(f64::MAX, f64::min);
        let dashes =
            |line: &&str| line.contains("stroke=\"#0072b2\"") && line.contains("stroke-width=\"10\"");
        let dashes: Vec<String> = svg.lines().filter(dashes).map(str::to_owned).collect();
        (dashes, ends)
    };
    let (none, without) = drawn(Limit::Ordinate(3.01, 0));
    assert!(none.is_empty());
    let (dashes, with) = drawn(Limit::Ordinate(2.0, 0));
    assert!(dashes.len() > 20, "{}", dashes.len());
    // The plot is 2220 points high, with room of a twentieth of the values at both ends.
    let (top, height) = (280.0, 2220.0);
    let row = |value: f64, [low, high]: [f64; 2]| {
        let room = 0.05 * (high - low);
        top + height * (high + room - value) / (high - low + 2.0 * room)
    };
    assert!((without - row(1.0, [-1.0, 1.0])).abs() <= 0.5 && (with - row(1.0, [-1.0, 2.0])).abs() <= 0.5);
    let down = format!(",{:.0} ", row(2.0, [-1.0, 2.0]));
    assert!(dashes.iter().all(|dash| dash.contains(&down)), "{down}: {}", dashes[0]);
    let across = drawn(Limit::Abscissa(10.0)).0;
    assert!(across.is_empty(), "limits of the abscissa have the colour of the axes");
}

#[test]
fn a_single_point_is_a_dot() {
    let svg = figure(vec![curve("y", [(1.0, 2.0)].into_iter())]).svg().expect("draws");
    let dots: Vec<_> = svg.lines().filter(|line| line.contains("stroke-width=\"60\"")).collect();
    assert_eq!(dots.len(), 1);
    // The middle of the axes.
    assert!(dots[0].contains("points=\"2280,1390 2280,1390\""), "{}", dots[0]);
}

#[test]
fn nothing_finite_leaves_empty_axes() {
    for value in [f64::NAN, f64::INFINITY] {
        let svg = figure(vec![curve("y", (0..10).map(|k| (f64::from(k), value)))]).svg().expect("draws");
        assert_eq!(polylines(&svg), Vec::<Vec<_>>::new());
    }
}

#[test]
fn thinning_keeps_every_extreme() {
    let wave = |k: u32| if k == 123_456 { 9.0 } else { (f64::from(k) * 0.1).sin() };
    let pieces = thin((0..1_000_000).map(|k| (f64::from(k) * 1e-3, wave(k))), 1.0);
    assert_eq!(pieces.len(), 1);
    let kept = &pieces[0];
    assert!(kept.len() <= 4000, "{}", kept.len());
    assert!(kept.contains(&(123.456, 9.0)));
    for column in 0..1000 {
        let inside = kept.iter().filter(|point| point.0.floor() == f64::from(column));
        let lowest = inside.map(|point| point.1).fold(f64::INFINITY, f64::min);
        let exact =
            (1000 * column..1000 * (column + 1)).map(|k| wave(k as u32)).fold(f64::INFINITY, f64::min);
        assert_eq!(lowest, exact);
    }
    assert_eq!((kept[0], kept.last().map(|point| point.0)), ((0.0, 0.0), Some(999.999)));
}

#[test]
fn a_curve_that_runs_along_itself_is_drawn_once() {
    let circle = |turns: u32| {
        let angle = |k: u32| f64::from(k) * std::f64::consts::TAU / 1000.0;
        thin((0..1000 * turns).map(|k| (1000.0 * angle(k).cos(), 1000.0 * angle(k).sin())), 5.0)
    };
    let count = |pieces: Vec<Vec<_>>| pieces.iter().map(Vec::len).sum::<usize>();
    assert!(count(circle(100)) < 2 * count(circle(1)));
}

#[test]
fn labels_are_short_and_differ() {
    assert_eq!(
        labels((0.0, 10.0)),
        (["0", "2", "4", "6", "8", "10"].map(String::from).to_vec(), String::new())
    );
    let (small, note) = labels((-1e-13, 2e-13));
    assert_eq!((small, note.as_str()), (["−1", "0", "1", "2"].map(String::from).to_vec(), "×10⁻¹³"));
    let (large, note) = labels((0.0, 3.2e8));
    assert_eq!((large, note.as_str()), (["0", "1", "2", "3"].map(String::from).to_vec(), "×10⁸"));
    let (late, note) = labels((1e9, 1e9 + 1.0));
    assert_eq!((late[1].as_str(), note.as_str()), ("0.2", "+ 1000000000"));
    for range in [(-7e-5, 3e-4), (1.0, 1.0 + 1e-12), (-4.2e20, 1e18), (0.099, 0.1), (-1e300, 1e300)] {
        let (labels, _) = labels(range);
        assert!(labels.len() >= 3 && labels.iter().all(|label| label.chars().count() <= 9), "{labels:?}");
        assert!(labels.windows(2).all(|pair| pair[0] != pair[1]), "{labels:?}");
    }
}

#[test]
fn constant_values_lie_in_the_middle() {
    for value in [0.0, 1.0, -3e9, 1e-300] {
        let axis = Axis::new(Scale::Linear, Some((value, value)), 0.05, 5);
        assert!((axis.place(value) - 0.5).abs() < 0.1, "{value}");
        assert!(!axis.marks.is_empty());
    }
}

#[test]
fn a_logarithmic_axis_has_powers_of_ten() {
    let axis = Axis::new(Scale::Logarithmic, Some((3e-16, 2e-11)), 0.0, 6);
    let marks: Vec<_> = axis.marks.iter().map(|mark| mark.label.as_str()).collect();
    assert_eq!(marks, ["10⁻¹⁶", "10⁻¹⁵", "10⁻¹⁴", "10⁻¹³", "10⁻¹²", "10⁻¹¹", "10⁻¹⁰"]);
    assert!((axis.place(1e-13) - 0.5).abs() < 1e-12);
    assert_eq!(axis.place(0.0), 0.0);
    assert!(axis.place(f64::NAN).is_nan());
}

#[test]
fn an_exact_axis_ends_with_its_values() {
    let marks = |low: f64, high: f64| {
        let axis = Axis::exact(Scale::Logarithmic, [f64::NAN, high, 0.0, low].into_iter(), 6);
        assert!(axis.place(low).abs() < 1e-12 && (axis.place(high) - 1.0).abs() < 1e-12);
        axis.marks.into_iter().map(|mark| mark.label).collect::<Vec<_>>()
    };
    assert_eq!(marks(0.15, 20.0), ["0.2", "0.5", "1", "2", "5", "10", "20"]);
    assert_eq!(marks(3e-9, 4e-8), ["5×10⁻⁹", "10⁻⁸", "2×10⁻⁸"]);
    assert_eq!(marks(1e-20, 1.0).len(), 11);
}

#[test]
fn a_picture_has_pixels_where_the_curve_is() {
    let figure = figure(vec![curve("y", [(0.0, 0.0), (1.0, 1.0)].into_iter())]);
    let path = std::env::temp_dir().join(format!("lagrange_{}.png", std::process::id()));
    figure.save(&path).expect("writes");
    let file = std::io::BufReader::new(std::fs::File::open(&path).expect("is there"));
    let mut reader = png::Decoder::new(file).read_info().expect("is PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("small")];
    let info = reader.next_frame(&mut pixels).expect("a frame");
    assert_eq!((info.width, info.height), (800, 600));
    // The middle of the axes, on the diagonal, and a place next to it.
    let pixel = |x: usize, y: usize| &pixels[3 * (800 * y + x)..][..3];
    assert_eq!(pixel(456, 278), [0, 114, 178]);
    assert_eq!(pixel(300, 278), [255, 255, 255]);
    let letters =
        (0..600).flat_map(|y| (0..140).map(move |x| (x, y))).filter(|(x, y)| pixel(*x, *y)[0] < 100);
    assert!(letters.count() > 200, "labels of the ordinate");
    std::fs::remove_file(path).expect("was there");
}

/// Returns the columns and rows of a picture that contain ink, within these ranges.
fn inked(pixels: &Pixels, columns: Range<usize>, rows: Range<usize>) -> [Range<usize>; 2] {
    let width = pixels.width() as usize;
    let is_dark = |(x, y): &(usize, usize)| pixels.rgba()[4 * (width * y + x)] < 128;
    let places = rows.flat_map(|y| columns.clone().map(move |x| (x, y))).filter(is_dark);
    let (across, down): (Vec<usize>, Vec<usize>) = places.unzip();
    [across, down].map(|found| *found.iter().min().expect("ink")..found.iter().max().expect("ink") + 1)
}

#[test]
fn words_are_where_the_document_has_them() {
    let figure = figure(vec![curve("y", [(0.0, 0.0), (1.0, 1.0)].into_iter())]);
    let svg = figure.svg().expect("draws");
    let line = svg.lines().find(|line| line.ends_with(">time</text>")).expect("is there");
    let number = |name: &str| -> f64 {
        let rest = line.split(&format!(" {name}=\"")).nth(1).expect("is there");
        rest.split('"').next().and_then(|value| value.parse().ok()).expect("a number")
    };
    assert!(line.contains("text-anchor=\"middle\""), "{line}");
    // Five points per pixel; capitals and the letter t extend upwards from the base line.
    let (size, x, y) = (number("font-size") / 5.0, number("x") / 5.0, number("y") / 5.0);
    let (base, half) = (y, 0.5 * size * width("time", Slope::Upright));
    let pixels = figure.pixels().expect("draws");
    let [columns, rows] = inked(&pixels, 150..770, 540..600);
    let near = |found: usize, wanted: f64| assert!((found as f64 - wanted).abs() < 2.0, "{found} {wanted}");
    near(columns.start, x - half);
    near(columns.end, x + half);
    near(rows.end, base);
    assert!((rows.len() as f64) < 0.8 * size, "{rows:?}");
}

#[test]
fn other_extensions_are_refused() {
    for path in ["plot.pdf", "plot", "svg"] {
        let error = figure(Vec::new()).save(path.as_ref()).expect_err("refused");
        assert!(matches!(error, PlotError::Extension(_)) && error.to_string().contains(path));
    }
    assert!(
        matches!(figure(Vec::new()).save("/no/such/folder/a.svg".as_ref()), Err(PlotError::Io { path, .. }) if path.ends_with("a.svg"))
    );
}

#[test]
fn pictures_larger_than_memory_are_refused() {
    for size in [[1 << 20, 1 << 20], [u32::MAX; 2], [0, 1], [1, 0]] {
        assert_eq!(Pixels::white(size, 1.0), None, "{size:?}");
    }
}
