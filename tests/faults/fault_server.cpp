// When main() begins, and what is to fail in it.
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/faults/fault.hpp"

namespace fault {

Order order;
bool armed = false;
std::atomic<long>* counts = nullptr;

}  // namespace fault

namespace {

using namespace fault;

constexpr const char* names[calls] = {"allocate", "open",   "read",   "write", "fsync",
                                      "close",    "rename", "unlink", "mkdir", "stat",
                                      "readdir",  "thread", "disk"};

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

extern "C" int __libc_start_main(Main main, int argc, char** argv, void (*init)(), void (*fini)(),
                                 void (*unload)(), void* stack) {
    program = main;
    const auto start = real(&__libc_start_main, "__libc_start_main");
    return start(&main_with_faults, argc, argv, init, fini, unload, stack);
}
