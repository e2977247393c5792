#pragma once

#include <filesystem>
#include <string_view>

namespace ramify {

/// Writes a file whole or not at all: to a temporary name in the same folder, renamed when every byte is
/// written.
///
/// A reader sees the old file or the new one, never half of either; what was there stays on failure. It does
/// not outlast a power cut (no fsync). Symbolic links, devices and pipes (-o /dev/stdout) are written
/// through, not replaced. Throws Error with the system's reason.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

/// Removes what files are written to at this moment, under their temporary names. Safe in a signal handler
/// that ends the process.
void remove_unfinished_files() noexcept;

/// Creates the folder where it is missing and proves that a file can be written in it, before long work
/// starts. Throws Error otherwise; a folder created for nothing is removed again.
void require_writable_folder(const std::filesystem::path& path);

}  // namespace ramify
