//! The roots of f(v) = v (a v^2 + b v + c), and their distances from any point: the cubic of roots.rs without a quintic
//! force, where one root is 0 and the others need no angle and no cube root.
//!
//! With A = a v the other roots are (-b +- sqrt(b^2 - 4 a c))/2. The larger in size is a sum of equal signs, the other is a c
//! over it. The discriminant is exact (float/dyadic.rs).
//! Source: DLMF 1.11(iii).

use super::roots::{Distances, less};
use crate::float::dyadic::Dyadic;
use crate::float::scaled::Scaled;

/// Coefficients, exact, and the roots other than 0.
#[derive(Clone, Debug)]
pub(super) struct Quadratic {
    a: Dyadic,
    b: Dyadic,
    c: Dyadic,
    lead: Scaled,
    /// sqrt|b^2 - 4 a c|.
    root: Scaled,
    /// The other roots, where they are real.
    others: Option<Others>,
}

/// The real roots other than 0.
#[derive(Clone, Copy, Debug)]
struct Others {
    /// a v of both, the larger in size first.
    scaled: [Scaled; 2],
    /// All three roots v, falling; and which each is: 0, 1 for the larger in size, 2 for the smaller.
    falling: [Scaled; 3],
    order: [usize; 3],
}

impl Others {
    fn new(scaled: [Scaled; 2], a: Scaled) -> Others {
        let v = [Scaled::ZERO, scaled[0] / a, scaled[1] / a];
        let mut order = [0, 1, 2];
        for (i, j) in [(0, 1), (1, 2), (0, 1)] {
            if less(v[order[i]], v[order[j]]) {
                order.swap(i, j);
            }
        }
        Others { scaled, falling: order.map(|k| v[k]), order }
    }
}

impl Quadratic {
    /// For a != 0.
    pub fn new(a: Dyadic, b: Dyadic, c: Dyadic) -> Quadratic {
        let ac = &a * &c;
        let discriminant = b.square() - &ac * 4.0;
        let root = discriminant.to_scaled().abs().sqrt();
        let lead = a.to_scaled();
        let others = (discriminant.sign() >= 0).then(|| {
            let large = (b.to_scaled().abs() + root).shift(-1).signed(-f64::from(b.sign()));
            Others::new([large, if large.is_zero() { large } else { ac.to_scaled() / large }], lead)
        });
        Quadratic { lead, a, b, c, root, others }
    }

    /// Gaps between the roots, from the largest: 0 to 1, 1 to 2, 0 to 2. None where two are complex.
    pub fn gaps(&self) -> Option<[Scaled; 3]> {
        let Others { scaled: [large, small], order, .. } = self.others?;
        let gap = |i: usize, j: usize| match order[i] + order[j] {
            1 => large.abs(),
            2 => small.abs(),
            _ => self.root,
        };
        Some([gap(0, 1), gap(1, 2), gap(0, 2)].map(|gap| gap / self.lead.abs()))
    }

    /// For complex roots Re +- i w: -sign(a) Re and w.
    pub fn pair(&self) -> Option<[Scaled; 2]> {
        let twice = self.lead.abs().shift(1);
        self.others.is_none().then(|| [self.b.to_scaled() / twice, self.root / twice])
    }

    /// 1 - y root of each root, at y, where f(1/y) y^3 = `value`.
    pub fn of_square(&self, y: &Dyadic, value: &Dyadic) -> Distances {
        let product = value.to_scaled() / self.lead;
        let sum = (&self.a * 2.0 + &self.b * y).to_scaled() / self.lead;
        let Some(Others { scaled: [large, _], order, .. }) = self.others else {
            return Distances::One([Scaled::ONE, product, sum.shift(-1)]);
        };
        // Of the two distances, the one of the larger root less the other.
        let difference = -self.root.signed(large.sign()) / self.lead * y.to_scaled();
        let same = sum.is_negative() == difference.is_negative();
        let first = (sum + if same { difference } else { -difference }).shift(-1);
        let second = if first.is_zero() { first } else { product / first };
        let at = if same { [Scaled::ONE, first, second] } else { [Scaled::ONE, second, first] };
        Distances::Three(order.map(|k| at[k]))
    }

    /// The roots; of a pair the square of its modulus and the real part.
    pub fn roots(&self) -> Distances {
        match self.others {
            Some(Others { falling, .. }) => Distances::Three(falling),
            None => {
                let [half, _] = self.pair().unwrap_or([Scaled::ZERO; 2]);
                let real = -half.signed(self.lead.sign());
                Distances::One([Scaled::ZERO, self.c.to_scaled() / self.lead, real])
            }
        }
    }

    /// Of three real roots: whether all lie below v = 1/y, and f is positive above them.
    pub fn all_on_one_side(&self, y: &Dyadic) -> bool {
        let by = &self.b * y;
        let singles = &self.a * 3.0 + &by;
        let pairs = &self.a * 3.0 + by * 2.0 + &self.c * y.square();
        self.a.sign() > 0 && singles.sign() > 0 && pairs.sign() > 0
    }
}
