#pragma once

#include <string>
#include <vector>

namespace pcvt {

/// One picture of a study with the values that its marks show.
struct StudyPagePicture {
    /// The name of its file, without the extension.
    std::string name;
    std::string svg;
    /// As plot_points() returns them; empty for a picture that is not a plot.
    std::string points;
};

/// One table of a study.
struct StudyPageTable {
    /// The name of its file, without the extension.
    std::string name;
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
    /// Sentences on the table.
    std::vector<std::string> remarks;
    /// The bytes of its file, which the page saves.
    std::string csv;
};

/// Encodes one HTML page that needs no other file and no network: the pictures of a study, its
/// tables, the values of a plot under the pointer, and buttons that save the pictures and tables.
/// The page follows the light or dark scheme of the reader. Tables of more than kMostPageRows rows
/// are cut on the page, but saved in full.
///
/// Example usage:
///     output.stage("fig9.html", encode_study_page("fig9", "energy by iteration", pictures,
///     tables));
std::string encode_study_page(const std::string& name, const std::string& description,
                              const std::vector<StudyPagePicture>& pictures,
                              const std::vector<StudyPageTable>& tables);

inline constexpr std::size_t kMostPageRows = 200;

}  // namespace pcvt
