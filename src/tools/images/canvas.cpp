// SPDX-License-Identifier: BSD-3-Clause
#include "tools/images/canvas.hpp"

#include <cairo-svg.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>
#include <stdexcept>

namespace vcavity::tools {
namespace {

// Cairo calls this from C: an exception must not pass, the file remembers the failure.
cairo_status_t write_bytes(void* file, const unsigned char* data, unsigned int size) noexcept try {
  static_cast<AtomicFile*>(file)->write(data, size);
  return CAIRO_STATUS_SUCCESS;
} catch (const std::exception&) {
  return CAIRO_STATUS_WRITE_ERROR;
}

void select_type(cairo_t* context, const TextStyle& style) {
  cairo_select_font_face(
      context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
      style.weight == TextStyle::Weight::bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, style.size);
}

// Glyphs must not depend on the desktop's settings for screens: the same figure gives the same bytes.
void fix_font_options(cairo_t* context) {
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_SLIGHT);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(context, options);
  cairo_font_options_destroy(options);
}

double advance(cairo_t* context, const std::string& text) {
  cairo_text_extents_t extents;
  cairo_text_extents(context, text.c_str(), &extents);
  if (const auto status = cairo_status(context); status != CAIRO_STATUS_SUCCESS)
    throw std::invalid_argument("a figure cannot show the text '" + text +
                                "': " + cairo_status_to_string(status));
  return extents.x_advance;
}

bool wants_svg(const std::filesystem::path& target) {
  const auto extension = target.extension();
  if (extension == ".svg") return true;
  if (extension == ".png") return false;
  throw std::invalid_argument("a figure is a .png or .svg file, not '" + target.string() + "'");
}

}  // namespace

Ink ink(unsigned rgb, double alpha) {
  return {(rgb >> 16 & 0xff) / 255.0, (rgb >> 8 & 0xff) / 255.0, (rgb & 0xff) / 255.0, alpha};
}

double text_width(const std::string& text, const TextStyle& style) {
  const CairoSurface surface(cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1));
  const CairoContext context(cairo_create(surface.get()));
  fix_font_options(context.get());
  select_type(context.get(), style);
  return advance(context.get(), text);
}

std::vector<std::string> wrap(const std::string& text, const TextStyle& style, double width) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.empty() ? word : lines.back() + " " + word;
    if (lines.empty())
      lines.push_back(word);
    else if (text_width(longer, style) <= width)
      lines.back() = longer;
    else
      lines.push_back(word);
  }
  return lines;
}

double paragraph_height(const std::string& text, const TextStyle& style, double width) {
  return static_cast<double>(wrap(text, style, width).size()) * style.size * leading;
}

Canvas::Canvas(AtomicFile& file, double width, double height, double scale)
    : file_(file), svg_(wants_svg(file.target())) {
  const auto pixels = [&](double length) { return static_cast<int>(std::lround(length * scale)); };
  surface_.reset(svg_ ? cairo_svg_surface_create_for_stream(write_bytes, &file, width, height)
                      : cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels(width), pixels(height)));
  if (svg_) cairo_svg_surface_set_document_unit(surface_.get(), CAIRO_SVG_UNIT_PX);
  context_.reset(cairo_create(surface_.get()));
  if (!svg_) cairo_scale(cairo(), scale, scale);
  fix_font_options(cairo());
  cairo_set_source_rgb(cairo(), 1, 1, 1);
  cairo_paint(cairo());
}

void Canvas::set_ink(const Ink& colour) const {
  cairo_set_source_rgba(cairo(), colour.r, colour.g, colour.b, colour.alpha);
}

void Canvas::text(double x, double y, const std::string& line, const TextStyle& style, double turn) const {
  cairo_save(cairo());
  set_ink(style.colour);
  select_type(cairo(), style);
  cairo_translate(cairo(), x, y);
  cairo_rotate(cairo(), turn);
  const double width = advance(cairo(), line);
  const double shift = style.anchor == TextStyle::Anchor::left     ? 0
                       : style.anchor == TextStyle::Anchor::centre ? -width / 2
                                                                   : -width;
  cairo_move_to(cairo(), shift, 0);
  cairo_show_text(cairo(), line.c_str());
  cairo_restore(cairo());
}

double Canvas::paragraph(double x, double top, const std::string& text, const TextStyle& style,
                         double width) const {
  double y = top;
  for (const auto& line : wrap(text, style, width)) {
    y += style.size * leading;
    this->text(x, y - style.size * (leading - 1), line, style);
  }
  return y;
}

void Canvas::line(double x0, double y0, double x1, double y1) const {
  cairo_move_to(cairo(), x0, y0);
  cairo_line_to(cairo(), x1, y1);
  cairo_stroke(cairo());
}

void Canvas::picture(double x, double y, double width, double height, int columns, int rows,
                     const std::vector<Rgba8>& pixels) const {
  const CairoSurface image(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, columns, rows));
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(image.get()));
  unsigned char* const data = cairo_image_surface_get_data(image.get());
  if (data == nullptr)
    throw std::runtime_error("no memory for a picture of " + std::to_string(columns) + " pixels");
  const auto premultiplied = [](std::uint32_t component, std::uint32_t alpha) {
    return (component * alpha + 127) / 255;
  };
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto [r, g, b, a] = pixels[i];
    const std::uint32_t word =
        std::uint32_t{a} << 24 | premultiplied(r, a) << 16 | premultiplied(g, a) << 8 | premultiplied(b, a);
    const auto column = i % static_cast<std::size_t>(columns), row = i / static_cast<std::size_t>(columns);
    std::memcpy(data + row * stride + column * sizeof word, &word, sizeof word);
  }
  cairo_surface_mark_dirty(image.get());

  cairo_save(cairo());
  cairo_rectangle(cairo(), x, y, width, height);
  cairo_clip(cairo());
  cairo_translate(cairo(), x, y);
  cairo_scale(cairo(), width / columns, height / rows);
  cairo_set_source_surface(cairo(), image.get(), 0, 0);
  cairo_pattern_set_extend(cairo_get_source(cairo()), CAIRO_EXTEND_PAD);  // no fade-out at the borders
  cairo_paint(cairo());
  cairo_restore(cairo());
}

void Canvas::finish() {
  cairo_status_t status = cairo_status(cairo());
  if (status == CAIRO_STATUS_SUCCESS && !svg_)
    status = cairo_surface_write_to_png_stream(surface_.get(), write_bytes, &file_);
  cairo_surface_finish(surface_.get());
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(surface_.get());
  file_.check();
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error("cannot draw '" + file_.target().string() +
                             "': " + cairo_status_to_string(status));
}

}  // namespace vcavity::tools
