#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Whole files in and out. A written file is either the old one or the complete new one: the bytes
/// go to a temporary file beside it, which is flushed to the disk and renamed (docs/exactness.md,
/// section 8).
namespace twofold {

/// Writes `bytes` to `path`, replacing what was there in one step.
/// The temporary file is `.NAME.twofold-PID.tmp` in the same folder; it is removed when anything
/// fails.
/// @throws Error(bad_file) naming the file and the step that failed. `path` must be new or a
/// regular
///         file: renaming over a device or a pipe would remove it from the system.
void write_file_atomically(const std::filesystem::path& path, std::span<const unsigned char> bytes);

/// The same for text.
void write_file_atomically(const std::filesystem::path& path, std::string_view text);

/// Removes from `folder` the temporary files of processes that no longer run, and those that carry
/// this process's own number (left by an earlier process of that number), so call it before the
/// first write. A file that cannot be removed is left alone: it belongs to somebody else and does
/// no harm.
/// @return how many were removed.
int remove_stale_temporaries(const std::filesystem::path& folder);

/// The bytes of a regular file.
/// @throws Error(bad_file) if it is not there, not a regular file or longer than `max_bytes`.
std::vector<unsigned char> read_file(const std::filesystem::path& path, std::size_t max_bytes);

/// The same as text; no line end and no encoding is changed.
std::string read_text_file(const std::filesystem::path& path, std::size_t max_bytes);

/// True for the short text file that a Git LFS checkout without its data leaves in place of the
/// file.
bool is_git_lfs_pointer(std::span<const unsigned char> bytes);

/// Writes all of `bytes` to an open descriptor, going on after short writes and interruptions.
/// @param name what the error calls the file.
/// @throws Error(bad_file), for instance when the disk is full.
void write_all(int descriptor, std::span<const unsigned char> bytes, const std::string& name);

}  // namespace twofold
