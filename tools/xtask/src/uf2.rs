//! UF2, the format that the RP2040's boot ROM takes on its drive: blocks of 512 bytes with 256
//! bytes of flash each (<https://github.com/microsoft/uf2>).

use std::collections::BTreeMap;

use object::LittleEndian;
use object::elf::{FileHeader32, PT_LOAD};
use object::read::elf::{ElfFile, ProgramHeader};

const MAGIC: [u32; 2] = [0x0A32_4655, 0x9E5D_5157];
const MAGIC_END: u32 = 0x0AB1_6F30;
/// The word after the flags names the chip.
const FLAG_FAMILY: u32 = 0x2000;
const RP2040: u32 = 0xE48B_FF56;
const PAGE: u32 = 256;
const FLASH: std::ops::Range<u32> = 0x1000_0000..0x1100_0000;

/// What an ELF file loads into flash, as a UF2 file. Parts of pages that it leaves out are 0.
pub fn from_elf(bytes: &[u8]) -> Result<Vec<u8>, String> {
    let pages = pages(bytes)?;
    let count = pages.len() as u32;
    let mut out = Vec::with_capacity(pages.len() * 512);
    for (number, (address, page)) in (0..).zip(&pages) {
        let head = [
            MAGIC[0],
            MAGIC[1],
            FLAG_FAMILY,
            *address,
            PAGE,
            number,
            count,
            RP2040,
        ];
        out.extend(head.iter().flat_map(|word| word.to_le_bytes()));
        out.extend(page);
        out.resize(out.len() + 476 - page.len(), 0);
        out.extend(MAGIC_END.to_le_bytes());
    }
    Ok(out)
}

/// Pages of flash by address.
fn pages(bytes: &[u8]) -> Result<BTreeMap<u32, [u8; PAGE as usize]>, String> {
    type Elf<'a> = ElfFile<'a, FileHeader32<LittleEndian>>;
    let file: Elf = ElfFile::parse(bytes).map_err(|error| error.to_string())?;
    let mut pages = BTreeMap::new();
    for header in file.elf_program_headers() {
        let endian = LittleEndian;
        let data = header
            .data(endian, bytes)
            .map_err(|()| "a segment is past the file's end")?;
        if header.p_type(endian) != PT_LOAD || data.is_empty() {
            continue;
        }
        let from = header.p_paddr(endian);
        let ends = u32::try_from(data.len()).is_ok_and(|size| size <= FLASH.end - FLASH.start);
        if !FLASH.contains(&from) || !ends {
            return Err(format!("a segment at {from:#010x} is not in flash"));
        }
        for (address, byte) in (from..).zip(data) {
            let page = pages
                .entry(address / PAGE * PAGE)
                .or_insert([0; PAGE as usize]);
            page[(address % PAGE) as usize] = *byte;
        }
    }
    if pages.is_empty() {
        return Err("nothing goes into flash".into());
    }
    Ok(pages)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An ELF file of one segment.
    fn elf(address: u32, data: &[u8]) -> Vec<u8> {
        let mut bytes = vec![0x7F, b'E', b'L', b'F', 1, 1, 1];
        bytes.resize(16, 0);
        let halves = |bytes: &mut Vec<u8>, all: &[u16]| {
            bytes.extend(all.iter().flat_map(|half| half.to_le_bytes()));
        };
        let words = |bytes: &mut Vec<u8>, all: &[u32]| {
            bytes.extend(all.iter().flat_map(|word| word.to_le_bytes()));
        };
        halves(&mut bytes, &[2, 40]);
        words(&mut bytes, &[1, 0, 52, 0, 0]);
        halves(&mut bytes, &[52, 32, 1, 0, 0, 0]);
        let size = data.len() as u32;
        // In RAM it is somewhere else.
        words(&mut bytes, &[1, 84, 0x2000_0000, address, size, size, 5, 4]);
        bytes.extend(data);
        bytes
    }

    fn word(block: &[u8], at: usize) -> u32 {
        u32::from_le_bytes([0, 1, 2, 3].map(|i| block[at * 4 + i]))
    }

    #[test]
    fn blocks_hold_pages_in_order() {
        let data: Vec<u8> = (0..300).map(|i| i as u8 | 1).collect();
        let uf2 = from_elf(&elf(0x1000_00F0, &data)).unwrap_or_default();
        assert_eq!(uf2.len(), 3 * 512);
        for (number, block) in uf2.chunks(512).enumerate() {
            assert_eq!([word(block, 0), word(block, 1)], MAGIC);
            assert_eq!(word(block, 3), 0x1000_0000 + 256 * number as u32);
            assert_eq!(word(block, 5), number as u32);
            assert_eq!((word(block, 6), word(block, 127)), (3, MAGIC_END));
        }
        let flash: Vec<u8> = uf2.chunks(512).flat_map(|b| b[32..288].to_vec()).collect();
        assert_eq!(flash[0xF0..0xF0 + 300], data);
        assert!(
            flash[..0xF0]
                .iter()
                .chain(&flash[0xF0 + 300..])
                .all(|b| *b == 0)
        );
    }

    #[test]
    fn what_is_not_for_flash_is_refused() {
        assert!(from_elf(&elf(0x2000_0000, &[1])).is_err());
        assert!(from_elf(&elf(0x1000_0000, &[])).is_err());
        assert!(from_elf(b"no").is_err());
    }
}
