use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::channel;
use std::thread::Builder;

/// Works on items on several threads and hands the results over in the order of the items, each as
/// soon as all before it are there; none for work that broke off.
pub(super) fn in_order<T: Sync, R: Send>(
    items: &[T],
    threads: usize,
    stack: usize,
    work: impl Fn(&T) -> R + Sync,
    mut take: impl FnMut(Option<R>),
) {
    let next = AtomicUsize::new(0);
    let (sender, receiver) = channel();
    let worker = |sender: std::sync::mpsc::Sender<_>| {
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(item) = items.get(index) else {
                break;
            };
            let result = catch_unwind(AssertUnwindSafe(|| work(item))).ok();
            if sender.send((index, result)).is_err() {
                break;
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..threads.clamp(1, items.len().max(1)) {
            let (worker, sender) = (&worker, sender.clone());
            // With fewer threads than asked for, the others do their work.
            let _ = Builder::new()
                .stack_size(stack)
                .spawn_scoped(scope, move || worker(sender));
        }
        drop(sender);
        let (mut early, mut taken) = (BTreeMap::new(), 0);
        for (index, result) in receiver {
            early.insert(index, result);
            while let Some(result) = early.remove(&taken) {
                take(result);
                taken += 1;
            }
        }
        for _ in taken..items.len() {
            take(None);
        }
    });
}

#[test]
fn work_that_breaks_off_is_missed_in_its_place() {
    let mut results = Vec::new();
    let numbers = [4, 0, 2, 1];
    in_order(
        &numbers,
        3,
        1 << 20,
        |own| 8 / own,
        |result| results.push(result),
    );
    assert_eq!(results, [Some(2), None, Some(4), Some(8)]);
    in_order(
        &numbers[..0],
        3,
        1 << 20,
        |own| 8 / own,
        |result| results.push(result),
    );
    assert_eq!(results.len(), 4);
}
