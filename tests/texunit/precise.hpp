#pragma once
#include <mpfr.h>

#include <cmath>
#include <limits>

/// The true values of elementary functions, by MPFR.
namespace twofold::precise {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// A number of 120 bits, enough to call the correct double and float for every argument tested
/// here.
class Precise {
  public:
    Precise() { mpfr_init2(value_, 120); }
    explicit Precise(double x) : Precise() { mpfr_set_d(value_, x, MPFR_RNDN); }
    Precise(const Precise&) = delete;
    Precise& operator=(const Precise&) = delete;
    ~Precise() { mpfr_clear(value_); }
    mpfr_ptr get() { return value_; }

    float nearest_float() { return mpfr_get_flt(value_, MPFR_RNDN); }

    /// |got - this| in units in the last place of this number as a double.
    double ulps_from(double got) {
        if (std::isinf(got) || std::isnan(got)) return infinity;
        const long exponent = mpfr_zero_p(value_) ? -1074 : mpfr_get_exp(value_) - 53;
        Precise difference(got);
        mpfr_sub(difference.get(), difference.get(), value_, MPFR_RNDN);
        mpfr_mul_2si(difference.get(), difference.get(), exponent < -1074 ? 1074 : -exponent,
                     MPFR_RNDN);
        return std::fabs(mpfr_get_d(difference.get(), MPFR_RNDN));
    }

  private:
    mpfr_t value_;
};

using Function = double (*)(double);
using Oracle = int (*)(mpfr_ptr, mpfr_srcptr, mpfr_rnd_t);

}  // namespace twofold::precise
