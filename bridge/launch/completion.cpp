// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/launch/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

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

std::string words_of(const CLI::App& app) {
  std::vector<std::string> words;
  for (const CLI::Option* option : named_options(app)) words.push_back("--" + option->get_lnames().front());
  return fmt::format("{}", fmt::join(words, " "));
}

/// An option as zsh's _arguments takes it.
std::string zsh_option(const CLI::Option& option) {
  return fmt::format("'{}--{}[{}]{}'", option.get_items_expected_max() > 1 ? "*" : "", option.get_lnames().front(),
                     escaped(option.get_description(), "[]:\\"), takes_value(option) ? ":value:_files" : "");
}

}  // namespace

std::string bash_completion(const CLI::App& app) {
  std::string names;
  std::string options;
  for (const CLI::App* command : commands_of(app)) {
    names += command->get_name() + " ";
    options += fmt::format("    {}) words=\"{}\" ;;\n", command->get_name(), words_of(*command));
  }
  return fmt::format(
      "# bash completion for blockweir, made by \"blockweir completion bash\"\n"
      "_blockweir() {{\n"
      "  local words= word=${{COMP_WORDS[COMP_CWORD]}}\n"
      "  COMPREPLY=()\n"
      "  case ${{COMP_WORDS[1]}} in\n"
      "{}"
      "  esac\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then words=\"{}{}\"; elif [[ $word != -* ]]; then return; fi\n"
      "  COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
      "}}\n"
      "complete -o default -F _blockweir blockweir\n",
      options, names, words_of(app));
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
