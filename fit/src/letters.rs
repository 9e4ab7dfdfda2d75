//! Letters in lower case. On a page only those of Latin, Greek and Cyrillic texts have one, by rules of their own: the standard library's
//! table of all is 7 kB to load.

/// What a page loads is short.
const COMPACT: bool = cfg!(target_arch = "wasm32");

/// A text in lower case.
pub(crate) fn lower(text: &str) -> String {
    if COMPACT { text.chars().map(lowered).collect() } else { text.to_lowercase() }
}

/// A letter in lower case. The dotted capital I of Turkish has no dot over its dot, and a sigma at the end of a word is as any other.
fn lowered(letter: char) -> char {
    let code = u32::from(letter);
    let pairs_from = |first: u32| code + u32::from(code % 2 == first % 2);
    let lower = match code {
        0x41..=0x5a | 0xc0..=0xd6 | 0xd8..=0xde | 0x391..=0x3a1 | 0x3a3..=0x3ab | 0x410..=0x42f => {
            code + 0x20
        }
        0x130 | 0x212a => 0x69 + u32::from(code > 0x130) * 2,
        0x100..=0x12f | 0x132..=0x137 | 0x14a..=0x177 | 0x460..=0x481 | 0x48a..=0x4bf | 0x4d0..=0x52f => {
            pairs_from(0)
        }
        0x139..=0x148 | 0x179..=0x17e | 0x4c1..=0x4ce => pairs_from(1),
        0x1e00..=0x1e95 | 0x1ea0..=0x1eff => pairs_from(0),
        0x178 => 0xff,
        0x386 => 0x3ac,
        0x388..=0x38a => code + 37,
        0x38c => 0x3cc,
        0x38e | 0x38f => code + 63,
        0x400..=0x40f => code + 0x50,
        0x4c0 => 0x4cf,
        0x2126 => 0x3c9,
        0x212b => 0xe5,
        _ => code,
    };
    char::from_u32(lower).unwrap_or(letter)
}

#[cfg(test)]
mod tests {
    use super::lowered;

    #[test]
    fn letters_of_europe_are_those_of_the_standard_library() {
        let blocks =
            [0..=0x17f, 0x380..=0x3ce, 0x400..=0x52f, 0x1e00..=0x1e95, 0x1ea0..=0x1eff, 0x2000..=0x2131];
        let mut changed = 0;
        for each in blocks.into_iter().flatten().filter_map(char::from_u32) {
            let mut wanted = each.to_lowercase();
            assert_eq!(Some(lowered(each)), wanted.next(), "{each} {:x}", u32::from(each));
            assert!(wanted.next().is_none() || each == 'İ');
            changed += usize::from(lowered(each) != each);
        }
        assert!(changed > 400, "{changed}");
        // No other letter becomes something that the library does not make of it.
        for each in (0..0x11_0000).filter_map(char::from_u32) {
            assert!(lowered(each) == each || Some(lowered(each)) == each.to_lowercase().next(), "{each}");
        }
    }
}
