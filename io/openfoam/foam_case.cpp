#include "io/openfoam/foam_case.hpp"

#include <cmath>

#include "io/bytes/text.hpp"
#include "io/openfoam/foam_text.hpp"
#include "mesher/lattice/polygon.hpp"

namespace pcvt {
namespace {

constexpr int kWrites = 5;
/// The share of the mean spacing that the fastest fluid crosses in one step.
constexpr double kCourant = 0.1;

constexpr const char* kControl = R"(application     icoFoam;
startFrom       startTime;
startTime       0;
stopAt          endTime;
endTime         $END;
deltaT          $STEP;
writeControl    timeStep;
writeInterval   $INTERVAL;
purgeWrite      0;
writeFormat     ascii;
writePrecision  12;
writeCompression off;
timeFormat      general;
timePrecision   10;
runTimeModifiable false;
)";

constexpr const char* kSchemes = R"(ddtSchemes           { default backward; }
gradSchemes          { default Gauss linear; }
divSchemes           { default none; div(phi,U) Gauss linear; }
laplacianSchemes     { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes        { default corrected; }
)";

// All patches are cyclic or empty, so p is determined up to a constant, which pRefCell fixes.
constexpr const char* kSolution = R"(solvers
{
    p
    {
        solver          PCG;
        preconditioner  DIC;
        tolerance       1e-09;
        relTol          0;
    }
    pFinal
    {
        $p;
    }
    U
    {
        solver          smoothSolver;
        smoother        symGaussSeidel;
        tolerance       1e-10;
        relTol          0;
    }
}

PISO
{
    nCorrectors              2;
    nNonOrthogonalCorrectors 1;
    pRefCell                 0;
    pRefValue                0;
}
)";

std::string boundary_field(const ExtrudedMesh& extruded) {
    std::string text = "boundaryField\n{\n";
    for (const ExtrudedPatch& patch : extruded.patches) {
        text +=
            "    " + patch.name + " { type " + (patch.partner < 0 ? "empty" : "cyclic") + "; }\n";
    }
    return text + "}\n";
}

Vec2 face_centroid(const Tile& tile, int f) {
    Polygon polygon;
    for (const int v : tile.faces[f]) {
        polygon.push_back(tile.points[v]);
    }
    return polygon_centroid(polygon);
}

}  // namespace

std::string foam_control(const DecayingFlow& flow, double spacing) {
    const double interval = std::ceil(flow.turn_time() / (kCourant * spacing) / kWrites);
    return foam_header("dictionary", "system", "controlDict") +
           foam_fill(kControl, {{"END", flow.turn_time()},
                                {"STEP", flow.turn_time() / (interval * kWrites)},
                                {"INTERVAL", interval}});
}

std::string foam_schemes() { return foam_header("dictionary", "system", "fvSchemes") + kSchemes; }

std::string foam_solution() {
    return foam_header("dictionary", "system", "fvSolution") + kSolution;
}

std::string foam_transport(const DecayingFlow& flow) {
    return foam_header("dictionary", "constant", "transportProperties") +
           foam_fill(
               "// The speed falls as exp(-nu $RATE t): to 1/e at the end of the run.\n"
               "nu [0 2 -1 0 0 0 0] $NU;\n",
               {{"RATE", flow.rate()}, {"NU", 1 / (flow.rate() * flow.turn_time())}});
}

std::string foam_velocity(const DecayingFlow& flow, const ExtrudedMesh& extruded,
                          const Tile& tile) {
    std::string text = foam_header("volVectorField", "0", "U") +
                       "dimensions [0 1 -1 0 0 0 0];\ninternalField nonuniform List<vector>\n" +
                       std::to_string(tile.n_faces()) + "\n(\n";
    for (int f = 0; f < tile.n_faces(); ++f) {
        const Vec2 u = flow.velocity(face_centroid(tile, f));
        append_foam_vector(text, {u.x(), u.y(), 0});
        text += '\n';
    }
    return text + ");\n" + boundary_field(extruded);
}

std::string foam_pressure(const ExtrudedMesh& extruded) {
    return foam_header("volScalarField", "0", "p") +
           "dimensions [0 2 -2 0 0 0 0];\ninternalField uniform 0;\n" + boundary_field(extruded);
}

}  // namespace pcvt
