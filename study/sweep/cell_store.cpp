#include "study/sweep/cell_store.hpp"

#include "texunit/atomic_file.hpp"
#include "texunit/error.hpp"
#include "texunit/image_file.hpp"

namespace twofold {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t max_result_bytes = std::size_t{1} << 26;
constexpr std::size_t max_picture_bytes = std::size_t{1} << 30;

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error || !std::filesystem::is_directory(folder))
        throw Error(ExitCode::bad_file, folder.string() + ": cannot be made a folder");
}

}  // namespace

CellStore::CellStore(std::filesystem::path folder) : folder_(std::move(folder)) {
    make_folder(folder_);
    remove_stale_temporaries(folder_);
}

std::filesystem::path CellStore::result_file(const std::string& id) const {
    return folder_ / (id + ".json");
}

std::filesystem::path CellStore::picture_file(const std::string& id) const {
    return folder_ / (id + ".png");
}

std::optional<Json> CellStore::result(const std::string& id) const {
    if (!std::filesystem::exists(result_file(id))) return std::nullopt;
    const std::string text = read_text_file(result_file(id), max_result_bytes);
    Json result = Json::parse(text, nullptr, false);
    if (!result.is_object() || result.value("id", "") != id) return std::nullopt;
    const bool complete = result.contains("failed") || std::filesystem::exists(picture_file(id));
    return complete ? std::optional(std::move(result)) : std::nullopt;
}

void CellStore::keep(const std::string& id, const CellFindings& findings) const {
    Json result{{"id", id}};
    result.update(findings.result);
    if (!findings.picture.pixels.empty())
        write_file_atomically(picture_file(id), encode_png(findings.picture));
    write_file_atomically(result_file(id), result.dump(1) + "\n");
}

void CellStore::take_over(const std::string& id, const CellStore& from) const {
    const std::optional<Json> theirs = from.result(id);
    if (!theirs || result(id)) return;
    if (!theirs->contains("failed"))
        write_file_atomically(picture_file(id),
                              read_file(from.picture_file(id), max_picture_bytes));
    write_file_atomically(result_file(id), theirs->dump(1) + "\n");
}

}  // namespace twofold
