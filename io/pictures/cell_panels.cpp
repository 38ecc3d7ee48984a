#include "io/pictures/cell_panels.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace pcvt {
namespace {

constexpr double kPanelMargin = 24;
constexpr double kPanelGap = 28;
constexpr double kHeading = 52;
constexpr double kCaptionLine = 17;
constexpr double kEntryHeight = 30;
/// The width of an entry's mark and of the gap after its label.
constexpr double kEntryGap = 40;
/// The size of the caption of all panels, in pixels.
constexpr double kHeadingSize = 16;
/// Below this spacing in pixels, dots would merge into grey.
constexpr double kLeastDottedPanelSpacing = 7;
constexpr const char* kPanelEdgeColour = "#565c68";

/// The positions of the panels, in pixels.
struct Grid {
    PanelLayout layout;
    int n_panels;
    std::size_t n_lines;

    int rows() const { return (n_panels + layout.columns - 1) / layout.columns; }
    int columns() const { return std::min(layout.columns, n_panels); }
    double row_height() const {
        return layout.size + kPanelGap + kCaptionLine * static_cast<double>(n_lines) + 4;
    }
    plane::Vec2 corner(int panel) const {
        const int row = panel / layout.columns;
        const int column = panel % layout.columns;
        return {kPanelMargin + (layout.size + kPanelGap) * column, kHeading + row_height() * row};
    }
    double width() const {
        return 2 * kPanelMargin + columns() * (layout.size + kPanelGap) - kPanelGap;
    }
    double height() const { return kHeading + rows() * row_height(); }
};

/// Maps length units, y upwards, to the pixels of one panel.
class PanelFrame {
   public:
    PanelFrame(const plane::Polygon& outline, const plane::Vec2& corner, double size)
        : corner_(corner) {
        low_ = high_ = outline.at(0);
        for (const plane::Vec2& p : outline) {
            low_ = low_.cwiseMin(p);
            high_ = high_.cwiseMax(p);
        }
        scale_ = size / (high_ - low_).maxCoeff();
    }
    plane::Vec2 pixel(const plane::Vec2& p) const {
        return corner_ + scale_ * plane::Vec2(p.x() - low_.x(), high_.y() - p.y());
    }
    double scale() const { return scale_; }
    double height() const { return scale_ * (high_.y() - low_.y()); }

   private:
    plane::Vec2 corner_;
    plane::Vec2 low_;
    plane::Vec2 high_;
    double scale_;
};

void append_hundredths(std::string& text, double value) {
    append_pixels(text, std::round(100 * value) / 100);
}

void append_polygon(std::string& path, const plane::Polygon& polygon, const PanelFrame& frame) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const plane::Vec2 pixel = frame.pixel(polygon[k]);
        path += k == 0 ? 'M' : 'L';
        append_hundredths(path, pixel.x());
        path += ' ';
        append_hundredths(path, pixel.y());
    }
    path += 'Z';
}

std::string draw_cells(const CellPanel& panel, const PanelFrame& frame) {
    std::map<std::string, std::string> by_colour;
    for (const CellPanel::Cell& cell : panel.cells) {
        append_polygon(by_colour[cell.colour], cell.polygon, frame);
    }
    std::string svg;
    for (const auto& [colour, path] : by_colour) {
        svg += "<path fill=\"" + colour + "\" d=\"" + path + "\"/>\n";
    }
    return svg;
}

std::string draw_sites(const CellPanel& panel, const PanelFrame& frame) {
    if (panel.sites.empty()) return "";
    const double spacing = frame.scale() * std::sqrt(std::abs(plane::polygon_area(panel.outline)) /
                                                     static_cast<double>(panel.sites.size()));
    if (spacing < kLeastDottedPanelSpacing) return "";
    std::string path;
    for (const plane::Vec2& site : panel.sites) {
        const plane::Vec2 pixel = frame.pixel(site);
        path += 'M';
        append_hundredths(path, pixel.x());
        path += ' ';
        append_hundredths(path, pixel.y());
        path += "h0";
    }
    return "<path stroke=\"#30343c\" stroke-linecap=\"round\"" +
           svg_attribute("stroke-width", std::clamp(0.09 * spacing, 1.0, 5.0)) + " d=\"" + path +
           "\"/>\n";
}

std::string draw_panel(const CellPanel& panel, const plane::Vec2& corner, double size) {
    const PanelFrame frame(panel.outline, corner, size);
    std::string outline;
    append_polygon(outline, panel.outline, frame);
    std::string svg = std::string("<g stroke=\"") + kPanelEdgeColour +
                      "\" stroke-width=\"0.7\" stroke-linejoin=\"round\">\n" +
                      draw_cells(panel, frame) + draw_sites(panel, frame) + "</g>\n";
    svg += std::string("<path") + kSvgLineClass + " fill=\"none\" stroke-width=\"1.2\" stroke=\"" +
           kSvgInk + "\" d=\"" + outline + "\"/>\n";
    double y = corner.y() + frame.height() + 5;
    for (std::size_t k = 0; k < panel.caption.size(); ++k) {
        y += kCaptionLine;
        svg += svg_text({corner.x(), y}, panel.caption[k], k == 0 ? R"( font-weight="bold")" : "");
    }
    return svg;
}

std::string draw_entries(const std::vector<LegendEntry>& entries, double y) {
    double x = kPanelMargin;
    std::string svg;
    for (const LegendEntry& entry : entries) {
        svg += legend_entry(x, y, entry);
        x += kEntryGap + svg_text_width(entry.label, kSvgFontSize);
    }
    return svg;
}

double entries_width(const std::vector<LegendEntry>& entries) {
    double x = 2 * kPanelMargin;
    for (const LegendEntry& entry : entries) {
        x += kEntryGap + svg_text_width(entry.label, kSvgFontSize);
    }
    return x;
}

}  // namespace

std::string encode_cell_panels(const Legend& legend, const std::vector<CellPanel>& panels,
                               const PanelLayout& layout) {
    Grid grid{layout, static_cast<int>(panels.size()), 0};
    for (const CellPanel& panel : panels)
        grid.n_lines = std::max(grid.n_lines, panel.caption.size());
    const double heading = 2 * kPanelMargin + svg_bold_text_width(legend.caption, kHeadingSize);
    const double width = std::max({grid.width(), heading, entries_width(legend.entries)});
    std::string svg = svg_head(legend.caption, width, grid.height() + kEntryHeight);
    svg += svg_text_group();
    svg += svg_text({kPanelMargin, 32}, legend.caption,
                    R"( font-weight="bold")" + svg_attribute("font-size", kHeadingSize));
    for (int k = 0; k < grid.n_panels; ++k) {
        svg += draw_panel(panels[k], grid.corner(k), layout.size);
    }
    return svg + draw_entries(legend.entries, grid.height()) + "</g>\n</svg>\n";
}

}  // namespace pcvt
