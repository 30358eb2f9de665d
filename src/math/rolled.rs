//! A word to the compiler about loops.

/// Keeps the compiler from unrolling a loop: where it runs two or three times, what goes
/// before an unrolled one costs more than the loop; and what is done once an actor shall
/// not be there three times.
#[inline(always)]
pub(crate) fn keep_rolled() {
    core::hint::black_box(());
}

/// A list whose length the compiler does not know, so that it does not write a short loop
/// over it out as a whole, which it does in spite of [`keep_rolled`]; that has to be in the loop as well.
#[inline(always)]
pub(crate) fn rolled<T>(list: &mut [T]) -> &mut [T] {
    core::hint::black_box(list)
}
