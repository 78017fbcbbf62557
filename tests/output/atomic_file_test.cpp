// SPDX-License-Identifier: BSD-3-Clause
#include "tools/images/atomic_file.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>

#include "scratch_folder.hpp"
#include "small_disk.hpp"
#include "support/catch.hpp"

using namespace vcavity::tools;
using Names = std::vector<std::string>;

namespace {

mode_t mode_of(const std::filesystem::path& path) {
  struct stat status{};
  REQUIRE(::stat(path.c_str(), &status) == 0);
  return status.st_mode & 07777;
}

const std::vector<int> ending_signals{SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXFSZ};

// The helper program, stopped half way through writing a file.
class InterruptedWriter {
 public:
  enum class Hangup { ends_it, is_ignored };

  explicit InterruptedWriter(const std::filesystem::path& target, Hangup hangup = Hangup::ends_it) {
    std::array<int, 2> pipe{};
    REQUIRE(::pipe(pipe.data()) == 0);
    process_ = ::fork();
    if (process_ == 0) {
      for (const int signal : ending_signals) ::signal(signal, SIG_DFL);  // background jobs ignore some
      if (hangup == Hangup::is_ignored) ::signal(SIGHUP, SIG_IGN);
      ::dup2(pipe[1], STDOUT_FILENO);
      ::close(pipe[0]);
      ::close(pipe[1]);
      ::execl(INTERRUPTED_WRITER, INTERRUPTED_WRITER, target.c_str(), nullptr);
      ::_exit(127);
    }
    ::close(pipe[1]);
    char first = 0;
    const ssize_t count = ::read(pipe[0], &first, 1);  // waits until it says "half done"
    ::close(pipe[0]);
    REQUIRE(count == 1);
  }

  void send(int signal) const { ::kill(process_, signal); }

  // The signal that ended the process, 0 if it ended otherwise.
  int end() const {
    int status = 0;
    ::waitpid(process_, &status, 0);
    return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  }

 private:
  pid_t process_;
};

// Files longer than `size` cannot be written, as on a full disk.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t size) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    previous_ = ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{size, before_.rlim_max};
    REQUIRE(::setrlimit(RLIMIT_FSIZE, &limit) == 0);
  }
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, previous_);
  }

 private:
  rlimit before_{};
  void (*previous_)(int);
};

// Lays down an administrator's privileges for a while, since they include writing everywhere.
class OrdinaryUser {
 public:
  OrdinaryUser() {
    if (::geteuid() == 0) REQUIRE(::seteuid(65534) == 0);
  }
  ~OrdinaryUser() {
    if (::getuid() == 0 && ::seteuid(0) != 0) std::abort();
  }
};

}  // namespace

TEST_CASE("a committed file has the text that was written and leaves nothing beside it") {
  const ScratchFolder folder;
  write_text(folder / "a.csv", "1,2,3\n");
  CHECK(content(folder / "a.csv") == "1,2,3\n");
  CHECK(folder.names() == Names{"a.csv"});
}

TEST_CASE("an earlier file is untouched until the commit") {
  const ScratchFolder folder;
  put(folder / "a.csv", "earlier");
  AtomicFile file(folder / "a.csv");
  file.write("later");
  CHECK(content(folder / "a.csv") == "earlier");
  CHECK(content(file.temporary()) == "later");
  CHECK(file.temporary().parent_path() == folder.path());
  file.commit();
  CHECK(content(folder / "a.csv") == "later");
}

TEST_CASE("a file that is not committed leaves no trace") {
  const ScratchFolder folder;
  {
    AtomicFile(folder / "a.csv").write("half");
  }
  CHECK(folder.names().empty());
}

TEST_CASE("bytes can be rewritten after seeking back") {
  const ScratchFolder folder;
  AtomicFile file(folder / "a");
  file.write("????5678");
  file.seek(0);
  file.write("1234");
  CHECK(file.position() == 4);
  file.commit();
  CHECK(content(folder / "a") == "12345678");
}

TEST_CASE("signals that end the process remove the temporary and keep the earlier file") {
  const int signal = GENERATE(from_range(ending_signals));
  CAPTURE(signal);
  const ScratchFolder folder;
  put(folder / "a.csv", "earlier");
  const InterruptedWriter writer(folder / "a.csv");
  CHECK(folder.names().size() == 2);
  writer.send(signal);
  CHECK(writer.end() == signal);
  CHECK(folder.names() == Names{"a.csv"});
  CHECK(content(folder / "a.csv") == "earlier");
}

TEST_CASE("a killed process leaves the earlier file whole and the next run is not disturbed") {
  const ScratchFolder folder;
  put(folder / "a.csv", "earlier");
  const InterruptedWriter writer(folder / "a.csv");
  writer.send(SIGKILL);
  CHECK(writer.end() == SIGKILL);
  CHECK(content(folder / "a.csv") == "earlier");
  write_text(folder / "a.csv", "later");
  CHECK(content(folder / "a.csv") == "later");
}

TEST_CASE("what a killed process left behind goes with the next run in the folder, and nothing else does") {
  const ScratchFolder folder;
  {
    const InterruptedWriter writer(folder / "a.csv");
    writer.send(SIGKILL);
    CHECK(writer.end() == SIGKILL);
  }
  REQUIRE(folder.names().size() == 1);
  const std::filesystem::path left_behind = folder / folder.names().front();
  const InterruptedWriter at_work(folder / "b.csv");
  const std::string ours = ".vcavity-" + std::to_string(::getpid()) + "-1000000.tmp";
  for (const std::string& name :
       {ours, std::string(".vcavity-notes.tmp"), std::string(".vcavity-7"), std::string("x.tmp")})
    put(folder / name, "");
  CHECK_FALSE(std::filesystem::exists(left_behind));
  CHECK(folder.names().size() == 5);
  write_text(folder / "c.csv", "text");
  CHECK(folder.names().size() == 6);  // the temporary of the process at work is still there
  at_work.send(SIGTERM);
  CHECK(at_work.end() == SIGTERM);
}

TEST_CASE("a signal that the parent process chose to ignore stays ignored") {
  const ScratchFolder folder;
  const InterruptedWriter writer(folder / "a.csv", InterruptedWriter::Hangup::is_ignored);
  writer.send(SIGHUP);
  writer.send(SIGTERM);
  CHECK(writer.end() == SIGTERM);
  CHECK(folder.names().empty());
}

TEST_CASE("a write that fails half way is reported, also at the commit, and keeps the earlier file") {
  const ScratchFolder folder;
  put(folder / "a.csv", "earlier");
  {
    AtomicFile file(folder / "a.csv");
    const FileSizeLimit limit(4096);
    const std::string expected = "cannot write '" + (folder / "a.csv").string() + "': File too large";
    CHECK(error_of([&] { file.write(std::string(10000, 'x')); }) == expected);
    CHECK(error_of([&] { file.commit(); }) == expected);
  }
  CHECK(folder.names() == Names{"a.csv"});
  CHECK(content(folder / "a.csv") == "earlier");
}

TEST_CASE("a full disk is reported and keeps the earlier file") {
  const SmallDisk disk;
  if (!disk.mounted()) {
    WARN("not permitted to mount a small disk, test skipped");
    return;
  }
  const auto target = disk.folder() / "a.csv";
  put(target, "earlier");
  CHECK(error_of([&] { write_text(target, std::string(100000, 'x')); }) ==
        "cannot write '" + target.string() + "': No space left on device");
  CHECK(disk.folder().names() == Names{"a.csv"});
  CHECK(content(target) == "earlier");
}

TEST_CASE("targets that cannot be written are refused before the work begins") {
  const ScratchFolder folder;
  put(folder / "file", "");
  const auto refusal = [](const std::filesystem::path& target) {
    return error_of([&] { AtomicFile file(target); });
  };
  const auto text = [](const std::filesystem::path& target, const std::string& reason) {
    return "cannot write '" + target.string() + "': " + reason;
  };
  CHECK(refusal("") == text("", "No such file or directory"));
  CHECK(refusal(folder / "missing/a.csv") == text(folder / "missing/a.csv", "No such file or directory"));
  CHECK(refusal(folder / "file/a.csv") == text(folder / "file/a.csv", "Not a directory"));
  CHECK(refusal(folder.path()) == text(folder.path(), "Is a directory"));
  CHECK(refusal(folder / "missing/") == text(folder / "missing/", "Is a directory"));
  CHECK(refusal(folder / std::string(300, 'x')) ==
        text(folder / std::string(300, 'x'), "File name too long"));
  CHECK(folder.names() == Names{"file"});
}

TEST_CASE("a read-only folder and a read-only file are refused before the work begins") {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "closed");
  put(folder / "file", "earlier");
  std::filesystem::permissions(folder / "closed", std::filesystem::perms(0555));
  std::filesystem::permissions(folder / "file", std::filesystem::perms(0444));
  std::filesystem::permissions(folder.path(), std::filesystem::perms(0777));
  const OrdinaryUser user;
  for (const char* name : {"closed/a.csv", "file"})
    CHECK(error_of([&] { AtomicFile file(folder / name); }) ==
          "cannot write '" + (folder / name).string() + "': Permission denied");
}

TEST_CASE("a name of the greatest length is accepted") {
  const ScratchFolder folder;
  const std::string name(255, 'x');
  write_text(folder / name, "text");
  CHECK(content(folder / name) == "text");
}

TEST_CASE("a new file gets the permissions of the umask and an existing one keeps its own") {
  const ScratchFolder folder;
  const mode_t before = ::umask(027);
  write_text(folder / "new", "");
  ::umask(before);
  CHECK(mode_of(folder / "new") == 0640);

  put(folder / "old", "");
  std::filesystem::permissions(folder / "old", std::filesystem::perms(0604));
  write_text(folder / "old", "text");
  CHECK(mode_of(folder / "old") == 0604);
}

TEST_CASE("a symbolic link stays and the file behind it is replaced, even if it does not exist yet") {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "results");
  std::filesystem::create_symlink("results/a.csv", folder / "link");
  for (const char* text : {"first", "second"}) {
    write_text(folder / "link", text);
    CHECK(std::filesystem::is_symlink(folder / "link"));
    CHECK(content(folder / "results/a.csv") == text);
  }
}

TEST_CASE("a link that leads to itself is refused") {
  const ScratchFolder folder;
  std::filesystem::create_symlink("loop", folder / "loop");
  CHECK(error_of([&] { AtomicFile file(folder / "loop"); }) ==
        "cannot write '" + (folder / "loop").string() + "': Too many levels of symbolic links");
}

TEST_CASE("a device without space reports it") {
  CHECK(error_of([] { write_text("/dev/full", "text"); }) ==
        "cannot write '/dev/full': No space left on device");
}

TEST_CASE("a device is written to and not replaced") {
  write_text("/dev/null", "text");
  CHECK(std::filesystem::is_character_file("/dev/null"));
}

TEST_CASE("a named pipe receives the file when it is complete") {
  const ScratchFolder folder;
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  const int reader = ::open((folder / "pipe").c_str(), O_RDONLY | O_NONBLOCK);
  AtomicFile file(folder / "pipe");
  file.write("all of it");
  std::array<char, 64> buffer{};
  CHECK(::read(reader, buffer.data(), buffer.size()) < 0);
  file.commit();
  CHECK(::read(reader, buffer.data(), buffer.size()) == 9);
  CHECK(std::string(buffer.data()) == "all of it");
  ::close(reader);
  CHECK_FALSE(std::filesystem::exists(file.temporary()));
}

TEST_CASE("an open descriptor such as /dev/stdout is appended to and not replaced") {
  const ScratchFolder folder;
  put(folder / "log", "earlier, ");
  const int descriptor = ::open((folder / "log").c_str(), O_WRONLY);
  write_text("/dev/fd/" + std::to_string(descriptor), "later");
  ::close(descriptor);
  CHECK(content(folder / "log") == "earlier, later");
  CHECK(folder.names() == Names{"log"});
}
