//! Products in groups of four, which fit in vector registers.
//!
//! A sum of products requires two loads per term, more than processors can perform alongside a
//! product and a sum. Groups that share one side of their products load it only once.
//!
//! # A double pendulum
//!
//! With sines and cosines s and c, velocities v and forces F, eight products fall into two groups
//! of one shared side:
//!
//! | | | | | |
//! |---|---|---|---|---|
//! | shared | s₁ | c₁ | s₂ | c₂ |
//! | first group | v₁ | v₁ | v₂ | v₂ |
//! | second group | F₁ | F₂ | F₃ | F₄ |

use super::SeriesPrograms;
use super::alignment::{GROUP, Group, aligned};
use lagrange_expr::collections::OrderedMap;

/// Maximum number of products whose factors processors keep in registers. The time of an order is
/// then that of chains of operations, not of moves between lanes.
const IN_REGISTERS: usize = 32;
/// Maximum number of loads of aligned groups relative to the fewest possible: moves cost more.
const ACCEPTABLE: f64 = 1.25;

/// Products a b in groups: places of factors, four for each group.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Groups {
    /// Factors a, each shared by one or more groups.
    pub shared: Vec<[usize; GROUP]>,
    /// Factors b of each group. Incomplete groups repeat a product.
    pub groups: Vec<[usize; GROUP]>,
    /// The shared factors of each group.
    pub of_group: Vec<usize>,
    /// Group of each product, and its place there.
    pub of_product: Vec<[usize; 2]>,
}

/// A factor, with the products in which it is the shared factor and their other factors.
struct Star {
    factor: usize,
    others: Vec<(usize, usize)>,
}

/// A product: its index and its factors.
type Product = (usize, [usize; 2]);

impl Groups {
    /// Groups the products of these programs: those of like parts of large systems lane by lane,
    /// others so that few registers are loaded.
    pub fn new(programs: &SeriesPrograms) -> Groups {
        let products = programs.sums.iter().copied().enumerate().collect::<Vec<_>>();
        let fewest = Groups::of(with_few_loads(&products), products.len());
        if products.len() <= IN_REGISTERS {
            return fewest;
        }
        let mut groups = aligned(programs);
        let mut is_left = vec![true; products.len()];
        groups.iter().flatten().for_each(|&(_, _, product)| is_left[product] = false);
        let left = products.iter().copied().filter(|(product, _)| is_left[*product]).collect::<Vec<_>>();
        groups.extend(with_few_loads(&left));
        let aligned = Groups::of(groups, products.len());
        let is_acceptable = aligned.loads() as f64 <= ACCEPTABLE * fewest.loads() as f64;
        if is_acceptable { aligned } else { fewest }
    }

    /// Returns the number of registers that a term of the sums loads.
    fn loads(&self) -> usize {
        self.shared.len() + self.groups.len()
    }

    fn of(mut groups: Vec<Group>, products: usize) -> Groups {
        let (sides, mut of_group) = sides(&groups);
        // Groups that share factors are adjacent.
        let mut order = (0..groups.len()).collect::<Vec<_>>();
        order.sort_by_key(|&group| of_group[group]);
        groups = order.iter().map(|&group| groups[group].clone()).collect();
        of_group = order.iter().map(|&group| of_group[group]).collect();
        let mut of_product = vec![[0; 2]; products];
        for (place, group) in groups.iter().enumerate() {
            for (lane, &(_, _, product)) in group.iter().enumerate() {
                of_product[product] = [place, lane];
            }
        }
        let others = groups.iter().map(|group| group.iter().map(|(_, b, _)| *b).collect::<Vec<_>>());
        let groups = others.map(|others| filled(&others)).collect();
        Groups { shared: sides.iter().map(|side| filled(side)).collect(), groups, of_group, of_product }
    }
}

impl Star {
    fn products(&self) -> impl Iterator<Item = (usize, usize, usize)> + '_ {
        self.others.iter().map(|&(product, other)| (self.factor, other, product))
    }
}

/// Groups products so that few registers are loaded.
fn with_few_loads(products: &[Product]) -> Vec<Group> {
    let stars = stars(products);
    let layers = (0..).map(|layer| row(&stars, layer)).take_while(|row| !row.is_empty());
    let layered = layers.flat_map(|layer| chunks(&layer)).collect::<Vec<_>>();
    let listed = chunks(&stars.iter().flat_map(Star::products).collect::<Vec<_>>());
    let loads = |groups: &[Group]| groups.len() + sides(groups).0.len();
    if loads(&layered) < loads(&listed) { layered } else { listed }
}

/// Returns the shared factors of groups, and the index of those of each group.
fn sides(groups: &[Group]) -> (Vec<Vec<usize>>, Vec<usize>) {
    let mut sides: Vec<Vec<usize>> = Vec::new();
    let mut side_of = |group: &Group| {
        let side = group.iter().map(|(a, _, _)| *a).collect::<Vec<_>>();
        sides.iter().position(|known| known.starts_with(&side)).unwrap_or_else(|| {
            sides.push(side);
            sides.len() - 1
        })
    };
    let of_group = groups.iter().map(&mut side_of).collect();
    (sides, of_group)
}

/// Assigns each product to one of its factors, the most frequent factors first.
fn stars(products: &[Product]) -> Vec<Star> {
    let mut left = products.to_vec();
    let mut stars = Vec::new();
    while !left.is_empty() {
        let mut counts: OrderedMap<usize, usize> = OrderedMap::default();
        for &(_, [a, b]) in &left {
            *counts.get_or_insert_with(a, || 0) += 1;
            if a != b {
                *counts.get_or_insert_with(b, || 0) += 1;
            }
        }
        // Factors that are not entries of the state have later places.
        let (&factor, _) =
            counts.iter().max_by_key(|(factor, count)| (**count, **factor)).expect("some left");
        let (taken, rest) = left.into_iter().partition(|(_, factors)| factors.contains(&factor));
        left = rest;
        let taken: Vec<Product> = taken;
        let others = taken.iter().map(|&(product, [a, b])| (product, if a == factor { b } else { a }));
        stars.push(Star { factor, others: others.collect() });
    }
    stars
}

/// Returns one product of each factor that has enough products. Later layers have fewer products.
fn row(stars: &[Star], layer: usize) -> Group {
    stars.iter().filter_map(|star| star.products().nth(layer)).collect()
}

fn chunks(products: &[(usize, usize, usize)]) -> Vec<Group> {
    products.chunks(GROUP).map(<[_]>::to_vec).collect()
}

/// Returns four places, repeating the last one.
fn filled(places: &[usize]) -> [usize; GROUP] {
    std::array::from_fn(|lane| places[lane.min(places.len() - 1)])
}

#[cfg(test)]
mod tests {
    use super::{Groups, with_few_loads};

    fn grouped(products: &[[usize; 2]]) -> Groups {
        let numbered = products.iter().copied().enumerate().collect::<Vec<_>>();
        Groups::of(with_few_loads(&numbered), products.len())
    }

    /// Sines and cosines at places 4 to 7, velocities at 2 and 3, forces from 8 on.
    #[test]
    fn a_double_pendulum_has_one_shared_side() {
        let products = [[2, 4], [2, 5], [3, 6], [3, 7], [4, 8], [5, 9], [6, 10], [7, 11]];
        let groups = grouped(&products);
        assert_eq!(groups.shared.len(), 1);
        assert_eq!(groups.groups.len(), 2);
        assert_eq!(groups.of_group, [0, 0]);
    }

    #[test]
    fn every_product_has_its_factors_at_its_place() {
        let all = (0..7).flat_map(|a| (a..7).map(move |b| [a, b])).collect::<Vec<_>>();
        for count in 0..=all.len() {
            for step in 1..=5 {
                let products = all.iter().copied().step_by(step).take(count).collect::<Vec<_>>();
                let groups = grouped(&products);
                assert!(groups.loads() <= 2 * products.len().div_ceil(4), "{products:?}");
                for (product, factors) in products.iter().enumerate() {
                    let [group, lane] = groups.of_product[product];
                    let (a, b) = (groups.shared[groups.of_group[group]][lane], groups.groups[group][lane]);
                    assert_eq!([a.min(b), a.max(b)], *factors);
                }
            }
        }
    }
}
