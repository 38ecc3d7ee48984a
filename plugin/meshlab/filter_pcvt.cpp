#include "plugin/meshlab/filter_pcvt.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <memory>
#include <stdexcept>

#include "plugin/meshlab/tile_colours.hpp"
#include "plugin/meshlab/tile_layer.hpp"

namespace {

using namespace pcvt::meshlab;

constexpr int kCreate = 0;

struct FreeResult {
    void operator()(pcvt_result* result) const { pcvt_free(result); }
};
using Result = std::unique_ptr<pcvt_result, FreeResult>;

void require(pcvt_status status) {
    if (status < 0) throw std::runtime_error(pcvt_last_error());
}

/// The progress for MeshLab's bar; it never falls.
struct ProgressBar {
    vcg::CallBackPos* callback;
    int percent = 0;
};

int show_progress(const pcvt_progress* progress, void* data) {
    ProgressBar& bar = *static_cast<ProgressBar*>(data);
    if (progress->phase == PCVT_PHASE_OPTIMISE) {
        bar.percent = std::max(bar.percent, static_cast<int>(100 * progress->fraction));
    }
    std::array<char, 120> text{};
    std::snprintf(text.data(), text.size(), "Periodic CVT: %s, iteration %d, residual %.1e",
                  progress->phase_text, static_cast<int>(progress->iteration), progress->residual);
    return bar.callback(bar.percent, text.data()) ? 0 : 1;
}

/// @throws std::runtime_error with the reason if there is no result.
Result generate(const TileRequest& request, vcg::CallBackPos* callback) {
    pcvt_options options = request.options;
    ProgressBar bar{callback};
    if (!request.density.empty()) options.density_source = request.density.c_str();
    if (callback) {
        options.progress = show_progress;
        options.progress_data = &bar;
    }
    pcvt_result* result = nullptr;
    const pcvt_status status = pcvt_generate(&options, &result);
    require(status);
    if (status == PCVT_CANCELLED) throw std::runtime_error("cancelled");
    return Result(result);
}

pcvt_tile get_tile(const pcvt_result* result, const TileRequest& request) {
    pcvt_tile tile;
    require(pcvt_get_tile(result, request.kind, request.outline, &tile, sizeof tile));
    return tile;
}

std::string run_line(const pcvt_statistics& run) {
    static constexpr std::array kEnds{"converged", "ended by its limit", "stalled"};
    std::array<char, 240> text{};
    std::snprintf(
        text.data(), text.size(),
        "%s after %d iterations, residual %.2e, energy %.10g, %d of %d cells are hexagons",
        kEnds.at(static_cast<std::size_t>(run.stop)), static_cast<int>(run.iterations),
        run.residual, run.energy, static_cast<int>(run.n_hexagons), static_cast<int>(run.n_sites));
    return text.data();
}

/// The number of seam edges that each translation glues.
std::string seam_line(const pcvt_tile& tile) {
    std::map<std::pair<int, int>, int> counts;
    for (int k = 0; k < tile.n_edge_pairs; ++k) {
        ++counts[{tile.edge_pairs[k].i, tile.edge_pairs[k].j}];
    }
    std::string line = "seam: " + std::to_string(2 * tile.n_edge_pairs) + " edges, pairs: ";
    const char* gap = "";
    for (const auto& [offset, count] : counts) {
        line += gap + std::to_string(count) + " by (" + std::to_string(offset.first) + ", " +
                std::to_string(offset.second) + ")";
        gap = ", ";
    }
    return line;
}

}  // namespace

FilterPcvt::FilterPcvt() {
    typeList << kCreate;
    actionList << new QAction(filterName(kCreate), this);
}

QString FilterPcvt::pluginName() const { return "FilterPcvt"; }

QString FilterPcvt::filterName(FilterIDType /*filter*/) const { return "Create Periodic CVT Tile"; }

QString FilterPcvt::filterInfo(FilterIDType /*filter*/) const {
    return "Create one tile of a doubly periodic mesh: the cells of a periodic centroidal Voronoi "
           "tessellation, its Delaunay triangles, or triangles inside of the cells. The boundary "
           "of the tile is a seam: copies moved by the period vectors fit without a gap, vertex "
           "on vertex. The quality of a vertex is the same for those that the seam glues, that of "
           "a face is the number of its cell.<br>After: <i>D.-M. Yan, K. Wang, B. L&eacute;vy, L. "
           "Alonso</i>, <b>Computing 2D Periodic Centroidal Voronoi Tessellation</b>, ISVD 2011.";
}

QString FilterPcvt::filterScriptFunctionName(FilterIDType /*filter*/) { return "periodiccvttile"; }

MeshFilterInterface::FilterClass FilterPcvt::getClass(QAction* /*action*/) { return MeshCreation; }

MeshFilterInterface::FILTER_ARITY FilterPcvt::filterArity(QAction* /*action*/) const {
    return NONE;
}

int FilterPcvt::postCondition(QAction* /*action*/) const { return MeshModel::MM_NONE; }

void FilterPcvt::initParameterSet(QAction* /*action*/, MeshDocument& /*document*/,
                                  RichParameterList& parameters) {
    add_parameters(parameters);
}

void FilterPcvt::say(const std::string& line) { Log(GLLogStream::FILTER, line); }

void FilterPcvt::report(const pcvt_result* result, const pcvt_tile& tile) {
    pcvt_statistics run;
    require(pcvt_get_statistics(result, &run, sizeof run));
    say(run_line(run));
    say(seam_line(tile));
}

void FilterPcvt::create_tile(MeshDocument& document, const TileRequest& request,
                             vcg::CallBackPos* callback) {
    const Result result = generate(request, callback);
    const pcvt_tile tile = get_tile(result.get(), request);
    const std::vector<vcg::Color4b> colours = site_colours(result.get(), request);
    fill_layer(*document.addNewMesh("", "Periodic CVT Tile"), tile, colours, request);
    report(result.get(), tile);
}

bool FilterPcvt::applyFilter(QAction* /*action*/, MeshDocument& document,
                             const RichParameterList& parameters, vcg::CallBackPos* callback) {
    try {
        create_tile(document, read_request(parameters), callback);
        return true;
    } catch (const std::exception& error) {
        errorMessage = QString::fromUtf8(error.what());
        say(std::string("error: ") + error.what());
        return false;
    }
}
