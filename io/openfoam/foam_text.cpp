#include "io/openfoam/foam_text.hpp"

#include <filesystem>
#include <system_error>

#include "io/bytes/text.hpp"
#include "mesher/base/error.hpp"

namespace pcvt {

void require_foam_path(const std::string& path) {
    std::error_code fault;
    const std::string whole = std::filesystem::absolute(path, fault).string();
    if ((fault ? path : whole).find_first_of(" '\"") == std::string::npos) return;
    throw InvalidInput("OpenFOAM leaves blanks and quotes out of paths, so it would not find " +
                       (fault ? path : whole) + "; take a folder and a name without them");
}

std::string foam_header(const std::string& kind, const std::string& location,
                        const std::string& object, const std::string& note) {
    std::string text =
        "FoamFile\n{\n    version     2.0;\n    format      ascii;\n    class       " + kind +
        ";\n";
    if (!note.empty()) text += "    note        \"" + note + "\";\n";
    text += "    location    \"" + location + "\";\n    object      " + object + ";\n}\n\n";
    return location == kMeshFolder ? text : text + kCaseNote;
}

std::string foam_field_head(const std::string& type, const std::string& field,
                            const std::string& dimensions, std::size_t n) {
    return foam_header(type == "vector" ? "volVectorField" : "volScalarField", "0", field) +
           "dimensions " + dimensions + ";\ninternalField nonuniform List<" + type + ">\n" +
           std::to_string(n) + "\n(\n";
}

void append_foam_vector(std::string& text, const Eigen::Vector3d& vector) {
    char before = '(';
    for (const double number : vector) {
        text += before;
        append_number(text, number);
        before = ' ';
    }
    text += ')';
}

std::string foam_fill(std::string text, std::initializer_list<FoamNumber> numbers) {
    for (const FoamNumber& number : numbers) {
        const std::string name = std::string("$") + number.name;
        std::string digits;
        append_number(digits, number.value);
        for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at)) {
            text.replace(at, name.size(), digits);
        }
    }
    return text;
}

}  // namespace pcvt
