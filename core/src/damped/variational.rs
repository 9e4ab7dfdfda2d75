//! How angle and velocity change with the start and with every constant: the variational equations as Taylor series.
//!
//! For a column y = d/dp of (theta, v, u), with the letters of equation.rs and side = sgn v:
//!   theta_p' = v_p,
//!   v_p' = -omega2 c theta_p - linear v_p - 2 quadratic |v| v_p + dry side u_p + (the equation's own derivative by p),
//!   u_p' = -side (v u_p + u v_p)/presliding + (for p = presliding) side v u/presliding^2.
//! Where the velocity changes its sign the acceleration jumps from a to b if friction is dry without presliding. The column is
//! continuous in theta_p; the time of the turn moves by -v_p/a, so v_p is multiplied by b/a (the
//! saltation matrix). Where friction takes hold v_p becomes 0; where it lets go nothing jumps,
//! because the acceleration is 0 there.

use super::equation::Equation;
use super::jet::Piece;
use super::motion_series::{LAST, MotionSeries, Short};
use super::segment::{Event, Segment};
use super::taylor::INVERSE;
use super::torque::TORQUES;
use crate::float::Dd;
use crate::lanes::{Kernel, Lane, four};

/// What the derivatives are by, in this order.
pub const PARAMETERS: [&str; 11] = [
    "theta0", "velocity0", "omega2", "linear", "quadratic", "dry", "presliding", "constant", "amplitude",
    "frequency", "phase",
];
const OMEGA2: usize = 2;
const LINEAR: usize = 3;
const QUADRATIC: usize = 4;
const DRY: usize = 5;
const PRESLIDING: usize = 6;
const CONSTANT: usize = 7;
const AMPLITUDE: usize = 8;
const FREQUENCY: usize = 9;
const PHASE: usize = 10;

/// The columns, and one that is not used: lanes come in fours.
pub(super) const WIDTH: usize = 12;
/// Columns of a lane.
pub(super) const LANE: usize = 4;
/// How many lanes hold a row.
pub(super) const LANES: usize = WIDTH / LANE;

type Row = [f64; WIDTH];

/// The derivatives of angle, velocity and u at one time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Columns {
    pub theta: Row,
    pub velocity: Row,
    pub slip: Row,
}

/// Their Taylor coefficients.
pub(super) struct ColumnJet {
    theta: [Row; LAST + 1],
    velocity: [Row; LAST + 1],
    /// Zero where presliding does not act, as `slips` says.
    slip: [Row; LAST + 1],
    slips: bool,
}

impl Columns {
    /// At t = 0, in the unit of time of the equation.
    pub fn start(equation: &Equation) -> Columns {
        let zero = [0.0; WIDTH];
        let (mut theta, mut velocity) = (zero, zero);
        (theta[0], velocity[1]) = (1.0, 1.0);
        if equation.presliding == 0.0 {
            // Friction that changes sign at once has no derivative by the angle over which it does not.
            theta[PRESLIDING] = f64::NAN;
        }
        Columns { theta, velocity, slip: zero }
    }

    /// After the beginning of a segment, from what they were at the end of the one before.
    pub fn begun(mut self, equation: &Equation, before: &Segment, segment: &Segment) -> Columns {
        match segment.event {
            Event::Turn => {
                if equation.dry != 0.0 && equation.presliding == 0.0 {
                    let jump = segment.acceleration(0.0) / before.acceleration(before.length);
                    self.velocity = self.velocity.map(|v| v * jump);
                }
                self.slip = self.slip.map(|u| -u);
            }
            Event::Stop => {
                let undefined = self.theta[PRESLIDING];
                self.velocity = [0.0; WIDTH];
                self.velocity[PRESLIDING] = 0.0 * undefined;
            }
            Event::Start | Event::Step | Event::Release => {}
        }
        self
    }
}

/// What derivatives of angle and velocity are multiplied by to have them in SI units.
#[derive(Clone, Copy, Debug)]
pub(super) struct SiFactors([Row; 2]);

impl SiFactors {
    pub fn new(equation: &Equation) -> SiFactors {
        let unit = crate::float::exponent::exp2(-equation.power);
        let square = unit * unit;
        let turned = equation.sense * unit;
        let factors = [1.0, turned, square, unit, 1.0, square, 1.0, square, square, turned, 1.0];
        let speed = equation.sense / unit;
        let mut both = [[0.0; WIDTH]; 2];
        for (i, factor) in factors.into_iter().enumerate() {
            (both[0][i], both[1][i]) = (factor, factor * speed);
        }
        SiFactors(both)
    }

    /// Derivatives of angle and velocity in SI units.
    pub fn of(&self, motion: [Row; 2]) -> [[f64; PARAMETERS.len()]; 2] {
        let mut both = [[0.0; PARAMETERS.len()]; 2];
        for ((both, row), factors) in both.iter_mut().zip(motion).zip(&self.0) {
            for ((value, derivative), factor) in both.iter_mut().zip(row).zip(factors) {
                *value = derivative * factor;
            }
        }
        both
    }
}

impl ColumnJet {
    pub const ZERO: ColumnJet = ColumnJet {
        theta: [[0.0; WIDTH]; LAST + 1],
        velocity: [[0.0; WIDTH]; LAST + 1],
        slip: [[0.0; WIDTH]; LAST + 1],
        slips: false,
    };

    /// On a segment that moves, from its start: the columns of so many lanes. The others keep what they were.
    pub fn fill(&mut self, lanes: usize, equation: &Equation, segment: &Segment, start: &Columns) {
        let settled = equation.presliding == 0.0 || segment.slip == 0.0;
        match lanes {
            1 if equation.quadratic == 0.0 && settled => self.filled::<1>(equation, segment, start),
            LANES if TORQUES => self.filled::<LANES>(equation, segment, start),
            _ => self.filled::<2>(equation, segment, start),
        }
    }

    fn filled<const N: usize>(&mut self, equation: &Equation, segment: &Segment, start: &Columns) {
        let settled = equation.presliding == 0.0 || segment.slip == 0.0;
        let piece = equation.piece_of(segment.side, settled);
        // Of the last lane alone.
        let sinusoid = if N == LANES { sinusoids(equation, segment.start) } else { [[0.0; LAST]; 3] };
        let signs = equation.sense * segment.side;
        four(ColumnRecurrence::<N> {
            jet: self,
            piece: &piece,
            presliding: equation.presliding,
            sinusoid: &sinusoid,
            sense: equation.sense,
            signs,
            segment,
            start,
        });
    }

    /// The derivatives a time since the start.
    pub fn at(&self, lanes: usize, since: f64) -> Columns {
        let [theta, velocity] = self.motion(lanes, since);
        let slip = if self.slips { sums(lanes, [&self.slip], since)[0] } else { self.slip[0] };
        Columns { theta, velocity, slip }
    }

    /// Those of angle and velocity.
    pub fn motion(&self, lanes: usize, since: f64) -> [Row; 2] {
        sums(lanes, [&self.theta, &self.velocity], since)
    }
}

fn sums<const ROWS: usize>(lanes: usize, rows: [&[Row; LAST + 1]; ROWS], since: f64) -> [Row; ROWS] {
    match lanes {
        1 => four(ColumnSum::<1, ROWS> { rows, since }),
        LANES if TORQUES => four(ColumnSum::<LANES, ROWS> { rows, since }),
        _ => four(ColumnSum::<2, ROWS> { rows, since }),
    }
}

/// Coefficients of what the torque changes by with the amplitude, the frequency and the phase of its sinusoid.
fn sinusoids(equation: &Equation, time: Dd) -> [[f64; LAST]; 3] {
    let (sine, cosine) = equation.sinusoid(time);
    let turns = [cosine.value(), -sine.value(), -cosine.value(), sine.value()];
    let mut all = [[0.0; LAST]; 3];
    let mut factor = 1.0;
    for k in 0..LAST {
        all[0][k] = turns[k % 4] * factor;
        // -A sin(phase), whose derivatives are a quarter of a turn ahead of those of the cosine.
        all[2][k] = equation.amplitude * turns[(k + 1) % 4] * factor;
        factor *= equation.frequency * INVERSE[k + 1].hi;
    }
    for k in 0..LAST {
        all[1][k] = time.value() * all[2][k] + if k > 0 { all[2][k - 1] } else { 0.0 };
    }
    all
}

/// Of the columns of N lanes. One lane is for a motion without drag and presliding.
struct ColumnRecurrence<'a, const N: usize> {
    jet: &'a mut ColumnJet,
    piece: &'a Piece,
    presliding: f64,
    sinusoid: &'a [[f64; LAST]; 3],
    sense: f64,
    /// Sense times side.
    signs: f64,
    segment: &'a Segment,
    start: &'a Columns,
}

/// Coefficient k of the product of a series with every column, for k = 0, 1, 2, ... in this order. Those of two orders are formed in
/// one pass, the terms in the same order as in two: what is `begun` for the next order lacks its last row alone, which is not yet known.
#[inline(always)]
fn products<L: Lane, const N: usize>(
    series: &Short,
    columns: &[Row; LAST + 1],
    k: usize,
    begun: &mut [L; N],
) -> [L; N] {
    if !k.is_multiple_of(2) {
        return with::<L, N>(*begun, series[0], &columns[k]);
    }
    let mut sums = [L::splat(0.0); N];
    let mut next = sums;
    let factors = series[..=k].iter().rev().zip(series[1..=k + 1].iter().rev());
    for ((factor, after), row) in factors.zip(&columns[..=k]) {
        sums = with::<L, N>(sums, *factor, row);
        next = with::<L, N>(next, *after, row);
    }
    *begun = next;
    sums
}

/// Sums with one more term each.
#[inline(always)]
fn with<L: Lane, const N: usize>(mut sums: [L; N], factor: f64, row: &Row) -> [L; N] {
    let factor = L::splat(factor);
    let mut i = 0;
    while i < N {
        sums[i] = L::load_at(row, LANE * i).mul_add(factor, sums[i]);
        i += 1;
    }
    sums
}

impl<const N: usize> Kernel for ColumnRecurrence<'_, N> {
    type Output = ();
    type Place = ColumnJet;
    #[inline(always)]
    fn run<L: Lane>(self) {
        let ColumnRecurrence { jet, piece, presliding, sinusoid, sense, signs, segment, start } = self;
        let MotionSeries { v, s, c, u, square, slipping } = MotionSeries::new::<L, N>(segment, piece.slip);
        let ColumnJet { theta, velocity, slip: slips, slips: slides } = jet;
        (theta[0], velocity[0], slips[0]) = (start.theta, start.velocity, start.slip);
        *slides = piece.slip != 0.0;
        let (omega2, linear) = (L::splat(piece.omega2.hi), L::splat(piece.linear));
        let (dry, drag) = (L::splat(piece.dry), L::splat(2.0 * piece.quadratic));
        let slip = L::splat(piece.slip);
        let by_presliding = if piece.slip == 0.0 { 0.0 } else { piece.slip / presliding };
        let (mut pull_begun, mut drag_begun) = ([L::splat(0.0); N], [L::splat(0.0); N]);
        let (mut own_begun, mut moved_begun) = (pull_begun, pull_begun);
        let mut k = 0;
        while k < LAST {
            let first = if k == 0 { 1.0 } else { 0.0 };
            let mut own = [0.0; WIDTH];
            own[OMEGA2] = -s[k];
            own[LINEAR] = -(2.0 * sense * v[k]);
            own[QUADRATIC] = -(signs * square[k]);
            own[DRY] = signs * (u[k] - first);
            own[CONSTANT] = first;
            own[AMPLITUDE] = sinusoid[0][k];
            own[FREQUENCY] = sinusoid[1][k];
            own[PHASE] = sinusoid[2][k];
            let mut force = [L::splat(0.0); N];
            let mut i = 0;
            while i < N {
                force[i] = L::load_at(&own, LANE * i);
                i += 1;
            }
            if N > 1 && piece.quadratic != 0.0 {
                let dragged = products::<L, N>(&v, velocity, k, &mut drag_begun);
                let mut i = 0;
                while i < N {
                    force[i] = force[i] - drag * dragged[i];
                    i += 1;
                }
            }
            let inverse = L::splat(INVERSE[k + 1].hi);
            if N > 1 && piece.slip != 0.0 {
                let (own, moved) = (
                    products::<L, N>(&v, slips, k, &mut own_begun),
                    products::<L, N>(&u, velocity, k, &mut moved_begun),
                );
                let mut i = 0;
                while i < N {
                    force[i] = dry.mul_add(L::load_at(&slips[k], LANE * i), force[i]);
                    (-(slip * (own[i] + moved[i]) * inverse)).store_at(&mut slips[k + 1], LANE * i);
                    i += 1;
                }
                slips[k + 1][PRESLIDING] += by_presliding * slipping[k] * INVERSE[k + 1].hi;
            }
            let pull = products::<L, N>(&c, theta, k, &mut pull_begun);
            let mut i = 0;
            while i < N {
                let now = L::load_at(&velocity[k], LANE * i);
                let rest = force[i] - linear * now;
                (now * inverse).store_at(&mut theta[k + 1], LANE * i);
                ((rest - omega2 * pull[i]) * inverse).store_at(&mut velocity[k + 1], LANE * i);
                i += 1;
            }
            k += 1;
        }
    }
}

struct ColumnSum<'a, const N: usize, const ROWS: usize> {
    rows: [&'a [Row; LAST + 1]; ROWS],
    since: f64,
}

impl<const N: usize, const ROWS: usize> Kernel for ColumnSum<'_, N, ROWS> {
    type Output = [Row; ROWS];
    type Place = ColumnJet;
    #[inline(always)]
    fn run<L: Lane>(self) -> [Row; ROWS] {
        let t = L::splat(self.since);
        let mut sums = [[L::splat(0.0); N]; ROWS];
        let mut k = LAST + 1;
        while k > 0 {
            k -= 1;
            let mut n = 0;
            while n < ROWS {
                let mut i = 0;
                while i < N {
                    sums[n][i] = sums[n][i].mul_add(t, L::load_at(&self.rows[n][k], LANE * i));
                    i += 1;
                }
                n += 1;
            }
        }
        let mut values = [[0.0; WIDTH]; ROWS];
        let mut n = 0;
        while n < ROWS {
            let mut i = 0;
            while i < N {
                sums[n][i].store_at(&mut values[n], LANE * i);
                i += 1;
            }
            n += 1;
        }
        values
    }
}
