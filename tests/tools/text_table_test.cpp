// SPDX-License-Identifier: BSD-3-Clause
#include "tools/support/text_table.hpp"

#include "support/catch.hpp"

using namespace vcavity::tools;

TEST_CASE("cells of CSV with commas, quotes and line ends are quoted as RFC 4180 wants it") {
  const TextTable table{{"name", "n"},
                        {{"plain", "1"}, {"a, b", "2"}, {"5\" disc", "3"}, {"two\nlines", "4"}}};
  CHECK(to_csv(table, {"made, \"here\""}) ==
        "# made, \"here\"\nname,n\nplain,1\n\"a, b\",2\n\"5\"\" disc\",3\n\"two\nlines\",4\n");
}
