use crate::film::layers::{Change, Layer, layers, lengths};
use crate::film::tests::{line, pendulum, pendulum_at, stroke};
use crate::picture::{Mark, Picture, Point, Segment};

/// Returns the marks of layers in a picture.
fn marks(layers: &[Layer], picture: usize) -> Vec<Mark> {
    layers.iter().filter_map(|layer| mark(layer, picture)).collect()
}

fn mark(layer: &Layer, picture: usize) -> Option<Mark> {
    let mut mark = layer.mark.clone();
    match &layer.change {
        Change::Shows(shown) => shown[picture].then_some(mark),
        Change::Moves(poses) => {
            let pose = poses[picture]?;
            let (sin, cos) = pose.angle.sin_cos();
            each_point(&mut mark, |[x, y]| [pose.at[0] + cos * x - sin * y, pose.at[1] + sin * x + cos * y]);
            Some(mark)
        }
        Change::Grows(drawn) => {
            let drawn = drawn[picture]?;
            let Mark::Path { segments, .. } = &mut mark else { return None };
            let count = lengths(segments).iter().filter(|length| **length <= drawn).count();
            segments.truncate(count);
            Some(mark)
        }
        Change::Bends(shapes) => {
            let Mark::Path { segments, .. } = &mut mark else { return None };
            *segments = shapes[picture].clone()?;
            Some(mark)
        }
    }
}

fn each_point(mark: &mut Mark, f: impl Fn(Point) -> Point) {
    match mark {
        Mark::Text { at, .. } => *at = f(*at),
        Mark::Path { segments, .. } => {
            for segment in segments {
                *segment = match *segment {
                    Segment::Move(end) => Segment::Move(f(end)),
                    Segment::Line(end) => Segment::Line(f(end)),
                    Segment::Curve(a, b, end) => Segment::Curve(f(a), f(b), f(end)),
                    Segment::Close => Segment::Close,
                };
            }
        }
    }
}

fn distance(one: &Mark, other: &Mark) -> f64 {
    let (mut a, mut b) = (Vec::new(), Vec::new());
    for (mark, points) in [(one, &mut a), (other, &mut b)] {
        let seen = std::cell::RefCell::new(Vec::new());
        each_point(&mut mark.clone(), |point| {
            seen.borrow_mut().push(point);
            point
        });
        *points = seen.into_inner();
    }
    assert_eq!(a.len(), b.len());
    a.iter().zip(&b).map(|(p, q)| (p[0] - q[0]).hypot(p[1] - q[1])).fold(0.0, f64::max)
}

fn is_drawn(mark: &&Mark) -> bool {
    !crate::svg::is_empty(mark)
}

#[test]
fn show_every_picture_of_the_film() {
    let film = pendulum(30);
    let layers = layers(&film.recording);
    for (index, picture) in film.recording.iter().enumerate() {
        let (shown, wanted) = (marks(&layers, index), picture.marks.iter().filter(is_drawn));
        assert_eq!(shown.len(), wanted.clone().count(), "picture {index}");
        for (shown, wanted) in shown.iter().zip(wanted) {
            assert!(distance(shown, wanted) < 0.01, "picture {index}: {shown:?} for {wanted:?}");
        }
    }
}

#[test]
fn hold_only_what_changes() {
    let film = pendulum(30);
    let kinds: Vec<char> = layers(&film.recording)
        .iter()
        .map(|layer| match layer.change {
            Change::Shows(_) => 's',
            Change::Moves(_) => 'm',
            Change::Grows(_) => 'g',
            Change::Bends(_) => 'b',
        })
        .collect();
    // Ground, path, rod, disk, velocity, force, label; one time label per tenth of a second,
    // including the rounded 1.16 s.
    let times =
        film.times().iter().map(|time| format!("{time:.1}")).collect::<std::collections::BTreeSet<_>>();
    let wanted: Vec<char> = "sgmmbsm".chars().chain(std::iter::repeat_n('s', times.len())).collect();
    assert_eq!(kinds, wanted);
}

#[test]
fn follow_turns_beyond_half_a_turn() {
    // The rod swings by 0.9 rad, so its own angle never jumps.
    let film = pendulum_at(&(0..200).map(|index| f64::from(index) / 25.0).collect::<Vec<_>>());
    for layer in layers(&film.recording) {
        let Change::Moves(poses) = layer.change else { continue };
        let angles: Vec<f64> = poses.iter().flatten().map(|pose| pose.angle).collect();
        assert!(angles.windows(2).all(|pair| (pair[1] - pair[0]).abs() < 0.1));
    }
}

#[test]
fn turn_on_without_end() {
    let spun = |index: usize| {
        let (sin, cos) = (0.7 * index as f64).sin_cos();
        let mut picture = pendulum(1).recording[0].clone();
        picture.marks.truncate(1);
        each_point(&mut picture.marks[0], |[x, y]| [cos * x - sin * y, sin * x + cos * y]);
        picture
    };
    let pictures: Vec<_> = (0..20).map(spun).collect();
    let Change::Moves(poses) = &layers(&pictures)[0].change else { panic!("a line that turns only moves") };
    let last = poses[19].expect("is shown").angle;
    assert!((last - 19.0 * 0.7).abs() < 1e-9, "{last}");
}

fn path(points: &[Point]) -> Picture {
    Picture { size: [100.0; 2], title: "".into(), marks: vec![stroke(line(points))] }
}

#[test]
fn grow_although_the_last_point_of_a_picture_may_lack_in_the_next() {
    // The second picture ends at 10.4, too close to 10 to be kept.
    let pictures = [
        path(&[[0.0, 0.0], [10.0, 0.0]]),
        path(&[[0.0, 0.0], [10.0, 0.0], [10.4, 0.1]]),
        path(&[[0.0, 0.0], [10.0, 0.0], [14.0, 3.0]]),
        path(&[[0.0, 0.0], [10.0, 0.0], [14.0, 3.0], [14.0, 9.0]]),
    ];
    let layers = layers(&pictures);
    let [Layer { change: Change::Grows(drawn), .. }] = layers.as_slice() else { panic!("{layers:?}") };
    let wanted = [10.0, 10.0 + 0.4f64.hypot(0.1), 15.0, 21.0];
    for (drawn, wanted) in drawn.iter().zip(wanted) {
        assert!(drawn.is_some_and(|drawn| (drawn - wanted).abs() < 1e-12), "{drawn:?} {wanted}");
    }
}

#[test]
fn do_not_grow_along_another_way() {
    let pictures = [
        path(&[[0.0, 0.0], [10.0, 0.0], [12.0, 5.0]]),
        path(&[[0.0, 0.0], [10.0, 0.0], [20.0, 0.0], [30.0, 0.0]]),
    ];
    assert!(layers(&pictures).iter().all(|layer| !matches!(layer.change, Change::Grows(_))));
}
