#pragma once
#include <stdlib.h>

#include <filesystem>
#include <string>
#include <system_error>

#include "texunit/error.hpp"

namespace twofold::bench {

/// An empty folder that goes with its owner.
class ScratchFolder {
  public:
    ScratchFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "twofold_XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw Error(ExitCode::bad_file, name + ": cannot be made");
        path_ = name;
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
};

}  // namespace twofold::bench
