//! Statements that declare surfaces and contacts on them.

use proc_macro2::Delimiter;

use super::ast::{Compliance, Contact, ContactDefaults, Name, Surface, SurfaceKind};
use super::blocks::BlockLabels;
use super::cursor::Cursor;
use super::messages;
use super::messages::forms::form;
use super::messages::scenes;
use super::parser::{Parsed, Parser, Reported};

impl Parser<'_> {
    /// Reads `name { on: body; through: e; angle: e; }` and similar statements.
    pub(super) fn surface(&mut self, kind: SurfaceKind, cursor: &mut Cursor) -> Parsed<Surface> {
        let help = form(kind.name());
        let name = self.scene_name(help, cursor)?;
        let origin = name.span.into();
        let group = self.braces(help, cursor)?;
        let mut surface = Surface::named(kind, name);
        let mut labels = BlockLabels::new(kind.described(), kind.labels());
        let complete = self.lines(&group, |parser, cursor| {
            let label = parser.label_of(&mut labels, cursor)?;
            if label == "height" {
                return parser.height(&mut surface, cursor);
            }
            parser.colon(label, cursor)?;
            match label {
                "on" => {
                    let name = parser.name(cursor)?;
                    surface.on = Some(parser.indexed(name, cursor)?);
                }
                label => *surface.value_mut(label) = Some(parser.line_value(cursor)),
            }
            Ok(())
        });
        for label in ["radius", "height"] {
            if !complete && kind.labels().contains(&label) {
                self.missing(surface.value_mut(label), origin);
            }
        }
        Ok(surface)
    }

    /// Reads `(x, y): e` after the label of a height. A space after the names of the coordinates
    /// distinguishes them from all names in a declaration; it does not matter in print.
    fn height(&mut self, surface: &mut Surface, cursor: &mut Cursor) -> Parsed<()> {
        let help = form("terrain");
        let Some(group) = cursor.eat_group(Delimiter::Parenthesis) else {
            let message = messages::expected("`(`", cursor.peek());
            return Err(self.fail_with_help(cursor.here(), message, help));
        };
        let names = self.inside(&group, |parser, cursor| parser.component_names("terrain", cursor))?;
        self.refuse_elements(&names)?;
        self.refuse_units(&names);
        if let Some(name) = names.iter().skip(1).find(|name| name.text == names[0].text) {
            return Err(self.fail_with_help(name.span, scenes::one_coordinate(&name.text), help));
        }
        if names.len() > 2 {
            return Err(self.fail_with_help(names[2].span, scenes::MANY_COORDINATES, help));
        }
        self.colon("height", cursor)?;
        let first = self.expressions.count();
        surface.height = Some(self.line_value(cursor));
        let is_coordinate = |text: &str| names.iter().any(|name| name.text == text);
        self.expressions.respell(first, |text| is_coordinate(text).then(|| format!("{text} ")));
        surface.coordinates =
            names.into_iter().map(|name| Name { text: format!("{} ", name.text), ..name }).collect();
        Ok(())
    }

    /// Reads `name = e on surface { friction: e; … }`, with or without the braces.
    pub(super) fn contact(&mut self, cursor: &mut Cursor) -> Parsed<Contact> {
        let help = form("contact");
        let name = self.declared_name(cursor)?;
        self.equals(help, cursor)?;
        let object = self.expression(cursor)?;
        let is_inside = cursor.eat_word("inside").is_some();
        if !is_inside {
            self.joining("on", scenes::CONTACT_HELP, cursor)?;
        }
        let surface = self.mentioned(help, cursor)?;
        let mut contact = Contact::between(name, object, surface, is_inside);
        match cursor.eat_group(Delimiter::Brace) {
            Some(group) => {
                let labels = BlockLabels::new("a contact", &Contact::LABELS);
                contact.is_incomplete = !self.values(&group, labels, &mut contact, Contact::value_mut);
                if !contact.is_incomplete {
                    self.check_coefficients(&contact)?;
                    self.check_axis(&contact)?;
                }
            }
            None if !cursor.at_statement_end() => return Err(self.misplaced("`{` or `;`", help, cursor)),
            None => {}
        }
        Ok(contact)
    }

    /// Checks that a contact has one coefficient of friction, or one for slipping and one for
    /// sticking.
    fn check_coefficients(&mut self, contact: &Contact) -> Parsed<()> {
        let name = &contact.name.text;
        let (value, message) = match (contact.friction, contact.kinetic, contact.fixed) {
            (Some(value), Some(_), _) | (Some(value), _, Some(_)) => (value, scenes::third_coefficient(name)),
            (None, Some(value), None) => (value, scenes::lonely_coefficient(name, "kinetic", "static")),
            (None, None, Some(value)) => (value, scenes::lonely_coefficient(name, "static", "kinetic")),
            _ => return Ok(()),
        };
        let origin = self.expressions.origin(value);
        self.fail_with_help(origin, message, scenes::COEFFICIENTS_HELP);
        Err(Reported)
    }

    /// Reads `contacts: rigid;` or `contacts: compliant { stiffness: k; … }`.
    pub(super) fn contact_defaults(&mut self, cursor: &mut Cursor) -> Parsed<ContactDefaults> {
        cursor.eat_ident();
        self.colon("contacts", cursor)?;
        let way = self.name(cursor)?;
        let mut compliance = Compliance::default();
        match way.text.as_str() {
            "rigid" => {}
            "compliant" => {
                let group = self.braces(form("contacts"), cursor)?;
                let labels = BlockLabels::new("compliant contacts", &Compliance::LABELS);
                let complete = self.values(&group, labels, &mut compliance, Compliance::value_mut);
                if complete && compliance.way().is_none() {
                    return Err(self.fail_with_help(way.span, scenes::NO_STIFFNESS, form("contacts")));
                }
            }
            "stepped" => return Err(self.fail_with_help(way.span, scenes::STEPPED, scenes::STEPPED_HELP)),
            other => return Err(self.fail_with_help(way.span, scenes::unknown_way(other), form("contacts"))),
        }
        Ok(ContactDefaults { way, compliance })
    }

    /// Checks that only a rim has an axis.
    fn check_axis(&mut self, contact: &Contact) -> Parsed<()> {
        let Some(axis) = contact.axis.filter(|_| contact.rim.is_none()) else { return Ok(()) };
        let origin = self.expressions.origin(axis);
        let message = scenes::without_rim(&contact.name.text);
        self.fail_with_help(origin, message, scenes::RIM_HELP);
        Err(Reported)
    }
}
