#include "tests/fuzz/check_mesh.hpp"

namespace twofold::hostile {

bool obj(Input bytes) {
    return reads(ExitCode::bad_file, [&] { check_mesh(parse_obj(text_of(bytes), file_name)); });
}

}  // namespace twofold::hostile
