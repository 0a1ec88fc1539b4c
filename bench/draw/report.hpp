#pragma once
#include <string>
#include <vector>

#include "bench/draw/figures.hpp"

namespace twofold::bench {

/// Everything that a run of bench_draw found.
struct DrawReport {
    std::string machine;  ///< the processor's name
    std::vector<PictureCheck> pictures;
    std::vector<Row> rows;
    std::vector<Series> growth;
    std::vector<Figure> figures;
};

/// One line of a row, a check or a figure, as they become known.
std::string line_of(const PictureCheck& check);
std::string line_of(const Row& row);
std::string line_of(const Figure& figure);
std::string lines_of(const Series& series);
std::string row_heading();

std::string json_of(const DrawReport& report);
std::string markdown_of(const DrawReport& report);

/// `document` with what stands between the two markers of a program replaced.
/// @throws Error(bad_file) naming `file` if a marker is missing
std::string with_table(const std::string& document, const std::string& table,
                       const std::string& file, const std::string& program = "bench_draw");

}  // namespace twofold::bench
