#include "io/openfoam/foam_settings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/bytes/text.hpp"
#include "io/openfoam/foam_text.hpp"

namespace pcvt {
namespace {

constexpr int kWrites = 5;
/// The largest Courant number of the first step, in OpenFOAM's sense: half the sum of the fluxes
/// through the faces of a cell, times the time step, divided by the volume of the cell. OpenFOAM
/// interpolates the fluxes; with 10 % of room, its number stays below 0.5.
constexpr double kCourant = 0.45;
/// With this number of steps the time integration of the decay errs by less than 0.1 %.
constexpr double kLeastSteps = 50;

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

// The line between the centres of two triangles misses the middle of their edge. With plain
// `linear` interpolation such meshes diverge. Coefficients of diffusion are interpolated by
// `linear` nevertheless, because the correction extrapolates and can make them negative.
constexpr const char* kSchemes = R"(ddtSchemes           { default backward; }
gradSchemes          { default Gauss skewCorrected linear; }
divSchemes
{
    default                         none;
    div(phi,U)                      Gauss skewCorrected linear;
    div(phi,T)                      Gauss skewCorrected linear;
    div((nuEff*dev2(T(grad(U)))))   Gauss skewCorrected linear;
}
laplacianSchemes     { default Gauss linear corrected; }
interpolationSchemes { default skewCorrected linear; }
snGradSchemes        { default corrected; }
)";

// Neither cyclic patches nor walls determine p and Phi, except up to a constant, which the
// reference cells fix. The line between the centres of two grains may lie 50 degrees off the normal
// of their edge. With one corrector for such edges the flow can grow without bound.
constexpr const char* kSolution = R"(solvers
{
    p
    {
        solver          PCG;
        preconditioner  DIC;
        tolerance       1e-09;
        relTol          0;
    }
    "pFinal|Phi"
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
    "UFinal|T"
    {
        $U;
    }
}

PISO
{
    nCorrectors              2;
    nNonOrthogonalCorrectors 3;
    pRefCell                 0;
    pRefValue                0;
}

PIMPLE
{
    nOuterCorrectors         1;
    $PISO;
}

potentialFlow
{
    nNonOrthogonalCorrectors 10;
    PhiRefCell               0;
    PhiRefValue              0;
    pRefCell                 0;
    pRefValue                0;
}

SIMPLE
{
    nNonOrthogonalCorrectors 1;
}
)";

/// @param at_walls  the condition on walls.
std::string boundary_field(const FiniteVolumeMesh& mesh, const char* at_walls) {
    std::string text = "boundaryField\n{\n";
    for (const FiniteVolumePatch& patch : mesh.patches) {
        const bool is_wall = patch.kind == PatchKind::kWall;
        text += "    " + patch.name + " { type " + (is_wall ? at_walls : foam_word(patch.kind)) +
                "; }\n";
    }
    return text + "}\n";
}

/// Returns the comment on the decay of the flow.
const char* decay_comment(const CellFlow& flow) {
    if (flow.has_holes) {
        return "// The decaying flow would cross the holes, so U and T start as 0.\n";
    }
    if (flow.at_rest) {
        return "// The cells are too large for the decaying flow, so U and T start as 0.\n";
    }
    if (!flow.keeps_shape) return "// U begins to fall as exp(-$RATE nu t).\n";
    if (flow.tracer.empty())
        return "// U falls as exp(-$RATE nu t): to 1/e at the end of the run.\n";
    return "// U, and T of scalarTransportFoam, fall as exp(-$RATE nu t): to 1/e at the end of the "
           "run.\n";
}

}  // namespace

const char* foam_word(PatchKind kind) {
    switch (kind) {
        case PatchKind::kCyclic:
            return "cyclic";
        case PatchKind::kWall:
            return "wall";
        default:
            return "empty";
    }
}

std::string foam_control(const FoamCase& foam) {
    const double end = foam.flow.turn_time;
    const double steps = std::max(kLeastSteps, end * foam.flow.courant_rate / kCourant);
    const double interval = std::ceil(steps / kWrites);
    return foam_header("dictionary", "system", "controlDict") +
           foam_fill(kControl,
                     {{"END", end}, {"STEP", end / (interval * kWrites)}, {"INTERVAL", interval}});
}

std::string foam_schemes(const FoamCase&) {
    return foam_header("dictionary", "system", "fvSchemes") + kSchemes;
}

std::string foam_solution(const FoamCase&) {
    return foam_header("dictionary", "system", "fvSolution") + kSolution;
}

std::string foam_transport(const FoamCase& foam) {
    const CellFlow& flow = foam.flow;
    std::string text = std::string(decay_comment(flow)) +
                       "transportModel Newtonian;\n"
                       "nu [0 2 -1 0 0 0 0] $NU;\n";
    if (!flow.tracer.empty()) text += "DT [0 2 -1 0 0 0 0] $NU;\n";
    const double diffusivity = 1 / (flow.rate * flow.turn_time);
    return foam_header("dictionary", "constant", "transportProperties") +
           foam_fill(std::move(text), {{"RATE", flow.rate}, {"NU", diffusivity}});
}

std::string foam_turbulence(const FoamCase&) {
    return foam_header("dictionary", "constant", "turbulenceProperties") +
           "simulationType laminar;\n";
}

std::string foam_velocity(const FoamCase& foam) {
    const std::vector<Eigen::Vector3d>& velocity = foam.flow.velocity;
    std::string text = foam_field_head("vector", "U", "[0 1 -1 0 0 0 0]", velocity.size());
    for (const Eigen::Vector3d& u : velocity) {
        append_foam_vector(text, u);
        text += '\n';
    }
    return text + ");\n" + boundary_field(foam.mesh, "noSlip");
}

std::string foam_pressure(const FoamCase& foam) {
    return foam_header("volScalarField", "0", "p") +
           "dimensions [0 2 -2 0 0 0 0];\ninternalField uniform 0;\n" +
           boundary_field(foam.mesh, "zeroGradient");
}

std::string foam_tracer(const FoamCase& foam) {
    const std::vector<double>& tracer = foam.flow.tracer;
    std::string text = foam_field_head("scalar", "T", "[0 0 0 0 0 0 0]", tracer.size());
    for (const double value : tracer) {
        append_number(text, value);
        text += '\n';
    }
    return text + ");\n" + boundary_field(foam.mesh, "zeroGradient");
}

}  // namespace pcvt
