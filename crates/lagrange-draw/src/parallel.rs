//! Detection of coincident springs and dampers, and the offset with which they are drawn.
//!
//! A spring and a damper between the same two points are drawn next to each other, as in textbooks
//! on oscillations. A torsion damper about the point of a torsion spring is drawn around it.
//! Connectors that meet only at one moment are not shifted.

use std::collections::BTreeMap;

use crate::geometry::{extent, length, subtract};
use crate::picture::Point;
use crate::snapshot::{Snapshot, Span};
use lagrange_runtime::scene::Connector;

/// Offsets of coincident connectors, by name. Between points, it is the number of lanes to the left
/// of the line from the first end to the second. About a point, it is the number of connectors
/// inside. Connectors without coincidence have no entry.
pub(super) type Lanes = BTreeMap<String, f64>;

/// Distance, as a fraction of the scene, below which points coincide.
const TOUCHING: f64 = 1e-6;

/// A connector that coincides with the first one of its group, in the same or opposite direction.
struct Member {
    name: String,
    is_damper: bool,
    is_reversed: bool,
}

/// Returns the offsets throughout a film; `elsewhere` is the scene in a different configuration.
pub(super) fn lanes(film: &[Snapshot], elsewhere: Option<&Snapshot>) -> Lanes {
    let moments: Vec<&Snapshot> = film.iter().chain(elsewhere).collect();
    // Connectors may have zero length, at some moment or always.
    let ends = moments.iter().flat_map(|snapshot| &snapshot.connectors).flat_map(|connector| connector.ends);
    let centers = moments.iter().flat_map(|snapshot| &snapshot.bodies).map(|body| body.motion.center);
    let close = TOUCHING * extent(ends.chain(centers));
    let mut groups: Vec<(bool, Vec<Member>)> = Vec::new();
    for Span { name, kind, .. } in film.first().into_iter().flat_map(|snapshot| &snapshot.connectors) {
        let turns = matches!(kind, Connector::TorsionSpring | Connector::TorsionDamper);
        let is_damper = matches!(kind, Connector::Damper | Connector::TorsionDamper);
        let found = groups.iter_mut().filter(|(other, _)| *other == turns).find_map(|(_, members)| {
            let is_reversed = meets([&members[0].name, name], &moments, close)?;
            Some((members, is_reversed))
        });
        let member = |is_reversed| Member { name: name.clone(), is_damper, is_reversed };
        match found {
            Some((members, is_reversed)) => members.push(member(is_reversed)),
            None => groups.push((turns, [member(false)].into())),
        }
    }
    groups.into_iter().flat_map(|(turns, members)| places(turns, members)).collect()
}

/// Returns the offsets within a group.
fn places(turns: bool, mut members: Vec<Member>) -> Vec<(String, f64)> {
    let middle = 0.5 * (members.len() - 1) as f64;
    if turns {
        members.sort_by_key(|member| member.is_damper);
    }
    let place = |(index, member): (usize, Member)| {
        let side = if member.is_reversed { -1.0 } else { 1.0 };
        (member.name, if turns { index as f64 } else { side * (middle - index as f64) })
    };
    let placed = members.into_iter().enumerate().map(place);
    placed.filter(|(_, place)| *place != 0.0).collect()
}

/// Returns whether their directions are opposite if two connectors have the same ends at all
/// moments.
fn meets([one, other]: [&str; 2], moments: &[&Snapshot], close: f64) -> Option<bool> {
    [false, true].into_iter().find(|is_reversed| {
        moments.iter().all(|snapshot| match (snapshot.ends(one), snapshot.ends(other)) {
            (Some(ends), Some([from, to])) => {
                is_same(ends, if *is_reversed { [to, from] } else { [from, to] }, close)
            }
            _ => false,
        })
    })
}

fn is_same(ends: [Point; 2], others: [Point; 2], close: f64) -> bool {
    ends.into_iter().zip(others).all(|(one, other)| length(subtract(one, other)) <= close)
}

#[cfg(test)]
mod tests {

    use super::lanes;
    use crate::snapshot::{Snapshot, Span};
    use lagrange_runtime::scene::Connector::{self, Damper, Spring, TorsionDamper, TorsionSpring};

    type Row = (&'static str, Connector, [[f64; 2]; 2]);

    fn scene(connectors: &[Row]) -> Snapshot {
        let connectors = connectors.iter().map(|(name, kind, ends)| Span {
            name: name.to_string(),
            kind: *kind,
            ends: *ends,
        });
        Snapshot { connectors: connectors.collect(), ..Snapshot::default() }
    }

    fn found(film: &[Snapshot]) -> Vec<(String, f64)> {
        lanes(film, None).into_iter().collect()
    }

    #[test]
    fn a_spring_and_a_damper_lie_side_by_side_in_whichever_direction_they_are_declared() {
        let (p, q) = ([0.0, 0.0], [2.0, 1.0]);
        let along = found(&[scene(&[("k", Spring, [p, q]), ("d", Damper, [p, q])])]);
        assert_eq!(along, [("d".to_string(), -0.5), ("k".to_string(), 0.5)]);
        let against = found(&[scene(&[("k", Spring, [p, q]), ("d", Damper, [q, p])])]);
        assert_eq!(against, [("d".to_string(), 0.5), ("k".to_string(), 0.5)]);
        let three = found(&[scene(&[("a", Spring, [p, q]), ("b", Spring, [p, q]), ("c", Damper, [p, q])])]);
        assert_eq!(three, [("a".to_string(), 1.0), ("c".to_string(), -1.0)]);
    }

    #[test]
    fn what_only_meets_for_a_moment_or_at_one_end_stays_where_it_is() {
        let (p, q, r) = ([0.0, 0.0], [2.0, 1.0], [2.0, 3.0]);
        let meeting = scene(&[("k", Spring, [p, q]), ("d", Damper, [p, q])]);
        let apart = scene(&[("k", Spring, [p, q]), ("d", Damper, [p, r])]);
        assert!(found(&[meeting.clone(), apart.clone()]).is_empty());
        assert!(lanes(&[meeting], Some(&apart)).is_empty());
        assert!(found(&[apart]).is_empty());
    }

    /// At one moment the ends coincide up to rounding; at another they have passed each other.
    #[test]
    fn a_pair_stays_side_by_side_while_its_ends_pass_each_other() {
        let at = |x: f64, off: f64| {
            let (p, q) = ([0.1, 0.2], [0.1 + x, 0.2 + x]);
            scene(&[("k", Spring, [p, q]), ("d", Damper, [[q[0] + off, q[1]], p])])
        };
        let film = [at(0.5, 0.0), at(0.0, 1e-17), at(1e-12, -1e-16), at(-0.5, 0.0)];
        assert_eq!(found(&film), [("d".to_string(), 0.5), ("k".to_string(), 0.5)]);
        assert_eq!(found(&[at(0.0, 0.0)]).len(), 2, "without any length, too");
        assert!(found(&[at(0.5, 0.0), at(0.0, 1e-3)]).is_empty(), "what is apart is apart");
    }

    #[test]
    fn a_torsion_damper_lies_around_a_torsion_spring() {
        let at = [[1.0, 1.0]; 2];
        let pair = vec![("d", TorsionDamper, at), ("k", TorsionSpring, at), ("m", Spring, at)];
        assert_eq!(found(&[scene(&pair)]), [("d".to_string(), 1.0)]);
    }
}
