#include "plugin/abi/progress_sites.hpp"

#include "mesher/base/error.hpp"
#include "plugin/job/job_tessellation.hpp"

namespace pcvt::abi {
namespace {

thread_local ProgressSites* innermost = nullptr;

}  // namespace

ProgressSites::ProgressSites(const Job* job, const Progress& progress)
    : job_(job), progress_(progress), outer_(innermost) {
    innermost = this;
}

ProgressSites::~ProgressSites() { innermost = outer_; }

pcvt_sites ProgressSites::current_view() {
    if (innermost == nullptr) throw InvalidInput("no progress callback runs on this thread");
    ProgressSites& now = *innermost;
    if (now.job_ == nullptr || now.progress_.positions == nullptr) {
        throw InvalidInput("the sites are not known in this call of the progress callback");
    }
    if (now.points_.cols() == 0) now.points_ = progress_sites(*now.job_, now.progress_);
    const plane::Lattice& lattice = now.job_->in_plane().lattice;
    pcvt_sites view{};
    view.lattice[0] = lattice.a().x();
    view.lattice[1] = lattice.a().y();
    view.lattice[2] = lattice.b().x();
    view.lattice[3] = lattice.b().y();
    view.points = now.points_.data();
    view.n_sites = static_cast<std::int32_t>(now.points_.cols());
    return view;
}

}  // namespace pcvt::abi
