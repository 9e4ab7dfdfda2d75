//! The motions at E = 0, where v = 1/u^2 obeys v'^2 = 4 C(v), C(v) = -alpha v^2 - beta v/2 - gamma/3: cosines, hyperbolic
//! functions or a square of the time.
//!
//! With c = -beta/4 alpha and D = 3 beta^2 - 16 alpha gamma the roots of C are c +- sqrt(D/48)/|alpha|, formed without
//! cancellation; the time to the pole is u R_C(s^2, s^2 + alpha u^2), s = |u'| + u^3 sqrt(-gamma/3).
//! Source: elementary; DLMF 19.2(iv).

use super::argument::{Form, Mark};
use super::cubic_phase::rf;
use super::elementary::{Curve, Plain, Shape};
use super::quintic_exact::Exact;
use super::set_up::{Outline, Spring, Way};
use super::theta_quotients::{Factors, Theta};
use crate::float::scaled::Scaled;

/// What v does.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// alpha > 0: between two roots.
    Cosine,
    /// Above the upper root, which is positive: u falls to 0 both ways.
    Above,
    /// Above the upper root, which is not positive: from 0 to infinity.
    AbovePole,
    /// Below the lower root.
    Below,
    /// No root.
    Sine,
    /// A double root that is positive or 0, v above it.
    Exponential,
    /// A positive double root, v below it.
    Levelling,
    /// A negative double root.
    Rising,
    /// alpha = beta = 0.
    Straight,
}

#[derive(Clone, Debug)]
pub(super) struct Level {
    kind: Kind,
    /// alpha = 0.
    parabola: bool,
    /// sqrt|alpha|, or 1.
    omega: Scaled,
    /// Lower and upper root; or c and the half gap without roots.
    roots: [Scaled; 2],
    /// Half the gap between the roots, or |beta|/4, or the slope.
    half: Scaled,
    /// sqrt(-gamma/3): the rate at the pole.
    eta: Scaled,
    alpha: Scaled,
    /// 4 |alpha| - beta y, at the start for the exponential; and D.
    offset: Scaled,
    spring: Spring,
    delta: Scaled,
    pole: Option<Scaled>,
}

fn asinh(z: Scaled) -> Scaled {
    z * rf([(Scaled::ONE + z.square()).sqrt(), Scaled::ONE, Scaled::ONE])
}

/// -(4 alpha + beta y), from b = -6 alpha and c = -3 beta: six times it.
fn above_centre(spring: &Spring, y: &Exact) -> Exact {
    &(&spring.b * 4.0) + &(&(&spring.c * y) * 2.0)
}

pub(super) fn level(spring: &Spring, y: &Exact) -> Level {
    let sixth = |x: &Exact, k: f64| x.to_wide() / Scaled::from(k);
    let (alpha, beta, gamma) = (sixth(&spring.b, -6.0), sixth(&spring.c, -3.0), sixth(&spring.d, -2.0));
    // 3 D.
    let delta = &spring.c.square() - &(&(&spring.b * &spring.d) * 4.0);
    let sign = delta.sign();
    let delta = delta.to_wide() / Scaled::from(3.0);
    let eta = if gamma.is_negative() { (-gamma / Scaled::from(3.0)).sqrt() } else { Scaled::ZERO };
    let mut level = Level {
        kind: Kind::Straight,
        parabola: alpha.is_zero(),
        omega: Scaled::ONE,
        roots: [Scaled::ZERO; 2],
        half: eta.shift(1),
        eta,
        alpha,
        offset: Scaled::ZERO,
        spring: spring.clone(),
        delta,
        pole: None,
    };
    let upwards = above_centre(spring, y).sign() > 0;
    if alpha.is_zero() {
        if beta.is_zero() {
            level.pole = Some(Scaled::ZERO);
            return level;
        }
        // v = v_t - beta t^2/2.
        let turn = gamma.shift(1) / (beta * -3.0);
        level.roots = [turn; 2];
        level.half = beta.abs().shift(-1);
        level.kind = if beta.is_positive() {
            Kind::Below
        } else if turn.is_positive() {
            Kind::Above
        } else {
            Kind::AbovePole
        };
        if level.kind != Kind::Above {
            level.pole = Some((turn.abs() / level.half).sqrt());
        }
        return level;
    }
    let size = alpha.abs();
    level.omega = size.sqrt();
    let centre = -(beta / alpha).shift(-2);
    if sign == 0 && alpha.is_negative() {
        level.roots = [centre; 2];
        // v - c at the start.
        level.offset = above_centre(spring, y).to_wide() / (size * y.to_wide() * 24.0);
        level.kind = match (centre.is_negative(), upwards) {
            (true, _) => Kind::Rising,
            (_, true) => Kind::Exponential,
            _ => Kind::Levelling,
        };
        level.pole = (level.kind != Kind::Exponential).then_some(Scaled::ZERO);
        return level;
    }
    level.half = (delta.abs() / Scaled::from(48.0)).sqrt() / size;
    if sign < 0 {
        level.kind = Kind::Sine;
        level.roots = [centre; 2];
        // Of half the hyperbolic argument, and with its sign.
        level.pole = Some(asinh(-centre / level.half).shift(-1));
        return level;
    }
    let product = gamma / (alpha * 3.0);
    let large = if centre.is_negative() { centre - level.half } else { centre + level.half };
    let small = if large.is_zero() { Scaled::ZERO } else { product / large };
    level.roots = if centre.is_negative() { [large, small] } else { [small, large] };
    let [low, high] = level.roots;
    level.kind = match (alpha.is_positive(), upwards, high.is_positive()) {
        (true, ..) => Kind::Cosine,
        (_, false, _) => Kind::Below,
        (_, _, true) => Kind::Above,
        _ => Kind::AbovePole,
    };
    level.pole = match level.kind {
        Kind::Cosine if low.is_positive() => None,
        Kind::Cosine => {
            let gap = level.half.shift(1);
            Some(arcsine((high / gap).sqrt(), (low.abs() / gap).sqrt()))
        }
        Kind::Above => None,
        _ => Some(asinh(level.eta / (level.omega * level.half)).shift(-1)),
    };
    level
}

/// arcsin of a sine with its cosine.
fn arcsine(sine: Scaled, cosine: Scaled) -> Scaled {
    sine * rf([cosine, Scaled::ONE, Scaled::ONE])
}

impl Level {
    /// Whether it is a cosine, for theta functions with m = 0.
    pub fn circular(&self) -> bool {
        self.kind == Kind::Cosine
    }

    pub fn at(&self, y: &Exact, square_speed: &Exact) -> Mark {
        let [low, high] = self.roots;
        // |u'| and what belongs to v = 1/y.
        let speed = (square_speed.to_wide() / Scaled::from(6.0)).sqrt();
        let exact_y = y;
        let y = y.to_wide();
        let u = y.sqrt();
        let pole = if self.pole.is_some() {
            self.omega * self.until_pole(exact_y, y, u, speed)
        } else {
            Scaled::ZERO
        };
        let half_rate = speed / (y * u);
        let base = match self.kind {
            Kind::Cosine => {
                // High y - 1 and 1 - low y, whose product is u'^2/(alpha y).
                let product = (speed / u).square() * y / (self.alpha * y);
                let (down, up) = (high * y - Scaled::ONE, Scaled::ONE - low * y);
                let (down, up) =
                    if (down - up).is_negative() { (product / up, up) } else { (down, product / down) };
                let gap = y * self.half.shift(1);
                arcsine((down / gap).sqrt(), (up / gap).sqrt())
            }
            Kind::Above | Kind::AbovePole | Kind::Below if self.parabola => half_rate / self.half,
            Kind::Above | Kind::AbovePole | Kind::Below => {
                asinh(half_rate / (self.omega * self.half)).shift(-1)
            }
            Kind::Sine => {
                let offset = above_centre(&self.spring, exact_y).to_wide() / (self.alpha.abs() * y * 24.0);
                asinh(offset / self.half).shift(-1)
            }
            Kind::Exponential => {
                let offset = above_centre(&self.spring, exact_y).to_wide() / (self.alpha.abs() * y * 24.0);
                let ratio = offset / self.offset;
                // ln of the ratio.
                asinh((ratio - Scaled::ONE / ratio).shift(-1)).shift(-1)
            }
            Kind::Levelling | Kind::Rising | Kind::Straight => pole,
        };
        Mark { base, pole }
    }

    fn until_pole(&self, exact_y: &Exact, y: Scaled, u: Scaled, speed: Scaled) -> Scaled {
        let eta = self.eta;
        let sum = speed + y * u * eta;
        let square = if self.alpha.is_negative() {
            // y (2 eta^2 - beta v/2 + 2 eta xi): the first two from exact sums, and where they are below 0 all three by
            // the product with the conjugate.
            let first = (&(&(&self.spring.d * exact_y) * 2.0) + &self.spring.c).to_wide() / Scaled::from(6.0);
            let second = (eta * speed / u).shift(1);
            let whole = if first.is_negative() {
                self.delta / (Scaled::from(12.0) * (first - second))
            } else {
                first + second
            };
            whole * y.square()
        } else {
            sum.square() + self.alpha * y
        };
        let root = square.sqrt();
        u * rf([sum, root, root])
    }

    pub fn outline(&self) -> Outline {
        let infinite = Scaled::from(f64::INFINITY);
        let at = |v: Scaled| Scaled::ONE / v.sqrt();
        let [low, high] = self.roots;
        let reach = match self.kind {
            Kind::Cosine => [at(high), if low.is_positive() { at(low) } else { infinite }],
            Kind::Above => [Scaled::ZERO, at(high)],
            Kind::Below | Kind::Levelling => [at(low), infinite],
            Kind::Exponential if low.is_positive() => [Scaled::ZERO, at(low)],
            _ => [Scaled::ZERO, infinite],
        };
        let grows = matches!(self.kind, Kind::Cosine | Kind::Below);
        Outline {
            reach,
            crosses: false,
            grows,
            two_sided: grows,
            pole: self.pole,
            omega: self.omega,
            periodic: self.circular() && self.pole.is_none(),
            limits: if self.kind == Kind::Exponential { 2 } else { 1 },
        }
    }

    /// The cosine.
    pub fn theta(&self, start: Mark, way: Way) -> (Theta, Scaled) {
        let [low, high] = self.roots;
        let gap = self.half.shift(1);
        let factors = Factors {
            form: Form::Between,
            m: Scaled::ZERO,
            mc: Scaled::ONE,
            omega: self.omega,
            squares: if self.pole.is_some() { [gap, gap] } else { [high, low] },
            velocity: gap * self.omega,
            pole: self.pole,
        };
        Theta::new(&factors, start, way)
    }

    pub fn plain(&self, start: Mark, way: Way) -> Plain {
        let rate = if way.turn < 0.0 { -self.omega } else { self.omega };
        let two = self.half.shift(1);
        let curve = if self.parabola { Curve::Power } else { Curve::Sinh };
        let l = if self.parabola { self.half } else { two };
        let squares = |l: Scaled, m: Scaled| Shape::Squares { curve, odd: false, l, m };
        let (shape, factor) = match self.kind {
            Kind::Above => (squares(self.roots[1], l), -l),
            Kind::AbovePole => (squares(l, Scaled::ZERO), -l),
            Kind::Below | Kind::Cosine => (squares(l, Scaled::ZERO), l),
            Kind::Sine => (Shape::Climbing(self.half), -self.half),
            Kind::Exponential => (Shape::Exponential { l: self.offset, m: self.roots[0] }, -self.offset),
            Kind::Levelling => (Shape::Levelling(self.roots[0]), -self.roots[0]),
            Kind::Rising => (Shape::Rising(self.roots[0].abs()), -self.roots[0].abs()),
            Kind::Straight => (Shape::Straight(self.half), -self.half.shift(-1)),
        };
        let one_sided = self.kind != Kind::Below;
        Plain {
            shape,
            base: [start.base, rate],
            rest: [start.pole, if one_sided { rate } else { -rate }],
            pole: self.pole,
            velocity: factor * rate,
            side: way.side,
        }
    }
}
