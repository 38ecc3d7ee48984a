#pragma once

#include <functional>

namespace pcvt::space {

/// Runs work that calls CGAL's triangulations in space.
///
/// CGAL notes the edges of the hole that it fills in a variable of the thread. Memory that ends
/// meanwhile leaves them there, and later triangulations of the thread would find them. So once
/// work() has ended with std::bad_alloc, this function runs all further work of the thread in
/// threads of their own, for the same client (checkpoint.hpp).
///
/// Example usage:
///
///     MirrorDiagram result;
///     run_in_unspoilt_thread([&] { result = mirrors(sites); });
///
/// @throws whatever work() throws, and std::bad_alloc if there is no memory for a thread.
void run_in_unspoilt_thread(const std::function<void()>& work);

}  // namespace pcvt::space
