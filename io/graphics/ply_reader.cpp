#include "io/graphics/ply_reader.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/forms/file_tile_builder.hpp"
#include "io/graphics/ply_header.hpp"

namespace pcvt {
namespace {

constexpr const char* kOtherDeclaration =
    " is not declared as pcvt declares it; write the file again with pcvt";
constexpr const char* kColourTypes = ", uchar red, uchar green, uchar blue";

class PlyParser {
   public:
    PlyParser(const std::string& name, std::string_view text)
        : scanner_(name, text), file_{.name = name, .index_base = 0, .notes = {.short_edges = 0}} {
        elements_ = read_ply_header(scanner_, name,
                                    std::bind_front(&FileTileBuilder::take_comment, &file_));
        if (file_.kind) {
            require_own_elements();
        } else if (file_.lattice && has_element("site")) {
            throw BadFile(name + ": the comment that states its kind is missing; write it again");
        }
        refuse_binary(name, text, "export it as ASCII");
    }

    FileTileBuilder parse() {
        for (const PlyElement& element : elements_) {
            if (element.name == "vertex") require_vertex(element);
            if (element.name == "face") require_face(element);
            if (has_positions(element)) require_site(element);
            read_ply_rows(scanner_, element,
                          [&](const PlyValues& values) { take_row(element, values); });
        }
        require_ply_end(scanner_);
        return std::move(file_);
    }

    plane::Precision precision() const {
        return is_single_ ? plane::Precision::kSingle : plane::Precision::kDouble;
    }

   private:
    enum class Type { kInteger, kNumber, kIntegerList };

    void require(const PlyElement& element, std::string_view name, Type type) const {
        const PlyProperty* found = element.find(name);
        if (found && found->is_list == (type == Type::kIntegerList) &&
            (type == Type::kNumber || !found->is_real)) {
            return;
        }
        throw BadFile(file_.name + ": element " + in_quotes(element.name) + " lacks a proper " +
                      in_quotes(name) + "; export the file with it");
    }

    void require_vertex(const PlyElement& vertex) {
        require_position(vertex);
        if (vertex.find("z")) require(vertex, "z", Type::kNumber);
        is_single_ = vertex.find("x")->is_single || vertex.find("y")->is_single;
        n_vertices_ = vertex.count;
        has_orbits_ = vertex.find("orbit") || vertex.find("offset_i") || vertex.find("offset_j");
        if (has_orbits_) {
            require(vertex, "orbit", Type::kInteger);
            require(vertex, "offset_i", Type::kInteger);
            require(vertex, "offset_j", Type::kInteger);
        }
        require_sites(vertex, false);
        require_colour(vertex);
    }

    void require_face(const PlyElement& face) {
        list_name_ = face.find("vertex_index") ? "vertex_index" : "vertex_indices";
        require(face, list_name_, Type::kIntegerList);
        require_sites(face, true);
        require_colour(face);
    }

    /// Whether the element stores the positions of the sites: only in a file of pcvt.
    bool has_positions(const PlyElement& element) const {
        return file_.kind && element.name == "site";
    }

    bool has_sites_with_positions() const {
        return std::any_of(elements_.begin(), elements_.end(),
                           [&](const PlyElement& element) { return has_positions(element); });
    }

    void require_position(const PlyElement& element) const {
        require(element, "x", Type::kNumber);
        require(element, "y", Type::kNumber);
    }

    void require_site(const PlyElement& site) const {
        require_position(site);
        for (const std::string_view part : site_parts()) {
            if (site.find(part)) require(site, part, Type::kNumber);
        }
    }

    /// A colour that lacks a part is none for most programs; pcvt writes all three parts.
    void require_colour(const PlyElement& element) const {
        const auto has = [&](const char* part) { return element.find(part) != nullptr; };
        if (!file_.kind || (has("red") == has("green") && has("green") == has("blue"))) return;
        throw BadFile(file_.name + ": element " + in_quotes(element.name) +
                      " has a part of a colour; give red, green and blue, or none");
    }

    /// A file of pcvt has no other elements than encode_ply() writes; one with positions of sites
    /// declares them in the same way, so that every program takes the same columns.
    void require_own_elements() const {
        const bool is_new = has_sites_with_positions();
        const bool owned = faces_have_sites(*file_.kind);
        for (const PlyElement& element : elements_) {
            const std::string real = element.properties.empty() ? "" : element.properties[0].type;
            const bool is_face = element.name == "face";
            const bool is_usual = is_face ? real == "list uchar int" || real == "list int int"
                                          : real == "double" || real == "float";
            const std::string coordinates = real + " x, " + real + " y";
            std::string wanted;
            if (element.name == "vertex") {
                wanted = coordinates + ", " + real + " z" + kColourTypes +
                         ", int orbit, int offset_i, int offset_j" + (owned ? "" : ", int site");
            } else if (is_face) {
                wanted = real + " vertex_indices" + kColourTypes + (owned ? ", int site" : "");
            } else if (element.name == "site") {
                for (const std::string_view part : site_parts()) {
                    if (!element.find(part)) continue;
                    wanted += (wanted.empty() ? "" : ", ") + real + ' ' + std::string(part);
                }
            }
            if (!wanted.empty() && (!is_new || (is_usual && wanted == declaration(element))))
                continue;
            throw BadFile(file_.name + ": element " + in_quotes(element.name) + kOtherDeclaration);
        }
    }

    bool has_element(std::string_view name) const {
        return std::any_of(elements_.begin(), elements_.end(),
                           [&](const PlyElement& element) { return element.name == name; });
    }

    static std::string declaration(const PlyElement& element) {
        std::string text;
        for (const PlyProperty& property : element.properties) {
            if (!text.empty()) text += ", ";
            text += property.type + ' ' + std::string(property.name);
        }
        return text;
    }

    /// Only a file of pcvt gives `site` a meaning, in the element that owns the sites.
    void require_sites(const PlyElement& element, bool of_faces) {
        has_sites_ =
            file_.kind && faces_have_sites(*file_.kind) == of_faces && element.find("site");
        if (has_sites_) require(element, "site", Type::kInteger);
    }

    void take_row(const PlyElement& element, const PlyValues& values) {
        if (element.name == "vertex") add_vertex(values);
        if (element.name == "face") add_face(values);
        if (has_positions(element)) add_site(element, values);
    }

    void add_site(const PlyElement& site, const PlyValues& values) {
        std::vector<double> numbers;
        for (const std::string_view part : site_parts()) {
            if (site.find(part)) numbers.push_back(values.number(part));
        }
        take_site_note(numbers, file_.notes);
    }

    void add_vertex(const PlyValues& values) {
        if (values.number("z") != 0) {
            scanner_.throw_bad_file("z is not 0; move the tile to the plane z = 0");
        }
        file_.points.emplace_back(values.number("x"), values.number("y"));
        if (has_orbits_) add_orbit(values);
        if (has_sites_) file_.sites.push_back(values.integer("site"));
    }

    void add_orbit(const PlyValues& values) {
        const int orbit = values.integer("orbit");
        const int v = static_cast<int>(file_.points.size()) - 1;
        const plane::Offset offset{values.integer("offset_i"), values.integer("offset_j")};
        if (orbit < 0 || orbit >= n_vertices_) {
            scanner_.throw_bad_file("orbit " + std::to_string(orbit) +
                                    " is not a vertex; correct the index");
        }
        if (orbit != v) {
            file_.vertex_pairs.push_back({orbit, v, offset});
        } else if (offset != plane::Offset{}) {
            scanner_.throw_bad_file(
                "a vertex has an offset to itself; write the file again with pcvt");
        }
    }

    void add_face(const PlyValues& values) {
        const std::vector<double>& list = values.list(list_name_);
        file_.add_face(std::vector<int>(list.begin(), list.end()), scanner_.line());
        if (has_sites_) file_.sites.push_back(values.integer("site"));
    }

    LineScanner scanner_;
    FileTileBuilder file_;
    std::vector<PlyElement> elements_;
    std::string_view list_name_;
    int n_vertices_ = 0;
    bool has_orbits_ = false;
    bool has_sites_ = false;
    bool is_single_ = false;
};

}  // namespace

TileFile decode_ply(const std::vector<EncodedFile>& files,
                    const std::optional<plane::Lattice>& lattice) {
    PlyParser parser(files.front().path, files.front().bytes);
    FileTileBuilder file = parser.parse();
    return finish(std::move(file), lattice, parser.precision());
}

SurfaceList decode_ply_surfaces(const EncodedFile& ply) {
    LineScanner scanner(ply.path, ply.bytes);
    SurfaceListBuilder builder;
    const std::vector<PlyElement> elements = read_ply_header(
        scanner, ply.path, std::bind_front(&SurfaceListBuilder::take_comment, &builder));
    refuse_binary(ply.path, ply.bytes, "give an ASCII PLY");
    space::TileSurface& surface = builder.list.surface;
    const bool is_boundary = builder.list.form == SurfaceForm::kBoundary;
    std::vector<space::Vec3> sites;
    for (const PlyElement& element : elements) {
        const bool has_reals = std::any_of(element.properties.begin(), element.properties.end(),
                                           [](const PlyProperty& p) { return p.is_real; });
        if (has_reals == (element.name == "face")) {
            throw BadFile(ply.path + ": element " + in_quotes(element.name) + kOtherDeclaration);
        }
        read_ply_rows(scanner, element, [&](const PlyValues& row) {
            if (element.name != "face") {
                (element.name == "site" ? sites : surface.points)
                    .emplace_back(row.number("x"), row.number("y"), row.number("z"));
                return;
            }
            for (const double v : row.list("vertex_indices")) {
                surface.faces.corners.push_back(static_cast<int>(v));
            }
            surface.faces.close();
            surface.cell.push_back(row.integer("cell"));
            if (!is_boundary) return;
            surface.partner.push_back(row.integer("partner"));
            surface.offset.push_back(stated_offset(row.integer("offset_i"), row.integer("offset_j"),
                                                   row.integer("offset_k"), ply.path));
        });
    }
    surface.sites = Eigen::Map<const space::Points>(sites.empty() ? nullptr : sites.front().data(),
                                                    3, static_cast<Eigen::Index>(sites.size()));
    return std::move(builder).finish(ply.path);
}

}  // namespace pcvt
