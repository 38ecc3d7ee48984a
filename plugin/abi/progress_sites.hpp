#pragma once

#include "plugin/job/job.hpp"
#include "plugin/pcvt.h"

namespace pcvt::abi {

/// While it lives, the view of pcvt_get_progress_sites() on its thread. Scopes nest, because a
/// callback may start a run. The positions are computed when they are requested.
///
///   const ProgressSites sites(&job, progress.run);
///   call_host("progress", host, [&] { return call(&view, data); });
class ProgressSites {
   public:
    /// @param job  nullptr: the sites are not known.
    ProgressSites(const Job* job, const Progress& progress);
    ~ProgressSites();
    ProgressSites(const ProgressSites&) = delete;
    ProgressSites& operator=(const ProgressSites&) = delete;

    /// The view of the innermost scope on this thread, valid as long as the scope.
    /// @throws InvalidInput outside of a callback, and where the sites are not known.
    static pcvt_sites current_view();

   private:
    const Job* job_;
    const Progress& progress_;
    plane::Points points_;
    ProgressSites* outer_;
};

}  // namespace pcvt::abi
