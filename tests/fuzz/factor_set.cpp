#include "scenes/factor_set.hpp"

#include "tests/fuzz/promises.hpp"

namespace twofold::hostile {

bool factor_set(Input bytes) {
    return reads(ExitCode::bad_file, [&] {
        const FactorSet set = parse_factor_set(text_of(bytes), file_name);
        promise(max_component(set.alpha) <= 1e6, "alpha beyond its limit");
        promise(printable(set.name, set.name.size()) == set.name, "the name is not printable");
    });
}

}  // namespace twofold::hostile
