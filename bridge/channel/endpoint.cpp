// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/channel/endpoint.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "bridge/channel/channel.hpp"

namespace blockweir::channel {
namespace {

const std::string tcp = "tcp://";

/// Do only processes of this machine reach `host`?
bool stays_here(const std::string& host) {
  in_addr v4 = {};
  if (::inet_pton(AF_INET, host.c_str(), &v4) == 1) return ntohl(v4.s_addr) >> 24U == 127;
  return host == "localhost" || host == "[::1]" || host == "lo";
}

bool somebody_listens(const sockaddr_un& address) {
  const int probe = ::socket(AF_UNIX, SOCK_STREAM, 0);
  if (probe < 0) return false;
  const bool answered = ::connect(probe, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  ::close(probe);
  return answered;
}

}  // namespace

bool is_tcp(const std::string& endpoint) {
  return endpoint.compare(0, tcp.size(), tcp) == 0;
}

void remove_socket_file(const std::string& endpoint) {
  std::error_code ignored;
  const std::string ipc = "ipc://";
  if (endpoint.compare(0, ipc.size(), ipc) == 0) std::filesystem::remove(endpoint.substr(ipc.size()), ignored);
}

void check_endpoint(const std::string& endpoint, bool listens, bool may_come) {
  const std::string ipc = "ipc://";
  const auto text = [&](const std::string& why) { return fmt::format("endpoint {}: {}", endpoint, why); };
  const auto refuse = [&](const std::string& why) { throw std::invalid_argument(text(why)); };
  if (is_tcp(endpoint)) {
    const auto colon = endpoint.rfind(':');
    const std::string port = endpoint.substr(colon + 1);
    if (colon < tcp.size() || port.empty() || port.find_first_not_of("0123456789") != std::string::npos) {
      refuse("expected tcp://HOST:PORT");
    }
    // ZeroMQ would take it modulo 65536.
    if (port.size() > 5 || std::stoi(port) < 1 || std::stoi(port) > 65535) refuse("expected a port from 1 to 65535");
    if (!may_come && !stays_here(endpoint.substr(tcp.size(), colon - tcp.size()))) {
      throw std::invalid_argument(
          fmt::format("endpoint {}: other machines on the network could read the run and connect to it; give both "
                      "sides the --keys that \"blockweir keys FOLDER\" makes, or allow it with --insecure",
                      endpoint));
    }
    return;
  }
  if (endpoint.compare(0, ipc.size(), ipc) != 0 || endpoint.size() == ipc.size()) {
    refuse("expected ipc://PATH or tcp://HOST:PORT");
  }
  const std::string path = endpoint.substr(ipc.size());
  sockaddr_un address = {};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) {
    refuse(fmt::format("the path has {} bytes, at most {} fit a socket; choose a shorter one", path.size(),
                       sizeof address.sun_path - 1));
  }
  std::memcpy(address.sun_path, path.c_str(), path.size());
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code ignored;
  if (!folder.empty() && !std::filesystem::is_directory(folder, ignored))
    refuse("there is no folder " + folder.string() + "; make it, or choose another path");
  if (!listens) return;
  if (somebody_listens(address))
    throw PeerError(text("another process listens there already; choose another --endpoint"));
  const auto there = std::filesystem::symlink_status(path, ignored);
  if (std::filesystem::exists(there) && !std::filesystem::is_socket(there)) {
    throw PeerError(text("there is a file that is no socket; choose another --endpoint"));
  }
  std::filesystem::remove(path, ignored);  // a former run's
}

}  // namespace blockweir::channel
