//! Models without cyclic coordinates, by Routh's reduction.
//!
//! If L does not depend on the coordinates φ and nothing acts on them, their momenta p = ∂L/∂φ̇ are
//! constant. The Routhian R = L − pᵀφ̇, with φ̇ as a function of p, is a Lagrangian of the other
//! coordinates, since ∂R/∂v = ∂L/∂v and ∂R/∂q = ∂L/∂q. Sources: Goldstein, Poole and Safko,
//! *Classical Mechanics*, 3rd ed., §8.3; Routh, *Stability of a Given State of Motion*, 1877.
//!
//! L is quadratic in velocities: L = L₀ + aᵀφ̇ + ½ φ̇ᵀM φ̇, where L₀ and a are the values at
//! φ̇ = 0. Then M φ̇ = p − a and R = L₀ − ½ (p − a)ᵀM⁻¹(p − a), a sum of squares by elimination.
//!
//! In loads φ̇ is replaced, both in forces and in the velocities along which they act. This adds
//! ∂φ̇/∂v times the force on φ to generalised forces, which is zero.
//!
//! In numbers, a spherical pendulum of m = l = 1 has L = ½ (θ̇² + sin² θ φ̇²) − V. At sin θ = 1/2,
//! p = 1/2 means φ̇ = p/sin² θ = 2, and R = ½ θ̇² − V − p²/(2 sin² θ) has −1/2 as its last term.
//!
//! The coordinates remain in the state, with φ̇ as their rates. Outputs may still depend on them.

use super::ignored::{Obstacle, Refusal, deciding, independent, vanish};
use super::pinned::holding;
use super::symmetric::{Solution, solve};
use crate::model::{Coordinate, Energies, Load, Model, Parameter, Pinned, Reduction};
use lagrange_algebra::calculus::{
    AccelerationTerms, Expansion, Rates, adjoint, gradient, substitute, substitute_all,
};
use lagrange_expr::collections::HashMap;
use lagrange_expr::expr::{Dependencies, ExprId, Node};
use lagrange_expr::number::Number;
use lagrange_expr::symbol::Role;
use lagrange_language::syntax::ast::{Name, momentum_of};

/// A cyclic coordinate with its velocity and acceleration.
struct Cyclic {
    pinned: Pinned,
    position: ExprId,
    /// Index of the velocity.
    speed: usize,
    velocity: ExprId,
    acceleration: ExprId,
}

/// Returns the model with ignored coordinates as states and their momenta as parameters.
/// Coordinates and velocities keep their indices.
pub(super) fn routhian(model: &Model, reduction: &Reduction) -> Result<Model, Refusal> {
    let mut routh = Routh::new(model, reduction);
    routh.check_cyclic()?;
    routh.check_loads()?;
    let lagrangian = routh.lagrangian()?;
    routh.reconstruct();
    Ok(routh.model(lagrangian))
}

struct Routh {
    /// The whole model; parts are added to its graph.
    model: Model,
    cyclic: Vec<Cyclic>,
    /// Expressions with frozen coordinates at their values.
    frozen: Expansion,
    /// Expressions with ignored coordinates also at rest at zero.
    resting: Expansion,
    /// The added parameters.
    momenta: Vec<ExprId>,
    /// The velocities of ignored coordinates as functions of the others and of momenta.
    rates: Vec<ExprId>,
    /// These velocities and their rates, by the symbols that they replace.
    replacements: HashMap<ExprId, ExprId>,
}

impl Routh {
    fn new(model: &Model, reduction: &Reduction) -> Routh {
        let mut model = model.clone();
        let zero = model.graph.number(0);
        let frozen = holding(&model, &reduction.frozen, zero);
        let held = [&reduction.frozen[..], &reduction.ignored].concat();
        let resting = holding(&model, &held, zero);
        let mut cyclic = Vec::new();
        for pinned in &reduction.ignored {
            let speeds = model.speeds.iter().enumerate();
            let own = speeds.filter(|(_, speed)| speed.coordinate == Some(pinned.coordinate));
            cyclic.extend(own.map(|(index, speed)| Cyclic {
                pinned: pinned.clone(),
                position: model.coordinates[pinned.coordinate].position,
                speed: index,
                velocity: speed.velocity,
                acceleration: speed.acceleration,
            }));
        }
        let (momenta, rates, replacements) = (Vec::new(), Vec::new(), HashMap::default());
        Routh { model, cyclic, frozen, resting, momenta, rates, replacements }
    }

    fn refusal(&self, index: usize, obstacle: Obstacle) -> Refusal {
        Refusal { pinned: self.cyclic[index].pinned.clone(), obstacle }
    }

    fn positions(&self) -> Vec<ExprId> {
        self.cyclic.iter().map(|cyclic| cyclic.position).collect()
    }

    fn velocities(&self) -> Vec<ExprId> {
        self.cyclic.iter().map(|cyclic| cyclic.velocity).collect()
    }

    /// Returns an expression with frozen coordinates at their values. It is unchanged if that is
    /// undefined, which is reported when the model is reduced.
    fn frozen(&mut self, id: ExprId) -> ExprId {
        self.frozen.of(&mut self.model.graph, id, 0).map_or(id, |series| series.closed)
    }

    fn check_cyclic(&mut self) -> Result<(), Refusal> {
        let lagrangian = self.frozen(self.model.lagrangian);
        let positions = self.positions();
        let fit = independent(&mut self.model, &[lagrangian], &positions);
        self.check(&fit, Obstacle::Energy)
    }

    /// Rejects the first unsuitable coordinate.
    fn check(&self, fit: &[bool], obstacle: Obstacle) -> Result<(), Refusal> {
        match fit.iter().position(|fits| !fits) {
            Some(index) => Err(self.refusal(index, obstacle)),
            None => Ok(()),
        }
    }

    /// Checks that neither loads nor dissipation act on ignored coordinates.
    fn check_loads(&mut self) -> Result<(), Refusal> {
        let velocities = self.velocities();
        let forces = self.forces(&self.model.loads.clone(), &velocities);
        for (index, vanishes) in vanish(&mut self.model, &forces).into_iter().enumerate() {
            if !vanishes {
                let name = self.load_on(velocities[index]);
                return Err(self.refusal(index, Obstacle::Load(name)));
            }
        }
        let dissipation = self.frozen(self.model.dissipation);
        let resistances = gradient(&mut self.model.graph, dissipation, &velocities);
        let fit = vanish(&mut self.model, &resistances);
        self.check(&fit, Obstacle::Dissipation)
    }

    /// Returns the generalised forces of loads along velocities.
    fn forces(&mut self, loads: &[Load], velocities: &[ExprId]) -> Vec<ExprId> {
        let seeds = loads.iter().map(|load| (self.frozen(load.velocity), self.frozen(load.force)));
        let seeds = seeds.collect::<Vec<_>>();
        adjoint(&mut self.model.graph, &seeds, velocities)
    }

    /// Returns the name of the first statement whose loads act along a velocity.
    fn load_on(&mut self, velocity: ExprId) -> Option<String> {
        let loads = self.model.loads.clone();
        for statement in loads.chunk_by(|a, b| a.name == b.name) {
            let forces = self.forces(statement, &[velocity]);
            if vanish(&mut self.model, &forces) != [true] {
                return Some(statement[0].name.clone());
            }
        }
        None
    }

    /// Computes the Routhian, and the velocities of ignored coordinates on the way.
    fn lagrangian(&mut self) -> Result<ExprId, Refusal> {
        let velocities = self.velocities();
        let lagrangian = self.frozen(self.model.lagrangian);
        self.check_pieces(lagrangian, &velocities)?;
        let momenta = gradient(&mut self.model.graph, lagrangian, &velocities);
        let (mut matrix, mut rests) = (Vec::new(), Vec::new());
        for (index, &momentum) in momenta.iter().enumerate() {
            let row = gradient(&mut self.model.graph, momentum, &velocities);
            if row.iter().any(|&entry| self.depends_on_velocities(entry)) {
                return Err(self.refusal(index, Obstacle::Nonlinear));
            }
            let row = row.into_iter().map(|entry| self.defined_at_rest(index, entry));
            matrix.push(row.collect::<Result<Vec<_>, _>>()?);
            let known = self.defined_at_rest(index, momentum)?;
            let parameter = self.add_momentum(index);
            rests.push(self.model.graph.subtract(parameter, known));
        }
        let resting = self.defined_at_rest(0, lagrangian)?;
        let solved = solve(&mut self.model, matrix, rests);
        let Solution { values, square } = solved.map_err(|i| self.refusal(i, Obstacle::Undetermined))?;
        self.rates = values;
        let half = self.model.graph.scale(Number::HALF, square);
        Ok(self.model.graph.subtract(resting, half))
    }

    /// Rejects a piecewise Lagrangian, unless its pieces are the same for all velocities of ignored
    /// coordinates.
    fn check_pieces(&mut self, lagrangian: ExprId, velocities: &[ExprId]) -> Result<(), Refusal> {
        let deciding = deciding(&mut self.model.graph, &[lagrangian]);
        let fit = independent(&mut self.model, &deciding, velocities);
        self.check(&fit, Obstacle::Nonlinear)
    }

    fn depends_on_velocities(&mut self, id: ExprId) -> bool {
        if !self.model.graph.dependencies(id).intersects(Dependencies::VELOCITY) {
            return false;
        }
        let velocities = self.model.velocities();
        independent(&mut self.model, &[id], &velocities).contains(&false)
    }

    /// True for values that do not depend on ignored coordinates.
    fn are_alike(&mut self, values: &[ExprId]) -> bool {
        let positions = self.positions();
        !independent(&mut self.model, values, &positions).contains(&false)
    }

    /// Returns an expression with ignored coordinates at rest at zero; `None` if it is undefined
    /// there.
    fn at_rest(&mut self, id: ExprId) -> Option<ExprId> {
        self.resting.of(&mut self.model.graph, id, 0).map(|series| series.closed)
    }

    /// Returns an expression at rest, which must be defined if a coordinate is to be ignored.
    fn defined_at_rest(&mut self, index: usize, id: ExprId) -> Result<ExprId, Refusal> {
        self.at_rest(id).ok_or_else(|| self.refusal(index, Obstacle::Undefined))
    }

    fn add_momentum(&mut self, index: usize) -> ExprId {
        let coordinate = &self.model.coordinates[self.cyclic[index].pinned.coordinate].name;
        let name = momentum_of(&Name::new(coordinate.clone(), self.cyclic[index].pinned.span)).text;
        let role = Role::Parameter((self.model.parameters.len() + index) as u32);
        let symbol = self.model.graph.symbol(&name, role);
        self.momenta.push(symbol);
        symbol
    }

    /// Finds the replacements of velocities and accelerations of ignored coordinates.
    fn reconstruct(&mut self) {
        let mut slopes = Rates::new(AccelerationTerms::Kept);
        for (cyclic, &rate) in self.cyclic.iter().zip(&self.rates) {
            self.replacements.insert(cyclic.velocity, rate);
            self.replacements.insert(cyclic.acceleration, slopes.of(&mut self.model.graph, rate));
        }
    }

    fn replaced(&mut self, id: ExprId) -> ExprId {
        substitute(&mut self.model.graph, id, &self.replacements)
    }

    /// Returns a value with rates replaced, and with ignored coordinates at zero if it does not
    /// depend on them.
    fn reconstructed(&mut self, value: ExprId) -> ExprId {
        let value = self.replaced(value);
        let is_alike = self.are_alike(&[value]);
        is_alike.then(|| self.at_rest(value)).flatten().unwrap_or(value)
    }

    fn model(mut self, lagrangian: ExprId) -> Model {
        let mut energies = match self.model.energies {
            Energies::Separate { kinetic, potential } => Energies::Routhian { kinetic, potential },
            other => other,
        };
        for part in energies.parts_mut() {
            *part = self.reconstructed(*part);
        }
        let dissipation = self.reconstructed(self.model.dissipation);
        let loads = self.loads();
        self.replace_outputs();
        let rates = self.known_rates();
        let labels = self.labels();
        self.add_parameters();
        self.move_coordinates();
        Model { energies, lagrangian, gibbs: None, dissipation, loads, rates, labels, ..self.model }
    }

    /// Returns the loads with rates replaced. If the effect of a statement does not depend on
    /// ignored coordinates, its loads do not contain them.
    fn loads(&mut self) -> Vec<Load> {
        let mut loads = self.model.loads.clone();
        let velocities = self.model.velocities();
        for statement in loads.chunk_by_mut(|a, b| a.name == b.name) {
            let mut effects = self.forces(statement, &velocities);
            let powers = statement.iter().map(|load| self.model.graph.multiply(load.force, load.velocity));
            let powers = powers.collect::<Vec<_>>();
            effects.push(self.model.graph.total(powers));
            let effects = substitute_all(&mut self.model.graph, &effects, &self.replacements);
            let is_alike = self.are_alike(&effects);
            for part in statement.iter_mut().flat_map(|load| [&mut load.velocity, &mut load.force]) {
                *part = self.replaced(*part);
                if is_alike {
                    *part = self.at_rest(*part).unwrap_or(*part);
                }
            }
        }
        loads
    }

    fn replace_outputs(&mut self) {
        let mut outputs = std::mem::take(&mut self.model.outputs);
        for part in outputs.iter_mut().flat_map(|output| &mut output.components) {
            *part = self.reconstructed(*part);
        }
        let mut scene = std::mem::take(&mut self.model.scene);
        for place in scene.places() {
            *place = self.replaced(*place);
        }
        (self.model.outputs, self.model.scene) = (outputs, scene);
    }

    /// Returns the names of expressions with rates replaced; symbols need no labels.
    fn labels(&mut self) -> Vec<(ExprId, String)> {
        let mut labels = self.model.labels.clone();
        labels.retain_mut(|(id, _)| {
            let old = std::mem::replace(id, substitute(&mut self.model.graph, *id, &self.replacements));
            let is_plain = matches!(self.model.graph.node(*id), Node::Symbol(_) | Node::Number(_));
            !is_plain || *id == old
        });
        labels
    }

    /// Returns the velocities that are rates in the Routhian.
    fn known_rates(&mut self) -> Vec<(ExprId, ExprId)> {
        let mut rates = Vec::new();
        for (velocity, position) in self.model.rates.clone() {
            let found = [velocity, position].map(|id| self.at_rest(id));
            if let [Some(velocity), Some(position)] = found {
                rates.push((velocity, position));
            }
        }
        rates
    }

    fn add_parameters(&mut self) {
        for (index, symbol) in self.momenta.clone().into_iter().enumerate() {
            let name = self.model.graph.symbol_of(symbol).map(|symbol| symbol.name.clone());
            let default = Some(self.momentum_at_start(index));
            let range = [None, None];
            self.model.parameters.push(Parameter { name: name.unwrap_or_default(), symbol, default, range });
        }
    }

    /// Returns the initial momentum of the default system; zero if it is unknown.
    fn momentum_at_start(&mut self, index: usize) -> ExprId {
        let zero = self.model.graph.number(0);
        let mut start = Expansion::default();
        start.hold(self.model.graph.symbol("t", Role::Time), zero);
        let state = [self.model.positions(), self.model.velocities()].concat();
        for (entry, value) in state.into_iter().zip(&self.model.start) {
            start.hold(entry, *value);
        }
        let lagrangian = self.frozen(self.model.lagrangian);
        let momentum = gradient(&mut self.model.graph, lagrangian, &[self.cyclic[index].velocity])[0];
        let graph = &mut self.model.graph;
        let defaults = self.model.parameters.iter().filter_map(|of| Some((of.symbol, of.default?)));
        let defaults = defaults.collect::<HashMap<_, _>>();
        let value = start.of(graph, momentum, 0).map(|series| substitute(graph, series.closed, &defaults));
        value.filter(|&value| graph.dependencies(value) == Dependencies::NONE).unwrap_or(zero)
    }

    /// Turns ignored coordinates into states, since their velocities are no longer part of the
    /// state.
    fn move_coordinates(&mut self) {
        for index in 0..self.model.coordinates.len() {
            let Coordinate { rate, is_state, .. } = self.model.coordinates[index];
            if is_state {
                self.model.coordinates[index].rate = self.replaced(rate);
            }
        }
        let gone = self.cyclic.iter().map(|cyclic| cyclic.speed).collect::<Vec<_>>();
        for (cyclic, &rate) in self.cyclic.iter().zip(&self.rates) {
            let coordinate: &mut Coordinate = &mut self.model.coordinates[cyclic.pinned.coordinate];
            (coordinate.rate, coordinate.is_state) = (rate, true);
        }
        let positions = self.model.coordinates.len();
        let mut index = 0..;
        self.model.speeds.retain(|_| index.next().is_some_and(|index| !gone.contains(&index)));
        let mut index = 0..;
        let stays = |index: usize| index.checked_sub(positions).is_none_or(|speed| !gone.contains(&speed));
        self.model.start.retain(|_| index.next().is_some_and(stays));
    }
}
