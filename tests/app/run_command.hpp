// Runs the built `lustro` as a user does, and catches what it says.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace lustro::testing {

struct Outcome {
  int code = -1;  ///< exit code; 128 + n after signal n
  std::string out;
  std::string err;

  [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(out); }
};

inline std::string file_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

/// A folder of its own for each test, gone when the test ends.
class CommandTest : public ::testing::Test {
 protected:
  CommandTest() {
    static std::atomic<int> count{0};
    folder = std::filesystem::temp_directory_path() / ("lustro_app_" + std::to_string(::getpid()) + "_" + std::to_string(count++));
    std::filesystem::create_directories(folder / "work");
  }
  ~CommandTest() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder, ignored);
  }

  /// Any program in the test's own folder, its stdin empty.
  Outcome run_program(std::vector<std::string> words, const std::string& stdout_to = {}) {
    const std::filesystem::path out = folder / "stdout", err = folder / "stderr";
    const std::string out_path = stdout_to.empty() ? out.string() : stdout_to;
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::posix_spawn_file_actions_addchdir_np(&actions, work().c_str());
    std::vector<char*> argv;
    for (std::string& word : words) {
      argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    Outcome outcome;
    pid_t child = 0;
    if (::posix_spawnp(&child, argv[0], &actions, nullptr, argv.data(), environ) == 0) {
      int status = 0;
      ::waitpid(child, &status, 0);
      outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    ::posix_spawn_file_actions_destroy(&actions);
    outcome.out = stdout_to.empty() ? file_text(out) : std::string();
    outcome.err = file_text(err);
    return outcome;
  }

  /// `lustro WORDS...`
  Outcome lustro(std::vector<std::string> words) {
    words.insert(words.begin(), LUSTRO_COMMAND);
    return run_program(std::move(words));
  }

  /// The folder in which the program runs.
  [[nodiscard]] std::filesystem::path work() const { return folder / "work"; }

  /// The names of all files in the work folder, hidden ones too.
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(work())) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  [[nodiscard]] bool has_program(const std::string& name) { return run_program({"sh", "-c", "command -v " + name}).code == 0; }

  std::filesystem::path folder;
};

}  // namespace lustro::testing
