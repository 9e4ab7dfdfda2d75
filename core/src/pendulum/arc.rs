//! Half a period of a libration, or a turn of a rotation, as polynomials: no sine, no arctangent.
//!
//! With f in [-1/2, 1/2] half periods from the bottom and x = f^2,
//!   angle = f P(t),  velocity = (1/4 - x) R(t) in libration and R(t) in rotation,  t = (w + b)/(1 + b w),  w = 8 x - 1.
//! As functions of w, P and R are analytic up to w = -(1 + 2 (K'/K)^2), where f = i K'/2K is the nearest pole. The map
//! with 1/b = the sum of the semi-axes of the ellipse through it sends the cut as far out to the left as to the right, so a
//! third to a half of the terms are saved. The leading coefficient stands for most of the sum and is carried as hi + lo.
//! Coefficients by interpolation of the theta quotients, when the first sample is asked for: docs/decisions/0011.

use super::canonical::{speed, tangent};
use super::orbit::Elliptic;
use crate::elliptic::theta::Lattice;
use crate::float::Dd;
use crate::float::double_double::fast_two_sum;
use crate::float::elementary::arctangent;
use crate::float::interpolation::{COUNTS, Interpolation, MOST};
use crate::float::loose::Loose;
use crate::lanes::{Kernel, Lane, Sampler, sweep, wide};

/// Up to this count the velocity is a polynomial too; beyond, it varies too much for one to keep its digits.
const MOST_OF_VELOCITY: usize = 24;

/// A polynomial in t, its first two coefficients to double-double.
#[derive(Clone, Debug)]
struct Powers {
    lead: Dd,
    first_rest: f64,
    /// Coefficients of t and t^2, t^3 and t^4, ...: as many as the layout counts.
    pairs: [[f64; 2]; MOST / 2],
}

/// The polynomials of one orbit.
#[derive(Clone, Debug)]
pub(crate) struct Arc {
    layout: Layout,
    angle: Powers,
    velocity: Powers,
}

/// How the arc of a lattice is laid out.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Layout {
    /// Terms, one of [`COUNTS`].
    count: usize,
    /// b of the map, a multiple of 2^-20, so that 1 - b is exact.
    bend: f64,
}

impl Layout {
    /// For a lattice, if few enough terms serve: up to about 170 degrees.
    pub fn of(lattice: &Lattice) -> Option<Layout> {
        let semi_axes = |foot: f64| foot + (foot * foot - 1.0).sqrt();
        let ellipse = semi_axes(1.0 + 2.0 * lattice.aspect * lattice.aspect);
        let bend = (1_048_576.0 / ellipse).round() / 1_048_576.0;
        let decay = semi_axes(ellipse).min(1e6).powi(4);
        // The error of n terms is some decay^(-n/4).
        const ENOUGH: f64 = 3.7e19; // 2^65
        let count = COUNTS.into_iter().find(|count| decay.powi(*count as i32 / 4) >= ENOUGH)?;
        Some(Layout { count, bend })
    }
}

impl Powers {
    fn new(coefficients: &[Dd; MOST]) -> Powers {
        let mut pairs = [[0.0; 2]; MOST / 2];
        for (i, coefficient) in coefficients.iter().enumerate().skip(1) {
            pairs[(i - 1) / 2][(i - 1) % 2] = coefficient.hi;
        }
        Powers { lead: coefficients[0], first_rest: coefficients[1].lo, pairs }
    }

    /// At t.
    #[inline(always)]
    fn at<L: Lane>(&self, count: usize, t: L) -> Dd<L> {
        // Odd and even powers apart: two chains, half as long.
        let square = t * t;
        let (mut odd, mut even) = (L::splat(0.0), L::splat(0.0));
        for [a, b] in self.pairs[..count / 2].iter().rev() {
            odd = odd.mul_add(square, L::splat(*a));
            even = even.mul_add(square, L::splat(*b));
        }
        let (hi, error) = fast_two_sum(L::splat(self.lead.hi), t * even.mul_add(t, odd));
        Dd::new(hi, error + t.mul_add(L::splat(self.first_rest), L::splat(self.lead.lo)))
    }
}

impl Arc {
    /// Of an orbit and its layout.
    #[cold]
    #[inline(never)]
    pub fn new<const ROTATION: bool>(elliptic: &Elliptic, layout: Layout) -> Arc {
        let Layout { count, bend } = layout;
        let interpolation = Interpolation::of(count);
        let mut values = [[0.0; MOST]; 4];
        wide(Measure::<ROTATION> { elliptic, bend, points: &interpolation.points, values: &mut values });
        let [angle, angle_rest, velocity, velocity_rest] = &values;
        let powers =
            |hi: &[f64], lo: &[f64]| Powers::new(&interpolation.coefficients([&hi[..count], &lo[..count]]));
        Arc { layout, angle: powers(angle, angle_rest), velocity: powers(velocity, velocity_rest) }
    }

    /// Whether the velocity is good as well.
    #[inline(always)]
    pub fn has_velocity(&self) -> bool {
        self.layout.count <= MOST_OF_VELOCITY
    }

    /// t of half periods f, |f| up to about 1/2.
    #[inline(always)]
    fn mapped<L: Lane>(&self, f: Dd<L>) -> L {
        let x = f.hi * f.hi;
        let flat = L::splat(1.0 - self.layout.bend);
        L::splat(8.0).mul_add(x, -flat) / L::splat(8.0 * self.layout.bend).mul_add(x, flat)
    }

    /// The angle.
    #[inline(always)]
    pub fn angle<L: Lane>(&self, f: Dd<L>) -> Dd<L> {
        let t = self.mapped(f);
        let Dd { hi, lo } = self.angle.at(self.layout.count, t);
        let (angle, error) = hi.two_product(f.hi);
        Dd::new(angle, hi.mul_add(f.lo, lo.mul_add(f.hi, error)))
    }

    /// The velocity.
    #[inline(always)]
    pub fn velocity<const ROTATION: bool, L: Lane>(&self, f: Dd<L>) -> L {
        let t = self.mapped(f);
        let Dd { hi, lo } = self.velocity.at(self.layout.count, t);
        if ROTATION {
            return hi + lo;
        }
        // 1/4 - f^2, also next to the turning points.
        let half = L::splat(0.5);
        let size = f.scale(L::splat(1.0).copysign(f.hi));
        let (above, above_error) = fast_two_sum(half, size.hi);
        let below = (half - size.hi) - size.lo;
        let (factor, error) = above.two_product(below);
        let below_error = ((half - size.hi) - below) - size.lo;
        let error = above.mul_add(below_error, (above_error + size.lo).mul_add(below, error));
        hi.mul_add(factor, hi.mul_add(error, lo * factor))
    }
}

/// P and R at the points of the interpolation.
struct Measure<'a, const ROTATION: bool> {
    elliptic: &'a Elliptic,
    bend: f64,
    points: &'a [Vec<f64>; 2],
    values: &'a mut [[f64; MOST]; 4],
}

/// The same on one side of the theta functions.
struct Point<'a, const ROTATION: bool, const HYPERBOLIC: bool>(&'a Elliptic, f64);

impl<L: Lane, const ROTATION: bool, const HYPERBOLIC: bool> Sampler<L, 2, 4>
    for Point<'_, ROTATION, HYPERBOLIC>
{
    #[inline(always)]
    fn at(&self, [hi, lo]: [L; 2]) -> [L; 4] {
        let Point(elliptic, bend) = self;
        let one = Loose::from_double(L::splat(1.0));
        let bend = Loose::from_double(L::splat(*bend));
        let t = Loose::new(hi, lo);
        // x = (1 - b)(1 + t)/8(1 - b t), and 1/4 - x = (1 + b)(1 - t)/8(1 - b t).
        let scale = (one - bend * t).scale(L::splat(8.0));
        let x = ((one - bend) * (one + t)).over(scale);
        let to_turning = ((one + bend) * (one - t)).over(scale);
        let f = x.root();
        let thetas = elliptic.lattice.thetas_on::<HYPERBOLIC, L>(f.tight());
        let [opposite, adjacent] = tangent::<ROTATION, L>(elliptic, &thetas);
        let angle = Loose::from(arctangent(opposite, adjacent)).scale(L::splat(2.0)).over(f);
        let [numerator, denominator] = speed::<ROTATION, L>(elliptic, &thetas);
        let velocity = Loose::from(numerator).over(Loose::from(denominator));
        let velocity = if ROTATION { velocity } else { velocity.over(to_turning) };
        [angle.hi, angle.lo, velocity.hi, velocity.lo]
    }
}

impl<const ROTATION: bool> Kernel for Measure<'_, ROTATION> {
    type Output = ();
    #[inline(always)]
    fn run<L: Lane>(self) {
        let [hi, lo] = self.points;
        let count = hi.len();
        let [a, b, c, d] = self.values;
        let mut values = [&mut a[..count], &mut b[..count], &mut c[..count], &mut d[..count]];
        if self.elliptic.lattice.hyperbolic() {
            sweep::<L, _, _, _>(&Point::<ROTATION, true>(self.elliptic, self.bend), [hi, lo], &mut values)
        } else {
            sweep::<L, _, _, _>(&Point::<ROTATION, false>(self.elliptic, self.bend), [hi, lo], &mut values)
        }
    }
}
