#include "study/sweep/figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/page_text.hpp"
#include "texunit/exact_math.hpp"

namespace twofold {
namespace {

constexpr double width = 760.0, height = 400.0;
constexpr double left = 62.0, right = 18.0, top = 14.0, bottom = 46.0;
constexpr int styles = 8;  ///< colours and signs before they repeat

double log10_of(double x) { return exact::log(x) / exact::log(10.0); }

/// One axis: from values to places on the paper.
struct Scale {
    double low = 0.0, high = 1.0;  ///< values, or their logarithms
    double from = 0.0, to = 1.0;   ///< places
    bool logarithmic = false;

    double place(double value) const {
        const double v = logarithmic ? log10_of(value) : value;
        return from + (to - from) * (v - low) / (high - low);
    }
    bool holds(double value) const {
        const double v = logarithmic && value > 0.0 ? log10_of(value) : value;
        return (!logarithmic || value > 0.0) && v >= low - 1e-9 && v <= high + 1e-9;
    }
};

/// A scale that holds all values, with some room at both ends; a linear one begins at 0.
Scale scale_of(const std::vector<double>& values, bool logarithmic, double from, double to) {
    Scale scale{0.0, 1.0, from, to, logarithmic};
    bool any = false;
    for (const double value : values) {
        if (logarithmic && !(value > 0.0)) continue;
        const double v = logarithmic ? log10_of(value) : value;
        scale.low = any ? std::min(scale.low, v) : v;
        scale.high = any ? std::max(scale.high, v) : v;
        any = true;
    }
    if (!logarithmic) scale.low = std::min(0.0, scale.low);
    const double room = 0.05 * std::max(scale.high - scale.low, logarithmic ? 0.4 : 1e-9);
    scale.high += room;
    if (logarithmic) scale.low -= room;
    return scale;
}

std::string number_text(double value) {
    if (value == 0.0) return "0";
    if (value >= 1e5 || value < 1e-4) return fmt::format("{:.0e}", value);
    return fmt::format("{:.4g}", value);
}

/// The sign of a series at (0, 0), so that colours alone need not tell series apart.
std::string_view sign_of(std::size_t series) {
    constexpr std::array<std::string_view, 4> signs{
        "<circle r='4.5'/>", "<rect x='-4' y='-4' width='8' height='8'/>",
        "<path d='M0-5.5 5 4H-5Z'/>", "<path d='M0-6 5.5 0 0 6-5.5 0Z'/>"};
    return signs[series % signs.size()];
}

std::string label(double x, double y, const std::string& text, const char* anchor) {
    return fmt::format("<text x='{:.1f}' y='{:.1f}' text-anchor='{}'>{}</text>", x, y, anchor,
                       html_text(text));
}

std::string line(double x1, double y1, double x2, double y2, const char* kind) {
    return fmt::format("<line x1='{:.1f}' y1='{:.1f}' x2='{:.1f}' y2='{:.1f}' class='{}'/>", x1, y1,
                       x2, y2, kind);
}

/// The largest power of ten that is not above `x`, which is above 0.
double decade_of(double x) {
    double decade = 1.0;
    while (decade > x) decade /= 10.0;
    while (decade * 10.0 <= x) decade *= 10.0;
    return decade;
}

/// Powers of ten, and their doubles and fives where there are few.
std::vector<double> logarithmic_ticks(double low, double high) {
    std::vector<double> ticks;
    const bool few = high / low < 30.0;
    for (double decade = decade_of(low); decade <= high; decade *= 10.0)
        for (const double part : {1.0, 2.0, 5.0})
            if ((few || part == 1.0) && decade * part >= low && decade * part <= high)
                ticks.push_back(decade * part);
    return ticks;
}

std::vector<double> linear_ticks(double low, double high) {
    const double decade = decade_of(high - low);
    double step = decade;
    for (const double part : {0.5, 0.2})
        if ((high - low) / (decade * part) <= 8.0) step = decade * part;
    std::vector<double> ticks;
    for (double k = std::ceil(low / step); k * step <= high; k += 1.0) ticks.push_back(k * step);
    return ticks;
}

std::vector<double> ticks_of(const Scale& s) {
    const double low = s.logarithmic ? exact::exp(s.low * exact::log(10.0)) : s.low;
    const double high = s.logarithmic ? exact::exp(s.high * exact::log(10.0)) : s.high;
    return axis_ticks(low, high, s.logarithmic);
}

std::string axes_svg(const PointFigure& figure, const Scale& x, const Scale& y) {
    std::string svg;
    for (const double tick : ticks_of(y)) {
        if (!y.holds(tick)) continue;
        svg += line(left, y.place(tick), width - right, y.place(tick), "grid");
        svg += label(left - 8.0, y.place(tick) + 4.0, number_text(tick), "end");
    }
    for (const double tick : ticks_of(x)) {
        if (!x.holds(tick)) continue;
        svg += line(x.place(tick), top, x.place(tick), height - bottom, "grid");
        svg += label(x.place(tick), height - bottom + 18.0, number_text(tick), "middle");
    }
    svg += label((left + width - right) / 2.0, height - 8.0, figure.x_label, "middle");
    const double middle = (top + height - bottom) / 2.0;
    return svg + fmt::format(
                     "<text transform='translate(14 {:.1f}) rotate(-90)' "
                     "text-anchor='middle'>{}</text>",
                     middle, html_text(figure.y_label));
}

/// A mark of a cell is a button; one of none is a sign alone.
std::string mark_svg(const FigureMark& mark, double x, double y, std::string_view sign) {
    const std::string title = fmt::format("<title>{}</title>", html_text(mark.title));
    const std::string place = fmt::format("transform='translate({:.1f} {:.1f})'", x, y);
    if (mark.cell.empty()) return fmt::format("<g {}>{}{}</g>", place, title, sign);
    return fmt::format("<g {} class='point' data-cell='{}' tabindex='0' role='button'>{}{}</g>",
                       place, mark.cell, title, sign);
}

std::string series_svg(const FigureSeries& series, std::size_t number, const Scale& x,
                       const Scale& y) {
    std::string signs, points;
    for (const FigureMark& mark : series.marks) {
        if (!x.holds(mark.at.x) || !y.holds(mark.at.y)) continue;
        const double px = x.place(mark.at.x), py = y.place(mark.at.y);
        points += fmt::format("{:.1f},{:.1f} ", px, py);
        if (series.marked) signs += mark_svg(mark, px, py, sign_of(number));
    }
    const std::string joined =
        series.joined ? fmt::format("<polyline class='line' points='{}'/>", points) : "";
    return fmt::format("<g class='series s{}' data-axis='{}'>{}{}</g>", number % styles,
                       html_text(series.axis), joined, signs);
}

/// The stair of what no other point beats.
std::string front_svg(const std::vector<CurvePoint>& front, const Scale& x, const Scale& y) {
    std::string points;
    for (std::size_t i = 0; i < front.size(); ++i) {
        const double px = x.place(front[i].x), py = y.place(front[i].y);
        if (i > 0) points += fmt::format("{:.1f},{:.1f} ", px, y.place(front[i - 1].y));
        points += fmt::format("{:.1f},{:.1f} ", px, py);
    }
    return front.empty() ? "" : fmt::format("<polyline class='front' points='{}'/>", points);
}

/// Where the names of series go under a figure.
struct KeyPlace {
    double x;
    int row;
};

std::vector<KeyPlace> key_places(const std::vector<std::string>& names) {
    std::vector<KeyPlace> places;
    double x = left;
    int row = 0;
    for (const std::string& name : names) {
        const double wide = 30.0 + 6.3 * static_cast<double>(name.size());
        if (x > left && x + wide > width) {
            x = left;
            ++row;
        }
        places.push_back({x, row});
        x += wide;
    }
    return places;
}

constexpr double key_row = 20.0;

std::string key_svg(const std::vector<std::string>& names, double y0) {
    const std::vector<KeyPlace> places = key_places(names);
    std::string svg;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const double y = y0 + key_row * places[i].row;
        svg += fmt::format("<g class='s{}' transform='translate({:.1f} {:.1f})'>{}</g>", i % styles,
                           places[i].x + 6.0, y - 4.0, sign_of(i));
        svg += label(places[i].x + 17.0, y, names[i], "start");
    }
    return svg;
}

double key_height(const std::vector<std::string>& names) {
    return names.empty() ? 0.0 : key_row * (key_places(names).back().row + 1);
}

std::string element(const std::string& title, double tall, const std::string& content) {
    return fmt::format(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {:.0f} {:.0f}' class='figure' "
        "role='group' aria-label='{}'>{}</svg>",
        width, tall, html_text(title), content);
}

std::string bar_svg(const FigureMark& mark, double x0, double x1, double y, double thick,
                    std::size_t part) {
    const std::string rectangle =
        fmt::format("<rect width='{:.1f}' height='{:.1f}'/>", std::max(1.0, x1 - x0), thick);
    return fmt::format("<g class='s{}'>{}</g>", part % styles, mark_svg(mark, x0, y, rectangle)) +
           label(x1 + 6.0, y + thick - 2.0, number_text(mark.at.y), "start");
}

std::vector<std::string> names_of(const std::vector<FigureSeries>& series) {
    std::vector<std::string> names;
    for (const FigureSeries& s : series) names.push_back(s.name);
    return names;
}

}  // namespace

std::vector<double> axis_ticks(double low, double high, bool logarithmic) {
    if (!(high > low)) return {};
    return logarithmic && low > 0.0 ? logarithmic_ticks(low, high) : linear_ticks(low, high);
}

std::string svg_of(const PointFigure& figure) {
    std::vector<double> xs, ys;
    for (const FigureSeries& series : figure.series)
        for (const FigureMark& mark : series.marks) {
            xs.push_back(mark.at.x);
            ys.push_back(mark.at.y);
        }
    const Scale x = scale_of(xs, figure.log_x, left, width - right);
    const Scale y = scale_of(ys, figure.log_y, height - bottom, top);
    std::string svg = axes_svg(figure, x, y) + front_svg(figure.front, x, y);
    for (std::size_t i = 0; i < figure.series.size(); ++i)
        svg += series_svg(figure.series[i], i, x, y);
    const auto names = names_of(figure.series);
    return element(figure.title, height + key_height(names) + 6.0,
                   svg + key_svg(names, height + 14.0));
}

std::string svg_of(const BarFigure& figure) {
    constexpr double names_width = 250.0, thick = 11.0, gap = 8.0;
    const double row = thick * static_cast<double>(figure.parts.size()) + gap;
    std::vector<double> values;
    for (const FigureBar& bar : figure.bars)
        for (const FigureMark& mark : bar.marks) values.push_back(mark.at.y);
    const Scale x = scale_of(values, false, names_width, width - 60.0);
    std::string svg;
    double y = 6.0;
    for (const FigureBar& bar : figure.bars) {
        svg += label(names_width - 10.0, y + row / 2.0, bar.label, "end");
        for (std::size_t part = 0; part < bar.marks.size(); ++part)
            svg += bar_svg(bar.marks[part], names_width, x.place(bar.marks[part].at.y),
                           y + thick * static_cast<double>(part), thick - 1.0, part);
        y += row;
    }
    svg += label((names_width + width) / 2.0, y + 16.0, figure.x_label, "middle");
    const auto names = figure.parts.size() > 1 ? figure.parts : std::vector<std::string>{};
    return element(figure.title, y + 30.0 + key_height(names), svg + key_svg(names, y + 40.0));
}

std::string svg_file(const std::string& element, std::string_view style) {
    const std::size_t after = element.find('>') + 1;
    return "<?xml version='1.0' encoding='UTF-8'?>\n" + element.substr(0, after) +
           fmt::format("<style>{}</style>", style) + element.substr(after) + "\n";
}

}  // namespace twofold
