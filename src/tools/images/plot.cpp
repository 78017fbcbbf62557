// SPDX-License-Identifier: BSD-3-Clause
#include "tools/images/plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "tools/images/canvas.hpp"
#include "tools/images/ticks.hpp"

namespace vcavity::tools {
namespace {

using Anchor = TextStyle::Anchor;
using Weight = TextStyle::Weight;

const TextStyle title_style{.size = 16, .weight = Weight::bold};
const TextStyle axis_style{.size = 13, .anchor = Anchor::centre};
const TextStyle legend_style{.size = 12};
const TextStyle footnote_style{.size = 10.5, .colour = mid_grey};
constexpr double tick_size = 11.5;

constexpr double margin = 20;
constexpr double swatch = 28;  // of the legend
constexpr double marker_radius = 3.6;
constexpr double room_per_label_x = 70, room_per_label_y = 40;

// Distinct without colour vision: Okabe & Ito, "Color Universal Design", 2008, without their yellow.
const std::array colours{ink(0x0072b2), ink(0xd55e00), ink(0x009e73), ink(0xcc79a7),
                         ink(0xe69f00), ink(0x56b4e9), ink(0x000000)};

// Where the values of one axis lie on the page.
class Mapping {
 public:
  Mapping(const Axis& axis, std::pair<double, double> range, double first, double last)
      : logarithmic_(axis.scale == Axis::Scale::logarithmic), range_(range), first_(first), last_(last) {}

  bool can_show(double value) const { return std::isfinite(value) && (!logarithmic_ || value > 0); }

  double operator()(double value) const {
    const double low = straight(range_.first), high = straight(range_.second);
    return first_ + (last_ - first_) * (straight(value) - low) / (high - low);
  }

  std::vector<Tick> ticks(double room_per_label) const {
    const int most = std::max(2, static_cast<int>(std::abs(last_ - first_) / room_per_label));
    return logarithmic_ ? log_ticks(range_.first, range_.second, most)
                        : linear_ticks(range_.first, range_.second, most);
  }

 private:
  double straight(double value) const { return logarithmic_ ? std::log10(value) : value; }

  bool logarithmic_;
  std::pair<double, double> range_;
  double first_, last_;
};

// The given range, or the extent of the data with a little air.
std::pair<double, double> range_of(const Axis& axis, const std::vector<Series>& series,
                                   std::vector<double> Series::* values) {
  if (axis.range) return *axis.range;
  const bool logarithmic = axis.scale == Axis::Scale::logarithmic;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const auto& one : series)
    for (const double value : one.*values)
      if (std::isfinite(value) && (!logarithmic || value > 0)) {
        low = std::min(low, value);
        high = std::max(high, value);
      }
  if (low > high) return logarithmic ? std::pair{0.1, 10.0} : std::pair{0.0, 1.0};  // nothing to show
  constexpr double air = 0.04;
  if (logarithmic) {
    const double factor = low < high ? std::pow(high / low, air) : 2;
    return {low / factor, high * factor};
  }
  const double space = low < high ? air * (high - low) : std::max(1.0, std::abs(low)) / 2;
  return {low - space, high + space};
}

void draw_marker(const Canvas& canvas, std::size_t shape, double x, double y) {
  cairo_t* const context = canvas.cairo();
  const auto polygon = [&](int corners, double turn, double radius) {
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners + turn;
      cairo_line_to(context, x + radius * std::sin(angle), y - radius * std::cos(angle));
    }
    cairo_close_path(context);
  };
  cairo_new_path(context);
  switch (shape % 4) {
    case 0:
      cairo_arc(context, x, y, marker_radius, 0, 2 * std::numbers::pi);
      break;
    case 1:
      polygon(4, std::numbers::pi / 4, 1.25 * marker_radius);
      break;
    case 2:
      polygon(3, 0, 1.4 * marker_radius);
      break;
    case 3:
      polygon(4, 0, 1.4 * marker_radius);
      break;
  }
  cairo_fill(context);
}

void draw_series(const Canvas& canvas, const Series& series, std::size_t index, const Mapping& x,
                 const Mapping& y) {
  cairo_t* const context = canvas.cairo();
  canvas.set_ink(colours[index % colours.size()]);
  cairo_new_path(context);
  if (series.look != Series::Look::markers) {
    for (std::size_t i = 0; i < series.x.size(); ++i)
      if (!x.can_show(series.x[i]) || !y.can_show(series.y[i]))
        cairo_new_sub_path(context);
      else
        cairo_line_to(context, x(series.x[i]), y(series.y[i]));
    cairo_set_line_width(context, 1.8);
    cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
    cairo_stroke(context);
  }
  if (series.look != Series::Look::line)
    for (std::size_t i = 0; i < series.x.size(); ++i)
      if (x.can_show(series.x[i]) && y.can_show(series.y[i]))
        draw_marker(canvas, index, x(series.x[i]), y(series.y[i]));
}

// One sample of line and marker for each series that has a name.
void draw_legend(const Canvas& canvas, const std::vector<Series>& series, double left, double top) {
  double y = top + legend_style.size / 2;
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (series[i].name.empty()) continue;
    canvas.set_ink(colours[i % colours.size()]);
    cairo_set_line_width(canvas.cairo(), 1.8);
    if (series[i].look != Series::Look::markers) canvas.line(left, y, left + swatch, y);
    if (series[i].look != Series::Look::line) draw_marker(canvas, i, left + swatch / 2, y);
    canvas.text(left + swatch + 8, y + 0.36 * legend_style.size, series[i].name, legend_style);
    y += 1.7 * legend_style.size;
  }
}

double legend_width(const std::vector<Series>& series) {
  double names = 0;
  for (const auto& one : series) names = std::max(names, text_width(one.name, legend_style));
  return names > 0 ? swatch + 8 + names + margin : 0;
}

// The centre of a pixel, where thin upright and level lines are sharp.
double crisp(double position) {
  return std::floor(position) + 0.5;
}

struct Box {
  double left, top, right, bottom;
};

void draw_axes(const Canvas& canvas, const Plot& plot, const Box& box, const Mapping& x, const Mapping& y) {
  cairo_set_line_width(canvas.cairo(), 1);
  for (const auto& tick : x.ticks(room_per_label_x)) {
    const double at = crisp(x(tick.value));
    canvas.set_ink(tick.label.empty() ? ink(0xf3f3f3) : light_grey);
    canvas.line(at, box.top, at, box.bottom);
    canvas.text(at, box.bottom + 1.5 * tick_size, tick.label,
                {.size = tick_size, .colour = dark_grey, .anchor = Anchor::centre});
  }
  for (const auto& tick : y.ticks(room_per_label_y)) {
    const double at = crisp(y(tick.value));
    canvas.set_ink(tick.label.empty() ? ink(0xf3f3f3) : light_grey);
    canvas.line(box.left, at, box.right, at);
    canvas.text(box.left - 6, at + 0.36 * tick_size, tick.label,
                {.size = tick_size, .colour = dark_grey, .anchor = Anchor::right});
  }
  canvas.set_ink(mid_grey);
  cairo_rectangle(canvas.cairo(), box.left, box.top, box.right - box.left, box.bottom - box.top);
  cairo_stroke(canvas.cairo());
  canvas.text((box.left + box.right) / 2, box.bottom + 3 * tick_size + 4, plot.x.label, axis_style);
  canvas.text(margin + axis_style.size * 0.6, (box.top + box.bottom) / 2, plot.y.label, axis_style,
              -std::numbers::pi / 2);
}

void validate(const Plot& plot) {
  for (const auto& one : plot.series)
    if (one.x.size() != one.y.size())
      throw std::invalid_argument("series '" + one.name + "' has " + std::to_string(one.x.size()) +
                                  " x and " + std::to_string(one.y.size()) + " y");
}

// The frame of a plot on a page of its own.
Box frame_of(const Plot& plot) {
  const double text_room = plot.width - 2 * margin;
  Box box;
  box.top = crisp(margin + paragraph_height(plot.title, title_style, text_room));
  box.bottom =
      crisp(plot.height - margin - 3.4 * tick_size -
            paragraph_height(plot.footnote, footnote_style, text_room) - (plot.x.label.empty() ? 0 : 6));
  box.right = crisp(plot.width - margin - legend_width(plot.series));
  const Mapping y(plot.y, range_of(plot.y, plot.series, &Series::y), box.bottom, box.top);
  double numbers = 0;
  for (const auto& tick : y.ticks(room_per_label_y))
    numbers = std::max(numbers, text_width(tick.label, {.size = tick_size}));
  box.left = crisp(margin + numbers + 10 + (plot.y.label.empty() ? 0 : 1.6 * axis_style.size));
  return box;
}

void draw_plot(const Canvas& canvas, const Plot& plot, const Box& box) {
  const Mapping x(plot.x, range_of(plot.x, plot.series, &Series::x), box.left, box.right);
  const Mapping y(plot.y, range_of(plot.y, plot.series, &Series::y), box.bottom, box.top);
  const double text_room = plot.width - 2 * margin;
  canvas.paragraph(margin, margin - 8, plot.title, title_style, text_room);
  draw_axes(canvas, plot, box, x, y);
  cairo_save(canvas.cairo());
  cairo_rectangle(canvas.cairo(), box.left, box.top, box.right - box.left, box.bottom - box.top);
  cairo_clip(canvas.cairo());
  for (std::size_t i = 0; i < plot.series.size(); ++i) draw_series(canvas, plot.series[i], i, x, y);
  cairo_restore(canvas.cairo());
  draw_legend(canvas, plot.series, box.right + margin, box.top);
  canvas.paragraph(margin,
                   plot.height - margin / 2 - paragraph_height(plot.footnote, footnote_style, text_room),
                   plot.footnote, footnote_style, text_room);
}

}  // namespace

void write_plot(AtomicFile& file, const Plot& plot) {
  write_plots(file, {plot});
}

void write_plots(AtomicFile& file, const std::vector<Plot>& plots) {
  if (plots.empty()) throw std::invalid_argument("a page needs at least one plot");
  double height = 0;
  double left = 0;
  double right = std::numeric_limits<double>::infinity();
  for (const Plot& plot : plots) {
    validate(plot);
    const Box box = frame_of(plot);
    left = std::max(left, box.left);
    right = std::min(right, box.right);
    height += std::ceil(plot.height);
  }

  Canvas canvas(file, plots.front().width, height, plots.front().scale);
  for (const Plot& plot : plots) {
    const Box box = frame_of(plot);
    draw_plot(canvas, plot, {left, box.top, right, box.bottom});
    cairo_translate(canvas.cairo(), 0, std::ceil(plot.height));
  }
  canvas.finish();
}

}  // namespace vcavity::tools
