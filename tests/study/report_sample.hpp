#pragma once
#include "study/report.hpp"

/// A report of made-up pictures and figures that fills every part of the page.
twofold::Report sample_report();
