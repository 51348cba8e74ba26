//! The `sweepc` command.

fn main() -> std::process::ExitCode {
    sweepc::cli::run()
}
