#pragma once

namespace pcvt {

/// Thrown to end work that its client has cancelled.
struct Cancelled {};

/// The party for which a thread works. Long work calls it often, so that it can end the work, and
/// so that it can do things of its own in between.
///
/// Any number of threads may work for one client; Workers hands the client of the thread that calls
/// for_each() to its team. A thread without a client works to the end.
///
/// Example usage:
///
///     class Patience final : public Client {
///         void pass() override { if (clock() > end) throw Cancelled{}; }
///     } patience;
///     const ClientScope scope(&patience);
///     compute_cvt(lattice, points, {});  // calls checkpoint()
class Client {
   public:
    /// Called at each checkpoint, by any thread. Cheap: some nanoseconds.
    /// @throws Cancelled where the work shall end, or an error of its own.
    virtual void pass() = 0;

   protected:
    ~Client() = default;
};

namespace detail {
/// The client of this thread: the one thing that long work does not get as an argument.
extern constinit thread_local Client* client_of_thread;
}  // namespace detail

/// The client of this thread, or null.
inline Client* current_client() { return detail::client_of_thread; }

/// Makes this thread work for a client while this object lives. Null: for none, where the work must
/// not end half way, or where foreign code runs.
class ClientScope {
   public:
    explicit ClientScope(Client* client) : before_(current_client()) {
        detail::client_of_thread = client;
    }
    ~ClientScope() { detail::client_of_thread = before_; }
    ClientScope(const ClientScope&) = delete;
    ClientScope& operator=(const ClientScope&) = delete;

   private:
    Client* before_;
};

/// Calls the client of this thread. Long work calls it at least once in a few milliseconds, between
/// steps after which everything may be destroyed. Never in a destructor.
/// @throws Cancelled
inline void checkpoint() {
    if (Client* const client = current_client()) client->pass();
}

/// Calls checkpoint() for every k-th item of a loop whose steps are short, k a power of two.
inline void checkpoint_each(long item, long k = 1024) {
    if ((item & (k - 1)) == 0) checkpoint();
}

}  // namespace pcvt
