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
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>

namespace {

enum Call {
    allocate,
    open_file,
    read_file,
    write_file,
    sync_file,
    close_file,
    rename_file,
    unlink_file,
    make_folder,
    status_of,
    list_folder,
    start_thread,
    disk,
    calls
};
constexpr const char* names[calls] = {"allocate", "open",   "read",   "write", "fsync",
                                      "close",    "rename", "unlink", "mkdir", "stat",
                                      "readdir",  "thread", "disk"};
constexpr int numbers[calls] = {ENOMEM, EMFILE, EIO, ENOSPC, EIO,    EIO,   EIO,
                                EACCES, ENOSPC, EIO, EIO,    EAGAIN, ENOSPC};

struct Order {
    Call call = calls;
    long first = 0, last = 0;
    int kill = 0;
    long microseconds = 0, megabytes = 0;
};

Order order;
bool armed = false;
/// Shared with the server's children; the counts of one run.
std::atomic<long>* counts = nullptr;
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

template <typename Function>
Function* real(Function*, const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

bool parse(const char* text, Order& parsed) {
    char name[32];
    if (sscanf(text, "%31s %ld %ld %d %ld %ld", name, &parsed.first, &parsed.last, &parsed.kill,
               &parsed.microseconds, &parsed.megabytes) != 6)
        return false;
    for (int i = 0; i < calls; ++i)
        if (strcmp(name, names[i]) == 0) parsed.call = static_cast<Call>(i);
    return true;
}

using Main = int (*)(int, char**, char**);
Main program = nullptr;

/// Pages that the process has mapped so far.
long mapped_bytes() {
    FILE* file = fopen("/proc/self/statm", "r");
    long pages = 0;
    if (file == nullptr || fscanf(file, "%ld", &pages) != 1) abort();
    fclose(file);
    return pages * ::sysconf(_SC_PAGESIZE);
}

int run_program(int argc, char** argv, char** environment) {
    if (order.megabytes > 0) {
        const auto most = static_cast<rlim_t>(mapped_bytes() + order.megabytes * (1L << 20));
        const rlimit limit{most, most};
        ::setrlimit(RLIMIT_AS, &limit);
    }
    armed = true;
    return program(argc, argv, environment);
}

/// Results and messages of a child go to the files that the driver names.
void redirect(const char* variable, int descriptor) {
    const int file = ::open(getenv(variable), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    if (file < 0 || ::dup2(file, descriptor) < 0) abort();
    ::close(file);
}

long microseconds_now() {
    timespec now{};
    static const auto clock = real(&clock_gettime, "clock_gettime");
    clock(CLOCK_MONOTONIC, &now);
    return now.tv_sec * 1'000'000 + now.tv_nsec / 1000;
}

constexpr long longest_run = 60'000'000;

/// Waits for the child; kills it at the moment that the order names, or when it hangs.
int wait_for(pid_t child, long began) {
    const long limit = order.microseconds > 0 ? order.microseconds : longest_run;
    int status = 0;
    for (bool killed = false; ::waitpid(child, &status, killed ? 0 : WNOHANG) == 0;) {
        killed = microseconds_now() - began >= limit;
        if (killed) ::kill(child, SIGKILL);
        if (!killed) ::usleep(50);
    }
    return status;
}

void answer(FILE* out, int status, long taken) {
    fprintf(out, "%d %ld", status, taken);
    for (int i = 0; i < calls; ++i) fprintf(out, " %s=%ld", names[i], counts[i].load());
    fprintf(out, "\n");
    fflush(out);
}

/// Ends a child without what libraries do at the end: some wait for threads that a fork does not
/// copy.
[[noreturn]] void finish(int code) {
    armed = false;
    fflush(stdout);
    ::_exit(code);
}

int serve(FILE* in, FILE* out, int argc, char** argv, char** environment) {
    char line[256];
    while (fgets(line, sizeof line, in) != nullptr) {
        order = Order{};
        if (!parse(line, order)) abort();
        for (int i = 0; i < calls; ++i) counts[i] = 0;
        const long began = microseconds_now();
        const pid_t child = ::fork();
        if (child == 0) {
            ::close(fileno(in));
            ::close(fileno(out));
            redirect("TWOFOLD_FAULT_STDOUT", STDOUT_FILENO);
            redirect("TWOFOLD_FAULT_STDERR", STDERR_FILENO);
            finish(run_program(argc, argv, environment));
        }
        const int status = wait_for(child, began);
        answer(out, status, microseconds_now() - began);
    }
    ::_exit(0);
}

int main_with_faults(int argc, char** argv, char** environment) {
    counts = static_cast<std::atomic<long>*>(::mmap(nullptr, sizeof(std::atomic<long>) * calls,
                                                    PROT_READ | PROT_WRITE,
                                                    MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    int in = -1, out = -1;
    if (const char* server = getenv("TWOFOLD_FAULT_SERVER");
        server != nullptr && sscanf(server, "%d,%d", &in, &out) == 2)
        return serve(fdopen(in, "r"), fdopen(out, "w"), argc, argv, environment);
    if (const char* text = getenv("TWOFOLD_FAULT"); text == nullptr || !parse(text, order)) abort();
    return run_program(argc, argv, environment);
}

}  // namespace

extern "C" {

int __libc_start_main(Main main, int argc, char** argv, void (*init)(), void (*fini)(),
                      void (*unload)(), void* stack) {
    program = main;
    const auto start = real(&__libc_start_main, "__libc_start_main");
    return start(&main_with_faults, argc, argv, init, fini, unload, stack);
}

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
    return fails(read_file) ? -1 : next(file, bytes, count);
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
