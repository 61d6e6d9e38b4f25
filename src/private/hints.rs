//! Compiler messages for products that a declaration does not emit.
//!
//! Declarations bring these traits into scope, without names. Each has the name of a product, for types that implement another trait,
//! which none does and which says what to do. So they are never found beside anything else of that name, be it emitted, written by
//! users, or that of another trait; where there is nothing else, the compiler explains why they are not. There is nothing here to run.

/// A system that emits `jacobian`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `jacobian`",
    label = "not emitted",
    note = "add `emit {{ jacobian }}` to the declaration",
    note = "the method of the trait `OdeSystem` is for methods of integration, and returns `None` here"
)]
pub trait EmitsJacobian {}

/// The name of that product.
pub trait Jacobian {
    /// Never called.
    fn jacobian(&self) {}
}

impl<M: EmitsJacobian> Jacobian for M {}

/// A system that emits `tangent_jacobian`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `tangent_jacobian`",
    label = "not emitted",
    note = "add `emit {{ tangent_jacobian }}` to the declaration"
)]
pub trait EmitsTangentJacobian {}

/// The name of that product.
pub trait TangentJacobian {
    /// Never called.
    fn tangent_jacobian(&self) {}
}

impl<M: EmitsTangentJacobian> TangentJacobian for M {}

/// A system that emits `parameter_jacobian`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `parameter_jacobian`",
    label = "not emitted",
    note = "add `emit {{ parameter_jacobian }}` to the declaration"
)]
pub trait EmitsParameterJacobian {}

/// The name of that product.
pub trait ParameterJacobian {
    /// Never called.
    fn parameter_jacobian(&self) {}
}

impl<M: EmitsParameterJacobian> ParameterJacobian for M {}

/// A system that emits `bias`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `bias`",
    label = "not emitted",
    note = "add `emit {{ bias }}` to the declaration"
)]
pub trait EmitsBias {}

/// The name of that product.
pub trait Bias {
    /// Never called.
    fn bias(&self) {}
}

impl<M: EmitsBias> Bias for M {}

/// A system that emits `prepared`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `prepared`",
    label = "not emitted",
    note = "add `emit {{ prepared }}` to the declaration"
)]
pub trait EmitsPrepared {}

/// The name of that product.
pub trait Prepared {
    /// Never called.
    fn prepared(&self) {}
}

impl<M: EmitsPrepared> Prepared for M {}

/// A system that emits `lanes`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `lanes`",
    label = "not emitted",
    note = "add `emit {{ lanes }}` to the declaration"
)]
pub trait EmitsLanes {}

/// The name of that product.
pub trait Lanes {
    /// Never called.
    fn lanes(&self) {}
}

impl<M: EmitsLanes> Lanes for M {}

/// A system that emits `momentum_rates`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `momentum_rates`",
    label = "not emitted",
    note = "add `emit {{ momentum_rates }}` to the declaration"
)]
pub trait EmitsMomentumRates {}

/// The name of that product.
pub trait MomentumRates {
    /// Never called.
    fn momentum_rates(&self) {}
}

impl<M: EmitsMomentumRates> MomentumRates for M {}

/// A system that emits `mass_matrix`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `mass_matrix`",
    label = "not emitted",
    note = "take `no mass_matrix` out of its `emit {{ … }}`"
)]
pub trait EmitsMassMatrix {}

/// The name of that product.
pub trait MassMatrix {
    /// Never called.
    fn mass_matrix(&self) {}
}

impl<M: EmitsMassMatrix> MassMatrix for M {}

/// A system that emits `forcing`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `forcing`",
    label = "not emitted",
    note = "take `no forcing` out of its `emit {{ … }}`"
)]
pub trait EmitsForcing {}

/// The name of that product.
pub trait Forcing {
    /// Never called.
    fn forcing(&self) {}
}

impl<M: EmitsForcing> Forcing for M {}

/// A system that emits `momenta`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `momenta`",
    label = "not emitted",
    note = "take `no momenta` out of its `emit {{ … }}`"
)]
pub trait EmitsMomenta {}

/// The name of that product.
pub trait Momenta {
    /// Never called.
    fn momenta(&self) {}
}

impl<M: EmitsMomenta> Momenta for M {}

/// A system that emits `kinetic_energy`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `kinetic_energy`",
    label = "not emitted",
    note = "take `no kinetic_energy` out of its `emit {{ … }}`",
    note = "a system that is declared by `lagrangian = …;` has no kinetic energy of its own"
)]
pub trait EmitsKineticEnergy {}

/// The name of that product.
pub trait KineticEnergy {
    /// Never called.
    fn kinetic_energy(&self) {}
}

impl<M: EmitsKineticEnergy> KineticEnergy for M {}

/// A system that emits `potential_energy`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `potential_energy`",
    label = "not emitted",
    note = "take `no potential_energy` out of its `emit {{ … }}`",
    note = "a system that is declared by `lagrangian = …;` has no potential energy of its own"
)]
pub trait EmitsPotentialEnergy {}

/// The name of that product.
pub trait PotentialEnergy {
    /// Never called.
    fn potential_energy(&self) {}
}

impl<M: EmitsPotentialEnergy> PotentialEnergy for M {}

/// A system that emits `energy`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `energy`",
    label = "not emitted",
    note = "take `no energy` out of its `emit {{ … }}`"
)]
pub trait EmitsEnergy {}

/// The name of that product.
pub trait Energy {
    /// Never called.
    fn energy(&self) {}
}

impl<M: EmitsEnergy> Energy for M {}

/// A system that emits `inverse_dynamics`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `inverse_dynamics`",
    label = "not emitted",
    note = "take `no inverse_dynamics` out of its `emit {{ … }}`"
)]
pub trait EmitsInverseDynamics {}

/// The name of that product.
pub trait InverseDynamics {
    /// Never called.
    fn inverse_dynamics(&self) {}
}

impl<M: EmitsInverseDynamics> InverseDynamics for M {}

/// A system that emits `constraints`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `constraints`",
    label = "not emitted",
    note = "systems with constraints emit it, unless `emit {{ … }}` says `no constraints`"
)]
pub trait EmitsConstraints {}

/// The name of that product.
pub trait Constraints {
    /// Never called.
    fn constraints(&self) {}
}

impl<M: EmitsConstraints> Constraints for M {}

/// A system that emits `constraint_velocity`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `constraint_velocity`",
    label = "not emitted",
    note = "systems with constraints emit it"
)]
pub trait EmitsConstraintVelocity {}

/// The name of that product.
pub trait ConstraintVelocity {
    /// Never called.
    fn constraint_velocity(&self) {}
}

impl<M: EmitsConstraintVelocity> ConstraintVelocity for M {}

/// A system that emits `constraint_jacobian`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `constraint_jacobian`",
    label = "not emitted",
    note = "systems with constraints emit it"
)]
pub trait EmitsConstraintJacobian {}

/// The name of that product.
pub trait ConstraintJacobian {
    /// Never called.
    fn constraint_jacobian(&self) {}
}

impl<M: EmitsConstraintJacobian> ConstraintJacobian for M {}

/// A system that emits `constraint_forces`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `constraint_forces`",
    label = "not emitted",
    note = "systems with constraints emit it, unless `emit {{ … }}` says `no constraint_forces`"
)]
pub trait EmitsConstraintForces {}

/// The name of that product.
pub trait ConstraintForces {
    /// Never called.
    fn constraint_forces(&self) {}
}

impl<M: EmitsConstraintForces> ConstraintForces for M {}

/// A system that emits `STATEMENTS`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `STATEMENTS`",
    label = "not emitted",
    note = "add `emit {{ statements }}` to the declaration",
    note = "only systems with rigid bodies have these statements"
)]
pub trait EmitsStatements {}

/// The name of that product.
pub trait Statements {
    /// Never read.
    const STATEMENTS: () = ();
}

impl<M: EmitsStatements> Statements for M {}

/// A system that emits `KERNEL_F64`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `KERNEL_F64`",
    label = "not emitted",
    note = "add `emit {{ kernel }}` to the declaration"
)]
pub trait EmitsKernelF64 {}

/// The name of that product.
pub trait KernelF64 {
    /// Never read.
    const KERNEL_F64: () = ();
}

impl<M: EmitsKernelF64> KernelF64 for M {}

/// A system that emits `KERNEL_F32`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `KERNEL_F32`",
    label = "not emitted",
    note = "add `emit {{ kernel }}` to the declaration"
)]
pub trait EmitsKernelF32 {}

/// The name of that product.
pub trait KernelF32 {
    /// Never read.
    const KERNEL_F32: () = ();
}

impl<M: EmitsKernelF32> KernelF32 for M {}

/// A system that emits `EQUATIONS_LATEX`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `EQUATIONS_LATEX`",
    label = "not emitted",
    note = "add `emit {{ latex }}` to the declaration"
)]
pub trait EmitsLatex {}

/// The name of that product.
pub trait Latex {
    /// Never read.
    const EQUATIONS_LATEX: () = ();
}

impl<M: EmitsLatex> Latex for M {}

/// A system that emits `PARAMETERS`.
#[diagnostic::on_unimplemented(
    message = "the declaration of `{Self}` does not emit `PARAMETERS`",
    label = "not emitted",
    note = "add `emit {{ parameter_jacobian }}` to the declaration: these are the names of its columns"
)]
pub trait EmitsParameters {}

/// The name of that product.
pub trait Parameters {
    /// Never read.
    const PARAMETERS: () = ();
}

impl<M: EmitsParameters> Parameters for M {}

/// Something with a default value. Only modules with a system that has none know of it, and what is said is true of other types, too.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no default value",
    label = "no default value",
    note = "a declared system has one if each of its parameters does, as by `param m = 2.0;`",
    note = "or write it with all its fields, as `Name {{ m: 2.0, l: 1.0 }}`"
)]
pub trait HasDefault {}

/// The name of that value.
pub trait DefaultValue: Sized {
    /// Never called.
    fn default() {}
}

impl<M: HasDefault> DefaultValue for M {}

/// Brings the names into scope.
#[doc(hidden)]
#[macro_export]
macro_rules! __hints {
    () => {
        #[allow(unused_imports, reason = "they are for what the compiler says of what is not emitted")]
        use $crate::private::hints::{
            Bias as _, ConstraintForces as _, ConstraintJacobian as _, ConstraintVelocity as _,
            Constraints as _, Energy as _, Forcing as _, InverseDynamics as _, Jacobian as _, KernelF32 as _,
            KernelF64 as _, KineticEnergy as _, Lanes as _, Latex as _, MassMatrix as _, Momenta as _,
            MomentumRates as _, ParameterJacobian as _, Parameters as _, PotentialEnergy as _, Prepared as _,
            Statements as _, TangentJacobian as _,
        };
    };
    (default) => {
        #[allow(
            unused_imports,
            reason = "it is for what the compiler says where there is no default value"
        )]
        use $crate::private::hints::DefaultValue as _;
    };
}
