//! Statements about rigid bodies as text.

use super::Printer;
use crate::syntax::ast::{
    AstId, Body, Connector, Contact, ContactDefaults, Joint, JointKind, Mobilizer, MobilizerKind, Part,
    SceneStatement, Shape, Surface,
};

impl Printer<'_> {
    pub(super) fn scene(&mut self, statement: &SceneStatement) {
        match statement {
            SceneStatement::Gravity(value) => self.between("gravity = ", *value, ";"),
            SceneStatement::Body(body) => self.body(body),
            SceneStatement::Frame(name) => {
                self.text("frame ");
                self.name(name);
                self.text(";");
            }
            SceneStatement::Surface(surface) => self.surface(surface),
            SceneStatement::Contact(contact) => self.contact(contact),
            SceneStatement::Contacts(defaults) => self.contact_defaults(defaults),
            SceneStatement::Connector(connector) => self.connector(connector),
            SceneStatement::Joint(joint) => self.joint(joint),
            SceneStatement::Mobilizer(joint) => self.mobilizer(joint),
        }
    }

    /// Prints ` label: value;` for each given value.
    fn given<'a>(&mut self, values: impl IntoIterator<Item = (&'a str, Option<AstId>)>) {
        for (label, value) in values {
            if let Some(value) = value {
                self.text(&format!(" {label}: "));
                self.expression(value);
                self.text(";");
            }
        }
    }

    fn body(&mut self, body: &Body) {
        self.text("body ");
        self.name(&body.name);
        self.text(" {");
        self.given([("mass", body.mass), ("inertia", body.inertia)]);
        if let Some(tensor) = &body.tensor {
            self.text(" inertia: (");
            self.list(tensor, |printer, component| printer.expression(*component));
            self.text(");");
        }
        self.given([
            ("center", body.center),
            ("origin", body.origin),
            ("centroid", body.centroid),
            ("angle", body.angle),
            ("angles", body.angles),
        ]);
        if let Some(sequence) = &body.sequence {
            self.text(&format!(" sequence: {};", sequence.text));
        }
        if let Some(shape) = &body.shape {
            self.text(" shape: ");
            self.shape(shape);
            self.text(";");
        }
        for (label, parts) in [("compound", &body.parts), ("visual", &body.visuals)] {
            if !parts.is_empty() {
                self.text(&format!(" {label} {{"));
                parts.iter().for_each(|part| self.part(part));
                self.text(" }");
            }
        }
        self.text(" }");
    }

    fn shape(&mut self, shape: &Shape) {
        self.text(&shape.solid.text);
        self.text("(");
        self.list(&shape.dimensions, |printer, dimension| printer.expression(*dimension));
        self.text(")");
    }

    fn part(&mut self, part: &Part) {
        self.text(if part.is_hole { " hole " } else { " " });
        self.shape(&part.shape);
        let given = [("mass", part.mass), ("at", part.at), ("angle", part.angle), ("turned", part.turned)];
        for (label, value) in given {
            if let Some(value) = value {
                self.text(&format!(", {label}: "));
                self.expression(value);
            }
        }
        self.text(";");
    }

    fn surface(&mut self, surface: &Surface) {
        self.text(surface.kind.name());
        self.text(" ");
        self.name(&surface.name);
        self.text(" {");
        if let Some(on) = &surface.on {
            self.text(" on: ");
            self.name(on);
            self.text(";");
        }
        let names = surface.coordinates.iter().map(|name| name.text.trim_end()).collect::<Vec<_>>();
        let height = format!("height({})", names.join(", "));
        let label = |label| if label == "height" { height.as_str() } else { label };
        self.given(surface.values().into_iter().map(|(known, value)| (label(known), value)));
        self.text(" }");
    }

    fn contact(&mut self, contact: &Contact) {
        self.text("contact ");
        self.name(&contact.name);
        self.labelled(" = ", contact.object);
        self.text(if contact.is_inside { " inside " } else { " on " });
        self.name(&contact.surface);
        self.text(" {");
        self.given(contact.values());
        self.text(" }");
    }

    fn contact_defaults(&mut self, defaults: &ContactDefaults) {
        self.text("contacts: ");
        self.name(&defaults.way);
        if defaults.compliance.way().is_none() {
            return self.text(";");
        }
        self.text(" {");
        self.given(defaults.compliance.values());
        self.text(" }");
    }

    fn connector(&mut self, connector: &Connector) {
        self.text(connector.kind.name());
        if let Some(name) = &connector.name {
            self.text(" ");
            self.name(name);
        }
        self.text(" {");
        self.given([
            ("from", connector.from),
            ("to", connector.to),
            ("stiffness", connector.stiffness),
            ("rest", connector.rest),
            ("damping", connector.damping),
        ]);
        self.text(" }");
    }

    fn joint(&mut self, joint: &Joint) {
        let word = match joint.kind {
            JointKind::Pin { .. } => "pin ",
            JointKind::Slide { .. } => "slide ",
            JointKind::Roll { .. } => "roll ",
        };
        self.text(word);
        if let Some(name) = &joint.name {
            self.name(name);
            self.text(" = ");
        }
        match &joint.kind {
            JointKind::Pin { first, second } => {
                self.expression(*first);
                self.labelled(" to ", *second);
            }
            JointKind::Slide { point, line } => {
                self.expression(*point);
                self.text(" on ");
                self.name(line);
            }
            JointKind::Roll { body, line, radius } => {
                self.name(body);
                self.text(" on ");
                self.name(line);
                radius.iter().for_each(|radius| self.labelled(", radius: ", *radius));
            }
        }
        self.text(";");
    }

    fn mobilizer(&mut self, joint: &Mobilizer) {
        self.text(joint.kind.name());
        self.text(" ");
        if joint.kind == MobilizerKind::Free {
            self.name(&joint.outboard);
            return self.text(";");
        }
        if let Some(quaternion) = &joint.quaternion {
            self.name(&quaternion.name);
            self.text(" = ");
        }
        match joint.coordinates.as_slice() {
            [] => {}
            [only] => {
                self.name(only);
                self.text(" = ");
            }
            several => {
                self.text("(");
                self.list(several, Self::name);
                self.text(") = ");
            }
        }
        self.name(&joint.inboard);
        self.text(" to ");
        self.name(&joint.outboard);
        self.text(" {");
        self.given([
            ("at", joint.at),
            ("turned", joint.turned),
            ("axis", joint.axis),
            ("pitch", joint.pitch),
            ("damping", joint.damping),
        ]);
        self.text(" }");
    }
}
