// SPDX-License-Identifier: MIT
// The man pages and the shell completions know every command and option that --help tells, and no other.
#include <algorithm>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "support/program.hpp"
#include <gtest/gtest.h>

namespace odas::test::manual_test {
namespace {

using Words = std::set<std::string>;

std::string read(const std::string& file) {
  std::ifstream in(std::string(ODAS_SOURCE_DIR) + "/packaging/" + file);
  EXPECT_TRUE(in) << file;
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::string help_of(const std::string& command) {
  std::vector<std::string> line{program_path("odas"), "--help"};
  if (!command.empty()) line.insert(line.begin() + 1, command);
  return run_program(line).out;
}

Words all_matches(const std::string& text, const std::regex& pattern) {
  Words words;
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match) {
    words.insert((*match)[1]);
  }
  return words;
}

Words commands() {
  std::string help = help_of("");
  help.erase(0, help.find("Subcommands:"));
  help.resize(std::min(help.find("\n\n"), help.size()));  // examples follow, which begin with odas
  return all_matches(help, std::regex(R"((?:^|\n)  ([a-z-]+) )"));
}

/// The lines of the options alone: the examples below them name options of other commands, too.
Words options(const std::string& command) {
  std::string help = help_of(command);
  help.erase(0, help.find("Options:"));
  const std::size_t end = help.find("\n\n");
  if (end != std::string::npos) help.resize(end);
  Words words;
  for (const std::string& names : all_matches(help, std::regex(R"(\n  (-[-a-z,]+))"))) {
    words.merge(all_matches(names, std::regex(R"((-{1,2}[a-z-]+))")));
  }
  return words;
}

/// The part of the man page on one command, its escapes undone; without a command, the general part.
std::string manual_section(const std::string& command) {
  std::string page = std::regex_replace(read("man/odas.1"), std::regex(R"(\\-)"), "-");
  std::string title = ".SH OPTIONS";
  if (!command.empty()) {
    title = ".SH ODAS " + command;
    for (char& c : title) c = static_cast<char>(std::toupper(c));
  }
  const std::size_t start = page.find(title + "\n");
  EXPECT_NE(start, std::string::npos) << "the man page has no section " << title;
  if (start == std::string::npos) return "";
  return page.substr(start, page.find("\n.SH", start + 1) - start);
}

/// What bash offers after `line`, of which the last word is being typed.
Words bash_offers(const std::string& function, const std::vector<std::string>& line) {
  std::string words;
  for (const std::string& word : line) words += "'" + word + "' ";
  const std::string script = "compopt() { :; }; source '" + std::string(ODAS_SOURCE_DIR) +
                             "/packaging/completions/odas.bash'; COMP_WORDS=(" + words +
                             "); COMP_CWORD=" + std::to_string(line.size() - 1) + "; " + function +
                             "; printf '%s\\n' \"${COMPREPLY[@]}\"";
  const ProgramRun run = run_program({"/bin/bash", "-c", script});
  return all_matches(run.out, std::regex(R"(([^\n]+)\n)"));
}

TEST(Help, tells_commands_and_options) {
  EXPECT_TRUE(commands().contains("run"));
  EXPECT_EQ(options("check"), (Words{"-h", "--help", "--keys"}));
}

TEST(ManPage, tells_every_option_of_every_command_and_no_other) {
  EXPECT_EQ(all_matches(manual_section(""), std::regex(R"(\W(-{1,2}[a-z][a-z-]*))")), options(""));
  for (const std::string& command : commands()) {
    Words told = all_matches(manual_section(command), std::regex(R"([ "](-{1,2}[a-z][a-z-]*))"));
    told.insert({"-h", "--help"});
    EXPECT_EQ(told, options(command)) << command;
  }
}

TEST(BashCompletion, offers_every_option_of_every_command_and_no_other) {
  Words first = bash_offers("_odas", {"odas", ""});
  Words expected = commands();
  expected.merge(options(""));
  EXPECT_EQ(first, expected);
  for (const std::string& command : commands()) {
    EXPECT_EQ(bash_offers("_odas", {"odas", command, "-"}), options(command)) << command;
  }
}

TEST(FishCompletion, knows_every_option_of_every_command) {
  const std::string text = read("completions/odas.fish");
  for (const std::string& command : commands()) {
    EXPECT_NE(text.find("-a " + command + " "), std::string::npos) << command;
    for (const std::string& option : options(command)) {
      if (option == "-h" || option == "--help") continue;  // of all commands at once
      const std::string said = option.starts_with("--") ? "-l " + option.substr(2) : "-s " + option.substr(1);
      const std::regex line("\ncomplete -c odas -n '__fish_seen_subcommand_from[^\n']*\\b" + command +
                            "\\b[^\n']*' [^\n]*" + said + " ");
      EXPECT_TRUE(std::regex_search(text, line)) << command << ' ' << option;
    }
  }
}

TEST(ZshCompletion, knows_every_option_of_every_command) {
  const std::string text = read("completions/_odas");
  for (const std::string& command : commands()) {
    EXPECT_NE(text.find("'" + command + ":"), std::string::npos) << command;
    const std::size_t start = text.find("    " + command + ")\n");
    ASSERT_NE(start, std::string::npos) << command;
    std::string part = text.substr(start, text.find(";;", start) - start);
    if (part.find("$config") != std::string::npos) part += "'-c[' '--config['";
    if (part.find("$out") != std::string::npos) part += "'-o[' '--out['";
    for (const std::string& option : options(command)) {
      if (option == "-h" || option == "--help") continue;  // $help, in each
      EXPECT_TRUE(std::regex_search(part, std::regex("['\"{,*]" + option + "[}\\[,]")))
          << command << ' ' << option;
    }
  }
}

TEST(Odaslive, has_its_options_in_help_man_page_and_completion) {
  const Words expected{"-c", "-s", "-v", "-h"};
  const std::string help = run_program({program_path("odaslive"), "-h"}).out;
  EXPECT_EQ(all_matches(help, std::regex(R"(\|  (-[a-z]) )")), expected);
  const std::string page = std::regex_replace(read("man/odaslive.1"), std::regex(R"(\\-)"), "-");
  EXPECT_EQ(all_matches(page, std::regex(R"(\n\.BI? (-[a-z])(?=\s))")), expected);
  EXPECT_EQ(bash_offers("_odaslive", {"odaslive", "-"}), expected);
}

TEST(Odasserver, has_its_options_in_help_man_page_and_completions) {
  const std::regex option(R"((-{1,2}[a-z]+))");
  std::string help = run_program({program_path("odasserver"), "--help"}).out;
  help = help.substr(help.find("Options:"));
  help.resize(help.find("\n\n"));
  Words expected;
  for (const std::string& names : all_matches(help, std::regex(R"(\n  (-[-a-z,]+))"))) {
    expected.merge(all_matches(names, option));
  }
  EXPECT_TRUE(expected.contains("--allow"));
  const std::string page = std::regex_replace(read("man/odasserver.1"), std::regex(R"(\\-)"), "-");
  Words told;
  for (const std::string& line : all_matches(page, std::regex(R"(\n\.BI?R? (-[^\n]*))"))) {
    told.merge(all_matches(line, std::regex(R"((?:^|[ "])(-{1,2}[a-z]+))")));
  }
  EXPECT_EQ(told, expected);
  EXPECT_EQ(bash_offers("_odasserver", {"odasserver", "-"}), expected);
  for (const char* file : {"completions/odas.fish", "completions/_odas"}) {
    const std::string text = read(file);
    for (const std::string& name : expected) {
      const bool is_fish = std::string_view(file).ends_with("fish");
      const std::string said =
          is_fish ? name.starts_with("--") ? "-l " + name.substr(2) : "-s " + name.substr(1) : name;
      const std::string after = is_fish ? "odasserver [^\n]*" : "odasserver[^]*";
      EXPECT_TRUE(std::regex_search(text, std::regex(after + said + "[ \\[,}]"))) << file << ' ' << name;
    }
  }
}

}  // namespace
}  // namespace odas::test::manual_test
