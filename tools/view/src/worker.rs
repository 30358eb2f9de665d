//! A thread that loads and draws, so that the window stays alive.

use std::path::PathBuf;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;

use crate::draw::{Drawer, Picture};
use crate::source::{Loader, Source};
use crate::variant::{Job, Renderer};

/// What comes back.
#[derive(Debug)]
pub enum Reply {
    /// A picture; of slow renderers several, each finer than the last.
    Picture(Box<Picture>),
    /// Why there is none for this job.
    Failed(Box<Job>, String),
    /// The file, loaded anew.
    Loaded(Result<Arc<Source>, String>),
}

/// What is to be done: the last job asked for, and whether to load.
#[derive(Default)]
struct Orders {
    job: Option<Job>,
    load: bool,
    end: bool,
}

#[derive(Default)]
struct Desk {
    orders: Mutex<Orders>,
    changed: Condvar,
}

impl Desk {
    fn open(&self) -> MutexGuard<'_, Orders> {
        // Orders are whole at every moment.
        self.orders.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn change(&self, change: impl FnOnce(&mut Orders)) {
        change(&mut self.open());
        self.changed.notify_one();
    }
}

/// The thread; it ends some time after this is dropped.
pub struct Worker {
    desk: Arc<Desk>,
}

impl Worker {
    /// `reply` is called on the thread.
    pub fn start(path: PathBuf, load: Loader, reply: impl Fn(Reply) + Send + 'static) -> Self {
        let desk = Arc::new(Desk::default());
        let own = Arc::clone(&desk);
        thread::spawn(move || work(&own, &path, &load, &reply));
        Self { desk }
    }

    /// Asks for a picture; earlier jobs are forgotten.
    pub fn draw(&self, job: Job) {
        self.desk.change(|orders| orders.job = Some(job));
    }

    /// Asks for the file.
    pub fn load(&self) {
        self.desk.change(|orders| orders.load = true);
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        self.desk.change(|orders| orders.end = true);
    }
}

fn work(desk: &Desk, path: &std::path::Path, load: &Loader, reply: &impl Fn(Reply)) {
    let mut drawer = Drawer::default();
    loop {
        let mut orders = desk.open();
        while !(orders.end || orders.load || orders.job.is_some()) {
            let woken = desk.changed.wait(orders);
            orders = woken.unwrap_or_else(PoisonError::into_inner);
        }
        if orders.end {
            return;
        }
        let loading = std::mem::take(&mut orders.load);
        let job = orders.job.take();
        drop(orders);
        if loading {
            reply(Reply::Loaded(load(path)));
        }
        if let Some(job) = job {
            draw(desk, &mut drawer, &job, reply);
        }
    }
}

fn draw(desk: &Desk, drawer: &mut Drawer, job: &Job, reply: &impl Fn(Reply)) {
    for step in steps(job.renderer) {
        match drawer.draw(job, *step) {
            Ok(picture) => reply(Reply::Picture(Box::new(picture))),
            Err(error) => {
                reply(Reply::Failed(Box::new(job.clone()), error));
                return;
            }
        }
        // Somebody wants to see something else by now.
        if desk.open().job.is_some() {
            return;
        }
    }
}

/// What is slow is drawn coarsely first.
fn steps(renderer: Renderer) -> &'static [u32] {
    match renderer {
        Renderer::Raster => &[1],
        _ => &[4, 2, 1],
    }
}
