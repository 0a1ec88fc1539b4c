#include "bench/draw/machine.hpp"

#include <fmt/format.h>

#include <fstream>

namespace twofold::bench {
namespace {

/// What follows the colon of the first such line.
std::string field_of_processor(std::string_view name) {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with(name)) return line.substr(line.find(':') + 1);
    return {};
}

}  // namespace

std::string processor_name() {
    const std::string name = field_of_processor("model name");
    return name.empty() ? std::string("a processor without a name") : name.substr(1);
}

bool processor_has(std::string_view feature) {
    const std::string features = field_of_processor("flags") + " ";
    return features.find(fmt::format(" {} ", feature)) != std::string::npos;
}

}  // namespace twofold::bench
