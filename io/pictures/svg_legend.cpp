#include "io/pictures/svg_legend.hpp"

#include <algorithm>

namespace pcvt {
namespace {

constexpr double kLegendMargin = 20;
constexpr double kLegendLine = 22;
constexpr double kLegendMarkWidth = 22;
constexpr double kLegendGap = 18;
/// The least width of a row beneath the drawing.
constexpr double kShortestRow = 400;
/// The legend lies beside a drawing with a larger ratio of height to width.
constexpr double kTall = 1.6;

double entry_width(const LegendEntry& entry) {
    return kLegendMarkWidth + svg_text_width(entry.label, kSvgFontSize);
}

double caption_width(const Legend& legend) {
    return svg_bold_text_width(legend.caption, kSvgFontSize);
}

std::string mark_at(double x, double y, const LegendEntry& entry) {
    const std::string colour = "=\"" + entry.colour + "\"";
    switch (entry.mark) {
        case LegendEntry::Mark::kPatch:
            return "<rect" + svg_attribute("x", x) + svg_attribute("y", y - 11) +
                   R"( width="14" height="14" rx="2" stroke="#555b66" stroke-width="0.8" fill)" +
                   colour + "/>\n";
        case LegendEntry::Mark::kDisc:
            return "<circle" + svg_attribute("cx", x + 7) + svg_attribute("cy", y - 4) +
                   R"( r="6" stroke="#8b919c" stroke-width="1" fill)" + colour + "/>\n";
        default:
            break;
    }
    const bool dashed = entry.mark == LegendEntry::Mark::kDashes;
    std::string line = "<line" + svg_attribute("x1", x) + svg_attribute("y1", y - 4) +
                       svg_attribute("x2", x + 15) + svg_attribute("y2", y - 4);
    line +=
        dashed ? kSvgLineClass + std::string(R"( stroke-width="1.2" stroke-dasharray="4 3" stroke)")
               : R"( stroke-width="3.5" stroke-linecap="round" stroke)";
    return line + colour + "/>\n";
}

PlacedLegend beside(const Legend& legend, const SvgFrame& frame) {
    const double x = frame.width();
    double y = kLegendMargin + 12;
    double widest = caption_width(legend);
    std::string svg = svg_text({x, y}, legend.caption, R"( font-weight="bold")");
    for (const LegendEntry& entry : legend.entries) {
        y += kLegendLine;
        svg += legend_entry(x, y, entry);
        widest = std::max(widest, entry_width(entry));
    }
    return {svg, x + widest + kLegendMargin, std::max(frame.height(), y + kLegendMargin)};
}

PlacedLegend beneath(const Legend& legend, const SvgFrame& frame) {
    const double row_end = std::max(frame.width() - kLegendMargin, kLegendMargin + kShortestRow);
    double x = kLegendMargin;
    double y = frame.height() + 12;
    double right = x + caption_width(legend);
    std::string svg = svg_text({x, y}, legend.caption, R"( font-weight="bold")");
    y += kLegendLine;
    for (const LegendEntry& entry : legend.entries) {
        if (x > kLegendMargin && x + entry_width(entry) > row_end) {
            x = kLegendMargin;
            y += kLegendLine;
        }
        svg += legend_entry(x, y, entry);
        x += entry_width(entry) + kLegendGap;
        right = std::max(right, x - kLegendGap);
    }
    return {svg, std::max(frame.width(), right + kLegendMargin), y + kLegendMargin};
}

}  // namespace

std::string legend_entry(double x, double y, const LegendEntry& entry) {
    return mark_at(x, y, entry) + svg_text({x + kLegendMarkWidth, y}, entry.label, "");
}

PlacedLegend place_legend(const Legend& legend, const SvgFrame& frame) {
    return frame.height() > kTall * frame.width() ? beside(legend, frame) : beneath(legend, frame);
}

}  // namespace pcvt
