#pragma once
#include <string>

namespace twofold {

/// What makes floating-point arithmetic inexact here and now: the names of the broken properties
/// among "contraction", "rounding mode", "flush to zero" and "denormals are zero", joined by ", ";
/// empty when all is well. Another library, or a compiler flag, can break each of them in a running
/// process. It sees the calling thread's processor state and this file's flags;
/// tests/checks/fused.sh sees every object file. Takes well under a microsecond.
std::string floating_point_defects();

}  // namespace twofold
