#pragma once

#include <cfenv>
#include <exception>
#include <string>

#include "mesher/base/checkpoint.hpp"
#include "mesher/base/error.hpp"
#include "plugin/abi/thread_end.hpp"
#include "plugin/pcvt.h"

namespace pcvt::abi {

/// A struct of an unknown size, or with unknown fields.
class AbiMismatch : public Error {
   public:
    using Error::Error;
};

/// A callback of the host violated its contract.
class CallbackFault : public Error {
   public:
    using Error::Error;
};

/// Valid arguments with a bad geometry: a cell or a tile is too small for its numbers.
class BadGeometry : public Error {
   public:
    using Error::Error;
};

/// Turns an error of valid arguments into one of the geometry of the result.
///   const PeriodicMesh mesh = from_geometry([&] { return cells.mesh(kind); });
template <class Make>
auto from_geometry(const Make& make) {
    try {
        return make();
    } catch (const InvalidInput& error) {
        throw BadGeometry(error.what());
    }
}

/// Enters another floating-point environment while this object lives: rounding, traps, flags,
/// denormals.
class FloatEnvironment {
   public:
    explicit FloatEnvironment(const std::fenv_t* entered) {
        std::fegetenv(&left_);
        std::fesetenv(entered);
    }
    ~FloatEnvironment() { std::fesetenv(&left_); }
    FloatEnvironment(const FloatEnvironment&) = delete;
    FloatEnvironment& operator=(const FloatEnvironment&) = delete;

    /// The environment that the destructor restores.
    const std::fenv_t& left() const { return left_; }

   private:
    std::fenv_t left_;
};

/// Calls a callback of the host in the host's floating-point environment.
/// @param name  of the callback, for the message.
/// @throws CallbackFault if the callback throws. Only the end of a thread passes through.
template <class Callback>
int call_host(const char* name, const std::fenv_t& host, const Callback& callback) {
    const FloatEnvironment environment(&host);
    const ClientScope no_client(nullptr);
    try {
        return callback();
    } catch (const ThreadEnd&) {
        throw;
    } catch (const std::exception& error) {
        throw CallbackFault("the " + std::string(name) + " callback threw: " + error.what());
    } catch (...) {
        throw CallbackFault("the " + std::string(name) + " callback threw no std::exception");
    }
}

/// The text of the last error of this thread, at most 1023 bytes of it.
const char* last_error();
void set_last_error(const char* text);

/// Replaces the names of options in a message by those of the fields of pcvt.h.
std::string in_fields(const std::string& message);

/// Stores the text of an exception as this thread's last error and returns its status. Laws, tested
/// by number:
///   (1) AbiMismatch                                  PCVT_ERROR_ABI
///   (2) CallbackFault, BadDensity                    PCVT_ERROR_DOMAIN
///   (3) DuplicateSites, BadGeometry                  PCVT_ERROR_GEOMETRY
///   (4) every other InvalidInput                     PCVT_ERROR_ARGUMENT
///   (5) OutputError                                  PCVT_ERROR_IO
///   (6) LimitExceeded, bad_alloc, length_error       PCVT_ERROR_MEMORY
///   (7) everything else                              PCVT_ERROR_INTERNAL
/// Allocates nothing.
/// @pre exception is not null.
pcvt_status note_failure(const std::exception_ptr& exception) noexcept;

/// Runs call(environment of the host) in the default floating-point environment and turns
/// exceptions into a status. Only the end of a thread (pthread_exit, pthread_cancel) passes
/// through.
///
///   return guarded([&](const std::fenv_t& host) { return generate(options, result, host); });
template <class Call>
pcvt_status guarded(const Call& call) {
    const FloatEnvironment environment(FE_DFL_ENV);
    set_last_error("");
    try {
        return call(environment.left());
    } catch (const ThreadEnd&) {
        throw;
    } catch (...) {
        return note_failure(std::current_exception());
    }
}

}  // namespace pcvt::abi
