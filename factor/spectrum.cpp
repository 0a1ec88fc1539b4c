#include "factor/spectrum.hpp"

#include <array>
#include <cstddef>

namespace twofold {
namespace {

constexpr double first_nm = 400.0, last_nm = 700.0, step_nm = 10.0;

/// x, y, z of the observer and D65's relative power.
struct Row {
    double x, y, z, power;
};

constexpr std::array<Row, 31> table{{
    {0.01431, 0.000396, 0.06785, 82.7549}, {0.04351, 0.00121, 0.2074, 91.486},
    {0.13438, 0.0040, 0.6456, 93.4318},    {0.2839, 0.0116, 1.3856, 86.6823},
    {0.34828, 0.0230, 1.74706, 104.865},   {0.3362, 0.0380, 1.77211, 117.008},
    {0.2908, 0.0600, 1.6692, 117.812},     {0.19536, 0.09098, 1.28764, 114.861},
    {0.09564, 0.13902, 0.81295, 115.923},  {0.03201, 0.20802, 0.46518, 108.811},
    {0.0049, 0.3230, 0.2720, 109.354},     {0.0093, 0.5030, 0.1582, 107.802},
    {0.06327, 0.7100, 0.07825, 104.79},    {0.1655, 0.8620, 0.04216, 107.689},
    {0.2904, 0.9540, 0.0203, 104.405},     {0.43345, 0.99495, 0.00875, 104.046},
    {0.5945, 0.9950, 0.0039, 100.0},       {0.7621, 0.9520, 0.0021, 96.3342},
    {0.9163, 0.8700, 0.00165, 95.788},     {1.0263, 0.7570, 0.0011, 88.6856},
    {1.0622, 0.6310, 0.0008, 90.0062},     {1.0026, 0.5030, 0.00034, 89.5991},
    {0.85445, 0.3810, 0.00019, 87.6987},   {0.6424, 0.2650, 0.00005, 83.2886},
    {0.4479, 0.1750, 0.00002, 83.6992},    {0.2835, 0.1070, 0.0, 80.0268},
    {0.1649, 0.0610, 0.0, 80.2146},        {0.0874, 0.0320, 0.0, 82.2778},
    {0.04677, 0.0170, 0.0, 78.2842},       {0.0227, 0.00821, 0.0, 69.7213},
    {0.011359, 0.004102, 0.0, 71.6091},
}};

Vec3 lit_observer(const Row& row) { return row.power * Vec3(row.x, row.y, row.z); }

/// Observer times illuminant at a wavelength.
Vec3 lit_observer_at(double nm) {
    if (nm < first_nm || nm > last_nm) return Vec3(0.0);
    const double position = (nm - first_nm) / step_nm;
    std::size_t i = 0;
    while (i + 2 < table.size() && static_cast<double>(i + 1) <= position) ++i;
    const double t = position - static_cast<double>(i);
    return (1.0 - t) * lit_observer(table[i]) + t * lit_observer(table[i + 1]);
}

/// Linear sRGB of an XYZ colour. @source IEC 61966-2-1
Rgb srgb_of(Vec3 c) {
    return {3.2406 * c.x - 1.5372 * c.y - 0.4986 * c.z, -0.9689 * c.x + 1.8758 * c.y + 0.0415 * c.z,
            0.0557 * c.x - 0.2040 * c.y + 1.0570 * c.z};
}

/// Trapezoid rule: half the way to either neighbour.
double width_at(std::span<const double> nm, std::size_t k) {
    const double left = k > 0 ? nm[k] - nm[k - 1] : 0.0;
    const double right = k + 1 < nm.size() ? nm[k + 1] - nm[k] : 0.0;
    return 0.5 * (left + right);
}

}  // namespace

std::vector<Rgb> spectrum_weights(std::span<const double> wavelengths) {
    std::vector<Rgb> weights;
    Rgb white(0.0);
    for (std::size_t k = 0; k < wavelengths.size(); ++k) {
        weights.push_back(srgb_of(width_at(wavelengths, k) * lit_observer_at(wavelengths[k])));
        white += weights.back();
    }
    for (Rgb& weight : weights) weight /= white;
    return weights;
}

Vec2 tabulated_white() {
    Vec3 sum(0.0);
    for (const Row& row : table) sum += lit_observer(row);
    const double total = sum.x + sum.y + sum.z;
    return {sum.x / total, sum.y / total};
}

}  // namespace twofold
