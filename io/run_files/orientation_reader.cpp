#include "io/run_files/orientation_reader.hpp"

#include "io/bytes/input_file.hpp"
#include "io/bytes/text.hpp"

namespace pcvt {
namespace {

BungeAngles parse_angles(const LineScanner& scanner, const std::vector<std::string_view>& words) {
    const BungeAngles angles{scanner.number(words[0]), scanner.number(words[1]),
                             scanner.number(words[2])};
    try {
        return checked_angles(angles);
    } catch (const InvalidInput& fault) {
        scanner.throw_bad_file(fault.what());
    }
}

}  // namespace

std::vector<BungeAngles> parse_orientations(const std::string& name, std::string_view text) {
    refuse_binary(name, text, "give a text with \"phi1 Phi phi2\" a line");
    LineScanner scanner(name, text);
    std::vector<BungeAngles> orientations;
    while (scanner.next()) {
        const std::vector<std::string_view> words = scanner.words_before_comment();
        if (words.empty()) continue;
        if (words.size() != 3) {
            scanner.throw_bad_file("an orientation has 3 angles, this line has " +
                                   std::to_string(words.size()) + "; write \"phi1 Phi phi2\"");
        }
        orientations.push_back(parse_angles(scanner, words));
    }
    if (orientations.empty()) {
        throw BadFile(name + ": holds no orientation; give one \"phi1 Phi phi2\" a line");
    }
    return orientations;
}

std::vector<BungeAngles> read_orientations(const std::string& path) {
    return parse_orientations(path, read_whole_file(path, kSiteInput));
}

}  // namespace pcvt
