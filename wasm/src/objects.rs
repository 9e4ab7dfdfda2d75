//! What is set up once and asked often, under numbers from 1 on; 0 is no object. A number that is free is given again.

use std::cell::RefCell;
use std::thread::LocalKey;

/// Objects of one type.
pub struct Objects<T>(Vec<Option<T>>);

impl<T> Objects<T> {
    /// None yet.
    pub const fn new() -> Self {
        Objects(Vec::new())
    }
}

/// A place for the objects of one type.
pub type Place<T> = LocalKey<RefCell<Objects<T>>>;

/// Keeps an object and gives it a number.
pub fn keep<T>(place: &'static Place<T>, object: T) -> u32 {
    place.with_borrow_mut(|Objects(objects)| {
        let free = objects.iter().position(Option::is_none);
        let at = free.unwrap_or(objects.len());
        if at == objects.len() {
            objects.push(None);
        }
        objects[at] = Some(object);
        u32::try_from(at + 1).unwrap_or(0)
    })
}

/// Drops an object; nothing where there is none.
pub fn drop<T>(place: &'static Place<T>, number: u32) {
    place.with_borrow_mut(|Objects(objects)| {
        if let Some(object) = index(number).and_then(|at| objects.get_mut(at)) {
            *object = None;
        }
    });
}

/// Asks an object; `None` where there is none.
pub fn ask<T, A>(place: &'static Place<T>, number: u32, question: impl FnOnce(&mut T) -> A) -> Option<A> {
    place.with_borrow_mut(|Objects(objects)| {
        index(number).and_then(|at| objects.get_mut(at)).and_then(Option::as_mut).map(question)
    })
}

fn index(number: u32) -> Option<usize> {
    number.checked_sub(1).and_then(|at| usize::try_from(at).ok())
}
