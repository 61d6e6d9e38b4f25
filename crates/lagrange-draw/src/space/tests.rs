//! Pictures of a hand-written scene.

mod glb;
mod hostile;
mod page;
mod surroundings;
mod walker;

use lagrange_runtime::body::SpatialMotion;
use lagrange_runtime::scene::{
    Connector, Item, LoadOrigin, Part, Scene, Solid, Spatial, SpatialJoint, SpatialJointKind,
};
use lagrange_runtime::system::{MechanicalSystem, OdeSystem, Unnamed};

use super::skeleton::Skeleton;
use super::snapshot::{Hold, Link, difference};
use crate::picture::{Mark, Picture};
use crate::snapshot::{Joint, Snapshot, Span};
use crate::{DrawError, Drawing};

/// A cuboid on an arm that rotates about z, suspended from a spring.
struct Crane;

impl OdeSystem for Crane {
    type Scalar = f64;
    type State = [f64; 2];

    fn rhs(&self, _t: f64, [_, rate]: &[f64; 2]) -> [f64; 2] {
        [*rate, 0.0]
    }
}

impl MechanicalSystem for Crane {
    type Coordinates = [f64; 1];
    type Velocities = [f64; 1];
    type Columns<C> = Unnamed<C>;
    const COORDINATES: &'static [&'static str] = &["phi"];

    fn acceleration(&self, _t: f64, _q: &[f64; 1], _v: &[f64; 1]) -> [f64; 1] {
        [0.0]
    }

    fn position_rates(&self, _t: f64, _q: &[f64; 1], v: &[f64; 1]) -> [f64; 1] {
        *v
    }
}

const UPRIGHT: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

fn motion(rotation: [[f64; 3]; 3], center: [f64; 3], velocity: [f64; 3]) -> SpatialMotion<f64> {
    SpatialMotion {
        mass: 2.0,
        inertia: UPRIGHT,
        centroid: [0.0; 3],
        center,
        rotation,
        velocity,
        angular_velocity: [0.0; 3],
        acceleration: [0.0; 3],
        angular_acceleration: [0.0; 3],
    }
}

impl Scene for Crane {
    type Space = Spatial;

    fn items(
        &self,
        _t: f64,
        [angle]: &[f64; 1],
        [rate]: &[f64; 1],
        visit: &mut dyn FnMut(Item<'_, f64, Spatial>),
    ) {
        let (sin, cos) = angle.sin_cos();
        let rotation = [[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]];
        let center = [2.0 * cos, 2.0 * sin, 0.0];
        let velocity = [-2.0 * sin * rate, 2.0 * cos * rate, 0.0];
        let part = |shape, at, is_hole| Part { shape, at, rotation: UPRIGHT, is_hole };
        let arm = SpatialMotion { centroid: [0.0; 3], ..motion(rotation, [0.0; 3], [0.0; 3]) };
        visit(Item::Body { name: "arm", motion: arm, parts: &[] });
        let parts = [
            part(Solid::Cuboid(1.0, 0.6, 0.4), [0.0; 3], false),
            part(Solid::Cylinder(0.1, 0.4), [0.0; 3], true),
        ];
        visit(Item::Body { name: "box", motion: motion(rotation, center, velocity), parts: &parts });
        for (name, kind) in [("hanger", Connector::Spring), ("brake", Connector::Damper)] {
            visit(Item::Connector { name, kind, from: [0.0, 0.0, 2.0], to: center, tension: 1.0 });
        }
        let joint = |name, kind, at, bodies| {
            let kind = SpatialJoint { kind, axis: [0.0, 0.0, 1.0], bodies };
            Item::Joint { name, kind, at }
        };
        visit(joint("phi", SpatialJointKind::Revolute, [0.0; 3], [None, Some("arm")]));
        visit(joint("tip", SpatialJointKind::Pin, center, [Some("arm"), Some("box")]));
        let (cause, body) = (LoadOrigin::Gravity, Some("box"));
        visit(Item::Force { name: "weight", cause, body, at: center, force: [0.0, 0.0, -19.62] });
        visit(Item::Omitted { name: "torque on `phi`" });
    }
}

fn texts(picture: &Picture) -> Vec<String> {
    let text = |mark: &'_ Mark| match mark {
        Mark::Text { text, .. } if !text.is_empty() => Some(text.clone()),
        _ => None,
    };
    picture.marks.iter().filter_map(text).collect()
}

#[test]
fn weights_have_the_letter_of_the_user() {
    let drawing = Drawing::of(&Crane).forces();
    let shown = |drawing: &Drawing<'_, Crane>| texts(&drawing.picture(0.0, &[0.3, 1.0]).expect("draws"));
    assert!(shown(&drawing).iter().any(|text| text == "G_{box}"), "{:?}", shown(&drawing));
    let texts = shown(&drawing.clone().letter("weight", "W"));
    let is = |wanted: &'static str| move |text: &String| text == wanted;
    assert!(texts.iter().any(is("W_{box}")) && !texts.iter().any(is("G_{box}")), "{texts:?}");
    assert!(matches!(drawing.letter("wight", "W").picture(0.0, &[0.3, 1.0]), Err(DrawError::UnknownItem(_))));
}

#[test]
fn requested_items_are_drawn_and_named() {
    let drawing = Drawing::of(&Crane).title("A crane").forces().velocities().axes().floor(-0.5);
    let drawing = drawing.trace("tip", |_, _, [angle, _]| [2.0 * angle.cos(), 2.0 * angle.sin(), 0.0]);
    let moments = (0..10).map(|k| (0.1 * f64::from(k), [0.2 * f64::from(k), 1.0]));
    let pictures = drawing.pictures(moments).expect("draws");
    let texts = texts(&pictures[9]);
    for text in ["A crane", "box", "x", "y", "z", "tip", "not drawn: torque on φ"] {
        assert!(texts.iter().any(|known| known == text), "`{text}` is not among {texts:?}");
    }
    let inside = |mark: &Mark| match mark {
        Mark::Path { segments, .. } => crate::geometry::flattened(segments, 1)
            .iter()
            .all(|[x, y]| (0.0..=640.0).contains(x) && (0.0..=480.0).contains(y)),
        Mark::Text { at: [x, y], .. } => (0.0..=640.0).contains(x) && (0.0..=480.0).contains(y),
    };
    assert!(pictures.iter().flat_map(|picture| &picture.marks).all(inside));
    if let Ok(folder) = std::env::var("LAGRANGE_PICTURES") {
        pictures[9].save(format!("{folder}/crane.png")).expect("is written");
        let perspective = drawing.clone().perspective().frames().view(0.4, 0.3);
        perspective
            .picture(0.0, &[2.5, 1.0])
            .and_then(|p| p.save(format!("{folder}/crane2.png")))
            .expect("is written");
    }
}

#[test]
fn rods_go_to_joints_that_a_body_carries_only() {
    let joint = |name: &str, at, links: [Option<&str>; 2]| Joint {
        name: name.to_owned(),
        kind: Hold {
            kind: SpatialJointKind::Prismatic,
            axis: [0.0, 0.0, 1.0],
            links: links.map(|link| link.map(str::to_owned)),
        },
        at,
    };
    let link = |name: &str, origin| Link {
        name: name.to_owned(),
        origin,
        rotation: UPRIGHT,
        motion: Some(motion(UPRIGHT, origin, [0.0; 3])),
        parts: Vec::new(),
    };
    let scene = Snapshot {
        bodies: vec![link("slide", [0.0, 0.0, 0.5]), link("tip", [1.0, 0.0, 0.5])],
        joints: vec![
            joint("s", [0.0; 3], [None, Some("slide")]),
            joint("q", [1.0, 0.0, 0.5], [Some("slide"), Some("tip")]),
        ],
        ..Snapshot::default()
    };
    let reach = |link: &Link| {
        let mesh = Skeleton::of(&scene, 0.01).mesh(link).expect("is drawn");
        let along = |axis: usize| mesh.corners.iter().map(|corner| corner.at[axis].abs()).fold(0.0, f64::max);
        [along(0), along(2)]
    };
    let [across, down] = reach(&scene.bodies[0]);
    assert!(
        (across - 1.0).abs() < 1e-12 && down < 0.1,
        "to the joint that it carries, not to the one that carries it"
    );
    assert!(reach(&scene.bodies[1]).iter().all(|reach| *reach < 0.1));
}

#[test]
fn things_that_change_during_a_film_are_refused_by_name() {
    let with = |name: &str| Snapshot::<Spatial> {
        connectors: vec![Span {
            name: name.to_owned(),
            kind: Connector::Spring,
            ends: [[0.0; 3], [1.0, 0.0, 0.0]],
        }],
        ..Snapshot::default()
    };
    let (before, now) = (with("strut"), with("tie"));
    assert_eq!(difference(&before, &before), None);
    assert_eq!(difference(&before, &now), Some("strut".to_owned()));
    assert_eq!(difference(&Snapshot::default(), &now), Some("tie".to_owned()));
    // Notes about items that cannot be drawn may come and go.
    let noted = Snapshot { omitted: vec!["overlap".to_owned()], ..with("tie") };
    assert_eq!(difference(&now, &noted), None);
}

#[test]
fn hidden_and_infinite_items_are_refused_by_name() {
    let drawing = Drawing::of(&Crane);
    assert!(matches!(drawing.clone().hide("wheel").picture(0.0, &[0.0; 2]), Err(DrawError::UnknownItem(_))));
    match drawing.clone().picture(0.5, &[f64::NAN, 0.0]) {
        Err(DrawError::NotFinite { item, time, .. }) => assert_eq!((item.as_str(), time), ("arm", 0.5)),
        other => panic!("{other:?}"),
    }
    let without = drawing.hide("box").hide("hanger").picture(0.0, &[0.0; 2]).expect("draws");
    assert!(!texts(&without).iter().any(|text| text == "box"));
    assert!(matches!(Drawing::of(&Crane).size(20.0, 20.0).picture(0.0, &[0.0; 2]), Err(DrawError::Size(_))));
    assert!(matches!(
        Drawing::of(&Crane).view(f64::NAN, 0.0).picture(0.0, &[0.0; 2]),
        Err(DrawError::View(_))
    ));
    let astray = Drawing::of(&Crane).path("way", [[0.0; 3], [f64::INFINITY, 0.0, 0.0]]);
    match astray.picture(0.0, &[0.0; 2]) {
        Err(DrawError::NotFinite { item, .. }) => assert_eq!(item, "way"),
        other => panic!("{other:?}"),
    }
    let dot = Drawing::of(&Crane).path("way", [[0.0; 3]]);
    assert!(dot.picture(0.0, &[0.0; 2]).is_ok(), "a path of one point is none");
}
