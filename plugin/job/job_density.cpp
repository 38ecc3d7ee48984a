#include "plugin/job/job_density.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "io/run_files/density_expression.hpp"
#include "mesher/base/error.hpp"
#include "mesher/plane/density/density_breaks.hpp"

namespace pcvt {

bool names_picture(const std::string& source) {
    std::string end = source.substr(source.size() - std::min<std::size_t>(source.size(), 4));
    std::transform(end.begin(), end.end(), end.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return end == ".png";
}

namespace {

constexpr const char* kForeignPictures[] = {".jpg",  ".jpeg", ".gif", ".bmp",  ".tif", ".tiff",
                                            ".webp", ".svg",  ".pgm", ".heic", ".pdf"};

/// Whether a source that is not a formula names something that cannot be read as a picture.
bool names_no_file(const std::string& source) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(source, ignored);
    return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

plane::Density read_formula(const std::string& source) {
    try {
        return expression_density(source);
    } catch (const InvalidInput&) {
        if (!names_no_file(source)) throw;
        throw InvalidInput("not a regular file; give a PNG picture, or a formula in x, y, u and v");
    }
}

/// Refuses a picture that would be read as a formula.
void refuse_foreign_picture(const std::string& source) {
    std::string extension = std::filesystem::path(source).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (std::find(std::begin(kForeignPictures), std::end(kForeignPictures), extension) ==
        std::end(kForeignPictures)) {
        return;
    }
    throw InvalidInput("only PNG pictures are read; convert it first: convert " + source + " " +
                       std::filesystem::path(source).replace_extension(".png").string());
}

}  // namespace

plane::Density source_density(const std::string& source, const std::optional<GreyRange>& range,
                              const plane::Lattice& lattice) {
    if (!names_picture(source)) {
        if (range) throw InvalidInput("a range of densities is for pictures; leave it out");
        refuse_foreign_picture(source);
        return with_axis_breaks(lattice, read_formula(source));
    }
    const GreyRange greys = range.value_or(GreyRange{});
    for (const double limit : {greys.black, greys.white}) {
        if (!(limit >= plane::kLeastDensity && limit <= plane::kGreatestDensity)) {
            throw InvalidInput("a range of densities is not from 1e-60 to 1e60");
        }
    }
    return png_density(source, greys);
}

}  // namespace pcvt
