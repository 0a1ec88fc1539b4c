// Makes one chosen call of a program fail, for tests: LD_PRELOAD=libfail_nth.so PROGRAM ...
//
// Calls are counted from the first instruction of main() on. What fails is said by TWOFOLD_FAULT,
// or, where TWOFOLD_FAULT_SERVER names two descriptors "IN,OUT", by lines read from IN: the loaded
// program then forks for each line, so that a fault costs what main() costs and not what loading
// its libraries does. An order is
//     CALL FIRST LAST KILL MICROSECONDS MEGABYTES
// Calls number FIRST to LAST of CALL fail (none for FIRST 0; "disk" has no room for byte FIRST and
// later ones). With KILL 1 the process is killed in their place. It is also killed after
// MICROSECONDS, and may map MEGABYTES more than it has (0: no limit). The answer on OUT: wait
// status, microseconds, and how often each call was made. Clocks advance by 1/512 s a reading,
// exact in binary, so that measured times are the same in every run.
#include <dirent.h>
#include <errno.h>
#include <linux/magic.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <time.h>
#include <unistd.h>

#include "tests/faults/fault.hpp"

namespace {

using namespace fault;

constexpr int numbers[calls] = {ENOMEM, EMFILE, EIO, ENOSPC, EIO,    EIO,   EIO,
                                EACCES, ENOSPC, EIO, EIO,    EAGAIN, ENOSPC};

std::atomic<long> ticks{0};

/// Counts the call; true if it is to fail, with errno set.
bool fails(Call call, long amount = 1) {
    if (!armed) return false;
    const long n = counts[call].fetch_add(amount) + amount;
    if (call != order.call || order.first == 0 || n < order.first || n > order.last) return false;
    if (order.kill) ::kill(::getpid(), SIGKILL);
    errno = numbers[call];
    return true;
}

/// Whether the file is one of /proc: its name of the processor stands beside measured times only.
bool of_the_system(int file) {
    struct statfs system {};
    return ::fstatfs(file, &system) == 0 && system.f_type == PROC_SUPER_MAGIC;
}

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* now) {
    static const auto next = real(&clock_gettime, "clock_gettime");
    if (!armed) return next(clock, now);
    const long n = ++ticks;
    *now = {8 + n / 512, n % 512 * 1'953'125};
    return 0;
}

void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);

void* malloc(size_t size) { return fails(allocate) ? nullptr : __libc_malloc(size); }

void* calloc(size_t count, size_t size) {
    return fails(allocate) ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* old, size_t size) {
    return fails(allocate) ? nullptr : __libc_realloc(old, size);
}

void* aligned_alloc(size_t alignment, size_t size) {
    return fails(allocate) ? nullptr : __libc_memalign(alignment, size);
}

int posix_memalign(void** result, size_t alignment, size_t size) {
    void* memory = fails(allocate) ? nullptr : __libc_memalign(alignment, size);
    if (memory != nullptr) *result = memory;
    return memory != nullptr ? 0 : ENOMEM;
}

int open(const char* path, int flags, ...) {
    static const auto next = real(&open, "open");
    va_list rest;
    va_start(rest, flags);
    const unsigned mode = va_arg(rest, unsigned);
    va_end(rest);
    return fails(open_file) ? -1 : next(path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
    static const auto next = real(&openat, "openat");
    va_list rest;
    va_start(rest, flags);
    const unsigned mode = va_arg(rest, unsigned);
    va_end(rest);
    return fails(open_file) ? -1 : next(folder, path, flags, mode);
}

ssize_t read(int file, void* bytes, size_t count) {
    static const auto next = real(&read, "read");
    return !of_the_system(file) && fails(read_file) ? -1 : next(file, bytes, count);
}

/// A full disk takes what it has room for and then nothing.
ssize_t write(int file, const void* bytes, size_t count) {
    static const auto next = real(&write, "write");
    if (fails(write_file)) return -1;
    const long before = counts != nullptr ? counts[disk].load() : 0;
    if (!fails(disk, static_cast<long>(count))) return next(file, bytes, count);
    const long room = order.first - 1 - before;
    return room > 0 ? next(file, bytes, static_cast<size_t>(room)) : -1;
}

int fsync(int file) {
    static const auto next = real(&fsync, "fsync");
    return fails(sync_file) ? -1 : next(file);
}

/// The descriptor is gone even where an error is reported, as on Linux.
int close(int file) {
    static const auto next = real(&close, "close");
    const bool failing = fails(close_file);
    const int result = next(file);
    if (failing) errno = numbers[close_file];
    return failing ? -1 : result;
}

int rename(const char* from, const char* to) {
    static const auto next = real(&rename, "rename");
    return fails(rename_file) ? -1 : next(from, to);
}

int unlink(const char* path) {
    static const auto next = real(&unlink, "unlink");
    return fails(unlink_file) ? -1 : next(path);
}

int mkdir(const char* path, mode_t mode) {
    static const auto next = real(&mkdir, "mkdir");
    return fails(make_folder) ? -1 : next(path, mode);
}

int stat(const char* path, struct stat* status) {
    static const auto next = real(static_cast<int (*)(const char*, struct stat*)>(&stat), "stat");
    return fails(status_of) ? -1 : next(path, status);
}

int fstat(int file, struct stat* status) {
    static const auto next = real(&fstat, "fstat");
    return fails(status_of) ? -1 : next(file, status);
}

DIR* opendir(const char* path) {
    static const auto next = real(&opendir, "opendir");
    return fails(open_file) ? nullptr : next(path);
}

dirent* readdir(DIR* folder) {
    static const auto next = real(&readdir, "readdir");
    return fails(list_folder) ? nullptr : next(folder);
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*start)(void*),
                   void* argument) {
    static const auto next = real(&pthread_create, "pthread_create");
    return fails(start_thread) ? EAGAIN : next(thread, attributes, start, argument);
}

}  // extern "C"
