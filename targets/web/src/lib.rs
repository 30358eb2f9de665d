//! The module behind the page: `page/worker.js` calls [`Session`] through it.
//!
//! The page asks for room, writes into it, and calls [`call`]; then it reads
//! the answer where [`text`] and [`bytes`] say. There is one thread, and nothing is called
//! while something else is.

use std::cell::RefCell;
use std::panic;

use fixel_simulator::{Answer, Session};

#[cfg(target_arch = "wasm32")]
#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// Takes a message: the module has failed, and is of no use any more.
    fn failed(text: *const u8, length: usize);
}

thread_local! {
    static SESSION: RefCell<Session> = RefCell::new(Session::default());
    static ROOM: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static ANSWER: RefCell<Answer> = RefCell::new(Answer::default());
}

/// Makes a failure of the module known to the page. To be called first.
#[unsafe(no_mangle)]
pub extern "C" fn start() {
    panic::set_hook(Box::new(|info| tell(&info.to_string())));
}

#[cfg(target_arch = "wasm32")]
fn tell(message: &str) {
    // SAFETY: the page only reads the text, before this returns.
    unsafe { failed(message.as_ptr(), message.len()) }
}

#[cfg(not(target_arch = "wasm32"))]
fn tell(message: &str) {
    eprintln!("{message}");
}

/// Where the page puts `length` bytes of input for the next [`call`].
#[unsafe(no_mangle)]
pub extern "C" fn room(length: usize) -> *mut u8 {
    ROOM.with_borrow_mut(|room| {
        room.clear();
        room.resize(length, 0);
        room.as_mut_ptr()
    })
}

/// Does what is asked for, one of [`Session::call`]'s numbers, with what lies in the room.
/// Gives 1 if that went well, 0 if the answer says what is wrong.
#[unsafe(no_mangle)]
pub extern "C" fn call(what: u32) -> u32 {
    let input = ROOM.take();
    let answer = SESSION.with_borrow_mut(|session| session.call(what, &input));
    let done = u32::from(answer.done);
    ANSWER.set(answer);
    done
}

/// The answer's text, in UTF-8.
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    ANSWER.with_borrow(|answer| answer.text.as_ptr())
}

/// How many bytes the answer's text has.
#[unsafe(no_mangle)]
pub extern "C" fn text_length() -> usize {
    ANSWER.with_borrow(|answer| answer.text.len())
}

/// The answer's bytes.
#[unsafe(no_mangle)]
pub extern "C" fn bytes() -> *const u8 {
    ANSWER.with_borrow(|answer| answer.bytes.as_ptr())
}

/// How many bytes the answer has beside its text.
#[unsafe(no_mangle)]
pub extern "C" fn bytes_length() -> usize {
    ANSWER.with_borrow(|answer| answer.bytes.len())
}
