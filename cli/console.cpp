#include "cli/console.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace twofold {

void print_message(std::string_view text) noexcept {
    std::fwrite(text.data(), 1, text.size(), stderr);
}

Console::Console(bool quiet)
    : quiet_(quiet),
      on_terminal_(isatty(STDERR_FILENO) != 0),
      in_color_(on_terminal_ && std::getenv("NO_COLOR") == nullptr) {}

Console::~Console() { finish(); }

void Console::step(std::string_view name) {
    if (quiet_) return;
    if (on_terminal_)
        print_message(fmt::format("\r\033[K{} ...", name));
    else
        print_message(fmt::format("{}\n", name));
    std::fflush(stderr);
    line_open_ = on_terminal_;
}

void Console::warn(std::string_view text) {
    finish();
    print_message(fmt::format("{}warning:{} {}\n", in_color_ ? "\033[33m" : "",
                              in_color_ ? "\033[0m" : "", text));
}

void Console::finish() {
    if (line_open_) print_message("\r\033[K");
    line_open_ = false;
}

}  // namespace twofold
