// SPDX-License-Identifier: GPL-3.0-or-later
// Command-line options of the connection, shared by all programs.
#pragma once

#include <CLI/CLI.hpp>

#include "bridge/channel/channel.hpp"

namespace blockweir::channel {

/// Adds --endpoint, --keys and --insecure.
inline CLI::Option* add_line_options(CLI::App& app, Options& line) {
  app.add_option("--keys", line.keys, "folder of this side's keys, as \"blockweir keys\" makes it; for tcp");
  app.add_flag("--insecure", line.insecure, "allow other machines to connect over tcp without keys");
  return app.add_option("--endpoint", line.endpoint,
                        line.side == Side::listens
                            ? "where to listen for the fluid process: ipc://PATH or tcp://HOST:PORT"
                            : "where the solid process listens: ipc://PATH or tcp://HOST:PORT");
}

}  // namespace blockweir::channel
