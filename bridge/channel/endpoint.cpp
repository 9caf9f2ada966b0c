// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/channel/endpoint.hpp"

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>

#include "bridge/channel/channel.hpp"

namespace blockweir::channel {
namespace {

bool somebody_listens(const sockaddr_un& address) {
  const int probe = ::socket(AF_UNIX, SOCK_STREAM, 0);
  if (probe < 0) return false;
  const bool answered = ::connect(probe, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  ::close(probe);
  return answered;
}

}  // namespace

void check_endpoint(const std::string& endpoint, bool listens) {
  const std::string ipc = "ipc://";
  const std::string tcp = "tcp://";
  const auto refuse = [&](const std::string& why) { throw PeerError(fmt::format("endpoint {}: {}", endpoint, why)); };
  if (endpoint.compare(0, tcp.size(), tcp) == 0) {
    const auto colon = endpoint.rfind(':');
    const std::string port = endpoint.substr(colon + 1);
    if (colon < tcp.size() || port.empty() || port.find_first_not_of("0123456789") != std::string::npos) {
      refuse("expected tcp://HOST:PORT");
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
  if (!folder.empty() && !std::filesystem::is_directory(folder, ignored)) refuse("there is no such folder");
  if (!listens) return;
  if (somebody_listens(address)) refuse("another process listens there already; choose another --endpoint");
  std::filesystem::remove(path, ignored);
}

}  // namespace blockweir::channel
