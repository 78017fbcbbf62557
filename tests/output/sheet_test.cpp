// SPDX-License-Identifier: BSD-3-Clause
#include "tools/images/sheet.hpp"

#include <cmath>
#include <numbers>

#include "page.hpp"
#include "scratch_folder.hpp"

using namespace vcavity::tools;

namespace {

constexpr Rgba8 red{255, 0, 0, 255}, green{0, 255, 0, 255}, blue{0, 0, 255, 255}, violet{255, 0, 255, 255};

// Upper left red, upper right green, lower left blue, lower right violet.
DiscMap quarters(int size) {
  DiscMap disc{"", size, {}};
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double u = 2 * (x + 0.5) / size - 1, v = 1 - 2 * (y + 0.5) / size;
      const Rgba8 colour = v > 0 ? (u < 0 ? red : green) : (u < 0 ? blue : violet);
      disc.pixels.push_back(u * u + v * v <= 1 ? colour : Rgba8{});
    }
  return disc;
}

DiscMap uniform(Rgba8 colour) {
  return {"", 64, std::vector<Rgba8>(64 * 64, colour)};
}

Page drawn(const Sheet& sheet) {
  const ScratchFolder folder;
  AtomicFile file(folder / "a.png");
  write_sheet(file, sheet);
  file.commit();
  return Page(folder / "a.png");
}

const Rgba8 white{255, 255, 255, 255};

/// The colour bar to the right of red discs: its pixels within the frame.
struct Bar {
  int inside;  ///< a column
  int right;   ///< the last column of the frame
  int top, bottom;

  explicit Bar(const Page& page) {
    const Patch discs = page.find(red);
    const int middle = static_cast<int>(discs.y);
    inside = discs.right + 5;
    while (inside + 8 < page.width && page.at(inside, middle) == white) ++inside;
    inside += 8;  // from the frame into the bar
    top = bottom = middle;
    while (page.at(inside, top - 1) != white) --top;
    while (page.at(inside, bottom + 1) != white) ++bottom;
    right = inside;
    while (page.at(right + 1, middle) != white) ++right;
  }

  /// The row of a share of the bar from its lower end.
  int level(double share) const { return bottom - static_cast<int>(std::lround((bottom - top) * share)); }
};

}  // namespace

TEST_CASE("a disc is drawn upright, round and to its rim, whatever its resolution") {
  const int size = GENERATE(32, 301, 1200);
  CAPTURE(size);
  Sheet sheet;
  sheet.discs = {quarters(size)};
  sheet.width = 600;
  const Page page = drawn(sheet);
  const Patch upper_left = page.find(red), upper_right = page.find(green);
  const Patch lower_left = page.find(blue), lower_right = page.find(violet);
  CHECK(upper_left.x < upper_right.x);
  CHECK(upper_left.y < lower_left.y);
  CHECK(lower_left.x < lower_right.x);
  CHECK(std::abs(upper_left.y - upper_right.y) < 1);
  CHECK(std::abs(upper_left.x - lower_left.x) < 1);
  const double radius = (upper_right.right - upper_left.left + 1) / 2.0;
  CHECK(std::abs(radius - (600 - 2 * 28) / 2.0) < 2);
  const int count = upper_left.count + upper_right.count + lower_left.count + lower_right.count;
  // The seams between the quarters blend over one pixel of the map on either side, the rim over one of the
  // page.
  const double seams = 4 * radius * (2 * radius / size + 2), rim = 2 * std::numbers::pi * radius;
  CHECK(count <= std::numbers::pi * radius * radius);
  CHECK(count >= std::numbers::pi * radius * radius - seams - 2 * rim);
}

TEST_CASE("discs stand in reading order") {
  Sheet sheet;
  sheet.discs = {uniform(red), uniform(green), uniform(blue), uniform(violet)};
  const Page row = drawn(sheet);
  CHECK(row.find(red).x < row.find(green).x);
  CHECK(row.find(green).x < row.find(blue).x);
  CHECK(row.find(blue).right < row.find(violet).left);
  CHECK(row.find(red).y == Catch::Approx(row.find(violet).y));

  sheet.columns = 2;
  const Page block = drawn(sheet);
  CHECK(block.find(red).right < block.find(green).left);
  CHECK(block.find(red).bottom < block.find(blue).top);
  CHECK(block.find(red).x == Catch::Approx(block.find(blue).x));
  CHECK(block.width == 1200);
  CHECK(block.height > row.height);
}

TEST_CASE("the colour bar shows the colour map with the highest value on top") {
  Sheet sheet;
  sheet.discs = {uniform(red), uniform(red)};
  sheet.colour_bar = ColourBar{ColourMap::viridis, 0.2, 1, "reflectance"};
  const Page page = drawn(sheet);
  const Bar bar(page);
  REQUIRE(bar.bottom - bar.top > 300);
  for (const double value : {0.01, 0.25, 0.5, 0.75, 0.99}) {
    const Rgba8 expected = map_colour(ColourMap::viridis, value);
    const Rgba8 shown = page.at(bar.inside, bar.level(value));
    CHECK(std::abs(expected.r - shown.r) + std::abs(expected.g - shown.g) + std::abs(expected.b - shown.b) <
          12);
  }
}

TEST_CASE("the numbers of the colour bar stand at their values") {
  Sheet sheet;
  sheet.discs = {uniform(red), uniform(red)};
  // Ticks at 0.3, 0.4 to 1: one at the upper end of the bar, none at the lower.
  sheet.colour_bar = ColourBar{ColourMap::viridis, 0.25, 1, "reflectance"};
  const Page page = drawn(sheet);
  const Bar bar(page);
  const auto marked = [&](double value) {
    const int y = bar.level((value - 0.25) / 0.75);
    for (int off = -2; off <= 2; ++off)
      if (page.at(bar.right + 2, y + off) != white) return true;
    return false;
  };
  for (const double value : {0.3, 0.5, 0.8, 0.9, 1.0}) {
    CAPTURE(value);
    CHECK(marked(value));
  }
  for (const double value : {0.25, 0.35, 0.75, 0.95}) {
    CAPTURE(value);
    CHECK_FALSE(marked(value));
  }
}

TEST_CASE("the angle grid marks its circles at equal-area radii and leaves the rest of the disc alone") {
  Sheet sheet;
  sheet.discs = {uniform(blue)};
  sheet.width = 600;
  const Page plain = drawn(sheet);
  CHECK(plain.find(blue).count > 200000);
  sheet.grid = AngleGrid::shown;
  const Page page = drawn(sheet);
  const Patch disc = page.find(blue);
  const double radius = (disc.right - disc.left + 1) / 2.0, x = (disc.right + disc.left + 1) / 2.0,
               y = (disc.bottom + disc.top + 1) / 2.0;
  const auto on_diagonal = [&](double theta) {  // between the rays at 0 and 45 degrees
    const double r = radius * 2 * std::sin(theta / 2) / std::numbers::sqrt2, phi = 0.4;
    int marked = 0;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        marked += page.at(static_cast<int>(x + r * std::cos(phi)) + dx,
                          static_cast<int>(y - r * std::sin(phi)) + dy) != blue;
    return marked;
  };
  constexpr double degree = std::numbers::pi / 180;
  CHECK(on_diagonal(30 * degree) > 0);
  CHECK(on_diagonal(60 * degree) > 0);
  for (const double theta : {15, 25, 35, 45, 55, 65, 80}) CHECK(on_diagonal(theta * degree) == 0);
}

TEST_CASE("titles, subtitles and footnotes add ink and make the page taller") {
  Sheet sheet;
  sheet.discs = {uniform(red)};
  sheet.width = 400;
  const Page bare = drawn(sheet);
  sheet.title = "A title";
  sheet.subtitle = {"one line", "another line"};
  sheet.footnote =
      "a footnote so long that it must be broken into several lines to fit into the width of this page";
  const Page full = drawn(sheet);
  const Patch before = bare.find(red), after = full.find(red);
  CHECK(after.count == before.count);
  CHECK(after.top > before.top + 50);
  CHECK(full.height - after.bottom > bare.height - before.bottom + 20);
  const auto inked = [&](int from, int to) {
    int count = 0;
    for (int y = from; y < to; ++y)
      for (int x = 0; x < full.width; ++x) count += full.at(x, y).r < 200;
    return count;
  };
  CHECK(inked(0, after.top - 30) > 200);
  CHECK(inked(after.bottom + 5, full.height) > 200);
  for (int y = 0; y < full.height; ++y) CHECK(full.at(full.width - 5, y) == Rgba8{255, 255, 255, 255});
}

TEST_CASE("the same sheet gives the same bytes") {
  const ScratchFolder folder;
  Sheet sheet;
  sheet.title = "title";
  sheet.discs = {quarters(50)};
  sheet.grid = AngleGrid::shown;
  for (const char* name : {"a.png", "b.png"}) {
    AtomicFile file(folder / name);
    write_sheet(file, sheet);
    file.commit();
  }
  CHECK(content(folder / "a.png") == content(folder / "b.png"));
}

TEST_CASE("sheets that cannot be drawn are refused and leave no file") {
  const ScratchFolder folder;
  Sheet sheet;
  const auto refused = [&](const char* name) {
    return error_of([&] {
      AtomicFile file(folder / name);
      write_sheet(file, sheet);
    });
  };
  CHECK(refused("a.png") == "a sheet needs at least one disc");
  sheet.discs = {{"Ag", 8, std::vector<Rgba8>(63)}};
  CHECK(refused("a.png") == "disc 'Ag' of size 8 has 63 pixels, expected 64");
  sheet.discs = {uniform(red)};
  CHECK(refused("a.jpg") == "a figure is a .png or .svg file, not '" + (folder / "a.jpg").string() + "'");
  sheet.title = "not-UTF-8:\xff";
  CHECK(refused("a.png").starts_with("a figure cannot show the text 'not"));
  CHECK(folder.names().empty());
}

TEST_CASE("a figure on a full device is reported") {
  const ScratchFolder folder;
  std::filesystem::create_symlink("/dev/full", folder / "full.png");
  AtomicFile file(folder / "full.png");
  Sheet sheet;
  sheet.discs = {uniform(red)};
  CHECK(error_of([&] {
          write_sheet(file, sheet);
          file.commit();
        }) == "cannot write '" + (folder / "full.png").string() + "': No space left on device");
}
