#pragma once
#include <unistd.h>

#include <filesystem>
#include <string>

#include "study/sweep/plan.hpp"

/// A folder of its own, gone with the value.
class ScratchFolder {
  public:
    explicit ScratchFolder(const std::string& name)
        : path_(std::filesystem::temp_directory_path() /
                ("twofold-" + name + "-" + std::to_string(::getpid()))) {
        std::filesystem::create_directories(path_);
    }
    ~ScratchFolder() { std::filesystem::remove_all(path_); }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

inline std::filesystem::path shipped_scene(const std::string& name) {
    return std::filesystem::path(TWOFOLD_SOURCE_DIR) / "scenes" / name;
}
