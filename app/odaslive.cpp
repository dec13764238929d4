// SPDX-License-Identifier: MIT
// odaslive: ODAS's command line, stamps and bytes, for those who have it in their scripts. Its messages are
// ODAS's too, but on stderr: stdout carries data only.
#include <csignal>
#include <cstdio>
#include <exception>
#include <string>

#include "configured_run.hpp"
#include "stop.hpp"
#include <unistd.h>

namespace {

constexpr int kFailure = 1;  // ODAS knows no other

constexpr const char* kHelp =
    "+----------------------------------------------------+\n"
    "|        ODAS (Open embeddeD Audition System)        |\n"
    "+----------------------------------------------------+\n"
    "| Usage: odaslive -c FILE [-s] [-v] [-h]             |\n"
    "|                                                    |\n"
    "|  -c FILE   Configuration file (mandatory)          |\n"
    "|  -s        Process sequentially, in one thread     |\n"
    "|  -v        Say what is done, and what it has cost  |\n"
    "|  -h        Show this help                          |\n"
    "|                                                    |\n"
    "| Example: odaslive -c respeaker.cfg                 |\n"
    "|                                                    |\n"
    "| Ctrl-C ends it well: all files are finished.       |\n"
    "+----------------------------------------------------+\n";

struct CommandLine {
  std::string file;
  bool sequential = false;
  bool verbose = false;
  bool help = false;
};

/// As ODAS: getopt says which option it does not know, and the others hold.
CommandLine parse(int argc, char** argv) {
  CommandLine line;
  for (int option = 0; (option = getopt(argc, argv, "c:hsv")) != -1;) {
    if (option == 'c') line.file = optarg;
    if (option == 'h') line.help = true;
    if (option == 's') line.sequential = true;
    if (option == 'v') line.verbose = true;
  }
  return line;
}

int run(const CommandLine& line) {
  if (line.verbose) {
    std::fprintf(stderr, "odaslive: running %s in %s\n", line.file.c_str(),
                 line.sequential ? "one thread" : "three threads");
  }
  const odas::ConfiguredRun how{.threads = !line.sequential, .like_odas = true};
  const odas::RunSummary summary =
      odas::run_configuration(line.file, how, "odaslive", odas::stop_on_signals());
  if (line.verbose) std::fprintf(stderr, "%s\n", odas::describe(summary.metrics).c_str());
  return odas::say_end(summary, "odaslive");
}

}  // namespace

int main(int argc, char** argv) {
  // A reader that goes away and a file that may not grow are error values, not our end.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  const CommandLine line = parse(argc, argv);
  if (line.help) {
    std::fputs(kHelp, stdout);
    return 0;
  }
  if (line.file.empty()) {
    std::fputs("Missing configuration file.\n", stderr);
    return kFailure;
  }
  try {
    return run(line);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return kFailure;
  }
}
