#include <fmt/format.h>

#include <cmath>

#include "factor/measured_data.hpp"
#include "factor/spectrum.hpp"
#include "texunit/error.hpp"
#include "texunit/exact_math.hpp"
#include "texunit/number_text.hpp"

namespace twofold {
namespace {

constexpr double most_wavelengths = 1024.0;
constexpr double most_value = 1e9;
/// Cornell's files have 1,439 each; a value between samples looks at all of them.
constexpr std::size_t most_samples = 100'000;

/// The numbers of a text, comments left out.
class Numbers {
  public:
    Numbers(std::string_view text, std::string_view name) : rest_(text), name_(name) {}

    bool done() {
        while (line_.empty() && !rest_.empty()) next_line();
        return line_.empty();
    }

    /// The next number, which `what` names and which must lie in [low, high].
    double next(std::string_view what, double low, double high) {
        const std::string_view word = done() ? std::string_view() : take_word(line_);
        const auto number = parse_real(word);
        if (!number || !(*number >= low && *number <= high))
            fail(fmt::format("{}: {} is no number of {} to {}", what,
                             word.empty() ? "the end" : fmt::format("'{}'", printable(word, 32)),
                             low, high));
        skip_blanks();
        return *number;
    }

    [[noreturn]] void fail(std::string_view what) const {
        throw Error(ExitCode::bad_file, fmt::format("{}: line {}: {}", name_, line_number_, what));
    }

  private:
    void next_line() {
        line_ = take_line(rest_);
        line_ = line_.substr(0, line_.find('#'));
        ++line_number_;
        skip_blanks();
    }
    void skip_blanks() {
        const std::size_t first = line_.find_first_not_of(" \t");
        line_ = first == std::string_view::npos ? std::string_view() : line_.substr(first);
    }

    std::string_view rest_, line_;
    std::string name_;
    int line_number_ = 0;
};

std::vector<double> read_wavelengths(Numbers& numbers) {
    const double count = numbers.next("number of wavelengths", 2.0, most_wavelengths);
    if (std::floor(count) != count) numbers.fail(fmt::format("{} wavelengths", count));
    std::vector<double> wavelengths;
    while (static_cast<double>(wavelengths.size()) < count) {
        const double low = wavelengths.empty() ? 1.0 : wavelengths.back() + 1e-3;
        wavelengths.push_back(numbers.next("wavelength", low, 1e5));
    }
    if (wavelengths.back() <= 400.0 || wavelengths.front() >= 700.0)
        numbers.fail("no wavelength within 400 to 700 nm");
    return wavelengths;
}

Vec3 read_direction(Numbers& numbers, std::string_view which) {
    const double theta = numbers.next(fmt::format("theta_{}", which), 0.0, exact::pi / 2.0);
    const double phi = numbers.next(fmt::format("phi_{}", which), -7.0, 7.0);
    const double sine = exact::sin(theta);
    return {sine * exact::cos(phi), sine * exact::sin(phi), exact::cos(theta)};
}

}  // namespace

MeasuredData parse_cornell(std::string_view text, std::string_view name) {
    Numbers numbers(text, name);
    const auto weights = spectrum_weights(read_wavelengths(numbers));
    MeasuredData data;
    while (!numbers.done()) {
        BrdfSample sample{read_direction(numbers, "i"), read_direction(numbers, "o"), Rgb(0.0)};
        for (const Rgb& weight : weights)
            sample.f += weight * numbers.next("value", -most_value, most_value);
        for (std::size_t c = 0; c < 3; ++c) data.counts[c].add(sample.f[static_cast<int>(c)]);
        if (data.scattered.size() == most_samples)
            numbers.fail(fmt::format("more than {} measurements", most_samples));
        data.scattered.push_back(sample);
    }
    if (data.scattered.empty()) numbers.fail("no measurement");
    data.value = scattered_value(data.scattered);
    return data;
}

}  // namespace twofold
