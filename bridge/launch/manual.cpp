// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/launch/manual.hpp"

#include <fmt/format.h>

#include "bridge/launch/commands.hpp"

namespace blockweir::launch {
namespace {

/// Text as roff takes it: no escapes, no requests at the start of a line, and hyphens that can be copied.
std::string plain(const std::string& text) {
  std::string all = text.starts_with('.') || text.starts_with('\'') ? "\\&" : "";
  for (const char c : text) {
    if (c == '\\') {
      all += "\\e";
    } else if (c == '-') {
      all += "\\-";
    } else {
      all += c;
    }
  }
  return all;
}

std::string tagged(const std::string& tag, const std::string& text) {
  return fmt::format(".TP\n{}\n{}\n", tag, plain(text));
}

std::string option_text(const CLI::Option& option) {
  const std::string name = plain("--" + option.get_lnames().front());
  return tagged(takes_value(option) ? fmt::format("\\fB{}\\fR \\fIVALUE\\fR", name) : fmt::format("\\fB{}\\fR", name),
                option.get_description());
}

std::string command_text(const CLI::App& command) {
  std::string synopsis = fmt::format(".SS \\fB{}\\fR", plain(command.get_name()));
  std::string options;
  for (const CLI::Option* option : positional_options(command)) {
    const std::string name = plain(option->get_name(true));
    synopsis += option->get_required() ? fmt::format(" \\fI{}\\fR", name) : fmt::format(" [\\fI{}\\fR ...]", name);
    options += tagged(fmt::format("\\fI{}\\fR", name), option->get_description());
  }
  for (const CLI::Option* option : named_options(command)) {
    if (option->get_lnames().front() != "help") options += option_text(*option);
  }
  return fmt::format("{}\n{}\n{}", synopsis, plain(command.get_description()), options);
}

}  // namespace

std::string manual(const CLI::App& app) {
  std::string texts;
  for (const CLI::App* command : commands_of(app)) texts += command_text(*command);
  std::string options;
  for (const CLI::Option* option : named_options(app)) options += option_text(*option);
  return fmt::format(
      ".TH BLOCKWEIR 1 \"\" \"blockweir {}\" \"User Commands\"\n"
      ".SH NAME\n{}\n"
      ".SH SYNOPSIS\n\\fBblockweir\\fR \\fICOMMAND\\fR [\\fIOPTION\\fR ...]\n"
      ".SH COMMANDS\n{}"
      ".SH OPTIONS\n{}"
      ".SH EXIT STATUS\n"
      "0: done; a structure that fails is a result. 1: the run failed, a figure is out of its tolerance, a study has "
      "no "
      "answer, or safety has a load case without its required factor. 2: the scene or the command is wrong. "
      "130: stopped on request.\n",
      BLOCKWEIR_VERSION, plain("blockweir - " + app.get_description().substr(app.get_description().find(": ") + 2)),
      texts, options);
}

}  // namespace blockweir::launch
