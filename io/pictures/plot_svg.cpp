#include "io/pictures/plot_svg.hpp"

#include <algorithm>
#include <cmath>

#include "io/bytes/json_writer.hpp"
#include "io/pictures/plot_ticks.hpp"
#include "io/pictures/svg_canvas.hpp"
#include "mesher/base/error.hpp"
#include "mesher/portable/portable_functions.hpp"

namespace pcvt {
namespace {

constexpr double kPanelWidth = 620;
constexpr double kPanelHeight = 460;
constexpr double kLeft = 72;
constexpr double kRight = 26;
constexpr double kTop = 96;
constexpr double kBottom = 56;
constexpr const char* kFaint = "#e4e6ea";
/// The margin between the outermost points and the border, as a share of the range.
constexpr double kAir = 0.04;
/// Ranges that are smaller than this part of their values are drawn as one value: ticks would
/// differ only by rounding.
constexpr double kRangeRounding = 1e-12;
/// Maps the values along one axis to pixels.
class Scale {
   public:
    Scale(const PlotAxis& axis, double low, double high, double from, double to)
        : logarithmic_(axis.logarithmic), from_(from), to_(to) {
        if (!std::isfinite(low) || !std::isfinite(high) || (logarithmic_ && !(low > 0))) {
            throw InternalError("a point of the plot '" + axis.label + "' cannot be drawn");
        }
        low_ = place(low);
        high_ = place(high);
        const double range = high_ - low_;
        const double size = std::max(std::abs(low_), std::abs(high_));
        const double air = range > kRangeRounding * size ? kAir * range : std::max(size, 1.0) / 10;
        // Quantities that begin at zero are drawn from zero.
        const bool from_zero = !logarithmic_ && low >= 0 && low < 0.3 * high;
        low_ = from_zero ? 0 : low_ - air;
        high_ += air;
    }

    double pixel(double value) const {
        return from_ + (to_ - from_) * (place(value) - low_) / (high_ - low_);
    }
    std::vector<double> ticks() const {
        if (!logarithmic_) return axis_ticks(low_, high_, false);
        return axis_ticks(std::pow(10, low_), std::pow(10, high_), true);
    }
    TickLabels labels() const { return tick_labels(ticks(), logarithmic_); }

   private:
    double place(double value) const { return logarithmic_ ? portable_log10(value) : value; }

    bool logarithmic_;
    double from_;
    double to_;
    double low_;
    double high_;
};

struct Bounds {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    void take(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// One plot with its position on the canvas.
class Panel {
   public:
    Panel(const Plot& plot, double left)
        : plot_(plot),
          left_(left),
          x_(plot.x, bounds(0).low, bounds(0).high, left + kLeft, left + kPanelWidth - kRight),
          y_(plot.y, bounds(1).low, bounds(1).high, kPanelHeight - kBottom, kTop) {}

    std::string draw() const {
        std::string svg =
            svg_text({left_ + kLeft, 30}, plot_.title, R"( font-weight="bold" font-size="16")");
        svg += legend() + x_axis() + y_axis();
        for (const PlotSeries& series : plot_.series) svg += line(series);
        for (const PlotSeries& series : plot_.series) svg += bars(series) + dots(series);
        return svg;
    }

    plane::Vec2 pixel(const plane::Vec2& point) const {
        return {x_.pixel(point.x()), y_.pixel(point.y())};
    }

   private:
    Bounds bounds(int axis) const {
        Bounds bounds;
        for (const PlotSeries& series : plot_.series) {
            for (std::size_t k = 0; k < series.points.size(); ++k) {
                const double error = axis == 1 && k < series.errors.size() ? series.errors[k] : 0;
                bounds.take(series.points[k][axis] - error);
                bounds.take(series.points[k][axis] + error);
            }
        }
        return bounds;
    }
    double bottom() const { return kPanelHeight - kBottom; }
    double right() const { return left_ + kPanelWidth - kRight; }

    std::string legend() const;
    std::string x_axis() const;
    std::string y_axis() const;
    std::string line(const PlotSeries& series) const;
    std::string bars(const PlotSeries& series) const;
    std::string dots(const PlotSeries& series) const;

    const Plot& plot_;
    double left_;
    Scale x_;
    Scale y_;
};

std::string straight(const plane::Vec2& from, const plane::Vec2& to,
                     const std::string& attributes) {
    return "<line" + svg_attribute("x1", from.x()) + svg_attribute("y1", from.y()) +
           svg_attribute("x2", to.x()) + svg_attribute("y2", to.y()) + attributes + "/>\n";
}

std::string disc(const plane::Vec2& centre, double radius, const std::string& colour) {
    return "<circle" + svg_attribute("cx", centre.x()) + svg_attribute("cy", centre.y()) +
           svg_attribute("r", radius) + " fill=\"" + colour + "\"/>\n";
}

bool has_line(const PlotSeries& series) { return series.mark != PlotSeries::Mark::kDots; }

bool has_dots(const PlotSeries& series) {
    return series.mark == PlotSeries::Mark::kDots || series.mark == PlotSeries::Mark::kLineAndDots;
}

std::string line_stroke(const PlotSeries& series) {
    const bool dashed = series.mark == PlotSeries::Mark::kDashes;
    return svg_stroke(series.colour, dashed ? 1.4 : 2) +
           (dashed ? " stroke-dasharray=\"6 4\"" : "");
}

std::string Panel::legend() const {
    constexpr double kMarkWidth = 30;
    constexpr double kGap = 18;
    constexpr double kRow = 52;
    double x = left_ + kLeft;
    std::string svg;
    for (const PlotSeries& series : plot_.series) {
        if (series.label.empty()) continue;
        if (has_line(series))
            svg += straight({x, kRow - 4}, {x + 22, kRow - 4}, line_stroke(series));
        if (has_dots(series)) svg += disc({x + 11, kRow - 4}, 3.5, series.colour);
        svg += svg_text({x + kMarkWidth, kRow}, series.label, "");
        x += kMarkWidth + svg_text_width(series.label, kSvgFontSize) + kGap;
    }
    return svg;
}

std::string Panel::x_axis() const {
    const std::vector<double> ticks = x_.ticks();
    const TickLabels labels = x_.labels();
    std::string svg;
    for (std::size_t k = 0; k < ticks.size(); ++k) {
        const double x = x_.pixel(ticks[k]);
        svg += straight({x, kTop}, {x, bottom()}, kSvgGridClass + svg_stroke(kFaint, 1));
        svg += svg_text({x, bottom() + 18}, labels.texts[k], R"( text-anchor="middle")");
    }
    svg += straight({left_ + kLeft, bottom()}, {right(), bottom()},
                    kSvgLineClass + svg_stroke(kSvgInk, 1));
    const std::string factor = labels.factor.empty() ? "" : " (" + labels.factor + ")";
    return svg + svg_text({(left_ + kLeft + right()) / 2, bottom() + 42}, plot_.x.label + factor,
                          R"( text-anchor="middle")");
}

std::string Panel::y_axis() const {
    const std::vector<double> ticks = y_.ticks();
    const TickLabels labels = y_.labels();
    std::string svg;
    for (std::size_t k = 0; k < ticks.size(); ++k) {
        const double y = y_.pixel(ticks[k]);
        svg += straight({left_ + kLeft, y}, {right(), y}, kSvgGridClass + svg_stroke(kFaint, 1));
        svg += svg_text({left_ + kLeft - 8, y + 4}, labels.texts[k], R"( text-anchor="end")");
    }
    const std::string factor = labels.factor.empty() ? "" : " (" + labels.factor + ")";
    return svg + svg_text({left_ + kLeft, kTop - 16}, plot_.y.label + factor, "");
}

std::string Panel::line(const PlotSeries& series) const {
    if (!has_line(series) || series.points.empty()) return "";
    std::string path;
    for (const plane::Vec2& point : series.points) {
        path += path.empty() ? 'M' : 'L';
        append_pixels(path, x_.pixel(point.x()));
        path += ' ';
        append_pixels(path, y_.pixel(point.y()));
    }
    return "<path fill=\"none\" stroke-linejoin=\"round\"" + line_stroke(series) + " d=\"" + path +
           "\"/>\n";
}

std::string Panel::bars(const PlotSeries& series) const {
    std::string svg;
    for (std::size_t k = 0; k < series.errors.size(); ++k) {
        const plane::Vec2& point = series.points[k];
        const double x = x_.pixel(point.x());
        const double low = y_.pixel(point.y() - series.errors[k]);
        const double high = y_.pixel(point.y() + series.errors[k]);
        if (low - high < 1) continue;
        svg += straight({x, low}, {x, high}, svg_stroke(series.colour, 1.4));
        for (const double y : {low, high}) {
            svg += straight({x - 4, y}, {x + 4, y}, svg_stroke(series.colour, 1.4));
        }
    }
    return svg;
}

std::string Panel::dots(const PlotSeries& series) const {
    if (!has_dots(series)) return "";
    std::string svg;
    for (const plane::Vec2& point : series.points) {
        svg += disc({x_.pixel(point.x()), y_.pixel(point.y())}, 3.5, series.colour);
    }
    return svg;
}

}  // namespace

std::string plot_points(const std::vector<Plot>& plots) {
    constexpr JsonLayout kSeries{.between = ",\n"};
    std::string text;
    JsonWriter json(text);
    json.begin_list(kSeries);
    for (std::size_t k = 0; k < plots.size(); ++k) {
        const Panel panel(plots[k], kPanelWidth * static_cast<double>(k));
        for (const PlotSeries& series : plots[k].series) {
            if (series.mark == PlotSeries::Mark::kDashes) continue;
            json.begin_object();
            json.member("label", series.label);
            json.key("points");
            json.begin_list();
            for (const plane::Vec2& point : series.points) {
                json.begin_list(kCompactJson);
                for (const double pixel : panel.pixel(point)) {
                    std::string number;
                    append_pixels(number, pixel);
                    json.raw(number);
                }
                for (const double x : point) json.value(x);
                json.end();
            }
            json.end();
            json.end();
        }
    }
    json.end();
    return text;
}

std::string encode_plots(const std::string& title, const std::vector<Plot>& plots) {
    std::string svg =
        svg_head(title, kPanelWidth * static_cast<double>(plots.size()), kPanelHeight);
    svg += svg_text_group();
    for (std::size_t k = 0; k < plots.size(); ++k) {
        svg += Panel(plots[k], kPanelWidth * static_cast<double>(k)).draw();
    }
    return svg + "</g>\n</svg>\n";
}

}  // namespace pcvt
