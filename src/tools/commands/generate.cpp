// SPDX-License-Identifier: BSD-3-Clause
#include <iostream>
#include <memory>

#include "tools/commands/bash_completion.hpp"
#include "tools/commands/commands.hpp"
#include "tools/commands/man_page.hpp"
#include "tools/commands/options.hpp"

namespace vcavity::tools {

void add_generate_command(CLI::App& program) {
  enum class Document { man, bash };
  auto document = std::make_shared<Document>();
  CLI::App* command = program.add_subcommand("generate", "a man page, or completion for bash, on stdout");
  command->group("");  // for packagers; not in the help
  add_choice(*command, "DOCUMENT", *document, {{"man", Document::man}, {"bash", Document::bash}},
             "man or bash")
      ->required();
  command->callback([document, &program] {
    std::cout << (*document == Document::man ? man_page(program) : bash_completion(program));
  });
}

}  // namespace vcavity::tools
