#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "study/sweep/laboratory.hpp"

namespace twofold {

/// Results of cells in a folder, by id: ID.json and, unless the cell failed, ID.png. Each is
/// written whole, the result last, so that a cell is either there or not.
class CellStore {
  public:
    /// Makes the folder if needed and sweeps what an interrupted run left in it.
    explicit CellStore(std::filesystem::path folder);

    /// The result of a cell; none if it is not there or cannot be read as one.
    std::optional<nlohmann::ordered_json> result(const std::string& id) const;
    std::filesystem::path picture_file(const std::string& id) const;

    void keep(const std::string& id, const CellFindings& findings) const;

    /// Copies the cell from another store if it is there and not here.
    void take_over(const std::string& id, const CellStore& from) const;

  private:
    std::filesystem::path result_file(const std::string& id) const;

    std::filesystem::path folder_;
};

}  // namespace twofold
