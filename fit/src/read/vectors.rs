//! Names for vectors of three: gravity's length tells the accelerometer, and the other one is the gyroscope.

use super::dialect::Separator;
use super::heads::Head;
use super::table::Table;

/// Names the columns of `[ax, ay, az]; [gx, gy, gz]; t`.
pub(super) fn name(table: &mut Table<'_>) {
    if table.separator() != Separator::Vectors {
        return;
    }
    let starts: Vec<usize> = (0..table.heads.len())
        .filter(|k| table.heads[*k].name.starts_with("vector ") && table.heads[*k].name.ends_with(" x"))
        .filter(|k| k + 2 < table.heads.len())
        .collect();
    for start in starts {
        let mut lengths: Vec<f64> = (0..table.lines.len())
            .map(|row| {
                (start..start + 3).map(|k| table.columns[k][row] * table.columns[k][row]).sum::<f64>().sqrt()
            })
            .filter(|length| length.is_finite())
            .collect();
        let length = super::profile::median(&mut lengths).unwrap_or(0.0);
        let weighs = [(1.0, "g"), (9.80665, "m/s^2"), (1000.0, "mg")]
            .into_iter()
            .find(|(g, _)| (length - g).abs() < 0.3 * g);
        for (k, axis) in (start..start + 3).zip(["x", "y", "z"]) {
            let head = match weighs {
                Some((_, unit)) => format!("acceleration {axis} ({unit})"),
                None => format!("gyroscope {axis}"),
            };
            table.heads[k] = Head { written: (k + 1).to_string(), ..Head::of(&head) };
        }
        let what = weighs.map_or("a gyroscope".to_owned(), |(_, unit)| format!("an accelerometer in {unit}"));
        table.understood.push(format!("Columns {} to {} are {what} by their size.", start + 1, start + 3));
    }
}
