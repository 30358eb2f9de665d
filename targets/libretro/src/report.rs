//! The block that a program keeps at the start of its RAM; `targets/gba` writes it.

/// Where the block is, and its bytes.
pub const ADDRESS: usize = 0x0200_0000;
/// See there.
pub const LENGTH: usize = 8192;

/// What it says.
#[derive(Debug, PartialEq, Eq)]
pub struct Report {
    /// How far the program is.
    pub state: State,
    /// Pictures shown since its start.
    pub pictures: u32,
    /// What it has printed.
    pub text: String,
}

/// How far a program is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum State {
    /// It runs.
    Runs,
    /// It has ended well.
    Ended,
    /// It has failed.
    Failed,
}

impl Report {
    /// `None` before the program has begun.
    pub fn read(memory: &[u8]) -> Option<Self> {
        let word = |at: usize| {
            let bytes = memory.get(at..at + 4)?.try_into().ok()?;
            Some(u32::from_le_bytes(bytes))
        };
        if memory.get(..4)? != b"FXLR" {
            return None;
        }
        let state = match word(4)? {
            0 => State::Runs,
            1 => State::Ended,
            _ => State::Failed,
        };
        let text = memory.get(16..16 + word(12)? as usize)?;
        Some(Self {
            state,
            pictures: word(8)?,
            text: String::from_utf8_lossy(text).into_owned(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_report() {
        let bytes = b"FXLR\x02\0\0\0\x07\0\0\0\x05\0\0\0panic and more";
        let expected = Report {
            state: State::Failed,
            pictures: 7,
            text: "panic".into(),
        };
        assert_eq!(Report::read(bytes), Some(expected));
        assert_eq!(Report::read(&[0; 64]), None);
        assert_eq!(Report::read(&bytes[..18]), None);
    }
}
