#pragma once
#include <functional>
#include <string>
#include <vector>

/// What is timed with a rule of exactness and without. Outside namespace twofold, which two builds
/// of the same sources go by other names of.
namespace price {

struct Work {
    std::string name;
    std::function<void()> run;
};

/// A work under the rule and the same without it.
struct Pair {
    std::string rule;
    Work with, without;
};

}  // namespace price

namespace twofold_exact {
std::vector<price::Work> works();
}

namespace twofold_fused {
std::vector<price::Work> works();
}
