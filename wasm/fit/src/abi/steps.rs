//! The steps of a fit, which JavaScript is told.

use libration_fit::fit::FitOptions;

#[cfg(target_arch = "wasm32")]
#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// Told at the begin of each step of a fit: its number in `FitOptions::STEPS`.
    fn step(number: usize);
}

/// Tells the page which step of a fit begins.
pub fn tell(begins: &'static str) {
    let Some(number) = FitOptions::STEPS.iter().position(|each| *each == begins) else { return };
    #[cfg(target_arch = "wasm32")]
    // SAFETY: the page reads one whole number.
    unsafe {
        step(number);
    }
    #[cfg(not(target_arch = "wasm32"))]
    let _ = number;
}
