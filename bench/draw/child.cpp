#include "bench/draw/child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "bench/draw/timing.hpp"
#include "texunit/error.hpp"

extern char** environ;

namespace twofold::bench {
namespace {

using Environment = std::vector<std::pair<std::string, std::string>>;

std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> result;
    for (std::string& text : texts) result.push_back(text.data());
    result.push_back(nullptr);
    return result;
}

/// Ours with `changes` in place of what has the same names.
std::vector<std::string> merged(const Environment& changes) {
    std::vector<std::string> result;
    for (char** variable = environ; *variable; ++variable) {
        const std::string text = *variable;
        bool kept = true;
        for (const auto& [name, value] : changes) kept = kept && !text.starts_with(name + "=");
        if (kept) result.push_back(text);
    }
    for (const auto& [name, value] : changes) result.push_back(name + "=" + value);
    return result;
}

[[noreturn]] void fail(const std::string& program, const std::string& text) {
    throw Error(ExitCode::bad_file, program + ": " + text);
}

/// Starts the program with its standard output going to `output`.
pid_t start(std::vector<std::string> command, const Environment& environment, int output) {
    std::vector<std::string> variables = merged(environment);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    pid_t child = 0;
    const int error = posix_spawn(&child, command[0].c_str(), &actions, nullptr,
                                  pointers(command).data(), pointers(variables).data());
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0) fail(command[0], std::strerror(error));
    return child;
}

std::string read_all(int descriptor) {
    std::string text;
    std::array<char, 4096> buffer;
    for (ssize_t n; (n = read(descriptor, buffer.data(), buffer.size())) > 0;)
        text.append(buffer.data(), static_cast<std::size_t>(n));
    return text;
}

}  // namespace

ChildResult run_child(const std::vector<std::string>& command, const Environment& environment) {
    std::array<int, 2> pipe_ends{};
    if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) fail(command[0], std::strerror(errno));
    const double before = wall_seconds();
    const pid_t child = start(command, environment, pipe_ends[1]);
    close(pipe_ends[1]);
    ChildResult result{read_all(pipe_ends[0])};
    close(pipe_ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    result.wall = wall_seconds() - before;
    if (WIFSIGNALED(status)) fail(command[0], fmt::format("signal {}", WTERMSIG(status)));
    if (WEXITSTATUS(status) != 0)
        fail(command[0], fmt::format("exit code {}", WEXITSTATUS(status)));
    return result;
}

}  // namespace twofold::bench
