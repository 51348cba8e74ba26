use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::channel;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::Builder;

/// How many results of each thread may wait for an earlier one.
const WINDOW: usize = 32;

/// Who is at work, and on how many threads with which stack.
#[derive(Debug, Clone, Copy)]
pub(super) struct Crew {
    pub(super) threads: usize,
    pub(super) stack: usize,
}

/// How far a crew has come.
#[derive(Debug, Default)]
struct Advance {
    /// The next piece of work.
    next: usize,
    /// The next result to be handed over.
    taken: usize,
}

impl Crew {
    /// Does so many pieces of work on several threads and hands the results over in order, each as
    /// soon as all before it are there; none for work that broke off. Nobody runs far ahead of the
    /// results that are taken, so that few of them are held.
    pub(super) fn in_order<R: Send>(
        self,
        count: usize,
        work: impl Fn(usize) -> R + Sync,
        mut take: impl FnMut(Option<R>),
    ) {
        let threads = self.threads.clamp(1, count.max(1));
        let (advance, moved) = (Mutex::new(Advance::default()), Condvar::new());
        let next = || {
            let mut now = lock(&advance);
            while now.next < count && now.next >= now.taken.saturating_add(WINDOW * threads) {
                now = moved.wait(now).unwrap_or_else(PoisonError::into_inner);
            }
            now.next += 1;
            now.next - 1
        };
        let (sender, receiver) = channel();
        let worker = |sender: std::sync::mpsc::Sender<_>| {
            loop {
                let index = next();
                if index >= count {
                    break;
                }
                let result = catch_unwind(AssertUnwindSafe(|| work(index))).ok();
                if sender.send((index, result)).is_err() {
                    break;
                }
            }
        };
        std::thread::scope(|scope| {
            for _ in 0..threads {
                let (worker, sender) = (&worker, sender.clone());
                // With fewer threads than asked for, the others do their work.
                let _ = Builder::new()
                    .stack_size(self.stack)
                    .spawn_scoped(scope, move || worker(sender));
            }
            drop(sender);
            let (mut early, mut taken) = (BTreeMap::new(), 0);
            for (index, result) in receiver {
                early.insert(index, result);
                while let Some(result) = early.remove(&taken) {
                    take(result);
                    taken += 1;
                    lock(&advance).taken = taken;
                    moved.notify_all();
                }
            }
            for _ in taken..count {
                take(None);
            }
        });
    }
}

fn lock(advance: &Mutex<Advance>) -> MutexGuard<'_, Advance> {
    advance.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    const CREW: Crew = Crew {
        threads: 3,
        stack: 1 << 20,
    };

    #[test]
    fn work_that_breaks_off_is_missed_in_its_place() {
        let mut results = Vec::new();
        let numbers = [4, 0, 2, 1];
        CREW.in_order(4, |own| 8 / numbers[own], |result| results.push(result));
        assert_eq!(results, [Some(2), None, Some(4), Some(8)]);
        CREW.in_order(0, |own| own, |_| results.push(None));
        assert_eq!(results.len(), 4);
    }

    #[test]
    fn nobody_runs_far_ahead() {
        let taken = Mutex::new(0);
        let read = || *taken.lock().unwrap_or_else(PoisonError::into_inner);
        let work = |own: usize| own.saturating_sub(read());
        let mut furthest = 0;
        let mut results = 0;
        CREW.in_order(2_000, work, |ahead| {
            furthest = furthest.max(ahead.unwrap_or(usize::MAX));
            results += 1;
            *taken.lock().unwrap_or_else(PoisonError::into_inner) = results;
        });
        assert_eq!(results, 2_000);
        // One result may be on its way between both counts.
        assert!(furthest <= 3 * WINDOW + 1, "{furthest}");
    }
}
