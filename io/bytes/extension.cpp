#include "io/bytes/extension.hpp"

#include <algorithm>
#include <filesystem>

namespace pcvt {

std::string lower_case_extension(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    for (char& c : extension) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return extension;
}

std::string one_word_beside(const std::string& path, const char* extension) {
    std::filesystem::path beside = std::filesystem::path(path).replace_extension(extension);
    std::string name = beside.filename().string();
    std::replace(name.begin(), name.end(), ' ', '_');
    return beside.replace_filename(name).string();
}

}  // namespace pcvt
