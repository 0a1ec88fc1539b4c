#pragma once
#include <dlfcn.h>
#include <sys/types.h>

#include <atomic>

/// What the calls of fail_nth.cpp share with the server that gives the orders.
namespace fault {

/// Calls that can fail; `disk` counts the bytes that are written.
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

struct Order {
    Call call = calls;
    long first = 0, last = 0;
    int kill = 0;
    long microseconds = 0, megabytes = 0;
};

extern Order order;
/// From the beginning of main() on.
extern bool armed;
/// How often each call was made; shared with the server's children.
extern std::atomic<long>* counts;

/// The next definition of a function that is defined here.
template <typename Function>
Function* real(Function*, const char* name) {
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace fault
