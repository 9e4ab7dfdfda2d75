//! Which formula an orbit of the cubic-quintic oscillator follows, with its factors and the place of its start.
//!
//! Every motion is u = n/sqrt M, M = l p^2 + m q^2 with l, m >= 0; where it escapes M has the factor sn d sn e besides,
//! d and e the arguments to the pole ahead and from the pole behind, so that no sum ever cancels:
//!   sn^2 x_e - sn^2 x = sn(x_e - x) sn(x_e + x) (cn^2 x + dn^2 x_e sn^2 x).
//!
//! | form | n | p, q | l, m | l, m with poles |
//! |---|---|---|---|---|
//! | crossing | sn | cn, sn | v0 - v2, v0 | -v2, -v1 |
//! | inside | 1 | cd, k' sd | v1, v2 | m v0, v1 - v2 |
//! | between | 1 | cn, sn | v0, v1 | v0 - v1, -m v2 |
//! | outside | cd | cd, k' sd | | v1, v0 |
//! | crossing, pair | sn dn | cn, sn dn | H, v0 | H - v0 twice |
//! | outside, pair | cn | cn, sn dn | | H + v0 twice |
//!
//! Source: derived from v'^2 = 4 C(v) of quintic_marks.rs; DLMF 22.8, 22.13(i).

use super::argument::{Form, Mark, Marks};
use super::cubic_phase::sign;
use super::elementary::{Plain, plain};
use super::elementary_lanes::Hyperbolic;
use super::quintic_exact::Exact;
use super::regime::Regime;
use super::roots::{Cubic, Distances};
use super::theta_quotients::{Theta, theta};
use super::zero_energy::{Level, level};
use super::zero_energy_lanes::Edge;
use crate::float::TWO_PI;
use crate::float::scaled::Scaled;

/// The inputs without rounding: 6 u'^2 = a + b y + c y^2 + d y^3, y = u^2.
#[derive(Clone, Debug)]
pub(super) struct Spring {
    /// 12 E.
    pub a: Exact,
    pub b: Exact,
    pub c: Exact,
    pub d: Exact,
}

/// The way of the canonical function along the orbit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Way {
    /// Sign of u where the canonical function is positive.
    pub side: f64,
    /// Whether its argument rises with time, +1 or -1.
    pub turn: f64,
}

/// How marks are found.
#[derive(Clone, Debug)]
pub(super) enum Marker {
    Energy(Box<Marks>),
    Level(Box<Level>),
}

/// A motion without theta functions in ordinary units, for lanes.
#[derive(Clone, Debug)]
pub(super) enum Ordinary {
    Hyperbolic(Hyperbolic),
    Edge(Edge),
}

#[derive(Clone, Debug)]
pub(super) enum Course {
    Still,
    Theta(Box<Theta>),
    Plain(Box<Plain>, Option<Box<Ordinary>>),
}

/// All that does not depend on time.
pub(super) struct SetUp {
    pub course: Course,
    pub marker: Option<Marker>,
    pub regime: Regime,
    pub period: Scaled,
    pub range: [Scaled; 2],
    /// Backward and forward.
    pub escapes: [Scaled; 2],
    pub way: Way,
}

/// What the marker and the formulas have in common.
pub(super) struct Outline {
    /// Smallest and largest |u|; from 0 where it crosses.
    pub reach: [Scaled; 2],
    /// Whether the motion passes u = 0.
    pub crosses: bool,
    /// Whether |u| grows with the argument.
    pub grows: bool,
    /// Whether the motion has a pole on both sides of its base, for those that have one.
    pub two_sided: bool,
    pub pole: Option<Scaled>,
    pub omega: Scaled,
    /// Whether it repeats.
    pub periodic: bool,
    /// Without a pole and not periodic: how many equilibria it tends to, 1 or 2.
    pub limits: usize,
}

impl Marker {
    pub fn at(&self, y: &Exact, square_speed: &Exact) -> Mark {
        match self {
            Marker::Energy(marks) => marks.at(y, square_speed),
            Marker::Level(level) => level.at(y, square_speed),
        }
    }
}

impl Spring {
    pub fn new(u: f64, velocity: f64, [alpha, beta, gamma]: [f64; 3]) -> Spring {
        let y = Exact::from(u).square();
        let [b, c, d] = [(alpha, -6.0), (beta, -3.0), (gamma, -2.0)].map(|(x, k)| &Exact::from(x) * k);
        let a = &(&Exact::from(velocity).square() * 6.0) - &(&y * &(&b + &(&y * &(&c + &(&y * &d)))));
        Spring { a, b, c, d }
    }
    /// 6 u'^2 where u^2 = y.
    pub fn square_speed(&self, y: &Exact) -> Exact {
        &self.a + &(y * &(&self.b + &(y * &(&self.c + &(y * &self.d)))))
    }
    /// Sign of the force times u where u^2 = y: of the derivative of the above.
    fn pull(&self, y: &Exact) -> i32 {
        (&self.b + &(y * &(&(&self.c * 2.0) + &(&(y * &self.d) * 3.0)))).sign()
    }
    pub fn linear(&self) -> bool {
        self.c.sign() == 0 && self.d.sign() == 0
    }
}

/// The marks of an orbit with E != 0.
fn marks(spring: &Spring, y: &Exact) -> Marks {
    let Spring { a, b, c, d } = spring.clone();
    let positive = a.sign() > 0;
    let speed = (a.to_wide().abs() / Scaled::from(6.0)).sqrt();
    let cubic = Cubic::new(a, b, c, d);
    let roots = cubic.roots();
    let none = Scaled::ZERO;
    let mut marks = Marks {
        form: Form::Crossing,
        roots,
        gaps: [none; 3],
        speed,
        omega: Scaled::ONE,
        mc: none,
        pole: None,
        cubic,
    };
    match (roots, marks.cubic.gaps(), marks.cubic.pair()) {
        (Distances::Three(_), Some(gaps), _) => {
            let all = marks.cubic.all_on_one_side(y);
            let [upper, lower, total] = gaps;
            marks.gaps = gaps;
            marks.form = match (positive, all) {
                (true, true) => Form::Crossing,
                (true, false) => Form::Inside,
                (false, false) => Form::Between,
                (false, true) => Form::Outside,
            };
            if total.is_zero() {
                marks.mc = Scaled::from(f64::NAN);
            } else {
                marks.mc = if positive { upper } else { lower } / total;
                marks.omega = speed * total.sqrt();
            }
            if !marks.mc.is_positive() {
                marks.form = match marks.form {
                    Form::Inside => Form::Falling,
                    Form::Outside => Form::Sinking,
                    form => form,
                };
            }
        }
        (_, _, Some([q, w])) => {
            let h = (q.square() + w.square()).sqrt();
            // (H + q)/2H, the smaller of the sums by w^2.
            let sum = if q.is_negative() { w.square() / (h - q) } else { h + q };
            marks.gaps = [q, w, h];
            marks.form = if positive { Form::PairCrossing } else { Form::PairOutside };
            marks.mc = sum / h.shift(1);
            marks.omega = speed * h.sqrt();
        }
        _ => {}
    }
    if marks.bounded() == Some(false) {
        marks.pole = Some(marks.of_pole());
    }
    marks
}

fn inverse_root(v: Scaled) -> Scaled {
    Scaled::ONE / v.sqrt()
}

impl Marks {
    /// Turning point or limit at the far end; `None` where u grows for ever without a pole.
    fn bounded(&self) -> Option<bool> {
        let end = self.end();
        match (end.is_positive(), end.is_zero()) {
            (true, _) => Some(true),
            // A double root 0 is reached by exponentials, a triple one by a straight line: the linear oscillator.
            (_, true) if !self.mc.is_positive() && self.form != Form::Falling => None,
            _ => Some(false),
        }
    }
    /// v at the end with the largest |u|; not positive where that is infinite.
    fn end(&self) -> Scaled {
        match (self.form, self.roots) {
            (Form::Crossing, Distances::Three(v)) => v[0],
            (Form::Inside | Form::Falling, Distances::Three(v)) => v[2],
            (Form::Between, Distances::Three(v)) => v[1],
            (Form::PairCrossing, Distances::One([v, ..])) => v,
            _ => -Scaled::ONE,
        }
    }

    fn outline(&self) -> Outline {
        let hyperbolic = !self.mc.is_positive();
        let infinite = Scaled::from(f64::INFINITY);
        let outer = if self.end().is_positive() { inverse_root(self.end()) } else { infinite };
        let inner = match (self.form, self.roots) {
            (Form::Inside | Form::Falling, Distances::Three(v)) => inverse_root(v[1]),
            (Form::Between, Distances::Three(v)) => inverse_root(v[0]),
            (Form::Outside | Form::Sinking, Distances::Three(v)) => inverse_root(v[2]),
            (Form::PairOutside, Distances::One([v, ..])) => inverse_root(v),
            _ => Scaled::ZERO,
        };
        let crosses = matches!(self.form, Form::Crossing | Form::PairCrossing);
        let one_sided = matches!(self.form, Form::Falling | Form::Sinking);
        Outline {
            reach: [inner, outer],
            crosses,
            grows: !one_sided,
            two_sided: !one_sided,
            pole: self.pole,
            omega: self.omega,
            periodic: self.pole.is_none() && !hyperbolic,
            limits: if crosses { 2 } else { 1 },
        }
    }
}

fn still(u: f64, y: &Exact, [alpha, beta, gamma]: [f64; 3]) -> SetUp {
    let infinite = Scaled::from(f64::INFINITY);
    let [alpha, beta, gamma] = [alpha, beta, gamma].map(Exact::from);
    let stiffness = &alpha + &(y * &(&(&beta * 3.0) + &(&(y * &gamma) * 5.0)));
    let period =
        if stiffness.sign() > 0 { Scaled::from(TWO_PI) / stiffness.to_wide().sqrt() } else { infinite };
    SetUp {
        course: Course::Still,
        marker: None,
        regime: Regime::Rest,
        period,
        range: [Scaled::from(u); 2],
        escapes: [-infinite, infinite],
        way: Way { side: 1.0, turn: 1.0 },
    }
}

fn without_thetas(plain: Plain) -> Course {
    let edge = || Edge::new(&plain).map(Ordinary::Edge);
    let ordinary = Hyperbolic::new(&plain).map(Ordinary::Hyperbolic).or_else(edge).map(Box::new);
    Course::Plain(Box::new(plain), ordinary)
}

/// The regime by exact signs, and the formula it asks for.
pub(super) fn course(spring: &Spring, u: f64, velocity: f64, force: [f64; 3]) -> SetUp {
    let y = Exact::from(u).square();
    if velocity == 0.0 && (u == 0.0 || spring.pull(&y) == 0) {
        return still(u, &y, force);
    }
    let square_speed = &Exact::from(velocity).square() * 6.0;
    let (marker, outline) = if spring.a.sign() == 0 {
        let level = level(spring, &y);
        let outline = level.outline();
        (Marker::Level(Box::new(level)), outline)
    } else {
        let marks = marks(spring, &y);
        let outline = marks.outline();
        (Marker::Energy(Box::new(marks)), outline)
    };
    let start = marker.at(&y, &square_speed);
    let outwards =
        if u == 0.0 || velocity == 0.0 { 1.0 } else { sign(Scaled::from(u)) * sign(Scaled::from(velocity)) };
    let side = sign(Scaled::from(if u == 0.0 { velocity } else { u }));
    let way = Way { side, turn: if outline.grows { outwards } else { -outwards } };
    let infinite = Scaled::from(f64::INFINITY);
    let mut escapes = [-infinite, infinite];
    if let Some(pole) = outline.pole {
        let ahead = start.pole / outline.omega;
        let behind = if outline.two_sided { (pole + start.base) / outline.omega } else { infinite };
        let (ahead, behind) = if outline.two_sided { (ahead, behind) } else { (behind, ahead) };
        escapes = if way.turn > 0.0 { [-behind, ahead] } else { [-ahead, behind] };
    }
    let [inner, outer] = outline.reach;
    let range = match (outline.crosses, side < 0.0) {
        (true, _) => [-outer, outer],
        (_, true) => [-outer, -inner],
        _ => [inner, outer],
    };
    let regime = if spring.linear() {
        Regime::Linear
    } else if outline.pole.is_some() {
        Regime::Escape
    } else {
        match (outline.periodic, outline.crosses, outline.limits) {
            (true, true, _) => Regime::Libration,
            (true, false, _) => Regime::Well,
            (_, _, 2) => Regime::Heteroclinic,
            _ => Regime::Homoclinic,
        }
    };
    let (course, half) = match &marker {
        Marker::Energy(marks) if marks.mc.is_positive() => {
            let (theta, half) = theta(marks, &outline, start, way);
            (Course::Theta(Box::new(theta)), half)
        }
        Marker::Energy(marks) => (without_thetas(plain(marks, start, way)), infinite),
        Marker::Level(level) if level.circular() => {
            let (theta, half) = level.theta(start, way);
            (Course::Theta(Box::new(theta)), half)
        }
        Marker::Level(level) => (without_thetas(level.plain(start, way)), infinite),
    };
    let period = match (outline.periodic, outline.crosses) {
        (true, true) => half.shift(1) / outline.omega,
        (true, false) => half / outline.omega,
        _ => infinite,
    };
    SetUp { course, marker: Some(marker), regime, period, range, escapes, way }
}
