//! Layout of a film's elements as pictures with the same marks in the same order.

use std::collections::{BTreeMap, BTreeSet};

use crate::element::{Element, Layer, Measure, Reach, Shape};
use crate::error::DrawError;
use crate::geometry::{bounds, extent, length, subtract};
use crate::labels::{self, Sheet};
use crate::marks;
use crate::paper::Paper;
use crate::picture::{Mark, Picture, Point};
use crate::tag::{Tag, tag};
use crate::view::{MARGIN, View};

/// The identity of an element across pictures: its kind, its name, and its index among equal ones.
#[derive(Clone, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
struct Key {
    layer: Layer,
    what: &'static str,
    name: String,
    marks: usize,
    count: usize,
}

/// An element at one moment.
type Drawn = (Vec<Mark>, Option<Tag>);

/// Lays out the pictures of a film from its times and elements. The longest arrow of each kind has
/// the length `longest`, relative to the smaller side within the margins.
pub(super) fn pictures(
    film: &[(f64, Vec<Element>)],
    paper: &Paper,
    longest: f64,
) -> Result<Vec<Picture>, DrawError> {
    for (time, elements) in film {
        check(*time, elements)?;
    }
    let view = common_view(film, paper.window(MARGIN)?, longest)?;
    let drawn: Vec<Vec<(Key, Drawn)>> = film.iter().map(|(_, elements)| draw(elements, &view)).collect();
    let keys = aligned(&drawn);
    let empty = patterns(&drawn);
    let scene = |moment| {
        let scene = complete(moment, &keys, &empty);
        let sheet = sheet(&scene, &keys);
        (scene.into_iter().flat_map(|(marks, _)| marks).collect(), sheet)
    };
    Ok(paper.finished(drawn.into_iter().map(scene).collect()))
}

fn check(time: f64, elements: &[Element]) -> Result<(), DrawError> {
    let wrong = |element: &&Element| element.numbers().iter().any(|number| !number.is_finite());
    match elements.iter().find(wrong) {
        Some(Element { name, shape, .. }) => {
            Err(DrawError::NotFinite { item: name.clone(), what: shape.what(), time })
        }
        None => Ok(()),
    }
}

/// Computes the common window and scale of arrows.
fn common_view(film: &[(f64, Vec<Element>)], window: [Point; 2], longest: f64) -> Result<View, DrawError> {
    let room = subtract(window[1], window[0]);
    let elements = || film.iter().flat_map(|(_, elements)| elements);
    let scale = |measure: Measure| {
        let largest = elements().map(|element| magnitude(&element.shape, measure)).fold(0.0, f64::max);
        // The reciprocal of tiny numbers overflows.
        let scale = longest * room[0].min(room[1]) / largest;
        if scale.is_finite() { scale } else { 0.0 }
    };
    let arrows = [scale(Measure::Velocity), scale(Measure::Acceleration), scale(Measure::Force)];
    let pixels = |measure: Measure| match measure {
        Measure::World => 0.0,
        Measure::Pixels => 1.0,
        Measure::Velocity => arrows[0],
        Measure::Acceleration => arrows[1],
        Measure::Force => arrows[2],
    };
    let mut reaches: Vec<Reach> = elements().flat_map(|element| element.reaches(&pixels)).collect();
    reaches.extend(near(elements(), &reaches));
    View::new(window, arrows, &reaches)
}

/// Returns the ends of rays that are not far away relative to the size of everything else.
fn near<'a>(elements: impl Iterator<Item = &'a Element>, reaches: &[Reach]) -> Vec<Reach> {
    const FAR: f64 = 0.7;
    let places = || reaches.iter().map(|reach| reach.at);
    let ([low, high], far) = (bounds(places()), FAR * extent(places()));
    let is_near = |p: &Point| (0..2).all(|k| (low[k] - far..=high[k] + far).contains(&p[k]));
    let ends = elements.filter_map(|element| match element.shape {
        Shape::Ray { to, .. } => Some(to),
        _ => None,
    });
    ends.filter(is_near).map(|at| Reach { at, offset: [0.0, 0.0], room: MARGIN }).collect()
}

fn magnitude(shape: &Shape, wanted: Measure) -> f64 {
    match shape {
        Shape::Arrow { vector, measure, .. } if *measure == wanted => length(*vector),
        _ => 0.0,
    }
}

fn draw(elements: &[Element], view: &View) -> Vec<(Key, Drawn)> {
    let mut seen: BTreeMap<Key, usize> = BTreeMap::new();
    let mut keyed = |element: &Element| {
        let marks = marks::marks(element, view);
        let (layer, what) = (element.layer, element.shape.what());
        let mut key = Key { layer, what, name: element.name.clone(), marks: marks.len(), count: 0 };
        let count = seen.entry(key.clone()).or_default();
        key.count = *count;
        *count += 1;
        (key, (marks, tag(element, view)))
    };
    elements.iter().map(&mut keyed).collect()
}

/// Merges the keys of all moments from back to front, in the order of each moment if these agree.
fn aligned(film: &[Vec<(Key, Drawn)>]) -> Vec<Key> {
    let mut keys: Vec<Key> = Vec::new();
    let mut known: BTreeSet<Key> = BTreeSet::new();
    for moment in film {
        let mut after = 0;
        for (key, _) in moment {
            if known.insert(key.clone()) {
                keys.insert(after, key.clone());
                after += 1;
            } else {
                after = keys.iter().position(|other| other == key).map_or(after, |index| index + 1);
            }
        }
    }
    keys.sort_by_key(|key| key.layer);
    keys
}

/// Returns placeholders for missing elements: their marks without content.
fn patterns(film: &[Vec<(Key, Drawn)>]) -> BTreeMap<Key, Vec<Mark>> {
    let all = film.iter().flatten();
    all.map(|(key, (marks, _))| (key.clone(), marks.iter().cloned().map(Mark::emptied).collect())).collect()
}

fn complete(moment: Vec<(Key, Drawn)>, keys: &[Key], empty: &BTreeMap<Key, Vec<Mark>>) -> Vec<Drawn> {
    let mut found: BTreeMap<Key, Drawn> = moment.into_iter().collect();
    let missing = |key: &Key| (empty.get(key).cloned().unwrap_or_default(), None);
    keys.iter().map(|key| found.remove(key).unwrap_or_else(|| missing(key))).collect()
}

fn sheet(scene: &[Drawn], keys: &[Key]) -> Sheet {
    let bodies = scene.iter().zip(keys).enumerate().filter(|(_, (_, key))| key.layer == Layer::Body);
    let areas = bodies
        .flat_map(|(index, ((marks, _), _))| labels::areas(marks).into_iter().map(move |area| (index, area)));
    let areas = areas.collect();
    let lines = scene.iter().flat_map(|(marks, _)| labels::lines(marks)).collect();
    Sheet { tags: scene.iter().map(|(_, tag)| tag.clone()).collect(), lines, areas }
}

#[cfg(test)]
mod tests {

    use super::pictures as pictures_on;
    use crate::DrawError;
    use crate::colour::INK;
    use crate::element::{Element, Layer, Measure, Shape};
    use crate::look::{Direction, Look};
    use crate::paper::Paper;
    use crate::picture::{Mark, Picture};
    use crate::svg;

    fn pictures(film: &[(f64, Vec<Element>)]) -> Result<Vec<Picture>, DrawError> {
        let look = Look { size: [300.0, 200.0], title: String::new(), direction: Direction::default() };
        pictures_on(film, &Paper::new(&look, ""), 0.25)
    }

    fn dot(name: &str, x: f64) -> Element {
        let shape = Shape::Dot { at: [x, 0.0] };
        Element { name: name.to_string(), label: name.to_string(), colour: INK, layer: Layer::Sketch, shape }
    }

    #[test]
    fn what_is_missing_at_some_moments_leaves_empty_marks() {
        let film = [(0.0, vec![dot("A", 0.0), dot("C", 2.0)]), (1.0, vec![dot("A", 0.0), dot("B", 1.0)])];
        let pictures = pictures(&film).expect("draws");
        let shown = |index: usize| pictures[index].marks.iter().filter(|mark| !svg::is_empty(mark)).count();
        assert_eq!((pictures[0].marks.len(), pictures[1].marks.len()), (6, 6), "three points, three labels");
        assert_eq!((shown(0), shown(1)), (4, 4));
    }

    #[test]
    fn the_longest_arrow_of_a_film_has_a_readable_length_and_others_are_in_proportion() {
        let arrow = |vector| Element {
            shape: Shape::Arrow { from: [0.0, 0.0], vector, measure: Measure::Force, is_push: false },
            ..dot("F", 0.0)
        };
        let film =
            [(0.0, vec![arrow([1e9, 0.0]), dot("A", 1.0)]), (1.0, vec![arrow([5e8, 0.0]), dot("A", 1.0)])];
        let pictures = pictures(&film).expect("draws");
        let longest = |index: usize| {
            let Mark::Path { segments, .. } = &pictures[index].marks[0] else { panic!("a path") };
            let points = crate::geometry::flattened(segments, 1);
            points.iter().map(|p| p[0] - points[0][0]).fold(0.0, f64::max)
        };
        assert!((longest(0) - 0.25 * 176.0).abs() < 1e-9, "{}", longest(0));
        assert!((longest(1) - 0.125 * 176.0).abs() < 1e-9, "{}", longest(1));
    }

    #[test]
    fn what_is_not_finite_is_refused_by_name() {
        let film = [(0.0, vec![dot("A", 0.0)]), (0.5, vec![dot("A", f64::NAN)])];
        match pictures(&film) {
            Err(DrawError::NotFinite { item, time, .. }) => assert_eq!((&*item, time), ("A", 0.5)),
            other => panic!("{other:?}"),
        }
    }
}
