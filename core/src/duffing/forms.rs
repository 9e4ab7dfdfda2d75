//! forms
pub struct Form;
