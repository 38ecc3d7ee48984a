#include "plugin/study/study_files.hpp"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string_view>

#include "io/outputs/distinct_paths.hpp"
#include "io/page/study_page.hpp"
#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "plugin/job/job_files.hpp"

namespace pcvt {
namespace {

namespace fs = std::filesystem;

bool is_folder(const std::string& path) {
    std::error_code ignored;
    return path.ends_with('/') || fs::is_directory(path, ignored);
}

/// The suffixes of the recipe's tables and of the runs.
std::vector<std::string> table_suffixes(const StudyRecipe& recipe, StudyShard shard) {
    if (shard.count > 1) return {""};
    std::vector<std::string> suffixes = recipe.tables;
    suffixes.emplace_back("-runs");
    return suffixes;
}

std::vector<std::string> picture_suffixes(const StudyRecipe& recipe, StudyShard) {
    return recipe.pictures;
}

std::vector<std::string> page_suffixes(const StudyRecipe&, StudyShard) { return {""}; }

std::string encode_table(const Study&, const StudyResult& result, std::size_t index) {
    return encode_csv(result.tables.at(index));
}

std::string picture(const Study&, const StudyResult& result, std::size_t index) {
    return result.pictures.at(index).svg;
}

std::string encode_page(const Study& study, const StudyResult& result, std::size_t) {
    std::vector<StudyPagePicture> pictures;
    for (const StudyPicture& picture : result.pictures) {
        pictures.push_back({study.name + picture.suffix, picture.svg, picture.points});
    }
    std::vector<StudyPageTable> tables;
    for (const StudyTable& table : result.tables) {
        tables.push_back({.name = study.name + table.suffix,
                          .columns = table.columns,
                          .rows = table.rows,
                          .remarks = table.remarks,
                          .csv = encode_csv(table)});
    }
    const StudyRecipe& recipe = find_study_recipe(study.name);
    return encode_study_page(study.name, recipe.description, pictures, tables);
}

/// A format of the files of a study.
struct StudyFormat {
    std::string_view extension;
    /// Whether a shard has such files.
    bool in_shards;
    /// Returns one suffix of the name for each file.
    std::vector<std::string> (*suffixes)(const StudyRecipe& recipe, StudyShard shard);
    StudyEncoder* encode;
};
constexpr StudyFormat kStudyFormats[] = {
    {.extension = ".csv", .in_shards = true, .suffixes = table_suffixes, .encode = encode_table},
    {.extension = ".svg", .in_shards = false, .suffixes = picture_suffixes, .encode = picture},
    {.extension = ".html", .in_shards = false, .suffixes = page_suffixes, .encode = encode_page},
};

void add_files(const std::string& path, const StudyFormat& format,
               const std::vector<std::string>& suffixes, std::vector<StudyFile>& files) {
    for (std::size_t k = 0; k < suffixes.size(); ++k) {
        files.push_back({with_suffix(path, suffixes[k]), format.encode, k});
    }
}

void add_folder(const std::string& folder, const StudyRecipe& recipe, StudyShard shard,
                std::vector<StudyFile>& files) {
    std::string stem = (fs::path(folder) / recipe.name).string();
    if (shard.count > 1) {
        stem += "-shard-" + std::to_string(shard.index) + "-of-" + std::to_string(shard.count);
    }
    for (const StudyFormat& format : kStudyFormats) {
        if (shard.count > 1 && !format.in_shards) continue;
        const std::string path = stem + std::string(format.extension);
        add_files(path, format, format.suffixes(recipe, shard), files);
    }
}

void add_named(const std::string& path, const StudyRecipe& recipe, StudyShard shard,
               std::vector<StudyFile>& files) {
    const std::string extension = fs::path(path).extension().string();
    const auto format =
        std::find_if(std::begin(kStudyFormats), std::end(kStudyFormats),
                     [&](const StudyFormat& row) { return row.extension == extension; });
    if (format == std::end(kStudyFormats)) {
        throw InvalidInput(
            "-o " + path +
            ": neither .csv, .svg nor .html nor a folder, which ends in /; take one of them");
    }
    if (shard.count > 1 && !format->in_shards) {
        throw InvalidInput("-o " + path +
                           ": a shard has no picture or page; merge the shards for it");
    }
    const std::vector<std::string> suffixes = format->suffixes(recipe, shard);
    if (suffixes.empty()) {
        throw InvalidInput("-o " + path + ": study " + recipe.name + " has no picture; take .csv");
    }
    add_files(path, *format, suffixes, files);
}

}  // namespace

std::vector<StudyFile> plan_study_files(const std::vector<std::string>& outputs,
                                        const std::string& study, StudyShard shard,
                                        const std::vector<std::string>& inputs) {
    const StudyRecipe& recipe = find_study_recipe(study);
    std::vector<StudyFile> files;
    for (const std::string& output : outputs) {
        if (is_folder(output)) {
            add_folder(output, recipe, shard, files);
        } else {
            add_named(output, recipe, shard, files);
        }
    }
    DistinctPaths book;
    for (const std::string& input : inputs) book.add_input(input);
    for (const StudyFile& file : files) book.add_output(file.path);
    return files;
}

void stage_study(const Study& study, const StudyResult& result, const std::vector<StudyFile>& files,
                 OutputSet& outputs) {
    for (const StudyFile& file : files) {
        outputs.stage(file.path, file.encode(study, result, file.index));
    }
}

std::vector<std::string> write_study(const Study& study, const StudyResult& result,
                                     const std::vector<StudyFile>& files, bool force,
                                     const WaitingCallback& waiting) {
    OutputSet outputs;
    stage_study(study, result, files, outputs);
    std::vector<std::string> recovered = outputs.wait_for_turn(waiting);
    const ClientScope no_client(nullptr);
    outputs.commit(force);
    return recovered;
}

}  // namespace pcvt
