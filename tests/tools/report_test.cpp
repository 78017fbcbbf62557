// SPDX-License-Identifier: BSD-3-Clause
#include "tools/support/report.hpp"

#include <limits>

#include "support/catch.hpp"

namespace vcavity::tools::testing {
namespace {

Report two_rows() {
  Report report;
  report.title = "Title";
  report.head["software"] = "ours";
  report.provenance = {"ours"};
  report.notes = {"a note"};
  report.add_row()
      .add("name", "a, b")
      .add("value", 0.125, "0.1")
      .add_null("limit", "all")
      .add_to_json("more", {1, 2});
  report.add_row()
      .add("name", "c")
      .add("tilt", 5)
      .add("value", 2.0)
      .add("limit", 3)
      .add_to_tables("only here", "yes");
  return report;
}

TEST_CASE(
    "Markdown has the title, the columns in the order of their first appearance, short numbers and the "
    "notes") {
  CHECK(two_rows().to_markdown() ==
        "Title\n\n"
        "| name | tilt | value | limit | only here |\n"
        "|------|------|-------|-------|-----------|\n"
        "| a, b |      | 0.1   | all   |           |\n"
        "| c    | 5    | 2     | 3     | yes       |\n"
        "\n- a note\n");
}

TEST_CASE("CSV has the provenance, all digits, and blanks where a row has no such cell") {
  CHECK(two_rows().to_csv() ==
        "# ours\nname,tilt,value,limit,only here\n\"a, b\",,0.125,all,\nc,5,2,3,yes\n");
}

TEST_CASE("JSON has typed cells, null for what tables say in words, and members of its own") {
  const auto json = nlohmann::json::parse(two_rows().to_json());
  CHECK(json["software"] == "ours");
  REQUIRE(json["rows"].size() == 2);
  CHECK(json["rows"][0] ==
        nlohmann::json{{"name", "a, b"}, {"value", 0.125}, {"limit", nullptr}, {"more", {1, 2}}});
  CHECK(json["rows"][1] == nlohmann::json{{"name", "c"}, {"tilt", 5}, {"value", 2.0}, {"limit", 3}});
}

TEST_CASE("a report may have no rows in JSON, or call them otherwise") {
  Report report = two_rows();
  report.rows_name = "materials";
  CHECK(nlohmann::json::parse(report.in(Format::json))["materials"].size() == 2);
  report.rows_name.clear();
  CHECK(nlohmann::json::parse(report.in(Format::json)) == nlohmann::json{{"software", "ours"}});
}

TEST_CASE("a number that is not finite is null in JSON and a word in tables") {
  Report report;
  report.add_row().add("value", std::numeric_limits<double>::infinity());
  CHECK(nlohmann::json::parse(report.to_json())["rows"][0]["value"].is_null());
  CHECK(report.to_csv() == "value\ninf\n");
}

TEST_CASE("fields are cells one by one, and lists among them are enumerated in tables") {
  Report report;
  report.add_row().add_fields({{"material", "Ag"}, {"films", {1, 2}}});
  CHECK(report.to_csv() == "material,films\nAg,1; 2\n");
}

TEST_CASE("the parts of a report stand under their headings in every format") {
  Report report;
  report.begin_section("Fast", {{"unit", "m"}});
  report.add_row().add("length", 1);
  report.add_row().add("length", 2);
  report.begin_section("Slow");
  report.add_row().add("length", 3).add("note", "late");
  CHECK(report.to_markdown() ==
        "| length   | note |\n"
        "|----------|------|\n"
        "| **Fast** |      |\n"
        "| 1        |      |\n"
        "| 2        |      |\n"
        "| **Slow** |      |\n"
        "| 3        | late |\n");
  CHECK(report.to_csv() ==
        "section,length,note\n"
        "Fast,1,\n"
        "Fast,2,\n"
        "Slow,3,late\n");
  const auto json = nlohmann::ordered_json::parse(report.to_json());
  REQUIRE(json["sections"].size() == 2);
  CHECK(json["sections"][0].dump() == R"({"title":"Fast","unit":"m","rows":[{"length":1},{"length":2}]})");
  CHECK(json["sections"][1].dump() == R"({"title":"Slow","rows":[{"length":3,"note":"late"}]})");
}

}  // namespace
}  // namespace vcavity::tools::testing
