// The protocol between a supervisor and its worker, over a socket that keeps packets whole (SOCK_SEQPACKET).
// The supervisor sends kStart once and then one kJob at a time; the worker answers kStart with kHello or
// kError, and each kJob with any number of kProgress and one kResult or kError.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "worker/payload.h"

namespace ssrkit {

enum class MessageType : std::uint32_t { kStart = 1, kHello, kJob, kProgress, kResult, kError };

struct Message {
  MessageType type = MessageType::kProgress;
  std::string text;  // of kProgress
  Payload payload;   // of every other type
};

struct Received {
  enum class State { kMessage, kNothingYet, kClosed, kGarbage };
  State state = State::kNothingYet;
  Message message;
};

// False when the peer is gone. A progress text is cut to 4,096 bytes.
[[nodiscard]] bool sendProgress(int socket, std::string_view text);
[[nodiscard]] bool sendPayload(int socket, MessageType type, const Payload& payload);

// The next packet; kNothingYet only when `wait` is false. Anything but a well-formed message is kGarbage.
[[nodiscard]] Received receiveMessage(int socket, bool wait);

}  // namespace ssrkit
