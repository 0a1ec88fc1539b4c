#pragma once
#include <string>
#include <vector>

#include "bench/check.hpp"

namespace twofold::bench {

/// A line of the table on the terminal.
std::string heading();
std::string text_of(const Row& row);

/// All rows for machines.
std::string json_of(const Driver& driver, const std::string& version, const std::vector<Row>& rows);

}  // namespace twofold::bench
