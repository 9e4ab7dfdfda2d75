//! The four theta functions of a nome of their own in every lane, given by itself or by the parameter.
//!
//! z = j pi +- r, and angle = r or pi/2 - r, whichever is smaller. For q <= e^-pi cubics in sin^2; above, Jacobi's imaginary
//! transformation with L = pi^2/(-ln q) = -ln q': sqrt(L/pi) e^(-angle^2 L/pi^2) times the functions of q' of i y,
//! y = angle L/pi, where 2 q'^(1/4) sinh y is e^(y - L/4) (1 - e^-2y), so that the exponents are added first.
//! Source: as functions.rs; DLMF 20.7.30 to 20.7.33.

use super::functions::ThetaFunction;
use super::neville::excesses;
use crate::elliptic::agm::NearMean;
use crate::elliptic::given::Given;
use crate::elliptic::nome::{minus_log_short_nome, short_nome};
use crate::elliptic::parameter_lanes::{ParameterLanes, class};
use crate::elliptic::phase::alternating;
use crate::float::angle_reduction::{FAR, half_turns};
use crate::float::double_double::two_sum;
use crate::float::elementary::{exp, quotient, sin_cos, sinh_cosh};
use crate::float::logarithm::long_ln;
use crate::float::unnormalised::Unnormalised;
use crate::float::{Dd, HALF_PI, PI};
use crate::lanes::{Formula, Lane};

/// By what the nome is given.
#[derive(Clone, Copy)]
pub(super) enum Nome {
    Itself,
    Parameter(Given),
}

/// Below, the fourth root of a nome loses its error.
const TINY: f64 = 1e-200;
/// Up to here the series in q.
const SMALL: f64 = 0.0432;

/// The class of a nome, as of parameters.
pub(super) struct ClassifyNome;

impl Formula<1, 1> for ClassifyNome {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [q]: [L; 1]) -> [L; 1] {
        let code = |class: usize| L::splat(class as f64);
        let size = q.abs();
        let found = L::select(size.less(L::splat(SMALL)), code(class::CIRCULAR), code(class::HYPERBOLIC));
        [L::select(size.less(L::splat(1.0)), found, code(class::FALLBACK))]
    }
}

/// Where a hyperbolic angle makes no more difference, for nomes whose own angle is beyond four times that.
const FAR_ANGLE: f64 = 175.0;
/// Where exponents leave the range, and where nothing is left of their powers.
const LEAST_EXPONENT: f64 = 690.0;
const NOTHING: f64 = 770.0;

/// A theta function of (z, nome or parameter).
pub(super) struct ThetaLanes<const HYPERBOLIC: bool>(pub Nome, pub ThetaFunction);

/// q for CIRCULAR or -ln q' and q', and whether the given nome is negative.
struct NomeLanes<L: Lane> {
    q: Dd<L>,
    log: Dd<L>,
    negative: L::Mask,
    /// NaN where there is no function, else 0.
    outside: L,
}

impl Nome {
    #[inline(always)]
    fn at<L: Lane, const HYPERBOLIC: bool>(self, value: L) -> NomeLanes<L> {
        let (zero, nan) = (L::splat(0.0), L::splat(f64::NAN));
        let none = Dd::from_double(zero);
        match self {
            Nome::Itself => {
                let size = value.abs();
                let negative = value.less(zero);
                if !HYPERBOLIC {
                    return NomeLanes { q: Dd::from_double(size), log: none, negative, outside: zero };
                }
                let log = -long_ln(Dd::from_double(size));
                let square = Unnormalised::splat(PI) * Unnormalised::splat(PI);
                let log = square.over(Unnormalised::from(log)).tight();
                let bound = L::splat(4.0 * FAR_ANGLE);
                let bounded = Dd::select(log.hi.less(bound), log, Dd::from_double(bound));
                NomeLanes { q: exp(-bounded), log, negative, outside: zero }
            }
            Nome::Parameter(given) => {
                let ParameterLanes { m, mc, negative, above, .. } = ParameterLanes::new(given, value);
                let outside = L::select(above, nan, zero);
                let (square, rest) = if HYPERBOLIC { (m, mc) } else { (mc, m) };
                let NearMean { lambda, .. } = NearMean::new(square, rest, L::splat(1.0));
                let log = if HYPERBOLIC { minus_log_short_nome(lambda).tight() } else { none };
                NomeLanes { q: short_nome(lambda), log, negative, outside }
            }
        }
    }
}

impl<const HYPERBOLIC: bool> Formula<2, 1> for ThetaLanes<HYPERBOLIC> {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [z, value]: [L; 2]) -> [L; 1] {
        use ThetaFunction::{Four, One, Two};
        let (zero, one, half) = (L::splat(0.0), L::splat(1.0), L::splat(0.5));
        let nome = self.0.at::<L, HYPERBOLIC>(value);
        let (j, rest) = half_turns(z);
        let side = one.copysign(rest.hi);
        let rest = rest.scale(side);
        let (other, error) = two_sum(L::splat(HALF_PI.hi), -rest.hi);
        let other = Dd::sum(other, error + (L::splat(HALF_PI.lo) - rest.lo));
        let folded = other.hi.less(rest.hi);
        let (angle, other) = (Dd::select(folded, other, rest), Dd::select(folded, rest, other));
        let vanishing = matches!(self.1, One | Two);
        let (folded, negative) = (L::select(folded, one, zero), L::select(nome.negative, one, zero));
        // theta1 and theta2, or theta3 and theta4, change places by folding; the latter where q < 0, too.
        let second = if vanishing { folded } else { (folded - negative).abs() };
        let second = if matches!(self.1, Two | Four) { one - second } else { second };
        let second = half.less(second);
        let size = if HYPERBOLIC {
            nome.by_exponents(angle, other, vanishing, second)
        } else {
            nome.by_sines(angle, vanishing, second)
        };
        let sign = match self.1 {
            One => alternating(j) * side,
            Two => alternating(j),
            _ => one,
        };
        let outside =
            if vanishing { L::select(nome.negative, L::splat(f64::NAN), nome.outside) } else { nome.outside };
        [L::select(z.abs().less(L::splat(FAR)), size * sign + outside, L::splat(f64::NAN))]
    }
}

impl<L: Lane> NomeLanes<L> {
    /// theta1, theta3 or, where `second`, theta2, theta4 of an angle in [0, pi/4].
    #[inline(always)]
    fn by_sines(&self, angle: Dd<L>, vanishing: bool, second: L::Mask) -> L {
        let (sine, cosine) = sin_cos(angle);
        let [t1, t2, t3, t4] = excesses(self.q.hi, sine.hi * sine.hi);
        if vanishing {
            let root = Unnormalised::from(self.q).root().root();
            let inside = L::splat(TINY).less(self.q.hi);
            let root = Unnormalised::new(L::select(inside, root.hi, L::splat(f64::NAN)), root.lo);
            let trigonometric = Dd::select(second, cosine, sine);
            let size = Unnormalised::from(trigonometric.nudge(L::select(second, t2, t1))) * root;
            (size.hi + size.lo) * L::splat(2.0)
        } else {
            L::splat(1.0) + L::select(second, t4, t3)
        }
    }

    /// The same from q'.
    #[inline(always)]
    fn by_exponents(&self, angle: Dd<L>, other: Dd<L>, vanishing: bool, second: L::Mask) -> L {
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let inverse_pi = Unnormalised::splat(INVERSE_PI);
        let scaled = Unnormalised::from(self.log) * inverse_pi;
        let y = (Unnormalised::from(angle) * scaled).tight();
        let y = Dd::select(y.hi.less(L::splat(FAR_ANGLE)), y, Dd::from_double(L::splat(FAR_ANGLE)));
        let (sine, cosine) = sinh_cosh(y);
        let [t1, t2, t3, t4] = excesses(self.q.hi, -(sine.hi * sine.hi));
        // The one with e^-L/4 is theta1 of the first pair and theta4 of the second, as theta2 of q'.
        let (falling, excess) = if vanishing {
            (L::select(second, zero, one), L::select(second, t4, t1))
        } else {
            (L::select(second, one, zero), L::select(second, t2, t3))
        };
        let falling = L::splat(0.5).less(falling);
        let distance = Unnormalised::from(Dd::select(falling, other, angle));
        let exponent = (distance.square() * scaled * inverse_pi).tight();
        let inside = exponent.hi.less(L::splat(LEAST_EXPONENT));
        let power = exp(-Dd::select(inside, exponent, Dd::from_double(zero)));
        let numerator = if vanishing { sine } else { cosine };
        // (1 -+ e^-2y)/2
        let part = quotient(numerator, cosine.plus_smaller(sine)).scale(L::splat(2.0));
        let part = Dd::select(falling, part, Dd::from_double(one));
        let size = Unnormalised::from(part.nudge(excess)) * scaled.root() * Unnormalised::from(power);
        let beyond = L::select(L::splat(NOTHING).less(exponent.hi), zero, L::splat(f64::NAN));
        L::select(inside, size.hi + size.lo, beyond)
    }
}

/// 1/pi.
const INVERSE_PI: Dd = Dd::new(0.3183098861837907, -1.9678676675182486e-17);
