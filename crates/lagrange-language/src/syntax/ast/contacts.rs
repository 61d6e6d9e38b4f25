//! Contacts, as written.

use super::{AstId, Name};

/// `contact name = wheel on floor { friction: mu; restitution: e; }`, rigid unless it has a
/// stiffness
#[derive(Clone, Debug)]
pub struct Contact {
    /// Its name, which denotes the normal force.
    pub name: Name,
    /// Names of the frictions in it.
    pub frictions: FrictionNames,
    /// The touching body, or a point of one.
    pub object: AstId,
    /// The touched surface: of a body, a line or similar object, or the ground.
    pub surface: Name,
    /// True if the body is inside the surface.
    pub is_inside: bool,
    /// `radius: r;` around the point or the rim; by default, that of a round body.
    pub radius: Option<AstId>,
    /// `rim: r;`, the radius of a circle about the touching point.
    pub rim: Option<AstId>,
    /// `axis: (a, b, c);` of the rim in the body; its third axis by default.
    pub axis: Option<AstId>,
    /// `friction: mu;`, one coefficient for slipping and sticking.
    pub friction: Option<AstId>,
    /// `kinetic: mu;`, the coefficient while it slips.
    pub kinetic: Option<AstId>,
    /// `static: mu;`, the coefficient while it sticks.
    pub fixed: Option<AstId>,
    /// `restitution: e;`; 0 by default.
    pub restitution: Option<AstId>,
    /// Labels of a compliant contact.
    pub compliance: Compliance,
    /// True if some lines between the braces could not be read.
    pub is_incomplete: bool,
    /// `rolling: a;`, the largest moment against rolling divided by the normal force.
    pub rolling: Option<AstId>,
    /// `spinning: a;`, the largest moment against spinning divided by the normal force.
    pub spinning: Option<AstId>,
}

/// Labels of compliant contacts.
#[derive(Clone, Copy, Default, Debug)]
pub struct Compliance {
    /// `stiffness: k;`, which makes a contact compliant.
    pub stiffness: Option<AstId>,
    /// `penetration: d;` under the load, instead of the stiffness.
    pub penetration: Option<AstId>,
    /// `load: f;`, the normal force at the penetration.
    pub load: Option<AstId>,
    /// `dissipation: d;` of Hunt and Crossley; 0 by default.
    pub dissipation: Option<AstId>,
    /// `stiction: v;`, the speed below which compliant friction creeps.
    pub stiction: Option<AstId>,
    /// `stiction_rate: w;`, the angular speed below which compliant rolling and spinning creep.
    pub stiction_rate: Option<AstId>,
}

impl Compliance {
    /// Its labels.
    pub const LABELS: [&'static str; 6] =
        ["stiffness", "penetration", "load", "dissipation", "stiction", "stiction_rate"];

    /// Returns the label that makes a contact compliant.
    pub fn way(&self) -> Option<AstId> {
        self.stiffness.or(self.penetration).or(self.load)
    }

    /// Returns the place for the value of a label.
    pub fn value_mut(&mut self, label: &str) -> &mut Option<AstId> {
        match label {
            "stiffness" => &mut self.stiffness,
            "penetration" => &mut self.penetration,
            "load" => &mut self.load,
            "dissipation" => &mut self.dissipation,
            "stiction" => &mut self.stiction,
            _ => &mut self.stiction_rate,
        }
    }

    /// Returns its labels with their values.
    pub fn values(&self) -> [(&'static str, Option<AstId>); 6] {
        let mut copy = *self;
        Compliance::LABELS.map(|label| (label, *copy.value_mut(label)))
    }

    /// Returns the values that are given.
    pub fn values_mut(&mut self) -> impl Iterator<Item = &mut AstId> {
        let Compliance { stiffness, penetration, load, dissipation, stiction, stiction_rate } = self;
        [stiffness, penetration, load, dissipation, stiction, stiction_rate].into_iter().flatten()
    }
}

/// `contacts: rigid;` or `contacts: compliant { stiffness: k; … }`: what contacts without labels of
/// their own are
#[derive(Clone, Debug)]
pub struct ContactDefaults {
    /// The word `rigid` or `compliant`.
    pub way: Name,
    /// Labels of compliant contacts.
    pub compliance: Compliance,
}

impl Contact {
    /// Returns this contact with the default labels that concern it and that it does not have.
    pub fn with_defaults(&self, defaults: &Compliance) -> Contact {
        let own = self.compliance;
        let law = if own.way().is_some() { own } else { *defaults };
        let turns = self.rolling.or(self.spinning).is_some();
        let Compliance { stiffness, penetration, load, .. } = law;
        let compliance = Compliance {
            stiffness,
            penetration,
            load,
            dissipation: own.dissipation.or(defaults.dissipation),
            stiction: own.stiction.or(defaults.stiction.filter(|_| self.has_friction())),
            stiction_rate: own.stiction_rate.or(defaults.stiction_rate.filter(|_| turns)),
        };
        Contact { compliance, ..self.clone() }
    }
}

/// Names of the frictions in a contact, derived from its own.
#[derive(Clone, Debug)]
pub struct FrictionNames {
    /// `name_friction`, against sliding.
    pub sliding: Name,
    /// `name_rolling`, against rolling.
    pub rolling: Name,
    /// `name_spinning`, against spinning about the normal.
    pub spinning: Name,
}

impl FrictionNames {
    /// Derives the names from that of the contact.
    pub fn of(contact: &Name) -> FrictionNames {
        let ending = |ending: &str| Name::new(format!("{}_{ending}", contact.text), contact.span);
        let [sliding, rolling, spinning] = ["friction", "rolling", "spinning"].map(ending);
        FrictionNames { sliding, rolling, spinning }
    }
}

impl Contact {
    /// The labels of a contact.
    pub const LABELS: [&'static str; 15] = [
        "radius",
        "rim",
        "axis",
        "friction",
        "kinetic",
        "static",
        "rolling",
        "spinning",
        "restitution",
        "stiffness",
        "penetration",
        "load",
        "dissipation",
        "stiction",
        "stiction_rate",
    ];

    /// Creates a contact without further properties.
    pub fn between(name: Name, object: AstId, surface: Name, is_inside: bool) -> Contact {
        let frictions = FrictionNames::of(&name);
        let [radius, rim, axis, friction, kinetic, fixed] = [None; 6];
        let [rolling, spinning, restitution] = [None; 3];
        Contact {
            name,
            frictions,
            object,
            surface,
            is_inside,
            radius,
            rim,
            axis,
            friction,
            kinetic,
            fixed,
            restitution,
            rolling,
            spinning,
            compliance: Compliance::default(),
            is_incomplete: false,
        }
    }

    /// True if it has friction against sliding.
    pub fn has_friction(&self) -> bool {
        [self.friction, self.kinetic, self.fixed].iter().any(Option::is_some)
    }

    /// Returns the names that it declares.
    pub fn names(&self) -> Vec<&Name> {
        let FrictionNames { sliding, rolling, spinning } = &self.frictions;
        let frictions = [
            (self.has_friction(), sliding),
            (self.rolling.is_some(), rolling),
            (self.spinning.is_some(), spinning),
        ];
        let frictions = frictions.into_iter().filter_map(|(exists, name)| exists.then_some(name));
        [&self.name].into_iter().chain(frictions).collect()
    }

    /// Returns the place for the value of a label.
    pub fn value_mut(&mut self, label: &str) -> &mut Option<AstId> {
        match label {
            "radius" => &mut self.radius,
            "rim" => &mut self.rim,
            "axis" => &mut self.axis,
            "friction" => &mut self.friction,
            "kinetic" => &mut self.kinetic,
            "static" => &mut self.fixed,
            "rolling" => &mut self.rolling,
            "spinning" => &mut self.spinning,
            "restitution" => &mut self.restitution,
            label => self.compliance.value_mut(label),
        }
    }

    /// Returns its labels with their values.
    pub fn values(&self) -> Vec<(&'static str, Option<AstId>)> {
        let mut copy = self.clone();
        Contact::LABELS.map(|label| (label, *copy.value_mut(label))).to_vec()
    }

    pub(super) fn expressions_mut(&mut self) -> Vec<&mut AstId> {
        let Contact { object, radius, rim, axis, friction, kinetic, fixed, restitution, .. } = self;
        let rigid = [radius, rim, axis, friction, kinetic, fixed, restitution];
        let turning = [&mut self.rolling, &mut self.spinning];
        let values = rigid.into_iter().chain(turning).flatten();
        [object].into_iter().chain(values).chain(self.compliance.values_mut()).collect()
    }
}
