//! Answers in JSON. A number is a text of its bits, which JavaScript turns back: so nothing here writes or rounds digits.

use serde::Serialize;
use serde_json::Serializer;
use serde_json::ser::Formatter;
use std::io;

/// JSON whose numbers that may have a fraction are texts: a mark and the 16 hexadecimal digits of the double.
struct Bits;

impl Formatter for Bits {
    fn write_f64<W: ?Sized + io::Write>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        write!(writer, "\"\\u0003{:016x}\"", value.to_bits())
    }
}

/// A value in JSON; what is not finite is null.
pub fn json(value: &impl Serialize) -> String {
    let mut bytes = Vec::new();
    let written = value.serialize(&mut Serializer::with_formatter(&mut bytes, Bits));
    written.ok().and_then(|()| String::from_utf8(bytes).ok()).unwrap_or_default()
}
