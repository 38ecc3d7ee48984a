#include "io/page/study_page.hpp"

#include <algorithm>

#include "io/bytes/json_writer.hpp"
#include "io/page/page_parts.hpp"
#include "io/page/page_text.hpp"

namespace pcvt {
namespace {

std::string button(const std::string& action, const std::string& name, const std::string& text) {
    return "<button type=\"button\" data-save=\"" + action + "\" data-name=\"" + html_text(name) +
           "\">" + text + "</button>\n";
}

std::string picture_section(const StudyPagePicture& picture) {
    return "<section class=\"picture\" data-picture=\"" + html_text(picture.name) + "\">\n" +
           picture.svg + button("svg", picture.name, "Download SVG") + "</section>\n";
}

template <class Cells>
std::string table_row(const Cells& cells, const std::string& tag) {
    std::string row = "<tr>";
    for (const std::string& cell : cells) {
        row += "<" + tag + ">";
        row += html_text(cell) + "</" + tag + ">";
    }
    return row + "</tr>\n";
}

std::string table_section(const StudyPageTable& table) {
    std::string section = "<section><h2>" + html_text(table.name) + "</h2>\n";
    for (const std::string& remark : table.remarks) section += "<p>" + html_text(remark) + "</p>\n";
    section += "<div class=\"scroll\"><table>\n<thead>" + table_row(table.columns, "th");
    section += "</thead>\n<tbody>\n";
    const std::size_t n_shown = std::min(table.rows.size(), kMostPageRows);
    for (std::size_t k = 0; k < n_shown; ++k) section += table_row(table.rows[k], "td");
    section += "</tbody>\n</table></div>\n";
    if (n_shown < table.rows.size()) {
        section += "<p>The first " + std::to_string(n_shown) + " of " +
                   std::to_string(table.rows.size()) + " rows; the file has all of them.</p>\n";
    }
    return section + button("csv", table.name, "Download CSV") + "</section>\n";
}

/// Returns {"points": {NAME: the points of its plots}, "csv": {NAME: the bytes of the file}}.
std::string page_data(const std::vector<StudyPagePicture>& pictures,
                      const std::vector<StudyPageTable>& tables) {
    std::string text;
    JsonWriter json(text, {.between = ",\n"}, JsonEscapes::kInPage);
    json.begin_object();
    json.object("points", [&] {
        for (const StudyPagePicture& picture : pictures) {
            if (picture.points.empty()) continue;
            json.key(picture.name);
            json.raw(picture.points);
        }
    });
    json.object("csv", [&] {
        for (const StudyPageTable& table : tables) json.member(table.name, table.csv);
    });
    json.end();
    return text;
}

}  // namespace

std::string encode_study_page(const std::string& name, const std::string& description,
                              const std::vector<StudyPagePicture>& pictures,
                              const std::vector<StudyPageTable>& tables) {
    std::string contents;
    for (const StudyPagePicture& picture : pictures) contents += picture_section(picture);
    for (const StudyPageTable& table : tables) contents += table_section(table);
    return filled_page(kStudyHtml, {{"@TITLE@", html_text(name)},
                                    {"@DESCRIPTION@", html_text(description)},
                                    {"@STYLE@", std::string(kStudyStyle)},
                                    {"@CONTENTS@", contents},
                                    {"@DATA@", page_data(pictures, tables)},
                                    {"@SCRIPT@", std::string(kStudyScript)}});
}

}  // namespace pcvt
