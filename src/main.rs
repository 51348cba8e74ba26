//! The `sweepc` command.

/// A sweep is a thousand small numbers and lists, most of which live for microseconds.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> std::process::ExitCode {
    sweepc::cli::run()
}
