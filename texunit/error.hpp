#pragma once
#include <stdexcept>
#include <string>
#include <string_view>

namespace twofold {

/// Exit codes of every program here; 0 to 4 are those of OpenImageIO's idiff.
enum class ExitCode {
    ok = 0,
    warning = 1,        ///< done, but the result carries a warning
    failure = 2,        ///< pictures differ, or wrong usage, argument or scene
    sizes_differ = 3,   ///< compared pictures have different sizes
    bad_file = 4,       ///< a file is missing, unreadable, damaged or cannot be written
    not_converged = 5,  ///< the solver ended without converging
    inexact_build = 6   ///< the build or the processor's floating-point state breaks exactness
};

/// A wrong file, argument or scene. The text names file, field and value; `cli` catches it once.
class Error : public std::runtime_error {
  public:
    Error(ExitCode code, const std::string& text) : std::runtime_error(text), code_(code) {}
    ExitCode code() const { return code_; }

  private:
    ExitCode code_;
};

/// `text` shortened and with every byte that is not printable ASCII replaced: what a file says is
/// fit for an error message and does not reach the terminal.
inline std::string printable(std::string_view text, std::size_t limit = 60) {
    std::string result(text.substr(0, limit));
    for (char& c : result)
        if (c < ' ' || c > '~') c = '?';
    return text.size() > limit ? result + "..." : result;
}

}  // namespace twofold
