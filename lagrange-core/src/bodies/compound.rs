//! Bodies made of parts, holes among them.
//!
//! M = Σ ±mᵢ, M r_S = Σ ±mᵢ rᵢ, J = Σ ±(Jᵢ + mᵢ |rᵢ − r_S|²) by Steiner's theorem, holes with the lower sign.

use super::body::MassGeometry;
use super::messages;
use super::plain::Outline;
use super::terms::Pair;
use super::translation::Translation;
use crate::solids::Solid;
use crate::syntax::ast;
use crate::syntax::ast::{AstId, Part};

/// A part with what is known of it.
struct CompoundPart {
    is_hole: bool,
    mass: AstId,
    /// About its own centre of mass.
    inertia: AstId,
    /// Its centre of mass in the body's coordinates.
    centroid: Pair,
    outline: Outline,
}

impl Translation<'_> {
    pub(super) fn compound(&mut self, statement: &ast::Body) -> MassGeometry {
        self.report_beside_compound(statement);
        let pieces =
            statement.parts.iter().map(|part| self.piece(&statement.name.text, part)).collect::<Vec<_>>();
        let Some(pieces) = pieces.into_iter().collect::<Option<Vec<_>>>() else {
            let invalid = self.terms().invalid();
            let (centroid, outlines) = ([invalid, invalid], Vec::new());
            return MassGeometry { mass: invalid, inertia: Some(invalid), centroid, outlines, radius: None };
        };
        let name = &statement.name.text;
        let mass = self.sum(&pieces, |_, piece| piece.mass);
        let mass = self.bind(&format!("{name}_mass"), mass);
        self.obligations.push(super::Obligation::PositiveMass { body: statement.name.clone(), mass });
        let centroid = self.common_centroid(name, &pieces, mass);
        let inertia = self.sum(&pieces, |translation, piece| {
            let mut terms = translation.terms();
            let arm = terms.minus_pair(piece.centroid, centroid);
            let square = terms.squared_length(arm);
            let moved = terms.times(piece.mass, square);
            terms.plus(piece.inertia, moved)
        });
        let inertia = self.bind(&format!("{name}_inertia"), inertia);
        let outlines = pieces.into_iter().map(|piece| piece.outline).collect();
        MassGeometry { mass, inertia: Some(inertia), centroid, outlines, radius: None }
    }

    fn report_beside_compound(&mut self, statement: &ast::Body) {
        let given =
            [("mass", statement.mass), ("inertia", statement.inertia), ("centroid", statement.centroid)];
        for (label, id) in given.into_iter().filter_map(|(label, id)| Some((label, id?))) {
            let error = self.report.error(self.expressions.origin(id), messages::beside_compound(label));
            error.help(messages::BESIDE_COMPOUND_HELP);
        }
        if let Some(shape) = &statement.shape {
            let error = self.report.error(shape.origin, messages::beside_compound("shape"));
            error.help(messages::BESIDE_COMPOUND_HELP);
        }
    }

    fn piece(&mut self, body: &str, part: &Part) -> Option<CompoundPart> {
        let shape = self.shape(&part.shape);
        let mass = self.mass_of_part(part);
        let at = match part.at {
            Some(at) => self.fixed_vector(at, messages::PLACE_OF_PART),
            None => self.terms().zero_pair(),
        };
        let angle = match part.angle {
            Some(angle) => self.property(angle, messages::ANGLE_OF_PART),
            None => self.terms().number(0),
        };
        let (solid, dimensions): (&'static Solid, Vec<AstId>) = shape?;
        let place = part.shape.origin;
        let (mass, inertia) = (mass?, self.inertia_of(solid, mass?, &dimensions, place));
        let name = format!("{body}_{}", solid.name);
        let own = self.named_centroid(&name, Some(&(solid, dimensions.clone())), place);
        let centroid = self.placed(&name, own, at, angle);
        let mut terms = self.terms();
        let outline = Outline {
            solid: solid.name.to_owned(),
            dimensions,
            at: terms.tuple(at),
            angle,
            is_hole: part.is_hole,
        };
        Some(CompoundPart { is_hole: part.is_hole, mass, inertia, centroid, outline })
    }

    /// Where the centre of mass of a part is in the body's coordinates, under a name of its own where the part is turned.
    fn placed(&mut self, name: &str, own: Pair, at: Pair, angle: AstId) -> Pair {
        let mut terms = self.terms();
        let arm = terms.turned(own, angle);
        let centroid = terms.plus_pair(at, arm);
        if arm == own {
            return centroid;
        }
        let centroid = terms.tuple(centroid);
        let centroid = self.bind(&format!("{name}_center"), centroid);
        self.terms().pair(centroid)
    }

    fn mass_of_part(&mut self, part: &Part) -> Option<AstId> {
        let Some(mass) = part.mass else {
            let error = self.report.error(part.origin, messages::PART_WITHOUT_MASS);
            error.help(messages::PART_WITHOUT_MASS_HELP);
            return None;
        };
        let body = part.shape.solid.clone();
        let mass = self.property(mass, &messages::mass_of(&body.text));
        self.obligations.push(super::Obligation::PositiveMass { body, mass });
        Some(mass)
    }

    /// Σ ± over the parts.
    fn sum(
        &mut self,
        pieces: &[CompoundPart],
        mut term: impl FnMut(&mut Self, &CompoundPart) -> AstId,
    ) -> AstId {
        let mut sum = self.terms().number(0);
        for piece in pieces {
            let term = term(self, piece);
            let mut terms = self.terms();
            sum = if piece.is_hole { terms.minus(sum, term) } else { terms.plus(sum, term) };
        }
        sum
    }

    /// The common centre of mass, each component under a name of its own unless it is zero.
    fn common_centroid(&mut self, name: &str, pieces: &[CompoundPart], mass: AstId) -> Pair {
        [("x", 0), ("y", 1)].map(|(axis, index)| {
            let moment = self.sum(pieces, |translation, piece| {
                translation.terms().times(piece.mass, piece.centroid[index])
            });
            if self.terms().is_zero(moment) {
                return moment;
            }
            let quotient = self.terms().divide(moment, mass);
            self.bind(&format!("{name}_centroid_{axis}"), quotient)
        })
    }
}
