// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/launch/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "bridge/launch/commands.hpp"

namespace blockweir::launch {
namespace {

/// `text` with a backslash before each of `marks`, for a text in single quotes.
std::string escaped(const std::string& text, const std::string& marks) {
  std::string all;
  for (const char c : text) {
    if (c == '\'') {
      all += "'\\''";
      continue;
    }
    if (marks.find(c) != std::string::npos) all += '\\';
    all += c;
  }
  return all;
}

/// The allowed words of an option, separated by blanks, if they are few; otherwise empty.
std::string values_of(const CLI::Option& option) {
  const std::string type = option.get_type_name();  // as "TEXT:{local,slurm}"
  const std::size_t first = type.find('{');
  const std::size_t last = type.rfind('}');
  if (first == std::string::npos || last == std::string::npos) return "";
  std::string words = type.substr(first + 1, last - first - 1);
  std::replace(words.begin(), words.end(), ',', ' ');
  return words;
}

/// Cases of bash's "COMMAND --option", each with the words that this option takes.
std::string bash_values(const CLI::App& command) {
  std::string cases;
  for (const CLI::Option* option : named_options(command)) {
    const std::string values = values_of(*option);
    if (values.empty()) continue;
    cases += fmt::format("    \"{} --{}\") COMPREPLY=($(compgen -W \"{}\" -- \"$word\")); return ;;\n",
                         command.get_name(), option->get_lnames().front(), values);
  }
  return cases;
}

std::string words_of(const CLI::App& app) {
  std::vector<std::string> words;
  for (const CLI::Option* option : named_options(app)) words.push_back("--" + option->get_lnames().front());
  return fmt::format("{}", fmt::join(words, " "));
}

/// An option as zsh's _arguments takes it.
std::string zsh_option(const CLI::Option& option) {
  const std::string values = values_of(option);
  const std::string action = values.empty() ? "_files" : "(" + values + ")";
  return fmt::format("'{}--{}[{}]{}'", option.get_items_expected_max() > 1 ? "*" : "", option.get_lnames().front(),
                     escaped(option.get_description(), "[]:\\"), takes_value(option) ? ":value:" + action : "");
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  std::string names;
  std::string options;
  std::string values;
  for (const CLI::App* command : commands_of(app)) {
    names += command->get_name() + " ";
    values += bash_values(*command);
    options += fmt::format("    {}) words=\"{}\" ;;\n", command->get_name(), words_of(*command));
  }
  return fmt::format(
      "# bash completion for blockweir, made by \"blockweir completion bash\"\n"
      "_blockweir() {{\n"
      "  local words= word=${{COMP_WORDS[COMP_CWORD]}}\n"
      "  COMPREPLY=()\n"
      "  case \"${{COMP_WORDS[1]}} ${{COMP_WORDS[COMP_CWORD-1]}}\" in\n"
      "{}"
      "  esac\n"
      "  case ${{COMP_WORDS[1]}} in\n"
      "{}"
      "  esac\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then words=\"{}{}\"; elif [[ $word != -* ]]; then return; fi\n"
      "  COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
      "}}\n"
      "complete -o default -F _blockweir blockweir\n",
      values, options, names, words_of(app));
}

std::string zsh_completion(const CLI::App& app) {
  std::string names;
  std::string options;
  for (const CLI::App* command : commands_of(app)) {
    names += fmt::format("    '{}:{}'\n", command->get_name(), escaped(command->get_description(), ":\\"));
    options += fmt::format("    {}) _arguments '*:file:_files'", command->get_name());
    for (const CLI::Option* option : named_options(*command)) options += " \\\n      " + zsh_option(*option);
    options += " ;;\n";
  }
  return fmt::format(
      "#compdef blockweir\n"
      "# zsh completion for blockweir, made by \"blockweir completion zsh\"\n"
      "_blockweir() {{\n"
      "  local -a commands=(\n"
      "{}"
      "  )\n"
      "  if (( CURRENT == 2 )); then\n"
      "    _describe command commands\n"
      "    return\n"
      "  fi\n"
      "  shift words\n"
      "  (( CURRENT-- ))\n"
      "  case $words[1] in\n"
      "{}"
      "  esac\n"
      "}}\n"
      "if [[ ${{funcstack[1]}} = _blockweir ]]; then _blockweir \"$@\"; else compdef _blockweir blockweir; fi\n",
      names, options);
}

}  // namespace blockweir::launch
