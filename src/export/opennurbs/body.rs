use crate::export::Double;

/// Set in the type of a chunk that ends with a checksum of its own bytes.
const CHECKED: u32 = 0x8000;
/// Set in the type of a chunk that is a number and nothing more.
const SHORT: u32 = 0x8000_0000;

/// The content of a chunk: bytes of its own, and chunks in it.
///
/// Integers and doubles are little-endian. The checksum is the CRC-32 of the bytes of its own;
/// chunks within have their own.
#[derive(Debug, Default)]
pub(super) struct Body {
    bytes: Vec<u8>,
    checksum: crc32fast::Hasher,
}

impl Body {
    /// Everything, as it goes into the file.
    pub(super) fn into_bytes(self) -> Vec<u8> {
        self.bytes
    }

    /// The number of bytes.
    pub(super) fn length(&self) -> usize {
        self.bytes.len()
    }

    /// Appends bytes.
    pub(super) fn bytes(&mut self, bytes: &[u8]) {
        self.bytes.extend_from_slice(bytes);
        self.checksum.update(bytes);
    }

    /// Appends an integer of four bytes.
    pub(super) fn integer(&mut self, value: u32) {
        self.bytes(&value.to_le_bytes());
    }

    /// Appends a number of items, in four bytes.
    pub(super) fn count(&mut self, value: usize) {
        self.integer(u32::try_from(value).unwrap_or(u32::MAX));
    }

    /// Appends a double.
    pub(super) fn double(&mut self, value: Double) {
        self.bytes(&value.value().to_le_bytes());
    }

    /// Appends a text: the number of its units in UTF-16 with the closing 0, and these.
    pub(super) fn text(&mut self, text: &str) {
        let mut units: Vec<u16> = text.encode_utf16().collect();
        if !units.is_empty() {
            units.push(0);
        }
        self.count(units.len());
        for unit in units {
            self.bytes(&unit.to_le_bytes());
        }
    }

    /// Appends a chunk: its type, its length, its content, and its checksum if the type asks for
    /// one.
    pub(super) fn chunk(&mut self, kind: u32, mut content: Self) {
        if kind & CHECKED != 0 {
            let checksum = content.checksum.clone().finalize();
            content.bytes.extend_from_slice(&checksum.to_le_bytes());
        }
        let length = u32::try_from(content.bytes.len()).unwrap_or(u32::MAX);
        self.bytes.extend_from_slice(&kind.to_le_bytes());
        self.bytes.extend_from_slice(&length.to_le_bytes());
        self.bytes.append(&mut content.bytes);
    }

    /// Appends a chunk that is a number.
    pub(super) fn short(&mut self, kind: u32, value: u32) {
        self.bytes.extend_from_slice(&(kind | SHORT).to_le_bytes());
        self.bytes.extend_from_slice(&value.to_le_bytes());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_checksum_is_that_of_the_own_bytes() {
        let mut inner = Body::default();
        inner.bytes(b"inner");
        let mut outer = Body::default();
        outer.bytes(b"1234");
        outer.chunk(1, inner);
        outer.bytes(b"56789");
        let mut file = Body::default();
        file.chunk(CHECKED, outer);
        let bytes = file.into_bytes();
        assert_eq!(&bytes[..8], [0, 0x80, 0, 0, 26, 0, 0, 0]);
        // the check value of CRC-32 for 123456789
        assert_eq!(&bytes[bytes.len() - 4..], 0xCBF4_3926_u32.to_le_bytes());
    }

    #[test]
    fn texts_are_utf_16() {
        let mut body = Body::default();
        body.text("σ");
        body.text("");
        assert_eq!(body.into_bytes(), [2, 0, 0, 0, 0xC3, 3, 0, 0, 0, 0, 0, 0]);
    }
}
