"""Equations of motion from energies: derived, printed, simulated.

>>> import lagrange
>>> pendulum = lagrange.System('''
...     param m: kg = 1, l: m = 1, g: m/s^2 = 9.81;
...     coord theta: rad = 0.5;
...     kinetic = 1/2 * m * (l * dot(theta))^2;
...     potential = -m * g * l * cos(theta);
... ''')
>>> motion = pendulum.simulate(until=10, every=0.1)
>>> motion["theta"].shape
(101,)

Values are in coherent units, as `System.units` lists them. Arrays of states are positions, then
velocities, in the order of `System.state_names`.
"""

from collections.abc import Callable, Sequence
from os import PathLike

import numpy
from numpy.typing import NDArray

Array = NDArray[numpy.float64]
State = Array | Sequence[float]

class DeclarationError(ValueError):
    """Mistakes in a declaration. The text lists all of them; the place is that of the first."""

    line: int | None
    column: int | None
    help: str | None

class EquilibriumError(RuntimeError):
    """A search that found no equilibrium, with the state at which it stopped."""

    state: Array

class FitError(RuntimeError):
    """A fit without a result. `fit` has the best values, if motions were compared with the data."""

    fit: Fit

class SimulationError(RuntimeError):
    """A motion that failed, with what it reached."""

    trajectory: Trajectory

class System:
    """A declared system with values for its parameters."""

    def __init__(self, text: str, *, compile: bool = True) -> None:
        """Derives the equations of a declaration. Raises `DeclarationError` for mistakes, and
        `ValueError` for what only compiled Rust can run, as contacts. Each function is compiled to
        machine code when it is first used, or interpreted with `compile=False`; results are the same."""
    @staticmethod
    def read(path: str | PathLike[str], *, compile: bool = True) -> System:
        """Reads a declaration from a file, beside which its tables are."""
    @property
    def is_compiled(self) -> bool:
        """True if functions are compiled to machine code."""
    @property
    def parameters(self) -> dict[str, float]:
        """Values of parameters, then of inputs; NaN for those without one."""
    def with_parameters(self, **values: float) -> System:
        """Returns the system with other parameters, or inputs of constant value."""
    @property
    def inputs(self) -> list[str]:
        """Names of the inputs, in the order of declaration."""
    @property
    def state_names(self) -> list[str]:
        """Names of the entries of a state: positions, then velocities."""
    @property
    def units(self) -> dict[str, str]:
        """Units by name; those of arrays for all of their elements."""
    def start(self, **values: float) -> Array:
        """Returns the declared state at the start, with other values for some of its entries."""
    def rhs(self, t: float, y: State) -> Array:
        """Computes the rates of a state, as `scipy.integrate.solve_ivp` takes them."""
    def accelerations(self, t: float, y: State) -> Array:
        """Computes the accelerations, one for each velocity."""
    def mass_matrix(self, t: float, y: State) -> Array:
        """Computes the mass matrix, of shape (velocities, velocities)."""
    def energy(self, t: float, y: State) -> float:
        """Computes the energy, in J if units are declared."""
    def product(self, name: str, t: float, y: State, a: State | None = None) -> Array:
        """Computes a product of `emit { … }` at a state, such as `coriolis_matrix` or
        `inverse_mass_matrix`. Those of the accelerations `a` are `inverse_dynamics`,
        `inverse_dynamics_jacobian` and `regressor`. It is derived the first time."""
    def jacobian(self, t: float, y: State) -> Array:
        """Computes the derivatives of `rhs` by the state, of shape (entries, entries), as the `jac`
        of `scipy.integrate.solve_ivp`. They are exact, and derived the first time."""
    def parameter_jacobian(self, t: float, y: State) -> Array:
        """Computes the derivatives of `rhs` by the parameters, of shape (entries, parameters), with
        columns in the order of declaration. Their units are those of the rates over those of the
        parameters. They are exact, and derived the first time."""
    def input_jacobian(self, t: float, y: State) -> Array:
        """Computes the derivatives of `rhs` by the inputs, of shape (entries, inputs), with columns
        in the order of `inputs`. Their units are those of the rates over those of the inputs."""
    def outputs(self, t: float, y: State) -> dict[str, float]:
        """Computes the declared outputs, by column."""
    def simulate(
        self,
        start: State | dict[str, float] | None = None,
        *,
        until: float,
        every: float | None = None,
        begin: float = 0.0,
        method: str | None = None,
        tolerance: float | None = None,
        step: float | None = None,
        seed: int | None = None,
        inputs: Callable[[float, Array], float | Sequence[float]]
        | tuple[Array | Sequence[float], Array | Sequence[float] | Sequence[Sequence[float]]]
        | None = None,
        energy: bool = False,
    ) -> Trajectory:
        """Computes the motion from a state: an array, values of some entries beside the declared
        ones, or as it is declared.

        Samples are kept `every` so many seconds, or after every step. Methods are `verner`, `taylor`
        and `radau` with a `tolerance`, 1e-9 by default, and `rk4` and `gauss` with a `step`. `taylor`
        is for small errors; its series are derived the first time, and take constant inputs. `stepped`,
        with a `step`, is for many contacts and for those of faces and edges. Systems with noise have
        `maruyama` and `stochastic` with a `step`, whose `seed`, 0 by default, chooses the noise.

        `inputs` is a function that returns the inputs at a time and a state; what it raises is raised
        here. Or it is a pair of times and values, an array of one input or with a column for each.
        These are linear between the times and constant before and after them; a time that occurs
        twice is a jump. Without a function, other threads of Python run meanwhile. Raises
        `SimulationError` where the motion fails. Ctrl-C ends the run; the `KeyboardInterrupt` has the
        `trajectory` so far.
        """
    def film(self, motion: Trajectory, *, energy: bool = True, forces: bool = False, height: int = 640) -> Film:
        """Returns the film of a motion, with the parameters of this system. Each sample is a picture,
        so `every` should be about 0.04 s. A column of the energy is plotted unless `energy` is false.
        With `forces`, forces and moments are drawn, for the constant inputs of this system. `height` is
        that of the frame in a notebook, in pixels. Raises `ValueError` for systems without bodies and
        for motions of other systems."""
    def ensemble(
        self,
        starts: Array | Sequence[State] | dict[str, float | Array | Sequence[float]] | None = None,
        *,
        until: float,
        parameters: dict[str, float | Array | Sequence[float]] | None = None,
        begin: float = 0.0,
        method: str | None = None,
        tolerance: float | None = None,
        step: float | None = None,
        seed: int | None = None,
        threads: int | None = None,
    ) -> Ensemble:
        """Computes many motions over threads, and keeps their ends.

        Starts are an array of shape (runs, entries), or numbers and arrays by entry beside the
        declared start. Parameters and inputs are numbers, or arrays with a number for each run.
        Methods are those of `simulate`, and each end has the bits of that of a single run, on any
        number of threads. With noise, each run has its own. Other threads of Python run meanwhile. A run
        that fails is in `failures`, and does not end the others. Ctrl-C ends the computation.

        >>> ends = pendulum.ensemble({"theta": [0.1, 0.2, 0.3]}, until=10, parameters={"l": 2.0})
        >>> ends.y.shape
        (3, 2)
        """
    def fit(
        self,
        data: dict[str, Array | Sequence[float | None]] | str | PathLike[str] | object,
        *,
        vary: Sequence[str] | dict[str, tuple[float | None, float | None] | None],
        start: State | dict[str, float] | None = None,
        noise: dict[str, float] | None = None,
        begin: float | None = None,
        tolerance: float = 1e-9,
        starts: int = 1,
        max_iterations: int = 200,
    ) -> Fit:
        """Fits parameters, inputs of constant value and entries of the start to measured columns, by
        nonlinear least squares along motions.

        Data are times `t`, and columns of the state or of outputs, in which `None` is a missing
        value: a dictionary, a data frame, or the path of a CSV file, whose names may end in units,
        as `x in m`. What varies starts at its present value, and stays between its bounds. `noise` has
        standard deviations by column; several columns need it. Motions start at the first time, or
        at `begin`. Of several `starts` the best end is taken. Other threads run meanwhile.
        Ctrl-C ends the search; the `KeyboardInterrupt` has the best `fit` so far.

        Raises `ValueError` for data and settings that make no sense. Raises `FitError` if no motion
        reaches the end of the data, the search does not end, or data do not tell all variables.

        >>> fit = pendulum.fit({"t": t, "theta": theta}, vary={"l": (0.1, 10)})
        >>> fit.values["l"], fit.standard_errors["l"]
        """
    def equilibrium(
        self,
        near: State | dict[str, float] | None = None,
        *,
        hold: Sequence[str] = (),
        trim: Sequence[str] = (),
        time: float = 0.0,
    ) -> Equilibrium:
        """Searches for an equilibrium near a state, or for a steady motion with its velocities.

        Coordinates and states of `hold` keep their values, and inputs of `trim` are unknowns, too.
        Constraints hold. Raises `EquilibriumError` where Newton's method stops.
        """
    def linearise(self, state: State | dict[str, float] | None = None, *, time: float = 0.0) -> LinearModel:
        """Linearises the equations of motion and the outputs at a state, by exact derivatives.

        Raises `ValueError` where they have a corner, or the state violates constraints, and
        `DeclarationError` for declarations with clocks or discrete states.
        """
    def equations(self) -> str:
        """Returns the equations as text."""
    def latex(self) -> str:
        """Returns the equations of motion as LaTeX, which Jupyter shows for the system."""
    def rust(self) -> str:
        """Returns the code that the macro of Rust emits for the declaration."""
    def c(self) -> tuple[str, str]:
        """Returns a module of C: header and source."""

class Columns:
    """Columns by name: times, entries of states, and others. Arrays of columns are shared, not copied,
    and cannot be written to: `motion["x"].copy()` can."""

    @property
    def t(self) -> Array:
        """Times in s."""
    @property
    def y(self) -> Array:
        """States, of shape (times, entries of a state)."""
    @property
    def names(self) -> list[str]:
        """Names of the columns, `t` first."""
    def columns(self) -> dict[str, Array]:
        """All columns by name."""
    def to_pandas(self) -> object:
        """Returns a `pandas.DataFrame`."""
    def to_polars(self) -> object:
        """Returns a `polars.DataFrame`."""
    def __len__(self) -> int: ...
    def __getitem__(self, name: str) -> Array: ...

class Ensemble(Columns):
    """The ends of many motions: columns by name, a row for each run."""

    @property
    def t(self) -> Array:
        """Times of the ends: `until`, or earlier where an event stopped a motion."""
    @property
    def y(self) -> Array:
        """Final states, of shape (runs, entries of a state); NaN for runs that failed."""
    @property
    def names(self) -> list[str]:
        """Names of the columns: `t`, the state, outputs, and all parameters if some were given."""
    @property
    def failures(self) -> list[tuple[int, float, Array, str]]:
        """Runs that failed: index, time and last good state, and why."""

class Fit:
    """Fitted values with what data tell of them; as text, a report."""

    @property
    def values(self) -> dict[str, float]:
        """Values by name."""
    @property
    def standard_errors(self) -> dict[str, float | None]:
        """Standard errors by name; `None` at a bound, or where data do not tell the value."""
    @property
    def covariance(self) -> Array | None:
        """Covariance matrix in the order of `values`, with zeros for values at a bound. `None` if
        data do not tell all of them, or there is neither noise nor a value to spare."""
    @property
    def correlations(self) -> Array | None:
        """Covariances over both standard errors; NaN for values at a bound."""
    @property
    def weakest(self) -> dict[str, float]:
        """The combination that data tell least: relative changes by name, of length one."""
    @property
    def weakest_error(self) -> float:
        """Standard error of that combination."""
    @property
    def chi_square(self) -> float:
        """Sum of squares of residuals, each over its noise level."""
    @property
    def degrees_of_freedom(self) -> int:
        """Number of measured values minus that of the variables that no bound holds."""
    @property
    def iterations(self) -> int:
        """Number of iterations of the best search."""
    @property
    def system(self) -> System:
        """The system with the fitted parameters."""
    @property
    def start(self) -> Array:
        """The start with its fitted entries."""

class Equilibrium:
    """An equilibrium or a steady motion."""

    @property
    def state(self) -> Array:
        """The state, with the velocities that were given."""
    @property
    def inputs(self) -> dict[str, float]:
        """All inputs by name, for `System.with_parameters`; empty if none were trimmed."""
    @property
    def iterations(self) -> int:
        """Number of steps."""
    @property
    def freedom(self) -> int:
        """Number of directions in which other equilibria adjoin this one: 0 if it is isolated."""

class LinearModel:
    """A linear model x' = A x + B u, y = C x + D u, as `scipy.signal.StateSpace` takes it.

    States are deviations of positions, first-order states and velocities, without those that
    follow from constraints.
    """

    @property
    def a(self) -> Array:
        """A, of shape (states, states)."""
    @property
    def b(self) -> Array:
        """B, of shape (states, inputs)."""
    @property
    def c(self) -> Array:
        """C, of shape (outputs, states)."""
    @property
    def d(self) -> Array:
        """D, of shape (outputs, inputs)."""
    @property
    def states(self) -> list[str]:
        """Names of the states."""
    @property
    def inputs(self) -> list[str]:
        """Names of the inputs."""
    @property
    def outputs(self) -> list[str]:
        """Names of the outputs' columns."""
    def modes(self) -> list[Mode]:
        """Computes the modes, one for each pair of conjugate eigenvalues."""
    @property
    def is_stable(self) -> bool | None:
        """True if deviations decay, false if some grow, `None` where nonlinear terms decide."""
    def lqr(self, q: Array | Sequence[Sequence[float]], r: Array | Sequence[Sequence[float]]) -> Array:
        """Computes the gain K of the feedback u = -K x that minimises the integral of
        x'Qx + u'Ru. Raises `ValueError` if no feedback stabilises the system."""

class Mode:
    """A mode of a linear model."""

    @property
    def eigenvalue(self) -> complex:
        """The eigenvalue in 1/s, with an imaginary part that is not negative."""
    @property
    def natural_frequency(self) -> float:
        """Magnitude of the eigenvalue, in rad/s."""
    @property
    def frequency(self) -> float:
        """Oscillations in a unit of time, in Hz."""
    @property
    def damping_ratio(self) -> float:
        """Damping ratio: 1 and more if it does not oscillate, negative if it grows."""
    @property
    def shape(self) -> dict[str, complex]:
        """Complex amplitudes of displacements, states and velocities."""

class Trajectory(Columns):
    """A motion: columns by name, and events."""

    @property
    def units(self) -> dict[str, str | None]:
        """Units of the columns; `None` for unknown ones."""
    @property
    def events(self) -> list[tuple[str, float, Array]]:
        """Events: name, time, and state before any reaction."""
    @property
    def ending(self) -> str:
        """`reached` if the motion came to its end time, `stopped` by an event, or `failed`."""
    @property
    def steps(self) -> int:
        """Number of steps of the integration."""
    def plot(self, *names: str, x: str = "t") -> Plot:
        """Plots columns over another one, each in a panel, with units at the axes. Without names, it
        plots the state. Raises `KeyError` for columns that are not there."""

class Plot:
    """A plot, which Jupyter shows."""

    @property
    def svg(self) -> str:
        """The picture as a document of SVG."""
    def save(self, path: str | PathLike[str]) -> None:
        """Saves the picture as `svg` or `png`, by the extension."""

class Film:
    """A film of bodies, which Jupyter shows in a frame."""

    @property
    def html(self) -> str:
        """The page of HTML that plays it, with nothing from elsewhere."""
    def save(self, path: str | PathLike[str]) -> None:
        """Saves the film as `html` or `gif`, in the plane as `svg`, in space as `glb`."""
