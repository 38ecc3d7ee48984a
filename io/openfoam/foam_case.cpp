#include "io/openfoam/foam_case.hpp"

#include <algorithm>
#include <cmath>

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
std::string boundary_field(const ExtrudedMesh& extruded, const std::string& at_walls) {
    std::string text = "boundaryField\n{\n";
    for (const ExtrudedPatch& patch : extruded.patches) {
        text += "    " + patch.name + " { type " +
                (patch.wall          ? at_walls
                 : patch.partner < 0 ? "empty"
                                     : "cyclic") +
                "; }\n";
    }
    return text + "}\n";
}

}  // namespace

std::string foam_control(double end, double courant_rate) {
    const double steps = std::max(kLeastSteps, end * courant_rate / kCourant);
    const double interval = std::ceil(steps / kWrites);
    return foam_header("dictionary", "system", "controlDict") +
           foam_fill(kControl,
                     {{"END", end}, {"STEP", end / (interval * kWrites)}, {"INTERVAL", interval}});
}

std::string foam_schemes() { return foam_header("dictionary", "system", "fvSchemes") + kSchemes; }

std::string foam_solution() {
    return foam_header("dictionary", "system", "fvSolution") + kSolution;
}

std::string foam_transport(const DecayingFlow& flow, const CellFlow& cells) {
    const char* comment =
        "// U, and T of scalarTransportFoam, fall as exp(-$RATE nu t): to 1/e at the end of the "
        "run.\n";
    if (!flow.keeps_shape()) comment = "// U begins to fall as exp(-$RATE nu t).\n";
    if (cells.at_rest) {
        comment =
            cells.has_holes
                ? "// The decaying flow would cross the holes, so U and T start as 0.\n"
                : "// The cells are too large for the decaying flow, so U and T start as 0.\n";
    }
    const double diffusivity = 1 / (flow.rate() * flow.turn_time());
    return foam_header("dictionary", "constant", "transportProperties") +
           foam_fill(std::string(comment) +
                         "transportModel Newtonian;\n"
                         "nu [0 2 -1 0 0 0 0] $NU;\n"
                         "DT [0 2 -1 0 0 0 0] $NU;\n",
                     {{"RATE", flow.rate()}, {"NU", diffusivity}});
}

std::string foam_turbulence() {
    return foam_header("dictionary", "constant", "turbulenceProperties") +
           "simulationType laminar;\n";
}

std::string foam_velocity(const CellFlow& cells, const ExtrudedMesh& extruded) {
    std::string text = foam_field_head("vector", "U", "[0 1 -1 0 0 0 0]", cells.velocity.size());
    for (const plane::Vec2& u : cells.velocity) {
        append_foam_vector(text, {u.x(), u.y(), 0});
        text += '\n';
    }
    return text + ");\n" + boundary_field(extruded, "noSlip");
}

std::string foam_pressure(const ExtrudedMesh& extruded) {
    return foam_header("volScalarField", "0", "p") +
           "dimensions [0 2 -2 0 0 0 0];\ninternalField uniform 0;\n" +
           boundary_field(extruded, "zeroGradient");
}

std::string foam_tracer(const CellFlow& cells, const ExtrudedMesh& extruded) {
    std::string text = foam_field_head("scalar", "T", "[0 0 0 0 0 0 0]", cells.tracer.size());
    for (const double value : cells.tracer) {
        append_number(text, value);
        text += '\n';
    }
    return text + ");\n" + boundary_field(extruded, "zeroGradient");
}

}  // namespace pcvt
