#pragma once
#include <string>

namespace twofold {

/// The processor that this runs on, as the system names it; "unknown" where it does not.
std::string processor_name();

/// The compiler that built this.
std::string compiler_name();

}  // namespace twofold
