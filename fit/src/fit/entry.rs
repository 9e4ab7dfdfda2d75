//! The one entry: data and options in, a result or a refusal out.

use super::assembly::record;
use super::data::Data;
use super::options::FitOptions;
use super::refusal::FitRefusal;
use super::result::Fit;
use super::tables::{gate, table};

/// Fits a pendulum with friction to data.
///
/// A record in time is fitted from its release to its stop, with start values of its own, by every model of [`Model`](super::Model)
/// or the one that is asked for; gate and table data are fitted by the core's period without an integration. The rest of the record
/// is always free. From a length comes g, from a g the length; without both omega0 stands alone.
///
/// # Errors
/// Where the data hold no motion, or the options contradict each other.
///
/// ```
/// use libration_fit::fit::{Data, FitOptions, Measure, fit};
/// let data = Data::Table { swings: vec![0.2, 0.6, 1.0, 1.4], periods: vec![2.0112, 2.0521, 2.1387, 2.2847] };
/// let options = FitOptions { length: Some(Measure { value: 1.0, u: 0.001 }), ..FitOptions::default() };
/// let g = fit(&data, &options)?.g.expect("a length gives g");
/// assert!((g.value - 9.81).abs() < 0.05, "{g:?}");
/// # Ok::<(), libration_fit::fit::FitRefusal>(())
/// ```
pub fn fit(data: &Data, options: &FitOptions) -> Result<Fit, FitRefusal> {
    data.check()?;
    options.check()?;
    match data {
        Data::Record { measured, t, values } => record(*measured, t, values, options),
        Data::Gate { t, periods, transits } => gate(t, periods, transits.as_deref(), options),
        Data::Table { swings, periods } => table(swings, periods, options),
    }
}
