#pragma once
#include <string>
#include <string_view>

namespace twofold::bench {

/// The processor's name, as the kernel gives it.
std::string processor_name();

/// Whether the processor names an instruction set among its features, such as "avx512bw".
bool processor_has(std::string_view feature);

/// MiB of this process's largest resident set so far. From /proc: getrusage() counts what the
/// parent held when it started the process.
double peak_mebibytes();

}  // namespace twofold::bench
