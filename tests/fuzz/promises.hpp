#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "tests/fuzz/readers.hpp"
#include "texunit/error.hpp"

/// What every reader is held to.
namespace twofold::hostile {

inline const std::string file_name = "hostile.file";

inline std::string_view text_of(Input bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

inline void promise(bool kept, const std::string& what) {
    if (!kept) throw std::logic_error("broken promise: " + what);
}

/// An error's text names the file, is short, and cannot steer a terminal.
inline void check_error(const Error& error, ExitCode code) {
    const std::string text = error.what();
    promise(error.code() == code, fmt::format("exit code {}: {}", int(error.code()), text));
    promise(text.starts_with(file_name + ":"), "the error names no file: " + text);
    promise(text.size() < 600, "an error of " + std::to_string(text.size()) + " bytes");
    promise(printable(text, text.size()) == text, "the error is not printable: " + text);
}

/// Runs the reader; true if it read, false if it refused as it should, with exit code `refusal`.
template <class Read>
bool reads(ExitCode refusal, const Read& read) {
    try {
        read();
        return true;
    } catch (const Error& error) {
        check_error(error, refusal);
        return false;
    }
}

}  // namespace twofold::hostile
