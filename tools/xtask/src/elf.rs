//! What a linked firmware holds: its sizes, and whether it keeps the promises
//! that fixel makes about it.

use std::fs;
use std::path::Path;

use object::read::elf::{ElfFile32, ProgramHeader};
use object::{Endianness, Object, ObjectSection, ObjectSymbol, SectionFlags, SectionKind, elf};

/// The linked scene's symbol, in `targets/*/src/bin/demo.rs`.
const SCENE_SYMBOL: &str = "FIXEL_SCENE";

/// Sizes and symbols of an ELF file.
#[derive(Clone, Debug, Default)]
pub struct Image {
    /// Bytes of flash: code, constants, and the initial values of statics.
    pub flash_bytes: u64,
    /// Bytes of statics, initialised or zero.
    pub static_ram_bytes: u64,
    /// Those of them that are not zero at the start, and are in flash for that.
    pub initialised_bytes: u64,
    /// Bytes of the scene linked in; they are part of the flash.
    pub scene_bytes: u64,
    /// Names of everything linked in.
    pub symbols: Vec<String>,
}

impl Image {
    /// Reads an ELF file.
    pub fn read(path: &Path) -> Result<Self, String> {
        let fail = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
        let bytes = fs::read(path).map_err(|error| fail(&error))?;
        let file = object::File::parse(bytes.as_slice()).map_err(|error| fail(&error))?;
        let mut image = Self::default();
        for section in file.sections() {
            let SectionFlags::Elf { sh_flags, .. } = section.flags() else {
                return Err(fail(&"not an ELF file"));
            };
            let name = section.name().map_err(|error| fail(&error))?;
            let allocated = sh_flags & elf::SHF_ALLOC == elf::SHF_ALLOC;
            let writable = sh_flags & elf::SHF_WRITE == elf::SHF_WRITE;
            // These stand for what is left of the RAM, not for what is used.
            let fictitious = [".stack", ".heap"].contains(&name);
            if !allocated || fictitious {
                continue;
            }
            let zero = section.kind() == SectionKind::UninitializedData;
            if !zero {
                image.flash_bytes += section.size();
            }
            if zero || writable {
                image.static_ram_bytes += section.size();
            }
            if writable && !zero {
                image.initialised_bytes += section.size();
            }
        }
        for symbol in file.symbols().filter(|symbol| symbol.is_definition()) {
            let Ok(name) = symbol.name() else { continue };
            if name == SCENE_SYMBOL {
                image.scene_bytes = symbol.size();
            }
            image.symbols.push(name.to_owned());
        }
        if image.symbols.is_empty() {
            return Err(fail(&"no symbols, so nothing can be checked"));
        }
        Ok(image)
    }

    /// Bytes of flash without the scene.
    pub fn code_bytes(&self) -> u64 {
        self.flash_bytes - self.scene_bytes
    }
}

/// What a program loads, as one piece that begins at `start`: what is to be in flash or
/// in a cartridge.
pub fn flat(path: &Path, start: u32) -> Result<Vec<u8>, String> {
    let fail = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
    let bytes = fs::read(path).map_err(|error| fail(&error))?;
    let file = ElfFile32::<Endianness>::parse(bytes.as_slice()).map_err(|error| fail(&error))?;
    let mut image = Vec::new();
    for segment in file.elf_program_headers() {
        let data = segment.data(file.endian(), bytes.as_slice());
        let data = data.map_err(|()| fail(&"a part is missing"))?;
        if segment.p_type.get(file.endian()) != elf::PT_LOAD || data.is_empty() {
            continue;
        }
        let address = segment.p_paddr.get(file.endian());
        let at = address.checked_sub(start).ok_or(fail(&"it begins lower"))? as usize;
        if image.len() < at + data.len() {
            image.resize(at + data.len(), 0);
        }
        image[at..at + data.len()].copy_from_slice(data);
    }
    Ok(image)
}

/// What must not be in a firmware that draws with fixel.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Broken {
    /// It could panic.
    pub panics: Vec<String>,
    /// It calculates in floating point.
    pub floats: Vec<String>,
    /// It allocates.
    pub allocations: Vec<String>,
}

/// Looks for symbols that show a broken promise.
pub fn broken<'a>(symbols: impl IntoIterator<Item = &'a str>) -> Broken {
    let mut broken = Broken::default();
    for name in symbols {
        if is_panic(name) {
            broken.panics.push(name.to_owned());
        } else if is_float(name) {
            broken.floats.push(name.to_owned());
        } else if is_allocation(name) {
            broken.allocations.push(name.to_owned());
        }
    }
    broken
}

/// `core::panicking` and the panic handler's entry, mangled either way.
fn is_panic(name: &str) -> bool {
    name.contains("4core9panicking") || name.contains("rust_begin_unwind")
}

/// Run-time library functions on `float` and `double`: Arm's names (Run-time
/// ABI for the Arm Architecture, 5.1.2), and GCC's, which RISC-V uses.
fn is_float(name: &str) -> bool {
    if let Some(arm) = name.strip_prefix("__aeabi_") {
        let from_integer = ["i2f", "i2d", "ui2f", "ui2d", "l2f", "l2d", "ul2f", "ul2d"];
        let float = |prefix: &str| {
            let rest = arm.strip_prefix(prefix);
            rest.is_some_and(|rest| {
                let rest = rest.trim_start_matches('r');
                let operations = ["add", "sub", "mul", "div", "neg", "cmp", "2"];
                operations
                    .iter()
                    .any(|operation| rest.starts_with(operation))
            })
        };
        let compare = arm.starts_with("cf") || arm.starts_with("cd");
        return float("f") || float("d") || compare || from_integer.contains(&arm);
    }
    let Some(gcc) = name.strip_prefix("__") else {
        return false;
    };
    let operations = [
        "add", "sub", "mul", "div", "neg", "pow", "eq", "ne", "ge", "gt", "le", "lt", "unord",
        "fix", "float", "extend", "trunc",
    ];
    let on_float = [
        "sf2", "df2", "sf3", "df3", "sf", "df", "sfsi", "dfsi", "sfdi", "dfdi",
    ];
    operations.iter().any(|operation| {
        let rest = gcc.strip_prefix(operation);
        rest.is_some_and(|rest| on_float.iter().any(|suffix| rest.ends_with(suffix)))
    })
}

/// The allocator's entry points, or anything of the crate `alloc`.
fn is_allocation(name: &str) -> bool {
    let parts = [
        "__rust_alloc",
        "__rust_realloc",
        "__rdl_alloc",
        "__rg_alloc",
        "5alloc5alloc",
    ];
    parts.iter().any(|part| name.contains(part)) || name == "malloc"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_promise_can_be_seen_broken() {
        let found = broken([
            "_ZN4core9panicking5panic17h0123456789abcdefE",
            "_RNvNtCs1234_4core9panicking18panic_bounds_check",
            "__aeabi_fadd",
            "__aeabi_dmul",
            "__aeabi_frsub",
            "__aeabi_ui2f",
            "__aeabi_f2iz",
            "__aeabi_cdcmple",
            "__adddf3",
            "__floatunsisf",
            "__fixsfsi",
            "__extendsfdf2",
            "__rust_alloc",
        ]);
        assert_eq!(found.panics.len(), 2, "{found:?}");
        assert_eq!(found.floats.len(), 10, "{found:?}");
        assert_eq!(found.allocations.len(), 1, "{found:?}");
    }

    #[test]
    fn integers_break_nothing() {
        let found = broken([
            "main",
            "Reset",
            "__aeabi_idiv",
            "__aeabi_uidivmod",
            "__aeabi_lmul",
            "__aeabi_ldivmod",
            "__aeabi_memcpy4",
            "__aeabi_memclr",
            "__muldi3",
            "__divsi3",
            "__udivdi3",
            "__lshrdi3",
            "_ZN5fixel6render12render_frame17h0123456789abcdefE",
        ]);
        assert_eq!(found, Broken::default());
    }
}
