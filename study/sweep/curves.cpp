#include "study/sweep/curves.hpp"

#include <algorithm>
#include <numeric>

#include "texunit/exact_math.hpp"

namespace twofold {

std::vector<std::size_t> pareto_front(std::span<const CurvePoint> points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return points[a].x != points[b].x ? points[a].x < points[b].x : points[a].y < points[b].y;
    });
    std::vector<std::size_t> front;
    for (const std::size_t i : order)
        if (front.empty() || points[i].y < points[front.back()].y) front.push_back(i);
    return front;
}

std::optional<double> fitted_slope(std::span<const CurvePoint> points) {
    const auto count = static_cast<double>(points.size());
    double mean_x = 0.0, mean_y = 0.0, square = 0.0, product = 0.0;
    for (const CurvePoint& p : points) {
        mean_x += p.x / count;
        mean_y += p.y / count;
    }
    for (const CurvePoint& p : points) {
        square += (p.x - mean_x) * (p.x - mean_x);
        product += (p.x - mean_x) * (p.y - mean_y);
    }
    return square > 0.0 ? std::optional(product / square) : std::nullopt;
}

std::optional<double> fitted_power(std::span<const CurvePoint> points) {
    std::vector<CurvePoint> logs;
    for (const CurvePoint& p : points) {
        if (!(p.x > 0.0 && p.y > 0.0)) return std::nullopt;
        logs.push_back({exact::log(p.x), exact::log(p.y)});
    }
    return fitted_slope(logs);
}

std::optional<double> fitted_doublings(std::span<const CurvePoint> points) {
    std::vector<CurvePoint> logs;
    for (const CurvePoint& p : points) {
        if (!(p.y > 0.0)) return std::nullopt;
        logs.push_back({p.x, exact::log(p.y) / exact::log(2.0)});
    }
    return fitted_slope(logs);
}

}  // namespace twofold
