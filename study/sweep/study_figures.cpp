#include "study/sweep/study_figures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "study/sweep/cell_view.hpp"
#include "study/sweep/figure.hpp"

namespace twofold {
namespace {

using Json = nlohmann::ordered_json;
using Field = std::optional<double> CellView::*;

constexpr const char* error_label = "RMS error against exact, steps of 1/255";
constexpr const char* ideal_label = "RMS error against ideal64, steps of 1/255";

/// Results with what every figure asks of them.
struct Views {
    const StudyResults& results;
    std::vector<std::string> names = cell_names(results.plan);
    double anchor = anchor_seconds(results);

    const std::string& id(const PlannedPoint& p) const { return results.plan.cells[p.cell].id; }
    const Json& json(const PlannedPoint& p) const { return results.cells.at(id(p)); }
    CellView view(const PlannedPoint& p) const { return view_of(json(p), anchor); }
};

/// One series an axis: judged error over a time in `unit` seconds.
std::vector<FigureSeries> trade_series(const Views& views, Field time, double unit) {
    std::vector<FigureSeries> all;
    for (const PlannedAxis& axis : views.results.plan.axes) {
        FigureSeries series{axis.title, axis.name, {}};
        for (const PlannedPoint& point : axis.points) {
            const CellView view = views.view(point);
            const auto x = view.*time, y = judged_error(view);
            if (!x || !y || *x <= 0.0 || *y <= 0.0) continue;
            series.marks.push_back({{*x / unit, *y},
                                    views.id(point),
                                    fmt::format("{}: {} — {:.3g} steps, {:.4g}", axis.title,
                                                point.label, *y, *x / unit)});
        }
        if (!series.marks.empty()) all.push_back(std::move(series));
    }
    return all;
}

std::vector<CurvePoint> front_of(const std::vector<FigureSeries>& series) {
    std::vector<CurvePoint> points, front;
    for (const FigureSeries& s : series)
        for (const FigureMark& mark : s.marks) points.push_back(mark.at);
    for (const std::size_t i : pareto_front(points)) front.push_back(points[i]);
    return front;
}

StudyFigure trade_figure(const Views& views, const char* name, const char* heading,
                         const char* remark, const char* x_label, Field time) {
    PointFigure figure{name, heading, x_label, error_label, true, true, {}, {}};
    figure.series = trade_series(views, time, 1e-3);
    figure.front = front_of(figure.series);
    return {name, heading, remark, figure.series.empty() ? "" : svg_of(figure)};
}

/// The largest error first; labels that both axes have.
BarFigure budget_of(const Views& views, const PlannedAxis& alone, const PlannedAxis* back) {
    BarFigure figure{"budget", "Error by stage", ideal_label, {alone.title}, {}};
    if (back) figure.parts.push_back(back->title);
    for (const PlannedPoint& point : alone.points) {
        FigureBar bar{point.label, {}};
        const auto add = [&](const PlannedPoint& p) {
            const double value = views.view(p).ideal.value_or(0.0);
            bar.marks.push_back(
                {{0.0, value}, views.id(p), fmt::format("{}: {:.4g} steps", p.label, value)});
        };
        add(point);
        if (back)
            for (const PlannedPoint& other : back->points)
                if (other.label == point.label) add(other);
        figure.bars.push_back(std::move(bar));
    }
    return figure;
}

/// The name with what the fitted line says.
std::string with_slope(const char* name, const std::vector<CurvePoint>& points, bool linear) {
    const auto slope = linear ? fitted_doublings(points) : fitted_power(points);
    if (!slope) return name;
    return linear ? fmt::format("{}: times 2^{:.2f} a step", name, *slope)
                  : fmt::format("{}: slope {:.2f}", name, *slope);
}

FigureSeries line_series(const Views& views, const PlannedAxis& axis, const char* name,
                         Field field) {
    FigureSeries series{name, axis.name, {}, true};
    std::vector<CurvePoint> points;
    for (const PlannedPoint& point : axis.points) {
        const auto y = views.view(point).*field;
        if (!point.value || !y || *y <= 0.0 || (!axis.linear && *point.value <= 0.0)) continue;
        points.push_back({*point.value, *y});
        series.marks.push_back(
            {points.back(), views.id(point), fmt::format("{}: {:.4g}", point.label, *y)});
    }
    std::stable_sort(series.marks.begin(), series.marks.end(),
                     [](const auto& a, const auto& b) { return a.at.x < b.at.x; });
    series.name = with_slope(name, points, axis.linear);
    return series;
}

StudyFigure line_figure(const Views& views, const PlannedAxis& axis) {
    const bool ideal = axis.against == AxisReference::ideal64;
    PointFigure figure{axis.name,    "Error by " + axis.title,
                       axis.title,   ideal ? ideal_label : "relative RMS error",
                       !axis.linear, true,
                       {},           {}};
    using Line = std::pair<const char*, Field>;
    const std::vector<Line> lines =
        ideal ? std::vector<Line>{{"picture against ideal64", &CellView::ideal}}
              : std::vector<Line>{{"picture against exact", &CellView::relative},
                                  {"product at held-out samples", &CellView::held_out},
                                  {"the same with maps of 8 bits", &CellView::held_out_bytes}};
    for (const auto& [name, field] : lines) {
        FigureSeries series = line_series(views, axis, name, field);
        if (!series.marks.empty()) figure.series.push_back(std::move(series));
    }
    return {axis.name, axis.title,
            axis.linear
                ? "The slope is that of the least-squares line through the logarithms."
                : "Logarithmic on both axes: the error grows as the setting to the power of "
                  "the fitted slope.",
            figure.series.empty() ? "" : svg_of(figure)};
}

StudyFigure bar_figure(const Views& views, const PlannedAxis& axis) {
    const bool ideal = axis.against == AxisReference::ideal64;
    BarFigure figure{
        axis.name, "Error by " + axis.title, ideal ? ideal_label : error_label, {"error"}, {}};
    for (const PlannedPoint& point : axis.points) {
        const CellView view = views.view(point);
        if (const auto error = ideal ? view.ideal : judged_error(view))
            figure.bars.push_back({point.label,
                                   {{{0.0, *error},
                                     views.id(point),
                                     fmt::format("{}: {:.4g} steps", point.label, *error)}}});
    }
    return {axis.name, axis.title, "", figure.bars.empty() ? "" : svg_of(figure)};
}

/// Residuals of the first material's green channel, iteration by iteration.
FigureSeries history_of(const Views& views, const PlannedAxis& axis, const PlannedPoint& point) {
    FigureSeries series{point.label, axis.name, {}, true, false};
    const Json& json = views.json(point);
    if (!json.contains("fit") || json.at("fit").is_null()) return series;
    double iteration = 0.0;
    for (const Json& residual : json.at("fit").begin()->at("channels").at(1).at("history"))
        if (iteration += 1.0; residual.is_number())
            series.marks.push_back({{iteration, residual.get<double>()}, "", ""});
    return series;
}

StudyFigure convergence_figure(const Views& views, const PlannedAxis& axis) {
    PointFigure figure{"convergence",
                       "Convergence of the solvers",
                       "iterations",
                       "relative residual",
                       false,
                       true,
                       {},
                       {}};
    for (const PlannedPoint& point : axis.points) {
        FigureSeries series = history_of(views, axis, point);
        if (!series.marks.empty()) figure.series.push_back(std::move(series));
    }
    return {"convergence", "Convergence of the solvers",
            "|A^T r| over |A^T b| after each iteration, green channel of the first material.",
            figure.series.empty() ? "" : svg_of(figure)};
}

void drop_empty(std::vector<StudyFigure>& figures) {
    std::erase_if(figures, [](const StudyFigure& f) { return f.svg.empty(); });
}

}  // namespace

std::vector<StudyFigure> trade_figures(const StudyResults& results) {
    const Views views{results};
    std::vector<StudyFigure> figures{
        trade_figure(
            views, "error-frame", "Error over the time of a frame",
            "Processor time of one frame on this machine, one thread: the least of several "
            "rounds. The line joins the cells that no other beats in both.",
            "milliseconds a frame", &CellView::frame),
        trade_figure(views, "error-before", "Error over the time before the first frame",
                     "Sampling and factoring, wall time; cells that share the samples count their "
                     "share of them.",
                     "milliseconds before the first frame", &CellView::before),
        trade_figure(views, "error-card", "Error over the predicted time on the paper's card",
                     "A model, not a measurement: see Provenance.",
                     "milliseconds a frame, predicted", &CellView::card)};
    drop_empty(figures);
    return figures;
}

std::vector<StudyFigure> budget_figures(const StudyResults& results) {
    const Views views{results};
    std::vector<const PlannedAxis*> axes;
    for (const PlannedAxis& axis : results.plan.axes)
        if (axis.plot == AxisPlot::budget) axes.push_back(&axis);
    if (axes.empty()) return {};
    const BarFigure figure = budget_of(views, *axes[0], axes.size() > 1 ? axes[1] : nullptr);
    return {
        {figure.name, figure.title,
         "One stage at a time. Left to right: what that stage alone does to a picture that is "
         "otherwise computed with wide registers, and what is left when it alone is made wide in "
         "the card's pipeline.",
         svg_of(figure)}};
}

std::vector<StudyFigure> axis_figures(const StudyResults& results) {
    const Views views{results};
    std::vector<StudyFigure> figures;
    for (const PlannedAxis& axis : results.plan.axes) {
        if (axis.plot == AxisPlot::line) figures.push_back(line_figure(views, axis));
        if (axis.plot == AxisPlot::bars) figures.push_back(bar_figure(views, axis));
        if (axis.name == "solver") figures.push_back(convergence_figure(views, axis));
    }
    drop_empty(figures);
    return figures;
}

}  // namespace twofold
