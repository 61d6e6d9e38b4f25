//! Planes, circles, spheres, cylinders and terrain that bodies touch.
//!
//! A plane has two perpendicular tangents with t₁ × t₂ = n. t₁ is the projection of the least
//! aligned coordinate axis, or the first of several. They are fixed in the carrier of the plane.

use super::constants::number;
use super::drawing::draw_surface;
use super::expressions::plain_expression;
use super::kinematics::point_of_body;
use super::lines::carrier;
use super::mass_geometry::{property, vector_of};
use super::messages;
use super::messages::contacts as words;
use super::object::{Height, Object, Surface};
use super::space::vectors::{Triple, cross, transposed, unit, zero_triple};
use super::space::{
    fixed_triple, frame_along, link_of, named_vector, place_on_link, triple_of, triple_of_numbers,
    vector_on_link, written,
};
use super::terms::TermWriter;
use super::translation::Translation;
use crate::syntax::ast::{self, AstId, Expression, Name, SurfaceKind};

pub(super) fn translate_surface(translation: &mut Translation<'_>, statement: &ast::Surface) {
    if !statement.kind.belongs_to(translation.space.is_some()) {
        let message = messages::only_in_space(statement.kind.name());
        translation.report.error(translation.origin, message).help(messages::NOT_IN_THE_PLANE_HELP);
        return declare_broken_surface(translation, statement);
    }
    let carrier = statement.on.as_ref().map(|on| carrier_of(translation, on));
    let own = own_surface(translation, statement);
    let Some(own) = own.filter(|_| carrier != Some(None)) else {
        return declare_broken_surface(translation, statement);
    };
    let surface = in_world(translation, &statement.name, own, carrier.flatten());
    draw_if_wanted(translation, &statement.name.text, &surface);
    translation.names.declare(&statement.name.text, Object::Surface(Box::new(surface)));
}

/// Draws a surface in the world, if there is a drawing.
pub(super) fn draw_if_wanted(translation: &mut Translation<'_>, name: &str, surface: &Surface) {
    if !translation.is_drawn {
        return;
    }
    let &Surface { kind, carrier, place, direction, tangents: [first, second], radius, .. } = surface;
    let mut values = match translation.space {
        None => {
            let angle = carrier.map(|body| translation.bodies[body].angle);
            let angle = angle.unwrap_or_else(|| translation.terms().number(0));
            vec![angle]
        }
        // A sphere has no axes.
        Some(_) if kind == SurfaceKind::Sphere => {
            let mut terms = translation.terms();
            [0, 1, 2].map(|axis| unit(&mut terms, axis)).map(|axis| terms.vector(&axis)).to_vec()
        }
        Some(_) => {
            transposed([first, second, direction]).map(|row| translation.terms().vector(&row)).to_vec()
        }
    };
    values.insert(0, scene_vector(translation, place));
    if kind.labels().contains(&"radius") {
        values.push(radius);
    }
    let height = surface.height.as_ref().map(|height| height_of_variables(translation, height));
    draw_surface(translation, name, (kind, carrier), values, height);
}

/// Returns a height as a function of new variables.
fn height_of_variables(translation: &mut Translation<'_>, height: &Height) -> (Vec<String>, AstId) {
    let names = height.coordinates.iter().map(|name| translation.new_name(name).text).collect::<Vec<_>>();
    let mut terms = translation.terms();
    let variables = names.iter().map(|name| terms.name(name)).collect::<Vec<_>>();
    let value = terms.with_values(height.value, &height.coordinates, &variables);
    (names, value)
}

/// Declares a surface with a reported error.
pub(super) fn declare_broken_surface(translation: &mut Translation<'_>, statement: &ast::Surface) {
    let radius = translation.terms().invalid();
    let [place, direction] = [[radius; 3]; 2];
    let (kind, tangents) = (statement.kind, [place; 2]);
    let (carrier, turning, length, height) = (None, radius, None, None);
    let surface = Surface { kind, carrier, place, direction, length, tangents, radius, height, turning };
    translation.names.declare(&statement.name.text, Object::Surface(Box::new(surface)));
}

/// Returns the body or link with this name; anything else is reported.
fn carrier_of(translation: &mut Translation<'_>, name: &Name) -> Option<usize> {
    match translation.space {
        Some(_) => link_of(translation, name),
        None => carrier(translation, name),
    }
}

/// Returns a surface in the coordinates of its carrier.
fn own_surface(translation: &mut Translation<'_>, statement: &ast::Surface) -> Option<Surface> {
    let ast::Surface { kind, name, place, direction, radius, .. } = statement;
    let place = own_place(translation, name, *place);
    let radius = own_radius(translation, *kind, name, *radius);
    let direction = own_direction(translation, *kind, name, *direction);
    let StatedDirection { unit: direction, tangents, length } = direction?;
    let height = own_height(translation, statement)?;
    let (kind, carrier, radius, turning) = (*kind, None, radius?, translation.terms().number(0));
    Some(Surface { kind, carrier, place, direction, length, tangents, radius, height, turning })
}

fn own_place(translation: &mut Translation<'_>, name: &Name, place: Option<AstId>) -> Triple {
    let zero = translation.terms().number(0);
    match place {
        None => [zero; 3],
        Some(place) if translation.space.is_some() => {
            triple_of(translation, place, &words::place_of(&name.text))
        }
        Some(place) => {
            let [x, y] = vector_of(translation, place, &words::place_of(&name.text));
            [x, y, zero]
        }
    }
}

fn own_radius(
    translation: &mut Translation<'_>,
    kind: SurfaceKind,
    name: &Name,
    radius: Option<AstId>,
) -> Option<AstId> {
    if !kind.labels().contains(&"radius") {
        return Some(translation.terms().number(0));
    }
    let Some(radius) = radius else {
        let message = words::surface_without_radius(kind.name(), &name.text);
        translation.report.error(name.span, message).help(words::SURFACE_RADIUS_HELP);
        return None;
    };
    let value = property(translation, radius, &words::radius_of(&name.text));
    let size = number(&translation.expressions, translation.names.constants(), value);
    if size.is_some_and(|size| size <= 0.0) {
        let origin = translation.expressions.origin(radius);
        let message = words::radius_not_positive(&name.text);
        translation.report.error(origin, message).help(words::SURFACE_RADIUS_HELP);
        return None;
    }
    Some(value)
}

/// Returns the height of a terrain, `Some(None)` for other surfaces; `None` after an error.
fn own_height(translation: &mut Translation<'_>, statement: &ast::Surface) -> Option<Option<Height>> {
    if statement.kind != SurfaceKind::Terrain {
        return Some(None);
    }
    let name = &statement.name;
    let Some(written) = statement.height else {
        let message = words::terrain_without_height(&name.text);
        let error = translation.report.error(name.span, message);
        error.help(match translation.space {
            Some(_) => words::HEIGHT_IN_SPACE_HELP,
            None => words::HEIGHT_IN_THE_PLANE_HELP,
        });
        return None;
    };
    let coordinates = statement.coordinates.iter().map(|name| name.text.clone()).collect::<Vec<_>>();
    if coordinates.is_empty() {
        // The coordinates could not be read.
        return None;
    }
    if coordinates.len() + 1 != translation.dimension() {
        let (message, help) = match translation.space {
            Some(_) => (words::height_in_space(&name.text), words::HEIGHT_IN_SPACE_HELP),
            None => (words::height_in_the_plane(&name.text), words::HEIGHT_IN_THE_PLANE_HELP),
        };
        translation.report.error(statement.coordinates[0].span, message).help(help);
        return None;
    }
    let value = plain_expression(translation, written);
    if let Expression::Tuple(_) = translation.expressions.get(value) {
        let origin = translation.expressions.origin(written);
        let message = words::height_not_scalar(&name.text);
        translation.report.error(origin, message).help(words::HEIGHT_NOT_SCALAR_HELP);
        return None;
    }
    let mut terms = translation.terms();
    // To find errors, any changing quantity can represent the coordinates.
    let values = coordinates.iter().map(|_| terms.name("t")).collect::<Vec<_>>();
    let mentioned = terms.with_values(value, &coordinates, &values);
    translation.mentioned.push(mentioned);
    translation.heights.push(mentioned);
    let fixed = translation.terms().number(0);
    let fixed = vec![fixed; coordinates.len()];
    let fixed = translation.terms().with_values(value, &coordinates, &fixed);
    Some(Some(Height { coordinates, value, is_fixed: translation.is_at_rest(fixed) }))
}

/// Returns the unit normal of a plane with its tangents, or the unit axis of a cylinder.
fn own_direction(
    translation: &mut Translation<'_>,
    kind: SurfaceKind,
    name: &Name,
    direction: Option<AstId>,
) -> Option<StatedDirection> {
    let length = None;
    if kind == SurfaceKind::Terrain {
        let is_spatial = translation.space.is_some();
        let mut terms = translation.terms();
        let [x, y, z] = [0, 1, 2].map(|axis| unit(&mut terms, axis));
        let (unit, tangents) = if is_spatial { (z, [x, y]) } else { (y, [x, z]) };
        return Some(StatedDirection { unit, tangents, length });
    }
    if !matches!(kind, SurfaceKind::Plane | SurfaceKind::Cylinder) {
        let zero = zero_triple(&mut translation.terms());
        return Some(StatedDirection { unit: zero, tangents: [zero; 2], length });
    }
    unit_direction(translation, name, kind.labels()[2], direction)
}

/// A unit direction with two tangents.
pub(super) struct StatedDirection {
    pub(super) unit: Triple,
    pub(super) tangents: [Triple; 2],
    /// The length of the stated vector, unless its components are numbers.
    pub(super) length: Option<AstId>,
}

/// Returns the direction of a vector; the third axis by default.
pub(super) fn unit_direction(
    translation: &mut Translation<'_>,
    name: &Name,
    label: &str,
    direction: Option<AstId>,
) -> Option<StatedDirection> {
    let Some(written_direction) = direction else {
        let mut terms = translation.terms();
        let [x, y, z] = [0, 1, 2].map(|axis| unit(&mut terms, axis));
        return Some(StatedDirection { unit: z, tangents: [x, y], length: None });
    };
    let vector = fixed_triple(translation, written_direction, &words::direction_of(&name.text));
    if let Some(numbers) = triple_of_numbers(translation, vector) {
        if numbers == [0.0; 3] {
            let origin = translation.expressions.origin(written_direction);
            translation
                .report
                .error(origin, words::zero_direction(label, &name.text))
                .help(words::ZERO_DIRECTION_HELP);
            return None;
        }
        let columns = transposed(written(&mut translation.terms(), frame_along(numbers)));
        let [x, y, z] = columns;
        let mut terms = translation.terms();
        let tangents = [y, x.map(|component| terms.negative(component))];
        return Some(StatedDirection { unit: z, tangents, length: None });
    }
    let mut terms = translation.terms();
    let whole = terms.vector(&vector);
    let length = terms.call("norm", &[whole]);
    let normal = vector.map(|component| terms.divide(component, length));
    let normal = bind_vector(translation, &format!("{}_direction", name.text), normal);
    let tangents = tangents_of(&mut translation.terms(), normal);
    Some(StatedDirection { unit: normal, tangents, length: Some(length) })
}

/// Returns two perpendicular directions whose cross product is the unit direction n. If a
/// coordinate axis is perpendicular to n, they are this axis and its cross product with n.
/// Otherwise they are Frisvad's, which are only singular at n = −e_z.
///
/// Source: Frisvad, *Building an orthonormal basis from a 3D unit vector without normalization*
/// (2012), eq. 2.
pub(super) fn tangents_of(terms: &mut TermWriter<'_>, normal: Triple) -> [Triple; 2] {
    if let Some(axis) = (0..3).find(|&axis| terms.is_zero(normal[axis])) {
        let first = unit(terms, axis);
        return [first, cross(terms, normal, first)];
    }
    let one = terms.number(1);
    let [x, y, z] = normal;
    let below = terms.plus(one, z);
    let [along, across] = [x, y].map(|component| terms.divide(component, below));
    let (xx, xy, yy) = (terms.times(along, x), terms.times(along, y), terms.times(across, y));
    let (first, mixed, second) = (terms.minus(one, xx), terms.negative(xy), terms.minus(one, yy));
    let back = [terms.negative(x), terms.negative(y)];
    [[first, mixed, back[0]], [mixed, second, back[1]]]
}

/// Returns a surface, which a body or link may carry, in the world.
fn in_world(translation: &mut Translation<'_>, name: &Name, own: Surface, carrier: Option<usize>) -> Surface {
    let Some(body) = carrier else { return own };
    if translation.space.is_none() {
        let [x, y, zero] = own.place;
        let [x, y] = point_of_body(translation, body, [x, y]);
        let place = bind_vector(translation, &format!("{}_center", name.text), [x, y, zero]);
        let angle = translation.bodies[body].angle;
        let mut turned = |[x, y, out]: Triple| {
            let [x, y] = translation.terms().turned([x, y], angle);
            [x, y, out]
        };
        let (direction, tangents) = (turned(own.direction), own.tangents.map(&mut turned));
        return Surface { carrier, place, direction, tangents, ..own };
    }
    let place = place_on_link(translation, body, own.place);
    let place = bind_vector(translation, &format!("{}_place", name.text), place);
    let mut turned = |part: &str, vector: Triple| {
        let world = vector_on_link(translation, body, vector);
        bind_vector(translation, &format!("{}_{part}", name.text), world)
    };
    let direction = turned("direction", own.direction);
    let [first, second] = own.tangents;
    let tangents = [turned("tangent_1", first), turned("tangent_2", second)];
    Surface { carrier, place, direction, tangents, ..own }
}

/// Returns a vector with the dimension of the scene.
pub(super) fn scene_vector(translation: &mut Translation<'_>, vector: Triple) -> AstId {
    match translation.space {
        Some(_) => translation.terms().vector(&vector),
        None => translation.terms().tuple([vector[0], vector[1]]),
    }
}

/// Returns a vector under a name, unless its components need none; in the plane its first two
/// components.
pub(super) fn bind_vector(translation: &mut Translation<'_>, wish: &str, vector: Triple) -> Triple {
    if translation.space.is_some() {
        return named_vector(translation, wish, vector);
    }
    let [x, y, zero] = vector;
    let is_atom = |id: AstId| {
        use Expression::{Component, Invalid, Name, Number};
        matches!(translation.expressions.get(id), Number(_) | Name(_) | Component(..) | Invalid)
    };
    if [x, y].into_iter().all(is_atom) {
        return vector;
    }
    let pair = translation.terms().tuple([x, y]);
    let name = translation.bind_optionally(wish, pair);
    let [x, y] = translation.terms().pair(name);
    [x, y, zero]
}
