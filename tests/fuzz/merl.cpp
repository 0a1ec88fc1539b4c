#include "tests/fuzz/check_measured.hpp"

namespace twofold::hostile {

bool merl(Input bytes) {
    return reads(ExitCode::bad_file, [&] { check_measured(parse_merl(bytes, file_name)); });
}

}  // namespace twofold::hostile
