//! A column of parameters, each stated by m, mc, the modulus or the nome: m and mc of all of them, a block of rows at a time.

use super::parameter::Parameter;
use crate::float::Dd;
use crate::lanes::{Columns, Evaluation, Formula, Lane};
use core::ops::Range;

/// What a column of parameters holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Given {
    /// The parameter m.
    M,
    /// Its complement mc = 1 - m.
    Mc,
    /// The modulus k.
    Modulus,
    /// The nome q.
    Nome,
}

/// Rows whose m and mc are formed at a time.
const BLOCK: usize = 512;

impl Given {
    /// The parameter of one value.
    #[must_use]
    pub fn parameter(self, value: f64) -> Parameter {
        match self {
            Given::M => Parameter::from_m(value),
            Given::Mc => Parameter::from_mc(value),
            Given::Modulus => Parameter::from_modulus(value),
            Given::Nome => Parameter::from_nome(value),
        }
    }

    /// Hands out m and mc as double-doubles, [m.hi, m.lo, mc.hi, mc.lo], of one range of rows after the other.
    pub(crate) fn blocks(self, values: &[f64], mut use_them: impl FnMut([&[f64]; 4], Range<usize>)) {
        let mut columns = [[0.0; BLOCK]; 4];
        for from in (0..values.len()).step_by(BLOCK) {
            let rows = from..values.len().min(from + BLOCK);
            let mut halves = columns.each_mut().map(|column| &mut column[..rows.len()]);
            if self == Given::Nome {
                // The theta functions of a nome are not over lanes.
                for (row, value) in values[rows.clone()].iter().enumerate() {
                    let Parameter { m, mc, .. } = self.parameter(*value);
                    for (half, word) in halves.iter_mut().zip([m.hi, m.lo, mc.hi, mc.lo]) {
                        half[row] = word;
                    }
                }
            } else {
                Columns::new([&values[rows.clone()]], halves.each_mut().map(|half| &mut **half)).of(&self);
            }
            use_them(halves.map(|half| &*half), rows);
        }
    }
}

impl Given {
    /// m and mc as [`Parameter`] forms them, bit for bit; NaN where it does not.
    #[inline(always)]
    pub(crate) fn pair<L: Lane>(self, value: L) -> (Dd<L>, Dd<L>) {
        let (one, nan) = (L::splat(1.0), L::splat(f64::NAN));
        let (m, mc) = match self {
            Given::M => (Dd::from_double(value), Dd::sum(one, -value)),
            Given::Mc => (Dd::sum(one, -value), Dd::from_double(value)),
            Given::Modulus => (Dd::product(value, value), Dd::sum(one, -value) * Dd::sum(one, value)),
            // Formed row by row.
            Given::Nome => (Dd::new(nan, nan), Dd::new(nan, nan)),
        };
        let end = if self == Given::Modulus { 1e150_f64.next_up() } else { f64::INFINITY };
        let inside = value.abs().less(L::splat(end));
        // No closure: it would be compiled without the instruction set.
        (Dd::select(inside, m, Dd::new(nan, nan)), Dd::select(inside, mc, Dd::new(nan, nan)))
    }
}

impl Formula<1, 4> for Given {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [value]: [L; 1]) -> [L; 4] {
        let (m, mc) = self.pair(value);
        [m.hi, m.lo, mc.hi, mc.lo]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_parameter_bit_for_bit() {
        let mut values = vec![
            0.0,
            -0.0,
            1.0,
            0.5,
            1e-320,
            1e-150,
            -1e-150,
            1e150,
            1e151,
            f64::MAX,
            f64::NAN,
            f64::INFINITY,
        ];
        values.extend((0..3000).map(|i| (f64::from(i) * 0.7).sin() * 10f64.powi(i % 40 - 20)));
        for given in [Given::M, Given::Mc, Given::Modulus, Given::Nome] {
            given.blocks(&values, |columns, rows| {
                for (i, row) in rows.enumerate() {
                    let Parameter { m, mc, .. } = given.parameter(values[row]);
                    let known = [m.hi, m.lo, mc.hi, mc.lo].map(f64::to_bits);
                    let found = columns.map(|column| column[i].to_bits());
                    assert!(
                        found == known || m.hi.is_nan() && columns[0][i].is_nan(),
                        "{given:?} {}",
                        values[row]
                    );
                }
            });
        }
    }
}
