//! Theta motions whose values lie too many powers of two apart for lanes: next to a separatrix, k' < 1e-135. In
//! double-doubles of any range, one sample after the other.
//!
//! There m = 1 to all digits, and each quarter period has its limit (DLMF 22.5(ii)): sn, cn, dn are tanh, sech, sech
//! next to 0, and 1, k' sinh, k' cosh of the distance next to K. The formulas are those of root_quotient.rs and
//! pq_quotient.rs.

use super::energy::{Orientation, Outline};
use super::nonzero_energy::{Argument, RootCase};
use super::pq_quotient::Pq;
use super::quotient_factors::QuotientFactors;
use super::root_quotient::Squares;
use crate::elliptic::phase::LAST_HALF_PERIOD;
use crate::float::scaled::Scaled;

/// k' below which lanes have no room, as its power of two: for n/sqrt M, and for a quotient without a root.
const LEAST: i32 = -450;
const LEAST_OF_PQ: i32 = -890;

/// A motion, set up once.
#[derive(Clone, Debug)]
pub(super) struct ScaledTheta {
    factors: QuotientFactors,
    mc: Scaled,
    kc: Scaled,
    /// 2K.
    half: Scaled,
    /// Argument at the start and per unit of time.
    base: [Scaled; 2],
    /// Argument from the start to the pole, and of the pole.
    poles: Option<[Scaled; 2]>,
    omega: Scaled,
    sign: f64,
}

/// sn, cn and dn.
#[derive(Clone, Copy)]
struct Values {
    sn: Scaled,
    cn: Scaled,
    dn: Scaled,
}

impl ScaledTheta {
    /// A motion with half period 2K, where lanes do not serve.
    pub fn new(
        factors: &QuotientFactors,
        half: Scaled,
        outline: &Outline,
        start: Argument,
        Orientation { sign, direction }: Orientation,
    ) -> Option<ScaledTheta> {
        let mc = factors.parameter()[1];
        let kc = mc.sqrt();
        let least = if matches!(factors, QuotientFactors::Pq(..)) { LEAST_OF_PQ } else { LEAST };
        (kc.power() < least).then(|| ScaledTheta {
            factors: factors.clone(),
            mc,
            kc,
            half,
            base: [start.base, outline.omega.signed(direction)],
            poles: outline.pole.map(|pole| [start.pole, pole]),
            omega: outline.omega.signed(direction),
            sign,
        })
    }

    /// At an argument in [0, 2K].
    fn values(&self, x: Scaled) -> Values {
        let quarter = self.half.shift(-1);
        let rest = quarter - x;
        let near = !(rest - x).is_negative();
        if near {
            let (sine, cosine) = x.sinh_cosh();
            let sech = Scaled::ONE / cosine;
            return Values { sn: sine * sech, cn: sech, dn: sech };
        }
        let beyond = rest.abs();
        if (beyond - quarter.shift(-1)).is_positive() {
            let Values { sn, cn, dn } = self.values(self.half - x);
            return Values { sn, cn: -cn, dn };
        }
        let (sine, cosine) = rest.sinh_cosh();
        Values { sn: Scaled::ONE, cn: self.kc * sine, dn: self.kc * cosine }
    }

    /// The argument from the base, its sign and (-1)^n; and the factor of M that the poles make. `None` beyond a pole and
    /// 2^53 half periods away.
    fn place(&self, t: f64) -> Option<(Scaled, f64, f64, Scaled)> {
        let x = self.base[0] + self.base[1] * t;
        let Some([ahead, pole]) = self.poles else {
            let count = (x / self.half).value().round();
            if count.is_nan() || count.abs() >= LAST_HALF_PERIOD {
                return None;
            }
            let rest = x - self.half * count;
            let parity = if count % 2.0 == 0.0 { 1.0 } else { -1.0 };
            return Some((rest.abs(), rest.sign(), parity, Scaled::ONE));
        };
        let ahead = ahead - self.base[1] * t;
        // From what is nearer, and so with the digits of the start.
        let x = if (ahead.abs() - x.abs()).is_negative() { pole - ahead } else { x };
        let behind = pole + x;
        if !(ahead.is_positive() && behind.is_positive()) {
            return None;
        }
        let [d, e] = [self.values(ahead), self.values(behind)];
        let pair = matches!(
            &self.factors,
            QuotientFactors::Root(Squares { case: RootCase::PairCrossing | RootCase::PairOutside, .. })
        );
        let product = if pair {
            // sn dn of both, over 1 - m sn^2 d sn^2 e as a sum.
            d.sn * d.dn * e.sn * e.dn / (d.cn.square() + (d.sn * e.dn).square())
        } else {
            d.sn * e.sn
        };
        Some((x.abs(), x.sign(), 1.0, product))
    }

    /// u and u' at t.
    pub fn at(&self, t: f64) -> (f64, f64) {
        let Some((x, sign, parity, product)) = self.place(t) else { return (f64::NAN, f64::NAN) };
        let Values { sn, cn, dn } = self.values(x);
        let (odd, u, velocity) = match &self.factors {
            QuotientFactors::Pq((pq, amplitude), [m, mc]) => {
                let [p, q, r, s] = pq.letters([sn, cn, dn, Scaled::ONE]);
                let slope = pq.slope(*m, *mc);
                let (u, slope) = if *pq == Pq::SnDnOverCn {
                    let rising = dn.square().square() + *m * self.mc * sn.square().square();
                    (sn * dn / cn, rising / cn.square())
                } else {
                    (p / q, slope * r * s / q.square())
                };
                (pq.odd(), *amplitude * u, *amplitude * self.omega * slope)
            }
            QuotientFactors::Root(Squares { case, m, mc, squares: [l, q], velocity }) => {
                let fourth = || dn.square().square() + *m * *mc * sn.square().square();
                // n and w; p^2, and q^2 with its factor.
                let (n, w, first, second) = match case {
                    RootCase::Crossing => (sn, cn * dn, cn, sn.square()),
                    RootCase::Inside => (dn, *mc * sn * cn, cn, *mc * sn.square()),
                    RootCase::Between => (Scaled::ONE, sn * cn * dn, cn, sn.square()),
                    RootCase::PairCrossing => (sn * dn, cn * fourth(), cn, (sn * dn).square()),
                    RootCase::PairOutside => (cn, sn * dn * fourth(), cn, (sn * dn).square()),
                    _ => (cn, *mc * sn * dn, cn, *mc * sn.square()),
                };
                let sum = (*l * first.square() + *q * second) * product;
                let root = sum.sqrt();
                let odd = matches!(case, RootCase::Crossing | RootCase::PairCrossing);
                (odd, n / root, velocity.signed(self.omega.sign()) * w / (root * sum))
            }
        };
        let (u_sign, velocity_sign) = if odd { (sign * parity, parity) } else { (1.0, sign) };
        (u.signed(u_sign * self.sign).value(), velocity.signed(velocity_sign * self.sign).value())
    }
}
