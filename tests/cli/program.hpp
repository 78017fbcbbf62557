// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Runs vcavity_maps the way a shell does.

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "output/scratch_folder.hpp"

/// The words of a command line; between single quotes blanks belong to a word.
inline std::vector<std::string> words(const std::string& line) {
  std::vector<std::string> result;
  bool in_word = false, quoted = false;
  for (const char letter : line) {
    if (!quoted && (letter == ' ' || letter == '\n')) {
      in_word = false;
      continue;
    }
    if (!in_word) result.emplace_back();
    in_word = true;
    if (letter == '\'')
      quoted = !quoted;
    else
      result.back() += letter;
  }
  return result;
}

/// The lines of a text, without their ends.
inline std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The program at work, with what it prints going to files.
class RunningProgram {
 public:
  /// \param folder      where the program runs, so that file names need no path
  /// \param out         the file that takes the standard output
  RunningProgram(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                 const std::filesystem::path& out, const std::filesystem::path& err) {
    std::vector<char*> argv{const_cast<char*>(VCAVITY_MAPS)};
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    process_ = ::fork();
    if (process_ != 0) return;
    for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) ::signal(signal, SIG_DFL);  // may be ignored here
    const int out_file = ::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int err_file = ::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (out_file < 0 || err_file < 0 || ::chdir(folder.c_str()) != 0) ::_exit(126);
    ::dup2(out_file, STDOUT_FILENO);
    ::dup2(err_file, STDERR_FILENO);
    ::execv(argv.front(), argv.data());
    ::_exit(127);
  }

  void send(int signal) const { ::kill(process_, signal); }

  bool ended() {
    if (!ended_ && ::waitpid(process_, &status_, WNOHANG) == process_) ended_ = true;
    return ended_;
  }

  /// Waits for the end. The exit status, or 128 + signal as in a shell.
  int status() {
    if (!ended_) ::waitpid(process_, &status_, 0);
    ended_ = true;
    return WIFSIGNALED(status_) ? 128 + WTERMSIG(status_) : WEXITSTATUS(status_);
  }

 private:
  pid_t process_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

/// What a run of the program gave.
struct Outcome {
  int status;
  std::string out;
  std::string err;
};

/// Runs the program in `folder` and waits for it.
inline Outcome run(const std::vector<std::string>& arguments, const std::filesystem::path& folder) {
  const ScratchFolder streams;
  RunningProgram program(arguments, folder, streams / "out", streams / "err");
  const int status = program.status();
  return {status, content(streams / "out"), content(streams / "err")};
}

inline Outcome run(const std::string& line, const std::filesystem::path& folder) {
  return run(words(line), folder);
}

/// Runs the program where it finds no files.
inline Outcome run(const std::string& line) {
  const ScratchFolder folder;
  return run(line, folder.path());
}
