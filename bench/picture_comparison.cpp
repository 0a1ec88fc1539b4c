#include "bench/picture_comparison.hpp"

#include <algorithm>
#include <cstdlib>

namespace twofold::bench {
namespace {

int largest_step(Rgba8 a, Rgba8 b) {
    return std::max(
        {std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b), std::abs(a.a - b.a)});
}

}  // namespace

double PictureComparison::equal_share() const {
    return compared() == 0 ? 1.0 : static_cast<double>(steps[0]) / static_cast<double>(compared());
}

void compare_pictures(const ByteImage& ours, const ByteImage& theirs, Rgba8 background,
                      const std::vector<bool>& left_out, PictureComparison& sum) {
    sum.pixels += ours.pixels.size();
    for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
        const Rgba8 a = ours.pixels[i], b = theirs.pixels[i];
        if ((a == background) != (b == background)) {
            ++sum.coverage;
        } else if (!left_out.empty() && left_out[i]) {
            ++sum.left_out;
        } else {
            const int step = largest_step(a, b);
            ++sum.steps[std::min<std::size_t>(static_cast<std::size_t>(step), 5)];
            if (step <= sum.worst) continue;
            sum.worst = step;
            const auto width = static_cast<std::size_t>(ours.width);
            sum.worst_pixel = {static_cast<int>(i % width), static_cast<int>(i / width), a, b};
        }
    }
}

}  // namespace twofold::bench
