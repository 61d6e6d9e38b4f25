//! Compiler messages for products that a declaration does not emit.
//!
//! Each row makes two traits. One has the name of the product and is implemented for all types that
//! implement the other, which none does. Declarations bring the first into scope, without its name.
//! The compiler therefore finds these items nowhere and prefers any other of the name. Where there
//! is none, it reports the message and the notes of the row. Nothing here ever runs.

/// Makes the traits of each row. The macro at the end of the file brings them into scope.
macro_rules! hints {
    (
        $($public:tt $trait:tt $emits:ident $empty:tt for $kind:ident $item:ident in $name:ident:
        $message:literal $(, $note:literal)*;)*
    ) => {
        $(
            #[doc = concat!("A system that emits `", stringify!($item), "`.")]
            #[diagnostic::on_unimplemented(message = $message, label = "not emitted" $(, note = $note)*)]
            $public $trait $emits $empty

            #[doc = concat!("The name `", stringify!($item), "`.")]
            pub trait $name {
                hints! { @item $kind $item }
            }

            impl<M: $emits> $name for M {}
        )*
    };
    (@item fn $item:ident) => {
        /// Stands for a method that is never called.
        fn $item(&self) {}
    };
    (@item const $item:ident) => {
        /// Never read.
        const $item: () = ();
    };
}

hints! {
    pub trait EmitsJacobian {} for fn jacobian in Jacobian:
        "the declaration of `{Self}` does not emit `jacobian`",
        "add `emit {{ jacobian }}` to the declaration",
        "the method of the trait `OdeSystem` is for methods of integration, and returns `None` here";
    pub trait EmitsTangentJacobian {} for fn tangent_jacobian in TangentJacobian:
        "the declaration of `{Self}` does not emit `tangent_jacobian`",
        "add `emit {{ tangent_jacobian }}` to the declaration";
    pub trait EmitsParameterJacobian {} for fn parameter_jacobian in ParameterJacobian:
        "the declaration of `{Self}` does not emit `parameter_jacobian`",
        "add `emit {{ parameter_jacobian }}` to the declaration";
    pub trait EmitsSystemMatrix {} for fn system_matrix in SystemMatrix:
        "the declaration of `{Self}` does not emit `system_matrix`",
        "add `emit {{ system_matrix }}` to the declaration";
    pub trait EmitsEventJacobian {} for fn event_jacobian in EventJacobian:
        "the declaration of `{Self}` does not emit `event_jacobian`",
        "add `emit {{ event_jacobian }}` to the declaration",
        "only systems with events have it";
    pub trait EmitsCenterOfMass {} for fn center_of_mass in CenterOfMass:
        "the declaration of `{Self}` does not emit `center_of_mass`",
        "add `emit {{ center_of_mass }}` to the declaration",
        "only systems with rigid bodies have it";
    pub trait EmitsCentroidalMomentum {} for fn centroidal_momentum in CentroidalMomentum:
        "the declaration of `{Self}` does not emit `centroidal_momentum`",
        "add `emit {{ centroidal_momentum }}` to the declaration",
        "only systems with rigid bodies have it";
    pub trait EmitsCentroidalMomentumMatrix {} for fn centroidal_momentum_matrix in CentroidalMomentumMatrix:
        "the declaration of `{Self}` does not emit `centroidal_momentum_matrix`",
        "add `emit {{ centroidal_momentum_matrix }}` to the declaration",
        "only systems with rigid bodies have it";
    pub trait EmitsLagrangian {} for fn lagrangian in LagrangianFunction:
        "the declaration of `{Self}` does not emit `lagrangian`",
        "add `emit {{ lagrangian }}` to the declaration";
    pub trait EmitsLagrangianHessian {} for fn lagrangian_hessian in LagrangianHessian:
        "the declaration of `{Self}` does not emit `lagrangian_hessian`",
        "add `emit {{ lagrangian_hessian }}` to the declaration";
    pub trait EmitsGeneralisedForces {} for fn generalised_forces in GeneralisedForces:
        "the declaration of `{Self}` does not emit `generalised_forces`",
        "add `emit {{ generalised_forces }}` to the declaration";
    pub trait EmitsBias {} for fn bias in Bias:
        "the declaration of `{Self}` does not emit `bias`",
        "add `emit {{ bias }}` to the declaration";
    pub trait EmitsInverseMassMatrix {} for fn inverse_mass_matrix in InverseMassMatrix:
        "the declaration of `{Self}` does not emit `inverse_mass_matrix`",
        "add `emit {{ inverse_mass_matrix }}` to the declaration";
    pub trait EmitsCoriolisMatrix {} for fn coriolis_matrix in CoriolisMatrix:
        "the declaration of `{Self}` does not emit `coriolis_matrix`",
        "add `emit {{ coriolis_matrix }}` to the declaration";
    pub trait EmitsInverseDynamicsJacobian {} for fn inverse_dynamics_jacobian in InverseDynamicsJacobian:
        "the declaration of `{Self}` does not emit `inverse_dynamics_jacobian`",
        "add `emit {{ inverse_dynamics_jacobian }}` to the declaration";
    pub trait EmitsRegressor {} for fn regressor in Regressor:
        "the declaration of `{Self}` does not emit `regressor`",
        "add `emit {{ regressor }}` to the declaration",
        "reduced types with small or ignored coordinates have no regressor";
    pub trait EmitsPrepared {} for fn prepared in Prepared:
        "the declaration of `{Self}` does not emit `prepared`",
        "add `emit {{ prepared }}` to the declaration";
    pub trait EmitsLanes {} for fn lanes in Lanes:
        "the declaration of `{Self}` does not emit `lanes`",
        "add `emit {{ lanes }}` to the declaration",
        "ensembles compute in lanes by themselves if the declaration emits them";
    pub trait EmitsTaylor {} for fn taylor in Taylor:
        "the declaration of `{Self}` does not emit `taylor`",
        "add `emit {{ taylor }}` to the declaration";
    pub trait EmitsMomentumRates {} for fn momentum_rates in MomentumRates:
        "the declaration of `{Self}` does not emit `momentum_rates`",
        "add `emit {{ momentum_rates }}` to the declaration";
    pub trait EmitsMassMatrix {} for fn mass_matrix in MassMatrix:
        "the declaration of `{Self}` does not emit `mass_matrix`",
        "take `no mass_matrix` out of its `emit {{ … }}`";
    pub trait EmitsForcing {} for fn forcing in Forcing:
        "the declaration of `{Self}` does not emit `forcing`",
        "take `no forcing` out of its `emit {{ … }}`";
    pub trait EmitsMomenta {} for fn momenta in Momenta:
        "the declaration of `{Self}` does not emit `momenta`",
        "take `no momenta` out of its `emit {{ … }}`";
    pub trait EmitsKineticEnergy {} for fn kinetic_energy in KineticEnergy:
        "the declaration of `{Self}` does not emit `kinetic_energy`",
        "take `no kinetic_energy` out of its `emit {{ … }}`",
        "a system declared by `lagrangian = …;` has no separate kinetic energy";
    pub trait EmitsPotentialEnergy {} for fn potential_energy in PotentialEnergy:
        "the declaration of `{Self}` does not emit `potential_energy`",
        "take `no potential_energy` out of its `emit {{ … }}`",
        "a system declared by `lagrangian = …;` has no separate potential energy";
    pub trait EmitsEnergy {} for fn energy in Energy:
        "the declaration of `{Self}` does not emit `energy`",
        "take `no energy` out of its `emit {{ … }}`";
    pub trait EmitsInverseDynamics {} for fn inverse_dynamics in InverseDynamics:
        "the declaration of `{Self}` does not emit `inverse_dynamics`",
        "take `no inverse_dynamics` out of its `emit {{ … }}`";
    pub trait EmitsConstraints {} for fn constraints in Constraints:
        "the declaration of `{Self}` does not emit `constraints`",
        "systems with constraints emit it, unless `emit {{ … }}` contains `no constraints`";
    pub trait EmitsConstraintVelocity {} for fn constraint_velocity in ConstraintVelocity:
        "the declaration of `{Self}` does not emit `constraint_velocity`",
        "systems with constraints emit it";
    pub trait EmitsConstraintJacobian {} for fn constraint_jacobian in ConstraintJacobian:
        "the declaration of `{Self}` does not emit `constraint_jacobian`",
        "systems with constraints emit it";
    pub trait EmitsConstraintForces {} for fn constraint_forces in ConstraintForces:
        "the declaration of `{Self}` does not emit `constraint_forces`",
        "systems with constraints emit it, unless `emit {{ … }}` contains `no constraint_forces`";
    pub trait DeclaresStart {} for fn start in Start:
        "the declaration of `{Self}` gives no initial values",
        "write `coord x = 1;`, or `start dot(x) = 2;` for a velocity";
    pub trait EmitsStatements {} for const STATEMENTS in Statements:
        "the declaration of `{Self}` does not emit `STATEMENTS`",
        "add `emit {{ statements }}` to the declaration",
        "only systems with rigid bodies have these statements";
    pub trait EmitsKernelF64 {} for const KERNEL_F64 in KernelF64:
        "the declaration of `{Self}` does not emit `KERNEL_F64`",
        "add `emit {{ kernel }}` to the declaration";
    pub trait EmitsKernelF32 {} for const KERNEL_F32 in KernelF32:
        "the declaration of `{Self}` does not emit `KERNEL_F32`",
        "add `emit {{ kernel }}` to the declaration";
    pub trait EmitsLatex {} for const EQUATIONS_LATEX in Latex:
        "the declaration of `{Self}` does not emit `EQUATIONS_LATEX`",
        "add `emit {{ latex }}` to the declaration";
    pub trait EmitsParameters {} for const PARAMETERS in Parameters:
        "the declaration of `{Self}` does not emit `PARAMETERS`",
        "add `emit {{ parameter_jacobian }}` to the declaration: these are the names of its columns";
}

/// A type with a default value. Imported only next to systems without a default; the message also
/// holds for other types.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no default value",
    label = "no default value",
    note = "a declared system has one if each of its parameters has a default, such as `param m = 2.0;`",
    note = "or write it with all its fields, as `Name {{ m: 2.0, l: 1.0 }}`"
)]
pub trait HasDefault {}

/// The name of that value.
pub trait DefaultValue: Sized {
    /// Stands for a method that cannot be called.
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
            Bias as _, CenterOfMass as _, CentroidalMomentum as _, CentroidalMomentumMatrix as _,
            ConstraintForces as _, ConstraintJacobian as _, ConstraintVelocity as _, Constraints as _,
            CoriolisMatrix as _, Energy as _, EventJacobian as _, Forcing as _, GeneralisedForces as _,
            InverseDynamics as _, InverseDynamicsJacobian as _, InverseMassMatrix as _, Jacobian as _,
            KernelF32 as _, KernelF64 as _, KineticEnergy as _, LagrangianFunction as _,
            LagrangianHessian as _, Lanes as _, Latex as _, MassMatrix as _, Momenta as _,
            MomentumRates as _, ParameterJacobian as _, Parameters as _, PotentialEnergy as _, Prepared as _,
            Regressor as _, Start as _, Statements as _, SystemMatrix as _, TangentJacobian as _,
            Taylor as _,
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
