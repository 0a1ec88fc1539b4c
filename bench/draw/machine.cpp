#include "bench/draw/machine.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

namespace twofold::bench {
namespace {

/// What follows the colon of the file's first such line.
std::string field_of(const char* path, std::string_view name) {
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);)
        if (line.starts_with(name)) return line.substr(line.find(':') + 1);
    return {};
}

}  // namespace

std::string processor_name() {
    const std::string name = field_of("/proc/cpuinfo", "model name");
    return name.empty() ? std::string("a processor without a name") : name.substr(1);
}

bool processor_has(std::string_view feature) {
    const std::string features = field_of("/proc/cpuinfo", "flags") + " ";
    return features.find(fmt::format(" {} ", feature)) != std::string::npos;
}

double peak_mebibytes() {
    std::istringstream text(field_of("/proc/self/status", "VmHWM"));
    double kibibytes = 0.0;
    text >> kibibytes;
    return kibibytes / 1024.0;
}

}  // namespace twofold::bench
