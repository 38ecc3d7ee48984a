#include "plugin/cli/exit_code.hpp"

#include <gmock/gmock.h>

#include <new>

#include "io/bytes/output_error.hpp"
#include "io/forms/tile_file.hpp"
#include "plugin/job/job.hpp"

namespace pcvt::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

template <class Thrown>
Failure failure_of(const Thrown& thrown) {
    return describe_failure(std::make_exception_ptr(thrown));
}

TEST(ExitCode, BadInputIsLaw1) {
    EXPECT_EQ(failure_of(InvalidInput("x")).code, ExitCode::kBadInput);
    EXPECT_EQ(failure_of(BadFile("x")).code, ExitCode::kBadInput);
    EXPECT_EQ(failure_of(DuplicateSites(1, 2)).code, ExitCode::kBadInput);
    EXPECT_EQ(failure_of(NotATile("x")).code, ExitCode::kBadInput);
}

TEST(ExitCode, OutputIsLaw2) {
    EXPECT_EQ(failure_of(OutputError("x")).code, ExitCode::kNotWritten);
}

TEST(ExitCode, LimitsAreLaw3) {
    EXPECT_EQ(failure_of(LimitExceeded("x")).code, ExitCode::kLimit);
    EXPECT_EQ(failure_of(std::bad_alloc()).code, ExitCode::kLimit);
    EXPECT_EQ(failure_of(std::length_error("x")).code, ExitCode::kLimit);
}

TEST(ExitCode, EverythingElseIsLaw4) {
    for (const Failure& failure :
         {failure_of(InternalError("x")), failure_of(std::out_of_range("x")), failure_of(7)}) {
        EXPECT_EQ(failure.code, ExitCode::kFault);
        EXPECT_THAT(failure.line.data(), HasSubstr("fault of pcvt"));
    }
}

TEST(ExitCode, NumbersAreAsDocumented) {
    EXPECT_EQ(static_cast<int>(ExitCode::kDone), 0);
    EXPECT_EQ(static_cast<int>(ExitCode::kFault), 1);
    EXPECT_EQ(static_cast<int>(ExitCode::kBadInput), 2);
    EXPECT_EQ(static_cast<int>(ExitCode::kNotWritten), 3);
    EXPECT_EQ(static_cast<int>(ExitCode::kLimit), 4);
    EXPECT_EQ(static_cast<int>(ExitCode::kNotConverged), 5);
    EXPECT_EQ(static_cast<int>(ExitCode::kInterrupted), 130);
    EXPECT_EQ(static_cast<int>(ExitCode::kTerminated), 143);
}

TEST(ExitCode, MessagesAreOneLineAndFilesComeFirst) {
    EXPECT_STREQ(failure_of(BadFile("sites.txt:7: what\nelse\n")).line.data(),
                 "sites.txt:7: what else");
    EXPECT_THAT(failure_of(InvalidInput("x")).line.data(), StartsWith("pcvt: "));
    EXPECT_THAT(failure_of(InternalError("a\r\nb")).line.data(), Not(HasSubstr("\n")));
}

}  // namespace
}  // namespace pcvt::cli
