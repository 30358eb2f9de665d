//! Goes through a script without a window.

use std::sync::mpsc;
use std::time::Duration;

use crate::frame::{self, Look};
use crate::view::{Going, Start, View};

/// Goes through a script without a window.
///
/// # Errors
/// If a picture cannot be written.
pub fn run(start: Start) -> Result<(), String> {
    let (to, replies) = mpsc::channel();
    // Nobody listens any more when the script is at its end.
    let reply = move |reply| drop(to.send(reply));
    let zoom = start.zoom;
    let mut look = Look {
        size: frame::wanted(start.state.size(), 1, zoom.unwrap_or(2)),
        scale: 1,
        zoom,
    };
    let mut view = View::new(start, reply);
    loop {
        match view.go_on(&look)? {
            Some(Going::Ends) | None => return Ok(()),
            Some(Going::Waits) => {}
        }
        let reply = replies.recv_timeout(Duration::from_secs(120));
        view.receive(reply.map_err(|_| "no picture in two minutes")?);
        look.size = frame::wanted(view.state.size(), 1, zoom.unwrap_or(2));
    }
}
