//! Declarations as text of the language.

use std::fmt::{Display, Formatter, Result};

use lagrange_core::elementary::row;

use crate::tree::{Body, Declaration, Expr, Index, Joint, Operator, Statement, Unit, Values};

impl Display for Declaration {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        writeln!(f, "#[accuracy({})] struct Random;", self.level)?;
        self.statements.iter().try_for_each(|statement| writeln!(f, "{statement}"))
    }
}

impl Display for Index {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let base = match (self.is_variable, self.offset) {
            (false, offset) => offset.to_string(),
            (true, 0) => "i".to_owned(),
            (true, offset) => format!("i {} {}", if offset < 0 { '-' } else { '+' }, offset.abs()),
        };
        match self.ring {
            Some(ring) => write!(f, "({base}) % {ring}"),
            None => write!(f, "{base}"),
        }
    }
}

fn list<T: Display>(items: &[T]) -> String {
    items.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}

/// Returns a unit behind a colon.
fn said(unit: Option<&Unit>) -> String {
    unit.map_or_else(String::new, |unit| format!(": {}", unit.text))
}

/// Returns a label with its value, if there is one.
fn label<T>(word: &str, value: Option<T>, text: impl Fn(T) -> String) -> String {
    value.map_or_else(String::new, |value| format!(" {word}: {};", text(value)))
}

impl Display for Expr {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Expr::Number(decimal, None) => write!(f, "{decimal}"),
            Expr::Number(decimal, Some(unit)) => write!(f, "({decimal} [{}])", unit.text),
            Expr::Pi => write!(f, "pi"),
            Expr::Time => write!(f, "t"),
            Expr::Name(name) => write!(f, "{name}"),
            Expr::Element(name, index) => write!(f, "{name}[{index}]"),
            Expr::Variable => write!(f, "i"),
            Expr::Binary(operator, a, b) => {
                let sign = match operator {
                    Operator::Add => '+',
                    Operator::Subtract => '-',
                    Operator::Multiply => '*',
                    Operator::Divide => '/',
                };
                write!(f, "({a} {sign} {b})")
            }
            Expr::Negative(a) => write!(f, "(-{a})"),
            Expr::Power(a, n, 1) => write!(f, "({a})^{n}"),
            Expr::Power(a, n, m) => write!(f, "({a})^({n}/{m})"),
            Expr::Call(function, arguments) => write!(f, "{}({})", row(*function).name, list(arguments)),
            Expr::Apply(name, arguments) => write!(f, "{name}({})", list(arguments)),
            Expr::Rate(a) => write!(f, "dot({a})"),
            Expr::Choose { or_equal, operands } => {
                let [a, b, then, otherwise] = &**operands;
                let relation = if *or_equal { "<=" } else { "<" };
                write!(f, "(if {a} {relation} {b} {{ {then} }} else {{ {otherwise} }})")
            }
            Expr::EveryNth(n, operands) => {
                let [then, otherwise] = &**operands;
                write!(f, "(if i % {n} == 0 && i >= 0 {{ {then} }} else {{ {otherwise} }})")
            }
            Expr::Sum(count, term) => write!(f, "sum(i in 0..{count}, {term})"),
            Expr::Vector(components) => write!(f, "({})", list(components)),
            Expr::Component(a, k) => write!(f, "{a}.{}", ["x", "y", "z"][*k]),
            Expr::Norm(a) => write!(f, "norm({a})"),
            Expr::Inner(a, b) => write!(f, "inner({a}, {b})"),
            Expr::KineticEnergy(m, v) => write!(f, "kinetic_energy({m}, {v})"),
            Expr::SpringEnergy(k, x) => write!(f, "spring_energy({k}, {x})"),
            Expr::Point(body, own) => write!(f, "{body}.point({})", list(own)),
            Expr::Direction(body, own) => write!(f, "{body}.vector({})", list(own)),
            Expr::Center(body) => write!(f, "{body}.center"),
            Expr::Spin(body) => write!(f, "angular_velocity({body})"),
        }
    }
}

impl Display for Values {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Values::One(value) | Values::All(_, value) => write!(f, "{value}"),
            Values::Each(values) => write!(f, "[{}]", list(values)),
        }
    }
}

impl Values {
    /// Returns the number of elements, in brackets.
    fn count(&self) -> String {
        match self {
            Values::One(_) => String::new(),
            Values::Each(values) => format!("[{}]", values.len()),
            Values::All(count, _) => format!("[{count}]"),
        }
    }
}

impl Display for Statement {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match self {
            Statement::Values { word, name, unit, values } => {
                write!(f, "{word} {name}{}{} = {values};", values.count(), said(unit.as_ref()))
            }
            Statement::Coordinate { name, unit, count } => {
                let count = count.map_or_else(String::new, |count| format!("[{count}]"));
                write!(f, "coord {name}{count}{};", said(unit.as_ref()))
            }
            Statement::State { name, unit, count } => {
                let count = count.map_or_else(String::new, |count| format!("[{count}]"));
                write!(f, "state {name}{count}{};", said(unit.as_ref()))
            }
            Statement::StateRate { name, index: None, rate } => write!(f, "dot({name}) = {rate};"),
            Statement::StateRate { name, index: Some(index), rate } => {
                write!(f, "dot({name}[{index}]) = {rate};")
            }
            Statement::Quaternion(name) => write!(f, "quaternion {name};"),
            Statement::Let(name, value) => write!(f, "let {name} = {value};"),
            Statement::LetElement(name, index, value) => write!(f, "let {name}[{index}] = {value};"),
            Statement::LetFunction(name, parameters, value) => {
                write!(f, "let {name}({}) = {value};", list(parameters))
            }
            Statement::Table(name, table) => {
                let points = table.points.iter().map(|(x, y)| format!("({x}, {y})")).collect::<Vec<_>>();
                let (interpolation, outside) = (table.interpolation, table.outside);
                write!(
                    f,
                    "table {name}(x) = [{}], interpolation: {interpolation}, outside: {outside};",
                    list(&points)
                )
            }
            Statement::Solve { name, unit, residual, start } => {
                let start = start.as_ref().map_or_else(String::new, |start| format!(", start: {start}"));
                write!(f, "solve {name}{}: 0 = {residual}{start};", said(unit.as_ref()))
            }
            Statement::Energy(word, value) => write!(f, "{word} = {value};"),
            Statement::Gibbs(function, stated) => write!(f, "gibbs = {function}, for: {stated};"),
            Statement::Force(name, force) => write!(f, "force {name} = {force};"),
            Statement::ForceAlong(force, velocity) => write!(f, "force {force} along {velocity};"),
            Statement::ForceAt(force, point) => write!(f, "force {force} at {point};"),
            Statement::Torque(moment, angle) => write!(f, "torque {moment} on {angle};"),
            Statement::TorqueOn(moment, body) => write!(f, "torque {moment} on {body};"),
            Statement::Constraint { name, zero, .. } => write!(f, "constraint {name} = {zero};"),
            Statement::Output(name, value) => write!(f, "output {name} = {value};"),
            Statement::Loop(count, statements) => {
                write!(f, "for i in 0..{count} {{")?;
                statements.iter().try_for_each(|statement| write!(f, " {statement}"))?;
                write!(f, " }}")
            }
            Statement::Gravity(vector) => write!(f, "gravity = ({});", list(vector)),
            Statement::Body(body) => write!(f, "{body}"),
            Statement::Joint(joint) => write!(f, "{joint}"),
            Statement::Free(name) => write!(f, "free {name};"),
            Statement::Spring { from, to, stiffness, rest } => {
                let rest = label("rest", rest.as_ref(), ToString::to_string);
                write!(f, "spring {{ from: {from}; to: {to}; stiffness: {stiffness};{rest} }}")
            }
            Statement::Damper { from, to, damping } => {
                write!(f, "damper {{ from: {from}; to: {to}; damping: {damping}; }}")
            }
            Statement::Pin { name, from, to } => write!(f, "pin {name} = {from} to {to};"),
        }
    }
}

fn triple(components: &[Expr]) -> String {
    format!("({})", list(components))
}

impl Display for Body {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        write!(f, "body {} {{ mass: {};", self.name, self.mass)?;
        let inertia = list(&self.inertia);
        match self.inertia.len() {
            1 => write!(f, " inertia: {inertia};")?,
            _ => write!(f, " inertia: ({inertia});")?,
        }
        write!(f, "{}", label("centroid", self.centroid.as_deref(), triple))?;
        if let Some(pose) = &self.pose {
            let word = if pose.is_center { "center" } else { "origin" };
            write!(f, " {word}: ({});", list(&pose.place))?;
            match &pose.angles[..] {
                [angle] => write!(f, " angle: {angle};")?,
                angles => write!(f, " angles: ({}); sequence: {};", list(angles), pose.sequence)?,
            }
        }
        write!(f, " }}")
    }
}

impl Display for Joint {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        let names = match &self.names[..] {
            [] => String::new(),
            [name] => format!("{name} = "),
            names => format!("({}) = ", list(names)),
        };
        let from = self.from.as_deref().unwrap_or("ground");
        let labels = [("at", &self.at), ("turned", &self.turned), ("axis", &self.axis)];
        let labels = labels.map(|(word, value)| label(word, value.as_deref(), triple)).concat();
        let numbers = [("pitch", &self.pitch), ("damping", &self.damping)];
        let numbers = numbers.map(|(word, value)| label(word, value.as_ref(), ToString::to_string)).concat();
        write!(f, "{} {names}{from} to {} {{{labels}{numbers} }}", self.kind, self.to)
    }
}
