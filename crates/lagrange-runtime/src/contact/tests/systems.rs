//! The systems of the tests.

/// Implements the traits of a mechanical system with reactions from its constant or hand-written
/// [`Terms`](crate::contact::Terms).
macro_rules! contact_system {
    ($name:ident, $n:literal coordinates $coordinates:tt, $k:literal reactions $reactions:tt) => {
        impl crate::system::OdeSystem for $name {
            type Scalar = f64;
            type State = [f64; 2 * $n];

            fn rhs(&self, t: f64, y: &[f64; 2 * $n]) -> [f64; 2 * $n] {
                let (q, v) = crate::system::split::<Self>(y);
                let a = crate::system::MechanicalSystem::acceleration(self, t, &q, &v);
                crate::system::join::<Self>(&v, &a)
            }

            const IS_CONSTRAINED: bool = true;

            fn correct(
                &self,
                t: f64,
                y: &mut [f64; 2 * $n],
            ) -> Result<(), crate::integrate::StepFailure<f64>> {
                crate::contact::correct::<_, $n, $k>(self, t, y)
            }

            const EVENTS: &'static [crate::event::DeclaredEvent] = {
                let names: [&'static str; $k] = $reactions;
                let mut events = [crate::event::DeclaredEvent::switch(""); $k];
                let mut k = 0;
                while k < $k {
                    events[k] = crate::event::DeclaredEvent::switch(names[k]);
                    k += 1;
                }
                &{ events }
            };

            fn event_values(&self, t: f64, y: &[f64; 2 * $n], values: &mut [f64]) {
                crate::contact::event_values::<_, $n, $k>(self, t, y, values);
            }

            fn react(
                &self,
                event: usize,
                t: f64,
                elapsed: f64,
                y: &[f64; 2 * $n],
            ) -> crate::system::Reacted<Self> {
                crate::contact::react::<_, $n, $k>(self, event, t, elapsed, y)
            }

            fn begin(
                &self,
                t: f64,
                y: &[f64; 2 * $n],
            ) -> Result<Option<Self>, crate::integrate::StepFailure<f64>> {
                crate::contact::begin::<_, $n, $k>(self, t, y)
            }
        }

        impl crate::system::MechanicalSystem for $name {
            type Coordinates = [f64; $n];
            type Velocities = [f64; $n];
            type Columns<C> = crate::system::Unnamed<C>;
            const COORDINATES: &'static [&'static str] = &$coordinates;

            fn position_rates(&self, _t: f64, _q: &[f64; $n], v: &[f64; $n]) -> [f64; $n] {
                *v
            }

            fn acceleration(&self, t: f64, q: &[f64; $n], v: &[f64; $n]) -> [f64; $n] {
                let terms = crate::contact::ContactSystem::<$n, $k>::terms(self, t, q, v);
                terms.acceleration(&crate::contact::reactions(&terms, &self.modes))
            }
        }

        impl crate::contact::ContactSystem<$n, $k> for $name {
            type Terms = super::systems::TestTerms<$n, $k>;

            const REACTIONS: [&'static str; $k] = $reactions;

            fn modes(&self) -> [crate::contact::Mode; $k] {
                self.modes
            }

            fn in_modes(&self, modes: [crate::contact::Mode; $k]) -> Self {
                $name { modes, ..*self }
            }

            fn terms(&self, t: f64, q: &[f64; $n], v: &[f64; $n]) -> Self::Terms {
                self.written(t, q, v)
            }

            fn event_of(&self, k: usize) -> Option<usize> {
                Some(k)
            }
        }
    };
}

use crate::contact::{Contact, Friction, LimitSlope, Mode, Terms};

pub(super) const OPEN: Mode = Mode::Contact(Contact::Open);
pub(super) const CLOSED: Mode = Mode::Contact(Contact::Closed);
pub(super) const FREE: Mode = Mode::Friction(Friction::Slips);
pub(super) const FORWARDS: Mode = Mode::Friction(Friction::SlipsForwards);
pub(super) const BACKWARDS: Mode = Mode::Friction(Friction::SlipsBackwards);
pub(super) const STICKS: Mode = Mode::Friction(Friction::Sticks);

/// Terms in which each limit may depend on one reaction.
pub(super) type TestTerms<const N: usize, const K: usize> = Terms<f64, N, K, [LimitSlope<f64>; K]>;

/// Returns terms that are all zero.
pub(super) fn nothing<const N: usize, const K: usize>() -> TestTerms<N, K> {
    Terms {
        free: [0.0; N],
        responses: [[0.0; N]; K],
        rows: [[0.0; N]; K],
        gaps: [0.0; K],
        rates: [0.0; K],
        drifts: [0.0; K],
        restitutions: [0.0; K],
        kinetic: [0.0; K],
        fixed: [0.0; K],
        slopes: core::array::from_fn(|limited| slope(limited, 0, [0.0; 2])),
    }
}

/// Returns the slopes of a kinetic and a static limit.
pub(super) fn slope(limited: usize, reaction: usize, [kinetic, fixed]: [f64; 2]) -> LimitSlope<f64> {
    LimitSlope { limited, reaction, kinetic, fixed }
}

/// A ball of mass m above a floor of height h(t) = rise·t² / 2: m ÿ = −m g + lift(t) + N.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ball {
    pub(super) m: f64,
    pub(super) g: f64,
    pub(super) e: f64,
    /// Growth of the upward force per unit of time.
    pub(super) lift: f64,
    pub(super) rise: f64,
    pub(super) modes: [Mode; 1],
}

impl Ball {
    pub(super) const fn new(e: f64) -> Self {
        Ball { m: 2.0, g: 9.81, e, lift: 0.0, rise: 0.0, modes: [OPEN] }
    }

    fn written(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> TestTerms<1, 1> {
        Terms {
            free: [-self.g + self.lift * t / self.m],
            responses: [[1.0 / self.m]],
            rows: [[1.0]],
            gaps: [q[0] - 0.5 * self.rise * t * t],
            rates: [v[0] - self.rise * t],
            drifts: [-self.rise],
            restitutions: [self.e],
            ..nothing()
        }
    }
}

contact_system!(Ball, 1 coordinates ["y"], 1 reactions ["floor"]);

/// A block on a belt with the speed `belt`, pulled by a spring and a force `drive`·t, with Coulomb
/// friction between constant limits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Block {
    pub(super) m: f64,
    pub(super) stiffness: f64,
    pub(super) drive: f64,
    pub(super) belt: f64,
    /// An additional constant force.
    pub(super) weight: f64,
    pub(super) kinetic: f64,
    pub(super) fixed: f64,
    pub(super) modes: [Mode; 1],
}

impl Block {
    fn written(&self, t: f64, q: &[f64; 1], v: &[f64; 1]) -> TestTerms<1, 1> {
        Terms {
            free: [(self.drive * t + self.weight - self.stiffness * q[0]) / self.m],
            responses: [[1.0 / self.m]],
            rows: [[1.0]],
            rates: [v[0] - self.belt],
            kinetic: [self.kinetic],
            fixed: [self.fixed],
            ..nothing()
        }
    }
}

contact_system!(Block, 1 coordinates ["x"], 1 reactions ["brake"]);

/// A block thrown onto a floor with Coulomb friction: a contact, and friction with the limit μ N.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slider {
    pub(super) m: f64,
    pub(super) g: f64,
    pub(super) e: f64,
    pub(super) kinetic: f64,
    pub(super) fixed: f64,
    /// Growth of the forces along the floor and upwards per unit of time.
    pub(super) pull: f64,
    pub(super) lift: f64,
    pub(super) modes: [Mode; 2],
}

impl Slider {
    fn written(&self, t: f64, q: &[f64; 2], v: &[f64; 2]) -> TestTerms<2, 2> {
        let w = 1.0 / self.m;
        Terms {
            free: [self.pull * t * w, self.lift * t * w - self.g],
            responses: [[0.0, w], [w, 0.0]],
            rows: [[0.0, 1.0], [1.0, 0.0]],
            gaps: [q[1], 0.0],
            rates: [v[1], v[0]],
            restitutions: [self.e, 0.0],
            slopes: [slope(0, 0, [0.0; 2]), slope(1, 0, [self.kinetic, self.fixed])],
            ..nothing()
        }
    }
}

contact_system!(Slider, 2 coordinates ["x", "y"], 2 reactions ["floor", "rubbing"]);

/// Three balls of radius zero on a line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cradle {
    pub(super) masses: [f64; 3],
    pub(super) e: f64,
    pub(super) modes: [Mode; 2],
}

impl Cradle {
    fn written(&self, _t: f64, q: &[f64; 3], v: &[f64; 3]) -> TestTerms<3, 2> {
        let w = self.masses.map(|m| 1.0 / m);
        Terms {
            responses: [[-w[0], w[1], 0.0], [0.0, -w[1], w[2]]],
            rows: [[-1.0, 1.0, 0.0], [0.0, -1.0, 1.0]],
            gaps: [q[1] - q[0], q[2] - q[1]],
            rates: [v[1] - v[0], v[2] - v[1]],
            restitutions: [self.e; 2],
            ..nothing()
        }
    }
}

contact_system!(Cradle, 3 coordinates ["a", "b", "c"], 2 reactions ["left", "right"]);

/// A slender rod that falls broadside onto two supports: the height of its centre and its angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rod {
    pub(super) m: f64,
    pub(super) length: f64,
    pub(super) g: f64,
    pub(super) e: f64,
    /// Positions of possible supports, from −1 at its left end to 1 at its right end, and their
    /// heights.
    pub(super) places: [f64; 2],
    pub(super) supports: [f64; 2],
    pub(super) modes: [Mode; 2],
}

impl Rod {
    /// Returns a rod of 3 kg and 2 m above a floor.
    pub(super) const fn new(g: f64, e: f64) -> Self {
        Rod { m: 3.0, length: 2.0, g, e, places: [-1.0, 1.0], supports: [0.0; 2], modes: [OPEN; 2] }
    }

    fn written(&self, _t: f64, q: &[f64; 2], v: &[f64; 2]) -> TestTerms<2, 2> {
        let arms = self.places.map(|place| 0.5 * self.length * place);
        let inertia = self.m * self.length * self.length / 12.0;
        let (sin, cos) = q[1].sin_cos();
        let rows = arms.map(|arm| [1.0, arm * cos]);
        Terms {
            free: [-self.g, 0.0],
            responses: rows.map(|[y, angle]| [y / self.m, angle / inertia]),
            rows,
            gaps: core::array::from_fn(|k| q[0] + arms[k] * sin - self.supports[k]),
            rates: rows.map(|[y, angle]| y * v[0] + angle * v[1]),
            drifts: arms.map(|arm| -arm * sin * v[1] * v[1]),
            restitutions: [self.e; 2],
            ..nothing()
        }
    }
}

contact_system!(Rod, 2 coordinates ["y", "angle"], 2 reactions ["left", "right"]);

/// A block pressed into a corner by two forces, between three walls, two of them identical.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) m: f64,
    pub(super) force: [f64; 2],
    pub(super) modes: [Mode; 3],
}

impl Corner {
    fn written(&self, _t: f64, q: &[f64; 2], v: &[f64; 2]) -> TestTerms<2, 3> {
        let rows = [[1.0, 0.0], [0.0, 1.0], [0.0, 1.0]];
        Terms {
            free: self.force.map(|f| f / self.m),
            responses: rows.map(|row| row.map(|d| d / self.m)),
            rows,
            gaps: [q[0], q[1], q[1]],
            rates: [v[0], v[1], v[1]],
            ..nothing()
        }
    }
}

contact_system!(Corner, 2 coordinates ["x", "y"], 3 reactions ["wall", "floor", "carpet"]);

/// A slender rod whose left end touches a rough floor: position and height of its centre, and its
/// angle. Its reactions are the contact of the end and the friction there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stick {
    pub(super) m: f64,
    pub(super) length: f64,
    pub(super) g: f64,
    pub(super) e: f64,
    pub(super) mu: f64,
    pub(super) modes: [Mode; 2],
}

impl Stick {
    fn written(&self, _t: f64, q: &[f64; 3], v: &[f64; 3]) -> TestTerms<3, 2> {
        let half = 0.5 * self.length;
        let inertia = self.m * self.length * self.length / 12.0;
        let (sin, cos) = q[2].sin_cos();
        let rows = [[0.0, 1.0, -half * cos], [1.0, 0.0, half * sin]];
        Terms {
            free: [0.0, -self.g, 0.0],
            responses: rows.map(|[x, y, angle]| [x / self.m, y / self.m, angle / inertia]),
            rows,
            gaps: [q[1] - half * sin, 0.0],
            rates: rows.map(|[x, y, angle]| x * v[0] + y * v[1] + angle * v[2]),
            drifts: [half * sin * v[2] * v[2], half * cos * v[2] * v[2]],
            restitutions: [self.e, 0.0],
            slopes: [slope(0, 0, [0.0; 2]), slope(1, 0, [self.mu; 2])],
            ..nothing()
        }
    }

    pub(super) fn kinetic_energy(&self, v: [f64; 3]) -> f64 {
        let inertia = self.m * self.length * self.length / 12.0;
        0.5 * (self.m * (v[0] * v[0] + v[1] * v[1]) + inertia * v[2] * v[2])
    }
}

contact_system!(Stick, 3 coordinates ["x", "y", "angle"], 2 reactions ["floor", "rubbing"]);
