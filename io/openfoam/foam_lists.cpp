#include "io/openfoam/foam_lists.hpp"

#include "io/bytes/bad_file.hpp"
#include "io/openfoam/foam_scanner.hpp"
#include "io/openfoam/foam_text.hpp"

namespace pcvt {

const EncodedFile& foam_mesh_file(const std::vector<EncodedFile>& files, const std::string& name) {
    const std::string end = std::string(kMeshFolder) + "/" + name;
    for (const EncodedFile& file : files) {
        if (file.path.ends_with(end)) return file;
    }
    throw BadFile(files.front().path + ": there is no " + end + " beside it; give a whole case");
}

const EncodedFile& foam_boundary(const std::vector<EncodedFile>& files) {
    const EncodedFile& boundary = foam_mesh_file(files, "boundary");
    for (const EncodedFile& file : files) {
        refuse_binary(file.path, file.bytes, "write the case with writeFormat ascii");
    }
    return boundary;
}

std::string foam_folder(const std::vector<EncodedFile>& files) {
    std::string folder = foam_mesh_file(files, "boundary").path;
    folder.resize(folder.rfind(kMeshFolder));
    if (folder.ends_with('/')) folder.pop_back();
    return folder;
}

void read_foam_notes(const EncodedFile& boundary, const TakeNote& take) {
    LineScanner scanner(boundary.path, boundary.bytes);
    while (scanner.next()) {
        const auto& words = scanner.words();
        if (words.size() < 3 || words[0] != "//" || words[1] != "pcvt") continue;
        take(scanner, words[2], std::span(words).subspan(3));
    }
}

std::vector<Eigen::Vector3d> foam_points(const EncodedFile& file) {
    FoamScanner scanner(file.path, file.bytes);
    const int n = scanner.begin_list();
    std::vector<Eigen::Vector3d> points;
    points.reserve(static_cast<std::size_t>(n));
    for (int k = 0; k < n; ++k) {
        scanner.expect("(");
        const double x = scanner.number();
        const double y = scanner.number();
        const double z = scanner.number();
        points.emplace_back(x, y, z);
        scanner.expect(")");
    }
    scanner.expect(")");
    return points;
}

Faces foam_faces(const EncodedFile& file) {
    FoamScanner scanner(file.path, file.bytes);
    const int n = scanner.begin_list();
    Faces faces;
    faces.begin.reserve(static_cast<std::size_t>(n) + 1);
    for (int k = 0; k < n; ++k) {
        for (int left = scanner.begin_list(); left > 0; --left) {
            faces.corners.push_back(scanner.integer());
        }
        scanner.expect(")");
        faces.close();
    }
    scanner.expect(")");
    return faces;
}

std::vector<int> foam_labels(const EncodedFile& file) {
    FoamScanner scanner(file.path, file.bytes);
    std::vector<int> labels(static_cast<std::size_t>(scanner.begin_list()));
    for (int& label : labels) label = scanner.integer();
    scanner.expect(")");
    return labels;
}

}  // namespace pcvt
