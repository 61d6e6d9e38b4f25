//! A motion in space as things: the appearance of each, and its placement at each moment.

use super::mesh::{Corner, Mesh, Placement};
use super::vector::Vector;
use crate::error::DrawError;
use crate::geometry::{bounds, length, mix, subtract};
use crate::picture::Colour;

/// Everything drawn of a motion. It is the source of pictures, pages and glTF files.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Recording {
    /// Times of the moments.
    pub(crate) times: Vec<f64>,
    pub(crate) things: Vec<MovingMesh>,
    pub(crate) traces: Vec<Trace>,
    /// Description of loads that act but are not drawn; empty if there are none.
    pub(crate) note: String,
}

/// A mesh that rotates, moves and is stretched, with the same corners and faces at all moments.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct MovingMesh {
    /// Name in messages and files.
    pub(crate) name: String,
    /// Label and its position; `None` if there is none.
    pub(crate) label: Option<Label>,
    pub(crate) colour: Colour,
    pub(crate) kind: Kind,
    pub(crate) mesh: Mesh,
    /// Placement at each moment.
    pub(crate) track: Vec<Placement>,
}

/// The kind of a thing.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Kind {
    Body,
    Connector,
    Joint,
    Arrow,
    /// A surface, a floor, or a fixed line.
    Surroundings,
}

#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Label {
    /// Text in the notation of formulas.
    pub(crate) text: String,
    /// Position in the axes of the thing.
    pub(crate) at: Corner,
}

/// The path of a point, drawn at each moment up to its current position.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Trace {
    pub(crate) label: String,
    pub(crate) colour: Colour,
    /// Positions of the point before the first moment, and at each moment.
    pub(crate) past: Vec<Vector>,
    pub(crate) points: Vec<Vector>,
}

impl Label {
    /// Creates a label at a point of a thing, with a share of the stretch; none if the text is
    /// empty.
    pub(super) fn new(text: String, at: Vector, share: f64) -> Option<Label> {
        (!text.is_empty()).then_some(Label { text, at: Corner { at, share } })
    }
}

impl Recording {
    /// Reports an error for numbers that are not finite.
    pub(super) fn checked(self) -> Result<Recording, DrawError> {
        for (moment, &time) in self.times.iter().enumerate() {
            let wrong = self.things.iter().find(|thing| !thing.is_finite_at(moment));
            let wrong = wrong.map(|thing| (thing.name.clone(), thing.kind.what()));
            let is_off = |trace: &&Trace| !trace.until(moment).flatten().all(f64::is_finite);
            let wrong = wrong.or_else(|| self.traces.iter().find(is_off).map(|t| (t.label.clone(), "path")));
            if let Some((item, what)) = wrong {
                return Err(DrawError::NotFinite { item, what, time });
            }
        }
        if self.places().next().is_none() {
            return Err(DrawError::NothingToDraw);
        }
        Ok(self)
    }

    /// Returns the middle of everything ever visible, and its radius about the middle; 1 if
    /// everything is at one point.
    pub(super) fn ball(&self) -> (Vector, f64) {
        let [low, high] = bounds(self.places());
        let middle = mix(low, high, 0.5);
        let radius = self.places().map(|place| length(subtract(place, middle))).fold(0.0, f64::max);
        (middle, if radius > 0.0 { radius } else { 1.0 })
    }

    /// Returns the positions of all visible corners at all moments.
    pub(super) fn places(&self) -> impl Iterator<Item = Vector> + '_ {
        let of_thing = |thing: &'_ MovingMesh| {
            let shown = thing.track.iter().filter(|placement| placement.scale > 0.0);
            shown.flat_map(|placement| thing.mesh.corners.iter().map(|c| placement.of(c))).collect::<Vec<_>>()
        };
        let traces = self.traces.iter().flat_map(|trace| trace.past.iter().chain(&trace.points).copied());
        self.things.iter().flat_map(of_thing).chain(traces)
    }
}

impl MovingMesh {
    fn is_finite_at(&self, moment: usize) -> bool {
        let corners = || self.mesh.corners.iter().flat_map(|corner| corner.at);
        self.track[moment].is_finite() && (moment > 0 || corners().all(f64::is_finite))
    }
}

impl Kind {
    fn what(self) -> &'static str {
        match self {
            Kind::Body => "position or shape",
            Kind::Connector => "end",
            Kind::Joint => "position of the joint",
            Kind::Arrow => "arrow",
            Kind::Surroundings => "place",
        }
    }
}

impl Trace {
    /// Returns the points drawn at a moment.
    pub(crate) fn until(&self, moment: usize) -> impl Iterator<Item = Vector> + '_ {
        self.past.iter().chain(&self.points[..=moment]).copied()
    }
}
