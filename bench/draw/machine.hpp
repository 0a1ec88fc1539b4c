#pragma once
#include <string>
#include <string_view>

namespace twofold::bench {

/// The processor's name, as the kernel gives it.
std::string processor_name();

/// Whether the processor names an instruction set among its features, such as "avx512bw".
bool processor_has(std::string_view feature);

}  // namespace twofold::bench
