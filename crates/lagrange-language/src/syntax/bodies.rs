//! Statements that declare rigid bodies.

use proc_macro2::{Delimiter, Group, TokenTree};

use super::ast::{AstId, Body, Name, Part, Shape};
use super::blocks::{BlockLabels, at_label};
use super::cursor::{Cursor, group_origin};
use super::messages;
use super::messages::forms::form;
use super::messages::scenes;
use super::parser::{Parsed, Parser};
use super::recovery::Turn;

/// Labels in the description of a body.
const BODY: &[&str] = &[
    "mass", "inertia", "center", "origin", "centroid", "angle", "angles", "sequence", "shape", "compound",
    "visual",
];
/// Number of components of a tensor of inertia.
const TENSOR: usize = 6;
/// Labels of a part of a compound, after its shape.
const PART: &[&str] = &["mass", "at", "angle", "turned"];

impl Parser<'_> {
    /// Reads `name { mass: e; … }`.
    pub(super) fn body(&mut self, cursor: &mut Cursor) -> Parsed<Body> {
        let name = self.scene_name(form("body"), cursor)?;
        let group = self.braces(form("body"), cursor)?;
        let mut body = empty_body(name);
        let mut labels = BlockLabels::new("a body", BODY);
        let complete = self.lines(&group, |parser, cursor| parser.body_line(&mut body, &mut labels, cursor));
        if !complete {
            self.complete_body(&mut body);
        }
        Ok(body)
    }

    fn body_line(&mut self, body: &mut Body, labels: &mut BlockLabels, cursor: &mut Cursor) -> Parsed<()> {
        let label = self.label_of(labels, cursor)?;
        if label == "compound" {
            body.parts = self.parts(scenes::COMPOUND_HELP, cursor)?;
            return Ok(());
        }
        if label == "visual" {
            body.visuals = self.parts(scenes::VISUAL_HELP, cursor)?;
            return Ok(());
        }
        self.colon(label, cursor)?;
        if label == "shape" {
            body.shape = Some(self.shape(cursor)?);
            return Ok(());
        }
        if label == "sequence" {
            body.sequence = Some(self.sequence(cursor)?);
            return Ok(());
        }
        if label == "inertia" && at_tensor(cursor) {
            body.tensor = Some(self.tensor(cursor)?);
            return Ok(());
        }
        if label == "inertia" && cursor.group(Delimiter::Bracket).is_some() {
            return Err(self.fail_with_help(cursor.here(), scenes::MATRIX, scenes::MATRIX_HELP));
        }
        let value = Some(self.line_value(cursor));
        match label {
            "mass" => body.mass = value,
            "inertia" => body.inertia = value,
            "center" => body.center = value,
            "origin" => body.origin = value,
            "centroid" => body.centroid = value,
            "angles" => body.angles = value,
            _ => body.angle = value,
        }
        Ok(())
    }

    /// Reads `zxz`: axes of three rotations, one after the other.
    fn sequence(&mut self, cursor: &mut Cursor) -> Parsed<Name> {
        let letters = self.name(cursor)?;
        let axes = letters.text.as_bytes();
        let is_sequence = axes.len() == 3
            && axes.iter().all(|axis| b"xyz".contains(axis))
            && axes.windows(2).all(|pair| pair[0] != pair[1]);
        match is_sequence {
            true => Ok(letters),
            false => {
                let message = scenes::no_sequence(&letters.text);
                Err(self.fail_with_help(letters.span, message, scenes::SEQUENCE_HELP))
            }
        }
    }

    /// Reads `(xx, yy, zz, xy, xz, yz)`.
    fn tensor(&mut self, cursor: &mut Cursor) -> Parsed<[AstId; TENSOR]> {
        let here = cursor.here();
        let Some(group) = cursor.eat_group(Delimiter::Parenthesis) else {
            let message = messages::expected("`(`", cursor.peek());
            return Err(self.fail_with_help(here, message, scenes::TENSOR_HELP));
        };
        let components = self.arguments(&group, Vec::new())?;
        let count = components.len();
        let tensor = components.try_into();
        tensor.map_err(|_| self.fail_with_help(here, scenes::tensor_count(count), scenes::TENSOR_HELP))
    }

    /// Completes a body. Missing values may be those that could not be read, so they are not
    /// reported.
    fn complete_body(&mut self, body: &mut Body) {
        let origin = body.name.span.into();
        if body.parts.is_empty() {
            self.missing(&mut body.mass, origin);
        }
        if body.parts.is_empty() && body.tensor.is_none() {
            self.missing(&mut body.inertia, origin);
        }
        if body.origin.is_none() && body.angles.is_none() {
            self.missing(&mut body.center, origin);
        }
        if body.angles.is_some() && body.sequence.is_none() {
            body.sequence = Some(Name { text: "zxz".to_owned(), ..body.name.clone() });
        }
    }

    /// Reads `solid(e, e)`.
    fn shape(&mut self, cursor: &mut Cursor) -> Parsed<Shape> {
        let start = cursor.position();
        if cursor.ident().is_none() {
            let message = messages::expected("the name of a solid", cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, scenes::SOLID_HELP));
        }
        let solid = self.name(cursor)?;
        let Some(group) = cursor.eat_group(Delimiter::Parenthesis) else {
            let message = messages::expected("`(`", cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, scenes::SOLID_HELP));
        };
        let dimensions = self.arguments(&group, Vec::new())?;
        Ok(Shape { solid, dimensions, origin: cursor.since(start) })
    }

    /// Reads `compound { disk(r), mass: m; }` or `visual { disk(r); }`, from the brace on.
    fn parts(&mut self, help: &str, cursor: &mut Cursor) -> Parsed<Vec<Part>> {
        if cursor.at(':') {
            let message = messages::expected("`{`", cursor.peek());
            self.report.error(cursor.skip_one(), message).help(help);
        }
        let group = self.braces(help, cursor)?;
        if group.stream().is_empty() {
            let error = self.report.error(group_origin(&group), scenes::EMPTY_COMPOUND);
            error.help(help);
        }
        let mut parts = Vec::new();
        self.lines(&group, |parser, cursor| {
            parts.push(parser.part(cursor)?);
            Ok(())
        });
        self.skipped = false;
        Ok(parts)
    }

    /// Reads `hole disk(r), mass: m, at: (a, b), angle: e`.
    fn part(&mut self, cursor: &mut Cursor) -> Parsed<Part> {
        let (start, mistakes) = (cursor.position(), self.report.diagnostics().len());
        let is_hole = cursor.eat_word("hole").is_some();
        let shape = self.shape(cursor)?;
        let origin = shape.origin;
        let mut part = Part { is_hole, shape, mass: None, at: None, angle: None, turned: None, origin };
        let mut labels = BlockLabels::new("a part", PART);
        self.turns(cursor, |parser, cursor| {
            if !parser.comma(cursor) || cursor.at(';') || cursor.at_end() {
                return Ok(Turn::Last);
            }
            if parser.part_item(&mut part, &mut labels, cursor).is_err() {
                parser.skip_item(cursor);
            }
            Ok(Turn::Next)
        })?;
        if self.report.diagnostics().len() > mistakes {
            self.missing(&mut part.mass, origin);
        }
        part.origin = cursor.since(start);
        Ok(part)
    }

    /// Consumes a comma; before a label, it is missing.
    fn comma(&mut self, cursor: &mut Cursor) -> bool {
        let is_missing = at_label(cursor);
        if is_missing {
            let message = messages::expected("`,`", cursor.peek());
            self.fail_with_help(cursor.here(), message, scenes::COMPOUND_HELP);
        }
        is_missing || cursor.eat(',').is_some()
    }

    fn part_item(&mut self, part: &mut Part, labels: &mut BlockLabels, cursor: &mut Cursor) -> Parsed<()> {
        let label = self.label_of(labels, cursor)?;
        self.colon(label, cursor)?;
        let value = Some(self.item_value(cursor));
        match label {
            "mass" => part.mass = value,
            "at" => part.at = value,
            "turned" => part.turned = value,
            _ => part.angle = value,
        }
        Ok(())
    }
}

/// True before parentheses with more components than a vector.
fn at_tensor(cursor: &Cursor) -> bool {
    let is_comma = |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == ',');
    let commas = |group: &Group| {
        let tokens = group.stream().into_iter().collect::<Vec<_>>();
        tokens.split(is_comma).filter(|component| !component.is_empty()).count()
    };
    cursor.group(Delimiter::Parenthesis).is_some_and(|group| commas(group) > 3)
}

fn empty_body(name: Name) -> Body {
    Body {
        name,
        mass: None,
        inertia: None,
        tensor: None,
        center: None,
        origin: None,
        centroid: None,
        angle: None,
        angles: None,
        sequence: None,
        shape: None,
        parts: Vec::new(),
        visuals: Vec::new(),
    }
}
