#include "plugin/abi/write_options.hpp"

#include <algorithm>

#include "io/run_files/material_reader.hpp"
#include "plugin/abi/feature_fields.hpp"
#include "plugin/abi/option_values.hpp"
#include "plugin/job/job_files.hpp"

namespace pcvt::abi {
namespace {

// The numbers of the published interface never change.
static_assert(mesh_kind_row(plane::MeshKind::kVoronoi).abi_value == PCVT_VORONOI);
static_assert(mesh_kind_row(plane::MeshKind::kDelaunay).abi_value == PCVT_DELAUNAY);
static_assert(mesh_kind_row(plane::MeshKind::kGrains).abi_value == PCVT_GRAINS);
static_assert(find_abi_value(kPlaneElements, PCVT_CPE)->element == PlaneElement::kStrain);
static_assert(find_abi_value(kPlaneElements, PCVT_CPS)->element == PlaneElement::kStress);
static_assert(find_abi_value(kPlaneElements, PCVT_C3D6)->element == PlaneElement::kWedge6);
static_assert(find_abi_value(kPlaneElements, PCVT_C3D15)->element == PlaneElement::kWedge15);
static_assert(find_abi_value(kSolverJobs, PCVT_JOB_ELASTIC)->job == SolverJob::kElastic);
static_assert(colouring_row(Colouring::kSides).abi_value == PCVT_COLOUR_SIDES);
static_assert(colouring_row(Colouring::kSize).abi_value == PCVT_COLOUR_SIZE);
static_assert(colouring_row(Colouring::kCells).abi_value == PCVT_COLOUR_CELLS);
static_assert(colouring_row(Colouring::kDensity).abi_value == PCVT_COLOUR_DENSITY);
static_assert(colouring_row(Colouring::kPhase).abi_value == PCVT_COLOUR_PHASE);
static_assert(colouring_row(Colouring::kOrbit).abi_value == PCVT_COLOUR_ORBIT);
static_assert(colouring_row(Colouring::kTag).abi_value == PCVT_COLOUR_TAG);
static_assert(colouring_row(Colouring::kFaces).abi_value == PCVT_COLOUR_FACES);
static_assert(colouring_row(Colouring::kOrientation).abi_value == PCVT_COLOUR_ORIENTATION);
static_assert(find_word(kGltfNodes, "cells")->abi_value == PCVT_NODES_CELLS);
static_assert(find_word(kGltfNodes, "one")->abi_value == PCVT_NODES_ONE);
static_assert(find_abi_value(kSurfaceForms, PCVT_SURFACE_CELLS)->form == SurfaceForm::kCells);
static_assert(find_abi_value(kSurfaceForms, PCVT_SURFACE_BOUNDARY)->form == SurfaceForm::kBoundary);

/// The forms of files that the options choose.
FileOptions file_options(const pcvt_write_options& options) {
    FileOptions result;
    result.surfaces = chosen_row("surface", options.surface, kSurfaceForms).form;
    if (options.colour != PCVT_COLOUR_DEFAULT) {
        result.colouring = chosen_row("colour", options.colour, kColourings).colouring;
    }
    if (options.background != nullptr) result.background = background_colour(options.background);
    if (options.gltf_nodes != PCVT_NODES_DEFAULT) {
        result.gltf_nodes = chosen_row("gltf_nodes", options.gltf_nodes, kGltfNodes).nodes;
    }
    result.single_precision = options.single_precision != 0;
    if ((options.voxels[0] != 0 || options.voxels[1] != 0) &&
        (options.voxels[0] < plane::kLeastVoxels || options.voxels[1] < plane::kLeastVoxels)) {
        throw InvalidInput("voxels are fewer than 2 along an axis; take 2 or more, or 0 for both");
    }
    if (options.voxel_layers < 0) throw InvalidInput("voxel_layers is negative; take 0 or more");
    result.voxels = {options.voxels[0], options.voxels[1], std::max(options.voxel_layers, 1)};
    require_finite("coriolis", options.coriolis, 2);
    if (options.coriolis[0] != 0 || options.coriolis[1] != 0) {
        result.coriolis = {options.coriolis[0], options.coriolis[1]};
    }
    read_numbers(kWriteFields, options, result);
    result.element = chosen_row("element", options.element, kPlaneElements).element;
    if (options.job != PCVT_JOB_NONE) {
        result.job = chosen_row("job", options.job, kSolverJobs).job;
    }
    if (options.materials != nullptr) {
        try {
            std::vector<std::string> files;
            result.elastic = read_elastic_choices(options.materials, files);
        } catch (const BadFile&) {
            throw;
        } catch (const InvalidInput& error) {
            throw InvalidInput(std::string("materials: ") + error.what());
        }
    }
    return result;
}

/// Requires that surfaces are chosen only for a file that has them.
void check_surfaces(const std::string& path, const pcvt_write_options& options, bool in_space) {
    if (options.surface == PCVT_SURFACE_CELLS) return;
    if (!in_space) {
        throw InvalidInput("surface is for three dimensions; leave it at its default");
    }
    const Format* const format = find_format(path);
    const bool has_surfaces =
        format == nullptr || !format->space || format->space->surfaces == FormatSurfaces::kChosen;
    if (has_surfaces) return;
    throw InvalidInput("surface is for " + surface_extensions() + "; leave it at its default");
}

}  // namespace

plane::MeshKind tile_kind(std::int32_t kind) {
    return chosen_row("kind", kind, plane::kMeshKinds).kind;
}

plane::Outline tile_outline(std::int32_t outline) {
    if (outline == PCVT_WHOLE) return plane::Outline::kWhole;
    if (outline == PCVT_BOX) return plane::Outline::kBox;
    throw InvalidInput("outline " + std::to_string(outline) + " is unknown; take one of pcvt.h");
}

WriteRequest write_request(const char* path, const pcvt_write_options& options, bool in_space) {
    if (in_space) {
        require_default_fields(kWriteFields, options, {}, &FeatureRow::in_space,
                               "is not for files in three dimensions; leave it at its default");
    }
    WriteRequest request;
    request.path = given_text(path);
    request.layout.kind = row_for(in_space, "kind", options.kind, plane::kMeshKinds,
                                  "PCVT_VORONOI, PCVT_DELAUNAY or PCVT_GRAINS")
                              .kind;
    request.layout.outline = tile_outline(options.outline);
    check_surfaces(request.path, options, in_space);
    if (options.colour != PCVT_COLOUR_DEFAULT) {
        row_for(in_space, "colour", options.colour, kColourings,
                "PCVT_COLOUR_FACES, SIZE, PHASE, ORIENTATION or CELLS");
    }
    request.files = file_options(options);
    request.report = given_text(options.report);
    request.replace = options.replace != 0;
    return request;
}

}  // namespace pcvt::abi
