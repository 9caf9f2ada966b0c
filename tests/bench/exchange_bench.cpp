// SPDX-License-Identifier: GPL-3.0-or-later
// links: bridge_channel
// What an exchange of a window costs over the line, against raw ZeroMQ that sends as many bytes to and fro, side by
// side in one run. Both have a thread for the other side, on the same kind of endpoint. Arguments: numbers of panels.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <thread>
#include <vector>
#include <zmq.hpp>

#include "bridge/channel/channel.hpp"
#include "bridge/wire/codec.hpp"

namespace {

using namespace blockweir;
using Clock = std::chrono::steady_clock;

wire::Motion motion_of(std::size_t blocks) {
  wire::Motion motion;
  motion.displacement.assign(blocks, {1, 2, 3, 4, 5, 6});
  motion.velocity = motion.displacement;
  return motion;
}

wire::Load load_of(std::size_t panels) {
  wire::Load load;
  for (std::size_t i = 0; i < panels; ++i) {
    load.block.push_back(static_cast<std::uint32_t>(i / 4));
    load.edge.push_back(static_cast<std::uint32_t>(i % 4));
    load.s_from.push_back(0);
    load.s_to.push_back(1);
    load.pressure_from_pa.push_back(static_cast<double>(i));
    load.pressure_to_pa.push_back(static_cast<double>(i + 1));
  }
  return load;
}

std::string endpoint(const char* name) {
  return fmt::format("ipc:///tmp/blockweir-bench-{}-{}", ::getpid(), name);
}

/// Our own line: the solid's side says where the blocks are, the fluid's what presses on them.
class Line {
 public:
  Line(std::size_t panels, int most) : motion_(motion_of(panels / 4 + 1)), load_(load_of(panels)) {
    wire::Hello hello;
    hello.block_names.resize(motion_.displacement.size());
    hello.vertex_counts.resize(hello.block_names.size());
    other_ = std::thread([panels, most, hello] {
      channel::Channel fluid({.side = channel::Side::connects, .endpoint = endpoint("line"), .partner = "solid"});
      (void)fluid.handshake(hello);
      wire::Motion heard;
      wire::Load said = load_of(panels);
      for (int i = 0; i < most; ++i) {
        fluid.receive(heard);
        fluid.send(said);
      }
    });
    (void)solid_.handshake(hello);
  }
  ~Line() { other_.join(); }
  void exchange() {
    solid_.send(motion_);
    solid_.receive(load_);
  }

 private:
  channel::Channel solid_{{.side = channel::Side::listens, .endpoint = endpoint("line"), .partner = "fluid"}};
  wire::Motion motion_;
  wire::Load load_;
  std::thread other_;
};

template <class Message>
std::size_t bytes_of(const Message& message) {
  flatbuffers::FlatBufferBuilder builder;
  std::vector<wire::Part> parts;
  wire::encode(message, builder, parts);
  return std::accumulate(parts.begin(), parts.end(), std::size_t{builder.GetSize()},
                         [](std::size_t sum, const wire::Part& part) { return sum + part.size; });
}

/// The same bytes, unread. It looks for an answer as the line does: at once for a while, then asleep.
class Raw {
 public:
  Raw(std::size_t panels, int most)
      : there_(bytes_of(motion_of(panels / 4 + 1))), back_(bytes_of(load_of(panels))), socket_(context_, ZMQ_PAIR) {
    socket_.bind(endpoint("raw"));
    other_ = std::thread([this, most] {
      zmq::context_t context;
      zmq::socket_t socket(context, ZMQ_PAIR);
      socket.connect(endpoint("raw"));
      for (int i = 0; i < most; ++i) {
        receive(socket);
        socket.send(zmq::buffer(back_), zmq::send_flags::none);
      }
    });
  }
  ~Raw() { other_.join(); }
  void exchange() {
    socket_.send(zmq::buffer(there_), zmq::send_flags::none);
    receive(socket_);
  }
  [[nodiscard]] std::size_t bytes() const { return there_.size() + back_.size(); }

 private:
  static void receive(zmq::socket_t& socket) {
    zmq::message_t message;
    for (const auto start = Clock::now(); Clock::now() - start < std::chrono::microseconds(50);) {
      if (socket.recv(message, zmq::recv_flags::dontwait)) return;
    }
    (void)socket.recv(message, zmq::recv_flags::none);
  }

  std::vector<char> there_;
  std::vector<char> back_;
  zmq::context_t context_;
  zmq::socket_t socket_;
  std::thread other_;
};

double seconds(const std::function<void()>& work) {
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::size_t> sizes;
  for (int i = 1; i < argc; ++i) sizes.push_back(std::strtoul(argv[i], nullptr, 10));
  if (sizes.empty()) sizes = {10, 100, 1'000, 10'000, 100'000};
  fmt::print("panels    bytes        ours [us]   raw [us]   ours/raw   of each pair\n");
  for (const std::size_t panels : sizes) {
    const int rounds = panels > 10'000 ? 40 : 400;
    constexpr int pairs = 9;  // each has its luck with memory and cores
    std::vector<double> ours_s;
    std::vector<double> raw_s;
    std::vector<double> ratios;
    std::size_t bytes = 0;
    for (int pair = 0; pair < pairs; ++pair) {
      Line line(panels, rounds);
      Raw raw(panels, rounds);
      std::vector<double> ours;
      std::vector<double> theirs;
      for (int i = 0; i < rounds; ++i) {  // by turns: whatever else the machine does meets both
        ours.push_back(seconds([&] { line.exchange(); }));
        theirs.push_back(seconds([&] { raw.exchange(); }));
      }
      ours_s.push_back(median(ours));
      raw_s.push_back(median(theirs));
      ratios.push_back(ours_s.back() / raw_s.back());
      bytes = raw.bytes();
    }
    std::sort(ratios.begin(), ratios.end());
    fmt::print("{:<9} {:<12} {:<11.1f} {:<10.1f} {:<10.2f} {:.2f} to {:.2f}\n", panels, bytes, 1e6 * median(ours_s),
               1e6 * median(raw_s), median(ratios), ratios.front(), ratios.back());
    std::fflush(stdout);
  }
}
