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
use super::segment::{Event, Segment};
use super::taylor::{INVERSE, ORDER};
use crate::float::Dd;
use crate::lanes::{Kernel, Lane, single};

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

type Row<L = f64> = [L; WIDTH];

/// The derivatives of angle, velocity and u at one time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Columns {
    pub theta: Row,
    pub velocity: Row,
    pub slip: Row,
}

/// Their Taylor coefficients.
pub(super) struct ColumnJet {
    theta: [Row; ORDER + 1],
    velocity: [Row; ORDER + 1],
    slip: [Row; ORDER + 1],
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

    /// In SI units.
    pub fn in_si(&self, equation: &Equation) -> [[f64; PARAMETERS.len()]; 2] {
        let unit = crate::float::exponent::exp2(-equation.power);
        let square = unit * unit;
        let turned = equation.sense * unit;
        let factors = [1.0, turned, square, unit, 1.0, square, 1.0, square, square, turned, 1.0];
        let speed = equation.sense / unit;
        let mut both = [[0.0; PARAMETERS.len()]; 2];
        for (i, factor) in factors.into_iter().enumerate() {
            both[0][i] = self.theta[i] * factor;
            both[1][i] = self.velocity[i] * factor * speed;
        }
        both
    }
}

impl ColumnJet {
    /// On a segment that moves, from its start.
    pub fn new(equation: &Equation, segment: &Segment, start: &Columns) -> ColumnJet {
        let settled = equation.presliding == 0.0 || segment.slip == 0.0;
        let piece = equation.piece_of(segment.side, settled);
        let sinusoid = sinusoids(equation, segment.start);
        let signs = equation.sense * segment.side;
        single(ColumnRecurrence {
            piece: &piece,
            presliding: equation.presliding,
            sinusoid: &sinusoid,
            sense: equation.sense,
            signs,
            segment,
            start,
        })
    }

    /// The derivatives a time since the start.
    pub fn at(&self, since: f64) -> Columns {
        single(ColumnSum { jet: self, since })
    }
}

/// Coefficients of what the torque changes by with the amplitude, the frequency and the phase of its sinusoid.
fn sinusoids(equation: &Equation, time: Dd) -> [[f64; ORDER]; 3] {
    let (sine, cosine) = equation.sinusoid(time);
    let turns = [cosine.value(), -sine.value(), -cosine.value(), sine.value()];
    let mut all = [[0.0; ORDER]; 3];
    let mut factor = 1.0;
    for k in 0..ORDER {
        all[0][k] = turns[k % 4] * factor;
        // -A sin(phase), whose derivatives are a quarter of a turn ahead of those of the cosine.
        all[2][k] = equation.amplitude * turns[(k + 1) % 4] * factor;
        factor *= equation.frequency * INVERSE[k + 1].hi;
    }
    for k in 0..ORDER {
        all[1][k] = time.value() * all[2][k] + if k > 0 { all[2][k - 1] } else { 0.0 };
    }
    all
}

struct ColumnRecurrence<'a> {
    piece: &'a Piece,
    presliding: f64,
    sinusoid: &'a [[f64; ORDER]; 3],
    sense: f64,
    /// Sense times side.
    signs: f64,
    segment: &'a Segment,
    start: &'a Columns,
}

/// Coefficient k of the product of a series with every column.
#[inline(always)]
fn products<L: Lane>(series: &[L; ORDER + 1], columns: &[Row<L>; ORDER + 1], k: usize) -> Row<L> {
    let mut sums = [L::splat(0.0); WIDTH];
    let mut j = 0;
    while j <= k {
        let mut i = 0;
        while i < WIDTH {
            sums[i] = columns[k - j][i].mul_add(series[j], sums[i]);
            i += 1;
        }
        j += 1;
    }
    sums
}

impl Kernel for ColumnRecurrence<'_> {
    type Output = ColumnJet;
    type Place = ColumnJet;
    #[inline(always)]
    fn run<L: Lane>(self) -> ColumnJet {
        let ColumnRecurrence { piece, presliding, sinusoid, sense, signs, segment, start } = self;
        let zero = L::splat(0.0);
        let none = [zero; ORDER + 1];
        let (mut v, mut s, mut c, mut u, mut square, mut slipping) = (none, none, none, none, none, none);
        let mut k = 0;
        while k <= ORDER {
            v[k] = L::splat(segment.slopes[k] * (k + 1) as f64);
            k += 1;
        }
        (s[0], c[0], u[0]) = (L::splat(segment.sine), L::splat(segment.cosine), L::splat(segment.slip));
        let slip = L::splat(piece.slip);
        let mut k = 0;
        while k < ORDER {
            let (mut rise, mut fall) = (zero, zero);
            let mut j = 0;
            while j <= k {
                rise = c[k - j].mul_add(v[j], rise);
                fall = s[k - j].mul_add(v[j], fall);
                square[k] = v[k - j].mul_add(v[j], square[k]);
                slipping[k] = u[k - j].mul_add(v[j], slipping[k]);
                j += 1;
            }
            let inverse = L::splat(INVERSE[k + 1].hi);
            s[k + 1] = rise * inverse;
            c[k + 1] = -(fall * inverse);
            u[k + 1] = -(slip * slipping[k] * inverse);
            k += 1;
        }
        let rows = [[zero; WIDTH]; ORDER + 1];
        let (mut theta, mut velocity, mut slips) = (rows, rows, rows);
        let mut i = 0;
        while i < WIDTH {
            theta[0][i] = L::splat(start.theta[i]);
            velocity[0][i] = L::splat(start.velocity[i]);
            slips[0][i] = L::splat(start.slip[i]);
            i += 1;
        }
        let (omega2, linear) = (L::splat(piece.omega2.hi), L::splat(piece.linear));
        let (dry, drag) = (L::splat(piece.dry), L::splat(2.0 * piece.quadratic));
        let by_presliding = L::splat(if piece.slip == 0.0 { 0.0 } else { piece.slip / presliding });
        let mut k = 0;
        while k < ORDER {
            let pull = products(&c, &theta, k);
            let mut force = [zero; WIDTH];
            force[OMEGA2] = -s[k];
            force[LINEAR] = -(L::splat(2.0 * sense) * v[k]);
            force[QUADRATIC] = -(L::splat(signs) * square[k]);
            force[DRY] = L::splat(signs) * (u[k] - L::splat(if k == 0 { 1.0 } else { 0.0 }));
            force[CONSTANT] = L::splat(if k == 0 { 1.0 } else { 0.0 });
            force[AMPLITUDE] = L::splat(sinusoid[0][k]);
            force[FREQUENCY] = L::splat(sinusoid[1][k]);
            force[PHASE] = L::splat(sinusoid[2][k]);
            if piece.quadratic != 0.0 {
                let dragged = products(&v, &velocity, k);
                let mut i = 0;
                while i < WIDTH {
                    force[i] = force[i] - drag * dragged[i];
                    i += 1;
                }
            }
            let inverse = L::splat(INVERSE[k + 1].hi);
            if piece.slip != 0.0 {
                let (own, moved) = (products(&v, &slips, k), products(&u, &velocity, k));
                let mut i = 0;
                while i < WIDTH {
                    force[i] = dry.mul_add(slips[k][i], force[i]);
                    slips[k + 1][i] = -(slip * (own[i] + moved[i]) * inverse);
                    i += 1;
                }
                slips[k + 1][PRESLIDING] =
                    (by_presliding * slipping[k]).mul_add(inverse, slips[k + 1][PRESLIDING]);
            }
            let mut i = 0;
            while i < WIDTH {
                let rest = force[i] - linear * velocity[k][i];
                theta[k + 1][i] = velocity[k][i] * inverse;
                velocity[k + 1][i] = (rest - omega2 * pull[i]) * inverse;
                i += 1;
            }
            k += 1;
        }
        let rows = [[0.0; WIDTH]; ORDER + 1];
        let mut jet = ColumnJet { theta: rows, velocity: rows, slip: rows };
        let mut k = 0;
        while k <= ORDER {
            let mut i = 0;
            while i < WIDTH {
                theta[k][i].store(&mut jet.theta[k][i..=i]);
                velocity[k][i].store(&mut jet.velocity[k][i..=i]);
                slips[k][i].store(&mut jet.slip[k][i..=i]);
                i += 1;
            }
            k += 1;
        }
        jet
    }
}

struct ColumnSum<'a> {
    jet: &'a ColumnJet,
    since: f64,
}

#[inline(always)]
fn sum<L: Lane>(rows: &[Row; ORDER + 1], t: L) -> Row {
    let mut sums = [L::splat(0.0); WIDTH];
    let mut k = ORDER + 1;
    while k > 0 {
        k -= 1;
        let mut i = 0;
        while i < WIDTH {
            sums[i] = sums[i].mul_add(t, L::load(&rows[k][i..]));
            i += 1;
        }
    }
    let mut values = [0.0; WIDTH];
    let mut i = 0;
    while i < WIDTH {
        values[i] = sums[i].first();
        i += 1;
    }
    values
}

impl Kernel for ColumnSum<'_> {
    type Output = Columns;
    type Place = ColumnJet;
    #[inline(always)]
    fn run<L: Lane>(self) -> Columns {
        let t = L::splat(self.since);
        let ColumnJet { theta, velocity, slip } = self.jet;
        Columns { theta: sum(theta, t), velocity: sum(velocity, t), slip: sum(slip, t) }
    }
}
