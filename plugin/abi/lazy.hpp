#pragma once

#include <memory>
#include <mutex>

namespace pcvt::abi {

/// A value that the first call of get() makes, on whichever thread, and that then stays:
///   const Tile& tile = tile_.get([&] { return build(); });
template <class Value>
class Lazy {
   public:
    /// Passes exceptions of make() on; the next call then tries again.
    template <class Make>
    const Value& get(const Make& make) const {
        const std::lock_guard lock(mutex_);
        if (!value_) value_.reset(new Value(make()));
        return *value_;
    }

   private:
    mutable std::mutex mutex_;
    mutable std::unique_ptr<const Value> value_;
};

}  // namespace pcvt::abi
