// OpenMesh requires its readers and writers to be included before any mesh.
// clang-format off
#include <OpenMesh/Core/IO/MeshIO.hh>
// clang-format on

#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

#include "io/graphics/om_reader.hpp"
#include "io/graphics/om_writer.hpp"
#include "mesher/plane/mesh/outline.hpp"
#include "mesher/plane/mesh/voronoi.hpp"
#include "mesher/plane/tile/openmesh_tile.hpp"
#include "mesher/plane/tile/tile_builder.hpp"
#include "tests/support/mutation.hpp"
#include "tests/support/tile_equality.hpp"

namespace pcvt {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// The Voronoi cells or the Delaunay triangles of n random sites; the triangles with face sites are
/// grains.
plane::Tile tile_of(const plane::Lattice& lattice, int n, plane::MeshKind kind) {
    const plane::PeriodicDelaunay delaunay(plane::Sites(lattice, uniform_points(lattice, n, 5)));
    const bool cells = kind == plane::MeshKind::kVoronoi;
    plane::PeriodicMesh mesh = cells ? cell_mesh(delaunay) : triangle_mesh(delaunay);
    if (kind == plane::MeshKind::kGrains) {
        mesh.kind = kind;
        mesh.site.resize(static_cast<std::size_t>(mesh.n_faces()), 3);
    }
    return make_tile(mesh, whole_outline(mesh, plane::Vec2(0, 0)));
}

std::string om_fault(const std::string& bytes) {
    try {
        decode_om({{"t.om", bytes}}, std::nullopt);
    } catch (const BadFile& fault) {
        return fault.what();
    }
    return "";
}

std::string example(plane::MeshKind kind = plane::MeshKind::kVoronoi) {
    return encode_om(tile_of(plane::Lattice({1, 0}, {0.37, 0.81}), 9, kind), "t.om")[0].bytes;
}

/// Reads the bytes with OpenMesh itself.
template <class Mesh>
plane::Tile read_with_openmesh(const std::string& bytes, const plane::Lattice& lattice) {
    plane::OpenMeshTile any(std::in_place_type<plane::OpenMeshTileOf<Mesh>>, lattice);
    auto& tile = std::get<plane::OpenMeshTileOf<Mesh>>(any);
    tile.mesh.property(tile.identification.lattice).clear();
    std::istringstream stream(bytes);
    OpenMesh::IO::Options options(OpenMesh::IO::Options::Binary);
    EXPECT_TRUE(OpenMesh::IO::read_mesh(tile.mesh, stream, ".om", options));
    EXPECT_THAT(
        tile.mesh.property(tile.identification.lattice),
        ::testing::ElementsAre(lattice.a().x(), lattice.a().y(), lattice.b().x(), lattice.b().y()));
    return pcvt::plane::tile(any);
}

TEST(Om, TilesReadBackExactlyWithTheirSeam) {
    for (const plane::Lattice& lattice : testing::awkward_lattices()) {
        for (const plane::MeshKind kind :
             {plane::MeshKind::kVoronoi, plane::MeshKind::kDelaunay, plane::MeshKind::kGrains}) {
            for (const int n : {1, 2, 40, 3000}) {
                const plane::Tile tile = tile_of(lattice, n, kind);
                const TileFile file = decode_om(encode_om(tile, "t.om"), std::nullopt);
                testing::expect_same_tile(file.tile, tile);
                EXPECT_TRUE(file.has_vertex_pairs && file.has_edge_pairs);
                EXPECT_EQ(file.precision, plane::Precision::kDouble);
            }
        }
    }
}

TEST(Om, OpenMeshReadsTheIdentificationBack) {
    const plane::Lattice lattice({1, 0}, {0.37, 0.81});
    for (const int n : {1, 5, 300}) {
        const plane::Tile cells = tile_of(lattice, n, plane::MeshKind::kVoronoi);
        testing::expect_same_tile(
            read_with_openmesh<plane::CellMesh>(encode_om(cells, "")[0].bytes, lattice), cells);
        const plane::Tile triangles = tile_of(lattice, n, plane::MeshKind::kDelaunay);
        testing::expect_same_tile(
            read_with_openmesh<plane::TriangleMesh>(encode_om(triangles, "")[0].bytes, lattice),
            triangles);
    }
}

TEST(Om, TheSameTileGivesTheSameBytes) {
    for (const plane::MeshKind kind : {plane::MeshKind::kVoronoi, plane::MeshKind::kDelaunay}) {
        const std::string first = example(kind);
        std::vector<std::string> litter(100, std::string(1000, 'x'));
        litter.clear();
        EXPECT_EQ(example(kind), first);
    }
}

TEST(Om, NothingIsPrinted) {
    ::testing::internal::CaptureStderr();
    ::testing::internal::CaptureStdout();
    example();
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(Om, CoordinatesThatAreNotFiniteAreOurFault) {
    plane::Tile tile = tile_of(plane::Lattice({1, 0}, {0, 1}), 4, plane::MeshKind::kVoronoi);
    tile.points[2].y() = std::nan("");
    EXPECT_THROW(encode_om(tile, "t.om"), InternalError);
}

TEST(Om, OtherBytesAreRefused) {
    EXPECT_THAT(om_fault(""), StartsWith("t.om: is cut short; "));
    EXPECT_THAT(om_fault("v 0 0 0\nv 1 0 0\n"), StartsWith("t.om: is not a mesh as OpenMesh 9 wr"));
    std::string bytes = example();
    EXPECT_THAT(om_fault(bytes + "x"), StartsWith("t.om: has data after its end; "));
    for (std::size_t length = 0; length < bytes.size(); ++length) {
        EXPECT_THAT(om_fault(bytes.substr(0, length)), StartsWith("t.om: ")) << length;
    }
}

TEST(Om, AMeshWithoutTheIdentificationIsRefused) {
    std::string bytes = example();
    bytes.replace(bytes.find("pcvt_orbit"), 10, "pcvt_0rbit");
    EXPECT_THAT(om_fault(bytes), StartsWith("t.om: has no property pcvt_orbit; "));
}

TEST(Om, PartnersThatAreNotMutualAreRefused) {
    std::string bytes = example();
    const std::string head = std::string("pcvt_partner\7int32_t");
    std::size_t at = bytes.find(head) + head.size() + 4;
    while (bytes.substr(at, 4) == "\xff\xff\xff\xff") at += 4;
    bytes[at] = static_cast<char>(bytes[at] ^ 2);
    EXPECT_THAT(om_fault(bytes), HasSubstr("another partner; "));
}

TEST(Om, DamagedFilesGiveATileOrAFaultAndNothingElse) {
    std::mt19937_64 random(11);
    int n_refused = 0;
    for (const plane::MeshKind kind : {plane::MeshKind::kVoronoi, plane::MeshKind::kDelaunay}) {
        const std::string bytes = example(kind);
        for (int k = 0; k < 4000; ++k) {
            const std::string fault = om_fault(testing::mutated(bytes, random));
            if (fault.empty()) continue;
            ++n_refused;
            EXPECT_THAT(fault, StartsWith("t.om: "));
        }
    }
    EXPECT_GT(n_refused, 2000);
}

}  // namespace
}  // namespace pcvt
