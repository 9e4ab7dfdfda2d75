//! What JavaScript and this module share: columns of doubles of one fixed length, one list of any length, one text.
//!
//! The columns stay where they are, so a long array goes through them in blocks that stay in the processor's cache, and
//! memory never grows with the length of an array.

use std::cell::RefCell;

/// Doubles in a column: six of them fill 192 kB.
pub const ROWS: usize = 4096;
/// Columns: arguments first, results after them.
pub const COLUMNS: usize = 6;

/// The columns.
pub type Columns = [[f64; ROWS]; COLUMNS];

thread_local! {
    static WORKSPACE: RefCell<Columns> = const { RefCell::new([[0.0; ROWS]; COLUMNS]) };
    static LIST: RefCell<Vec<f64>> = const { RefCell::new(Vec::new()) };
    static TEXT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Works on the columns.
pub fn with_columns<T>(work: impl FnOnce(&mut Columns) -> T) -> T {
    WORKSPACE.with_borrow_mut(work)
}

/// Where the columns are.
pub fn columns() -> *const f64 {
    WORKSPACE.with_borrow(|columns| columns.as_flattened().as_ptr())
}

/// Leaves a list, and says how many it holds.
pub fn leave(list: Vec<f64>) -> i32 {
    let length = list.len();
    LIST.set(list);
    i32::try_from(length).unwrap_or(i32::MAX)
}

/// Where the list is.
pub fn list() -> *const f64 {
    LIST.with_borrow(|list| list.as_ptr())
}

/// Leaves a text.
pub fn say(text: String) {
    TEXT.set(text.into_bytes());
}

/// Room for a text of so many bytes, to be written by JavaScript.
pub fn room(length: usize) -> *const u8 {
    TEXT.with_borrow_mut(|text| {
        text.clear();
        text.resize(length, 0);
        text.as_ptr()
    })
}

/// Where the text is.
pub fn text() -> *const u8 {
    TEXT.with_borrow(|text| text.as_ptr())
}

/// How many bytes it has.
pub fn text_length() -> usize {
    TEXT.with_borrow(Vec::len)
}

/// Works on the text that JavaScript has written. Names are ASCII; another letter is one that no name has.
pub fn with_text<T>(work: impl FnOnce(&str) -> T) -> T {
    let written = TEXT.take();
    let letter = |byte: &u8| if byte.is_ascii() { char::from(*byte) } else { '?' };
    work(&written.iter().map(letter).collect::<String>())
}
