#pragma once
#include <filesystem>
#include <string>

#include "study/run.hpp"

/// Files of results. Each is written whole under a temporary name and renamed.
namespace twofold {

/// Where a run came from, for the report.
struct RunOrigin {
    std::string scene_path;
    std::string command;  ///< how the program was called
};

/// t1 and t2 of every material, front and back, as MATERIAL-t1-front.exr (float) and .png (8 bits),
/// and factors.json.
/// @throws Error naming the file that could not be written
void write_factors(const Scene& scene, const LitScene& lit, const std::filesystem::path& folder);

/// The pictures as NAME.png and NAME.exr (binary32), the factors, manifest.json and report.html.
/// @return the path of the report
std::filesystem::path write_run(const RunResult& run, const std::filesystem::path& folder,
                                const RunOrigin& origin);

/// The folder that results go to. It is made before the work begins, so that a place that cannot be
/// written to is found early, and removed again if nothing came of it.
class OutputFolder {
  public:
    /// Makes the folder if it is not there and sweeps what an interrupted earlier run left in it.
    /// @throws Error naming the folder if it cannot be made
    explicit OutputFolder(std::filesystem::path path);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    bool made_here_ = false;
};

/// For a single file of results: its folder has to be there, which is found out before the work
/// instead of after it, and what interrupted writers left in it is swept.
/// @throws Error naming the file and the folder
void prepare_folder_of(const std::filesystem::path& file);

}  // namespace twofold
