//! Numbers in texts, which JavaScript reads: to the same double as Rust does, without its tables of powers of ten here.

#[cfg(target_arch = "wasm32")]
#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// The number that a text of so many bytes is; NaN where it is none.
    fn number(text: *const u8, length: usize) -> f64;
}

/// The number that a text is, none where it is none.
pub fn number_of(text: &str) -> Option<f64> {
    #[cfg(target_arch = "wasm32")]
    // SAFETY: the page reads so many bytes of a text that lives until it is done.
    let value = unsafe { number(text.as_ptr(), text.len()) };
    #[cfg(not(target_arch = "wasm32"))]
    let value: f64 = text.parse().unwrap_or(f64::NAN);
    (!value.is_nan() || text == "NaN").then_some(value)
}
