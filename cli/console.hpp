#pragma once
#include <string>
#include <string_view>

namespace twofold {

/// Writes to stderr. What cannot be written there is lost: the work goes on, and the exit code
/// tells how it ended.
void print_message(std::string_view text) noexcept;

/// Progress and messages on stderr. On a terminal the running step stays on one line with the time
/// so far; elsewhere each step is a line of its own.
class Console {
  public:
    explicit Console(bool quiet);
    ~Console();
    Console(const Console&) = delete;
    Console& operator=(const Console&) = delete;

    void step(std::string_view name);
    /// A line that is shown even when quiet.
    void warn(std::string_view text);
    void finish();

  private:
    bool quiet_;
    bool on_terminal_;
    bool in_color_;
    bool line_open_ = false;
};

}  // namespace twofold
