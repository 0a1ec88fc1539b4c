#include "tests/fuzz/readers.hpp"

/// libFuzzer's entry for one reader; an exception that leaves it is a finding. Files that do not
/// begin as the target's format does go to another target.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::string_view magic = TWOFOLD_FUZZ_MAGIC;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    if (!text.starts_with(magic)) return -1;
    twofold::hostile::TWOFOLD_FUZZ_READER({data, size});
    return 0;
}
