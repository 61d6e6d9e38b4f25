//! Sums of products of sines and cosines with as few terms as possible, so that little cancels.
//!
//! Products of sines and cosines are written as sums of waves, which are sin or cos of a sum of
//! angles. Terms of these sums cancel exactly. The remainder is combined into products again:
//!
//! ```text
//! cos a cos b = ½ cos(a − b) + ½ cos(a + b),     cos a − cos b = −2 sin((a + b)/2) sin((a − b)/2), …
//! ```
//!
//! (Abramowitz and Stegun, §4.3.31–37). Examples:
//! - sin a cos b − cos a sin b becomes sin(a − b), where the angles are subtracted before the sine
//!   is computed;
//! - m₁ + m₂ − m₂ cos² a becomes m₁ + m₂ sin² a;
//! - 1 − cos a becomes 2 sin²(a/2).

use std::collections::BTreeMap;

use super::angle::{Angles, Wave};
use super::monomial::{Monomial, Term};
use crate::calculus::rebuild;
use lagrange_expr::collections::{HashMap, OrderedMap};
use lagrange_expr::expr::{ExprId, Function, Graph, Node};
use lagrange_expr::functions::apply;
use lagrange_expr::number::Number;

/// Maximum number of sines and cosines in a product that is written as a sum of waves: n of them
/// yield 2ⁿ⁻¹ terms.
const MAX_WAVES: usize = 4;
/// Maximum number of terms of a contracted sum, since all pairs of its waves are compared.
const MAX_TERMS: usize = 64;

/// A number times sines and cosines.
#[derive(Clone, Debug)]
struct WaveProduct {
    coefficient: Number,
    waves: Vec<Wave>,
}

/// Terms of a sum with the same cofactor.
#[derive(Default)]
struct Group {
    terms: Vec<(ExprId, Number)>,
    products: Vec<WaveProduct>,
}

/// Returns `Σ coefficient · term` with fewer terms, if possible, and the same terms otherwise.
/// `angles` caches the forms of angles.
pub fn contract(graph: &mut Graph, angles: &mut Angles, terms: Vec<(ExprId, Number)>) -> ExprId {
    if terms.len() < 2 || terms.len() > MAX_TERMS {
        return graph.sum(Number::ZERO, terms);
    }
    let mut groups: OrderedMap<Monomial, Group> = OrderedMap::default();
    let mut left = Vec::new();
    for (term, coefficient) in terms {
        match read(graph, angles, term, &coefficient) {
            Some((cofactor, product)) => {
                let group = groups.get_or_insert_with(cofactor, Group::default);
                group.terms.push((term, coefficient));
                group.products.push(product);
            }
            None => left.push((term, coefficient)),
        }
    }
    for (cofactor, group) in groups.iter() {
        if group.terms.len() < 2 {
            left.extend(group.terms.iter().cloned());
            continue;
        }
        let gathered = gather(&group.products);
        // If the number of terms does not decrease, shared sines would merely be replaced by
        // others.
        if gathered.len() < group.terms.len() {
            left.extend(gathered.iter().map(|product| build(graph, angles, cofactor, product)));
        } else {
            left.extend(group.terms.iter().cloned());
        }
    }
    graph.sum(Number::ZERO, left)
}

/// Returns the expressions with every sum in them contracted.
pub fn contract_all(graph: &mut Graph, angles: &mut Angles, exprs: &[ExprId]) -> Vec<ExprId> {
    let mut image: HashMap<ExprId, ExprId> = HashMap::default();
    for id in graph.reachable(exprs) {
        let moved = rebuild(graph, id, |child| image.get(&child).copied().unwrap_or(child));
        let contracted = match graph.node(moved).clone() {
            Node::Sum { constant, terms } => {
                let mut terms = terms.into_vec();
                if !constant.is_zero() {
                    terms.push((graph.number(1), constant));
                }
                contract(graph, angles, terms)
            }
            _ => moved,
        };
        image.insert(id, contracted);
    }
    exprs.iter().map(|expr| image.get(expr).copied().unwrap_or(*expr)).collect()
}

/// Splits a term into a cofactor and a product of waves; `None` if it has too many factors.
fn read(
    graph: &Graph,
    angles: &mut Angles,
    term: ExprId,
    coefficient: &Number,
) -> Option<(Monomial, WaveProduct)> {
    let Term { coefficient, monomial } = Term::of(graph, term, coefficient);
    let (mut cofactor, mut waves) = (Vec::new(), Vec::new());
    for (base, exponent) in monomial.factors() {
        let wave = match graph.node(*base) {
            Node::Call(function @ (Function::Sin | Function::Cos), x) => {
                Some(Wave { is_sine: *function == Function::Sin, angle: angles.read(graph, x[0]) })
            }
            _ => None,
        };
        match (wave, exponent.to_i32().map(usize::try_from)) {
            (Some(_), Some(Ok(power))) if power > MAX_WAVES - waves.len() => return None,
            (Some(wave), Some(Ok(power))) => waves.extend(std::iter::repeat_n(wave, power)),
            _ => cofactor.push((*base, exponent.clone())),
        }
    }
    Some((Monomial::new(cofactor), WaveProduct { coefficient, waves }))
}

/// Writes the sum of the products with as few products as possible.
fn gather(products: &[WaveProduct]) -> Vec<WaveProduct> {
    let mut sum: BTreeMap<Wave, Number> = BTreeMap::new();
    for product in products {
        for (wave, coefficient) in waves_of(product) {
            let total = sum.entry(wave).or_insert(Number::ZERO);
            *total = &*total + &coefficient;
        }
    }
    sum.retain(|wave, coefficient| !coefficient.is_zero() && !wave.is_zero());
    let single = |(wave, coefficient): (Wave, Number)| WaveProduct { coefficient, waves: vec![wave] };
    let mut gathered = sum.into_iter().map(single).collect::<Vec<_>>();
    while let Some((i, j, merged)) = first_pair(&gathered) {
        gathered.swap_remove(j);
        gathered[i] = merged;
    }
    gathered
}

/// Expands a product of sines and cosines to a sum.
fn waves_of(product: &WaveProduct) -> Vec<(Wave, Number)> {
    let mut sum = vec![(Wave::one(), product.coefficient.clone())];
    for factor in &product.waves {
        sum = sum.iter().flat_map(|(wave, c)| times(wave, factor, c)).collect();
    }
    sum
}

/// Applies sin a sin b = ½ cos(a − b) − ½ cos(a + b) and similar identities.
fn times(a: &Wave, b: &Wave, coefficient: &Number) -> [(Wave, Number); 2] {
    let half = &Number::HALF * coefficient;
    let (sum, difference) = (a.angle.plus(&b.angle), a.angle.minus(&b.angle));
    let is_sine = a.is_sine != b.is_sine;
    let sum_sign = if a.is_sine && b.is_sine { -&half } else { half.clone() };
    let difference_sign = if b.is_sine && !a.is_sine { -&half } else { half };
    [Wave::signed(is_sine, sum, sum_sign), Wave::signed(is_sine, difference, difference_sign)]
}

/// Finds two products that can be merged, and the merged product.
fn first_pair(products: &[WaveProduct]) -> Option<(usize, usize, WaveProduct)> {
    for (j, b) in products.iter().enumerate() {
        for (i, a) in products[..j].iter().enumerate() {
            if let Some(merged) = merge(a, b) {
                return Some((i, j, merged));
            }
        }
    }
    None
}

/// Writes `A·w·f(a) ± A·w·f(b)` as a single product.
fn merge(a: &WaveProduct, b: &WaveProduct) -> Option<WaveProduct> {
    if a.coefficient.abs() != b.coefficient.abs() || a.waves.len() != b.waves.len() {
        return None;
    }
    let mut common = a.waves.clone();
    let mut other = b.waves.clone();
    common.retain(|wave| match other.iter().position(|w| w == wave) {
        Some(position) => {
            other.remove(position);
            true
        }
        None => false,
    });
    let [y] = other.as_slice() else { return None };
    let x = a.waves.iter().find(|wave| {
        let count = |waves: &[Wave]| waves.iter().filter(|w| w == wave).count();
        count(&a.waves) > count(&common)
    })?;
    let (waves, coefficient) = sum_to_product(x, y, &a.coefficient, a.coefficient != b.coefficient)?;
    common.extend(waves.into_iter().filter(|wave| !wave.is_one()));
    common.sort();
    Some(WaveProduct { coefficient, waves: common })
}

/// Turns a sum into a product of functions of (a + b)/2 and (a − b)/2, by these identities:
/// - cos a + cos b = 2 cos cos;
/// - cos a − cos b = −2 sin sin;
/// - sin a ± sin b = 2 sin cos.
fn sum_to_product(
    x: &Wave,
    y: &Wave,
    coefficient: &Number,
    is_difference: bool,
) -> Option<([Wave; 2], Number)> {
    if x.is_sine != y.is_sine {
        return None;
    }
    let mean = x.angle.plus(&y.angle).scaled(&Number::HALF);
    let spread = x.angle.minus(&y.angle).scaled(&Number::HALF);
    let twice = &Number::TWO * coefficient;
    let (mean_is_sine, spread_is_sine, sign) = match (x.is_sine, is_difference) {
        (false, false) => (false, false, twice),
        (false, true) => (true, true, -&twice),
        (true, false) => (true, false, twice),
        (true, true) => (false, true, twice),
    };
    let (mean, sign) = Wave::signed(mean_is_sine, mean, sign);
    let (spread, coefficient) = Wave::signed(spread_is_sine, spread, sign);
    Some(([mean, spread], coefficient))
}

fn build(
    graph: &mut Graph,
    angles: &mut Angles,
    cofactor: &Monomial,
    product: &WaveProduct,
) -> (ExprId, Number) {
    let mut factors = cofactor.factors().to_vec();
    for wave in product.waves.iter().filter(|wave| !wave.is_one()) {
        let angle = angles.write(graph, &wave.angle);
        let function = if wave.is_sine { Function::Sin } else { Function::Cos };
        factors.push((apply(graph, function, &[angle]), Number::ONE));
    }
    (graph.product(factors), product.coefficient.clone())
}
