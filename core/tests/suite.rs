//! All integration tests in one program, so that the crate is linked once: a module per file of this folder.

mod action_angle;
mod cubic_quintic;
mod damped_domain;
mod damped_invariants;
mod damped_limits;
mod damped_motion;
mod doors;
mod duffing;
mod duffing_forms;
mod duffing_rows;
mod elliptic_ends;
mod ensemble;
mod even_rows;
mod identities;
mod instruction_sets;
mod invariants;
mod oscillator;
mod oscillator_knowledge;
mod own_parameters;
mod own_slopes;
mod own_states;
mod passages;
mod pendulum_ends;
mod quintic_knowledge;
mod quintic_rows;
mod ruler;
mod ruler_itself;
mod short_steps;
mod vectors_action;
mod vectors_approx_angle;
mod vectors_approx_period;
mod vectors_approx_sine;
mod vectors_columns;
mod vectors_cubic_quintic;
mod vectors_damped;
mod vectors_duffing;
mod vectors_elliptic;
mod vectors_elliptic_complex;
mod vectors_elliptic_family;
mod vectors_helmholtz_duffing;
mod vectors_oscillator_action;
mod vectors_own_parameters;
mod vectors_pendulum;
mod vectors_quintic_action;
mod vectors_second;
mod vectors_sensitivity;
mod vectors_starts;

use libration::InstructionSet;

/// Runs a test once on every instruction set of this processor, on this thread alone.
fn on_every_set(test: impl Fn(InstructionSet)) {
    for set in InstructionSet::available() {
        set.scope(|| test(*set)).unwrap();
    }
}

/// A file without its `mod` line would never be run.
#[test]
fn every_file_is_a_module() {
    let here = concat!(env!("CARGO_MANIFEST_DIR"), "/tests");
    let mut files = 0;
    for entry in std::fs::read_dir(here).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap();
        if name != "suite" && (path.is_dir() || path.extension().is_some_and(|end| end == "rs")) {
            assert!(include_str!("suite.rs").contains(&format!("\nmod {name};\n")), "{name}");
            files += 1;
        }
    }
    assert!(files > 20);
}
