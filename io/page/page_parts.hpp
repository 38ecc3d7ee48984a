#pragma once

#include <string_view>

namespace pcvt {

/// The sources of the page, which embed_page.cmake makes from the files beside it: page.html with
/// the marks @TITLE@, @STYLE@, @DATA@ and @SCRIPT@ (each on its own or within a line), page.css,
/// and all scripts in the order in which they depend on each other.
extern const std::string_view kPageHtml;
extern const std::string_view kPageStyle;
extern const std::string_view kPageScript;

/// The sources of the page of a study: study.html with the further marks @DESCRIPTION@ and
/// @CONTENTS@, study.css and study.js.
extern const std::string_view kStudyHtml;
extern const std::string_view kStudyStyle;
extern const std::string_view kStudyScript;

}  // namespace pcvt
