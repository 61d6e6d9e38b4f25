//! Letters made of strokes, so that pictures in pixels need no font: those of ASCII, Greek ones, and some signs.
//!
//! A glyph is drawn on a grid: column 0 is its left edge, row 2 the base line, row 7 the height of small letters, row 9
//! that of capitals and digits. Strokes are separated by blanks, points are two digits, column and row. A stroke that
//! starts with `~` is an open curve and one that starts with `@` a closed one: quadratic B-splines of these points, by
//! Chaikin's corner cutting (1974).

/// A character, its width on the grid and its strokes.
type Glyph = (char, f64, &'static str);

/// A point in units of the height of capitals; x to the right, y upwards from the base line.
pub type Point = (f64, f64);

const BASE_LINE: f64 = 2.0;
const CAPITALS: f64 = 7.0;
/// Between letters, on the grid.
const SPACE: f64 = 2.0;
/// How often corners are cut.
const ROUNDS: usize = 3;
/// Superscripts are smaller by this factor and raised by this part of the height of capitals.
const SUPERSCRIPT: (f64, f64) = (0.65, 0.5);
const SUPERSCRIPTS: [(char, char); 11] = [
    ('⁰', '0'),
    ('¹', '1'),
    ('²', '2'),
    ('³', '3'),
    ('⁴', '4'),
    ('⁵', '5'),
    ('⁶', '6'),
    ('⁷', '7'),
    ('⁸', '8'),
    ('⁹', '9'),
    ('⁻', '−'),
];

/// What is drawn for a character without a glyph.
const UNKNOWN: Glyph = ('\u{fffd}', 5.0, "0209595202");

#[rustfmt::skip]
const GLYPHS: [Glyph; 138] = [
    (' ', 2.0, ""),
    ('!', 0.0, "0904 0202"),
    ('"', 2.0, "0907 2927"),
    ('#', 6.0, "1228 4258 0464 0767"),
    ('$', 5.0, "~5859090655520203 3A31"),
    ('%', 6.0, "0269 @09290706 @62424465"),
    ('&', 6.0, "~6207393909050212424265"),
    ('\'', 0.0, "0907"),
    ('(', 2.0, "~29060320"),
    (')', 2.0, "~09262300"),
    ('*', 4.0, "2925 0836 0638"),
    ('+', 6.0, "0565 3238"),
    (',', 1.0, "1201"),
    ('-', 3.0, "0535"),
    ('.', 0.0, "0202"),
    ('/', 4.0, "0149"),
    ('0', 5.0, "@09595202"),
    ('1', 3.0, "072922"),
    ('2', 5.0, "~0709595602 0252"),
    ('3', 5.0, "~0809595626 ~2656520203"),
    ('4', 5.0, "42490454"),
    ('5', 5.0, "490906 ~060757520203"),
    ('6', 5.0, "~49290904 @06565202"),
    ('7', 5.0, "095922"),
    ('8', 5.0, "@09595606 @06565202"),
    ('9', 5.0, "~12325257 @09595505"),
    (':', 0.0, "0202 0606"),
    (';', 1.0, "1201 1616"),
    ('<', 5.0, "570552"),
    ('=', 5.0, "0454 0656"),
    ('>', 5.0, "075502"),
    ('?', 4.0, "~0809494624 2424 2222"),
    ('@', 8.0, "@46664323 ~46436385898902020272"),
    ('A', 6.0, "023962 1454"),
    ('B', 5.0, "0209 0929 0626 0222 ~29595626 ~26565222"),
    ('C', 6.0, "~676909026264"),
    ('D', 6.0, "0209 0929 0222 ~29696222"),
    ('E', 5.0, "59090252 0646"),
    ('F', 5.0, "590902 0646"),
    ('G', 6.0, "~676909026265 6535"),
    ('H', 6.0, "0209 6269 0666"),
    ('I', 0.0, "0209"),
    ('J', 4.0, "4944 ~44420203"),
    ('K', 5.0, "0209 5905 1652"),
    ('L', 5.0, "090252"),
    ('M', 6.0, "0209346962"),
    ('N', 6.0, "02096269"),
    ('O', 7.0, "@09797202"),
    ('P', 5.0, "0209 0929 0525 ~29595525"),
    ('Q', 7.0, "@09797202 4471"),
    ('R', 5.0, "0209 0929 0525 ~29595525 2552"),
    ('S', 5.0, "~5859090655520203"),
    ('T', 6.0, "0969 3932"),
    ('U', 6.0, "0904 ~04026264 6469"),
    ('V', 6.0, "093269"),
    ('W', 8.0, "0922486289"),
    ('X', 6.0, "0269 0962"),
    ('Y', 6.0, "0935 6935 3532"),
    ('Z', 5.0, "09590252"),
    ('[', 2.0, "29090020"),
    ('\\', 4.0, "0941"),
    (']', 2.0, "09292000"),
    ('^', 4.0, "072947"),
    ('_', 5.0, "0151"),
    ('`', 1.0, "0918"),
    ('a', 4.0, "4742 @07474202"),
    ('b', 5.0, "0902 @07575202"),
    ('c', 4.0, "~464707024243"),
    ('d', 5.0, "5952 @07575202"),
    ('e', 5.0, "0555 ~555707025253"),
    ('f', 3.0, "~391917 1712 0737"),
    ('g', 5.0, "5752 @07575202 ~52500001"),
    ('h', 4.0, "0902 ~04074744 4442"),
    ('i', 0.0, "0702 0909"),
    ('j', 2.0, "2722 ~22201000 2929"),
    ('k', 4.0, "0902 4704 1542"),
    ('l', 0.0, "0902"),
    ('m', 8.0, "0702 ~04074744 4442 ~44478784 8482"),
    ('n', 4.0, "0702 ~04074744 4442"),
    ('o', 5.0, "@07575202"),
    ('p', 5.0, "0700 @07575202"),
    ('q', 5.0, "5750 @07575202"),
    ('r', 3.0, "0702 ~040737"),
    ('s', 4.0, "~4647070544420203"),
    ('t', 3.0, "1914 ~141232 0737"),
    ('u', 4.0, "0704 ~04024244 4742"),
    ('v', 4.0, "072247"),
    ('w', 6.0, "0712375267"),
    ('x', 4.0, "0247 0742"),
    ('y', 4.0, "0722 4710"),
    ('z', 4.0, "07470242"),
    ('{', 2.0, "~2919160605 ~0505041020"),
    ('|', 0.0, "0901"),
    ('}', 2.0, "~0919161525 ~2525141000"),
    ('~', 6.0, "~0406363565"),
    ('×', 4.0, "0347 0743"),
    ('−', 5.0, "0555"),
    ('·', 0.0, "0505"),
    ('′', 1.0, "1907"),
    ('°', 2.0, "@09292707"),
    ('–', 5.0, "0555"),
    ('…', 4.0, "0202 2222 4242"),
    ('½', 7.0, "0829 2925 0279 ~44647252 4373"),
    ('Γ', 5.0, "025959"),
    ('Δ', 6.0, "02396202"),
    ('Θ', 7.0, "@09797202 2555"),
    ('Λ', 6.0, "023962"),
    ('Ξ', 6.0, "0969 1656 0262"),
    ('Π', 6.0, "02096962"),
    ('Σ', 5.0, "5909350252"),
    ('Υ', 6.0, "0935 6935 3532"),
    ('Φ', 8.0, "@08888303 4942"),
    ('Ψ', 6.0, "~09046469 3932"),
    ('Ω', 7.0, "0222 ~22050A7A7552 5272"),
    ('α', 5.0, "~574202074752"),
    ('β', 5.0, "~0009494616 ~16565202"),
    ('γ', 4.0, "~07172420 472420"),
    ('δ', 5.0, "@06565202 ~5919164655"),
    ('ε', 4.0, "~4647070525 ~2505024243"),
    ('ζ', 4.0, "0949 ~4904024230"),
    ('η', 4.0, "0702 ~04074744 4440"),
    ('θ', 4.0, "@09494202 0646"),
    ('ι', 1.0, "~070212"),
    ('κ', 4.0, "0702 4704 1542"),
    ('λ', 4.0, "~09194252 2602"),
    ('μ', 4.0, "0700 ~04024244 4742"),
    ('ν', 4.0, "0722 ~224447"),
    ('ξ', 4.0, "~49090636 ~3606024230"),
    ('π', 5.0, "0757 1712 4742"),
    ('ρ', 5.0, "@07575202 0400"),
    ('σ', 5.0, "@07474202 2757"),
    ('ς', 4.0, "~4747070242"),
    ('τ', 4.0, "0747 ~27222242"),
    ('υ', 4.0, "~0702424247"),
    ('φ', 6.0, "@07676202 3930"),
    ('χ', 5.0, "0750 5700"),
    ('ψ', 6.0, "~07026267 3930"),
    ('ω', 6.0, "~1707023235 ~5767623235"),
];

/// The strokes of a line of text, from its left end on the base line, and its width.
pub fn strokes(text: &str) -> (Vec<Vec<Point>>, f64) {
    let (mut strokes, mut x, mut end) = (Vec::new(), 0.0, 0.0);
    for character in text.chars() {
        let superscript = SUPERSCRIPTS.iter().find(|(raised, _)| *raised == character);
        let (scale, raise) = superscript.map_or((1.0, 0.0), |_| SUPERSCRIPT);
        let (_, width, drawing) = glyph(superscript.map_or(character, |(_, plain)| *plain));
        for stroke in drawing.split_whitespace() {
            let place =
                |(column, row): Point| (x + scale * column / CAPITALS, raise + scale * row / CAPITALS);
            strokes.push(curve(stroke).into_iter().map(place).collect());
        }
        end = x + scale * width / CAPITALS;
        x = end + scale * SPACE / CAPITALS;
    }
    (strokes, end)
}

fn glyph(character: char) -> Glyph {
    GLYPHS.into_iter().find(|(known, ..)| *known == character).unwrap_or(UNKNOWN)
}

/// The points of a stroke on the grid, from the base line upwards.
fn curve(stroke: &str) -> Vec<Point> {
    let (is_closed, is_curved) = (stroke.starts_with('@'), stroke.starts_with(['@', '~']));
    let digits: Vec<f64> = stroke.chars().filter_map(|c| c.to_digit(11).map(f64::from)).collect();
    let mut points: Vec<Point> = digits.chunks_exact(2).map(|pair| (pair[0], pair[1] - BASE_LINE)).collect();
    let rounds = if is_curved { ROUNDS } else { 0 };
    for _ in 0..rounds {
        points = cut_corners(&points, is_closed);
    }
    if is_closed {
        points.extend(points.first().copied());
    }
    points
}

/// One round of Chaikin's corner cutting; the ends of an open curve stay.
fn cut_corners(points: &[Point], is_closed: bool) -> Vec<Point> {
    let mix = |a: Point, b: Point, s: f64| (a.0 + s * (b.0 - a.0), a.1 + s * (b.1 - a.1));
    let mut cut = Vec::with_capacity(2 * points.len());
    for (a, b) in points.iter().zip(&points[1.min(points.len())..]) {
        cut.extend([mix(*a, *b, 0.25), mix(*a, *b, 0.75)]);
    }
    if let ([first, ..], [.., last]) = (points, points) {
        if is_closed {
            cut.extend([mix(*last, *first, 0.25), mix(*last, *first, 0.75)]);
        } else {
            cut.splice(..1, [*first]);
            cut.pop();
            cut.push(*last);
        }
    }
    cut
}
