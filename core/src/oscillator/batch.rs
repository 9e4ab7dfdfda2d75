//! Motion of rows with states of their own: (t, u0, velocity0, p, q) each.
//!
//! A [`Duffing`] of the row, kept while the state repeats; NaN where an argument is not finite; panics where the
//! lengths differ. Errors and digits are those of one orbit.

use super::duffing::Duffing;

/// u and u' of every row.
///
/// ```
/// let (mut u, mut velocity) = ([0.0; 2], [0.0; 2]);
/// let rows = [&[1.0, 1.0], &[1.0, 0.0], &[0.0, 1.0], &[1.0, -1.0], &[1.0, 2.0]].map(|column| column.as_slice());
/// libration::oscillator::duffing_motion_into(rows, [&mut u, &mut velocity]);
/// assert_eq!(format!("{:.9} {:.9}", u[0], velocity[1]), "0.233691791 0.932682266");
/// ```
pub fn duffing_motion_into([t, u0, velocity0, p, q]: [&[f64]; 5], [u, velocity]: [&mut [f64]; 2]) {
    let rows = t.len();
    let fits = [u0, velocity0, p, q].iter().all(|column| column.len() == rows);
    assert!(fits && u.len() == rows && velocity.len() == rows, "rows of another length than the first");
    let mut from = 0;
    while from < rows {
        let state = |row: usize| [u0[row], velocity0[row], p[row], q[row]].map(f64::to_bits);
        let same = state(from);
        let mut to = from + 1;
        while to < rows && state(to) == same {
            to += 1;
        }
        match Duffing::new(u0[from], velocity0[from], p[from], q[from]) {
            Ok(orbit) => orbit.motion_into(&t[from..to], &mut u[from..to], &mut velocity[from..to]),
            Err(_) => {
                u[from..to].fill(f64::NAN);
                velocity[from..to].fill(f64::NAN);
            }
        }
        from = to;
    }
}
