#include "signals.hpp"

#include <csignal>
#include <cstring>
#include <ctime>

#include <unistd.h>

#include "ramify/io/atomic_file.hpp"

namespace ramify::cli {
namespace {

Cancellation* stop_flag = nullptr;
volatile std::sig_atomic_t asked_by = 0;
timer_t patience{};

// All that handlers call is safe in them (signal-safety(7)).

[[noreturn]] void end_now() {
  remove_unfinished_files();
  constexpr const char* message = "ramify: interrupted\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, message, std::strlen(message));
  ::_exit(interrupted_code());
}

extern "C" void on_signal(int number) {
  if (asked_by != 0) end_now();
  asked_by = number;
  stop_flag->request();
  itimerspec wait{};
  wait.it_value.tv_sec = 1;
  wait.it_value.tv_nsec = 500'000'000;
  ::timer_settime(patience, 0, &wait, nullptr);
}

extern "C" void on_patience_lost(int) {
  end_now();
}

}  // namespace

void listen_for_signals(Cancellation& cancellation) {
  stop_flag = &cancellation;
  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGALRM;
  ::timer_create(CLOCK_MONOTONIC, &event, &patience);
  std::signal(SIGALRM, on_patience_lost);
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
  std::signal(SIGPIPE, SIG_IGN);
}

int interrupted_code() {
  return 128 + (asked_by != 0 ? asked_by : SIGINT);
}

}  // namespace ramify::cli
