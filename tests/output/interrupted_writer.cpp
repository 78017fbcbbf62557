// SPDX-License-Identifier: BSD-3-Clause

/// Writes half of the file named on the command line, says so on stdout, and waits for the signal that ends
/// it.

#include <unistd.h>

#include <cstdio>

#include "tools/images/atomic_file.hpp"

int main(int, char** arguments) {
  vcavity::tools::AtomicFile file(arguments[1]);
  file.write("the first half");
  std::puts("half done");
  std::fflush(stdout);
  ::alarm(30);
  for (;;) ::pause();
}
