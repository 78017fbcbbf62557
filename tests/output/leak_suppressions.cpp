// SPDX-License-Identifier: BSD-3-Clause

/// Fontconfig, which cairo uses, keeps what it read about fonts until the process ends. LeakSanitizer asks
/// here.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libfontconfig\n";
}
