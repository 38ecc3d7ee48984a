#include "io/run_files/orientation_reader.hpp"

#include "io/bytes/input_file.hpp"
#include "io/bytes/text.hpp"

namespace pcvt {
namespace {

constexpr double kFullTurn = 360;

double parse_angle(const LineScanner& scanner, std::string_view word) {
    const double angle = scanner.number(word);
    if (angle >= -kFullTurn && angle <= kFullTurn) return angle;
    scanner.throw_bad_file(in_quotes(word) + " is no angle from -360 to 360 degrees; correct it");
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
        orientations.push_back({parse_angle(scanner, words[0]), parse_angle(scanner, words[1]),
                                parse_angle(scanner, words[2])});
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
