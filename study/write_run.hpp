#pragma once
#include <filesystem>
#include <string>

#include "study/run.hpp"

/// Files of results. Each is written whole under a temporary name and renamed.
namespace twofold {

/// t1 and t2 of every material, front and back, as MATERIAL-t1-front.exr (float) and .png (8 bits),
/// and factors.json.
/// @throws Error naming the file that could not be written
void write_factors(const Scene& scene, const LitScene& lit, const std::filesystem::path& folder);

/// The pictures as NAME.png and NAME.exr (binary32), the factors, manifest.json and report.html.
/// @param command how the program was called, for the report
/// @return the path of the report
std::filesystem::path write_run(const RunResult& run, const std::filesystem::path& folder,
                                const std::string& command);

/// Creates the folder if needed and sweeps what an interrupted earlier run left in it.
void prepare_folder(const std::filesystem::path& folder);

}  // namespace twofold
