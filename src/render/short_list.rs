//! A list of entries of fixed length while it is filled: what it keeps if there are more.

use core::ops::Range;

use super::entry::{Entry, Order, Place, sort};
use crate::math::keep_rolled;

/// A list that takes entries in any order.
///
/// Of too many it keeps those that begin first, which are all that touch the rows before some
/// row. If more than fit touch even the band, which is the first rows, it keeps those of the band
/// that are drawn first.
pub(super) struct ShortList<'e> {
    entries: &'e mut [Entry],
    count: usize,
    /// The band's rows.
    band: Range<u16>,
    /// Entries that begin here or later are left out.
    end: u16,
    /// Entries up to this one's place are left out.
    after: Option<Place>,
    /// How it is sorted, once it is full.
    sorted: Option<Order>,
}

/// What a list that is filled holds, sorted as it is drawn.
pub(super) struct Listed {
    /// How many entries.
    pub(super) count: usize,
    /// The row before which they are all that there are; the band's first row if they are not
    /// even all of the band.
    pub(super) complete_to: u16,
    /// If they are not all of the band, the place of the last: the rest come after it.
    pub(super) last: Option<Place>,
}

impl<'e> ShortList<'e> {
    /// Of entries that touch the rows from the band's first one to `end`; after some place, of
    /// those that touch the band and come after it.
    pub(super) fn new(
        entries: &'e mut [Entry],
        band: Range<u16>,
        end: u16,
        after: Option<Place>,
    ) -> Self {
        Self {
            entries,
            count: 0,
            end: if after.is_some() { band.end } else { end },
            band,
            after,
            sorted: None,
        }
    }

    /// Puts an entry in if it is wanted.
    pub(super) fn put(&mut self, entry: Entry) {
        let early = self.after.is_some_and(|after| entry.place() <= after);
        if early || !entry.touches(&(self.band.start..self.end)) {
            return;
        }
        match self.entries.get_mut(self.count) {
            Some(slot) => {
                *slot = entry;
                self.count += 1;
            }
            None => self.put_into_full(entry),
        }
    }

    #[cold]
    #[inline(never)]
    fn put_into_full(&mut self, entry: Entry) {
        let order = match (self.sorted, self.after) {
            (Some(order), _) => order,
            (None, None) => self.sort(Order::Rows),
            (None, Some(_)) => self.sort(Order::Drawing),
        };
        let left = displace_last(self.entries, entry, order);
        if order == Order::Drawing {
            return;
        }
        self.end = left.first_row.max(self.band.end);
        if left.first_row < self.band.end {
            // So do all in the list: it is for the band alone from now on.
            let order = self.sort(Order::Drawing);
            displace_last(self.entries, left, order);
        }
    }

    fn sort(&mut self, order: Order) -> Order {
        sort(self.entries, order);
        self.sorted = Some(order);
        order
    }

    /// What it holds in the end.
    pub(super) fn finished(self) -> Listed {
        let list = self.entries.get_mut(..self.count).unwrap_or_default();
        if self.sorted == Some(Order::Drawing) {
            return Listed {
                count: self.count,
                complete_to: self.band.start,
                last: list.last().map(Entry::place),
            };
        }
        sort(list, Order::Drawing);
        Listed {
            count: self.count,
            complete_to: self.end,
            last: None,
        }
    }
}

/// Puts an entry into a full sorted list at its place; gives the last one, which falls out.
#[inline(never)]
fn displace_last(list: &mut [Entry], entry: Entry, order: Order) -> Entry {
    let at = list.partition_point(|held| comes_before(held, &entry, order));
    // Each takes over what stood before it.
    let mut carried = entry;
    for held in list.iter_mut().skip(at) {
        core::mem::swap(held, &mut carried);
        keep_rolled();
    }
    carried
}

/// Whether an entry comes before another. A call, so that a search does not have it twice.
#[inline(never)]
fn comes_before(one: &Entry, other: &Entry, order: Order) -> bool {
    one.key_of(order) < other.key_of(order)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// As many entries as there are rows in `first_rows`, each 10 rows high, near ones last.
    fn filled(length: usize, first_rows: &[u16], after: Option<Place>) -> (Listed, [Entry; 8]) {
        let mut entries = [Entry::EMPTY; 8];
        let list = entries.get_mut(..length).unwrap_or_default();
        let mut list = ShortList::new(list, 16..32, 100, after);
        for (number, first_row) in first_rows.iter().enumerate() {
            list.put(Entry {
                key: number as u32,
                first_row: *first_row,
                end_row: first_row + 10,
                nearness: number as u16,
                ..Entry::EMPTY
            });
        }
        (list.finished(), entries)
    }

    fn keys(list: &Listed, entries: &[Entry; 8]) -> [u32; 8] {
        let mut keys = [u32::MAX; 8];
        for (key, entry) in keys.iter_mut().zip(entries).take(list.count) {
            *key = entry.key;
        }
        keys
    }

    const NO: u32 = u32::MAX;

    #[test]
    fn all_that_fit_are_kept() {
        // The second ends before the band begins.
        let (list, entries) = filled(8, &[20, 5, 90, 40], None);
        assert_eq!(keys(&list, &entries), [3, 2, 0, NO, NO, NO, NO, NO]);
        assert_eq!((list.complete_to, list.last), (100, None));
    }

    #[test]
    fn of_too_many_those_that_begin_first() {
        let (list, entries) = filled(3, &[70, 20, 50, 60, 40], None);
        assert_eq!(keys(&list, &entries), [4, 2, 1, NO, NO, NO, NO, NO]);
        assert_eq!((list.complete_to, list.last), (60, None));
    }

    #[test]
    fn of_too_many_in_a_band_those_drawn_first() {
        let rows = [90, 20, 31, 16, 10, 32];
        let (list, entries) = filled(3, &rows, None);
        assert_eq!(keys(&list, &entries), [4, 3, 2, NO, NO, NO, NO, NO]);
        assert_eq!(list.complete_to, 16);
        let (rest, entries) = filled(3, &rows, list.last);
        assert_eq!(keys(&rest, &entries), [1, NO, NO, NO, NO, NO, NO, NO]);
        assert_eq!(rest.last, None);
    }
}
