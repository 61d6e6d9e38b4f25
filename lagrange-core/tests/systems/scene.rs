//! Rigid bodies and joints along a motion: rotation matrices as jets, and energies from their
//! rates.
//!
//! The kinetic energy is `T = ½ m ċ·ċ + ½ ω·J ω` with ω of `Rᵀ Ṙ` in the axes of the body
//! (Goldstein, Poole and Safko, *Classical Mechanics*, 3rd ed., §5.3).

use lagrange_core::expr::Function;

use crate::jet::Jet;
use crate::tree::{Body, Expr, Joint, Pose, Statement};
use crate::world::{Placed, World};

/// Rows of jets.
pub(crate) type Matrix = Vec<Vec<Jet>>;

const AXES: &str = "xyz";

impl World<'_> {
    /// Reads a statement about bodies.
    pub(crate) fn read_scene(&mut self, statement: &Statement) -> Option<()> {
        match statement {
            Statement::Gravity(vector) => self.gravity = self.scalars(vector)?,
            Statement::Body(body) => self.read_body(body)?,
            Statement::Joint(joint) => self.read_joint(joint)?,
            Statement::Free(name) => {
                let place = ["x", "y", "z"].map(|axis| Expr::Name(format!("{name}_{axis}")));
                let origin = self.scalars(&place)?;
                let rotation = self.oriented(name)?;
                let placed = self.placed.get_mut(name)?;
                (placed.rotation, placed.origin) = (rotation, origin);
            }
            Statement::Spring { from, to, stiffness, rest } => {
                let (span, stiffness) = (self.span(from, to)?, self.scalar(stiffness)?);
                let square = match rest {
                    None => self.field.dot(&span, &span),
                    Some(rest) => {
                        let (length, rest) = (self.field.norm(&span), self.scalar(rest)?);
                        let stretch = self.field.subtract(&length, &rest);
                        self.field.multiply(&stretch, &stretch)
                    }
                };
                let energy = self.half_product(&stiffness, &square);
                self.sums.potential = self.field.add(&self.sums.potential, &energy);
            }
            Statement::Damper { from, to, damping } => {
                let (span, damping) = (self.span(from, to)?, self.scalar(damping)?);
                let length = self.field.norm(&span);
                let rate = self.field.rate(&length);
                self.add_loss(&damping, &[rate]);
            }
            Statement::Pin { from, to, .. } => {
                let span = self.span(to, from)?;
                self.sums.constraints.extend(span.into_iter().map(|zero| (zero, false)));
            }
            _ => return None,
        }
        Some(())
    }

    /// Adds ½ c Σ vᵢ² to the Rayleigh function.
    fn add_loss(&mut self, damping: &Jet, rates: &[Jet]) {
        let square = self.field.dot(rates, rates);
        let loss = self.half_product(damping, &square);
        self.sums.dissipation = self.field.add(&self.sums.dissipation, &loss);
    }

    fn span(&mut self, from: &Expr, to: &Expr) -> Option<Vec<Jet>> {
        let (from, to) = (self.value(from)?, self.value(to)?);
        Some(to.iter().zip(&from).map(|(to, from)| self.field.subtract(to, from)).collect())
    }

    pub(crate) fn unit(&mut self, dimension: usize) -> Matrix {
        let entry = |row, column| self.field.whole(i32::from(row == column));
        (0..dimension).map(|row| (0..dimension).map(|column| entry(row, column)).collect()).collect()
    }

    fn at_origin(&mut self, dimension: usize) -> Placed {
        let zeros = vec![self.field.whole(0); dimension];
        Placed { rotation: self.unit(dimension), origin: zeros.clone(), centroid: zeros }
    }

    fn times(&mut self, a: &Matrix, b: &Matrix) -> Matrix {
        let columns = transposed(b);
        a.iter().map(|row| columns.iter().map(|column| self.field.dot(row, column)).collect()).collect()
    }

    fn apply(&mut self, a: &Matrix, vector: &[Jet]) -> Vec<Jet> {
        a.iter().map(|row| self.field.dot(row, vector)).collect()
    }

    fn plus(&mut self, a: &[Jet], b: &[Jet]) -> Vec<Jet> {
        a.iter().zip(b).map(|(a, b)| self.field.add(a, b)).collect()
    }

    /// Stores a body. Energies are added after all joints are read.
    fn read_body(&mut self, body: &Body) -> Option<()> {
        let dimension = if body.inertia.len() == 1 { 2 } else { 3 };
        let mut placed = self.at_origin(dimension);
        if let Some(centroid) = &body.centroid {
            placed.centroid = self.scalars(centroid)?;
        }
        if let Some(pose) = &body.pose {
            self.place_by_hand(&mut placed, pose)?;
        }
        self.placed.insert(body.name.clone(), placed);
        Some(())
    }

    fn place_by_hand(&mut self, placed: &mut Placed, pose: &Pose) -> Option<()> {
        let angles = self.scalars(&pose.angles)?;
        match &angles[..] {
            [angle] if placed.origin.len() == 2 => {
                let turn = self.turn(2, angle);
                placed.rotation = turn.iter().take(2).map(|row| row[..2].to_vec()).collect();
            }
            angles => {
                for (angle, letter) in angles.iter().zip(pose.sequence.chars()) {
                    let turn = self.turn(AXES.find(letter)?, angle);
                    placed.rotation = self.times(&placed.rotation, &turn);
                }
            }
        }
        placed.origin = self.scalars(&pose.place)?;
        if pose.is_center {
            let arm = self.apply(&placed.rotation, &placed.centroid);
            let arm = arm.iter().map(|arm| self.field.negate(arm)).collect::<Vec<_>>();
            placed.origin = self.plus(&placed.origin, &arm);
        }
        Some(())
    }

    /// Returns the rotation about one axis.
    fn turn(&mut self, axis: usize, angle: &Jet) -> Matrix {
        let axis = (0..3).map(|k| self.field.whole(i32::from(k == axis))).collect::<Vec<_>>();
        self.turn_about(&axis, angle)
    }

    /// Returns c 1 + s n× + (1 − c) n nᵀ (Rodrigues).
    fn turn_about(&mut self, n: &[Jet], angle: &Jet) -> Matrix {
        let cosine = self.field.call(Function::Cos, std::slice::from_ref(angle));
        let sine = self.field.call(Function::Sin, std::slice::from_ref(angle));
        let one = self.field.whole(1);
        let rest = self.field.subtract(&one, &cosine);
        let mut turn = self.unit(3);
        for row in 0..3 {
            for column in 0..3 {
                let square = self.field.multiply(&n[row], &n[column]);
                let square = self.field.multiply(&rest, &square);
                let other = match (column + 3 - row) % 3 {
                    0 => cosine.clone(),
                    1 => {
                        let product = self.field.multiply(&sine, &n[(row + 2) % 3]);
                        self.field.negate(&product)
                    }
                    _ => self.field.multiply(&sine, &n[(row + 1) % 3]),
                };
                turn[row][column] = self.field.add(&square, &other);
            }
        }
        turn
    }

    fn read_joint(&mut self, joint: &Joint) -> Option<()> {
        let mut carrier = match &joint.from {
            Some(name) => self.placed.get(name)?.clone(),
            None => self.at_origin(3),
        };
        if let Some(at) = &joint.at {
            let at = self.scalars(at)?;
            self.advance(&mut carrier, &at);
        }
        if let Some(turned) = &joint.turned {
            let angles = self.scalars(turned)?;
            for axis in [2, 1, 0] {
                let turn = self.turn(axis, &angles[axis]);
                carrier.rotation = self.times(&carrier.rotation, &turn);
            }
        }
        let rates = self.follow(joint, &mut carrier)?;
        if let Some(damping) = &joint.damping {
            let damping = self.scalar(damping)?;
            self.add_loss(&damping, &rates);
        }
        let placed = self.placed.get_mut(&joint.to)?;
        (placed.rotation, placed.origin) = (carrier.rotation, carrier.origin);
        Some(())
    }

    /// Moves along the axes of a frame.
    fn advance(&mut self, frame: &mut Placed, by: &[Jet]) {
        let by = self.apply(&frame.rotation, by);
        frame.origin = self.plus(&frame.origin, &by);
    }

    /// Moves a frame as a joint does, and returns the velocities on which its damping acts.
    fn follow(&mut self, joint: &Joint, frame: &mut Placed) -> Option<Vec<Jet>> {
        if joint.kind == "ball" {
            let turn = self.oriented(&joint.names[0])?;
            frame.rotation = self.times(&frame.rotation, &turn);
            let spin = ["x", "y", "z"].map(|axis| Expr::Name(format!("{}_w{axis}", joint.names[0])));
            return self.scalars(&spin);
        }
        let names = joint.names.iter().map(|name| Expr::Name(name.clone())).collect::<Vec<_>>();
        let q = self.scalars(&names)?;
        let axis = self.axis(joint)?;
        let along = |world: &mut Self, by: &Jet| {
            axis.iter().map(|component| world.field.multiply(component, by)).collect::<Vec<_>>()
        };
        let (turns, moves): (Vec<(usize, usize)>, Vec<Vec<Jet>>) = match joint.kind {
            "prismatic" => (vec![], vec![along(self, &q[0])]),
            "cylindrical" => (vec![], vec![along(self, &q[1])]),
            "screw" => {
                let pitch = self.scalar(joint.pitch.as_ref()?)?;
                let pi = self.field.arithmetic.pi();
                let pi = self.field.constant(pi);
                let twice = self.field.add(&pi, &pi);
                let advance = self.field.multiply(&pitch, &q[0]);
                let advance = self.field.divide(&advance, &twice);
                (vec![], vec![along(self, &advance)])
            }
            "universal" => (vec![(0, 0), (1, 1)], vec![]),
            "planar" => (vec![(2, 2)], vec![vec![q[0].clone(), q[1].clone(), self.field.whole(0)]]),
            _ => (vec![], vec![]),
        };
        moves.iter().for_each(|by| self.advance(frame, by));
        if matches!(joint.kind, "revolute" | "screw" | "cylindrical") {
            let turn = self.turn_about(&axis, &q[0]);
            frame.rotation = self.times(&frame.rotation, &turn);
        }
        for (axis, angle) in turns {
            let turn = self.turn(axis, &q[angle]);
            frame.rotation = self.times(&frame.rotation, &turn);
        }
        Some(q.iter().map(|q| self.field.rate(q)).collect())
    }

    /// Returns the unit axis of a joint.
    fn axis(&mut self, joint: &Joint) -> Option<Vec<Jet>> {
        let Some(axis) = &joint.axis else {
            return Some([0, 0, 1].map(|component| self.field.whole(component)).into());
        };
        let axis = self.scalars(axis)?;
        let length = self.field.norm(&axis);
        Some(axis.iter().map(|component| self.field.divide(component, &length)).collect())
    }

    /// Adds the energies of a body at its place.
    pub(crate) fn add_energies(&mut self, body: &Body) -> Option<()> {
        let placed = self.placed.get(&body.name)?.clone();
        let (mass, inertia) = (self.scalar(&body.mass)?, self.scalars(&body.inertia)?);
        let center = self.point(&body.name, &placed.centroid)?;
        let velocity = center.iter().map(|c| self.field.rate(c)).collect::<Vec<_>>();
        let square = self.field.dot(&velocity, &velocity);
        let moving = self.half_product(&mass, &square);
        let spin = self.own_spin(&placed.rotation);
        let momentum = self.spin_momentum(&inertia, &spin);
        let turning = self.field.dot(&spin, &momentum);
        let one = self.field.whole(1);
        let turning = self.half_product(&one, &turning);
        let sum = self.field.add(&moving, &turning);
        self.sums.kinetic = self.field.add(&self.sums.kinetic, &sum);
        let weight = self.field.dot(&self.gravity.clone(), &center);
        let weight = self.field.multiply(&mass, &weight);
        self.sums.potential = self.field.subtract(&self.sums.potential, &weight);
        Some(())
    }

    /// Returns J ω from xx, yy, zz, and from xy, xz, yz if they exist.
    fn spin_momentum(&mut self, inertia: &[Jet], spin: &[Jet]) -> Vec<Jet> {
        let entry = |row: usize, column: usize| if row == column { row } else { row + column + 2 };
        let zero = self.field.whole(0);
        let row = |row: usize| {
            let row = (0..spin.len()).map(|column| inertia.get(entry(row, column)).unwrap_or(&zero).clone());
            self.field.dot(&row.collect::<Vec<_>>(), spin)
        };
        (0..spin.len()).map(row).collect()
    }

    /// Returns ω of Rᵀ Ṙ, a single number in the plane.
    fn own_spin(&mut self, rotation: &Matrix) -> Vec<Jet> {
        let rates = rotation.iter().map(|row| row.iter().map(|entry| self.field.rate(entry)).collect());
        let rates = rates.collect::<Matrix>();
        let skew = self.times(&transposed(rotation), &rates);
        match rotation.len() {
            2 => vec![skew[1][0].clone()],
            _ => vec![skew[2][1].clone(), skew[0][2].clone(), skew[1][0].clone()],
        }
    }

    /// Returns the angular velocity of a body in the world.
    pub(crate) fn spin(&mut self, body: &str) -> Option<Vec<Jet>> {
        let rotation = self.placed.get(body)?.rotation.clone();
        let spin = self.own_spin(&rotation);
        Some(self.apply(&rotation, &spin))
    }

    pub(crate) fn point(&mut self, body: &str, own: &[Jet]) -> Option<Vec<Jet>> {
        let placed = self.placed.get(body)?.clone();
        let arm = self.apply(&placed.rotation, own);
        Some(self.plus(&placed.origin, &arm))
    }
}

fn transposed(a: &Matrix) -> Matrix {
    (0..a[0].len()).map(|column| a.iter().map(|row| row[column].clone()).collect()).collect()
}
