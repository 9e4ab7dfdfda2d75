//! Polynomials in place of the sine in the force: Salas's two, Taylor's, and the best one of a degree on a range
//! (remez.rs).
//!
//! A polynomial is known by how far its coefficients depart from Taylor's, so that its distance from the sine is one
//! series without cancellation, right to its own last digits.

use super::entry::{Entry, Named, Orders, Row, entries, row};
use super::remez;
use super::salas::{CUBIC, DEGREES_70, DEGREES_120, QUINTIC};
use super::search::{crossing, peak};
use crate::domain::Domain;
use crate::float::Td;
use core::f64::consts::{PI, TAU};

/// Where the coefficients come from; Salas's after the first.
enum SineRule {
    Salas(&'static [[f64; 2]]),
    Taylor,
    Best,
}

const TABLE: &[Row<SineRule>] = &[
    row(
        Entry::new("salas-2", "φ − 40φ³/243", "Salas 2019 (2)").for_range("|φ| < 70 deg", [0.0, DEGREES_70]),
        SineRule::Salas(&[CUBIC]),
    ),
    row(
        Entry::new("salas-3", "φ − 40φ³/243 + φ⁵/131", "Salas 2019 (3)")
            .for_range("|φ| ≤ 120 deg", [0.0, DEGREES_120]),
        SineRule::Salas(&[CUBIC, QUINTIC]),
    ),
    row(
        Entry::new("taylor", "φ − φ³/3! + φ⁵/5! − … to φ^N, N odd", "Taylor series, DLMF 4.19.1")
            .of_order(Orders::every_second([1, 99])),
        SineRule::Taylor,
    ),
    row(
        Entry {
            name: "best",
            orders: Some(Orders::every_second([1, 21])),
            formula: "the odd polynomial P of degree N with the least largest |sin φ − P(φ)| for |φ| ≤ phi_max, N odd",
            source: "Chebyshev's alternation, by Remez's exchange",
            stated: "|φ| ≤ phi_max",
            ..Entry::new("", "", "")
        },
        SineRule::Best,
    ),
];

/// Every polynomial for sin(phi); N is its degree, odd.
pub static SINES: [Entry; TABLE.len()] = entries(TABLE);

/// Terms of a polynomial's distance from the sine after its own: they are below 2^-157 of it up to twice pi.
const TERMS: usize = 48;
/// Points between which a peak is looked for.
const POINTS: usize = 600;

/// A polynomial for the sine.
///
/// ```
/// use libration::approx::SineFormula;
/// let formula = SineFormula::named("salas-2", None)?;
/// let error = formula.largest_error(70f64.to_radians())?;
/// assert_eq!(format!("{:.5} {:.3} %", error.absolute, 100.0 * error.relative), "0.01814 1.931 %");
/// # Ok::<(), libration::Domain>(())
/// ```
#[derive(Clone, Debug)]
pub struct SineFormula {
    named: Named,
    phi_max: Option<f64>,
    /// Of phi, phi^3, ...
    exact: Vec<Td>,
    coefficients: Vec<f64>,
    /// Coefficients of its difference from the sine, without end.
    difference: Vec<Td>,
}

/// The largest distance of a polynomial from the sine on a range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SineError {
    /// Largest |P(phi) - sin(phi)|.
    pub absolute: f64,
    /// Where, in rad.
    pub at: f64,
    /// Largest |P(phi)/sin(phi) - 1|, infinite beyond pi.
    pub relative: f64,
    /// Where, in rad; 0 if it is the limit there.
    pub relative_at: f64,
}

/// 1/1!, -1/3!, 1/5!, ...
fn taylor(count: usize) -> Vec<Td> {
    let mut terms = vec![Td::ONE];
    for k in 1..count {
        let power = (2 * k + 1) as f64;
        terms.push(-terms[k - 1] / Td::from(power * (power - 1.0)));
    }
    terms
}

/// phi (c_0 + c_1 phi^2 + ...).
fn odd(coefficients: &[Td], phi: f64) -> Td {
    let square = Td::product(phi, phi);
    coefficients.iter().rev().fold(Td::ZERO, |sum, c| sum * square + *c) * phi
}

/// The order of triple-doubles that are not negative.
fn ordered(value: Td) -> (f64, f64, f64) {
    (value.hi, value.mid, value.lo)
}

impl SineFormula {
    /// By its name, `name` or `name:N`; `phi_max` in (0, 2 pi] belongs to `best:N` and to it alone.
    pub fn named(name: &str, phi_max: Option<f64>) -> Result<SineFormula, Domain> {
        let (named, kind) = Named::find("sine", TABLE, name)?;
        let count = named.order.div_ceil(2) as usize;
        let (departures, exact) = match (kind, phi_max) {
            (SineRule::Best, None) => {
                return Err(Domain::new("phi_max", "none".to_string(), "given for best:N"));
            }
            (SineRule::Best, Some(phi_max)) => {
                let phi_max = allowed(phi_max)?;
                let departures = remez::departures(count, phi_max);
                let allowed = "where the exchange of Remez ends";
                let departures =
                    departures.ok_or_else(|| Domain::new("phi_max", format!("{phi_max:?}"), allowed))?;
                let exact = taylor(count).into_iter().zip(&departures).map(|(c, d)| c + *d).collect();
                (departures, exact)
            }
            (SineRule::Taylor | SineRule::Salas(_), Some(phi_max)) => {
                return Err(Domain::new("phi_max", format!("{phi_max:?}"), "left out but for best:N"));
            }
            (SineRule::Taylor, None) => (vec![Td::ZERO; count], taylor(count)),
            (SineRule::Salas(quotients), None) => {
                let rest = quotients.iter().map(|[above, below]| Td::from(*above) / Td::from(*below));
                let exact: Vec<Td> = core::iter::once(Td::ONE).chain(rest).collect();
                (exact.iter().zip(taylor(exact.len())).map(|(c, t)| *c - t).collect(), exact)
            }
        };
        let coefficients = exact.iter().map(|c| c.hi).collect();
        let tail = taylor(exact.len() + TERMS).split_off(exact.len()).into_iter().map(|c| -c);
        let difference = departures.into_iter().chain(tail).collect();
        Ok(SineFormula { named, phi_max, exact, coefficients, difference })
    }
    /// What is known of it.
    pub fn entry(&self) -> &'static Entry {
        self.named.entry
    }
    /// The name that finds it again, beside `phi_max`.
    pub fn name(&self) -> String {
        self.named.name()
    }
    /// The range that `best:N` is best on.
    pub fn phi_max(&self) -> Option<f64> {
        self.phi_max
    }
    /// Of phi, phi^3, phi^5, ...
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }
    /// P(phi) of the coefficients before they are rounded; NaN for what is not finite or leaves the range.
    ///
    /// **Error** at most 1 ulp, plus 2^-140 of the largest term.
    pub fn value(&self, phi: f64) -> f64 {
        let value = odd(&self.exact, phi).hi;
        if value.is_finite() { value } else { f64::NAN }
    }

    /// The largest distance from the sine for |phi| <= `phi_max`, in (0, 2 pi].
    ///
    /// **Error** at most 2 ulp; the places to 1e-14 of them, as flat as a maximum is.
    pub fn largest_error(&self, phi_max: f64) -> Result<SineError, Domain> {
        let phi_max = allowed(phi_max)?;
        let points: Vec<f64> = marks(phi_max).collect();
        let size = |phi: f64| ordered(odd(&self.difference, phi).abs());
        let (at, absolute) = largest(&points, size);
        let sine = taylor(self.difference.len());
        let relative = |phi: f64| {
            if phi == 0.0 {
                return ordered(self.difference[0].abs());
            }
            ordered((odd(&self.difference, phi) / odd(&sine, phi)).abs())
        };
        let (relative_at, relative) =
            if phi_max > PI { (PI, f64::INFINITY) } else { largest(&points, relative) };
        Ok(SineError { absolute, at, relative, relative_at })
    }

    /// The values of `phi_max` in (0, 2 pi] for which the largest distance from the sine stays within a bound: one
    /// interval from 0, to the last double.
    ///
    /// | argument | domain |
    /// |---|---|
    /// | `bound` | at least 1e-30, finite |
    pub fn ranges(&self, bound: f64) -> Result<Vec<[f64; 2]>, Domain> {
        Domain::check("bound", bound, (1e-30..f64::INFINITY).contains(&bound), "finite and at least 1e-30")?;
        let size = |phi: f64| odd(&self.difference, phi).abs();
        // Those of the own range too, because that may be a small part of the whole.
        let mut points: Vec<f64> = marks(TAU).chain(self.phi_max.into_iter().flat_map(marks)).collect();
        points.sort_by(f64::total_cmp);
        points.dedup();
        let mut peaks: Vec<f64> = tops(&points, |phi| ordered(size(phi)));
        peaks.append(&mut points);
        peaks.sort_by(f64::total_cmp);
        let within = |phi: f64| size(phi).hi <= bound;
        let end = peaks.windows(2).find(|pair| !within(pair[1]));
        Ok(vec![[0.0, end.map_or(TAU, |pair| crossing(within, pair[0], pair[1]))]])
    }
}

/// `phi_max`, where it is one.
fn allowed(phi_max: f64) -> Result<f64, Domain> {
    Domain::check("phi_max", phi_max, 0.0 < phi_max && phi_max <= TAU, "above 0 and at most 2 pi")
}

/// Points of [0, phi_max], denser towards its end, as the peaks of a best polynomial are.
fn marks(phi_max: f64) -> impl Iterator<Item = f64> {
    (0..=POINTS).map(|i| i as f64 / POINTS as f64).map(move |u| phi_max * (u * (2.0 - u)))
}

/// The places of the maxima between the points.
fn tops<V: PartialOrd>(points: &[f64], size: impl Fn(f64) -> V) -> Vec<f64> {
    let sizes: Vec<V> = points.iter().map(|phi| size(*phi)).collect();
    let top = |i: &usize| sizes[*i] > sizes[i - 1] && sizes[*i] >= sizes[i + 1];
    (1..points.len() - 1).filter(top).map(|i| peak(&size, points[i - 1], points[i + 1])).collect()
}

/// How large a size is on the points, the ends among them, and between; and where, the last of places that are alike,
/// as the peaks of a best polynomial are.
fn largest(points: &[f64], size: impl Fn(f64) -> (f64, f64, f64)) -> (f64, f64) {
    let places: Vec<f64> =
        [points[0], points[points.len() - 1]].into_iter().chain(tops(points, &size)).collect();
    let sizes: Vec<f64> = places.iter().map(|phi| size(*phi).0).collect();
    let most = sizes.iter().copied().fold(0.0, f64::max);
    let alike = places.iter().zip(&sizes).filter(|(_, size)| **size >= most * (1.0 - 1e-15));
    (alike.map(|(phi, _)| *phi).fold(0.0, f64::max), most)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn best_polynomials_are_found_on_every_range() {
        for phi_max in [1e-30, 1e-3, 0.1, 1.0, 2.0, 3.0, PI, 4.0, 5.0, 6.0, TAU] {
            for order in (1..=21).step_by(2) {
                let name = format!("best:{order}");
                let best = SineFormula::named(&name, Some(phi_max)).unwrap();
                let least = best.largest_error(phi_max).unwrap().absolute;
                let taylor = SineFormula::named(&format!("taylor:{order}"), None).unwrap();
                let other = taylor.largest_error(phi_max).unwrap().absolute;
                assert!(
                    least <= other && (least < 0.6 * other || other == 0.0),
                    "{name} {phi_max} {least:e} {other:e}"
                );
            }
        }
    }

    #[test]
    fn refusals_are_one_clear_line() {
        let refused =
            |name, phi_max| SineFormula::named(name, phi_max).err().map(|error| error.to_string()).unwrap();
        assert_eq!(
            refused("taylor:4", None),
            "sine = \"taylor:4\": must be taylor:N with an odd N from 1 to 99"
        );
        assert_eq!(refused("best:5", None), "phi_max = none: must be given for best:N");
        assert_eq!(refused("best:5", Some(7.0)), "phi_max = 7.0: must be above 0 and at most 2 pi");
        assert_eq!(refused("salas-2", Some(1.0)), "phi_max = 1.0: must be left out but for best:N");
        assert!(refused("salas", None).starts_with("sine = \"salas\": must be one of salas-2, salas-3, "));
    }
}
