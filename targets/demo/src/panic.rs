//! What the linker asks for. Firmware that only draws cannot panic, so the handler is not
//! linked, which is checked in the ELF file.

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
