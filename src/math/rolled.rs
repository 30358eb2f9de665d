//! A word to the compiler about loops.

/// Keeps the compiler from unrolling a loop: where it runs two or three times, what goes
/// before an unrolled one costs more than the loop; and what is done once an actor shall
/// not be there three times.
#[inline(always)]
pub(crate) fn keep_rolled() {
    core::hint::black_box(());
}
