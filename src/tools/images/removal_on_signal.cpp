// SPDX-License-Identifier: BSD-3-Clause
#include "tools/images/removal_on_signal.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstring>

namespace vcavity::tools {
namespace {

// The handler may only read plain memory and call unlink(), hence an array of fixed size.
struct Slot {
  enum State { free, claimed, in_use };
  std::atomic<State> state{free};
  std::array<char, PATH_MAX> path{};
};
static_assert(std::atomic<Slot::State>::is_always_lock_free);
std::array<Slot, 64> slots;

extern "C" void remove_temporaries(int signal) {
  for (const Slot& slot : slots)
    if (slot.state.load() == Slot::in_use) ::unlink(slot.path.data());
  ::raise(signal);  // SA_RESETHAND restored the default action, which ends the process as the sender expects
}

void install_signal_handlers() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXFSZ}) {
    struct sigaction current{};
    if (::sigaction(signal, nullptr, &current) != 0 || current.sa_handler != SIG_DFL) continue;  // e.g. nohup
    struct sigaction ours{};
    ours.sa_handler = remove_temporaries;
    ours.sa_flags = static_cast<int>(SA_RESETHAND);
    ::sigfillset(&ours.sa_mask);
    ::sigaction(signal, &ours, nullptr);
  }
}

}  // namespace

RemovalOnSignal::RemovalOnSignal(const std::filesystem::path& path) {
  static const bool installed = (install_signal_handlers(), true);
  static_cast<void>(installed);
  const std::string& name = path.native();
  if (name.size() >= PATH_MAX) return;
  for (std::size_t i = 0; i < slots.size(); ++i) {
    auto expected = Slot::free;
    if (!slots[i].state.compare_exchange_strong(expected, Slot::claimed)) continue;
    std::memcpy(slots[i].path.data(), name.c_str(), name.size() + 1);
    slots[i].state = Slot::in_use;
    slot_ = static_cast<int>(i);
    return;
  }
}

RemovalOnSignal::~RemovalOnSignal() {
  if (slot_ >= 0) slots[static_cast<std::size_t>(slot_)].state = Slot::free;
}

}  // namespace vcavity::tools
