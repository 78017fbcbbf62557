// SPDX-License-Identifier: BSD-3-Clause
#include "tools/commands/direction_plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <string>

#include "tools/images/canvas.hpp"
#include "tools/support/error.hpp"
#include "tools/support/text_table.hpp"
#include "tools/surfaces/profile_shape.hpp"

namespace vcavity::tools {
namespace {

using Point = Vec2<double>;
using Anchor = TextStyle::Anchor;

constexpr double page_width = 820, margin = 24, highest_drawing = 520;
constexpr double scale_of_png = 2;
constexpr double room_for_title = 34, line_of_table = 18;
const TextStyle title_style{.size = 16, .weight = TextStyle::Weight::bold};
const TextStyle table_style{.size = 12};
const TextStyle footnote_style{.size = 10.5, .colour = mid_grey};
const Ink solid = ink(0xe3e3e3);

// Six that are distinct without colour vision (Okabe & Ito, "Color Universal Design", 2008), and two more.
const std::array colours{ink(0x0072b2), ink(0xd55e00), ink(0x009e73), ink(0xcc79a7),
                         ink(0xe69f00), ink(0x56b4e9), ink(0x6a51a3), ink(0x4d4d4d)};

/// One period of the cross-section, the rim of panel one first and at the height of the others.
struct Section {
  std::vector<Point> points;
  std::string names;  // of the faces between them
};

Section section_of(const SurfaceDescription& surface) {
  const ProfileDescription& profile = surface.profile;
  double one, two;
  if (profile.slopes_deg) {
    one = radians((*profile.slopes_deg)[0]);
    two = radians((*profile.slopes_deg)[1]);
  } else {
    const double mean = (180 - surface.aperture_deg) / 2;
    one = radians(mean + profile.tilt_deg.value_or(0));
    two = radians(mean - profile.tilt_deg.value_or(0));
  }
  const double floor = profile.floor.value_or(0), land = profile.land.value_or(0);
  Section section{{{0, 0}}, ""};
  const auto add = [&](double y, double z, char name) {
    section.points.push_back(section.points.back() + Point{y, z});
    section.names += name;
  };
  const bool flat = std::sin(one) < 1e-9 && std::sin(two) < 1e-9;
  add(flat ? 0.5 : std::cos(one), flat ? 0 : -std::sin(one), '1');
  // Panels reach down to the same depth.
  const double depth = -section.points.back().y;
  if (floor > 0) add(floor * depth, 0, 'F');
  add(flat ? 0.5 : depth * std::cos(two) / std::sin(two), depth, '2');
  if (land > 0) add(land / (1 - land) * section.points.back().x, 0, 'L');
  section.points.back().y = 0;
  return section;
}

/// A ray through the middle of a pencil: where it enters, bounces and goes.
struct Way {
  std::vector<Point> corners;  // the entrance, then the bounces
  Point leaving;               // direction at the end
};

Way way_through(const Section& section, double position, Point travel) {
  const double width = section.points.back().x;
  Way way{{{position * width, 0}}, travel};
  constexpr std::size_t max_drawn = 400;
  Point at = way.corners.front() - 1e-3 * travel;
  while (way.corners.size() <= max_drawn) {
    double nearest = std::numeric_limits<double>::infinity();
    Point normal{};
    for (std::size_t i = 1; i < section.points.size(); ++i) {
      const Point along = section.points[i] - section.points[i - 1];
      const Point up = Point{-along.y, along.x} / glm::length(along);
      const double approach = glm::dot(way.leaving, up);
      if (approach >= 0) continue;
      const double distance = glm::dot(section.points[i - 1] - at, up) / approach;
      const double part =
          glm::dot(at + distance * way.leaving - section.points[i - 1], along) / glm::dot(along, along);
      if (part < 0 || part > 1 || distance < 0 || distance >= nearest) continue;
      nearest = distance;
      normal = up;
    }
    if (!std::isfinite(nearest)) break;
    at += nearest * way.leaving;
    way.leaving -= 2 * glm::dot(way.leaving, normal) * normal;
    way.corners.push_back(at);
  }
  return way;
}

/// Where the cross-section lies on the page.
struct Layout {
  double scale;   // CSS pixels for the unit of the section
  Point origin;   // of the rim of panel one
  double bottom;  // of the drawing
};

Layout layout_of(const Section& section) {
  const double width = section.points.back().x;
  double depth = 0;
  for (const Point& point : section.points) depth = std::max(depth, -point.y);
  const double above = 0.5 * std::max(depth, width) + 0.1 * depth,
               below = 0.08 * std::max(depth, 0.5 * width);
  const double scale = std::min((page_width - 2 * margin) / (1.5 * width),
                                (highest_drawing - margin) / (above + depth + below));
  const Point origin{page_width / 2 - scale * width / 2, margin + room_for_title + scale * above};
  return {scale, origin, origin.y + scale * (depth + below)};
}

/// The part of the page that shows the cross-section.
class Drawing {
 public:
  Drawing(const Canvas& canvas, const Section& section, const Layout& layout)
      : canvas_(canvas),
        section_(section),
        scale_(layout.scale),
        origin_(layout.origin),
        bottom_(layout.bottom) {}

  double top() const { return margin + room_for_title; }

  Point on_page(const Point& point) const {
    return {origin_.x + scale_ * point.x, origin_.y - scale_ * point.y};
  }

  /// The solid and its faces.
  void draw_solid() const {
    cairo_t* cairo = canvas_.cairo();
    clip();
    const double width = scale_ * section_.points.back().x;
    const int periods = static_cast<int>(std::ceil(page_width / width)) + 1;
    cairo_move_to(cairo, on_page(section_.points.front()).x - periods * width, bottom_);
    for (int period = -periods; period <= periods; ++period)
      for (const Point& point : section_.points) {
        const Point there = on_page(point);
        cairo_line_to(cairo, there.x + period * width, there.y);
      }
    cairo_line_to(cairo, on_page(section_.points.back()).x + periods * width, bottom_);
    cairo_close_path(cairo);
    canvas_.set_ink(solid);
    cairo_fill_preserve(cairo);
    canvas_.set_ink(dark_grey);
    cairo_set_line_width(cairo, 1.4);
    cairo_stroke(cairo);
    for (std::size_t i = 1; i < section_.points.size(); ++i) {
      const Point along = section_.points[i] - section_.points[i - 1];
      const Point into = Point{along.y, -along.x} / glm::length(along);
      const Point there =
          on_page((section_.points[i] + section_.points[i - 1]) / 2.0) + Point{into.x, -into.y} * 11.0;
      canvas_.text(there.x, there.y + 4, std::string(1, section_.names[i - 1]),
                   {.size = 12, .colour = mid_grey, .anchor = Anchor::centre});
    }
    cairo_reset_clip(cairo);
  }

  /// The light of a pencil before it enters, as wide as it is.
  void draw_beam(double start, double weight, const Point& travel, const Ink& colour) const {
    cairo_t* cairo = canvas_.cairo();
    clip();
    const double width = section_.points.back().x;
    const Point up =
        -travel * (reach({start * width, 0}, -travel) + reach({(start + weight) * width, 0}, -travel));
    const std::array corners{Point{start * width, 0}, Point{(start + weight) * width, 0},
                             Point{(start + weight) * width, 0} + up, Point{start * width, 0} + up};
    for (const Point& corner : corners) cairo_line_to(cairo, on_page(corner).x, on_page(corner).y);
    cairo_close_path(cairo);
    canvas_.set_ink({colour.r, colour.g, colour.b, 0.13});
    cairo_fill(cairo);
    cairo_reset_clip(cairo);
  }

  /// A ray, its bounces numbered, and how much goes its way.
  void draw_way(const Way& way, const Point& travel, double weight, const Ink& colour) {
    cairo_t* cairo = canvas_.cairo();
    canvas_.set_ink(colour);
    cairo_set_line_width(cairo, 1.6);
    clip();
    const Point from = on_page(way.corners.front() - travel * reach(way.corners.front(), -travel));
    cairo_move_to(cairo, from.x, from.y);
    for (const Point& corner : way.corners) cairo_line_to(cairo, on_page(corner).x, on_page(corner).y);
    const Point end =
        on_page(way.corners.back() + way.leaving * 0.86 * reach(way.corners.back(), way.leaving));
    cairo_line_to(cairo, end.x, end.y);
    cairo_stroke(cairo);
    arrow_head(end, {way.leaving.x, -way.leaving.y});
    // The direction of the light, above the groove.
    arrow_head((from + 2.0 * on_page(way.corners.front())) / 3.0, {travel.x, -travel.y});
    cairo_reset_clip(cairo);

    constexpr std::size_t most_numbers = 12;
    for (std::size_t i = 1; i < way.corners.size() && way.corners.size() <= most_numbers + 1; ++i) {
      const Point there = on_page(way.corners[i]);
      cairo_arc(cairo, there.x, there.y, 2.6, 0, 2 * std::numbers::pi);
      cairo_fill(cairo);
      // Beside the bounce, on the side from which the light comes and goes.
      const Point before = i > 1 ? way.corners[i - 1] : way.corners[i] - travel;
      const Point after = i + 1 < way.corners.size() ? way.corners[i + 1] : way.corners[i] + way.leaving;
      Point aside = glm::normalize(before - way.corners[i]) + glm::normalize(after - way.corners[i]);
      if (glm::length(aside) < 1e-3) aside = {0, 1};
      aside = glm::normalize(aside);
      Point place = there + Point{aside.x, -aside.y} * 12.0;
      constexpr double apart = 12;
      while (std::any_of(numbers_.begin(), numbers_.end(),
                         [&](const Point& other) { return glm::distance(other, place) < apart; }))
        place += Point{aside.x, -aside.y} * apart;
      numbers_.push_back(place);
      label(place, std::to_string(i), colour);
    }
    const Point beyond = glm::normalize(Point{way.leaving.x, -way.leaving.y});
    const Point place = end + beyond * 14.0;
    Point centre{std::clamp(place.x, 2 * margin, page_width - 2 * margin), std::max(place.y, top() + 8)};
    constexpr double wide = 48, high = 13;
    while (std::any_of(weights_.begin(), weights_.end(), [&](const Point& other) {
      return std::abs(other.x - centre.x) < wide && std::abs(other.y - centre.y) < high;
    }))
      centre.y += high;
    weights_.push_back(centre);
    label(centre, with_digits(100 * weight, 3) + " %", colour);
  }

 private:
  void clip() const {
    cairo_rectangle(canvas_.cairo(), margin, top(), page_width - 2 * margin, bottom_ - top());
    cairo_clip(canvas_.cairo());
  }

  void label(const Point& centre, const std::string& text, const Ink& colour) const {
    // A little of the paper behind the figure keeps it legible on lines.
    const TextStyle style{
        .size = 11.5, .colour = colour, .anchor = Anchor::centre, .weight = TextStyle::Weight::bold};
    const double half = text_width(text, style) / 2;
    canvas_.set_ink(ink(0xffffff, 0.75));
    cairo_rectangle(canvas_.cairo(), centre.x - half - 1, centre.y - 6, 2 * half + 2, 12);
    cairo_fill(canvas_.cairo());
    canvas_.text(centre.x, centre.y + 4, text, style);
    canvas_.set_ink(colour);
  }

  /// How far it is from a point to the edge of the drawing.
  double reach(const Point& from, const Point& direction) const {
    const Point there = on_page(from);
    double distance = std::numeric_limits<double>::infinity();
    if (direction.y > 0) distance = (there.y - top()) / direction.y;
    if (direction.x > 0) distance = std::min(distance, (page_width - margin - there.x) / direction.x);
    if (direction.x < 0) distance = std::min(distance, (margin - there.x) / direction.x);
    return std::isfinite(distance) ? std::max(distance, 0.0) / scale_ : 0;
  }

  void arrow_head(const Point& tip, const Point& direction) const {
    const Point along = glm::normalize(direction), across{-along.y, along.x};
    cairo_t* cairo = canvas_.cairo();
    for (const Point& corner :
         {tip + 4.0 * along, tip - 5.0 * along + 3.6 * across, tip - 5.0 * along - 3.6 * across})
      cairo_line_to(cairo, corner.x, corner.y);
    cairo_close_path(cairo);
    cairo_fill(cairo);
  }

  const Canvas& canvas_;
  const Section& section_;
  double scale_;
  Point origin_;
  double bottom_;
  std::vector<Point> numbers_, weights_;  // where they stand, so that none covers another
};

/// The pencils of light of the lobes, without reflectances.
std::vector<FacePencil<double>> pencils_of(const DirectionPlot& plot) {
  std::vector<FacePencil<double>> pencils;
  with_profile(plot.surface, [&](const auto& shape) {
    shape.follow(
        plot.e, [](const double&) { return 1.0; },
        [&](const FacePencil<double>& light, double) {
          if (light.weight > negligible_fraction<double>()) pencils.push_back(light);
        });
  });
  return pencils;
}

}  // namespace

void write_direction_plot(AtomicFile& file, const DirectionPlot& plot) {
  if (plot.lobes.empty())
    throw UsageError("--plot: draws the lobes of mirrors, which this surface does not have");
  const double across = std::hypot(plot.e.y, plot.e.z);
  if (!(plot.e.z > 1e-3 * across))
    throw UsageError("--plot: light that grazes the surface enters no groove, expected --theta below 90");
  const Point travel{-plot.e.y / across, -plot.e.z / across};
  const Section section = section_of(plot.surface);
  const std::vector<FacePencil<double>> pencils = pencils_of(plot);
  const auto colour_of = [&](std::size_t i) { return colours[i % colours.size()]; };

  const double text_width = page_width - 2 * margin;
  const double footnote = paragraph_height(plot.footnote, footnote_style, text_width);
  const Layout layout = layout_of(section);
  const double table = line_of_table * (static_cast<double>(plot.lobes.size()) + 2);
  Canvas canvas(file, page_width, layout.bottom + table + footnote + margin, scale_of_png);
  canvas.text(margin, margin + 14, plot.title, title_style);
  Drawing drawing(canvas, section, layout);
  for (std::size_t i = 0; i < pencils.size(); ++i)
    drawing.draw_beam(pencils[i].start, pencils[i].weight, travel, colour_of(i));
  drawing.draw_solid();
  for (std::size_t i = 0; i < pencils.size(); ++i)
    drawing.draw_way(way_through(section, pencils[i].start + pencils[i].weight / 2, travel), travel,
                     pencils[i].weight, colour_of(i));

  double y = layout.bottom + 1.5 * line_of_table;
  const std::array columns{margin + 22, margin + 200, margin + 290, margin + 390, margin + 500};
  const std::array headings{"faces met", "bounces", "weight", "throughput", "leaves towards (x, y, z)"};
  for (std::size_t i = 0; i < columns.size(); ++i)
    canvas.text(columns[i], y, headings[i], {.size = 12, .colour = dark_grey});
  for (std::size_t i = 0; i < plot.lobes.size(); ++i) {
    y += line_of_table;
    const SurfaceLobe& lobe = plot.lobes[i];
    canvas.set_ink(colour_of(i));
    cairo_rectangle(canvas.cairo(), margin, y - 9, 14, 9);
    cairo_fill(canvas.cairo());
    std::string faces = i < pencils.size() ? pencils[i].path.text() : lobe.facets;
    constexpr std::size_t most_faces = 20;
    if (faces.size() > most_faces) faces.replace(most_faces - 3, std::string::npos, "...");
    std::string direction;
    for (const double component : {lobe.direction.x, lobe.direction.y, lobe.direction.z})
      direction.append(direction.empty() ? "" : ", ").append(with_digits(component + 0.0, 4));
    const std::array cells{faces, std::to_string(lobe.bounces), with_digits(lobe.weight, 5),
                           with_digits(lobe.throughput.unpolarized, 5), direction};
    for (std::size_t column = 0; column < columns.size(); ++column)
      canvas.text(columns[column], y, cells[column], table_style);
  }
  canvas.paragraph(margin, y + line_of_table / 2, plot.footnote, footnote_style, text_width);
  canvas.finish();
}

}  // namespace vcavity::tools
