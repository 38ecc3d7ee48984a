#include "io/bytes/encoded_file.hpp"

#include <algorithm>

#include "io/bytes/bad_file.hpp"

namespace pcvt {

void require_same_bytes(const std::vector<EncodedFile>& files,
                        const std::vector<EncodedFile>& wanted) {
    for (const EncodedFile& own : wanted) {
        for (const EncodedFile& file : files) {
            if (file.path != own.path || file.bytes == own.bytes) continue;
            const auto [here, there] = std::mismatch(file.bytes.begin(), file.bytes.end(),
                                                     own.bytes.begin(), own.bytes.end());
            const auto line = 1 + std::count(file.bytes.begin(), here, '\n');
            throw BadFile(file.path + ":" + std::to_string(line) +
                          ": another line follows from the cells; write the file again with pcvt");
        }
    }
}

}  // namespace pcvt
