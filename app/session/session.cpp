// SPDX-License-Identifier: BSD-3-Clause
#include "app/session/session.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <mutex>
#include <new>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>
#include <thread>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace angiomesh::cli {
namespace {

const Progress* signalled = nullptr;

/// Where our own messages go. Libraries write theirs to the standard error stream.
std::FILE* messages = stderr;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kMuteLibraries = false;  // the sanitizers report there too
#else
constexpr bool kMuteLibraries = true;
#endif

/// Sends what libraries print on stderr nowhere: a failure is to be one line, ours.
void muteLibraries() {
  if (!kMuteLibraries) return;
  const int own = dup(STDERR_FILENO);
  std::FILE* stream = own >= 0 ? fdopen(own, "w") : nullptr;
  const int nowhere = open("/dev/null", O_WRONLY);
  if (stream != nullptr && nowhere >= 0) {
    dup2(nowhere, STDERR_FILENO);
    messages = stream;
  }
  if (nowhere >= 0) close(nowhere);
}

extern "C" void onSignal(int) { signalled->cancel(); }

/// Shows a job's progress on stderr from a thread of its own until it is destroyed.
class ProgressPrinter {
 public:
  ProgressPrinter(const Progress& progress, const std::string& mode) : progress_(progress) {
    json_ = mode == "json";
    if (json_ || (mode == "auto" && isatty(fileno(messages)) == 1))
      thread_ = std::thread([this] { run(); });
  }
  ProgressPrinter(const ProgressPrinter&) = delete;
  ProgressPrinter& operator=(const ProgressPrinter&) = delete;

  ~ProgressPrinter() {
    {
      const std::lock_guard lock(mutex_);
      ended_ = true;
    }
    wake_.notify_all();
    if (thread_.joinable()) thread_.join();
  }

 private:
  void run() {
    using namespace std::chrono_literals;
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, 200ms, [this] { return ended_; })) print();
    if (json_)
      print();
    else
      std::fputs("\r\033[K", messages);
    std::fflush(messages);
  }

  void print() {
    std::string line;
    const int iterations = progress_.iterations();
    const double change = progress_.change();
    if (json_) {
      nlohmann::ordered_json state{{"phase", progress_.phase()},
                                   {"fraction", progress_.fraction()}};
      if (iterations > 0) state["iterations"] = iterations;
      if (iterations > 0 && change >= 0.0) state["change"] = change;
      line = state.dump() + "\n";
    } else {
      char text[160];
      std::snprintf(text, sizeof text, "\r\033[K%3.0f %%  %s", 100.0 * progress_.fraction(),
                    progress_.phase());
      line = text;
      if (iterations > 0) {
        std::snprintf(text, sizeof text, "  (iteration %d", iterations);
        line += text;
        if (change >= 0.0) {
          std::snprintf(text, sizeof text, ", change %.3g", change);
          line += text;
        }
        line += ")";
      }
    }
    if (line == last_) return;
    last_ = line;
    std::fputs(line.c_str(), messages);
    std::fflush(messages);
  }

  Progress progress_;
  bool json_ = false;
  std::string last_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool ended_ = false;
  std::thread thread_;
};

const char* const kNoMemory =
    "not enough memory: choose a smaller region with --roi, or a machine with more memory";

/// Whether a failure is that of a library that got no memory or no thread.
bool isLackOfMemory(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return true;
  if (const auto* system = dynamic_cast<const std::system_error*>(&error))
    return system->code() == std::errc::resource_unavailable_try_again ||
           system->code() == std::errc::not_enough_memory;
  // ITK and TBB have no types of their own for it.
  const std::string_view text = error.what();
  return text.find("Failed to allocate memory") != std::string_view::npos ||
         text.find("pthread_create has failed") != std::string_view::npos;
}

/// Of an exception that nobody can catch, as one in a library's thread; or of none: ITK's pool ends
/// so when it gets some of its threads and not all.
[[noreturn]] void onTerminate() {
  bool memory = true;
  try {
    if (std::current_exception()) std::rethrow_exception(std::current_exception());
  } catch (const std::exception& error) {
    memory = isLackOfMemory(error);
  } catch (...) {
    memory = false;
  }
  if (!memory) std::abort();
  // Nothing that takes memory any more.
  std::fputs("angiomesh-cli: error: ", messages);
  std::fputs(kNoMemory, messages);
  std::fputs("\n", messages);
  std::fflush(messages);
  std::_Exit(UserCanChange);
}

int guarded(const std::function<int()>& action, std::string& message) {
  try {
    return action();
  } catch (const Cancelled&) {
    message = "cancelled: no result was written";
    return WasCancelled;
  } catch (const Error& error) {
    message = error.what();
    return UserCanChange;
  } catch (const std::exception& error) {
    if (isLackOfMemory(error)) {
      message = kNoMemory;
      return UserCanChange;
    }
    message = std::string("internal fault (") + error.what() +
              "): please report it with the command line that led to it";
    return OurFault;
  }
}

}  // namespace

void handleSignals(const Progress& progress) {
  signalled = &progress;
  struct sigaction action {};
  action.sa_handler = onSignal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    // Whoever started the program may want it to go on, as nohup does.
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) sigaction(signal, &action, nullptr);
  }
  std::set_terminate(onTerminate);
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

int runSession(Session& session) {
  muteLibraries();
  setThreads(session.threads);
  std::string message;
  int code = OurFault;
  {
    const ProgressPrinter printer(session.progress, session.progressMode);
    code = guarded(session.action, message);
  }
  if (!message.empty()) printError(message);
  if (!flushOutput() && code == Done) code = UserCanChange;
  // Libraries that were stopped half-way, as for want of memory, may not survive their own end.
  if (code == UserCanChange || code == OurFault) std::_Exit(code);
  return code;
}

bool flushOutput() {
  errno = 0;
  const bool whole = std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.flush();
  if (whole) return true;
  printError("cannot write to the standard output (" +
             std::generic_category().message(errno != 0 ? errno : EIO) +
             "): what was printed is not whole; send it to a place with free space");
  return false;
}

void printError(const std::string& text) {
  std::fprintf(messages, "angiomesh-cli: error: %s\n", text.c_str());
  std::fflush(messages);
}

void printWarning(const std::string& text) {
  std::fprintf(messages, "angiomesh-cli: warning: %s\n", text.c_str());
  std::fflush(messages);
}

}  // namespace angiomesh::cli
