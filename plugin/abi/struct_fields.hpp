// The fields of the options of pcvt.h, by their names. Written by plugin/words.
#pragma once

#include <array>

#include "plugin/abi/struct_field.hpp"
#include "plugin/pcvt.h"

namespace pcvt::abi {

inline constexpr std::array kOptionFields{
    struct_field<&pcvt_options::lattice>("lattice"),
    struct_field<&pcvt_options::origin>("origin"),
    struct_field<&pcvt_options::sites>("sites"),
    struct_field<&pcvt_options::n_sites>("n_sites"),
    struct_field<&pcvt_options::start>("start"),
    struct_field<&pcvt_options::seed>("seed"),
    struct_field<&pcvt_options::solver>("solver"),
    struct_field<&pcvt_options::max_iterations>("max_iterations"),
    struct_field<&pcvt_options::tolerance>("tolerance"),
    struct_field<&pcvt_options::n_threads>("n_threads"),
    struct_field<&pcvt_options::columns>("columns"),
    struct_field<&pcvt_options::rows>("rows"),
    struct_field<&pcvt_options::grain_order>("grain_order"),
    struct_field<&pcvt_options::grain_size>("grain_size"),
    struct_field<&pcvt_options::short_edges>("short_edges"),
    struct_field<&pcvt_options::budget>("budget"),
    struct_field<&pcvt_options::density_source>("density_source"),
    struct_field<&pcvt_options::density_range>("density_range"),
    struct_field<&pcvt_options::density>("density"),
    struct_field<&pcvt_options::density_data>("density_data"),
    struct_field<&pcvt_options::progress>("progress"),
    struct_field<&pcvt_options::progress_data>("progress_data"),
    struct_field<&pcvt_options::grain_per_edge>("grain_per_edge"),
    struct_field<&pcvt_options::find_origin>("find_origin"),
    struct_field<&pcvt_options::areas>("areas"),
    struct_field<&pcvt_options::n_areas>("n_areas"),
    struct_field<&pcvt_options::area_law>("area_law"),
    struct_field<&pcvt_options::aspect>("aspect"),
    struct_field<&pcvt_options::aspect_degrees>("aspect_degrees"),
    struct_field<&pcvt_options::phases>("phases"),
    struct_field<&pcvt_options::orientations>("orientations"),
    struct_field<&pcvt_options::n_orientations>("n_orientations"),
    struct_field<&pcvt_options::random_orientations>("random_orientations"),
    struct_field<&pcvt_options::symmetry>("symmetry"),
    struct_field<&pcvt_options::walls>("walls"),
    struct_field<&pcvt_options::wall_cells>("wall_cells"),
    struct_field<&pcvt_options::inclusions>("inclusions"),
    struct_field<&pcvt_options::fibres>("fibres"),
    struct_field<&pcvt_options::fixed_sites>("fixed_sites"),
    struct_field<&pcvt_options::n_fixed_sites>("n_fixed_sites"),
    struct_field<&pcvt_options::holes>("holes"),
    struct_field<&pcvt_options::dimension>("dimension"),
    struct_field<&pcvt_options::lattice3>("lattice3"),
    struct_field<&pcvt_options::duplicates>("duplicates"),
    struct_field<&pcvt_options::n_weights>("n_weights"),
    struct_field<&pcvt_options::weights>("weights"),
    struct_field<&pcvt_options::site_phases>("site_phases"),
    struct_field<&pcvt_options::n_site_phases>("n_site_phases"),
    struct_field<&pcvt_options::origin_z>("origin_z"),
    struct_field<&pcvt_options::volumes>("volumes"),
    struct_field<&pcvt_options::volume_law>("volume_law"),
    struct_field<&pcvt_options::n_volumes>("n_volumes"),
    struct_field<&pcvt_options::aspect_axis>("aspect_axis"),
    struct_field<&pcvt_options::sites_are_centroids>("sites_are_centroids")};

inline constexpr std::array kWriteFields{
    struct_field<&pcvt_write_options::report>("report"),
    struct_field<&pcvt_write_options::kind>("kind"),
    struct_field<&pcvt_write_options::outline>("outline"),
    struct_field<&pcvt_write_options::replace>("replace"),
    struct_field<&pcvt_write_options::colour>("colour"),
    struct_field<&pcvt_write_options::progress>("progress"),
    struct_field<&pcvt_write_options::progress_data>("progress_data"),
    struct_field<&pcvt_write_options::gltf_nodes>("gltf_nodes"),
    struct_field<&pcvt_write_options::single_precision>("single_precision"),
    struct_field<&pcvt_write_options::pixels>("pixels"),
    struct_field<&pcvt_write_options::element>("element"),
    struct_field<&pcvt_write_options::cut_width>("cut_width"),
    struct_field<&pcvt_write_options::background>("background"),
    struct_field<&pcvt_write_options::voxels>("voxels"),
    struct_field<&pcvt_write_options::job>("job"),
    struct_field<&pcvt_write_options::voxel_layers>("voxel_layers"),
    struct_field<&pcvt_write_options::thickness>("thickness"),
    struct_field<&pcvt_write_options::surface>("surface"),
    struct_field<&pcvt_write_options::materials>("materials"),
    struct_field<&pcvt_write_options::coriolis>("coriolis")};

}  // namespace pcvt::abi
