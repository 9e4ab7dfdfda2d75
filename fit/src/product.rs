//! Products of numbers in texts, formed in decimals: nothing is rounded before the product is read.

/// The product of two decimal texts, exactly, without zeros at its end; none where one of them is no decimal text.
pub(crate) fn product(number: &str, factor: &str) -> Option<String> {
    let ((minus, a, shift), (_, b, by)) = (parts(number)?, parts(factor)?);
    let mut exponent = shift.checked_add(by)?;
    // From the last digit, as on paper.
    let mut sums = vec![0u32; a.len() + b.len() + 1];
    for (i, left) in a.iter().rev().enumerate() {
        let mut carry = 0;
        for (j, right) in b.iter().rev().enumerate() {
            let sum = sums[i + j] + u32::from(*left) * u32::from(*right) + carry;
            (sums[i + j], carry) = (sum % 10, sum / 10);
        }
        sums[i + b.len()] += carry;
    }
    let digits: String = sums.iter().rev().map(|digit| char::from(b'0' + *digit as u8)).collect();
    let mut digits = digits.trim_start_matches('0').to_owned();
    while exponent < 0 && digits.ends_with('0') {
        digits.pop();
        exponent += 1;
    }
    let sign = if minus { "-" } else { "" };
    Some(match usize::try_from(-exponent) {
        _ if digits.is_empty() => format!("{sign}0"),
        Ok(0) => format!("{sign}{digits}"),
        Ok(decimals @ ..=40) => {
            let digits = "0".repeat((decimals + 1).saturating_sub(digits.len())) + &digits;
            let (whole, rest) = digits.split_at(digits.len() - decimals);
            format!("{sign}{whole}.{rest}")
        }
        _ => format!("{sign}{digits}e{exponent}"),
    })
}

/// Sign, digits and exponent of a decimal text: 1.25e-3 is 125 and -5.
fn parts(text: &str) -> Option<(bool, Vec<u8>, i64)> {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (whole, decimals) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = whole.trim_start_matches(['+', '-']).bytes().chain(decimals.bytes());
    let digits: Vec<u8> = digits.map(|digit| digit.wrapping_sub(b'0')).collect();
    let exponent = exponent.parse::<i64>().ok()?.checked_sub(decimals.len() as i64)?;
    digits.iter().all(|digit| *digit < 10).then_some((whole.starts_with('-'), digits, exponent))
}

#[cfg(test)]
mod tests {
    use super::product;

    #[test]
    fn products_are_exact() {
        for (a, b, wanted) in [
            ("3", "20.0", "60"),
            ("0", "33.3", "0"),
            ("-12.5", "8", "-100"),
            ("3", "33.366700033366704", "100.100100100100112"),
            ("1", "0.001", "0.001"),
            ("7", "1.0E2", "70e1"),
            ("0.1", "-0.1", "0.01"),
            ("5", "2e-50", "1e-49"),
        ] {
            assert_eq!(product(a, b).as_deref(), Some(wanted), "{a} {b}");
        }
        assert_eq!([product("a", "1"), product("1", "nan")], [None, None]);
    }
}
