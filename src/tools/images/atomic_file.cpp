// SPDX-License-Identifier: BSD-3-Clause
#include "tools/images/atomic_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <mutex>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace vcavity::tools {
namespace fs = std::filesystem;
namespace {

// Follows the symbolic links at the end of `path`, dangling ones too. Stops inside /proc, whose links stand
// for open descriptors (/dev/stdout): those are to be written to and not to be replaced.
fs::path behind_links(fs::path path) {
  constexpr int most_links = 40;  // as in the Linux kernel
  std::error_code ignored;
  for (int i = 0; i < most_links && fs::is_symlink(fs::symlink_status(path, ignored)); ++i) {
    const fs::path folder = fs::canonical(fs::absolute(path).parent_path(), ignored);
    if (folder.native().starts_with("/proc/")) break;
    path = folder / fs::read_symlink(path, ignored);
  }
  return path;
}

fs::path next_temporary(const fs::path& folder) {
  static std::atomic<unsigned> count{0};
  return folder / (".vcavity-" + std::to_string(::getpid()) + "-" + std::to_string(count++) + ".tmp");
}

/// The process that a temporary belongs to; nothing for other files.
std::optional<pid_t> owner_of(const fs::path& file) {
  const std::string name = file.filename().string();
  constexpr std::string_view prefix = ".vcavity-";
  if (!name.starts_with(prefix) || !name.ends_with(".tmp")) return std::nullopt;
  pid_t owner = 0;
  const char* const digits = name.data() + prefix.size();
  const auto [end, error] = std::from_chars(digits, name.data() + name.size(), owner);
  if (error != std::errc() || end == digits || *end != '-' || owner <= 0) return std::nullopt;
  return owner;
}

// Removes temporaries of processes that were killed, once for every folder. Both signs must say so: there is no process
// of that number here, and nobody, perhaps on another machine, holds the lock of the file.
void remove_leftovers(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<fs::path> seen;
  const std::lock_guard guard(mutex);
  if (!seen.insert(folder).second) return;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::optional<pid_t> owner = owner_of(entry.path());
    if (!owner || ::kill(*owner, 0) == 0 || errno != ESRCH) continue;
    const int descriptor = ::open(entry.path().c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
    if (descriptor < 0) continue;
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) ::unlink(entry.path().c_str());
    ::close(descriptor);
  }
}

// Writes everything or returns errno.
int write_all(int descriptor, const void* data, std::size_t size) {
  const char* next = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = ::write(descriptor, next, size);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    next += written;
    size -= static_cast<std::size_t>(written);
  }
  return 0;
}

}  // namespace

// Once the delegated constructor is done the destructor runs even if open() throws.
AtomicFile::AtomicFile(fs::path target) : AtomicFile(std::move(target), Unopened{}) {
  open();
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
    ::unlink(temporary_.c_str());
  }
  if (special_ >= 0) ::close(special_);
}

void AtomicFile::open() {
  if (target_.empty()) fail(ENOENT);
  file_ = behind_links(fs::absolute(target_));
  if (!file_.has_filename()) fail(EISDIR);

  struct stat existing{};
  const bool exists = ::lstat(file_.c_str(), &existing) == 0;
  if (!exists && errno != ENOENT) fail(errno);
  if (exists && S_ISDIR(existing.st_mode)) fail(EISDIR);
  if (exists && ::faccessat(AT_FDCWD, file_.c_str(), W_OK, AT_EACCESS) != 0) fail(errno);

  const bool special = exists && !S_ISREG(existing.st_mode);  // a link only within /proc
  if (special && (special_ = ::open(file_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC)) < 0) fail(errno);

  std::error_code error;
  const fs::path folder = special ? fs::temp_directory_path(error) : file_.parent_path();
  if (error) fail(error.value());
  remove_leftovers(folder);
  do {  // a killed process with our number may have left its file
    temporary_ = next_temporary(folder);
    on_signal_.emplace(temporary_);  // before the file exists, or a signal in between would leave it behind
    descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (descriptor_ < 0 && errno == EEXIST);
  if (descriptor_ < 0) fail(errno);
  ::flock(descriptor_,
          LOCK_EX | LOCK_NB);  // for remove_leftovers() of other runs; where there are no locks it is theirs
  if (exists && !special && ::fchmod(descriptor_, existing.st_mode & 07777) != 0) fail(errno);
}

void AtomicFile::write(const void* data, std::size_t size) {
  check();
  if (const int error = write_all(descriptor_, data, size)) fail(error);
  position_ += size;
}

void AtomicFile::seek(std::uint64_t position) {
  check();
  if (::lseek(descriptor_, static_cast<off_t>(position), SEEK_SET) < 0) fail(errno);
  position_ = position;
}

void AtomicFile::check() const {
  if (error_ != 0)
    throw std::runtime_error("cannot write '" + target_.string() +
                             "': " + std::generic_category().message(error_));
}

void AtomicFile::commit() {
  check();
  if (special_ >= 0) {
    deliver_copy();
    if (::unlink(temporary_.c_str()) != 0) fail(errno);
  } else {
    if (::fsync(descriptor_) != 0) fail(errno);
    if (::rename(temporary_.c_str(), file_.c_str()) != 0) fail(errno);
  }
  ::close(std::exchange(descriptor_, -1));
}

void AtomicFile::deliver_copy() {
  seek(0);
  std::array<char, 1 << 16> block;
  for (;;) {
    const ssize_t count = ::read(descriptor_, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(errno);
    if (count == 0) break;
    if (const int error = write_all(special_, block.data(), static_cast<std::size_t>(count))) fail(error);
  }
  if (::close(std::exchange(special_, -1)) != 0) fail(errno);
}

void AtomicFile::fail(int error) {
  error_ = error;
  check();
  throw std::logic_error("AtomicFile::fail needs an error number");
}

void write_text(const fs::path& path, std::string_view text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace vcavity::tools
