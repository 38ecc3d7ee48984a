#pragma once

#include <string>

#include "plugin/job/job.hpp"

namespace pcvt::cli {

/// The lines of the sites of a job and of their periods: how many sites there are, which of a file
/// were left out, and what their positions say about the domain.
/// @param n_sites  of the result.
std::string site_lines(const Job& job, int n_sites);

}  // namespace pcvt::cli
