// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/channel/keys.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zmq.h>

#include <array>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace blockweir::channel {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t key_length = 40;
using KeyText = std::array<char, key_length + 1>;
const char* const secret_file = "own-secret";
const char* const partner_file = "partner-public";

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
  throw std::invalid_argument(fmt::format("--keys: {}: {}", path.string(), why));
}

void write_new(const fs::path& path, const KeyText& key, mode_t mode) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
  const std::string line = std::string(key.data()) + "\n";
  const bool written = file >= 0 && ::write(file, line.data(), line.size()) == static_cast<ssize_t>(line.size());
  const int cause = errno;
  if ((file >= 0 && ::close(file) != 0) || !written) {
    throw std::invalid_argument(
        fmt::format("cannot write {}: {}; expected a folder that can be written; choose another", path.string(),
                    std::generic_category().message(cause)));
  }
}

void make_side(const fs::path& side) {
  std::error_code failed;
  fs::create_directories(side, failed);
  if (!failed) fs::permissions(side, fs::perms::owner_all, failed);
  if (failed) {
    throw std::invalid_argument(
        fmt::format("cannot make the folder {}: {}; expected a folder that can be written; "
                    "choose another",
                    side.string(), failed.message()));
  }
}

std::string read_key(const fs::path& path) {
  std::ifstream stream(path);
  if (!stream) refuse(path, "no such file; expected one side's folder as \"blockweir keys\" makes it");
  std::string key;
  std::getline(stream, key);
  std::array<std::uint8_t, 32> bytes;
  if (key.size() != key_length || zmq_z85_decode(bytes.data(), key.c_str()) == nullptr) {
    refuse(path, "not a key; expected a line of 40 characters as \"blockweir keys\" writes it");
  }
  return key;
}

}  // namespace

void make_keys(const fs::path& folder) {
  if (folder.empty()) throw std::invalid_argument("FOLDER: found no name; expected that of a new folder for the keys");
  const std::array<fs::path, 2> sides = {folder / "solid", folder / "fluid"};
  for (const fs::path& side : sides) {
    if (fs::exists(side)) {
      throw std::invalid_argument(
          fmt::format("{} is there already; choose another folder, or remove it", side.string()));
    }
  }
  std::array<KeyText, 2> open;
  std::array<KeyText, 2> secret;
  for (std::size_t s = 0; s < 2; ++s) {
    if (zmq_curve_keypair(open[s].data(), secret[s].data()) != 0) {
      throw std::runtime_error("--keys: this libzmq has no CURVE encryption; install one that is built with libsodium");
    }
  }
  try {
    for (std::size_t s = 0; s < 2; ++s) {
      make_side(sides[s]);
      write_new(sides[s] / secret_file, secret[s], 0600);
      write_new(sides[s] / partner_file, open[1 - s], 0644);
    }
  } catch (...) {  // nothing half-made stays in the way of another try
    std::error_code kept;
    for (const fs::path& side : sides) fs::remove_all(side, kept);
    throw;
  }
}

Keys read_keys(const fs::path& folder) {
  struct stat status = {};
  const fs::path secret = folder / secret_file;
  if (::stat(secret.c_str(), &status) == 0 && (status.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
    refuse(secret, fmt::format("others may read this secret; \"chmod 600 {}\"", secret.string()));
  }
  Keys keys;
  keys.own_secret = read_key(secret);
  keys.partner_public = read_key(folder / partner_file);
  KeyText open;
  if (zmq_curve_public(open.data(), keys.own_secret.c_str()) != 0) {
    throw std::runtime_error("--keys: this libzmq has no CURVE encryption; install one that is built with libsodium");
  }
  keys.own_public = open.data();
  return keys;
}

}  // namespace blockweir::channel
