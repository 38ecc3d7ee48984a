#include "io/formats/output_files.hpp"

#include <gtest/gtest.h>

namespace pcvt {
namespace {

TEST(OutputFiles, TheSuffixPrecedesTheExtension) {
    EXPECT_EQ(with_suffix("tile.obj", "-voronoi"), "tile-voronoi.obj");
    EXPECT_EQ(with_suffix("a.b/tile.v2.obj", "-x"), "a.b/tile.v2-x.obj");
    EXPECT_EQ(with_suffix("a.b/tile", "-x"), "a.b/tile-x");
}

TEST(OutputFiles, TheSlashOfACaseFolderIsDropped) {
    EXPECT_EQ(without_slash("a/t.foam/"), "a/t.foam");
    for (const char* path : {"t.foam", "t.obj/", "folder/"}) EXPECT_EQ(without_slash(path), path);
}

TEST(OutputFiles, PicturesAndSitesAreWrittenButNotChecked) {
    std::string written = output_extensions() + " ";
    for (const std::string only_written :
         {" .svg ", " .png ", " .dxf ", " .html ", " .csv ", " .txt "}) {
        ASSERT_NE(written.find(only_written), std::string::npos) << only_written;
        written.replace(written.find(only_written), only_written.size(), " ");
    }
    EXPECT_EQ(written, readable_extensions() + " ");
}

}  // namespace
}  // namespace pcvt
