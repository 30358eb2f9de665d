//! Emulators, and builds of firmware, which take one processor each, run side by side.

use std::sync::Mutex;
use std::thread;

use crate::report::Tally;

/// Applies `work` to every item, several at a time; results in the items'
/// order.
pub fn map<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let threads = thread::available_parallelism().map_or(1, |count| count.get());
    let queue = Mutex::new(items.iter().enumerate());
    let done = Mutex::new(Vec::with_capacity(items.len()));
    thread::scope(|scope| {
        for _ in 0..threads.min(items.len()) {
            scope.spawn(|| {
                loop {
                    let next = queue.lock().ok().and_then(|mut queue| queue.next());
                    let Some((place, item)) = next else { break };
                    let result = work(item);
                    if let Ok(mut done) = done.lock() {
                        done.push((place, result));
                    }
                }
            });
        }
    });
    let mut done = done.into_inner().unwrap_or_default();
    done.sort_by_key(|(place, _)| *place);
    done.into_iter().map(|(_, result)| result).collect()
}

/// Makes checks of every item, several at a time; they are counted in the items' order.
pub fn check<T: Sync, R: Send>(
    tally: &mut Tally,
    items: &[T],
    work: impl Fn(&T, &mut Tally) -> R + Sync,
) -> Vec<R> {
    let done = map(items, |item| {
        let mut own = Tally::default();
        (work(item, &mut own), own)
    });
    let counted = done.into_iter().map(|(result, own)| {
        tally.add(own);
        result
    });
    counted.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn checks_are_counted_in_order() {
        let mut tally = Tally::default();
        let items = ["a", "b", "c", "d"];
        let results = check(&mut tally, &items, |item, tally| {
            let result = if *item == "b" {
                Ok(())
            } else {
                Err("wrong".into())
            };
            tally.check(item, result).is_some()
        });
        assert_eq!(results, [false, true, false, false]);
        assert_eq!(
            (tally.passed, tally.failed),
            (1, vec!["a".into(), "c".into(), "d".into()])
        );
    }

    #[test]
    fn results_keep_their_order() {
        let items: Vec<u64> = (0..100).collect();
        let squares = map(&items, |&n| n * n);
        assert_eq!(squares, items.iter().map(|n| n * n).collect::<Vec<_>>());
    }
}
