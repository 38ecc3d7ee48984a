#include "io/outputs/journal.hpp"

#include <gmock/gmock.h>

#include "io/outputs/run_file.hpp"

namespace pcvt {
namespace {

Journal example() {
    Journal journal;
    journal.folders = {{"", "abcdefgh"}, {"/some/where", "01234567"}};
    journal.moves = {{.kind = FileMove::Kind::kReplacement,
                      .folder = 1,
                      .temporary = temporary_leaf("tile.obj", "01234567", 0),
                      .target = "tile.obj",
                      .fresh = {5, 6, 7},
                      .old = {8, -9, 10}},
                     {.kind = FileMove::Kind::kNewFolder,
                      .folder = 0,
                      .temporary = temporary_leaf("c.foam", "abcdefgh", 12),
                      .target = "out/deep/c.foam",
                      .fresh = {},
                      .old = {}}};
    return journal;
}

TEST(Journal, IsReadBackAsItWasWritten) {
    const Journal journal = example();
    const std::optional<Journal> read = decode_journal(encode_journal(journal));
    ASSERT_TRUE(read);
    EXPECT_EQ(encode_journal(*read), encode_journal(journal));
    ASSERT_EQ(read->moves.size(), 2U);
    EXPECT_EQ(read->moves[0].old, (FileStamp{8, -9, 10}));
    EXPECT_EQ(read->moves[1].target, "out/deep/c.foam");
    EXPECT_EQ(decode_pointer(encode_pointer("/a/b\nc")), "/a/b\nc");
}

TEST(Journal, IsInvalidUntilItsLastByteIsWritten) {
    const std::string bytes = encode_journal(example());
    for (std::size_t n = 0; n < bytes.size(); ++n) EXPECT_FALSE(decode_journal(bytes.substr(0, n)));
    for (std::size_t n = 0; n < bytes.size(); ++n) {
        std::string damaged = bytes;
        damaged[n] = static_cast<char>(damaged[n] ^ 1);
        EXPECT_FALSE(decode_journal(damaged)) << n;
    }
    EXPECT_FALSE(decode_journal(bytes + '\0'));
    EXPECT_FALSE(decode_journal(encode_pointer("/a")));
    EXPECT_FALSE(decode_pointer(bytes));
}

TEST(Journal, NamesNothingOutsideOfItsFolders) {
    for (const char* target : {"../a", "/a", "a/../../b", "", "a//b", "./a", "a/"}) {
        Journal journal = example();
        journal.moves[0].target = target;
        EXPECT_FALSE(decode_journal(encode_journal(journal))) << target;
    }
    for (const char* temporary : {"a", "../.a.pcvt-01234567-0.new", ".a.pcvt-abcdefgh-0.new",
                                  "x/.a.pcvt-01234567-0.new", ".a.pcvt-01234567-0.old"}) {
        Journal journal = example();
        journal.moves[0].temporary = temporary;
        EXPECT_FALSE(decode_journal(encode_journal(journal))) << temporary;
    }
}

TEST(Journal, TemporaryNamesCarryTheirToken) {
    EXPECT_EQ(temporary_token(temporary_leaf("tile.obj", "abcdefgh", 3)), "abcdefgh");
    EXPECT_LE(temporary_leaf(std::string(255, 'n'), "abcdefgh", 99999999).size(), 255U);
    EXPECT_EQ(run_file_token(run_file_name("abcdefgh")), "abcdefgh");
    EXPECT_EQ(backup_path("d/.a.pcvt-abcdefgh-3.new"), "d/.a.pcvt-abcdefgh-3.old");
    for (const char* name :
         {".a.pcvt-abcdefgh-.new", ".a.pcvt-abcdefgh-x.new", "a.pcvt-abcdefgh-0.new",
          ".a.pcvt-ABCDEFGH-0.new", ".pcvt-abcdefgh", ".a.pcvt-abcdefgh.new"}) {
        EXPECT_FALSE(temporary_token(name)) << name;
    }
    for (const char* name :
         {".pcvt-abcdefg", ".pcvt-abcdefgh1", "pcvt-abcdefgh", ".pcvt-abcdefg."}) {
        EXPECT_FALSE(run_file_token(name)) << name;
    }
}

}  // namespace
}  // namespace pcvt
