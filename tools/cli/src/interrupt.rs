//! Ctrl-C takes the temporary file away and then ends the program as it always does.

use signal_hook::consts::SIGINT;
use signal_hook::iterator::Signals;
use signal_hook::low_level::emulate_default_handler;

/// Waits for it in a thread of its own; without one, a temporary file may stay.
pub fn listen() {
    let Ok(mut signals) = Signals::new([SIGINT]) else {
        return;
    };
    std::thread::spawn(move || {
        for signal in signals.forever() {
            fixel_output::stop();
            // It does not come back from this one.
            let _ = emulate_default_handler(signal);
        }
    });
}
