#include "worker/serve.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <thread>

#include "worker/fault.h"
#include "worker/message.h"
#include "worker/wire.h"

namespace ssrkit {

namespace {

constexpr int kUsage = 2;
constexpr int kBroken = 3;

// The kernel's own signal on a parent's death comes when the *thread* that started us ends, which is no
// reason to stop. The socket closes only with the whole process.
void endWithSupervisor(int fd) {
  std::thread([fd] {
    pollfd peer{fd, 0, 0};
    while (::poll(&peer, 1, -1) < 0 && errno == EINTR) {
    }
    std::this_thread::sleep_for(
        std::chrono::milliseconds(1500));  // the way out through main is the better one
    ::_exit(kAbandoned);
  }).detach();
}

void forbidCoreFiles() {
  const rlimit none = {0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
}

// From now on; the kernel sends SIGXCPU when it is spent.
void limitCpu(std::chrono::seconds limit) {
  rusage usage = {};
  ::getrusage(RUSAGE_SELF, &usage);
  const auto used_s = static_cast<rlim_t>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec + 1);
  rlimit limits = {};
  ::getrlimit(RLIMIT_CPU, &limits);
  limits.rlim_cur = std::min(limits.rlim_max, used_s + static_cast<rlim_t>(limit.count()));
  ::setrlimit(RLIMIT_CPU, &limits);
}

bool isProtocolSocket(int fd) {
  int type = 0;
  socklen_t size = sizeof(type);
  return ::getsockopt(fd, SOL_SOCKET, SO_TYPE, &type, &size) == 0 && type == SOCK_SEQPACKET;
}

template <class T, class Function>
Expected<T> withoutExceptions(const std::string& attempted, const Function& function) {
  try {
    return function();
  } catch (const std::bad_alloc&) {
    return setupError(attempted, "memory ran out", {}, "choose a smaller size or fewer stages");
  } catch (const std::exception& exception) {
    return setupError(attempted, std::string("an unforeseen failure: ") + exception.what());
  }
}

// As wrong as a driver's answer may be: every hit is one texel off.
void spoil(JobResult& result) {
  for (TraceResult& trace : result.traces) {
    for (RayHit& ray : trace.record.rays) {
      ray.texel_x += ray.ray_class == RayClass::kHit ? 1 : 0;
    }
  }
}

class Server {
 public:
  Server(std::string device_id, int fd, const WorkerRole& role, Fault fault)
      : device_id_(std::move(device_id)), fd_(fd), role_(role), fault_(std::move(fault)) {}

  int loop() {
    while (true) {
      const Received received = receiveMessage(fd_, true);
      if (received.state == Received::State::kClosed) {
        return 0;
      }
      const bool answered = received.state == Received::State::kMessage && answer(received.message);
      if (!answered) {
        return kBroken;
      }
    }
  }

  bool replyError(const Error& error) { return reply(MessageType::kError, packError(error)); }

 private:
  bool answer(const Message& message) {
    if (message.type == MessageType::kStart) {
      const std::optional<std::filesystem::path> shader_root = unpackStart(message.payload);
      return shader_root && start(*shader_root);
    }
    if (message.type == MessageType::kJob) {
      const std::optional<LimitedJob> limited = unpackJob(message.payload);
      return limited && run(*limited);
    }
    return false;
  }

  bool start(const std::filesystem::path& shader_root) {
    const auto info = withoutExceptions<DeviceInfo>("start the device '" + device_id_ + "'", [&] {
      return role_.start(shader_root, progressOf("start"));
    });
    return info ? reply(MessageType::kHello, packInfo(*info)) : replyError(info.error());
  }

  bool run(const LimitedJob& limited) {
    limitCpu(limited.cpu_limit);
    const auto packed = withoutExceptions<Payload>(
        "run '" + limited.job.id + "' on '" + device_id_ + "'", [&]() -> Expected<Payload> {
          auto result = role_.run(limited.job, progressOf(limited.job.id));
          if (result && fault_.spoils(device_id_ + " " + limited.job.id + ": answer")) {
            spoil(*result);
          }
          return std::move(result).and_then(packResult);
        });
    return packed ? reply(MessageType::kResult, packed) : replyError(packed.error());
  }

  Progress progressOf(const std::string& job_id) {
    return [this, prefix = device_id_ + " " + job_id + ": "](const std::string& text) {
      if (!sendProgress(fd_, text)) {
        std::_Exit(kBroken);
      }
      fault_.strikeAt(prefix + text);
    };
  }

  bool reply(MessageType type, const Expected<Payload>& payload) {
    if (payload) {
      return sendPayload(fd_, type, *payload);
    }
    return type != MessageType::kError && replyError(payload.error());
  }

  std::string device_id_;
  int fd_;
  const WorkerRole& role_;
  Fault fault_;
};

}  // namespace

int serve(const std::string& device_id, int fd, const WorkerRole& role) {
  if (!isProtocolSocket(fd)) {
    fmt::print(stderr, "ssrkit: '__worker' is for ssrkit's own use: it needs a supervisor\n");
    return kUsage;
  }
  ::fcntl(fd, F_SETFD, FD_CLOEXEC);
  forbidCoreFiles();
  std::signal(SIGXFSZ, SIG_IGN);  // shared memory beyond the limit on files is an error to tell
  endWithSupervisor(fd);
  const Expected<Fault> fault = Fault::fromEnvironment();
  Server server(device_id, fd, role, fault.value_or(Fault()));
  if (!fault) {
    // A socket that is closed with a message unread in it takes the reply with it.
    static_cast<void>(receiveMessage(fd, true));
    return server.replyError(fault.error()) ? kUsage : kBroken;
  }
  return server.loop();
}

}  // namespace ssrkit
