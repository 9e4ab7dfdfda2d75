//! The functions that JavaScript calls: springs here, friction in abi/friction.rs. `unsafe` stands in this file and abi/ only: in the
//! attribute that gives a function its name outside.
//!
//! As in wasm/src/abi.rs: column 0 holds arguments, the next ones results; a function that makes an object returns its number, one
//! that leaves a list its length; where it refuses it returns 0 (a list: -1), and the text says what.

#[path = "../../src/abi/exchange.rs"]
mod exchange;
mod friction;

use crate::objects::{Objects, ask, drop};
use crate::workspace::with_columns;
use exchange::{both, made, refuse};
use libration::{CubicQuintic, Duffing, Frequency, OscillatorRegime};
use std::cell::RefCell;

/// Of either kind.
enum Spring {
    Duffing(Duffing),
    CubicQuintic(Box<CubicQuintic>),
}

/// What both answer.
macro_rules! of_both {
    ($spring:expr, $orbit:ident => $value:expr) => {
        match $spring {
            Spring::Duffing($orbit) => $value,
            Spring::CubicQuintic($orbit) => $value,
        }
    };
}

thread_local! {
    static SPRINGS: RefCell<Objects<Spring>> = const { RefCell::new(Objects::new()) };
}

/// The motion of u'' + p u + r u^2 + q u^3 = c.
#[unsafe(no_mangle)]
pub extern "C" fn duffing_new(u0: f64, velocity0: f64, p: f64, q: f64, r: f64, c: f64) -> u32 {
    made(&SPRINGS, Duffing::with_even_powers(u0, velocity0, [p, q, r, c]).map(Spring::Duffing))
}

/// The motion of u'' + p u + q u^3 + s u^5 = 0.
#[unsafe(no_mangle)]
pub extern "C" fn cubic_quintic_new(u0: f64, velocity0: f64, p: f64, q: f64, s: f64) -> u32 {
    made(&SPRINGS, CubicQuintic::new(u0, velocity0, p, q, s).map(Box::new).map(Spring::CubicQuintic))
}

/// Drops a spring.
#[unsafe(no_mangle)]
pub extern "C" fn spring_drop(spring: u32) {
    drop(&SPRINGS, spring);
}

/// Column 0: period, lowest and highest u, energy, when it escapes, when it came from infinity. Returns the regime: rest, linear,
/// libration, well, homoclinic, heteroclinic, escape from 0 on.
#[unsafe(no_mangle)]
pub extern "C" fn spring_facts(spring: u32) -> u32 {
    let regime = ask(&SPRINGS, spring, |spring| {
        let facts = of_both!(spring, orbit => {
            let (lowest, highest) = orbit.range();
            [orbit.period(), lowest, highest, orbit.energy(), orbit.escape_time(), orbit.escape_time_backward()]
        });
        with_columns(|columns| columns[0][..facts.len()].copy_from_slice(&facts));
        match of_both!(spring, orbit => orbit.regime()) {
            OscillatorRegime::Rest => 0,
            OscillatorRegime::Linear => 1,
            OscillatorRegime::Libration => 2,
            OscillatorRegime::Well => 3,
            OscillatorRegime::Homoclinic => 4,
            OscillatorRegime::Heteroclinic => 5,
            _ => 6,
        }
    });
    regime.unwrap_or(0)
}

/// t to u and velocity.
#[unsafe(no_mangle)]
pub extern "C" fn spring_motion(spring: u32, rows: usize) {
    ask(&SPRINGS, spring, |spring| {
        let spring = &*spring;
        both(rows, |t| of_both!(spring, orbit => orbit.motion(t)).into());
    });
}

/// Column 0: u0, velocity0, p and q of the oscillator that moves like a pendulum, u = tan(theta/2).
#[unsafe(no_mangle)]
pub extern "C" fn duffing_of_pendulum(theta0: f64, velocity0: f64, length: f64, gravity: f64) -> u32 {
    let companion = Frequency::from_arguments(None, None, Some(length), Some(gravity))
        .and_then(|frequency| Duffing::of_pendulum(theta0, velocity0, frequency));
    match companion {
        Err(domain) => (refuse(&domain), 0).1,
        Ok(spring) => {
            let facts = [spring.u0(), spring.velocity0(), spring.p(), spring.q()];
            with_columns(|columns| columns[0][..facts.len()].copy_from_slice(&facts));
            1
        }
    }
}
