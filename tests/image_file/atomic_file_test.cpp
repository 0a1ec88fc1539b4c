#include "texunit/atomic_file.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <iterator>
#include <string>
#include <thread>

#include "tests/temporary_folder.hpp"
#include "texunit/error.hpp"

namespace {
using namespace twofold;
namespace fs = std::filesystem;
using Catch::Contains;

std::ptrdiff_t entries(const fs::path& folder) {
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

/// Lets no file of this process grow past `bytes`: what a full disk does, without filling one.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) : handler_(::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        ::signal(SIGXFSZ, handler_);
    }

  private:
    rlimit before_{};
    void (*handler_)(int);
};

/// A process number that no process has: that of a child which has ended and been waited for.
pid_t ended_process() {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    siginfo_t info{};
    ::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED);
    return child;
}

fs::path temporary_of(const TemporaryFolder& folder, const std::string& pid) {
    return folder / (".a.png.twofold-" + pid + ".tmp");
}
}  // namespace

TEST_CASE("a written file holds the bytes and nothing is left beside it", "[file]") {
    const TemporaryFolder folder;
    std::string text = "line\r\n\0end";
    text.push_back('\0');
    write_file_atomically(folder / "a.txt", text);
    CHECK(read_text_file(folder / "a.txt", 100) == text);
    write_file_atomically(folder / "a.txt", std::string_view());
    CHECK(read_text_file(folder / "a.txt", 100).empty());
    CHECK(entries(folder.path()) == 1);
}

TEST_CASE("bytes of any length come back", "[file]") {
    const TemporaryFolder folder;
    std::vector<unsigned char> bytes(300'001);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<unsigned char>(i * 7);
    write_file_atomically(folder / "a.bin", bytes);
    CHECK(read_file(folder / "a.bin", bytes.size()) == bytes);
}

TEST_CASE("a file longer than allowed is refused with both numbers", "[file]") {
    const TemporaryFolder folder;
    write_file_atomically(folder / "a", std::string_view("12345"));
    CHECK(read_text_file(folder / "a", 5) == "12345");
    CHECK_THROWS_WITH(read_text_file(folder / "a", 4), Contains("5 bytes, more than the 4"));
}

TEST_CASE("what is not a regular file is neither read nor replaced", "[file]") {
    const TemporaryFolder folder;
    const fs::path pipe = folder / "pipe";
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    for (const fs::path& path : {pipe, folder.path()}) {
        CHECK_THROWS_WITH(read_file(path, 10), Contains("not a regular file"));
        CHECK_THROWS_WITH(write_file_atomically(path, std::string_view("x")),
                          Contains("not a regular file"));
    }
    CHECK_THROWS_WITH(read_file(folder / "none", 10), Contains("No such file"));
    CHECK(fs::is_fifo(pipe));
}

TEST_CASE("a full device is an error", "[file]") {
    const int full = ::open("/dev/full", O_WRONLY | O_CLOEXEC);
    if (full < 0) return;  // not every system has it
    const std::vector<unsigned char> bytes(10);
    CHECK_THROWS_WITH(write_all(full, bytes, "picture.png"),
                      Contains("picture.png: cannot write: No space left"));
    ::close(full);
}

TEST_CASE("a write that ends half way leaves the old file and no temporary one", "[file]") {
    const TemporaryFolder folder;
    write_file_atomically(folder / "a", std::string_view("old"));
    {
        const FileSizeLimit limit(4096);
        CHECK_THROWS_WITH(write_file_atomically(folder / "a", std::string(10'000, 'x')),
                          Contains("cannot write"));
    }
    CHECK(read_text_file(folder / "a", 100) == "old");
    CHECK(entries(folder.path()) == 1);
}

TEST_CASE("short writes are continued", "[file]") {
    int ends[2];
    REQUIRE(::pipe2(ends, O_CLOEXEC) == 0);
    // More than a pipe holds, so that write() returns early unless somebody empties it.
    const std::vector<unsigned char> bytes(1 << 20, 42);
    std::size_t received = 0;
    std::thread reader([&] {
        unsigned char buffer[1000];
        for (ssize_t n = 0; (n = ::read(ends[0], buffer, sizeof buffer)) > 0;)
            received += static_cast<std::size_t>(n);
    });
    write_all(ends[1], bytes, "pipe");
    ::close(ends[1]);
    reader.join();
    ::close(ends[0]);
    CHECK(received == bytes.size());
}

TEST_CASE("a folder that is missing or may not be written is named with the file", "[file]") {
    const TemporaryFolder folder;
    CHECK_THROWS_WITH(write_file_atomically(folder / "no/a", std::string_view("x")),
                      Contains("no/a: cannot create a file in its folder: No such file"));
    fs::create_directory(folder / "locked");
    fs::permissions(folder / "locked", fs::perms::owner_read | fs::perms::owner_exec);
    if (::geteuid() == 0) return;  // permissions do not bind root
    CHECK_THROWS_WITH(write_file_atomically(folder / "locked/a", std::string_view("x")),
                      Contains("Permission denied"));
}

TEST_CASE("the error of a file says bad_file", "[file]") {
    const TemporaryFolder folder;
    try {
        read_file(folder / "none", 1);
        FAIL("no error");
    } catch (const Error& error) {
        CHECK(error.code() == ExitCode::bad_file);
    }
}

TEST_CASE("temporary files of ended processes are swept, others stay", "[file]") {
    const TemporaryFolder folder;
    const std::string ended = std::to_string(ended_process());
    const std::string own = std::to_string(::getpid());
    const std::string parent = std::to_string(::getppid());
    for (const std::string& pid : {ended, own, parent, std::string("12x"), std::string("-5")})
        write_file_atomically(temporary_of(folder, pid), std::string_view("x"));
    write_file_atomically(folder / ("a.twofold-" + ended + ".tmp"), std::string_view("x"));
    CHECK(remove_stale_temporaries(folder.path()) == 2);
    CHECK_FALSE(fs::exists(temporary_of(folder, ended)));
    CHECK_FALSE(fs::exists(temporary_of(folder, own)));
    CHECK(fs::exists(temporary_of(folder, parent)));
    CHECK(entries(folder.path()) == 4);
    CHECK_THROWS_WITH(remove_stale_temporaries(folder / "none"),
                      Contains("none: cannot open the folder: No such file"));
}

TEST_CASE("a temporary file left under our own process number does not stop a write", "[file]") {
    const TemporaryFolder folder;
    const std::string own = std::to_string(::getpid());
    write_file_atomically(temporary_of(folder, own), std::string_view("left by a killed process"));
    write_file_atomically(folder / "a.png", std::string_view("new"));
    CHECK(read_text_file(folder / "a.png", 10) == "new");
    CHECK(entries(folder.path()) == 1);
}
