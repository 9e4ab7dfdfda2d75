//! From bytes to text: a byte order mark, UTF-16 without one, UTF-8, or else Windows-1252 (which holds Latin-1).

use std::borrow::Cow;

use super::refusal::Refusal;

/// The text of a file, and how its bytes were understood if not as UTF-8.
pub(super) fn decoded(bytes: &[u8]) -> Result<(Cow<'_, str>, Option<String>), Refusal> {
    let (encoding, note) = match encoding_rs::Encoding::for_bom(bytes) {
        Some((encoding, _)) if encoding == encoding_rs::UTF_8 => (encoding, None),
        Some((encoding, _)) => (encoding, Some(format!("The file is {}.", encoding.name()))),
        None => match utf16(bytes) {
            Some(encoding) => (encoding, Some(format!("The file is {} without a mark.", encoding.name()))),
            None => match std::str::from_utf8(bytes) {
                Ok(_) => (encoding_rs::UTF_8, None),
                Err(_) => (encoding_rs::WINDOWS_1252, Some("The file is no UTF-8: read as Latin-1.".into())),
            },
        },
    };
    if !encoding.is_ascii_compatible() {
        let (text, _) = encoding.decode_with_bom_removal(bytes);
        refuse_binary(text.as_bytes())?;
        return Ok((text, note));
    }
    refuse_binary(bytes)?;
    let (text, _) = encoding.decode_with_bom_removal(bytes);
    // A UTF-8 mark before text that is not UTF-8: some tools write one in front of Latin-1.
    let (text, note) = if encoding == encoding_rs::UTF_8 && text.contains('\u{fffd}') {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        if std::str::from_utf8(bytes).is_ok() {
            (text, note)
        } else {
            let (text, _) = encoding_rs::WINDOWS_1252.decode_without_bom_handling(bytes);
            (text, Some("The file has the mark of UTF-8 and is none: read as Latin-1.".into()))
        }
    } else {
        (text, note)
    };
    Ok((text, note))
}

/// Refuses what no text holds, with its place.
fn refuse_binary(bytes: &[u8]) -> Result<(), Refusal> {
    let Some(at) = bytes.iter().position(|byte| is_binary(*byte)) else { return Ok(()) };
    let allowed = "a table of text, or XLSX, XLS, ZIP, TRK";
    Err(Refusal::fault(None, format!("is not text: byte {at} is 0x{:02x}; allowed is {allowed}", bytes[at])))
}

/// What a text file does not contain: control characters other than tab, line feed, vertical tab, form feed, return.
fn is_binary(byte: u8) -> bool {
    matches!(byte, 0..=8 | 14..=31 | 127)
}

/// UTF-16 without a mark: every second byte of ASCII text is zero, and the others are not.
fn utf16(bytes: &[u8]) -> Option<&'static encoding_rs::Encoding> {
    let sample = &bytes[..bytes.len().min(1024) & !1];
    if sample.len() < 8 {
        return None;
    }
    let zeros = |offset: usize| sample.iter().skip(offset).step_by(2).filter(|byte| **byte == 0).count();
    let (even, odd, half) = (zeros(0), zeros(1), sample.len() / 2);
    if even * 10 >= half * 9 && odd == 0 {
        Some(encoding_rs::UTF_16BE)
    } else if odd * 10 >= half * 9 && even == 0 {
        Some(encoding_rs::UTF_16LE)
    } else {
        None
    }
}
