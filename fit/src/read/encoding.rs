//! From bytes to text: a byte order mark, UTF-16 without one, UTF-8, or else Windows-1252 (which holds Latin-1).

use std::borrow::Cow;

use super::refusal::Refusal;

/// An encoding whose code units are no bytes of ASCII.
#[derive(Clone, Copy)]
enum Utf16 {
    Little,
    Big,
}

impl Utf16 {
    fn name(self) -> &'static str {
        match self {
            Utf16::Little => "UTF-16LE",
            Utf16::Big => "UTF-16BE",
        }
    }

    /// The text without its mark; what is no character is U+FFFD, and so is a byte that is left over.
    fn decoded(self, bytes: &[u8]) -> String {
        let (pairs, rest) = bytes.as_chunks::<2>();
        let units = pairs.iter().map(|pair| match self {
            Utf16::Little => u16::from_le_bytes(*pair),
            Utf16::Big => u16::from_be_bytes(*pair),
        });
        let letters = char::decode_utf16(units).map(|letter| letter.unwrap_or(char::REPLACEMENT_CHARACTER));
        let text: String = letters.chain(rest.first().map(|_| char::REPLACEMENT_CHARACTER)).collect();
        text.strip_prefix(MARK).map(str::to_owned).unwrap_or(text)
    }
}

/// The byte order mark.
const MARK: char = '\u{feff}';

/// Windows-1252 from 0x80 to 0x9f; elsewhere a byte is its letter. Source: the index of the WHATWG's Encoding Standard.
#[rustfmt::skip]
const WINDOWS_1252: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}',
    '\u{90}', '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

fn windows_1252(bytes: &[u8]) -> String {
    let letter = |byte: &u8| match byte {
        0x80..=0x9f => WINDOWS_1252[usize::from(byte - 0x80)],
        _ => char::from(*byte),
    };
    bytes.iter().map(letter).collect()
}

/// The text of a file, and how its bytes were understood if not as UTF-8.
pub(super) fn decoded(bytes: &[u8]) -> Result<(Cow<'_, str>, Option<String>), Refusal> {
    let wide = match bytes {
        [0xff, 0xfe, ..] => Some((Utf16::Little, "")),
        [0xfe, 0xff, ..] => Some((Utf16::Big, "")),
        _ => utf16(bytes).map(|encoding| (encoding, " without a mark")),
    };
    if let Some((encoding, how)) = wide {
        let text = encoding.decoded(bytes);
        refuse_binary(text.as_bytes())?;
        return Ok((text.into(), Some(format!("The file is {}{how}.", encoding.name()))));
    }
    refuse_binary(bytes)?;
    let (rest, marked) = match bytes.strip_prefix(b"\xef\xbb\xbf") {
        Some(rest) => (rest, true),
        None => (bytes, false),
    };
    if let Ok(text) = std::str::from_utf8(rest) {
        return Ok((text.into(), None));
    }
    // Some tools write a UTF-8 mark in front of Latin-1.
    let note = if marked {
        "The file has the mark of UTF-8 and is none: read as Latin-1."
    } else {
        "The file is no UTF-8: read as Latin-1."
    };
    Ok((windows_1252(rest).into(), Some(note.into())))
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
fn utf16(bytes: &[u8]) -> Option<Utf16> {
    let sample = &bytes[..bytes.len().min(1024) & !1];
    if sample.len() < 8 {
        return None;
    }
    let zeros = |offset: usize| sample.iter().skip(offset).step_by(2).filter(|byte| **byte == 0).count();
    let (even, odd, half) = (zeros(0), zeros(1), sample.len() / 2);
    if even * 10 >= half * 9 && odd == 0 {
        Some(Utf16::Big)
    } else if odd * 10 >= half * 9 && even == 0 {
        Some(Utf16::Little)
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::{Utf16, windows_1252};

    #[test]
    fn single_bytes_are_those_of_the_encoding_standard() {
        let all: Vec<u8> = (0..=255).collect();
        let (wanted, _) = encoding_rs::WINDOWS_1252.decode_without_bom_handling(&all);
        assert_eq!(windows_1252(&all), wanted);
    }

    #[test]
    fn pairs_of_bytes_are_those_of_the_encoding_standard() {
        // Marks, characters of one and of two units, halves of such, and a byte that is left over.
        let units: [u16; 12] =
            [0xfeff, 0x41, 0xfeff, 0xd83d, 0xde00, 0xde00, 0xd83d, 0x42, 0xd83d, 0x3b8, 0xfffe, 0xd83d];
        for (encoding, standard) in
            [(Utf16::Little, encoding_rs::UTF_16LE), (Utf16::Big, encoding_rs::UTF_16BE)]
        {
            let each = |unit: &u16| match encoding {
                Utf16::Little => unit.to_le_bytes(),
                Utf16::Big => unit.to_be_bytes(),
            };
            let bytes: Vec<u8> = units.iter().flat_map(each).collect();
            for (from, to) in [(0, 24), (2, 24), (2, 10), (0, 22), (2, 23)] {
                let (wanted, _) = standard.decode_with_bom_removal(&bytes[from..to]);
                assert_eq!(encoding.decoded(&bytes[from..to]), wanted, "{} {from} {to}", encoding.name());
            }
        }
    }
}
