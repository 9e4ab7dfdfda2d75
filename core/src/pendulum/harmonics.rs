//! The angle of a libration as its own Fourier series, for amplitudes up to about 158 degrees.
//!
//! theta = sum b_n sin((2n - 1) z), b_n = 8 q^(n - 1/2) / ((2n - 1)(1 + q^(2n - 1))), z = pi u / 2K: the cn series of
//! the velocity integrated term by term (DLMF 22.11.2). One sine, no division, no arctangent. Summed by Clenshaw's
//! recurrence in 2 cos 2z, with the first term as a double-double lead and all others as a correction, at most 0.3 of
//! it for q <= 0.2: so the error stays near half an ulp, and relative at the zeros.

use crate::elliptic::nome::small_root_nome;
use crate::elliptic::theta::Lattice;
use crate::float::elementary::exp;
use crate::float::{Dd, HALF_PI, PI};
use crate::lanes::Lane;

/// Terms that can be kept: q^24/49 is below 2^-58 for the largest nome.
const MOST: usize = 24;
const LARGEST_NOME: f64 = 0.2;
const NEGLIGIBLE: f64 = 3.5e-18; // 2^-58

/// The amplitudes b_n of one orbit.
#[derive(Clone, Debug)]
pub(crate) struct Harmonics {
    first: Dd,
    /// b_2, b_3, ...
    others: [f64; MOST - 1],
    count: usize,
}

impl Harmonics {
    /// From the lattice and the modulus of the orbit (over 2^power), if its nome is small enough.
    pub fn new(lattice: &Lattice, k: Dd, power: i32) -> Option<Harmonics> {
        let root = if lattice.hyperbolic() {
            // q = exp(-pi K'/K), and the angle of this side is pi K/K'.
            exp((PI * HALF_PI / -lattice.angle).ldexp(-power))
        } else {
            small_root_nome(k, power, lattice.kc)
        };
        let nome = root.square().ldexp(2 * power);
        if nome.hi > LARGEST_NOME {
            return None;
        }
        let first = (root.scale(8.0) / (Dd::ONE + nome)).ldexp(power);
        let q = nome.hi;
        let (mut others, mut count) = ([0.0; MOST - 1], 0);
        let (mut falling, mut odd) = (1.0, q);
        for (i, b) in others.iter_mut().enumerate() {
            // b_n/b_1 = q^(n-1) (1 + q) / ((2n - 1)(1 + q^(2n-1)))
            falling *= q;
            odd *= q * q;
            let ratio = falling * (1.0 + q) / ((2 * i + 3) as f64 * (1.0 + odd));
            if ratio < NEGLIGIBLE {
                break;
            }
            *b = ratio * first.hi;
            count = i + 1;
        }
        Some(Harmonics { first, others, count })
    }

    /// The sum at s = sin z.
    #[inline(always)]
    pub fn at<L: Lane>(&self, sine: Dd<L>) -> Dd<L> {
        let x = sine.hi * sine.hi;
        let y = L::splat(-4.0).mul_add(x, L::splat(2.0));
        let (mut last, mut before) = (L::splat(0.0), L::splat(0.0));
        for b in self.others[..self.count].iter().rev() {
            let next = y.mul_add(last, L::splat(*b) - before);
            before = last;
            last = next;
        }
        let correction = y.mul_add(last, last - before);
        let (lead, error) = sine.hi.two_product(L::splat(self.first.hi));
        let rest = sine.hi.mul_add(correction + L::splat(self.first.lo), error);
        Dd::ordered_sum(lead, sine.lo.mul_add(L::splat(self.first.hi), rest))
    }
}
