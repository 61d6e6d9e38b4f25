//! Measurements as Markdown tables.

use std::fmt::Write;

use super::crate_of_variants::Variant;
use super::ideas::{Chain, Idea};

/// Times of two functions measured alternately.
#[derive(Clone, Debug)]
pub(super) struct Times {
    first: f64,
    second: f64,
    ratio: f64,
}

impl Times {
    fn read(cells: &[&str]) -> Option<Times> {
        let [first, second, ratio] = cells else { return None };
        Some(Times { first: first.parse().ok()?, second: second.parse().ok()?, ratio: ratio.parse().ok()? })
    }
}

/// A row of benches/comparison.rs, or of benches/spatial, whose last name is the computed quantity.
#[derive(Clone, Debug)]
pub(super) struct Comparison {
    level: String,
    chain: String,
    other: String,
    times: Times,
}

impl Comparison {
    pub(super) fn read(cells: &[&str]) -> Option<Comparison> {
        let [level, chain, other] =
            [cells.first()?, cells.get(1)?, cells.get(2)?].map(|&cell| cell.to_owned());
        Some(Comparison { level, chain, other, times: Times::read(cells.get(3..)?)? })
    }
}

/// A row printed by the crate of variants.
#[derive(Clone, Debug)]
pub(super) struct Measured {
    chain: String,
    idea: usize,
    times: Times,
}

impl Measured {
    pub(super) fn read(cells: &[&str]) -> Option<Measured> {
        let (&chain, idea) = (cells.first()?, cells.get(1)?.parse().ok()?);
        Some(Measured { chain: chain.to_owned(), idea, times: Times::read(cells.get(2..)?)? })
    }
}

/// Returns the chains of a level in the order of measurement.
fn chains<'a>(level: &str, compared: &'a [Comparison]) -> Vec<&'a str> {
    let mut chains = Vec::new();
    for row in compared.iter().filter(|row| row.level == level) {
        if !chains.contains(&row.chain.as_str()) {
            chains.push(&row.chain);
        }
    }
    chains
}

/// Returns the measurements on all targets in a cell: `1.02 / 0.97`, or nothing.
fn on_targets(
    targets: &[Vec<Comparison>],
    level: &str,
    chain: &str,
    other: Option<&str>,
    show: impl Fn(&Times) -> String,
) -> String {
    let of_target = |compared: &Vec<Comparison>| {
        let is_wanted = |row: &&Comparison| {
            row.level == level && row.chain == chain && other.is_none_or(|other| row.other == other)
        };
        // The fastest of several measurements was disturbed least.
        let rows = compared.iter().filter(is_wanted);
        rows.min_by(|a, b| a.times.first.total_cmp(&b.times.first)).map(|row| show(&row.times))
    };
    targets.iter().filter_map(of_target).collect::<Vec<_>>().join(" / ")
}

fn nanoseconds(times: &Times) -> String {
    format!("{:.0}", times.first)
}

/// Formats a ratio; bold if the emitted code is slower.
fn ratio(times: &Times) -> String {
    let shown = format!("{:.2}", times.ratio);
    if times.ratio > 1.05 { format!("**{shown}**") } else { shown }
}

/// Returns times of a level and ratios to each hand-written variant, on the default and native
/// targets.
pub(super) fn beside_by_hand(level: &str, targets: &[Vec<Comparison>]) -> String {
    let mut table = "| chain | emitted, ns | to straight line | to articulated bodies | to massless rods |\n\
                     |---|---|---|---|---|\n"
        .to_owned();
    for chain in chains(level, &targets[0]) {
        let _ = write!(table, "| {chain} | {} |", on_targets(targets, level, chain, None, nanoseconds));
        for way in ["straight line", "articulated", "massless rods"] {
            let _ = write!(table, " {} |", on_targets(targets, level, chain, Some(way), ratio));
        }
        table.push('\n');
    }
    table
}

/// Returns the time of `strict` and its ratio to `standard`.
pub(super) fn strict(targets: &[Vec<Comparison>]) -> String {
    let mut table = "| chain | `strict`, ns | to `standard` |\n|---|---|---|\n".to_owned();
    for chain in chains("strict", &targets[0]) {
        let time = on_targets(targets, "strict", chain, None, nanoseconds);
        let ratio = on_targets(targets, "strict", chain, None, |times| format!("{:.2}", times.ratio));
        let _ = writeln!(table, "| {chain} | {time} | {ratio} |");
    }
    table
}

/// Returns robots, computed quantities, and both times.
pub(super) fn spatial(targets: &[Vec<Comparison>]) -> String {
    let mut table = "| robot | | emitted, ns | by hand, ns | ratio |\n|---|---|---|---|---|\n".to_owned();
    for Comparison { level, chain, other, .. } in &targets[0] {
        let cell = |show: fn(&Times) -> String| on_targets(targets, level, chain, Some(other), show);
        let by_hand = cell(|times| format!("{:.0}", times.second));
        let what = if level == "standard" { other.clone() } else { format!("{other}, `{level}`") };
        let _ = writeln!(table, "| {chain} | {what} | {} | {by_hand} | {} |", cell(nanoseconds), cell(ratio));
    }
    table
}

/// Returns counted operations, in total and per link.
pub(super) fn growth(counted: &[(Chain, usize)]) -> String {
    let mut table = "| chain | operations | for each link |\n|---|---|---|\n".to_owned();
    for (chain, operations) in counted {
        let each = *operations as f64 / chain.links as f64;
        let _ = writeln!(table, "| {} | {operations} | {each:.1} |", chain.title());
    }
    table
}

/// Returns operations and times with an idea disabled, relative to those with all ideas.
pub(super) fn ideas(
    ideas: &[Idea],
    variants: &[Variant],
    chains: &[Chain],
    targets: &[Vec<Measured>],
) -> String {
    let titles = chains.iter().map(|chain| chain.title()).collect::<Vec<_>>().join(" | ");
    let mut table = format!("| instead | {titles} |\n|---|{}\n", "---|".repeat(chains.len()));
    let operations = |idea: usize, chain: Chain| {
        let variant = variants.iter().find(|variant| variant.idea == idea && variant.chain == chain);
        variant.map_or(0, |variant| variant.derivation.operations()) as f64
    };
    for (index, idea) in ideas.iter().enumerate() {
        let Some(base) = variants.iter().find(|variant| variant.idea == index).map(|variant| variant.base)
        else {
            continue;
        };
        if index == base {
            continue;
        }
        let cells = chains.iter().map(|&chain| {
            let counted = operations(index, chain) / operations(base, chain);
            let is_wanted = |row: &&Measured| row.idea == index && row.chain == chain.title();
            let measured = targets.iter().filter_map(|rows| rows.iter().find(is_wanted));
            let measured = measured.map(|row| format!(" / {:.2}", row.times.ratio)).collect::<String>();
            format!("{counted:.2}{measured}")
        });
        let _ = writeln!(table, "| {} | {} |", idea.title, cells.collect::<Vec<_>>().join(" | "));
    }
    table
}
