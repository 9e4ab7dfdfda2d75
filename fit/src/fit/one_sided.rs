//! The covariance of values of which some cannot be negative.
//!
//! What is known before of a bounded value is that it is 0 or more, every number as likely as the next: its distribution is the normal
//! one around the minimum without bounds, cut off at 0, and the other values follow it linearly. Linear friction is cut off where
//! friction would drive the pendulum, at -sqrt(quadratic dry). Uncertainties are the roots of the mean squares about the minimum that
//! was found, so a value on its bound has one too. Draws by Gibbs's method along single values, along pairs that make up for each
//! other (Liu & Sabatti, Biometrika 87 (2000) 353) and along the axes of the normal distribution, each by Robert's rejection (Stat.
//! Comput. 5 (1995) 121).

use super::random::Stream;
use nalgebra::{DMatrix, DVector};

/// A value with a bound.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounded {
    /// Its row of the covariance.
    pub place: usize,
    /// Where it was found; not below its bound.
    pub found: f64,
    /// Where it would be without bounds.
    pub unbounded: f64,
}

/// A bound further away cuts nothing off.
const FAR: f64 = 4.0;
/// So many rounds give an uncertainty to some 3 %.
const ROUNDS: usize = 1500;

/// The mean products of the errors of all values; the covariance itself where no bound is near, or where it is singular.
///
/// The bound is 0, but for the first of the three places of `cone`, linear, quadratic and dry friction: -sqrt(second third).
pub(super) fn one_sided(
    covariance: &DMatrix<f64>,
    bounded: &[Bounded],
    cone: Option<[usize; 3]>,
) -> DMatrix<f64> {
    let at =
        |place: usize, of: fn(&Bounded) -> f64| bounded.iter().find(|b| b.place == place).map_or(0.0, of);
    let least = |b: &Bounded| match cone {
        Some([linear, quadratic, dry]) if linear == b.place => {
            -(at(quadratic, |b| b.found) * at(dry, |b| b.found)).sqrt()
        }
        _ => 0.0,
    };
    let near = |b: &Bounded| b.unbounded - least(b) < FAR * covariance[(b.place, b.place)].sqrt();
    // A near edge of the cone is one of all three.
    let cone = cone.filter(|cone| bounded.iter().any(|b| b.place == cone[0] && near(b)));
    let counts = |b: &&Bounded| near(b) || cone.is_some_and(|cone| cone.contains(&b.place));
    let bounded: Vec<Bounded> = bounded.iter().filter(counts).copied().collect();
    let places: Vec<usize> = bounded.iter().map(|b| b.place).collect();
    let all = covariance.nrows();
    let own = covariance.select_rows(&places).select_columns(&places);
    let Some(root) = own.clone().cholesky().filter(|_| !bounded.is_empty()) else {
        return covariance.clone();
    };
    let precision = root.inverse();
    let within = |place: usize| places.iter().position(|other| *other == place).unwrap_or(0);
    let moments = moments(&bounded, &precision, cone.map(|cone| cone.map(within)));
    // All values by those with bounds; of the latter the identity.
    let by = covariance.select_columns(&places) * precision;
    let apart = covariance - &by * own * by.transpose();
    let mut found = &apart + &by * &moments * by.transpose();
    found = 0.5 * (&found + found.transpose());
    if (0..all).all(|i| found[(i, i)] > 0.0) { found } else { covariance.clone() }
}

/// The mean products of b less what was found, b normal around `unbounded` and not below its bounds.
fn moments(bounded: &[Bounded], precision: &DMatrix<f64>, cone: Option<[usize; 3]>) -> DMatrix<f64> {
    let size = bounded.len();
    // Single values, pairs whose effects on the record cancel, and the axes of the normal distribution of values in units of their own.
    let alone = |i: usize| 1.0 / precision[(i, i)].sqrt();
    let scaled = DMatrix::from_fn(size, size, |i, j| precision[(i, j)] * alone(i) * alone(j));
    let axes = scaled.symmetric_eigen().eigenvectors;
    let mut directions: Vec<DVector<f64>> =
        axes.column_iter().map(|axis| DVector::from_fn(size, |row, _| axis[row] * alone(row))).collect();
    for i in 0..size {
        directions.push(DVector::from_fn(size, |row, _| if row == i { alone(i) } else { 0.0 }));
        for j in 0..i {
            let sign = if precision[(i, j)] > 0.0 { -1.0 } else { 1.0 };
            let part = |row: usize| if row == i { alone(i) } else { sign * alone(j) };
            directions
                .push(DVector::from_fn(size, |row, _| if row == i || row == j { part(row) } else { 0.0 }));
        }
    }
    let found = DVector::from_fn(size, |i, _| bounded[i].found);
    let middle = DVector::from_fn(size, |i, _| bounded[i].unbounded);
    let mut draws = Draws { stream: Stream::new(0x6f6e_6573), counter: 0 };
    let (mut b, mut sum) = (found.clone(), DMatrix::zeros(size, size));
    for _ in 0..ROUNDS {
        for direction in &directions {
            let pull = precision * direction;
            let narrow = direction.dot(&pull).sqrt();
            let mean = -pull.dot(&(&b - &middle)) / (narrow * narrow);
            let (low, high) = allowed(&b, direction, cone);
            let z = draws.normal_between((low - mean) * narrow, (high - mean) * narrow);
            b += direction * (mean + z / narrow);
            // What rounding has put outside.
            inside(&mut b, cone);
        }
        let off = &b - &found;
        sum += &off * off.transpose();
    }
    sum / ROUNDS as f64
}

/// From where to where a line through an allowed point is allowed; this is one piece, because the allowed points are convex.
fn allowed(b: &DVector<f64>, direction: &DVector<f64>, cone: Option<[usize; 3]>) -> (f64, f64) {
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    let mut zero = |place: usize| {
        let (value, slope) = (b[place], direction[place]);
        match slope.partial_cmp(&0.0) {
            Some(core::cmp::Ordering::Greater) => low = low.max(-value / slope),
            Some(core::cmp::Ordering::Less) => high = high.min(-value / slope),
            _ => {}
        }
    };
    (0..b.len()).filter(|place| cone.is_none_or(|cone| cone[0] != *place)).for_each(&mut zero);
    let Some(cone) = cone else { return (low, high) };
    let ([g, q, d], [by_g, by_q, by_d]) = (cone.map(|place| b[place]), cone.map(|place| direction[place]));
    // On the edge g is not positive, and g^2 - q d = a t^2 + 2 h t + c is 0; outside it is positive.
    let a = by_g * by_g - by_q * by_d;
    let h = g * by_g - 0.5 * (q * by_d + d * by_q);
    let c = g * g - q * d;
    let root = (h * h - a * c).sqrt();
    let larger = -(h + root.copysign(h));
    let (lowest, highest) = (low, high);
    for t in [larger / a, c / larger] {
        if (lowest..=highest).contains(&t) && g + t * by_g <= 0.0 {
            if a * t + h > 0.0 { high = high.min(t) } else { low = low.max(t) }
        }
    }
    (low, high)
}

/// The nearest allowed values.
fn inside(b: &mut DVector<f64>, cone: Option<[usize; 3]>) {
    let linear = cone.map(|cone| (cone[0], b[cone[0]]));
    b.apply(|value| *value = value.max(0.0));
    if let (Some((place, linear)), Some([_, quadratic, dry])) = (linear, cone) {
        b[place] = linear.max(-(b[quadratic] * b[dry]).sqrt());
    }
}

/// Numbers of a stream one after the other.
struct Draws {
    stream: Stream,
    counter: u64,
}

impl Draws {
    fn uniform(&mut self) -> f64 {
        self.counter += 1;
        self.stream.uniform(2 * self.counter + 1)
    }

    /// A standard normal number in an interval.
    fn normal_between(&mut self, low: f64, high: f64) -> f64 {
        if high < -low {
            // The side nearer to 0 is the low one.
            return -self.normal_between_from(-high, -low);
        }
        self.normal_between_from(low, high)
    }

    fn normal_between_from(&mut self, low: f64, high: f64) -> f64 {
        let width = high - low;
        if width.is_nan() || width <= 0.0 {
            return low;
        }
        let nearest = low.max(0.0);
        let rate = 0.5 * (nearest + libm::hypot(nearest, 2.0));
        loop {
            let (z, ln_share) = if width * rate < 2.0 {
                let z = low + width * self.uniform();
                (z, 0.5 * (nearest * nearest - z * z))
            } else if low > 0.0 {
                let z = low - libm::log(self.uniform()) / rate;
                (z, -0.5 * (z - rate) * (z - rate))
            } else {
                self.counter += 1;
                (self.stream.normal(self.counter), 0.0)
            };
            if (low..=high).contains(&z) && libm::log(self.uniform()) < ln_share {
                return z;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matrix(rows: &[&[f64]]) -> DMatrix<f64> {
        DMatrix::from_fn(rows.len(), rows.len(), |i, j| rows[i][j])
    }

    #[test]
    fn one_bounded_value_has_the_moments_of_half_a_normal_distribution() {
        // Of a normal distribution cut off at its middle the mean square is that of the whole.
        let covariance = matrix(&[&[4.0, 1.2], &[1.2, 1.0]]);
        let middle = Bounded { place: 1, found: 0.0, unbounded: 0.0 };
        let found = one_sided(&covariance, &[middle], None);
        for (a, b) in found.iter().zip(covariance.iter()) {
            assert!((a - b).abs() < 0.12 * b, "{found}");
        }
        // Cut off 2 deviations above its middle: 1 + 4 - 2 h with h = phi(2)/Q(2) = 2.373216.
        let beyond = Bounded { place: 1, found: 0.0, unbounded: -2.0 };
        let found = one_sided(&covariance, &[beyond], None);
        let square = 5.0 - 2.0 * 2.373_216;
        assert!((found[(1, 1)] - square).abs() < 0.15 * square, "{found}");
        let other = 4.0 - 1.44 + 1.44 * square;
        assert!((found[(0, 0)] - other).abs() < 0.05 * other, "{found}");
        // A bound that is far changes nothing.
        let far = Bounded { place: 1, found: 4.5, unbounded: 4.5 };
        assert_eq!(one_sided(&covariance, &[far], None), covariance);
    }

    #[test]
    fn two_values_that_make_up_for_each_other_are_known_by_both_bounds() {
        // Correlation -0.999: without bounds each has a deviation of 1. With both, their sum s has the density s exp(-P s^2/2) with
        // P = 1/(1 - 0.999^2), and each is anywhere between 0 and s: the mean square is that of s, 2/P, over 3.
        let covariance = matrix(&[&[1.0, -0.999], &[-0.999, 1.0]]);
        let at = |place| Bounded { place, found: 0.0, unbounded: 0.0 };
        let found = one_sided(&covariance, &[at(0), at(1)], None);
        let square = 2.0 / 3.0 * (1.0 - 0.999 * 0.999);
        assert!((found[(0, 0)] - square).abs() < 0.1 * square, "{found}");
        assert!((found[(1, 1)] - square).abs() < 0.1 * square, "{found}");
    }

    #[test]
    fn linear_friction_is_cut_off_where_friction_would_drive() {
        // Independent values with their middle at the tip of the cone: their mean products by quadrature over the directions inside.
        let place = |place| Bounded { place, found: 0.0, unbounded: 0.0 };
        let bounded = [place(0), place(1), place(2)];
        let near = |found: &DMatrix<f64>| {
            let wanted = [[0.764, 0.290, 0.290], [0.290, 1.118, 0.743], [0.290, 0.743, 1.118]];
            (0..3).all(|i| (0..3).all(|j| (found[(i, j)] - wanted[i][j]).abs() < 0.08))
        };
        let free = one_sided(&DMatrix::identity(3, 3), &bounded, Some([0, 1, 2]));
        assert!(near(&free), "{free}");
        // The spoiled sibling: cut off at 0.
        assert!(!near(&one_sided(&DMatrix::identity(3, 3), &bounded, None)));
        // Wherever the cone is entered or left, it is in one piece.
        let mut stream = 0;
        let mut next = || {
            stream += 1;
            Stream::new(5).normal(stream)
        };
        for _ in 0..2000 {
            let mut b = DVector::from_fn(3, |_, _| next());
            b[1] = b[1].abs();
            b[2] = b[2].abs();
            b[0] = b[0].abs() - (b[1] * b[2]).sqrt();
            let direction = DVector::from_fn(3, |_, _| next());
            let (low, high) = allowed(&b, &direction, Some([0, 1, 2]));
            assert!(low <= 0.0 && high >= 0.0, "{low} {high}");
            let outside = |t: f64| {
                let at = &b + t * &direction;
                at[1] < 0.0 || at[2] < 0.0 || at[0] < -(at[1] * at[2]).sqrt()
            };
            let (below, above) = (low.max(-1e3), high.min(1e3));
            assert!(
                (1..100).all(|i| !outside(below + 0.01 * f64::from(i) * (above - below))),
                "{b} {direction}"
            );
            let beyond = 1e-6 * (above - below);
            assert!(low < -1e3 || outside(low - beyond), "{b} {direction}");
            assert!(high > 1e3 || outside(high + beyond), "{b} {direction}");
        }
    }
}
