#include "io/run_files/yaml_reader.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>

#include "io/bytes/text.hpp"

namespace pcvt {
namespace {

/// Deeper mappings are not materials, or contain themselves through an alias.
constexpr int kDeepest = 32;
/// Aliases of aliases make more values than a file has characters.
constexpr int kMostValues = 1'000'000;

std::string place(const std::string& name, const YAML::Mark& mark) {
    return name + (mark.is_null() ? "" : ":" + std::to_string(mark.line + 1)) + ": ";
}

/// Turns nodes of yaml-cpp into values.
class ValueBuilder {
   public:
    explicit ValueBuilder(const std::string& name) : name_(name) {}

    YamlValue value_of(const YAML::Node& node, int depth = 0) {
        if (depth > kDeepest)
            refuse(node.Mark(), "the mappings are too deep; give materials alone");
        if (++n_values_ > kMostValues) {
            refuse(node.Mark(), "the values are too many; give materials alone");
        }
        YamlValue value{.text = node.IsScalar() ? node.Scalar() : std::string(),
                        .line = node.Mark().line + 1,
                        .is_mapping = node.IsMap(),
                        .is_list = node.IsSequence()};
        if (value.is_mapping) add_members(node, depth, value);
        return value;
    }

   private:
    [[noreturn]] void refuse(const YAML::Mark& mark, const std::string& complaint) const {
        throw BadFile(place(name_, mark) + complaint);
    }

    void add_members(const YAML::Node& mapping, int depth, YamlValue& value) {
        for (const auto& member : mapping) {
            const YAML::Node& key = member.first;
            if (!key.IsScalar()) refuse(key.Mark(), "a key is not a word; write KEY: VALUE");
            if (value.find(key.Scalar()) != nullptr) {
                refuse(key.Mark(), in_quotes(key.Scalar()) + " is there twice; remove one");
            }
            value.members.emplace_back(key.Scalar(), value_of(member.second, depth + 1));
            value.members.back().second.line = key.Mark().line + 1;
        }
    }

    const std::string& name_;
    int n_values_ = 0;
};

}  // namespace

const YamlValue* YamlValue::find(std::string_view key) const {
    const auto found = std::find_if(members.begin(), members.end(),
                                    [&](const auto& member) { return member.first == key; });
    return found == members.end() ? nullptr : &found->second;
}

YamlValue parse_yaml(const std::string& name, std::string_view text) {
    refuse_binary(name, text, "give a text in YAML");
    try {
        const std::vector<YAML::Node> documents = YAML::LoadAll(std::string(text));
        if (documents.size() > 1) {
            throw BadFile(place(name, documents[1].Mark()) + "a second document begins; give one");
        }
        return documents.empty() ? YamlValue{} : ValueBuilder(name).value_of(documents.front());
    } catch (const YAML::Exception& fault) {
        throw BadFile(place(name, fault.mark) + fault.msg + "; correct the YAML");
    }
}

}  // namespace pcvt
