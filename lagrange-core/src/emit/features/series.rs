//! Programs of the Taylor series of a motion, from its equations in the cheaper form.

use crate::derive::{Equations, Switch};
use crate::emit::base::exclusion::Exclusion;
use crate::emit::base::messages;
use crate::emit::base::refusal::Refusal;
use crate::emit::base::sides::on_sides;
use crate::model::{Model, Product};
use lagrange_algebra::program::{Labels, ValueId, lower};
use lagrange_algebra::series::{
    Entry, Motion, NoSeries, Rate, SeriesPrograms, expand, function_rates, without_long_powers,
};
use lagrange_expr::expr::ExprId;

/// Parts of a system that series do not support.
const EXCLUSIONS: [Exclusion; 5] =
    [Exclusion::Contacts, Exclusion::Redundant, Exclusion::Indefinite, Exclusion::Noise, Exclusion::Delays];

/// The reason why a motion has no series.
pub(super) enum WithoutSeries {
    /// Series do not support this part of the system.
    Exclusion(Exclusion),
    /// A value has no series.
    Form(NoSeries),
}

impl WithoutSeries {
    /// Returns the refusal of the product.
    pub(super) fn refusal(self) -> Refusal {
        match self {
            WithoutSeries::Exclusion(exclusion) => Refusal::Exclusion(Product::Taylor, exclusion),
            WithoutSeries::Form(cause) => Refusal::Series(cause),
        }
    }
}

/// Derives the programs of a motion on the sides of these switches.
///
/// # Errors
/// With a message, if the motion has no series.
pub fn series_programs(
    model: &mut Model,
    equations: &Equations,
    switches: &[Switch],
) -> Result<SeriesPrograms, String> {
    derived_series(model, equations, switches).map_err(|refusal| match refusal {
        WithoutSeries::Exclusion(exclusion) => messages::excluded(Product::Taylor.name(), exclusion.words()),
        WithoutSeries::Form(cause) => messages::without_series(&cause),
    })
}

/// Derives the programs, or returns the reason why the motion has no series.
pub(super) fn derived_series(
    model: &mut Model,
    equations: &Equations,
    switches: &[Switch],
) -> Result<SeriesPrograms, WithoutSeries> {
    if let Some(exclusion) = Exclusion::first(&EXCLUSIONS, model, equations) {
        return Err(WithoutSeries::Exclusion(exclusion));
    }
    let explicit = programs(model, equations, switches, Form::Accelerations);
    let implicit = programs(model, equations, switches, Form::Residuals);
    cheaper(explicit, implicit).map_err(WithoutSeries::Form)
}

/// The form of the equations that series are derived from.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    /// Accelerations as functions of the state.
    Accelerations,
    /// Residuals that accelerations make zero.
    Residuals,
}

/// Returns the programs of the form with fewer products.
fn cheaper(
    explicit: Result<SeriesPrograms, NoSeries>,
    implicit: Result<SeriesPrograms, NoSeries>,
) -> Result<SeriesPrograms, NoSeries> {
    match (explicit, implicit) {
        (Ok(explicit), Ok(implicit)) if implicit.sums.len() < explicit.sums.len() => Ok(implicit),
        (Err(_), implicit @ Ok(_)) => implicit,
        (explicit, _) => explicit,
    }
}

fn programs(
    model: &mut Model,
    equations: &Equations,
    switches: &[Switch],
    form: Form,
) -> Result<SeriesPrograms, NoSeries> {
    let state = [model.positions(), model.velocities()].concat();
    let mut rates = model.position_rates();
    let (mut unexpanded, mut residuals) = (Vec::new(), Vec::new());
    match (form, &equations.series) {
        (Form::Residuals, Some(series)) => {
            unexpanded.clone_from(&series.unexpanded);
            residuals.clone_from(&series.residuals);
        }
        _ => rates.extend(&equations.accelerations),
    }
    let velocities = unexpanded.iter().map(|(_, of)| *of);
    let roots = rates.iter().copied().chain(velocities).chain(residuals.iter().copied());
    let roots = roots.collect::<Vec<_>>();
    let roots = on_sides(&mut model.graph, &Labels::default(), switches, &roots).roots;
    let functions = function_rates(&mut model.graph, &roots);
    let mut all = [state.clone(), roots].concat();
    all.extend(functions.iter().flat_map(|(value, rate)| [*value, *rate]));
    let program = without_long_powers(&lower(&model.graph, &all, &Labels::default()));
    let mut outputs = Outputs(program.outputs());
    let entries = outputs.take(state.len());
    let mut known = outputs.take(rates.len()).iter();
    let entry = |(index, &value): (usize, &ValueId)| {
        let unknown = || Rate::Acceleration((index - rates.len()) as u32);
        Entry { value, rate: known.next().map_or_else(unknown, |&rate| Rate::Value(rate)) }
    };
    let entries = entries.iter().enumerate().map(entry).collect::<Vec<_>>();
    let role = |id: ExprId| model.graph.symbol_of(id).map(|symbol| symbol.role);
    let of = outputs.take(unexpanded.len()).iter();
    let unexpanded = unexpanded.iter().zip(of).filter_map(|((symbol, _), &of)| Some((role(*symbol)?, of)));
    let unexpanded = unexpanded.collect::<Vec<_>>();
    let residuals = outputs.take(residuals.len());
    let rates = outputs.take(2 * functions.len()).chunks_exact(2).map(|pair| (pair[0], pair[1]));
    let rates = rates.collect::<Vec<_>>();
    let motion =
        Motion { program: &program, state: &entries, rates: &rates, unexpanded: &unexpanded, residuals };
    expand(&motion)
}

/// The outputs of a program, split into consecutive groups.
struct Outputs<'a>(&'a [ValueId]);

impl<'a> Outputs<'a> {
    fn take(&mut self, count: usize) -> &'a [ValueId] {
        let (first, rest) = self.0.split_at(count);
        self.0 = rest;
        first
    }
}
