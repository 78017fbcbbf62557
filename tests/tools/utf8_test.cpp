// SPDX-License-Identifier: BSD-3-Clause
#include "tools/support/utf8.hpp"

#include <string>

#include "support/catch.hpp"

namespace vcavity::tools::testing {
namespace {

TEST_CASE("UTF-8 is kept as it is") {
  for (const std::string text : {"", "plain", "\u00fc\u212b", "\U0001F600", "\uFFFD", "\uD7FF\uE000"}) {
    CAPTURE(text);
    CHECK_FALSE(first_not_utf8(text));
    CHECK(valid_utf8(text) == text);
  }
}

TEST_CASE("what is not UTF-8 is found where it begins and replaced byte by byte") {
  struct Broken {
    std::string text;
    std::size_t place;
    std::string valid;
  };
  const std::string mark = "\uFFFD";
  for (const auto& [text, place, valid] :
       {Broken{"M\xfcller", 1, "M" + mark + "ller"}, Broken{"ab\xc3", 2, "ab" + mark},
        Broken{"\xc0\x80", 0, mark + mark},                        // longer than need be
        Broken{"\xed\xa0\x80", 0, mark + mark + mark},             // half of a surrogate pair
        Broken{"\xf4\x90\x80\x80", 0, mark + mark + mark + mark},  // beyond U+10FFFF
        Broken{"\xe2\x84x", 0, mark + mark + "x"}, Broken{"\x80", 0, mark}}) {
    CHECK(first_not_utf8(text) == place);
    CHECK(valid_utf8(text) == valid);
  }
}

TEST_CASE("every byte of Latin-1 is a character") {
  CHECK(utf8_of_latin1("M\xfcller \xb5m") == "M\u00fcller \u00b5m");
}

}  // namespace
}  // namespace vcavity::tools::testing
