//! A choice of the instruction set holds on its own thread, while it is open, and nowhere else.

use libration::InstructionSet;
use std::sync::Barrier;
use std::thread;

fn best() -> InstructionSet {
    InstructionSet::available()[InstructionSet::available().len() - 1]
}

/// All scopes are open at once, each asked many times; and one thread beside them has none.
#[test]
fn threads_do_not_see_the_sets_of_each_other() {
    let sets = InstructionSet::available();
    let together = &Barrier::new(2 * sets.len() + 1);
    thread::scope(|threads| {
        for set in sets.iter().chain(sets) {
            threads.spawn(move || {
                let seen = set.scope(|| {
                    together.wait();
                    let seen: Vec<InstructionSet> = (0..1000)
                        .map(|_| {
                            thread::yield_now();
                            InstructionSet::in_use()
                        })
                        .collect();
                    together.wait();
                    seen
                });
                assert!(seen.unwrap().iter().all(|other| other == set));
            });
        }
        together.wait();
        let beside: Vec<InstructionSet> = (0..1000).map(|_| InstructionSet::in_use()).collect();
        together.wait();
        assert!(beside.iter().all(|other| *other == best()));
    });
    assert_eq!(InstructionSet::in_use(), best());
}

#[test]
fn an_inner_scope_ends_with_the_outer_one() {
    for outer in InstructionSet::available() {
        for inner in InstructionSet::available() {
            let seen = outer.scope(|| {
                let within = inner.scope(InstructionSet::in_use).unwrap();
                (within, InstructionSet::in_use())
            });
            assert_eq!(seen.unwrap(), (*inner, *outer));
        }
    }
    assert_eq!(InstructionSet::in_use(), best());
}

#[test]
fn a_panic_closes_the_scope() {
    let caught = thread::spawn(|| {
        let caught = std::panic::catch_unwind(|| InstructionSet::Plain.scope(|| panic!("on purpose")));
        (caught.is_err(), InstructionSet::in_use())
    });
    assert_eq!(caught.join().unwrap(), (true, best()));
}

#[test]
fn a_set_that_the_processor_lacks_is_refused() {
    for set in [InstructionSet::Plain, InstructionSet::Fused, InstructionSet::Avx512] {
        let answer = set.scope(InstructionSet::in_use);
        if InstructionSet::available().contains(&set) {
            assert_eq!(answer.unwrap(), set);
        } else {
            assert!(answer.unwrap_err().to_string().contains("an instruction set of this processor"));
        }
    }
}
