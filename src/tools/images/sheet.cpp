// SPDX-License-Identifier: BSD-3-Clause
#include "tools/images/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tools/images/canvas.hpp"
#include "tools/images/ticks.hpp"

namespace vcavity::tools {
namespace {

using Anchor = TextStyle::Anchor;
using Weight = TextStyle::Weight;

const TextStyle title_style{.size = 22, .weight = Weight::bold};
const TextStyle subtitle_style{.size = 14, .colour = dark_grey};
const TextStyle label_style{.size = 15, .anchor = Anchor::centre};
const TextStyle tick_style{.size = 12, .colour = dark_grey};
const TextStyle bar_label_style{.size = 13, .colour = dark_grey, .anchor = Anchor::centre};
const TextStyle angle_style{.size = 10, .colour = mid_grey, .anchor = Anchor::centre};
const TextStyle note_style{.size = 11, .anchor = Anchor::centre};
const TextStyle footnote_style{.size = 11, .colour = mid_grey};

constexpr double margin = 28;
constexpr double gap = 26;           // between discs
constexpr double label_height = 28;  // above a disc
constexpr double bar_thickness = 16;
constexpr double bar_gap = 34;  // between the discs and the colour bar
constexpr double most_bar_height = 420;

constexpr double degree = std::numbers::pi / 180;

struct Layout {
  int columns, rows;
  double bar_room;    // at the right of the discs
  double top;         // of the grid of discs
  double angle_room;  // around a disc, for the labels of φ
  double diameter, cell_width, cell_height;
  double grid_height, page_height;
};

void validate(const Sheet& sheet) {
  if (sheet.discs.empty()) throw std::invalid_argument("a sheet needs at least one disc");
  for (const auto& disc : sheet.discs)
    if (disc.size < 1 ||
        disc.pixels.size() != static_cast<std::size_t>(disc.size) * static_cast<std::size_t>(disc.size))
      throw std::invalid_argument("disc '" + disc.label + "' of size " + std::to_string(disc.size) + " has " +
                                  std::to_string(disc.pixels.size()) + " pixels, expected " +
                                  std::to_string(static_cast<long>(disc.size) * disc.size));
}

std::vector<Tick> bar_ticks(const ColourBar& bar) {
  return linear_ticks(bar.low, bar.high, 9);
}

// Width of the colour bar with its numbers and its label.
double width_of(const ColourBar& bar) {
  double numbers = 0;
  for (const auto& tick : bar_ticks(bar)) numbers = std::max(numbers, text_width(tick.label, tick_style));
  const double label = bar.label.empty() ? 0 : bar_label_style.size * 2;
  return bar_gap + bar_thickness + 8 + numbers + label;
}

// Up to four discs in one row, five or six in two rows of three, then rows of four.
int default_columns(std::size_t discs) {
  return discs <= 4 ? static_cast<int>(discs) : discs <= 6 ? 3 : 4;
}

Layout lay_out(const Sheet& sheet) {
  Layout layout{};
  const int discs = static_cast<int>(sheet.discs.size());
  const double text_room = sheet.width - 2 * margin;
  layout.columns = std::min(sheet.columns > 0 ? sheet.columns : default_columns(sheet.discs.size()), discs);
  layout.rows = (discs + layout.columns - 1) / layout.columns;
  layout.bar_room = sheet.colour_bar ? width_of(*sheet.colour_bar) : 0;

  layout.top = margin + paragraph_height(sheet.title, title_style, text_room);
  for (const auto& line : sheet.subtitle) layout.top += paragraph_height(line, subtitle_style, text_room);
  if (layout.top > margin) layout.top += gap / 2;

  layout.angle_room = sheet.grid == AngleGrid::shown ? 22 : 0;
  layout.cell_width = (text_room - layout.bar_room - (layout.columns - 1) * gap) / layout.columns;
  layout.diameter = layout.cell_width - 2 * layout.angle_room;
  layout.cell_height = label_height + layout.diameter + 2 * layout.angle_room;
  layout.grid_height = layout.rows * layout.cell_height + (layout.rows - 1) * gap;
  layout.page_height = layout.top + layout.grid_height + margin;
  if (!sheet.footnote.empty())
    layout.page_height += gap / 2 + paragraph_height(sheet.footnote, footnote_style, text_room);
  return layout;
}

// A thin line that shows on any colour: light on a translucent dark edge.
void stroke_on_any_colour(const Canvas& canvas) {
  canvas.set_ink({0, 0, 0, 0.22});
  cairo_set_line_width(canvas.cairo(), 1.8);
  cairo_stroke_preserve(canvas.cairo());
  canvas.set_ink({1, 1, 1, 0.75});
  cairo_set_line_width(canvas.cairo(), 0.7);
  cairo_stroke(canvas.cairo());
}

// Letters that show on any colour, centred or to the right of a point of their baseline.
void text_on_any_colour(const Canvas& canvas, double x, double y, const std::string& text,
                        const TextStyle& style) {
  cairo_t* const context = canvas.cairo();
  cairo_select_font_face(context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, style.size);
  cairo_move_to(context, style.anchor == Anchor::centre ? x - text_width(text, style) / 2 : x, y);
  cairo_text_path(context, text.c_str());
  canvas.set_ink({0, 0, 0, 0.45});
  cairo_set_line_width(context, 2.2);
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  cairo_stroke_preserve(context);
  canvas.set_ink({1, 1, 1});
  cairo_fill(context);
}

// Bold lines that show on any colour, not to be mistaken for the grid.
void draw_contours(const Canvas& canvas, const DiscMap& disc, double x, double y, double radius) {
  cairo_t* const context = canvas.cairo();
  cairo_new_path(context);
  for (const DiscLine& line : disc.contours) {
    cairo_new_sub_path(context);
    for (const auto& [u, v] : line) cairo_line_to(context, x + radius * u, y - radius * v);
  }
  cairo_set_line_join(context, CAIRO_LINE_JOIN_ROUND);
  canvas.set_ink({0, 0, 0, 0.55});
  cairo_set_line_width(context, 3.4);
  cairo_stroke_preserve(context);
  canvas.set_ink({1, 1, 1});
  cairo_set_line_width(context, 1.6);
  cairo_stroke(context);
  for (const DiscNote& note : disc.notes)
    if (text_width(note.text, note_style) <= note.room * radius)
      text_on_any_colour(canvas, x + radius * note.at.u, y - radius * note.at.v, note.text, note_style);
}

// Radius of a circle of equal θ on a disc whose rim, θ = 90°, has radius 1.
double disc_radius(double theta) {
  return std::numbers::sqrt2 * std::sin(theta / 2);
}

void draw_angle_grid(const Canvas& canvas, double x, double y, double radius) {
  cairo_t* const context = canvas.cairo();
  for (const double theta : {30.0, 60.0}) {
    cairo_new_path(context);
    cairo_arc(context, x, y, radius * disc_radius(theta * degree), 0, 2 * std::numbers::pi);
    stroke_on_any_colour(canvas);
  }
  const double inner = radius * disc_radius(30 * degree);
  for (int phi = 0; phi < 360; phi += 45) {
    const double from = phi % 90 == 0 ? 0 : inner;  // fewer lines where they meet
    cairo_move_to(context, x + from * std::cos(phi * degree), y - from * std::sin(phi * degree));
    cairo_line_to(context, x + radius * std::cos(phi * degree), y - radius * std::sin(phi * degree));
    stroke_on_any_colour(canvas);
  }
  for (const int theta : {30, 60}) {
    const double at = radius * disc_radius(theta * degree);
    text_on_any_colour(canvas, x + 3, y - at + 12, std::to_string(theta) + "°", {.size = angle_style.size});
  }
  const double baseline = 0.36 * angle_style.size;  // centres digits on a point
  canvas.text(x + radius + 5, y + baseline, "0°", {.size = angle_style.size, .colour = mid_grey});
  canvas.text(x, y - radius - 6, "φ = 90°", angle_style);
  canvas.text(x, y + radius + 14, "270°", angle_style);
  canvas.text(x - radius - 5, y + baseline, "180°",
              {.size = angle_style.size, .colour = mid_grey, .anchor = Anchor::right});
}

// Continues the colours at the rim outwards, so that a resampled picture does not fade there; the disc is
// clipped later.
std::vector<Rgba8> with_extended_rim(const DiscMap& disc) {
  std::vector<Rgba8> pixels = disc.pixels;
  const double centre = disc.size / 2.0;
  const double inside = std::max(centre - 1, 0.0);  // at this radius a pixel lies wholly within the disc
  const auto index = [&](double x, double y) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(disc.size) + static_cast<std::size_t>(x);
  };
  for (int row = 0; row < disc.size; ++row)
    for (int column = 0; column < disc.size; ++column) {
      const double x = column + 0.5 - centre, y = row + 0.5 - centre, radius = std::hypot(x, y);
      if (radius <= inside) continue;
      const double shrink = inside / radius;
      pixels[index(column, row)] = disc.pixels[index(centre + shrink * x, centre + shrink * y)];
    }
  return pixels;
}

void draw_disc(const Canvas& canvas, const DiscMap& disc, AngleGrid grid, double x, double y, double radius) {
  cairo_t* const context = canvas.cairo();
  cairo_save(context);
  cairo_arc(context, x, y, radius, 0, 2 * std::numbers::pi);
  cairo_clip(context);
  canvas.picture(x - radius, y - radius, 2 * radius, 2 * radius, disc.size, disc.size,
                 with_extended_rim(disc));
  draw_contours(canvas, disc, x, y, radius);
  cairo_restore(context);
  if (grid == AngleGrid::shown) draw_angle_grid(canvas, x, y, radius);
  cairo_new_path(context);
  cairo_arc(context, x, y, radius, 0, 2 * std::numbers::pi);
  canvas.set_ink(mid_grey);
  cairo_set_line_width(context, 1);
  cairo_stroke(context);
}

void draw_colour_bar(const Canvas& canvas, const ColourBar& bar, double x, double y, double height) {
  constexpr int steps = 256;
  std::vector<Rgba8> colours(steps);
  for (int i = 0; i < steps; ++i)
    colours[static_cast<std::size_t>(i)] = map_colour(bar.map, 1 - (i + 0.5) / steps);
  canvas.picture(x, y, bar_thickness, height, 1, steps, colours);
  canvas.set_ink(mid_grey);
  cairo_set_line_width(canvas.cairo(), 1);
  cairo_rectangle(canvas.cairo(), x, y, bar_thickness, height);
  cairo_stroke(canvas.cairo());

  double numbers = 0;
  for (const auto& tick : bar_ticks(bar)) {
    const double at = y + height * (bar.high - tick.value) / (bar.high - bar.low);
    canvas.set_ink(mid_grey);
    canvas.line(x + bar_thickness, at, x + bar_thickness + 4, at);
    canvas.text(x + bar_thickness + 8, at + 0.36 * tick_style.size, tick.label, tick_style);
    numbers = std::max(numbers, text_width(tick.label, tick_style));
  }
  canvas.text(x + bar_thickness + 8 + numbers + 1.5 * bar_label_style.size, y + height / 2, bar.label,
              bar_label_style, -std::numbers::pi / 2);
}

}  // namespace

void write_sheet(AtomicFile& file, const Sheet& sheet) {
  validate(sheet);
  const Layout layout = lay_out(sheet);
  const double text_room = sheet.width - 2 * margin;
  Canvas canvas(file, sheet.width, layout.page_height, sheet.scale);

  double y = canvas.paragraph(margin, margin - 4, sheet.title, title_style, text_room);
  for (const auto& line : sheet.subtitle) y = canvas.paragraph(margin, y, line, subtitle_style, text_room);

  for (std::size_t i = 0; i < sheet.discs.size(); ++i) {
    const auto column = static_cast<int>(i) % layout.columns, row = static_cast<int>(i) / layout.columns;
    const double x = margin + column * (layout.cell_width + gap) + layout.cell_width / 2;
    const double top = layout.top + row * (layout.cell_height + gap);
    canvas.text(x, top + label_style.size, sheet.discs[i].label, label_style);
    draw_disc(canvas, sheet.discs[i], sheet.grid, x,
              top + label_height + layout.angle_room + layout.diameter / 2, layout.diameter / 2);
  }

  if (sheet.colour_bar) {
    const double height =
        std::min(most_bar_height, layout.grid_height - label_height - 2 * layout.angle_room);
    const double middle = layout.top + (label_height + layout.grid_height) / 2;
    draw_colour_bar(canvas, *sheet.colour_bar, sheet.width - margin - layout.bar_room + bar_gap,
                    middle - height / 2, height);
  }
  canvas.paragraph(margin, layout.top + layout.grid_height + gap / 2, sheet.footnote, footnote_style,
                   text_room);
  canvas.finish();
}

}  // namespace vcavity::tools
