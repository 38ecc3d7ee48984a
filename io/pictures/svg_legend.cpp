#include "io/pictures/svg_legend.hpp"

#include <algorithm>

namespace pcvt {
namespace {

constexpr double kMargin = 20;
constexpr double kLine = 22;
constexpr double kMarkWidth = 22;
constexpr double kGap = 18;
/// The least width of a row beneath the drawing.
constexpr double kShortestRow = 400;
/// The legend lies beside a drawing with a larger ratio of height to width.
constexpr double kTall = 1.6;

double entry_width(const LegendEntry& entry) {
    return kMarkWidth + svg_text_width(entry.label, kSvgFontSize);
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
    double y = kMargin + 12;
    double widest = caption_width(legend);
    std::string svg = svg_text({x, y}, legend.caption, R"( font-weight="bold")");
    for (const LegendEntry& entry : legend.entries) {
        y += kLine;
        svg += legend_entry(x, y, entry);
        widest = std::max(widest, entry_width(entry));
    }
    return {svg, x + widest + kMargin, std::max(frame.height(), y + kMargin)};
}

PlacedLegend beneath(const Legend& legend, const SvgFrame& frame) {
    const double row_end = std::max(frame.width() - kMargin, kMargin + kShortestRow);
    double x = kMargin;
    double y = frame.height() + 12;
    double right = x + caption_width(legend);
    std::string svg = svg_text({x, y}, legend.caption, R"( font-weight="bold")");
    y += kLine;
    for (const LegendEntry& entry : legend.entries) {
        if (x > kMargin && x + entry_width(entry) > row_end) {
            x = kMargin;
            y += kLine;
        }
        svg += legend_entry(x, y, entry);
        x += entry_width(entry) + kGap;
        right = std::max(right, x - kGap);
    }
    return {svg, std::max(frame.width(), right + kMargin), y + kMargin};
}

}  // namespace

std::string legend_entry(double x, double y, const LegendEntry& entry) {
    return mark_at(x, y, entry) + svg_text({x + kMarkWidth, y}, entry.label, "");
}

PlacedLegend place_legend(const Legend& legend, const SvgFrame& frame) {
    return frame.height() > kTall * frame.width() ? beside(legend, frame) : beneath(legend, frame);
}

}  // namespace pcvt
