//! The complete integrals over lanes, from the complement: Cody's form, P(y) + ln(1/y) Q(y) in y = mc.
//!
//! All terms of K, E and G have one sign, so nothing cancels, down to mc = 1e-308. For m < 0 from 1/mc, DLMF 19.7.5.
//! Coefficients: reference/coefficients.py, errors noted beside them. Source: Cody, Math. Comp. 19 (1965) 105.

use crate::float::elementary::horner;
use crate::float::logarithm::ln;
use crate::lanes::{Formula, Lane};

/// K = P + L Q, error 2^-59.
const K_P: [f64; 11] = [
    1.3862943611198906, 0.09657359028272494, 0.030885147904700278, 0.014938233197404515,
    0.008797247843009932, 0.0062569109194198684, 0.007092505245970241, 0.009963850310825976,
    0.007741320148818186, 0.0021287763848174585, 0.00012438343731454088,
];
const K_Q: [f64; 11] = [
    0.5, 0.12499999999968624, 0.07031249946774683, 0.04882799268989119, 0.03737545171552454,
    0.03008994605898005, 0.023735576155245283, 0.015109856376688074, 0.005645530325692148,
    0.0008433765241564237, 2.635071724361709e-05,
];
/// E = 1 + y (P + L Q), error 2^-58.
const E_P: [f64; 10] = [
    0.44314718056075086, 0.056805194345167336, 0.021831770346199743, 0.011567849797756867,
    0.007573597099731987, 0.007740963028229906, 0.010719236397332238, 0.008723145672625547,
    0.002531782868896517, 0.00015560667820560233,
];
const E_Q: [f64; 10] = [
    0.24999999999991646, 0.09374999975566646, 0.05859366999838093, 0.04271839784416815, 0.03348805973795995,
    0.026203352881268138, 0.0169430983104468, 0.006550730956788406, 0.0010203274927922815,
    3.325723709682316e-05,
];
/// B = (E - mc K)/m = P + y L Q, error 2^-61.
const B_P: [f64; 12] = [
    1.0, 0.05685281943987482, 0.017084421342887367, 0.008030442427709693, 0.004617389762745247,
    0.0023466947802667014, -0.006484250280822656, -0.04510025514700379, -0.10756375223662341,
    -0.104181656982831, -0.036821557186625775, -0.0033821325221288917,
];
const B_Q: [f64; 12] = [
    -0.24999999999998174, -0.28124999992568916, -0.29296871239738026, -0.29906752881553716,
    -0.3026076690034402, -0.3018123235155671, -0.27954599927022383, -0.20215641774191984,
    -0.08771010253449844, -0.016736845481388655, -0.0008296119917028227, 4.755400999281411e-06,
];
/// G = (1 - m B)/mc = P + L Q, error 2^-63.
const G_P: [f64; 11] = [
    0.9431471805599453, 0.03976839757014057, 0.009053774272178423, 0.003393113694647208,
    0.001626017937147921, 0.0009278113676282766, 0.0007153155724301955, 0.0007280260604651184,
    0.0005007619516608467, 0.00013201716907141052, 7.5838446847155345e-06,
];
const G_Q: [f64; 11] = [
    0.25, 0.031249999999983236, 0.011718749971104154, 0.006103508372249911, 0.003737930469668442,
    0.002512882674422359, 0.0017236835759533232, 0.0010017349417496908, 0.00035636601174097386,
    5.1957065076858606e-05, 1.6037453885276589e-06,
];

/// y in (0, 1] and ln(1/y), of which the four integrals are made.
#[derive(Clone, Copy)]
pub(crate) struct Complement<L> {
    y: L,
    log: L,
}

impl<L: Lane> Complement<L> {
    /// Of a normal y in (0, 1].
    #[inline(always)]
    pub fn new(y: L) -> Self {
        Complement { y, log: -ln(y) }
    }
    #[inline(always)]
    fn form<const N: usize>(self, p: &[f64; N], q: &[f64; N]) -> L {
        self.log.mul_add(horner(q, self.y), horner(p, self.y))
    }
    /// K.
    #[inline(always)]
    pub fn k(self) -> L {
        self.form(&K_P, &K_Q)
    }
    /// E.
    #[inline(always)]
    pub fn e(self) -> L {
        self.y.mul_add(self.e_beyond_one(), L::splat(1.0))
    }
    /// (E - 1)/mc.
    #[inline(always)]
    pub fn e_beyond_one(self) -> L {
        self.form(&E_P, &E_Q)
    }
    /// B = int_0^K cn^2.
    #[inline(always)]
    pub fn b(self) -> L {
        (self.y * self.log).mul_add(horner(&B_Q, self.y), horner(&B_P, self.y))
    }
    /// G = (1 - m B)/mc.
    #[inline(always)]
    pub fn g(self) -> L {
        self.form(&G_P, &G_Q)
    }
}

/// Where the range of the logarithm ends.
const LARGE: f64 = 8.9e307;

/// mc, in (0, 1] as it is and above as its inverse; NaN where the logarithm does not take it. With the flags of mc > 1.
#[inline(always)]
fn folded<L: Lane>(mc: L) -> (Complement<L>, L::Mask) {
    let one = L::splat(1.0);
    let negative = one.less(mc);
    let inside = L::splat(f64::MIN_POSITIVE * 0.999_999).less(mc);
    let inside =
        L::select(mc.less(L::splat(LARGE)), L::select(inside, mc, L::splat(f64::NAN)), L::splat(f64::NAN));
    let log = ln(inside).abs();
    (Complement { y: L::select(negative, one / inside, inside), log }, negative)
}

/// K of mc; NaN where mc is no positive normal number.
pub(crate) struct CompleteK;

impl Formula<4, 1> for CompleteK {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [_, _, mc, _]: [L; 4]) -> [L; 1] {
        let (complement, negative) = folded(mc);
        let k = complement.k();
        // One root for all: where none has m < 0 it is the root of 1.
        [L::select(negative, k * complement.y.sqrt(), k)]
    }
}

/// E of mc, likewise.
pub(crate) struct CompleteE;

impl Formula<4, 1> for CompleteE {
    type Place = Self;
    #[inline(always)]
    fn at<L: Lane>(&self, [_, _, mc, _]: [L; 4]) -> [L; 1] {
        let (complement, negative) = folded(mc);
        let e = complement.e();
        [L::select(negative, e * mc.sqrt(), e)]
    }
}
