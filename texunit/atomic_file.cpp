#include "texunit/atomic_file.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "texunit/error.hpp"

namespace twofold {
namespace {

namespace fs = std::filesystem;

/// The error of a system call; `number` is errno, taken before anything else could change it.
Error system_error(const std::string& name, const std::string& what, int number) {
    return Error(ExitCode::bad_file,
                 name + ": " + what + ": " + std::generic_category().message(number));
}

/// Owns an open descriptor. The destructor closes it without looking at the result, so a writer
/// calls close() itself: some file systems report a failed write only there.
class Descriptor {
  public:
    explicit Descriptor(int value) : value_(value) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor() {
        if (value_ >= 0) ::close(value_);
    }
    int get() const { return value_; }
    int close() { return ::close(std::exchange(value_, -1)); }

  private:
    int value_;
};

constexpr std::string_view marker = ".twofold-";
constexpr std::string_view ending = ".tmp";

fs::path temporary_path(const fs::path& target) {
    return target.parent_path() /
           fmt::format(".{}{}{}{}", target.filename().string(), marker, ::getpid(), ending);
}

fs::path folder_of(const fs::path& target) {
    return target.has_parent_path() ? target.parent_path() : fs::path(".");
}

void require_replaceable(const fs::path& target) {
    std::error_code ignored;  // a file that cannot be looked at fails below, with a better reason
    const fs::file_status status = fs::status(target, ignored);
    if (!target.has_filename() || (fs::exists(status) && !fs::is_regular_file(status)))
        throw Error(ExitCode::bad_file,
                    target.string() + ": not a regular file, so it is not replaced");
}

int create_exclusively(const fs::path& path) {
    return ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

/// Creates the temporary file. One that is already there carries our process number, so a process
/// that had the number before us was killed (common in containers): it is removed and the name
/// tried again.
int create_temporary(const fs::path& path, const fs::path& target) {
    int descriptor = create_exclusively(path);
    if (descriptor < 0 && errno == EEXIST && ::unlink(path.c_str()) == 0)
        descriptor = create_exclusively(path);
    if (descriptor < 0)
        throw system_error(target.string(), "cannot create a file in its folder", errno);
    return descriptor;
}

/// The file that will be `target`, removed unless it has become that. It is created last, so that
/// nothing can fail between its creation and its having an owner.
class TemporaryFile {
  public:
    explicit TemporaryFile(const fs::path& target)
        : path_(temporary_path(target)), file_(create_temporary(path_, target)) {}
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;
    ~TemporaryFile() {
        if (!renamed_) ::unlink(path_.c_str());
    }
    Descriptor& file() { return file_; }

    void rename_to(const fs::path& target) {
        if (::rename(path_.c_str(), target.c_str()) != 0)
            throw system_error(target.string(), "cannot rename the finished file", errno);
        renamed_ = true;
    }

  private:
    fs::path path_;
    Descriptor file_;
    bool renamed_ = false;
};

void flush_to_disk(Descriptor& file, const fs::path& target) {
    if (::fsync(file.get()) != 0)
        throw system_error(target.string(), "cannot flush to the disk", errno);
    if (file.close() != 0) throw system_error(target.string(), "cannot close", errno);
}

/// Makes the rename itself durable. EINVAL means that this file system has no such operation for
/// folders; the file is complete either way.
void flush_folder(const fs::path& target) {
    const fs::path folder = folder_of(target);
    Descriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (directory.get() < 0) throw system_error(folder.string(), "cannot open the folder", errno);
    if (::fsync(directory.get()) != 0 && errno != EINVAL)
        throw system_error(folder.string(), "cannot flush the folder to the disk", errno);
    if (directory.close() != 0) throw system_error(folder.string(), "cannot close", errno);
}

/// The process number in `.NAME.twofold-PID.tmp`; nothing for any other name.
std::optional<pid_t> process_of_temporary(std::string_view name) {
    if (!name.starts_with('.') || !name.ends_with(ending)) return std::nullopt;
    name.remove_suffix(ending.size());
    const std::size_t start = name.rfind(marker);
    if (start == std::string_view::npos || start == 0) return std::nullopt;
    const std::string_view digits = name.substr(start + marker.size());
    pid_t pid = 0;
    const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), pid);
    const bool whole = status == std::errc() && end == digits.data() + digits.size();
    return whole && pid > 0 ? std::optional(pid) : std::nullopt;
}

/// EPERM: there is such a process, but it is not ours.
bool is_another_running_process(pid_t pid) {
    return pid != ::getpid() && (::kill(pid, 0) == 0 || errno == EPERM);
}

struct CloseFolder {
    void operator()(DIR* folder) const { ::closedir(folder); }
};

/// Temporary files in the folder that no running process is going to rename. The folder is read by
/// the system's calls: libstdc++'s directory_iterator ends the program where memory ends.
std::vector<fs::path> stale_temporaries(const fs::path& folder) {
    const std::unique_ptr<DIR, CloseFolder> listing(::opendir(folder.c_str()));
    if (!listing) throw system_error(folder.string(), "cannot open the folder", errno);
    std::vector<fs::path> stale;
    for (errno = 0; const dirent* entry = ::readdir(listing.get()); errno = 0) {
        const auto pid = process_of_temporary(entry->d_name);
        if (pid && !is_another_running_process(*pid)) stale.push_back(folder / entry->d_name);
    }
    if (errno != 0) throw system_error(folder.string(), "cannot be listed", errno);
    return stale;
}

/// Opens without waiting: a named pipe would otherwise block until somebody writes to it.
int open_to_read(const fs::path& path) {
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (descriptor < 0) throw system_error(path.string(), "cannot open", errno);
    return descriptor;
}

std::size_t checked_size(int descriptor, const fs::path& path, std::size_t max_bytes) {
    struct stat status {};
    if (::fstat(descriptor, &status) != 0) throw system_error(path.string(), "cannot stat", errno);
    if (!S_ISREG(status.st_mode))
        throw Error(ExitCode::bad_file, path.string() + ": not a regular file");
    const auto size = static_cast<std::size_t>(status.st_size);
    if (size > max_bytes)
        throw Error(ExitCode::bad_file, path.string() + ": " + std::to_string(size) +
                                            " bytes, more than the " + std::to_string(max_bytes) +
                                            " allowed");
    return size;
}

/// Fills `bytes` as far as the file goes and returns how far that was.
std::size_t read_up_to(int descriptor, std::span<unsigned char> bytes, const fs::path& path) {
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t count = ::read(descriptor, bytes.data() + done, bytes.size() - done);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw system_error(path.string(), "cannot read", errno);
        if (count == 0) break;
        done += static_cast<std::size_t>(count);
    }
    return done;
}

}  // namespace

void write_all(int descriptor, std::span<const unsigned char> bytes, const std::string& name) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) throw system_error(name, "cannot write", errno);
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
}

void write_file_atomically(const fs::path& path, std::span<const unsigned char> bytes) {
    require_replaceable(path);
    TemporaryFile temporary(path);
    write_all(temporary.file().get(), bytes, path.string());
    flush_to_disk(temporary.file(), path);
    temporary.rename_to(path);
    flush_folder(path);
}

void write_file_atomically(const fs::path& path, std::string_view text) {
    const auto* data = reinterpret_cast<const unsigned char*>(text.data());
    write_file_atomically(path, std::span(data, text.size()));
}

int remove_stale_temporaries(const fs::path& folder) {
    const std::vector<fs::path> stale = stale_temporaries(folder);
    const auto removed = std::count_if(stale.begin(), stale.end(), [](const fs::path& path) {
        return ::unlink(path.c_str()) == 0;  // never removes a folder
    });
    return static_cast<int>(removed);
}

std::vector<unsigned char> read_file(const fs::path& path, std::size_t max_bytes) {
    const Descriptor file(open_to_read(path));
    std::vector<unsigned char> bytes(checked_size(file.get(), path, max_bytes));
    bytes.resize(read_up_to(file.get(), bytes, path));
    return bytes;
}

std::string read_text_file(const fs::path& path, std::size_t max_bytes) {
    const Descriptor file(open_to_read(path));
    std::string text(checked_size(file.get(), path, max_bytes), '\0');
    auto* data = reinterpret_cast<unsigned char*>(text.data());
    text.resize(read_up_to(file.get(), std::span(data, text.size()), path));
    return text;
}

bool is_git_lfs_pointer(std::span<const unsigned char> bytes) {
    constexpr std::string_view first_line = "version https://git-lfs.github.com/spec/";
    return bytes.size() > first_line.size() &&
           std::equal(first_line.begin(), first_line.end(), bytes.begin(),
                      [](char a, unsigned char b) { return static_cast<unsigned char>(a) == b; });
}

}  // namespace twofold
