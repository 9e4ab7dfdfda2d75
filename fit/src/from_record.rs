//! What the reader found as what the fit takes: its first series, with the quantity that it holds.

use crate::fit::{Data, Measured};
use crate::read::{Kind, Quantity, Record};

/// The data of a record; otherwise the sentence that says which quantity is missing and how it may be stated.
///
/// # Errors
/// Where the file has no quantity that a fit takes.
pub fn data(record: &Record) -> Result<Data, String> {
    let values = |quantity: Quantity| record.series(quantity).map(|series| series.values.clone());
    match record.kind {
        Kind::Gate => {
            let periods = values(Quantity::Period).ok_or("no periods between passages of the gate")?;
            let transits = values(Quantity::Transit);
            Ok(Data::Gate { t: record.time.clone(), periods, transits })
        }
        Kind::Swings => match (values(Quantity::Theta0), values(Quantity::Period)) {
            (Some(swings), Some(periods)) => Ok(Data::Table { swings, periods }),
            _ => Err("a table of periods needs the angles of release beside them".to_owned()),
        },
        Kind::Samples => {
            let first = record.series.first().ok_or("no measured column beside the time")?;
            let measured = match first.quantity {
                Quantity::Angle => Measured::Angle,
                Quantity::Velocity => Measured::Velocity,
                // The distance of the sensor is free, so an angular acceleration is one of distance 1.
                Quantity::AngularAcceleration | Quantity::LinearAcceleration => Measured::Acceleration,
                Quantity::AngleUnscaled => {
                    return Err(format!(
                        "the unit of {} is not known, and g depends on the size of the swing; write --unit angle=deg, rad, \
                         or how many make a turn, such as angle=4096/rev",
                        first.name
                    ));
                }
                other => return Err(format!("{} alone is no motion that can be fitted", other.words())),
            };
            Ok(Data::Record { measured, t: record.time.clone(), values: first.values.clone() })
        }
    }
}
