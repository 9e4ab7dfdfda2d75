//! The pair of Dormand and Prince of orders 5 and 4 with the step control and the interpolant of SciPy's `RK45`, at its
//! defaults rtol = 1e-3 and atol = 1e-6: what `scipy.integrate.solve_ivp` makes of the pendulum when it is told no more.
//!
//! In plain doubles, operation by operation as SciPy has it: the first step, the norm of the error, the factors between
//! steps, the last step cut at the end. Source: Dormand & Prince, J. Comput. Appl. Math. 6 (1980) 19; Shampine, Math.
//! Comp. 46 (1986) 135 (interpolant); Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.4.

use super::steps::State;
use crate::float::Dd;
use crate::float::exponent::ldexp;

/// SciPy's defaults.
const RELATIVE: f64 = 1e-3;
const ABSOLUTE: f64 = 1e-6;
/// The factors between steps: the safety and the least and the most.
const SAFETY: f64 = 0.9;
const LEAST: f64 = 0.2;
const MOST: f64 = 10.0;

/// The stages after the first, by the slopes before them.
const STAGES: [&[f64]; 5] = [
    &[1.0 / 5.0],
    &[3.0 / 40.0, 9.0 / 40.0],
    &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
    &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
    &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
];
/// The state of order 5.
const WEIGHTS: [f64; 6] = [35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0];
/// Less the state of order 4.
const ERROR: [f64; 7] =
    [-71.0 / 57600.0, 0.0, 71.0 / 16695.0, -71.0 / 1920.0, 17253.0 / 339_200.0, -22.0 / 525.0, 1.0 / 40.0];
/// The interpolant of order 4: the powers 1 to 4 of the part of a step, by slopes.
const INTERPOLANT: [[f64; 4]; 7] = [
    [
        1.0,
        -8_048_581_381.0 / 2_820_520_608.0,
        8_663_915_743.0 / 2_820_520_608.0,
        -12_715_105_075.0 / 11_282_082_432.0,
    ],
    [0.0; 4],
    [
        0.0,
        131_558_114_200.0 / 32_700_410_799.0,
        -68_118_460_800.0 / 10_900_136_933.0,
        87_487_479_700.0 / 32_700_410_799.0,
    ],
    [
        0.0,
        -1_754_552_775.0 / 470_086_768.0,
        14_199_869_525.0 / 1_410_260_304.0,
        -10_690_763_975.0 / 1_880_347_072.0,
    ],
    [
        0.0,
        127_303_824_393.0 / 49_829_197_408.0,
        -318_862_633_887.0 / 49_829_197_408.0,
        701_980_252_875.0 / 199_316_789_632.0,
    ],
    [0.0, -282_668_133.0 / 205_662_961.0, 2_019_193_451.0 / 616_988_883.0, -1_453_857_185.0 / 822_651_844.0],
    [0.0, 40_617_522.0 / 29_380_423.0, -110_615_467.0 / 29_380_423.0, 69_997_945.0 / 29_380_423.0],
];

/// An accepted step with its interpolant.
#[derive(Clone, Copy, Debug)]
pub(super) struct DenseStep {
    /// Where it begins, and how long it is.
    pub t: f64,
    pub h: f64,
    /// The state at its beginning.
    pub start: State,
    /// The coefficients of the powers 1 to 4 of the part of the step.
    slopes: [State; 4],
}

impl DenseStep {
    /// The state at a time within.
    pub fn state(&self, t: f64) -> State {
        let part = (t - self.t) / self.h;
        let mut power = 1.0;
        let mut sum = State(0.0, 0.0);
        for slope in self.slopes {
            power *= part;
            sum = sum.along(slope, power);
        }
        self.start.along(sum, self.h)
    }
}

/// An integration under way.
pub(super) struct DormandPrince {
    omega2: f64,
    until: f64,
    t: f64,
    state: State,
    slope: State,
    /// The next step to be tried.
    h: f64,
}

impl DormandPrince {
    /// From a state at 0 to a time >= 0.
    pub fn new(state: State, omega2: f64, until: f64) -> DormandPrince {
        let slope = state.slope(omega2);
        DormandPrince { omega2, until, t: 0.0, state, slope, h: first_step(state, slope, omega2, until) }
    }

    /// The time and the state that have been reached.
    pub fn reached(&self) -> (f64, State) {
        (self.t, self.state)
    }

    /// The next accepted step; `None` at the end, and where a step would be too short for the doubles.
    pub fn step(&mut self) -> Option<DenseStep> {
        if self.t.is_nan() || self.t >= self.until {
            return None;
        }
        let least = 10.0 * (self.t.next_up() - self.t);
        let mut h = self.h.max(least);
        let mut rejected = false;
        // Ends: each turn accepts a step or makes it shorter by a tenth at least, until it is too short.
        while h >= least {
            let end = self.until.min(self.t + h);
            h = end - self.t;
            let slopes = self.slopes(h);
            let state = slopes.1;
            let size = norm(weighted(&ERROR, &slopes.0), self.state, state, h);
            if size < 1.0 {
                let factor = if size == 0.0 { MOST } else { MOST.min(SAFETY * fifth_root(1.0 / size)) };
                let step = DenseStep {
                    t: self.t,
                    h,
                    start: self.state,
                    slopes: [0, 1, 2, 3]
                        .map(|power| weighted(&INTERPOLANT.map(|weights| weights[power]), &slopes.0)),
                };
                self.h = h * if rejected { factor.min(1.0) } else { factor };
                (self.t, self.state, self.slope) = (end, state, slopes.0[6]);
                return Some(step);
            }
            h *= LEAST.max(SAFETY * fifth_root(1.0 / size));
            rejected = true;
        }
        None
    }

    /// The seven slopes of a step, and the state at its end.
    fn slopes(&self, h: f64) -> ([State; 7], State) {
        let mut slopes = [self.slope; 7];
        for (at, weights) in STAGES.iter().enumerate() {
            slopes[at + 1] = self.state.along(weighted(weights, &slopes), h).slope(self.omega2);
        }
        let state = self.state.along(weighted(&WEIGHTS, &slopes), h);
        slopes[6] = state.slope(self.omega2);
        (slopes, state)
    }
}

/// The sum of slopes by their weights.
fn weighted(weights: &[f64], slopes: &[State]) -> State {
    weights.iter().zip(slopes).fold(State(0.0, 0.0), |sum, (weight, slope)| sum.along(*slope, *weight))
}

/// The root of the mean square of a state over its scales.
fn scaled(State(a, b): State, State(scale_a, scale_b): State) -> f64 {
    let (a, b) = (a / scale_a, b / scale_b);
    ((a * a + b * b) / 2.0).sqrt()
}

/// What is allowed of a state.
fn tolerance(State(a, b): State) -> State {
    State(ABSOLUTE + a.abs() * RELATIVE, ABSOLUTE + b.abs() * RELATIVE)
}

/// The error of a step over what is allowed; NaN counts as too large.
fn norm(error: State, before: State, after: State, h: f64) -> f64 {
    let larger = State(before.0.abs().max(after.0.abs()), before.1.abs().max(after.1.abs()));
    scaled(State(h * error.0, h * error.1), tolerance(larger))
}

/// The first step to be tried (Hairer, Norsett, Wanner I, II.4).
fn first_step(state: State, slope: State, omega2: f64, until: f64) -> f64 {
    let scale = tolerance(state);
    let (d0, d1) = (scaled(state, scale), scaled(slope, scale));
    let h = if d0 < 1e-5 || d1 < 1e-5 { 1e-6 } else { 0.01 * d0 / d1 }.min(until);
    let next = state.along(slope, h).slope(omega2);
    let d2 = scaled(State(next.0 - slope.0, next.1 - slope.1), scale) / h;
    let longer =
        if d1 <= 1e-15 && d2 <= 1e-15 { f64::max(1e-6, h * 1e-3) } else { fifth_root(0.01 / d1.max(d2)) };
    (100.0 * h).min(longer).min(until)
}

/// The fifth root of a number >= 0, rounded to the nearest double but where that is nearly a tie; what is NaN gives none, so that a
/// step shrinks most.
fn fifth_root(value: f64) -> f64 {
    if value.is_nan() || value < f64::MIN_POSITIVE {
        return 0.0;
    }
    if value == f64::INFINITY {
        return value;
    }
    // The squares and their rests stay doubles; powers of 2 change no digit.
    if !(1e-200..1e200).contains(&value) {
        let power = if value < 1.0 { 500 } else { -500 };
        return ldexp(fifth_root(ldexp(value, power)), -power / 5);
    }
    // A fifth of the exponent: within 5 % of the root. Newton's steps square the error: 5e-3, 5e-5, 5e-9, rounding.
    let mut root = f64::from_bits(value.to_bits() / 5 + 4 * 1023 * (1 << 52) / 5);
    for _ in 0..4 {
        let square = root * root;
        root -= (root - value / (square * square)) / 5.0;
    }
    // One more in double-double, of which the correction alone is taken.
    let fourth = Dd::product(root, root).square();
    let left = Dd::from(value) - fourth * root;
    root + left.value() / (5.0 * fourth.hi)
}

#[cfg(test)]
mod tests {
    use super::fifth_root;
    use crate::float::Dd;
    use crate::float::exponent::ldexp;

    /// Whether the fifth power of a root and a part of its last place is above a number.
    fn is_above(value: f64, root: f64, places: f64) -> bool {
        let near = Dd::from(root) + Dd::from(places * (root.next_up() - root));
        (near.square().square() * near - Dd::from(value)).value() > 0.0
    }

    #[test]
    fn fifth_roots_are_the_nearest_doubles() {
        let mut value = 1e-190;
        while value < 1e190 {
            let root = fifth_root(value);
            assert!(is_above(value, root, 0.501) && !is_above(value, root, -0.501), "{value}: {root}");
            // Beyond, by powers of 2.
            let power = if value < 1.0 { -300 } else { 300 };
            assert_eq!(fifth_root(ldexp(value, power)), ldexp(root, power / 5), "{value}");
            value *= 1.37;
        }
        for (value, root) in
            [(32.0, 2.0), (1.0, 1.0), (243.0, 3.0), (0.0, 0.0), (f64::INFINITY, f64::INFINITY)]
        {
            assert_eq!(fifth_root(value), root);
        }
        assert_eq!(fifth_root(f64::NAN), 0.0);
    }

    #[test]
    fn the_check_of_roots_sees_the_next_double() {
        let root = fifth_root(7.0);
        assert!(!is_above(7.0, root.next_down(), 0.501));
        assert!(is_above(7.0, root.next_up(), -0.501));
    }
}
