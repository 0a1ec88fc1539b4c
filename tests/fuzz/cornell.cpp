#include "tests/fuzz/check_measured.hpp"

namespace twofold::hostile {

bool cornell(Input bytes) {
    return reads(ExitCode::bad_file,
                 [&] { check_measured(parse_cornell(text_of(bytes), file_name)); });
}

}  // namespace twofold::hostile
