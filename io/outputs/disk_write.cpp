#include "io/outputs/disk_write.hpp"

#include <unistd.h>

#include <cerrno>
#include <utility>

#include "io/outputs/file_calls.hpp"
#include "mesher/base/checkpoint.hpp"

namespace pcvt {
namespace {

/// The bytes between two checkpoints, and the most for which one synchronisation waits.
constexpr std::size_t kPiece = std::size_t{4} << 20;
constexpr std::size_t kMostUnsynchronised = std::size_t{16} << 20;

/// A file that is closed on every way out.
class OpenFile {
   public:
    explicit OpenFile(int number) : number_(number) {}
    ~OpenFile() { close(); }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    int close() { return number_ < 0 || ::close(std::exchange(number_, -1)) == 0 ? 0 : errno; }

   private:
    int number_;
};

int write_pieces(int file, std::string_view bytes) {
    std::size_t unsynchronised = 0;
    while (!bytes.empty()) {
        const std::string_view piece = bytes.substr(0, kPiece);
        if (unsynchronised + piece.size() > kMostUnsynchronised) {
            if (const int error = sync_file(file)) return error;
            unsynchronised = 0;
        }
        checkpoint();
        if (const int error = write_all(file, piece)) return error;
        unsynchronised += piece.size();
        bytes.remove_prefix(piece.size());
    }
    return sync_file(file);
}

}  // namespace

int write_to_disk(int file, std::string_view bytes) {
    OpenFile closed_at_end(file);
    const int error = write_pieces(file, bytes);
    const int close_error = closed_at_end.close();
    return error != 0 ? error : close_error;
}

}  // namespace pcvt
