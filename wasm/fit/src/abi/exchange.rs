//! What JavaScript and this module exchange: texts that are written and read, and columns of numbers as their bytes.

use std::cell::RefCell;

thread_local! {
    /// The bytes of a file or of a column, what is stated, the answer.
    static TEXTS: [RefCell<Vec<u8>>; 3] = const { [const { RefCell::new(Vec::new()) }; 3] };
    /// The columns that belong to the answer.
    static COLUMNS: RefCell<Vec<Vec<f64>>> = const { RefCell::new(Vec::new()) };
}

pub const BYTES: usize = 0;
pub const STATED: usize = 1;
const ANSWER: usize = 2;

/// Makes a text so many bytes long, to be written; its address. 0 is a file or a column, 1 what is stated.
#[unsafe(no_mangle)]
pub extern "C" fn room(text: usize, length: usize) -> *const u8 {
    TEXTS.with(|texts| {
        let Some(text) = texts.get(text) else { return core::ptr::null() };
        let mut text = text.borrow_mut();
        text.clear();
        text.resize(length, 0);
        text.as_ptr()
    })
}

/// Address of the answer.
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> *const u8 {
    TEXTS.with(|texts| texts[ANSWER].borrow().as_ptr())
}

/// Bytes of the answer.
#[unsafe(no_mangle)]
pub extern "C" fn answer_length() -> usize {
    TEXTS.with(|texts| texts[ANSWER].borrow().len())
}

/// Address of a column of the answer.
#[unsafe(no_mangle)]
pub extern "C" fn column(number: usize) -> *const f64 {
    COLUMNS.with_borrow(|columns| columns.get(number).map_or(core::ptr::null(), |column| column.as_ptr()))
}

/// Rows of a column of the answer.
#[unsafe(no_mangle)]
pub extern "C" fn column_length(number: usize) -> usize {
    COLUMNS.with_borrow(|columns| columns.get(number).map_or(0, Vec::len))
}

/// What was written, which is let go.
pub fn taken(text: usize) -> Vec<u8> {
    TEXTS.with(|texts| texts[text].take())
}

/// What is stated.
pub fn stated() -> String {
    String::from_utf8_lossy(&taken(STATED)).into_owned()
}

/// Leaves an answer with its columns, or a refusal. 1: an answer; 0: a refusal.
pub fn left(answer: Result<(String, Vec<Vec<f64>>), String>) -> u32 {
    let kept = u32::from(answer.is_ok());
    let (text, columns) = answer.unwrap_or_else(|refusal| (refusal, Vec::new()));
    TEXTS.with(|texts| texts[ANSWER].replace(text.into_bytes()));
    COLUMNS.set(columns);
    kept
}
