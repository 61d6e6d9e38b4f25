//! The regressor of the inverse dynamics: the coefficients of the parameters in which it is linear.
//!
//! The inverse dynamics is τ = Y π + τ₀. The first parameters π are those of the bodies. Each has
//! its mass m, first moments h = m c, and the tensor of inertia J about the body-fixed origin. Let
//! this origin accelerate by a, less free fall. In body-fixed axes the body needs the force f and,
//! about its origin, the moment n:
//!
//! > f = m a + α × h + ω × (ω × h),  n = J α + ω × J ω + h × a
//!
//! With the velocity u of the origin, columns are (∂u/∂v)ᵀ ∂f/∂π + (∂ω/∂v)ᵀ ∂n/∂π. Each body needs
//! six rows of a Jacobian for all of its columns.
//!
//! The others are declared parameters in which the rest of the inverse dynamics is linear. Examples
//! are stiffness, damping, and masses in user-defined energies. The rest is derived from the
//! Lagrangian without the bodies, so that no terms of the bodies have to cancel. If the product of
//! two parameters occurs, only one of them can be a column: one with inertia, otherwise the first.
//! In m g l sin φ together with ½ m l² φ̇² this is m, not g.
//!
//! Sources: Atkeson, An, Hollerbach, "Estimation of inertial parameters of manipulator loads and
//! links", Int. J. Robotics Research 5 (1986), eqs. 7 to 17; Khalil, Dombre, *Modeling,
//! Identification and Control of Robots*, §12.6.
//!
//! For example, let a rod along its body-fixed x axis turn in the plane by φ about its origin.
//! Under g its origin has a = g (sin φ, cos φ). The columns are g cos φ for h_x, −g sin φ for h_y
//! and φ̈ for J_zz; that of m is zero.

use super::gibbs_appell::remainder;
use super::inverse_dynamics::residual;
use super::least_constraint::{SplitLagrangian, Terms};
use crate::model::{InertialBody, Model};
use lagrange_algebra::calculus::{AccelerationTerms, gradient, jacobian};
use lagrange_algebra::simplify::vanishing;
use lagrange_expr::expr::{Dependencies, ExprId, Graph};

/// The columns of the regressor, with their parameters.
#[derive(Clone, Default, Debug)]
pub struct Regressor {
    /// The columns in order.
    pub columns: Vec<RegressorColumn>,
}

/// A column of the regressor.
#[derive(Clone, Debug)]
pub struct RegressorColumn {
    /// The name of the body, or of the declared parameter.
    pub owner: String,
    /// Parameter of a body, such as `mx`.
    pub part: Option<&'static str>,
    /// The parameter, a function of declared parameters.
    pub parameter: ExprId,
    /// The entries, in the order of the velocities.
    pub entries: Vec<ExprId>,
}

impl Regressor {
    /// Computes the regressor of all parameters in which the inverse dynamics of a model is linear.
    pub(super) fn new(model: &mut Model) -> Regressor {
        let mut columns = Vec::new();
        let velocities = model.velocities();
        for body in model.scene.inertial.clone() {
            columns.extend(columns_of_body(&mut model.graph, &body, &velocities));
        }
        for candidate in candidates(model) {
            if is_linear_beside(&mut model.graph, &columns, &candidate) {
                columns.push(candidate);
            }
        }
        Regressor { columns }
    }

    /// Returns Y in rows.
    pub(super) fn rows(&self, velocities: usize) -> Vec<ExprId> {
        (0..velocities).flat_map(|row| self.columns.iter().map(move |column| column.entries[row])).collect()
    }
}

/// Returns the nonzero columns of a body.
fn columns_of_body(graph: &mut Graph, body: &InertialBody, velocities: &[ExprId]) -> Vec<RegressorColumn> {
    let jacobian = body.twist.map(|component| gradient(graph, component, velocities));
    let wrenches = wrenches(graph, body);
    let named = InertialBody::PARAMETERS.iter().zip(body.parameters).zip(wrenches);
    let columns = named.map(|((&name, parameter), wrench)| {
        let entry = |row: usize| {
            let products = wrench.iter().zip(&jacobian);
            let products = products.map(|(&force, slopes)| graph.multiply(force, slopes[row]));
            let products = products.collect::<Vec<_>>();
            graph.total(products)
        };
        let entries = (0..velocities.len()).map(entry).collect();
        RegressorColumn { owner: body.body.text.clone(), part: Some(name), parameter, entries }
    });
    let columns = columns.collect::<Vec<_>>();
    columns.into_iter().filter(|column| !is_zero(graph, column)).collect()
}

fn is_zero(graph: &Graph, column: &RegressorColumn) -> bool {
    column.entries.iter().all(|&entry| graph.is_zero(entry))
}

/// Returns the force and moment of a unit of each parameter.
fn wrenches(graph: &mut Graph, body: &InertialBody) -> [[ExprId; 6]; 10] {
    let [ax, ay, az, alpha_x, alpha_y, alpha_z] = body.change;
    let [.., wx, wy, wz] = body.twist;
    let (a, alpha, w) = ([ax, ay, az], [alpha_x, alpha_y, alpha_z], [wx, wy, wz]);
    let zero = graph.number(0);
    let of_mass = [ax, ay, az, zero, zero, zero];
    let of_moments = [0, 1, 2].map(|axis| {
        let e = unit(graph, axis);
        let [turned, carried] = [cross(graph, alpha, e), cross(graph, w, e)];
        let inwards = cross(graph, w, carried);
        let ([fx, fy, fz], [nx, ny, nz]) = (sum(graph, turned, inwards), cross(graph, e, a));
        [fx, fy, fz, nx, ny, nz]
    });
    let of_tensor = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].map(|(row, column)| {
        let [of_alpha, of_w] = [alpha, w].map(|vector| {
            let mut product = [zero; 3];
            (product[row], product[column]) = (vector[column], vector[row]);
            product
        });
        let turning = cross(graph, w, of_w);
        let [nx, ny, nz] = sum(graph, of_alpha, turning);
        [zero, zero, zero, nx, ny, nz]
    });
    let [x, y, z] = of_moments;
    let [xx, yy, zz, xy, xz, yz] = of_tensor;
    [of_mass, x, y, z, xx, yy, zz, xy, xz, yz]
}

fn unit(graph: &mut Graph, axis: usize) -> [ExprId; 3] {
    [0, 1, 2].map(|other| graph.number(i64::from(other == axis)))
}

fn sum(graph: &mut Graph, a: [ExprId; 3], b: [ExprId; 3]) -> [ExprId; 3] {
    [0, 1, 2].map(|axis| graph.total(vec![a[axis], b[axis]]))
}

fn cross(graph: &mut Graph, a: [ExprId; 3], b: [ExprId; 3]) -> [ExprId; 3] {
    [0, 1, 2].map(|axis| {
        let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
        let (forward, backward) = (graph.multiply(a[next], b[last]), graph.multiply(a[last], b[next]));
        graph.subtract(forward, backward)
    })
}

/// Returns the columns of declared parameters that occur in the inverse dynamics without the
/// bodies. Parameters with inertia come first.
fn candidates(model: &mut Model) -> Vec<RegressorColumn> {
    let rest = rest(model);
    let graph = &mut model.graph;
    let mut candidates = Vec::new();
    for parameter in &model.parameters {
        let entries = jacobian(graph, &rest, &[parameter.symbol]).concat();
        let (owner, parameter) = (parameter.name.clone(), parameter.symbol);
        let column = RegressorColumn { owner, part: None, parameter, entries };
        let vanishes = vanishing(graph, &column.entries);
        if !vanishes.into_iter().all(|vanishes| vanishes) {
            candidates.push(column);
        }
    }
    let has_inertia = |column: &RegressorColumn| {
        column.entries.iter().any(|&entry| graph.dependencies(entry).intersects(Dependencies::ACCELERATION))
    };
    candidates.sort_by_key(|column| !has_inertia(column));
    candidates
}

/// Returns the inverse dynamics without the bodies.
fn rest(model: &mut Model) -> Vec<ExprId> {
    let bodies = model.scene.inertial.iter().map(|body| body.lagrangian).collect::<Vec<_>>();
    let (lagrangian, gibbs) = (model.lagrangian, model.gibbs.take());
    let bodies = model.graph.total(bodies);
    model.lagrangian = remainder(&mut model.graph, lagrangian, bodies);
    let split = SplitLagrangian::new(model);
    let rest = residual(model, &split, AccelerationTerms::Kept, Terms::All);
    (model.lagrangian, model.gibbs) = (lagrangian, gibbs);
    rest
}

/// True if a column does not depend on the parameter of any column, and the other columns do not
/// depend on its parameter.
fn is_linear_beside(graph: &mut Graph, columns: &[RegressorColumn], candidate: &RegressorColumn) -> bool {
    let others = columns.iter().flat_map(|column| &column.entries).copied().collect::<Vec<_>>();
    let mut slopes = jacobian(graph, &others, &[candidate.parameter]).concat();
    let declared = columns.iter().map(|column| column.parameter).chain([candidate.parameter]);
    let declared = declared.filter(|&parameter| graph.symbol_of(parameter).is_some()).collect::<Vec<_>>();
    slopes.extend(jacobian(graph, &candidate.entries, &declared).concat());
    slopes.retain(|&slope| !graph.is_zero(slope));
    vanishing(graph, &slopes).into_iter().all(|vanishes| vanishes)
}
