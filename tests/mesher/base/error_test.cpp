#include "mesher/base/error.hpp"

#include <gtest/gtest.h>

namespace pcvt {
namespace {

TEST(Error, AMessageIsOnePrintableLine) {
    EXPECT_STREQ(InvalidInput("a\tb\r\nc\x1b[2Jd\x7f\n").what(), "a b  c?[2Jd?");
    EXPECT_STREQ(InternalError("tile \xC3\xA4.obj").what(), "tile \xC3\xA4.obj");
    EXPECT_STREQ(LimitExceeded("").what(), "");
}

TEST(Error, ANulByteDoesNotCutAMessage) {
    EXPECT_STREQ(InvalidInput(std::string("a\0b", 3)).what(), "a?b");
}

}  // namespace
}  // namespace pcvt
