//! Taylor series of interpreted systems, by the operations of emitted code.

use lagrange_core::pipeline::{MotionSeries, SlotPlaces};
use lagrange_runtime::system::{
    Order, StateVector, StoredProducts, TaylorSystem, negative_inverse, negative_inverse_of_definite,
};

use crate::inline::Inline;
use crate::system::DynamicSystem;

/// Coefficients of an expansion, whose numbers the first expansion finds.
#[derive(Clone, Debug)]
pub struct DynamicSeries {
    /// Inputs of a step.
    slots: Vec<f64>,
    results: Vec<f64>,
    products: StoredProducts<f64>,
}

impl DynamicSeries {
    /// Makes room for the series of a system.
    fn resize(&mut self, of: &MotionSeries) {
        self.slots.resize(of.places.end, 0.0);
        self.results.resize(of.results.end, 0.0);
        let sides = (of.results.groups - of.results.shared) / 4;
        self.products.resize([sides, of.of_group.len(), of.arguments.len()]);
    }

    /// Prepares the first step from the values at a state.
    fn begin(&mut self, of: &MotionSeries) {
        for (slot, initial) in (of.places.carried..).zip(&of.carried) {
            self.slots[slot] = self.slots[*initial];
        }
        for (index, argument) in of.arguments.iter().enumerate() {
            let start = self.slots[argument.initial];
            let ends = argument.table.table().map(|table| table.axes[argument.axis].piece(start));
            self.products.follow(index, start, ends.unwrap_or([f64::NAN; 2]));
        }
    }

    /// Computes the coefficients of step k.
    #[inline(always)]
    fn step<const FUSED: bool>(&mut self, k: usize, of: &MotionSeries, compute: impl Fn(&[f64], &mut [f64])) {
        let SlotPlaces { order, carried, sums, .. } = of.places;
        let Order { number, reciprocal, first } = Order::after(k);
        self.slots[order..carried].copy_from_slice(&[number, reciprocal, first]);
        self.products.sums::<FUSED>(k, &of.of_group, &mut self.slots[sums..]);
        compute(&self.slots, &mut self.results);
        self.products.keep(k, &self.results[of.results.shared..]);
        let (carried_on, arguments) =
            self.results[of.results.carried..of.results.shared].split_at(sums - carried);
        for (index, coefficient) in arguments.iter().enumerate() {
            self.products.keep_argument(index, k, *coefficient);
        }
        self.slots[carried..sums].iter_mut().zip(carried_on).for_each(|(slot, found)| *slot = *found);
    }
}

/// Coefficients are NaN without series, which [`MethodChoice`](crate::MethodChoice) refuses.
impl<const CAPACITY: usize> TaylorSystem for DynamicSystem<CAPACITY> {
    type Series = DynamicSeries;

    fn series() -> DynamicSeries {
        DynamicSeries { slots: Vec::new(), results: Vec::new(), products: StoredProducts::EMPTY }
    }

    #[inline]
    fn product_groups(&self) -> usize {
        self.programs().known_series().map_or(0, |of| of.of_group.len())
    }

    // Compiled once for each instruction set that the method selects from.
    #[inline(always)]
    fn expand<const FUSED: bool>(
        &self,
        t: f64,
        y: &Inline<CAPACITY>,
        series: &mut DynamicSeries,
        coefficients: &mut [Inline<CAPACITY>],
    ) {
        let Some(of) = self.programs().known_series() else {
            let mut undefined = y.zeros();
            undefined.as_mut().fill(f64::NAN);
            return coefficients.fill(undefined);
        };
        let (q, v) = y.parts(0);
        series.resize(of);
        self.numeric.begin_series(of, (t, q, v), &mut series.slots[..of.places.order]);
        let matrix = &mut series.slots[of.places.inverse..of.places.order];
        match of.is_definite {
            true => negative_inverse_of_definite(matrix, of.rows),
            false if of.rows > 0 => negative_inverse(matrix, &Inline::<CAPACITY>::of(&vec![0.0; of.rows])),
            false => {}
        }
        series.begin(of);
        let compute = self.numeric.series_step(of);
        for (k, coefficients) in coefficients.iter_mut().enumerate() {
            series.step::<FUSED>(k, of, &compute);
            *coefficients = y.zeros();
            coefficients.as_mut().iter_mut().zip(&series.results).for_each(|(entry, found)| *entry = *found);
        }
    }

    #[inline]
    fn reach(series: &DynamicSeries, h: f64) -> f64 {
        series.products.reach(h)
    }
}
