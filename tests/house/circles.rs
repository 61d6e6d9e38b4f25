//! Circles of files: strongly connected components of the imports (R. Tarjan, *Depth-first search
//! and linear graph algorithms*, 1972).
//!
//! To a reader, the file of a module and the files of its direct children are one unit. Imports
//! between them make no circle, in either direction, and neither does a re-export from the module's
//! own folder. Everything else does: siblings that import each other, and a file that imports from
//! its caller by way of a re-export. So do a module and its grandchildren if each imports from the
//! other.

use std::collections::btree_map::Entry;
use std::collections::{BTreeMap, BTreeSet, VecDeque};

use crate::imports::{Crate, Import};

/// The first import of each file from each other file.
type Graph<'a> = BTreeMap<usize, BTreeMap<usize, &'a Import>>;

/// Returns every knot of files, with the shortest circle through each of its files.
pub(crate) fn circles(krate: &Crate) -> Vec<String> {
    let graph = graph(krate);
    let knots = components(&graph).into_iter().filter(|component| component.len() > 1);
    knots.map(|knot| describe(krate, &graph, &knot)).collect()
}

fn graph(krate: &Crate) -> Graph<'_> {
    let is_family = |a: usize, b: usize| krate.files[a].parent == Some(b) || krate.files[b].parent == Some(a);
    let mut graph = Graph::new();
    for import in krate.imports.iter().filter(|import| !is_family(import.from, import.to)) {
        graph.entry(import.from).or_default().entry(import.to).or_insert(import);
    }
    graph
}

fn describe(krate: &Crate, graph: &Graph, knot: &BTreeSet<usize>) -> String {
    let circles = knot.iter().filter_map(|file| shortest_circle(graph, knot, *file));
    let circles = circles.map(from_least).collect::<BTreeSet<_>>();
    let mut lines = vec![format!("{}: {} files in circles", krate.name, knot.len())];
    for circle in &circles {
        let mut line = format!("  {}", krate.files[circle[0]].path);
        for (from, to) in circle.iter().zip(circle.iter().cycle().skip(1)) {
            let Import { item, line: number, .. } = graph[from][to];
            line += &format!(" → {} (`{item}` at line {number})", krate.files[*to].path);
        }
        lines.push(line);
    }
    lines.join("\n")
}

/// Returns the same circle, beginning with its first file.
fn from_least(mut circle: Vec<usize>) -> Vec<usize> {
    let least = (0..circle.len()).min_by_key(|at| circle[*at]).unwrap_or_default();
    circle.rotate_left(least);
    circle
}

/// Returns the files of the shortest circle through a file, by breadth-first search within its
/// knot.
fn shortest_circle(graph: &Graph, knot: &BTreeSet<usize>, start: usize) -> Option<Vec<usize>> {
    let mut before = BTreeMap::new();
    let mut pending = VecDeque::from([start]);
    while let Some(file) = pending.pop_front() {
        for next in imported(graph, file).filter(|next| knot.contains(next)) {
            if next == start {
                let back = std::iter::successors(Some(file), |file| before.get(file).copied());
                let mut circle = back.collect::<Vec<_>>();
                circle.reverse();
                return Some(circle);
            }
            if let Entry::Vacant(unseen) = before.entry(next) {
                unseen.insert(file);
                pending.push_back(next);
            }
        }
    }
    None
}

fn components(graph: &Graph) -> Vec<BTreeSet<usize>> {
    let mut search = Search::default();
    for file in graph.keys() {
        search.visit(graph, *file);
    }
    search.components
}

/// State of Tarjan's search.
#[derive(Default)]
struct Search {
    /// Order in which files were discovered.
    order: BTreeMap<usize, usize>,
    /// Earliest file on the stack that a file reaches.
    low: BTreeMap<usize, usize>,
    stack: Vec<usize>,
    components: Vec<BTreeSet<usize>>,
}

impl Search {
    fn visit(&mut self, graph: &Graph, file: usize) {
        if self.order.contains_key(&file) {
            return;
        }
        let order = self.order.len();
        self.order.insert(file, order);
        self.low.insert(file, order);
        self.stack.push(file);
        for next in imported(graph, file) {
            self.visit(graph, next);
            if self.stack.contains(&next) {
                let low = self.low[&file].min(self.low[&next]);
                self.low.insert(file, low);
            }
        }
        if self.low[&file] == order {
            let start = self.stack.iter().rposition(|on_stack| *on_stack == file).expect("it was put there");
            self.components.push(self.stack.drain(start..).collect());
        }
    }
}

fn imported<'a>(graph: &'a Graph, file: usize) -> impl Iterator<Item = usize> + 'a {
    graph.get(&file).into_iter().flat_map(|imports| imports.keys().copied())
}
