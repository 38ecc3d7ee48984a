#include "mesher/space/geometry/unspoilt_thread.hpp"

#include <exception>
#include <new>
#include <system_error>
#include <thread>

#include "mesher/base/checkpoint.hpp"

namespace pcvt::space {
namespace {

thread_local bool is_thread_spoilt = false;

}  // namespace

void run_in_unspoilt_thread(const std::function<void()>& work) {
    if (!is_thread_spoilt) {
        try {
            work();
            return;
        } catch (const std::bad_alloc&) {
            is_thread_spoilt = true;
            throw;
        }
    }
    std::exception_ptr failure;
    Client* const client = current_client();
    try {
        std::thread([&] {
            const ClientScope scope(client);
            try {
                work();
            } catch (...) {
                failure = std::current_exception();
            }
        }).join();
    } catch (const std::system_error&) {
        throw std::bad_alloc();
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace pcvt::space
