#pragma once
#include <string>

#include "texunit/error.hpp"

/// What a reader says to a file that it must not read.
namespace twofold::cases {

/// The text of the Error that `read` throws, with a remark if its exit code is another than `code`;
/// "accepted" if it throws none.
template <class Read>
std::string refusal(ExitCode code, const Read& read) {
    try {
        read();
    } catch (const Error& error) {
        return (error.code() == code ? "" : "wrong exit code: ") + std::string(error.what());
    }
    return "accepted";
}

}  // namespace twofold::cases
