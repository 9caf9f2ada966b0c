// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge/channel/authenticator.hpp"
#include "bridge/channel/retry_on_interrupt.hpp"

#include <array>
#include <vector>

namespace blockweir::channel {

Authenticator::Authenticator(zmq::context_t& context, const std::string& partner_public)
    : questions_(context, zmq::socket_type::rep) {
  if (!partner_public.empty()) {
    partner_.resize(32);
    zmq_z85_decode(reinterpret_cast<std::uint8_t*>(partner_.data()), partner_public.c_str());
  }
  questions_.set(zmq::sockopt::linger, 0);
  retry_on_interrupt([&] { questions_.bind("inproc://zeromq.zap.01"); });
}

void Authenticator::answer() {
  zmq::message_t part;
  const auto receive = [&](zmq::recv_flags flags) {
    return retry_on_interrupt([&] { return questions_.recv(part, flags); });
  };
  while (receive(zmq::recv_flags::dontwait)) {
    std::vector<std::string> question = {part.to_string()};
    while (part.more() && receive(zmq::recv_flags::none)) question.push_back(part.to_string());
    // version, request, domain, address, identity, mechanism, credentials
    question.resize(7);
    const bool known = partner_.empty() || (question[5] == "CURVE" && question[6] == partner_);
    const std::array<std::string, 6> answer = {question[0], question[1], known ? "200" : "400", "", "", ""};
    for (std::size_t i = 0; i < answer.size(); ++i) {
      const auto flags = i + 1 < answer.size() ? zmq::send_flags::sndmore : zmq::send_flags::none;
      retry_on_interrupt([&] { return questions_.send(zmq::buffer(answer[i]), flags); });
    }
  }
}

}  // namespace blockweir::channel
