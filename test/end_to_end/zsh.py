# Copyright 2026 The Semantic KISS Authors
# SPDX-License-Identifier: Apache-2.0
"""An interactive zsh in a terminal of its own, to ask what it makes of the Tab key."""

import os
import pty
import select
import tempfile
import time

# `compadd` is how completion functions hand over their matches (zshcompwid(1)); calls with -O, -A or
# -D only ask. Control-T completes, and tells by the file $ANSWER.
SETUP = r"""
unsetopt zle_bracketed_paste beep
fpath=($COMPLETION_DIRECTORY $fpath)
autoload -Uz compinit && compinit -u -D
compadd() {
  if [[ ${@[1,(i)(-|--)]} != *-(O|A|D)\ * ]]; then
    local -a matches
    builtin compadd -O matches "$@"
    offered+=("${matches[@]}")
  fi
  builtin compadd "$@"
}
typeset -ga offered
tell-completion() {
  offered=()
  zle complete-word
  print -rl -- "$BUFFER" "${offered[@]}" >$ANSWER.part
  BUFFER=
  mv $ANSWER.part $ANSWER
}
zle -N tell-completion
bindkey '^T' tell-completion
"""
COMPLETE = b"\x14"  # Control-T


class Zsh:
    """Reads completion functions from a directory. Always close(), which a `with` does."""

    def __init__(self, completion_directory, path, working_directory):
        self.scratch = tempfile.TemporaryDirectory(prefix="semantic_kiss_")
        self.answer = os.path.join(self.scratch.name, "answer")
        variables = {**os.environ, "TERM": "dumb", "PATH": path, "ANSWER": self.answer,
                     "ZDOTDIR": self.scratch.name, "COMPLETION_DIRECTORY": completion_directory}
        with open(os.path.join(self.scratch.name, ".zshrc"), "w", encoding="utf-8") as file:
            file.write(SETUP)
        self.process, self.terminal = pty.fork()
        if self.process == 0:
            os.chdir(working_directory)
            os.execvpe("zsh", ["zsh", "-i"], variables)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        os.close(self.terminal)
        os.waitpid(self.process, 0)
        self.scratch.cleanup()

    def complete(self, typed, within_s=30):
        """The line after a Tab at the end of `typed`, and the set of all that fits there."""
        os.write(self.terminal, typed.encode() + COMPLETE)
        end = time.monotonic() + within_s
        while not os.path.exists(self.answer):
            if time.monotonic() > end:
                raise AssertionError(f"zsh says nothing about {typed!r}")
            # What it shows has to go somewhere, or it stops.
            if select.select([self.terminal], [], [], 0.02)[0]:
                os.read(self.terminal, 65536)
        with open(self.answer, encoding="utf-8") as file:
            line, *offered = file.read().splitlines()
        os.remove(self.answer)
        return line, set(offered)
