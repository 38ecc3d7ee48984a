#include "io/run_files/table_name.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "tests/support/temporary_folder.hpp"

namespace pcvt {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(TableName, TheLastColonBeginsTheColumns) {
    const TableName name = parse_table_name("a:b.csv:phi1,Phi,phi2");
    EXPECT_EQ(name.path, "a:b.csv");
    EXPECT_THAT(name.columns, ElementsAre("phi1", "Phi", "phi2"));
    EXPECT_EQ(name.prefix, "");
}

TEST(TableName, APrefixThatTheOptionKnowsComesFirst) {
    const TableName name = parse_table_name("rad:e.csv:1,2,3", {"rad", "deg"});
    EXPECT_EQ(name.prefix, "rad");
    EXPECT_EQ(name.path, "e.csv");
    EXPECT_THAT(name.columns, ElementsAre("1", "2", "3"));
    EXPECT_EQ(parse_table_name("rad:e.csv", {"rad"}).path, "e.csv");
    EXPECT_THAT(parse_table_name("rad:e.csv", {"rad"}).columns, IsEmpty());
    EXPECT_EQ(parse_table_name("rad:e.csv:1", {"deg"}).path, "rad:e.csv");
}

TEST(TableName, AFileThatExistsWinsOverEverySplit) {
    const testing::TemporaryFolder folder;
    const auto path = [&](const char* name) { return std::string(folder / name); };
    for (const char* name : {"t.csv:x,y", "t.csv", "t.csv:"}) {
        testing::write_bytes(path(name), "0 0\n");
        EXPECT_EQ(parse_table_name(path(name), {"rad"}).path, path(name));
        EXPECT_THAT(parse_table_name(path(name)).columns, IsEmpty());
        EXPECT_EQ(parse_table_name("rad:" + path(name), {"rad"}).path, path(name));
        EXPECT_THAT(parse_table_name("rad:" + path(name), {"rad"}).columns, IsEmpty());
    }
}

TEST(TableName, StandardInputMayHaveColumns) {
    EXPECT_EQ(parse_table_name("-").path, "-");
    EXPECT_EQ(parse_table_name("-:x,y").path, "-");
    EXPECT_THAT(parse_table_name("-:x,y").columns, ElementsAre("x", "y"));
}

TEST(TableName, MessagesQuoteWhatAShellWouldSplit) {
    EXPECT_EQ(with_columns({.path = "e.csv"}, "diameter", "ECD"), "diameter:e.csv:ECD");
    EXPECT_EQ(with_columns({.path = "e.csv"}, "", ""), "e.csv");
    EXPECT_EQ(with_columns({.path = "my e.csv"}, "rad", "a,b,c"), "'rad:my e.csv:a,b,c'");
    EXPECT_EQ(with_columns({.path = "e.csv"}, "", "Feret (max)"), "'e.csv:Feret (max)'");
    EXPECT_EQ(with_columns({.path = "e's.csv"}, "", "a b"), "e's.csv:a b");
}

TEST(TableName, EmptyPartsAreNoColumns) {
    EXPECT_EQ(parse_table_name("none.csv:").path, "none.csv:");
    EXPECT_EQ(parse_table_name(":x").path, ":x");
    EXPECT_EQ(parse_table_name("").path, "");
    EXPECT_THAT(parse_table_name("none.csv:x,").columns, ElementsAre("x", ""));
}

}  // namespace
}  // namespace pcvt
