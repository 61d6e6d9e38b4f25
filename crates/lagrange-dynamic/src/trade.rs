//! The cost of accuracy of a motion, by method.

use lagrange_runtime::contact::Stepped;
use lagrange_runtime::integrate::{PlainGaussLegendre, Radau5, RungeKutta4, Taylor, Verner98};
use lagrange_runtime::trade::{Knob, Report, Trade};

use crate::declared::{DeclaredSystem, Visitor};
use crate::inline::Inline;
use crate::method::NAMES;
use crate::reactions::in_room;
use crate::system::DynamicSystem;

/// Measures the motion of a system from time zero to an end, by each method with coarse to fine
/// settings. Taylor series are among them if the system has them, and steps if it has contacts or
/// friction. Variants of the report are names of a [`MethodChoice`](crate::MethodChoice). Settings
/// finer than one that took `longest` seconds are not tried. Errors are differences from the finest
/// run, and include the final time if an event stopped it.
pub fn trade(system: &DeclaredSystem, start: &[f64], end: f64, longest: f64) -> Report {
    system.visit(Contest { name: &system.programs().name, start, end, longest })
}

struct Contest<'a> {
    name: &'a str,
    start: &'a [f64],
    end: f64,
    longest: f64,
}

impl Visitor for Contest<'_> {
    type Output = Report;

    fn visit<const CAPACITY: usize>(self, system: &DynamicSystem<CAPACITY>) -> Report {
        let from = |entries: &[f64]| system.state(entries);
        let to = |state: &Inline<CAPACITY>| state.as_ref().to_vec();
        let [verner, radau, taylor, rk4, gauss, stepped, ..] = NAMES;
        let trade = Trade::without_methods(self.name, self.start.to_vec(), self.end).longest(self.longest);
        let trade = match system.is_touching() {
            true => in_room!(system, V, R, {
                trade.method(stepped, system, Knob::Step, Stepped::<f64, V, R>::every, (from, to))
            }),
            false => trade,
        };
        let trade = trade
            .method(verner, system, Knob::Tolerance, Verner98::tolerance, (from, to))
            .method(radau, system, Knob::Tolerance, Radau5::tolerance, (from, to))
            .method(rk4, system, Knob::Step, |step| RungeKutta4 { step }, (from, to))
            .method(gauss, system, Knob::Step, |step| PlainGaussLegendre::<f64, 3> { step }, (from, to));
        match system.names.without_series {
            None => trade.method(taylor, system, Knob::Tolerance, Taylor::tolerance, (from, to)).run(),
            Some(_) => trade.run(),
        }
    }
}
