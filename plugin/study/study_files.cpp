#include "plugin/study/study_files.hpp"

#include <filesystem>

#include "io/bytes/output.hpp"
#include "io/page/study_page.hpp"
#include "mesher/base/error.hpp"
#include "plugin/job/distinct_paths.hpp"
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

void add_files(const std::string& path, StudyFileKind kind,
               const std::vector<std::string>& suffixes, std::vector<StudyFile>& files) {
    for (std::size_t k = 0; k < suffixes.size(); ++k) {
        files.push_back({with_suffix(path, suffixes[k]), kind, k});
    }
}

void add_folder(const std::string& folder, const StudyRecipe& recipe, StudyShard shard,
                std::vector<StudyFile>& files) {
    std::string stem = (fs::path(folder) / recipe.name).string();
    if (shard.count > 1) {
        stem += "-shard-" + std::to_string(shard.index) + "-of-" + std::to_string(shard.count);
    }
    add_files(stem + ".csv", StudyFileKind::kTable, table_suffixes(recipe, shard), files);
    if (shard.count > 1) return;
    add_files(stem + ".svg", StudyFileKind::kPicture, recipe.pictures, files);
    add_files(stem + ".html", StudyFileKind::kPage, {""}, files);
}

void add_named(const std::string& path, const StudyRecipe& recipe, StudyShard shard,
               std::vector<StudyFile>& files) {
    const std::string extension = fs::path(path).extension().string();
    if (extension == ".csv") {
        add_files(path, StudyFileKind::kTable, table_suffixes(recipe, shard), files);
    } else if ((extension == ".svg" || extension == ".html") && shard.count > 1) {
        throw InvalidInput("-o " + path +
                           ": a shard has no picture or page; merge the shards for it");
    } else if (extension == ".html") {
        add_files(path, StudyFileKind::kPage, {""}, files);
    } else if (extension == ".svg" && recipe.pictures.empty()) {
        throw InvalidInput("-o " + path + ": study " + recipe.name + " has no picture; take .csv");
    } else if (extension == ".svg") {
        add_files(path, StudyFileKind::kPicture, recipe.pictures, files);
    } else {
        throw InvalidInput(
            "-o " + path +
            ": neither .csv, .svg nor .html nor a folder, which ends in /; take one of them");
    }
}

std::string page_of(const Study& study, const StudyResult& result) {
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

void write_study(const Study& study, const StudyResult& result, const std::vector<StudyFile>& files,
                 bool force) {
    OutputSet outputs;
    for (const StudyFile& file : files) {
        switch (file.kind) {
            case StudyFileKind::kTable:
                outputs.stage(file.path, encode_csv(result.tables.at(file.index)));
                break;
            case StudyFileKind::kPicture:
                outputs.stage(file.path, result.pictures.at(file.index).svg);
                break;
            case StudyFileKind::kPage:
                outputs.stage(file.path, page_of(study, result));
                break;
        }
    }
    outputs.commit(force);
}

}  // namespace pcvt
