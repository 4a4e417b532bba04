// A pool of forked processes on one poll(2): see worker_pool.hpp. The caller must not have made threads, since a fork copies only one of them.
#include "worker_pool.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <exception>
#include <fstream>
#include <new>
#include <optional>
#include <string_view>
#include <vector>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace lustro::app {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::uint64_t kLongestText = std::uint64_t{1} << 24;
constexpr int kOutOfMemory = 71;  // a worker's exit code

// --- in the worker -----------------------------------------------------------------------------------------------------------------

bool receive_all(int fd, void* data, std::size_t size) {
  auto* to = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t got = ::recv(fd, to, size, 0);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got <= 0) {
      return false;
    }
    to += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

bool send_all(int fd, const void* data, std::size_t size) {
  const auto* from = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t sent = ::send(fd, from, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) {
      continue;
    }
    if (sent < 0) {
      return false;
    }
    from += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

/// Bytes of private, writable memory that the process has; what RLIMIT_DATA counts.
std::uint64_t allocated_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    constexpr std::string_view kKey = "VmData:";
    if (line.starts_with(kKey)) {
      return std::strtoull(line.c_str() + kKey.size(), nullptr, 10) * 1024;
    }
  }
  return 0;
}

void limit_memory(std::uint64_t bytes) {
#if defined(__GLIBC__)
  ::malloc_trim(0);
#endif
  const rlim_t most = allocated_bytes() + bytes;
  const rlimit limit{most, most};
  ::setrlimit(RLIMIT_DATA, &limit);
}

[[noreturn]] void work(int fd, const WorkerLimits& limits, const std::function<std::string(std::size_t)>& job) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // no worker outlives the command
  if (limits.bytes > 0) {
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
    limit_memory(limits.bytes);
  }
  std::uint64_t index = 0;
  while (receive_all(fd, &index, sizeof(index))) {
    std::string text;
    try {
      text = job(index);
    } catch (const std::bad_alloc&) {
      ::_exit(kOutOfMemory);
    }
    const std::uint64_t size = text.size();
    if (!send_all(fd, &size, sizeof(size)) || !send_all(fd, text.data(), text.size())) {
      break;
    }
#if defined(__GLIBC__)
    if (limits.bytes > 0) {
      ::malloc_trim(0);  // the next model has the whole limit
    }
#endif
  }
  ::_exit(0);
}

// --- in the command ----------------------------------------------------------------------------------------------------------------

struct Worker {
  pid_t process = -1;
  int fd = -1;
  std::optional<std::size_t> job;
  Clock::time_point deadline = Clock::time_point::max();
  std::string received;
  bool killed_for_time = false;
};

std::string reason_of(int status) {
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    return fmt::format("the process that drew it was stopped by signal {} ({}){}", signal, ::strsignal(signal),
                       signal == SIGKILL ? ", as the system does when memory runs out" : "");
  }
  if (WEXITSTATUS(status) == kOutOfMemory) {
    return "needs more memory than there is, or than --memory-limit grants";
  }
  return fmt::format("the process that drew it ended with code {}", WEXITSTATUS(status));
}

class Pool {
 public:
  Pool(std::size_t count, int workers, const WorkerLimits& limits, const std::function<std::string(std::size_t)>& job,
       const std::function<void(const JobEnd&)>& ended)
      : count_(count), limits_(limits), job_(job), ended_(ended), workers_(static_cast<std::size_t>(std::max(workers, 1))) {
    workers_.resize(std::min(workers_.size(), count));
    sigemptyset(&interrupts_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
      sigaddset(&interrupts_, signal);
    }
    ::sigprocmask(SIG_BLOCK, &interrupts_, &mask_before_);
    interrupt_fd_ = ::signalfd(-1, &interrupts_, SFD_CLOEXEC);
  }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;
  ~Pool() {
    for (Worker& worker : workers_) {
      stop(worker, SIGKILL);
    }
    ::close(interrupt_fd_);
    ::sigprocmask(SIG_SETMASK, &mask_before_, nullptr);
  }

  Result<void> run() {
    while (next_ < count_ || is_busy()) {
      for (Worker& worker : workers_) {
        if (!worker.job && next_ < count_) {
          if (const Result<void> done = give(worker); !done) {
            return done;
          }
        }
      }
      wait();
    }
    for (Worker& worker : workers_) {
      stop(worker, 0);
    }
    return {};
  }

 private:
  [[nodiscard]] bool is_busy() const {
    return std::any_of(workers_.begin(), workers_.end(), [](const Worker& w) { return w.job.has_value(); });
  }

  Result<void> start(Worker& worker) {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
      return fail(ErrorKind::io, "", fmt::format("no connection to a process can be made: {}", std::strerror(errno)));
    }
    const pid_t process = ::fork();
    if (process < 0) {
      const int error = errno;
      ::close(ends[0]);
      ::close(ends[1]);
      return fail(ErrorKind::io, "", fmt::format("no process can be made: {}", std::strerror(error)));
    }
    if (process == 0) {
      ::close(ends[0]);
      for (const Worker& other : workers_) {  // else a dead worker's connection would stay open here
        if (other.fd >= 0) {
          ::close(other.fd);
        }
      }
      ::close(interrupt_fd_);
      ::sigprocmask(SIG_SETMASK, &mask_before_, nullptr);
      work(ends[1], limits_, job_);
    }
    ::close(ends[1]);
    worker = {};
    worker.process = process;
    worker.fd = ends[0];
    return {};
  }

  /// Gives the worker its next job, and a process where it has none.
  Result<void> give(Worker& worker) {
    const std::uint64_t index = next_;
    if (worker.process >= 0 && !send_all(worker.fd, &index, sizeof(index))) {
      stop(worker, SIGKILL);  // it died while it had nothing to do
    }
    if (worker.process < 0) {
      if (const Result<void> done = start(worker); !done) {
        return done;
      }
      if (!send_all(worker.fd, &index, sizeof(index))) {
        return fail(ErrorKind::io, "", "a new process is gone at once");
      }
    }
    worker.job = next_++;
    worker.killed_for_time = false;
    worker.received.clear();
    worker.deadline = limits_.seconds > 0
                          ? Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limits_.seconds))
                          : Clock::time_point::max();
    return {};
  }

  /// Ends the process: 0 lets it come to its own end, which is where its connection is closed.
  static int stop(Worker& worker, int signal) {
    int status = 0;
    if (worker.process >= 0) {
      ::close(worker.fd);
      if (signal != 0) {
        ::kill(worker.process, signal);
      }
      while (::waitpid(worker.process, &status, 0) < 0 && errno == EINTR) {
      }
      worker.process = -1;
      worker.fd = -1;
    }
    return status;
  }

  /// Until a worker says something, dies, or has had its time.
  void wait() {
    std::vector<pollfd> polled{{interrupt_fd_, POLLIN, 0}};
    Clock::time_point deadline = Clock::time_point::max();
    for (const Worker& worker : workers_) {
      polled.push_back({worker.job ? worker.fd : -1, POLLIN, 0});
      if (worker.job) {
        deadline = std::min(deadline, worker.deadline);
      }
    }
    int patience = -1;
    if (deadline != Clock::time_point::max()) {
      const double left = std::chrono::duration<double, std::milli>(deadline - Clock::now()).count();
      patience = static_cast<int>(std::clamp(std::ceil(left), 0.0, 1e9));
    }
    if (::poll(polled.data(), polled.size(), patience) < 0 && errno != EINTR) {
      return;
    }
    if ((polled[0].revents & POLLIN) != 0) {
      give_up();
    }
    for (std::size_t i = 0; i < workers_.size(); ++i) {
      Worker& worker = workers_[i];
      if (worker.job && polled[i + 1].revents != 0) {
        listen(worker);
      }
      if (worker.job && Clock::now() >= worker.deadline) {
        worker.killed_for_time = true;
        bury(worker, SIGKILL);
      }
    }
  }

  /// Takes what the worker has sent; the job has ended when that is a whole result, or when there is no more to come.
  void listen(Worker& worker) {
    std::array<char, 65536> buffer{};
    const ssize_t got = ::recv(worker.fd, buffer.data(), buffer.size(), MSG_DONTWAIT);
    if (got < 0 && (errno == EINTR || errno == EAGAIN)) {
      return;
    }
    if (got <= 0) {
      bury(worker, SIGKILL);  // it is dead already, or says nothing any more
      return;
    }
    worker.received.append(buffer.data(), static_cast<std::size_t>(got));
    std::uint64_t size = 0;
    if (worker.received.size() < sizeof(size)) {
      return;
    }
    std::memcpy(&size, worker.received.data(), sizeof(size));
    if (size > kLongestText) {  // a process whose memory a file has overwritten may say anything
      bury(worker, SIGKILL);
    } else if (worker.received.size() >= sizeof(size) + size) {
      report(worker, true, worker.received.substr(sizeof(size), size), worker.process);
    }
  }

  /// Ends a worker that has not come to a result.
  void bury(Worker& worker, int signal) {
    const pid_t process = worker.process;
    const int status = stop(worker, signal);
    report(worker, false, worker.killed_for_time ? fmt::format("took more than {} s", limits_.seconds) : reason_of(status), process);
  }

  void report(Worker& worker, bool has_result, std::string text, pid_t process) {
    const std::size_t job = *worker.job;
    worker.job.reset();
    ended_({.job = job, .has_result = has_result, .text = std::move(text), .timed_out = worker.killed_for_time, .process = process});
  }

  /// An interrupt: the processes end, their jobs are reported so that nothing of theirs is left lying, and then it takes its course.
  [[noreturn]] void give_up() {
    signalfd_siginfo info{};
    const bool is_known = ::read(interrupt_fd_, &info, sizeof(info)) == static_cast<ssize_t>(sizeof(info));
    const int signal = is_known ? static_cast<int>(info.ssi_signo) : SIGTERM;
    for (Worker& worker : workers_) {
      if (worker.job) {
        const pid_t process = worker.process;
        stop(worker, SIGKILL);
        report(worker, false, "was interrupted", process);
      } else {
        stop(worker, SIGKILL);
      }
    }
    ::signal(signal, SIG_DFL);
    ::sigprocmask(SIG_SETMASK, &mask_before_, nullptr);
    ::raise(signal);
    ::_exit(128 + signal);
  }

  std::size_t count_;
  std::size_t next_ = 0;
  WorkerLimits limits_;
  const std::function<std::string(std::size_t)>& job_;
  const std::function<void(const JobEnd&)>& ended_;
  std::vector<Worker> workers_;
  sigset_t interrupts_{}, mask_before_{};
  int interrupt_fd_ = -1;
};

}  // namespace

Result<void> run_in_workers(std::size_t count, int workers, const WorkerLimits& limits, const std::function<std::string(std::size_t)>& job,
                            const std::function<void(const JobEnd&)>& ended) {
  return count == 0 ? Result<void>{} : Pool(count, workers, limits, job, ended).run();
}

}  // namespace lustro::app
