// SPDX-License-Identifier: BSD-3-Clause
#include "tools/images/plot.hpp"

#include <cmath>

#include "page.hpp"
#include "scratch_folder.hpp"

using namespace vcavity::tools;

namespace {

constexpr Rgba8 first_colour{0, 114, 178, 255}, second_colour{213, 94, 0, 255};

Page drawn(const Plot& plot) {
  const ScratchFolder folder;
  AtomicFile file(folder / "a.png");
  write_plot(file, plot);
  file.commit();
  return Page(folder / "a.png");
}

// Centres of the runs of columns that hold the colour.
std::vector<double> columns_with(const Page& page, Rgba8 colour) {
  std::vector<double> centres;
  int begin = -1;
  for (int x = 0; x <= page.width; ++x) {
    bool present = false;
    for (int y = 0; x < page.width && y < page.height; ++y) present = present || page.at(x, y) == colour;
    if (present && begin < 0) begin = x;
    if (!present && begin >= 0) {
      centres.push_back((begin + x - 1) / 2.0);
      begin = -1;
    }
  }
  return centres;
}

Series points(std::vector<double> x, std::vector<double> y) {
  return {"", x, y, Series::Look::markers};
}

}  // namespace

TEST_CASE("points stand at their values on a linear axis") {
  Plot plot;
  plot.series = {points({1, 2, 5}, {1, 1, 1})};
  const auto x = columns_with(drawn(plot), first_colour);
  REQUIRE(x.size() == 3);
  CHECK((x[2] - x[1]) / (x[1] - x[0]) == Catch::Approx(3).margin(0.05));
}

TEST_CASE("equal ratios are equal distances on a logarithmic axis") {
  Plot plot;
  plot.x.scale = Axis::Scale::logarithmic;
  plot.series = {points({1e-6, 1e-3, 1}, {1, 1, 1})};
  const auto x = columns_with(drawn(plot), first_colour);
  REQUIRE(x.size() == 3);
  CHECK((x[2] - x[1]) / (x[1] - x[0]) == Catch::Approx(1).margin(0.02));
}

TEST_CASE("larger values stand higher") {
  Plot plot;
  plot.series = {points({1, 2}, {1, 1}), points({1, 2}, {3, 3})};
  const Page page = drawn(plot);
  CHECK(page.find(second_colour).bottom < page.find(first_colour).top);
}

TEST_CASE("points that an axis cannot show interrupt the line") {
  const double gap = GENERATE(NAN, INFINITY, 0.0, -1.0);
  CAPTURE(gap);
  Plot plot;
  plot.y.scale = Axis::Scale::logarithmic;
  plot.series = {{"", {1, 2, 3, 4, 5}, {1, 1, gap, 1, 1}, Series::Look::line}};
  CHECK(columns_with(drawn(plot), first_colour).size() == 2);
  plot.series[0].y[2] = 1;
  CHECK(columns_with(drawn(plot), first_colour).size() == 1);
}

TEST_CASE("lines end at the frame where a range is given") {
  Plot plot;
  plot.series = {{"", {0, 10}, {0, 0}, Series::Look::line}};
  plot.x.range = {2, 4};
  const Patch line = drawn(plot).find(first_colour);
  CHECK(line.left > 20);
  CHECK(line.right < 800 - 19);
  CHECK(line.right - line.left > 700);
}

TEST_CASE("only series with a name are in the legend, which narrows the frame") {
  Plot plot;
  plot.series = {points({0, 1}, {0, 1}), points({0, 1}, {1, 0})};
  const Page without = drawn(plot);
  plot.series[1].name = "Monte Carlo";
  const Page with = drawn(plot);
  CHECK(columns_with(with, first_colour).size() == 2);
  CHECK(columns_with(with, second_colour).size() == 3);
  CHECK(with.find(first_colour).right < without.find(first_colour).right - 80);
}

TEST_CASE("a plot without points is an empty frame") {
  Plot plot;
  plot.x.scale = Axis::Scale::logarithmic;
  CHECK(drawn(plot).find(first_colour).count == 0);
}

TEST_CASE("an SVG plot is an SVG file and the same PNG plot gives the same bytes") {
  const ScratchFolder folder;
  Plot plot;
  plot.title = "Title";
  plot.series = {points({1, 2, 3}, {1, 4, 9})};
  for (const char* name : {"a.svg", "a.png", "b.png"}) {
    AtomicFile file(folder / name);
    write_plot(file, plot);
    file.commit();
  }
  const std::string svg = content(folder / "a.svg");
  CHECK(svg.starts_with("<?xml"));
  CHECK(svg.find("width=\"800px\" height=\"500px\"") != std::string::npos);
  CHECK(svg.find("</svg>") != std::string::npos);
  CHECK(content(folder / "a.png") == content(folder / "b.png"));
}

TEST_CASE("series of unequal lengths and impossible ranges are refused") {
  const ScratchFolder folder;
  AtomicFile file(folder / "a.png");
  Plot plot;
  plot.series = {{"Ag", {1, 2}, {1}, {}}};
  CHECK(error_of([&] { write_plot(file, plot); }) == "series 'Ag' has 2 x and 1 y");
  plot.series.clear();
  plot.x.range = {1, 1};
  CHECK_THROWS_AS(write_plot(file, plot), std::invalid_argument);
  plot.x.range = {-1, 1};
  plot.x.scale = Axis::Scale::logarithmic;
  CHECK_THROWS_AS(write_plot(file, plot), std::invalid_argument);
}

TEST_CASE("plots below each other share the page and their frames are aligned") {
  Plot upper, lower;
  upper.height = lower.height = 300;
  upper.series = {points({1, 2, 5}, {1, 1, 1})};
  lower.series = {points({1, 2, 5}, {123456, 234567, 345678})};  // wider numbers at the axis
  const ScratchFolder folder;
  AtomicFile file(folder / "a.png");
  write_plots(file, {upper, lower});
  file.commit();
  const Page page(folder / "a.png");
  CHECK(page.height == 600);
  CHECK(columns_with(page, first_colour).size() == 3);  // the markers of both stand below each other
}

TEST_CASE("a page without plots is refused") {
  const ScratchFolder folder;
  AtomicFile file(folder / "a.png");
  CHECK(error_of([&] { write_plots(file, {}); }) == "a page needs at least one plot");
}
