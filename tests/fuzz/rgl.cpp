#include "tests/fuzz/check_measured.hpp"

namespace twofold::hostile {

bool rgl(Input bytes) {
    return reads(ExitCode::bad_file, [&] { check_measured(parse_rgl(bytes, file_name)); });
}

}  // namespace twofold::hostile
