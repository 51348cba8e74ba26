use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag::{register, register_conditional_shutdown};

use super::status::INTERRUPTED;

/// Whether the user or the system has asked this process to end.
#[derive(Debug, Clone, Default)]
pub(super) struct Interrupt {
    asked: Arc<AtomicBool>,
}

impl Interrupt {
    /// Listens to SIGINT and SIGTERM. The first of them is only noted, so that what is staged can
    /// be taken away; a second one ends the process where it stands.
    ///
    /// A file that grows beyond the size that the process may write is an error of that file: the
    /// signal that comes with it is taken in silence.
    pub(super) fn listen() -> Self {
        let own = Self::default();
        for signal in [SIGINT, SIGTERM] {
            // In this order: the shutdown looks at the flag before the first signal sets it.
            let shutdown = Arc::clone(&own.asked);
            let _ = register_conditional_shutdown(signal, i32::from(INTERRUPTED), shutdown);
            let _ = register(signal, Arc::clone(&own.asked));
        }
        #[cfg(unix)]
        let _ = register(signal_hook::consts::SIGXFSZ, Arc::default());
        own
    }

    /// Whether a signal has come.
    pub(super) fn is_asked(&self) -> bool {
        self.asked.load(Ordering::SeqCst)
    }
}
