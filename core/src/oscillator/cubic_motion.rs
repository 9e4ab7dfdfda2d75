//! u and u' of an orbit at any time, over lanes.
//!
//! Elliptic motions are quotients of theta functions at the reduced phase. With t1 (without its factor A) to t4:
//!
//! | motion | u | u' | swaps |
//! |---|---|---|---|
//! | A k' sd | t1/t3 | t2 t4/t3^2 | counted from K, t1 with t2 and t3 with t4 |
//! | A sn | t1/t4 | t2 t3/t4^2 | |
//! | A dn | t3/t4 | t1 t2/t4^2 | |
//! | A nc | t4/t2 | t1 t3/t2^2 | |
//! | A dc | t3/t2 | t1 t4/t2^2 | |
//! | A sc | t1/t2 | t3 t4/t2^2 | |
//! | A sn dn/cn | t1 t3/(t2 t4) | (t3^4 + m k'^2 A^4 t1^4)/(t2 t4)^2 | |
//!
//! Where polynomials serve (cubic_arc.rs) these are their values at some points, and not taken for each sample.
//! An escape counts its phase from the pole or from the middle, whichever is next to the start: beyond the poles NaN.
//! Source: DLMF 20.2, 22.2, 22.13(i).

use super::cubic_course::{Course, Elliptic, Shape};
use super::cubic_plain::{Plainly, Straight};
use super::duffing::Duffing;
use crate::elliptic::phase::{LAST_HALF_PERIOD, alternating};
use crate::float::Dd;
use crate::float::elementary::quotient;
use crate::lanes::{Formula, Lane, tabulate};
use crate::motion::bounded::{Swinging, begun};
use crate::motion::escape::Flying;
use crate::motion::samples::Way;

/// What an evaluation returns first; where it returns no more, the rest is not computed.
const U: bool = true;
const VELOCITY: bool = false;

/// Theta functions at a reduced phase, t1 with t2 and t3 with t4 exchanged where the argument is counted from K; and
/// whether it is.
#[inline(always)]
fn thetas<const HYPERBOLIC: bool, L: Lane>(e: &Elliptic, size: Dd<L>) -> ([Dd<L>; 4], L::Mask) {
    let thetas = e.lattice.thetas_on::<HYPERBOLIC, L>(size);
    let [t1, t2, t3, t4] = thetas.theta;
    let folded = thetas.folded;
    // From a pole, what is near 0 is near K of the functions.
    let [t1, t2, t3, t4] = if e.from_pole { [t2, t1, t4, t3] } else { [t1, t2, t3, t4] };
    let picked = [
        Dd::select(folded, t2, t1),
        Dd::select(folded, t1, t2),
        Dd::select(folded, t4, t3),
        Dd::select(folded, t3, t4),
    ];
    (picked, folded)
}

#[inline(always)]
fn pick<L: Lane>(folded: L::Mask, pair: &[Dd; 2]) -> Dd<L> {
    Dd::select(folded, Dd::splat(pair[1]), Dd::splat(pair[0]))
}

/// u = above/below and u' = left right/below^2, but for their factors.
#[inline(always)]
fn letters<L: Lane>(shape: Shape, [t1, t2, t3, t4]: [Dd<L>; 4]) -> [Dd<L>; 4] {
    match shape {
        Shape::Cn => [t1, t3, t2, t4],
        Shape::Sn => [t1, t4, t2, t3],
        Shape::Dn => [t3, t4, t1, t2],
        Shape::Nc => [t4, t2, t1, t3],
        Shape::Dc => [t3, t2, t1, t4],
        Shape::Sc | Shape::SdOverC => [t1, t2, t3, t4],
    }
}

/// Numerators and denominators of u and u', but for their signs.
#[inline(always)]
pub(super) fn quotients<const HYPERBOLIC: bool, L: Lane>(e: &Elliptic, size: Dd<L>) -> [[Dd<L>; 2]; 2] {
    let (thetas, folded) = thetas::<HYPERBOLIC, L>(e, size);
    let (u_factor, factor) = (pick::<L>(folded, &e.u), pick::<L>(folded, &e.velocity));
    if e.shape == Shape::SdOverC {
        let [t1, t2, t3, t4] = thetas;
        let (above, below) = (t1 * t3, t2 * t4);
        let dn = quotient(t3.square() * factor, below);
        let sn = quotient(t1.square() * pick::<L>(folded, &e.other), below);
        let rising = dn.square().plain_sum(sn.square()) * Dd::splat(e.slope);
        return [[above * u_factor, below], [rising, Dd::from_double(L::splat(1.0))]];
    }
    let [above, below, left, right] = letters(e.shape, thetas);
    [[above * u_factor, below], [left * right * factor, below.square()]]
}

/// a b but for the product of the low words, as hi + lo not normalised.
#[inline(always)]
fn product<L: Lane>(a: Dd<L>, b: Dd<L>) -> Dd<L> {
    let (hi, error) = a.hi.two_product(b.hi);
    Dd::new(hi, a.hi.mul_add(b.lo, a.lo.mul_add(b.hi, error)))
}

/// u and u' of a bounded orbit, but for their signs: one division for both.
#[inline(always)]
fn bounded<const HYPERBOLIC: bool, L: Lane>(e: &Elliptic, size: Dd<L>) -> [L; 2] {
    let (thetas, folded) = thetas::<HYPERBOLIC, L>(e, size);
    let [above, below, left, right] = letters(e.shape, thetas);
    let inverse = L::splat(1.0) / below.hi;
    let (back, error) = inverse.two_product(below.hi);
    // What the inverse lacks of itself.
    let rest = ((L::splat(1.0) - back) - error) - inverse * below.lo;
    let inverse = Dd::new(inverse, inverse * rest);
    let u = product(product(above, pick::<L>(folded, &e.u)), inverse);
    let left_right = product(product(left, inverse), product(right, inverse));
    let velocity = product(left_right, pick::<L>(folded, &e.velocity));
    [u.value(), velocity.value()]
}

/// A libration or a well on one side of the theta functions.
struct Bounded<'a, const HYPERBOLIC: bool, const FIRST: bool>(&'a Duffing, &'a Elliptic);

/// An escape, likewise.
struct Escape<'a, const HYPERBOLIC: bool, const FIRST: bool>(&'a Duffing, &'a Elliptic);

/// The start as it was given, at t = 0; what is wanted first.
#[inline(always)]
pub(super) fn finished<const FIRST: bool, L: Lane>(orbit: &Duffing, t: L, u: L, velocity: L) -> [L; 2] {
    begun::<FIRST, L>([orbit.u0, orbit.velocity0], t, [u, velocity])
}

impl<const HYPERBOLIC: bool, const FIRST: bool> Formula<1, 2> for Bounded<'_, HYPERBOLIC, FIRST> {
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let Bounded(orbit, e) = self;
        let scaled = t * L::splat(e.scales.time);
        let (n, f) = e.phase.spread::<L>().count(scaled, LAST_HALF_PERIOD);
        let sign = L::splat(1.0).copysign(f.hi);
        let [u, velocity] = bounded::<HYPERBOLIC, L>(e, f.scale(sign));
        let (u_sign, velocity_sign) = if e.shape == Shape::Dn {
            (L::splat(1.0), sign)
        } else {
            let parity = alternating(n);
            (sign * parity, parity)
        };
        let u = u * (u_sign * L::splat(e.scales.u));
        let velocity = velocity * (velocity_sign * L::splat(e.scales.velocity));
        finished::<FIRST, L>(orbit, t, u, velocity)
    }
}

impl<const HYPERBOLIC: bool, const FIRST: bool> Formula<1, 2> for Escape<'_, HYPERBOLIC, FIRST> {
    #[inline(always)]
    fn at<L: Lane>(&self, [t]: [L; 1]) -> [L; 2] {
        let Escape(orbit, e) = self;
        let f = e.phase.counted(t * L::splat(e.scales.time));
        let half = L::splat(0.5);
        // From the middle to both poles, or from one pole to the other: how far from the nearest end.
        let (sign, size, left) = if e.from_pole {
            let far = half.less(f.hi);
            let rest = Dd::sum(L::splat(1.0), -f.hi).plain_sum(Dd::new(-f.lo, L::splat(0.0)));
            let size = Dd::select(far, rest, f);
            (L::select(far, L::splat(-1.0), L::splat(1.0)), size, size.hi)
        } else {
            let sign = L::splat(1.0).copysign(f.hi);
            let size = f.scale(sign);
            (sign, size, (half - size.hi) - size.lo)
        };
        // False for NaN as well.
        let inside = L::splat(0.0).less(left);
        let size = Dd::select(inside, size, Dd::from_double(L::splat(0.25)));
        let [[above, below], [rising, square]] = quotients::<HYPERBOLIC, L>(e, size);
        let one = L::splat(1.0);
        let even = matches!(e.shape, Shape::Nc | Shape::Dc);
        let (u_sign, velocity_sign) = if even { (one, sign) } else { (sign, one) };
        let u = quotient(above, below).value() * (u_sign * L::splat(e.scales.u));
        let velocity = quotient(rising, square).value() * (velocity_sign * L::splat(e.scales.velocity));
        let nan = L::splat(f64::NAN);
        finished::<FIRST, L>(orbit, t, L::select(inside, u, nan), L::select(inside, velocity, nan))
    }
}

/// Times into slices of the R results wanted, each of the length of the times.
struct Fill<'a, 'b, const FIRST: bool, const R: usize> {
    orbit: &'a Duffing,
    t: &'a [f64],
    results: [&'b mut [f64]; R],
}

impl<const FIRST: bool, const R: usize> Fill<'_, '_, FIRST, R> {
    fn run<const WIDE: bool>(mut self) {
        let (orbit, t, results) = (self.orbit, [self.t], &mut self.results);
        match &orbit.course {
            Course::Elliptic(e) => {
                let start = [orbit.u0, orbit.velocity0];
                if let Some(arc) = e.arc() {
                    return match &e.drawing.way {
                        Way::Swing(swing) => {
                            tabulate::<WIDE, _, _, _, _>(&Swinging::<FIRST> { swing, arc, start }, t, results)
                        }
                        Way::Flight(flight) => {
                            tabulate::<WIDE, _, _, _, _>(&Flying::<FIRST> { flight, arc, start }, t, results)
                        }
                    };
                }
                let bounded = matches!(e.shape, Shape::Cn | Shape::Sn | Shape::Dn);
                match (bounded, e.lattice.hyperbolic()) {
                    (true, true) => {
                        tabulate::<WIDE, _, _, _, _>(&Bounded::<true, FIRST>(orbit, e), t, results)
                    }
                    (true, false) => {
                        tabulate::<WIDE, _, _, _, _>(&Bounded::<false, FIRST>(orbit, e), t, results)
                    }
                    (false, true) => {
                        tabulate::<WIDE, _, _, _, _>(&Escape::<true, FIRST>(orbit, e), t, results)
                    }
                    (false, false) => {
                        tabulate::<WIDE, _, _, _, _>(&Escape::<false, FIRST>(orbit, e), t, results)
                    }
                }
            }
            Course::Simple(simple) => {
                tabulate::<WIDE, _, _, _, _>(&Plainly::<FIRST>(orbit, simple), t, results)
            }
            Course::Still | Course::Straight => {
                tabulate::<WIDE, _, _, _, _>(&Straight::<FIRST>(orbit), t, results)
            }
        }
    }
}

impl Duffing {
    fn fill<'a, 'b, const FIRST: bool, const R: usize>(
        &'a self,
        t: &'a [f64],
        results: [&'b mut [f64]; R],
    ) -> Fill<'a, 'b, FIRST, R> {
        assert!(
            results.iter().all(|result| result.len() == t.len()),
            "results of another length than the times"
        );
        Fill { orbit: self, t, results }
    }

    /// u at t.
    ///
    /// NaN at and beyond an escape, for times that are not finite (but for motions with a limit there), and more than
    /// 2^53 half periods away. **Error** at most 4 ulp of the largest |u| of a bounded orbit, of max(|u|, |u0|) else, plus
    /// 2^-100 of the condition.
    pub fn u(&self, t: f64) -> f64 {
        let mut u = [0.0];
        self.fill::<U, 1>(&[t], [&mut u]).run::<false>();
        u[0]
    }

    /// u' at t; domain and error as for [`Duffing::u`].
    pub fn velocity(&self, t: f64) -> f64 {
        let mut velocity = [0.0];
        self.fill::<VELOCITY, 1>(&[t], [&mut velocity]).run::<false>();
        velocity[0]
    }

    /// u and u' at t, bit for bit those of [`Duffing::u`] and [`Duffing::velocity`].
    pub fn motion(&self, t: f64) -> (f64, f64) {
        let (mut u, mut velocity) = ([0.0], [0.0]);
        self.fill::<U, 2>(&[t], [&mut u, &mut velocity]).run::<false>();
        (u[0], velocity[0])
    }

    /// [`Duffing::u`] of every time, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn u_into(&self, t: &[f64], u: &mut [f64]) {
        self.fill::<U, 1>(t, [u]).run::<true>();
    }

    /// [`Duffing::velocity`] of every time, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn velocity_into(&self, t: &[f64], velocity: &mut [f64]) {
        self.fill::<VELOCITY, 1>(t, [velocity]).run::<true>();
    }

    /// [`Duffing::motion`] of every time, bit for bit, on the widest lanes; panics where the lengths differ.
    pub fn motion_into(&self, t: &[f64], u: &mut [f64], velocity: &mut [f64]) {
        self.fill::<U, 2>(t, [u, velocity]).run::<true>();
    }
}
