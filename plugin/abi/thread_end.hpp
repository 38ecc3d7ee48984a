#pragma once

#include <exception>

#if defined(__GLIBCXX__)
#include <cxxabi.h>
#endif

namespace pcvt::abi {

#if defined(__GLIBCXX__)
/// The exception by which pthread_exit() and pthread_cancel() end a thread; it must be rethrown.
using ThreadEnd = __cxxabiv1::__forced_unwind;
#else
/// Threads end without an exception here.
class ThreadEnd {};
#endif

}  // namespace pcvt::abi
