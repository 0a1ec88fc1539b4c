#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "study/sweep/curves.hpp"

/// Figures as values, and as SVG: the same drawing goes into the page and into a file of its own.
namespace twofold {

/// A point that stands for a cell.
struct FigureMark {
    CurvePoint at;
    std::string cell;   ///< id; empty if it stands for none
    std::string title;  ///< what it says when pointed at
};

struct FigureSeries {
    std::string name;  ///< as the key shows it
    std::string axis;  ///< name of the study's axis, by which the page filters
    std::vector<FigureMark> marks;
    bool joined = false;  ///< by a line, in the order of the marks
    bool marked = true;   ///< with a sign at each mark
};

/// Points over two axes.
struct PointFigure {
    std::string name;   ///< of the file
    std::string title;  ///< for who cannot see it
    std::string x_label, y_label;
    bool log_x = false, log_y = false;
    std::vector<FigureSeries> series;
    std::vector<CurvePoint> front;  ///< drawn as a stair; may be empty
};

/// One or two values and what they are of.
struct FigureBar {
    std::string label;
    std::vector<FigureMark> marks;  ///< one for each of the figure's parts; at.y is the value
};

struct BarFigure {
    std::string name, title, x_label;
    std::vector<std::string> parts;  ///< names of the bars of a row; one needs no key
    std::vector<FigureBar> bars;
};

/// @return an svg element without style of its own
std::string svg_of(const PointFigure& figure);
std::string svg_of(const BarFigure& figure);

/// An SVG file of an element made above.
std::string svg_file(const std::string& element, std::string_view style);

/// The values at which an axis from `low` to `high` is labelled: round numbers, or powers of ten
/// and their parts; at most about eight.
std::vector<double> axis_ticks(double low, double high, bool logarithmic);

}  // namespace twofold
