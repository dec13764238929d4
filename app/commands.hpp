// SPDX-License-Identifier: MIT
// One function a subcommand, each in a file of its own: it adds itself, its options and its callback.
// A callback throws ConfigError (exit code 2), any other exception (1), or ExitCode.
#pragma once

namespace CLI {
class App;
}

namespace odas {

/// Ends the program with this code, all that there is to say having been said.
struct ExitCode {
  int code;
};

void add_array(CLI::App& app);
void add_arrays(CLI::App& app);
void add_bench(CLI::App& app);
void add_check(CLI::App& app);
void add_devices(CLI::App& app);
void add_learn_noise(CLI::App& app);
void add_live(CLI::App& app);
void add_run(CLI::App& app);
void add_simulate(CLI::App& app);
void add_score(CLI::App& app);
void add_studio(CLI::App& app);
void add_tune(CLI::App& app);
void add_targets(CLI::App& app);

}  // namespace odas
