//! Limits of joints as stops: contacts of a coordinate with the ends of its range.
//!
//! The stops of a joint that follows another one act on the leader. With q₂ = −2 q₁ + 0.1 and 0 ≤
//! q₂ ≤ 1, the leader has −0.45 ≤ q₁ ≤ 0.05. The tighter of these limits and its own ones apply.

use super::Writer;
use crate::decimal::Decimal;
use crate::robot::{Following, Joint};

/// Difference up to which limits of a follower and of its leader are the same, relative to the
/// larger of the limit and one.
const SAME: f64 = 1e-9;

/// Limits of a coordinate.
#[derive(Clone, Debug)]
struct Range {
    lower: Option<Decimal>,
    upper: Option<Decimal>,
}

impl Range {
    fn of(joint: &Joint) -> Range {
        Range { lower: joint.limit.lower.clone(), upper: joint.limit.upper.clone() }
    }

    fn is_empty(&self) -> bool {
        self.lower
            .as_ref()
            .zip(self.upper.as_ref())
            .is_some_and(|(lower, upper)| lower.value() >= upper.value())
    }

    /// Converts limits of a follower to those of its leader.
    fn of_leader(&self, Following { factor, offset, .. }: &Following) -> Range {
        let [lower, upper] = [&self.lower, &self.upper].map(|limit| {
            let limit = limit.as_ref().filter(|_| *factor != 0.0)?;
            Some(Decimal::rounded((limit.value() - offset) / factor))
        });
        if *factor < 0.0 { Range { lower: upper, upper: lower } } else { Range { lower, upper } }
    }

    /// Replaces limits with tighter ones.
    fn narrow(&mut self, other: Range) {
        tighten(&mut self.lower, other.lower, 1.0);
        tighten(&mut self.upper, other.upper, -1.0);
    }

    /// Returns zero if it is within the limits, otherwise their middle.
    fn start(&self) -> f64 {
        let [lower, upper] = [&self.lower, &self.upper].map(|limit| limit.as_ref().map(Decimal::value));
        let is_outside = lower.is_some_and(|lower| lower > 0.0) || upper.is_some_and(|upper| upper < 0.0);
        match (lower, upper) {
            _ if !is_outside || self.is_empty() => 0.0,
            (Some(lower), Some(upper)) => 0.5 * (lower + upper),
            (limit, None) | (None, limit) => limit.unwrap_or_default(),
        }
    }
}

/// Replaces a limit with another one that exceeds it in the direction of the sign.
fn tighten(limit: &mut Option<Decimal>, other: Option<Decimal>, sign: f64) {
    let exceeds = |other: &Decimal| {
        limit
            .as_ref()
            .is_none_or(|limit| sign * (other.value() - limit.value()) > SAME * limit.value().abs().max(1.0))
    };
    if let Some(other) = other.filter(exceeds) {
        *limit = Some(other);
    }
}

impl Writer<'_> {
    /// Writes stops without restitution, and a start between them if they exclude zero.
    pub(super) fn stops(&mut self) {
        let robot = self.robot;
        let coordinates = self.coordinates.clone();
        let simple = coordinates.iter().enumerate();
        let simple = simple.filter_map(|(joint, coordinate)| Some((joint, coordinate.as_deref()?)));
        let followings = (0..robot.joints.len()).map(|joint| robot.following(joint)).collect::<Vec<_>>();
        let mut ranges = robot.joints.iter().map(Range::of).collect::<Vec<_>>();
        for (joint, _) in simple.clone().filter(|(joint, _)| followings[*joint].leader != *joint) {
            let range = ranges[joint].clone();
            match range.is_empty() {
                true => self.declared.rangeless.push(joint),
                false => ranges[followings[joint].leader].narrow(range.of_leader(&followings[joint])),
            }
        }
        self.page.gap();
        for (joint, coordinate) in simple.clone().filter(|(joint, _)| followings[*joint].leader == *joint) {
            match ranges[joint].is_empty() {
                true => self.declared.rangeless.push(joint),
                false => self.stops_of(coordinate, &ranges[joint]),
            }
        }
        for (joint, coordinate) in simple {
            let Following { leader, factor, offset } = followings[joint];
            let start = Decimal::rounded(factor * ranges[leader].start() + offset);
            if !start.is_zero() {
                self.page.line(&format!("start {coordinate} = {start};"));
            }
        }
    }

    fn stops_of(&mut self, coordinate: &str, Range { lower, upper }: &Range) {
        let lower = lower.as_ref().map(|lower| match lower.value() {
            0.0 => coordinate.to_owned(),
            value if value < 0.0 => format!("{coordinate} + {}", lower.magnitude()),
            _ => format!("{coordinate} - {lower}"),
        });
        let upper = upper.as_ref().map(|upper| match upper.is_zero() {
            true => format!("-{coordinate}"),
            false => format!("{upper} - {coordinate}"),
        });
        for (end, gap) in [("lower", lower), ("upper", upper)] {
            let Some(gap) = gap else { continue };
            let name = self.identifiers.take(&format!("{coordinate}_{end}"), "limit", &[]);
            self.page.line(&format!("event {name} = {gap}, falling => impact(0);"));
            self.declared.event_count += 1;
        }
    }
}
