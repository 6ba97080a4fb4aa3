#include "worker/message.h"

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace ssrkit {

namespace {

constexpr std::uint32_t kMagic = 0x4B525353;  // "SSRK"
constexpr std::size_t kMaxTextBytes = 4096;

struct Prefix {
  std::uint32_t magic = kMagic;
  MessageType type = MessageType::kProgress;
  std::uint64_t header_bytes = 0;  // kProgress: of the text that follows in the packet
  std::uint64_t bulk_bytes = 0;
};
static_assert(sizeof(Prefix) == 24, "no padding: it is sent as it is");

// Room for one descriptor, aligned as the kernel wants it.
struct ControlBuffer {
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> bytes = {};
};

bool sendPacket(int socket, Prefix prefix, std::string_view text, int fd) {
  std::array<iovec, 2> parts = {iovec{&prefix, sizeof(prefix)},
                                iovec{const_cast<char*>(text.data()), text.size()}};
  msghdr packet = {};
  packet.msg_iov = parts.data();
  packet.msg_iovlen = parts.size();
  ControlBuffer control;
  if (fd >= 0) {
    packet.msg_control = control.bytes.data();
    packet.msg_controllen = control.bytes.size();
    cmsghdr* const rights = CMSG_FIRSTHDR(&packet);
    rights->cmsg_level = SOL_SOCKET;
    rights->cmsg_type = SCM_RIGHTS;
    rights->cmsg_len = CMSG_LEN(sizeof(int));
    std::memcpy(CMSG_DATA(rights), &fd, sizeof(fd));
  }
  ssize_t sent = 0;
  do {
    sent = ::sendmsg(socket, &packet, MSG_NOSIGNAL);
  } while (sent < 0 && errno == EINTR);
  return sent >= 0;
}

OwnedFd takeDescriptor(msghdr& packet) {
  const cmsghdr* const rights = CMSG_FIRSTHDR(&packet);
  if (rights == nullptr || rights->cmsg_level != SOL_SOCKET || rights->cmsg_type != SCM_RIGHTS ||
      rights->cmsg_len != CMSG_LEN(sizeof(int))) {
    return {};
  }
  int fd = -1;
  std::memcpy(&fd, CMSG_DATA(rights), sizeof(fd));
  return OwnedFd(fd);
}

bool isKnown(MessageType type) {
  return type >= MessageType::kStart && type <= MessageType::kError;
}

Received parse(const Prefix& prefix, std::string_view text, OwnedFd memory) {
  Received received;
  received.state = Received::State::kGarbage;
  if (prefix.magic != kMagic || !isKnown(prefix.type)) {
    return received;
  }
  received.message.type = prefix.type;
  if (prefix.type == MessageType::kProgress) {
    if (prefix.header_bytes == text.size()) {
      received.message.text = text;
      received.state = Received::State::kMessage;
    }
    return received;
  }
  received.message.payload = Payload{std::move(memory), prefix.header_bytes, prefix.bulk_bytes};
  if (text.empty() && hasDeclaredSize(received.message.payload)) {
    received.state = Received::State::kMessage;
  }
  return received;
}

}  // namespace

bool sendProgress(int socket, std::string_view text) {
  text = text.substr(0, kMaxTextBytes);
  return sendPacket(socket, Prefix{kMagic, MessageType::kProgress, text.size(), 0}, text, -1);
}

bool sendPayload(int socket, MessageType type, const Payload& payload) {
  return sendPacket(socket, Prefix{kMagic, type, payload.header_bytes, payload.bulk_bytes}, {},
                    payload.memory.get());
}

Received receiveMessage(int socket, bool wait) {
  Prefix prefix;
  std::array<char, kMaxTextBytes> text;
  std::array<iovec, 2> parts = {iovec{&prefix, sizeof(prefix)}, iovec{text.data(), text.size()}};
  ControlBuffer control;
  msghdr packet = {};
  packet.msg_iov = parts.data();
  packet.msg_iovlen = parts.size();
  packet.msg_control = control.bytes.data();
  packet.msg_controllen = control.bytes.size();
  ssize_t count = 0;
  do {
    count = ::recvmsg(socket, &packet, MSG_CMSG_CLOEXEC | (wait ? 0 : MSG_DONTWAIT));
  } while (count < 0 && errno == EINTR);
  Received received;
  if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
    return received;
  }
  if (count <= 0) {
    received.state = Received::State::kClosed;
    return received;
  }
  OwnedFd memory = takeDescriptor(packet);
  const auto size = static_cast<std::size_t>(count);
  if (size < sizeof(prefix) || (packet.msg_flags & (MSG_TRUNC | MSG_CTRUNC)) != 0) {
    received.state = Received::State::kGarbage;
    return received;
  }
  return parse(prefix, std::string_view(text.data(), size - sizeof(prefix)), std::move(memory));
}

}  // namespace ssrkit
