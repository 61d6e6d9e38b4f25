//! Items that cannot be drawn are refused by name.

use lagrange::body::Motion;
use lagrange::draw::{DrawError, Drawing, Picture};
use lagrange::scene::{Connector, Item, Joint, LoadOrigin, Outline};

use crate::scenes::{Items, LADDER, Puppet, SLOPE, line, part, still};

fn refused(result: Result<Picture, DrawError>) -> String {
    result.expect_err("cannot be drawn").to_string()
}

/// A plate whose position is the coordinate, beside items that are not finite if it is zero.
const BROKEN: Puppet = Puppet(|s, visit| {
    let motion = Motion { velocity: [0.0, 1.0 / s], ..still([0.0, 0.0], 0.0) };
    visit(Item::Body { name: "plate", motion, parts: &[part(Outline::Rectangle(1.0, 1.0))] });
    visit(Item::Force {
        name: "N",
        cause: LoadOrigin::Joint,
        body: Some("plate"),
        at: [0.0, 0.0],
        force: [1.0 / s, 0.0],
    });
});

#[test]
fn an_arrow_without_end_is_refused_only_if_it_is_wanted() {
    assert!(Drawing::of(&BROKEN).picture(0.0, &[0.0, 0.0]).is_ok());
    let velocity = Drawing::of(&BROKEN).velocities().picture(2.5, &[0.0, 0.0]);
    assert_eq!(refused(velocity), "the velocity of `plate` is not finite at time 2.5");
    let force = Drawing::of(&BROKEN).forces().picture(0.0, &[0.0, 0.0]);
    assert_eq!(refused(force), "the force of `N` is not finite at time 0");
    assert!(Drawing::of(&BROKEN).velocities().forces().picture(0.0, &[1.0, 0.0]).is_ok());
}

#[test]
fn a_state_that_is_not_a_number_is_refused_by_the_first_item_that_shows_it() {
    let picture = Drawing::of(&LADDER).picture(1.0, &[f64::NAN, 0.0]);
    assert_eq!(refused(picture), "the position or shape of `left` is not finite at time 1");
    let film = [(0.0, [1.0, 0.0]), (1.0, [f64::INFINITY, 0.0])];
    assert!(matches!(Drawing::of(&LADDER).pictures(film), Err(DrawError::NotFinite { time: 1.0, .. })));
}

#[test]
fn every_kind_of_item_is_checked() {
    let broken: [(&str, Items); 6] = [
        ("line", |x, visit| visit(line("line", [0.0, 0.0], x))),
        ("spring", |x, visit| {
            let kind = Connector::Spring;
            visit(Item::Connector { name: "spring", kind, from: [0.0, 0.0], to: [x, 0.0], tension: 0.0 });
        }),
        ("pin", |x, visit| visit(Item::Joint { name: "pin", kind: Joint::Pin, at: [x, 0.0] })),
        ("moment", |x, visit| {
            let cause = LoadOrigin::Applied;
            visit(Item::Moment { name: "moment", cause, body: None, at: [0.0, 0.0], moment: x });
        }),
        ("triangle", |x, visit| {
            // No triangle has such sides, at any state.
            let parts = [part(Outline::Triangle(1.0, 1.0, 3.0 + 0.0 * x))];
            visit(Item::Body { name: "triangle", motion: still([0.0, 0.0], 0.0), parts: &parts });
        }),
        ("polygon", |x, visit| {
            let parts = [part(Outline::RegularPolygon(4.5 + 0.0 * x, 1.0))];
            visit(Item::Body { name: "polygon", motion: still([0.0, 0.0], 0.0), parts: &parts });
        }),
    ];
    for (name, items) in broken {
        let message = refused(Drawing::of(&Puppet(items)).forces().picture(0.0, &[f64::NAN, 0.0]));
        assert!(message.contains(&format!("`{name}` is not finite")), "{message}");
    }
}

#[test]
fn annotations_are_checked_too() {
    let drawing = Drawing::of(&LADDER).annotate(|sketch, _| {
        sketch.point([f64::INFINITY, 0.0], "P");
    });
    assert_eq!(refused(drawing.picture(0.0, &[1.0, 0.0])), "the point of `P` is not finite at time 0");
}

#[test]
fn unknown_bodies_empty_scenes_and_impossible_sizes_are_refused() {
    let unknown = Drawing::of(&SLOPE).free_body("sphere").picture(0.0, &[0.0, 0.0]);
    assert_eq!(refused(unknown), "the scene has no body `sphere`");
    let hidden = Drawing::of(&SLOPE).hide("slop").picture(0.0, &[0.0, 0.0]);
    assert_eq!(refused(hidden), "the scene has nothing named `slop`");
    let lettered = Drawing::of(&SLOPE).forces().letter("R", "A").picture(0.0, &[0.0, 0.0]);
    assert_eq!(refused(lettered), "the scene has nothing named `R`", "only a free body has resultants");
    let empty = Puppet(|_, _| {});
    assert_eq!(refused(Drawing::of(&empty).picture(0.0, &[0.0, 0.0])), "there is nothing to draw");
    for size in [[20.0, 300.0], [300.0, 0.0], [-300.0, 300.0], [f64::NAN, 300.0], [300.0, f64::INFINITY]] {
        let drawing = Drawing::of(&SLOPE).size(size[0], size[1]);
        assert!(matches!(drawing.picture(0.0, &[0.0, 0.0]), Err(DrawError::Size(_))), "{size:?}");
    }
}

#[test]
fn a_body_that_does_not_turn_has_no_centre() {
    let still = Puppet(|s, visit| {
        let motion = Motion { velocity: [1.0, 0.0], ..still([s, 0.0], 0.0) };
        visit(Item::Body { name: "plate", motion, parts: &[part(Outline::Rectangle(1.0, 1.0))] });
    });
    let plain = Drawing::of(&still).picture(0.0, &[0.0, 0.0]).expect("draws");
    let centers = Drawing::of(&still).centers().picture(0.0, &[0.0, 0.0]).expect("draws");
    assert_eq!(plain, centers);
}
