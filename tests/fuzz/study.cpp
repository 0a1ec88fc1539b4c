#include "study/sweep/study_file.hpp"
#include "tests/fuzz/promises.hpp"

namespace twofold::hostile {

bool study(Input bytes) {
    return reads(ExitCode::failure, [&] {
        const Study study = parse_study(text_of(bytes), file_name);
        for (const StudyAxis& axis : study.axes)
            promise(!axis.points.empty(), "an axis without a point");
    });
}

}  // namespace twofold::hostile
