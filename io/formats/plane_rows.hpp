#pragma once

#include <string>
#include <vector>

#include "io/formats/formats.hpp"

namespace pcvt::plane_rows {

// Functions that rows of the table of formats name for the plane.

void require_prisms(const FormatRequest& request);
void require_solver_input(const FormatRequest& request);
void require_mpas_torus(const FormatRequest& request);
std::vector<std::string> mpas_paths(const std::string& path);
void require_image_size(const FormatRequest& request);
void require_voxel_grid(const FormatRequest& request);
std::vector<EncodedFile> write_mpas(const Torus& torus, const FileOptions& options,
                                    const std::string& path);
MpasGrid read_mpas(const std::vector<EncodedFile>& files);
std::vector<EncodedFile> write_sites(const plane::Points& sites, const std::string& path);
bool reads_back_sites(const std::vector<EncodedFile>& files, const plane::Points& sites);
std::vector<EncodedFile> write_cells(const CellRows& rows, const std::string& path);
bool reads_back_cells(const std::vector<EncodedFile>& files, const CellRows& rows);
std::vector<EncodedFile> write_svg(const plane::Tile& tile, const FileOptions& options,
                                   const std::string& path);
std::vector<EncodedFile> write_msh(const plane::Tile& tile, const FileOptions& options,
                                   const std::string& path);
std::vector<EncodedFile> write_vtu(const plane::Tile& tile, const FileOptions& options,
                                   const std::string& path);
std::vector<EncodedFile> write_foam(const plane::Tile& tile, const FileOptions& options,
                                    const std::string& path);

}  // namespace pcvt::plane_rows
