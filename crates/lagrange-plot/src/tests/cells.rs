//! Grids of cells, and bands.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use crate::label::Label;
use crate::pixels::Pixels;
use crate::{Band, Cells, Curve, Figure, Panel, Scale};

const DARK: [u8; 3] = [68, 1, 84];
const YELLOW: [u8; 3] = [253, 231, 37];
const WHITE: [u8; 3] = [255; 3];

/// Returns a figure of three cells side by side in two rows; the last one has no value.
fn map(scale: Scale) -> Figure {
    let values = vec![1.0, 10.0, 100.0, 100.0, 1.0, f64::NAN];
    let cells = Cells { name: "time".into(), scale, x: (0.0, 3.0), y: (-1.0, 1.0), columns: 3, values };
    Figure::of_cells(Panel { x: "x".into(), y: "y".into(), cells: Some(cells), ..Panel::default() })
}

fn pixel(pixels: &Pixels, (x, y): (u32, u32)) -> [u8; 3] {
    let at = 4 * (y * pixels.width() + x) as usize;
    [pixels.rgba()[at], pixels.rgba()[at + 1], pixels.rgba()[at + 2]]
}

/// Returns the pixel in the middle of a cell, counted from the lower left. Each cell has 334 pixels
/// per side.
fn middle((column, row): (u32, u32)) -> (u32, u32) {
    (2 * 74 + 334 * column + 167, 2 * 28 + 334 * (1 - row) + 167)
}

#[test]
fn cells_have_the_colours_of_their_values() {
    let pixels = map(Scale::Logarithmic).pixels().expect("draws");
    let at = |cell| pixel(&pixels, middle(cell));
    assert_eq!([at((0, 0)), at((1, 1))], [DARK; 2]);
    assert_eq!([at((2, 0)), at((0, 1))], [YELLOW; 2]);
    assert_eq!(at((2, 1)), WHITE, "not finite");
    // Halfway between the powers of ten, which is between the fourth and the fifth of eight
    // colours.
    assert_eq!(at((1, 0)), [35, 144, 139]);
    let linear = map(Scale::Linear).pixels().expect("draws");
    assert_eq!(pixel(&linear, middle((2, 0))), YELLOW);
    assert_ne!(pixel(&linear, middle((1, 0))), [35, 144, 139]);
}

#[test]
fn each_cell_has_as_many_pixels() {
    let pixels = map(Scale::Linear).pixels().expect("draws");
    // Along a row through the middle of the lower cells, inside the border.
    let y = middle((0, 0)).1;
    let colours: Vec<_> = (150..2 * 74 + 3 * 334 - 2).map(|x| pixel(&pixels, (x, y))).collect();
    let changes: Vec<_> = (1..colours.len()).filter(|k| colours[*k] != colours[k - 1]).collect();
    assert_eq!(changes, [334 - 2, 2 * 334 - 2]);
}

#[test]
fn a_document_holds_the_same_cells() {
    let svg = map(Scale::Linear).svg().expect("draws");
    let images: Vec<_> = svg.lines().filter(|line| line.starts_with("<image")).collect();
    assert_eq!(images.len(), 2, "cells and the bar of colours");
    assert!(images[0].contains("x=\"740\" y=\"280\" width=\"5010\" height=\"3340\""), "{}", images[0]);
    let data = images[0].split("base64,").nth(1).and_then(|rest| rest.split('"').next()).expect("data");
    let file = STANDARD.decode(data).expect("base 64");
    let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().expect("is PNG");
    let mut rgba = vec![0; reader.output_buffer_size().expect("small")];
    let info = reader.next_frame(&mut rgba).expect("a frame");
    assert_eq!((info.width, info.height), (3, 2));
    let pixels: Vec<&[u8]> = rgba.chunks(4).map(|pixel| &pixel[..3]).collect();
    assert_eq!([pixels[0], pixels[1], pixels[3], pixels[5]], [&YELLOW, &DARK, &DARK, &YELLOW]);
    assert_eq!(rgba[4 * 2 + 3], 0, "not finite");
    // The white background comes first, and marks and labels come later.
    let at = |text: &str| svg.find(text).expect("is there");
    assert!(at("<rect") < at("<image") && at("<image") < at("<polyline"));
    assert!([">time<", ">−1.0<", ">100<"].iter().all(|label| svg.contains(label)), "{svg}");
}

#[test]
fn nothing_to_show_is_white() {
    let cells = Cells {
        name: Label::default(),
        scale: Scale::Logarithmic,
        x: (0.0, 1.0),
        y: (0.0, 1.0),
        columns: 2,
        values: vec![f64::NAN, f64::INFINITY, f64::NAN, f64::NEG_INFINITY],
    };
    let figure = Figure::of_cells(Panel { cells: Some(cells), ..Panel::default() });
    let pixels = figure.pixels().expect("draws");
    assert_eq!(pixel(&pixels, (400, 400)), WHITE);
}

#[test]
fn bands_are_areas_that_darken_in_each_other() {
    let band = |name: &str, half: f64| Band {
        name: name.into(),
        points: vec![
            (0.0, -half, half),
            (1.0, -half, half),
            (2.0, f64::NAN, half),
            (3.0, -half, half),
            (4.0, -half, half),
        ],
    };
    let curve = Curve { name: "median".into(), points: vec![(0.0, 0.0), (4.0, 0.0)] };
    let panel =
        Panel { bands: vec![band("90 %", 2.0), band("50 %", 1.0)], curves: vec![curve], ..Panel::default() };
    let figure = Figure { panels: vec![panel], columns: 1, size: (600, 300) };
    let svg = figure.svg().expect("draws");
    let areas = svg.lines().filter(|line| line.contains("<polygon")).count();
    // Two pieces of each band, one sample of the outer band and two of the inner one.
    assert_eq!(areas, 4 + 3);
    assert!([">90 %<", ">50 %<", ">median<"].iter().all(|label| svg.contains(label)));
    assert!(!svg.contains("NaN"));

    let pixels = figure.pixels().expect("draws");
    let middle = |row: u32| pixel(&pixels, (2 * 74 + 20, 2 * 28 + row));
    // 444 pixels from 2.2 to −2.2.
    let (above, outer, inner) = (middle(5), middle(70), middle(150));
    assert_eq!(above, WHITE);
    assert!(outer[0] > inner[0] && inner[0] > 100 && outer[0] < 255, "{outer:?} {inner:?}");
}
