#pragma once

#include <common/filter_parameter/rich_parameter_list.h>
#include <pcvt.h>

#include <string>

namespace pcvt::meshlab {

enum class Colouring { kNone, kByCell, kBySides };

/// The request of the filter's user.
struct TileRequest {
    pcvt_options options{};
    std::string density;  ///< for options.density_source; empty: uniform
    int32_t kind = PCVT_VORONOI;
    int32_t outline = PCVT_WHOLE;
    Colouring colouring = Colouring::kBySides;
    bool select_vertices = false;  ///< on the seam
    bool select_faces = false;     ///< with an edge on the seam
};

/// The parameters of the filter with their defaults, in the order of its dialog.
void add_parameters(RichParameterList& parameters);

/// The request of a dialog. A parameter of 32 bits becomes the double with the same shortest
/// decimal: 1e-6 means 1e-6.
/// @throws std::invalid_argument with a message for the user; pcvt_generate() finds other errors.
TileRequest read_request(const RichParameterList& parameters);

}  // namespace pcvt::meshlab
