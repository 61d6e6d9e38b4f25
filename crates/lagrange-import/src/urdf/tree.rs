//! Construction of a tree from links and joints: names resolved, one base, no loops.

use std::collections::HashMap;

use lagrange_core::diagnostics::nearest;

use super::collector::Source;
use super::joints::{NameAt, NamedJoint};
use super::messages;
use crate::robot::{Joint, Kind, Link, Mimic, Robot};

/// Sorts joints, starting at the base. `None` after a mistake; `is_complete` is true if all joints
/// are readable.
pub(super) fn tree(
    source: &mut Source<'_>,
    name: String,
    (links, joints): (Vec<Link>, Vec<NamedJoint<'_>>),
    is_complete: bool,
) -> Option<Robot> {
    let before = source.error_count();
    let mut link_named =
        Named::new(source, "link", links.iter().map(|link| (link.name.as_str(), link.place)));
    let mut joint_named = Named::new(source, "joint", joints.iter().map(|joint| (joint.name, joint.place)));
    let mut end = |end: &NameAt<'_>, role: &str| {
        link_named.find(source, end, || messages::unknown_link(role, end.name))
    };
    let ends = joints.iter().map(|joint| end(&joint.parent, "parent").zip(end(&joint.child, "child")));
    let ends = ends.collect::<Vec<_>>();
    let leaders = joints.iter().map(|joint| leader(source, joint, &mut joint_named)).collect::<Vec<_>>();
    report_mimic_circles(source, &joints, &leaders);
    let ends = ends.into_iter().collect::<Option<Vec<_>>>()?;
    report_placed_twice(source, &links, &joints, &ends);
    if source.error_count() > before || !is_complete {
        // Missing connections may be a consequence of these mistakes.
        return None;
    }
    let root = root_of(source, &links, &ends)?;
    let order = order(root, links.len(), &ends);
    if order.len() + 1 < links.len() && source.error_count() == before {
        report_loop(source, &links, &joints, (&ends, &order));
    }
    let mut places = vec![0; joints.len()];
    order.iter().enumerate().for_each(|(place, &index)| places[index] = place);
    let resolved = order.iter().map(|&index| {
        let leader = leaders[index].map(|leader| places[leader]);
        resolve(&joints[index], ends[index], leader)
    });
    let joints = resolved.collect();
    (source.error_count() == before).then_some(Robot { name, links, root, joints })
}

/// Maximum number of unknown names for which a similar one is suggested. Nobody reads more
/// suggestions.
const MAX_SUGGESTIONS: usize = 50;

/// Elements by name.
struct Named<'n> {
    indices: HashMap<&'n str, usize>,
    /// The names in sorted order, filled when the first name is not found.
    sorted: Vec<&'n str>,
    suggestions: usize,
}

impl<'n> Named<'n> {
    /// Collects items with their places, and reports repeated names.
    fn new(source: &mut Source<'_>, tag: &str, items: impl Iterator<Item = (&'n str, usize)>) -> Named<'n> {
        let mut known = HashMap::<&str, (usize, usize)>::new();
        for (index, (name, place)) in items.enumerate() {
            let here = (place, messages::element(tag, name));
            if name.is_empty() {
                source.error_at(here, messages::EMPTY_NAME);
            } else if let Some((_, before)) = known.get(name) {
                let line = source.line(*before);
                source.error_at(here, messages::repeated(tag, line));
            } else {
                known.insert(name, (index, place));
            }
        }
        let indices = known.into_iter().map(|(name, (index, _))| (name, index)).collect();
        Named { indices, sorted: Vec::new(), suggestions: 0 }
    }

    /// Returns the index of a name; an unknown one is reported.
    fn find(
        &mut self,
        source: &mut Source<'_>,
        name: &NameAt<'_>,
        message: impl Fn() -> String,
    ) -> Option<usize> {
        let found = self.indices.get(name.name).copied();
        if found.is_none() {
            let mistake = source.error_at(name.place.clone(), message());
            self.suggest(name.name).into_iter().for_each(|near| mistake.help(messages::did_you_mean(near)));
        }
        found
    }

    fn suggest(&mut self, name: &str) -> Option<&'n str> {
        self.suggestions += 1;
        if self.sorted.is_empty() {
            self.sorted = self.indices.keys().copied().collect();
            self.sorted.sort_unstable();
        }
        (self.suggestions <= MAX_SUGGESTIONS).then(|| nearest(name, self.sorted.iter().copied())).flatten()
    }
}

/// Returns the joint that another one mimics.
fn leader(source: &mut Source<'_>, joint: &NamedJoint<'_>, joints: &mut Named<'_>) -> Option<usize> {
    let name = &joint.mimic.as_ref()?.joint;
    if name.name == joint.name {
        source.error_at(name.place.clone(), messages::MIMICS_ITSELF);
        return None;
    }
    joints.find(source, name, || messages::unknown_joint(name.name))
}

/// Reports circles of joints that mimic each other, each at its first joint.
fn report_mimic_circles(source: &mut Source<'_>, joints: &[NamedJoint<'_>], leaders: &[Option<usize>]) {
    // The start from which each joint was first reached; reaching a joint of the same walk again
    // closes a circle.
    let mut reached_from = vec![None; joints.len()];
    for start in 0..joints.len() {
        let mut next = Some(start);
        while let Some(joint) = next.filter(|&joint| reached_from[joint].is_none()) {
            reached_from[joint] = Some(start);
            next = leaders[joint];
        }
        let Some(last) = next.filter(|&last| reached_from[last] == Some(start)) else { continue };
        let circle = std::iter::successors(leaders[last], |&joint| leaders[joint]);
        let first = circle.take_while(|&joint| joint != last).fold(last, usize::min);
        if let Some(mimic) = &joints[first].mimic {
            source.error_at(mimic.joint.place.clone(), messages::MIMIC_CIRCLE);
        }
    }
}

fn report_placed_twice(
    source: &mut Source<'_>,
    links: &[Link],
    joints: &[NamedJoint<'_>],
    ends: &[(usize, usize)],
) {
    let mut placed_by = HashMap::<usize, &NamedJoint<'_>>::new();
    for (joint, (_, child)) in joints.iter().zip(ends) {
        if let Some(first) = placed_by.get(child) {
            let message = messages::two_parents(&links[*child].name, first.name, source.line(first.place));
            source.error_at(joint.child.place.clone(), message).help(messages::TREE_HELP);
        } else {
            placed_by.insert(*child, joint);
        }
    }
}

/// Returns the only link that no joint places.
fn root_of(source: &mut Source<'_>, links: &[Link], ends: &[(usize, usize)]) -> Option<usize> {
    let mut is_placed = vec![false; links.len()];
    ends.iter().for_each(|(_, child)| is_placed[*child] = true);
    let mut roots = (0..links.len()).filter(|link| !is_placed[*link]);
    let Some(root) = roots.next() else {
        let first = links.first()?;
        let place = (first.place, messages::element("link", &first.name));
        source.error_at(place, messages::LOOP).help(messages::TREE_HELP);
        return None;
    };
    for other in roots {
        let (first, other) = (&links[root], &links[other]);
        let message = messages::two_roots(&first.name, source.line(first.place));
        source.error_at((other.place, messages::element("link", &other.name)), message);
    }
    Some(root)
}

/// Returns joints in depth-first order, starting at the base.
fn order(root: usize, count: usize, ends: &[(usize, usize)]) -> Vec<usize> {
    let mut carried = vec![Vec::new(); count];
    ends.iter().enumerate().for_each(|(joint, (parent, _))| carried[*parent].push(joint));
    let mut order = Vec::new();
    let mut waiting = carried[root].iter().rev().copied().collect::<Vec<_>>();
    while let Some(joint) = waiting.pop().filter(|_| order.len() < ends.len()) {
        order.push(joint);
        waiting.extend(carried[ends[joint].1].iter().rev());
    }
    order
}

fn report_loop(
    source: &mut Source<'_>,
    links: &[Link],
    joints: &[NamedJoint<'_>],
    (ends, order): (&[(usize, usize)], &[usize]),
) {
    let mut is_reached = vec![false; joints.len()];
    order.iter().for_each(|&joint| is_reached[joint] = true);
    if let Some(joint) = is_reached.iter().position(|is_reached| !is_reached) {
        let message = messages::in_loop(&links[ends[joint].1].name);
        let place = (joints[joint].place, messages::element("joint", joints[joint].name));
        source.error_at(place, message).help(messages::TREE_HELP);
    }
}

fn resolve(joint: &NamedJoint<'_>, (parent, child): (usize, usize), leader: Option<usize>) -> Joint {
    let mimic = joint.mimic.as_ref().zip(leader).map(|(mimic, joint)| Mimic {
        joint,
        multiplier: mimic.multiplier.clone(),
        offset: mimic.offset.clone(),
    });
    Joint {
        name: joint.name.to_owned(),
        kind: joint.kind,
        parent,
        child,
        at: joint.at.clone(),
        turned: joint.turned.clone(),
        axis: joint.axis.clone(),
        limit: joint.limit.clone(),
        damping: joint.damping.clone(),
        friction: joint.friction.clone(),
        mimic,
        place: joint.place,
    }
}

/// Holds joints that move no mass, and omits their couplings; `is_free` is true if the base moves.
pub(super) fn settle(source: &mut Source<'_>, robot: &mut Robot, is_free: bool) {
    let carries = robot.carries_mass();
    for joint in &mut robot.joints {
        let here = || (joint.place, messages::element("joint", &joint.name));
        if !joint.kind.is_rigid() && !carries[joint.child] {
            source.warning_at(here(), messages::HELD);
            joint.kind = Kind::Held;
        }
        if joint.mimic.is_some() && !joint.kind.is_simple() {
            source.warning_at(here(), messages::MIMIC_LEFT_OUT);
            joint.mimic = None;
        }
    }
    for joint in &robot.joints {
        let leader = joint.mimic.as_ref().map(|mimic| &robot.joints[mimic.joint]);
        if leader.is_some_and(|leader| !leader.kind.is_simple()) {
            let here = (joint.place, messages::element("joint", &joint.name));
            source.error_at(here, messages::MIMICS_NONE).help(messages::MIMIC_HELP);
        }
    }
    let base_moves = is_free && carries[robot.root];
    if !base_moves && robot.joints.iter().all(|joint| joint.kind.is_rigid()) {
        let root = &robot.links[robot.root];
        let here = (root.place, messages::element("link", &root.name));
        source.error_at(here, messages::NOTHING_MOVES).help(messages::NOTHING_MOVES_HELP);
    }
}
