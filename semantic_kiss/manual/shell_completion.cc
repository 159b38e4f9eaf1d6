// Copyright 2026 The Semantic KISS Authors
// SPDX-License-Identifier: Apache-2.0

#include "semantic_kiss/manual/shell_completion.h"

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"
#include "gflags/gflags.h"
#include "semantic_kiss/cli/flags.h"

namespace semantic_kiss::manual {
namespace {

using cli::Command;
using cli::FlagInfo;
using cli::FlagUse;
using cli::FlagValue;

// --config has a way of its own to be completed.
constexpr char kConfigFlag[] = "config";

std::string Names(const std::vector<Command>& commands) {
  return absl::StrJoin(commands, " ",
                       [](std::string* out, const Command& command) { *out += command.name; });
}

// Whether a flag has a value, but stands for something without it, too.
bool MayBeBare(const FlagInfo& flag) { return !flag.bare_value.empty(); }

// "--flag=", "--flag", or both.
std::string BashFlag(const FlagUse& use) {
  const FlagInfo& flag = cli::FlagNamed(use.name);
  if (flag.value == FlagValue::kNone) return absl::StrCat("--", flag.name);
  return absl::StrCat(MayBeBare(flag) ? absl::StrCat("--", flag.name, " ") : "", "--", flag.name,
                      "=");
}

// How the value of a flag is completed in bash; empty: not at all.
std::string BashValue(const FlagInfo& flag) {
  std::string text;
  const std::vector<std::string> words = cli::WordsOfFlag(flag.name);
  if (!words.empty()) {
    absl::StrAppend(&text, "_semantic_kiss_words \"$value\" ", absl::StrJoin(words, " "), "; ");
  }
  if (flag.name == kConfigFlag) text += "_semantic_kiss_configurations \"$1\" \"$value\"; ";
  if (flag.value == FlagValue::kFile) text += "_semantic_kiss_paths -f \"$value\"; ";
  if (flag.value == FlagValue::kDirectory) text += "_semantic_kiss_paths -d \"$value\"; ";
  return text;
}

constexpr char kBashHead[] =
    R"bash(# bash completion for semantic_kiss; generated from the declarations of commands and flags.

_semantic_kiss_words() {
  local value=$1
  shift
  COMPREPLY+=($(compgen -W "$*" -- "$value"))
}

_semantic_kiss_paths() {
  local path
  compopt -o filenames 2>/dev/null
  while IFS= read -r path; do COMPREPLY+=("$path"); done < <(compgen "$1" -- "$2")
}

# The configurations that the program brings along, by name.
_semantic_kiss_configurations() {
  local program file
  program=$(readlink -f -- "$(type -P -- "$1")")
  for file in "${program%/bin/*}"/share/semantic_kiss/configuration_files/*.lua; do
    file=${file##*/}
    if [[ $file != '*.lua' && $file == "$2"* ]]; then COMPREPLY+=("$file"); fi
  done
}

_semantic_kiss() {
  # Bash breaks words at "=" as a rule; the line itself tells what is being typed.
  local line=${COMP_LINE:0:COMP_POINT}
  local -a tokens
  read -ra tokens <<<"$line"
  local token=${line##*[[:space:]]} command=${tokens[1]} flags value flag=
  COMPREPLY=()
  if [[ -n $token ]]; then unset "tokens[-1]"; fi
  if ((${#tokens[@]} == 1)) || [[ $command == help ]]; then
    _semantic_kiss_words "$token" )bash";

constexpr char kBashMiddle[] = R"bash(
  esac

  if [[ $token == --*=* ]]; then
    flag=${token%%=*}
    value=${token#*=}
  elif [[ $token != --* && " $flags " == *" ${tokens[-1]}= "* &&
    " $flags " != *" ${tokens[-1]} "* ]]; then
    flag=${tokens[-1]}
    value=$token
  fi
  case $flag in
    '')
      _semantic_kiss_words "$token" $flags --help
      if [[ ${COMPREPLY[*]} == *= ]]; then compopt -o nospace 2>/dev/null; fi
      return
      ;;
)bash";

constexpr char kBashTail[] = R"bash(  esac
  # Where "=" breaks no words, bash replaces the whole token.
  if [[ $token == --*=* && $COMP_WORDBREAKS != *=* ]]; then
    COMPREPLY=("${COMPREPLY[@]/#/$flag=}")
  fi
}

complete -F _semantic_kiss semantic_kiss
)bash";

// Text within '...' of a specification of _arguments.
std::string ZshText(const std::string& text) {
  return absl::StrReplaceAll(text, {{"'", "'\\''"}, {"[", "\\["}, {"]", "\\]"}, {":", "\\:"}});
}

std::string ZshValue(const FlagInfo& flag) {
  const std::vector<std::string> words = cli::WordsOfFlag(flag.name);
  if (flag.name == kConfigFlag) return "_semantic_kiss_configurations";
  if (!words.empty()) return absl::StrCat("(", absl::StrJoin(words, " "), ")");
  if (flag.value == FlagValue::kFile) return "_files";
  if (flag.value == FlagValue::kDirectory) return "_directories";
  return " ";
}

std::string ZshFlag(const FlagUse& use) {
  const FlagInfo& flag = cli::FlagNamed(use.name);
  const std::string about = gflags::GetCommandLineFlagInfoOrDie(flag.name.c_str()).description;
  // A value that may be left out can only follow "=": the next word is something else.
  std::string text = absl::StrCat("'--", flag.name);
  if (flag.value != FlagValue::kNone) text += MayBeBare(flag) ? "=-" : "=";
  absl::StrAppend(&text, "[", ZshText(about), "]");
  if (flag.value != FlagValue::kNone) {
    absl::StrAppend(&text, MayBeBare(flag) ? "::" : ":", flag.value_name, ":", ZshValue(flag));
  }
  return text + "'";
}

constexpr char kZshHead[] = R"zsh(#compdef semantic_kiss
# Generated from the declarations of commands and flags.

# The configurations that the program brings along, by name, and files.
_semantic_kiss_configurations() {
  local program=${commands[semantic_kiss]:-$service}
  local -a names=(${program:A:h:h}/share/semantic_kiss/configuration_files/*.lua(N:t))
  _alternative "configurations:configuration:($names)" "files:file:_files -g '*.lua'"
}

_semantic_kiss() {
  local -a names=(
)zsh";

constexpr char kZshMiddle[] = R"zsh(  )
  if ((CURRENT == 2)); then
    names+=('help:tell all about a command')
    local -a options=('--help:list the commands' '--version:tell the version')
    _describe command names
    _describe -o option options
    return
  fi
  if [[ $words[2] == help ]]; then
    if ((CURRENT == 3)); then _describe command names; fi
    return
  fi
  shift words
  ((CURRENT--))
  case $words[1] in
)zsh";

}  // namespace

std::string BashCompletion(const std::vector<Command>& commands) {
  std::string script = absl::StrCat(kBashHead, Names(commands),
                                    "\n    if [[ $command != help ]]; then\n"
                                    "      _semantic_kiss_words \"$token\" help --help --version\n"
                                    "    fi\n    return\n  fi\n\n  case $command in");
  for (const Command& command : commands) {
    absl::StrAppend(
        &script, "\n    ", command.name, ") flags='",
        absl::StrJoin(command.flags, " ",
                      [](std::string* out, const FlagUse& use) { *out += BashFlag(use); }),
        "' ;;");
  }
  script += kBashMiddle;
  for (const FlagInfo& flag : cli::Flags()) {
    const std::string value = BashValue(flag);
    if (!value.empty()) absl::StrAppend(&script, "    --", flag.name, ") ", value, ";;\n");
  }
  return script + kBashTail;
}

std::string ZshCompletion(const std::vector<Command>& commands) {
  std::string script = kZshHead;
  for (const Command& command : commands) {
    absl::StrAppend(&script, "    '", command.name, ":", ZshText(command.summary), "'\n");
  }
  script += kZshMiddle;
  for (const Command& command : commands) {
    absl::StrAppend(&script, "    ", command.name, ")\n      _arguments \\\n");
    for (const FlagUse& use : command.flags) {
      absl::StrAppend(&script, "        ", ZshFlag(use), " \\\n");
    }
    absl::StrAppend(&script, "        '--help[Tell all about this command.]'\n      ;;\n");
  }
  return script + "  esac\n}\n\n_semantic_kiss \"$@\"\n";
}

}  // namespace semantic_kiss::manual
