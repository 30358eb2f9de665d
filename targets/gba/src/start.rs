//! The cartridge's header (GBATEK, "GBA Cartridge Header"), and the way from it to
//! `main`.

use core::arch::global_asm;

/// The second part of the header. The first part, beside a branch, is the console
/// maker's picture, which is theirs and left empty.
#[used]
#[unsafe(link_section = ".header.game")]
static GAME: [u8; 32] = game(*b"FIXEL\0\0\0\0\0\0\0", *b"BFXE", *b"00");

/// Title, code and maker, a fixed byte, and the checksum over all that.
const fn game(title: [u8; 12], code: [u8; 4], maker: [u8; 2]) -> [u8; 32] {
    let mut header = [0; 32];
    let (mut at, mut sum) = (0, 0x19u8);
    while at < 0x1D {
        header[at] = match at {
            0..12 => title[at],
            12..16 => code[at - 12],
            16..18 => maker[at - 16],
            18 => 0x96,
            _ => 0,
        };
        sum = sum.wrapping_add(header[at]);
        at += 1;
    }
    header[0x1D] = sum.wrapping_neg();
    header
}

// ARM code, as the processor starts; from then on, all is Thumb. Cartridges in use
// since 2001 bear 3 and 1 wait states with prefetch (WAITCNT 0x4317); the reset value
// of 4 and 2 is for the slowest.
global_asm!(
    ".section .header.start, \"ax\", %progbits",
    ".arm",
    ".global _start",
    "_start:",
    "    b 1f",
    "    .space 156",
    ".section .text.start, \"ax\", %progbits",
    ".arm",
    "1:",
    "    msr cpsr_c, #0xDF", // system mode, no interrupts
    "    ldr sp, =_stack_start",
    "    ldr r0, =0x04000204",
    "    ldr r1, =0x4317",
    "    strh r1, [r0]",
    "    ldr r0, =__fast_start",
    "    ldr r1, =__fast_end",
    "    ldr r2, =__fast_load",
    "2:  cmp r0, r1",
    "    ldrlo r3, [r2], #4",
    "    strlo r3, [r0], #4",
    "    blo 2b",
    "    ldr r0, =__data_start",
    "    ldr r1, =__data_end",
    "    ldr r2, =__data_load",
    "5:  cmp r0, r1",
    "    ldrlo r3, [r2], #4",
    "    strlo r3, [r0], #4",
    "    blo 5b",
    "    mov r3, #0",
    "    ldr r0, =__fast_bss_start",
    "    ldr r1, =__fast_bss_end",
    "3:  cmp r0, r1",
    "    strlo r3, [r0], #4",
    "    blo 3b",
    "    ldr r0, =__bss_start",
    "    ldr r1, =__bss_end",
    "4:  cmp r0, r1",
    "    strlo r3, [r0], #4",
    "    blo 4b",
    "    ldr r0, =main",
    "    bx r0",
    "    .ltorg",
    ".thumb",
);
