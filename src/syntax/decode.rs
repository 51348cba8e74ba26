use crate::diag::{Code, Diagnostic, Limits};

/// The text of a source file, byte for byte; a byte-order mark is kept, so that offsets stay true.
///
/// `name` is the name that messages show. The diagnostic has no place in a source: there is none.
///
/// - **errors** E0001 (not UTF-8), E0501 (larger than `limits.source`)
///
/// # Errors
///
/// One diagnostic; nothing of the file can be used.
///
/// ```
/// use sweepc::diag::{Code, Limits};
/// let limits = Limits::default();
/// assert_eq!(sweepc::syntax::decode(b"unit mm", "a.sweep", &limits).unwrap(), "unit mm");
/// let refused = sweepc::syntax::decode(b"unit \xff", "a.sweep", &limits).unwrap_err();
/// assert_eq!(refused.code, Code::E0001);
/// ```
pub fn decode(bytes: &[u8], name: &str, limits: &Limits) -> Result<String, Box<Diagnostic>> {
    let largest = limits.largest_source();
    if bytes.len() > largest {
        let message = format!("`{name}` has {} bytes, the limit is {largest}", bytes.len());
        return Err(Box::new(
            Diagnostic::global(Code::E0501, message).help("`--max-source` raises the limit"),
        ));
    }
    if looks_like_utf16(bytes) {
        let message = format!("`{name}` looks like UTF-16");
        return Err(Box::new(
            Diagnostic::global(Code::E0001, message).help("save the file as UTF-8"),
        ));
    }
    match std::str::from_utf8(bytes) {
        Ok(text) => Ok(text.to_owned()),
        Err(error) => {
            let offset = error.valid_up_to();
            let message = format!("`{name}` is not UTF-8 text: invalid at byte {offset}");
            let line = bytes[..offset]
                .iter()
                .filter(|byte| **byte == b'\n')
                .count()
                + 1;
            Err(Box::new(
                Diagnostic::global(Code::E0001, message)
                    .note(format!("byte 0x{:02X} in line {line}", bytes[offset]))
                    .help("save the file as UTF-8"),
            ))
        }
    }
}

/// A UTF-16 byte-order mark, or a zero in every second byte of a text that is mostly ASCII.
fn looks_like_utf16(bytes: &[u8]) -> bool {
    if bytes.starts_with(&[0xFF, 0xFE]) || bytes.starts_with(&[0xFE, 0xFF]) {
        return true;
    }
    let start = &bytes[..bytes.len().min(256)];
    let pairs = start.len() / 2;
    let zeros = |parity: usize| {
        let places = start.iter().skip(parity).step_by(2);
        places.filter(|byte| **byte == 0).count()
    };
    let (even, odd) = (zeros(0), zeros(1));
    pairs >= 2 && even.max(odd) * 4 >= pairs * 3 && even.min(odd) == 0
}
