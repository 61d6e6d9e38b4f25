//! States with their derivatives in lanes: the variational equations of several motions at once.

use core::marker::PhantomData;

use super::stacked::{Stacked, variational_rates};
use super::system::Sensitive;
use super::variable::VariedPlace;
use crate::scalar::Number;
use crate::simulate::closed_loop::ClosedLoop;
use crate::system::{
    Equations, LanesSystem, LanesVisitor, OdeSystem, ParametricSystem, ScalarOf, SideBySide, StateVector,
};

/// Maximum number of entries of a state and its derivatives in lanes. A method keeps some 25 such
/// vectors of eight lanes on the stack, 150 kB in all, and many times as much unoptimised.
const MAX_ENTRIES: usize = 96;

/// Maximum number of derivatives of the right-hand side in lanes, which take 64 bytes each.
const MAX_SLOPES: usize = 512;

/// True if N entries of a state, R rows of derivatives and `numbers` parameters and inputs fit into
/// lanes.
pub(super) const fn fit<const N: usize, const R: usize>(numbers: usize) -> bool {
    N * R <= MAX_ENTRIES && N * (N + numbers) <= MAX_SLOPES
}

/// Marks an initial value, which has no column ∂f/∂p.
const INITIAL: usize = usize::MAX;

/// The equations E for numbers of the type S, and those of the derivatives of N entries.
#[derive(Clone, Copy, Debug)]
pub struct SensitiveEquations<S, E, const N: usize, const R: usize> {
    equations: E,
    /// Indices of the parameters and inputs among the variables, and their number.
    indices: ([usize; R], usize),
    /// The place of each variable in this list, or [`INITIAL`].
    columns: [usize; R],
    /// The scale of each variable.
    scales: [S; R],
}

impl<S, E, const N: usize, const R: usize> Equations<S> for SensitiveEquations<S, E, N, R>
where
    S: Number,
    E: Equations<S>,
{
    type State = Stacked<S, N, R>;
    type Series = ();

    #[inline(always)]
    fn rhs(&self, t: S, y: &Stacked<S, N, R>) -> Stacked<S, N, R> {
        let mut rates = y.zeros();
        let ([state, changes @ ..], (indices, count)) = (y.used(), self.indices) else {
            rates.as_mut().fill(S::NAN);
            return rates;
        };
        let (mut jacobian, mut by_numbers) = (E::State::ZERO_SQUARE, [E::State::ZERO; R]);
        let found = self.equations.differentiated(
            t,
            &E::State::of(state),
            &mut jacobian,
            &indices[..count],
            &mut by_numbers[..count],
        );
        rates.rows[0].copy_from_slice(found.as_ref());
        for (variable, changes) in changes.iter().enumerate() {
            let column = by_numbers.get(self.columns[variable]);
            let direct = column.map(|column| (self.scales[variable], column.as_ref()));
            variational_rates(jacobian.as_ref(), changes, direct, &mut rates.rows[1 + variable]);
        }
        rates
    }
}

impl<M, L, const N: usize, const R: usize> LanesSystem for Sensitive<M, L, N, R>
where
    M: ParametricSystem + OdeSystem<State = [ScalarOf<M>; N]>,
    L: ClosedLoop<M> + LanesSystem + OdeSystem<Scalar = ScalarOf<M>, State = [ScalarOf<M>; N]>,
{
    type Lanes<S: Number> = SensitiveEquations<S, L::Lanes<S>, N, R>;

    fn lanes<S: Number>(&self, splat: impl Fn(M::Scalar) -> S) -> Self::Lanes<S> {
        let (mut indices, mut columns, mut scales) = (([0; R], 0), [INITIAL; R], [S::ONE; R]);
        for (variable, varied) in self.variables.iter().enumerate() {
            scales[variable] = splat(varied.scale());
            if let VariedPlace::Number(index) = varied.place {
                columns[variable] = indices.1;
                indices.0[indices.1] = index;
                indices.1 += 1;
            }
        }
        SensitiveEquations { equations: self.closed.lanes(splat), indices, columns, scales }
    }

    fn set_lane<S: SideBySide<Element = M::Scalar>>(&self, lanes: &mut Self::Lanes<S>, lane: usize) {
        self.closed.set_lane(&mut lanes.equations, lane);
        for (scales, variable) in lanes.scales.iter_mut().zip(self.variables.iter()) {
            scales.set_lane(lane, variable.scale());
        }
    }
}

/// A visitor of a closed loop that brings the visitor V to the loop with derivatives, T. The latter
/// is refused if the equations in lanes have no derivatives.
pub(super) struct OfClosed<V, T> {
    visitor: V,
    visited: PhantomData<T>,
}

impl<V, T> OfClosed<V, T> {
    pub(super) fn new(visitor: V) -> Self {
        OfClosed { visitor, visited: PhantomData }
    }

    pub(super) fn into_visitor(self) -> V {
        self.visitor
    }
}

impl<M, L, V, const N: usize, const R: usize> LanesVisitor<L> for OfClosed<V, Sensitive<M, L, N, R>>
where
    M: ParametricSystem + OdeSystem<State = [ScalarOf<M>; N]>,
    L: ClosedLoop<M> + OdeSystem<Scalar = ScalarOf<M>, State = [ScalarOf<M>; N]>,
    V: LanesVisitor<Sensitive<M, L, N, R>>,
{
    type Output = Result<V::Output, V>;

    fn visit(self) -> Result<V::Output, V>
    where
        L: LanesSystem,
    {
        if <L::Lanes<M::Scalar> as Equations<M::Scalar>>::HAS_DERIVATIVES {
            Ok(self.visitor.visit())
        } else {
            Err(self.visitor)
        }
    }
}
