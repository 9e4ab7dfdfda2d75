//! What the tests of the oscillators share.

use crate::on_every_set;
use crate::ruler::{distance, ulp};
use libration::{CubicQuintic, Duffing, DuffingForm, Glaisher};

/// Reproducible numbers in [0, 1).
pub struct Spread(pub u64);

impl Spread {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
    pub fn state(&mut self) -> [f64; 4] {
        [(); 4].map(|()| self.between(-2.0, 2.0))
    }
}

pub fn energy(u: f64, v: f64, p: f64, q: f64) -> f64 {
    0.5 * v * v + 0.5 * p * u * u + 0.25 * q * u * u * u * u
}

/// Sizes of the terms of the energy.
pub fn energy_scale(u: f64, v: f64, p: f64, q: f64) -> f64 {
    0.5 * v * v + 0.5 * p.abs() * u * u + 0.25 * q.abs() * u * u * u * u
}

/// Largest |u| and |u'| of a bounded orbit; of two values else.
pub fn scales(orbit: &Duffing, u: f64, v: f64) -> [f64; 2] {
    let (low, high) = orbit.range();
    let (p, q) = (orbit.p(), orbit.q());
    let reach = low.abs().max(high.abs());
    if reach.is_infinite() {
        return [u.abs().max(orbit.u0().abs()), v.abs().max(orbit.velocity0().abs())];
    }
    let well = if p * q < 0.0 { -p / q } else { 0.0 };
    let fastest = [0.0, well].map(|square| 2.0 * orbit.energy() - p * square - 0.5 * q * square * square);
    [reach, fastest[0].max(fastest[1]).max(orbit.velocity0().powi(2)).sqrt()]
}

/// A real example of a form.
pub fn example(which: Glaisher, c2: f64) -> Option<DuffingForm> {
    let grid = [
        (1.0, -0.7),
        (1.0, 0.6),
        (-0.8, 1.2),
        (-1.5, 0.4),
        (-0.5, -0.9),
        (1.0, -1.6),
        (-1.1, 1.3),
        (0.3, -1.1),
        (-0.9, -1.2),
        (-1.5, -0.5),
    ];
    grid.iter().find_map(|(p, q)| DuffingForm::new(which, *p, *q, 1.0, c2).ok())
}

/// The promise of rows, in ulps of the scale; the difference of two that keep it is twice that.
const BOUND: f64 = 4.0;

/// An oscillator set up alone.
pub trait Orbit {
    /// u and u' at a time.
    fn at(&self, t: f64) -> [f64; 2];
}

impl Orbit for Duffing {
    fn at(&self, t: f64) -> [f64; 2] {
        self.motion(t).into()
    }
}

impl Orbit for CubicQuintic {
    fn at(&self, t: f64) -> [f64; 2] {
        self.motion(t).into()
    }
}

/// Rows, whose first number is the time, beside an orbit each, on every instruction set; spoiled ones are found.
pub fn rows_keep_their_promise<const N: usize, O: Orbit>(
    rows: &[[f64; N]],
    motions: fn(&[[f64; N]]) -> [Vec<f64>; 2],
    orbit: fn([f64; N]) -> Option<O>,
    scales: fn(&O, f64, f64) -> [f64; 2],
) {
    // The worst distances of u and u' from an orbit each, in ulps of their scales.
    let worst = |rows: &[[f64; N]], orbits: &[Option<O>], spoil: f64| {
        let mut worst = [0.0f64; 2];
        let [u, velocity] = motions(rows);
        for (i, (row, orbit)) in rows.iter().zip(orbits).enumerate() {
            let known = orbit.as_ref().map_or([f64::NAN; 2], |orbit| orbit.at(row[0]));
            let scales = orbit.as_ref().map_or([1.0; 2], |orbit| scales(orbit, known[0], known[1]));
            for (k, got) in [u[i], velocity[i]].into_iter().enumerate() {
                let error = distance(got * spoil, [known[k], 0.0], ulp(scales[k]));
                if error > 2.0 * BOUND && spoil == 1.0 {
                    println!("{i} {row:?} {error} {got} {}", known[k]);
                }
                worst[k] = worst[k].max(error);
            }
        }
        worst
    };
    on_every_set(|set| {
        let orbits: Vec<Option<O>> = rows.iter().map(|row| orbit(*row)).collect();
        let found = worst(rows, &orbits, 1.0);
        println!("{set:?} {found:.2?}");
        assert!(found.iter().all(|error| *error <= 2.0 * BOUND), "{set:?} {found:?}");
        let spoiled = worst(&rows[..600], &orbits[..600], 1.0 + 12.0 * f64::EPSILON);
        assert!(spoiled.iter().all(|error| *error > 2.0 * BOUND), "{set:?} {spoiled:?}");
    });
}
