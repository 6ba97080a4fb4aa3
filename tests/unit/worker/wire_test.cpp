#include "worker/wire.h"

#include <gtest/gtest.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "samples.h"

namespace ssrkit {

namespace {

std::string bytesOf(const Payload& payload) {
  std::string bytes(payload.header_bytes + payload.bulk_bytes, '\0');
  EXPECT_TRUE(readPayload(payload, 0, std::as_writable_bytes(std::span(bytes))));
  return bytes;
}

Payload payloadOf(const std::string& bytes, std::uint64_t header_bytes) {
  Payload payload{OwnedFd(::memfd_create("test", MFD_CLOEXEC)), header_bytes, bytes.size() - header_bytes};
  EXPECT_EQ(::write(payload.memory.get(), bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
  return payload;
}

}  // namespace

TEST(Wire, AJobComesBackWithEveryBitOfEveryField) {
  const Expected<Payload> packed = packJob(sampleJob(), std::chrono::seconds(17));
  ASSERT_TRUE(packed);
  EXPECT_TRUE(hasDeclaredSize(*packed));
  const std::optional<LimitedJob> limited = unpackJob(*packed);
  ASSERT_TRUE(limited);
  EXPECT_EQ(limited->cpu_limit, std::chrono::seconds(17));
  EXPECT_TRUE(sameBits(limited->job, sampleJob()));
}

TEST(Wire, AJobOfDefaultsComesBackAsDefaults) {
  const std::optional<LimitedJob> limited = unpackJob(packJob(Job{}, std::chrono::seconds(1)).value());
  ASSERT_TRUE(limited);
  EXPECT_TRUE(sameBits(limited->job, Job{}));
}

TEST(Wire, AResultComesBackWithEveryBitOfEveryField) {
  const std::optional<JobResult> result = unpackResult(packResult(sampleResult()).value());
  ASSERT_TRUE(result);
  EXPECT_TRUE(sameBits(*result, sampleResult()));
}

TEST(Wire, TheComparisonOfTheseTestsSeesOneChangedBit) {
  JobResult changed = sampleResult();
  EXPECT_TRUE(sameBits(changed, sampleResult()));
  changed.traces[0].record.rays[5].px_y = 5.0F;  // was -5
  EXPECT_FALSE(sameBits(changed, sampleResult()));
  Job other = sampleJob();
  other.gbuffer["dist_view"].data[4] = 0.0F;  // was -0
  EXPECT_FALSE(sameBits(other, sampleJob()));
}

TEST(Wire, AnErrorComesBackWhole) {
  const Error error{ErrorKind::kSetup, "draw", "no memory", "a.gltf:1:2", "buy some", {"VK -1", "twice"}};
  const std::optional<Error> copy = unpackError(packError(error).value());
  ASSERT_TRUE(copy);
  EXPECT_EQ(sentence(*copy), sentence(error));
  EXPECT_EQ(copy->kind, ErrorKind::kSetup);
}

TEST(Wire, IdentityAndTraitsComeBackWhole) {
  const DeviceInfo info{
      {"gl-osmesa", "OpenGL 4.5 core", "llvmpipe", "Mesa 22.3.6", "a cpu", {"avx2", "avx512f"}},
      {65535, true, "SPIR-V"},
      789};
  const std::optional<DeviceInfo> copy = unpackInfo(packInfo(info).value());
  ASSERT_TRUE(copy);
  EXPECT_EQ(copy->identity.id, "gl-osmesa");
  EXPECT_EQ(copy->identity.api, "OpenGL 4.5 core");
  EXPECT_EQ(copy->identity.driver, "llvmpipe");
  EXPECT_EQ(copy->identity.version, "Mesa 22.3.6");
  EXPECT_EQ(copy->identity.cpu, "a cpu");
  EXPECT_EQ(copy->identity.cpu_features, (std::vector<std::string>{"avx2", "avx512f"}));
  EXPECT_EQ(copy->traits.loop_cap, 65535U);
  EXPECT_TRUE(copy->traits.device_timer_usable);
  EXPECT_EQ(copy->traits.shader_input, "SPIR-V");
  EXPECT_EQ(copy->create_ns, 789);
}

TEST(Wire, APayloadOfAnotherKindIsRefused) {
  EXPECT_FALSE(unpackResult(packError(Error{}).value()));
  EXPECT_FALSE(unpackError(packResult(sampleResult()).value()));
  EXPECT_FALSE(unpackInfo(packStart("shaders").value()));
}

TEST(Wire, AHeaderThatIsCutOffIsRefusedAtEveryLength) {
  const Payload payload = packResult(sampleResult()).value();
  const std::string bytes = bytesOf(payload);
  for (std::uint64_t length = 0; length < payload.header_bytes; ++length) {
    ASSERT_FALSE(unpackResult(payloadOf(bytes.substr(0, length), length))) << length;
  }
}

TEST(Wire, BulkDataThatIsCutOffOrTooLongIsRefused) {
  const Payload payload = packResult(sampleResult()).value();
  const std::string bytes = bytesOf(payload);
  EXPECT_FALSE(unpackResult(payloadOf(bytes.substr(0, bytes.size() - 1), payload.header_bytes)));
  EXPECT_FALSE(unpackResult(payloadOf(bytes + "x", payload.header_bytes)));
  EXPECT_TRUE(unpackResult(payloadOf(bytes, payload.header_bytes)));
}

TEST(Wire, NoDamagedByteMakesTheReaderFailInAnyOtherWayThanByRefusing) {
  const Payload payload = packResult(sampleResult()).value();
  const std::string bytes = bytesOf(payload);
  int refused = 0;
  for (std::size_t i = 0; i < payload.header_bytes; ++i) {
    for (const char damage : {'\x01', '\x7f', '\xff'}) {
      std::string damaged = bytes;
      damaged[i] = static_cast<char>(damaged[i] ^ damage);
      const std::optional<JobResult> result = unpackResult(payloadOf(damaged, payload.header_bytes));
      refused += result ? 0 : 1;
      if (result) {
        for (const auto& [name, image] : result->images) {
          ASSERT_EQ(image.data.size(), image.texelCount() * image.channelCount());
        }
      }
    }
  }
  EXPECT_GT(refused, 1000);
}

TEST(Wire, ARayOfAClassThatDoesNotExistArrivesForTheChecksToTell) {
  JobResult result;
  result.traces.emplace_back();
  result.traces[0].record = RayRecord{{1, 1}, {RayHit{.ray_class = static_cast<RayClass>(200)}}};
  const Payload payload = packResult(result).value();
  const auto read = unpackResult(payloadOf(bytesOf(payload), payload.header_bytes));
  ASSERT_TRUE(read);
  EXPECT_EQ(static_cast<int>(read->traces[0].record.rays[0].ray_class), 200);
}

TEST(Wire, WhatHasBeenReadIsNotKeptTwice) {
  JobResult result;
  result.images["lit"] = Image({512, 512}, {"R", "G", "B"});
  const Payload payload = packResult(std::move(result)).value();
  const auto kept_bytes = [&payload] {
    struct stat status = {};
    EXPECT_EQ(::fstat(payload.memory.get(), &status), 0);
    constexpr std::int64_t kBlock = 512;
    return status.st_blocks * kBlock;
  };
  constexpr std::int64_t kImageBytes = std::int64_t{512} * 512 * 3 * 4;
  EXPECT_GE(kept_bytes(), kImageBytes);
  ASSERT_TRUE(unpackResult(payload));
  EXPECT_LT(kept_bytes(), kImageBytes / 100);
}

TEST(Wire, APayloadThatIsNotAsLargeAsItSaysIsFoundOut) {
  Payload payload = packResult(sampleResult()).value();
  payload.bulk_bytes += 1;
  EXPECT_FALSE(hasDeclaredSize(payload));
  payload.bulk_bytes = ~std::uint64_t{0};
  EXPECT_FALSE(hasDeclaredSize(payload));
  payload.header_bytes = ~std::uint64_t{0};
  EXPECT_FALSE(hasDeclaredSize(payload));
  EXPECT_FALSE(hasDeclaredSize(Payload{OwnedFd(), 0, 0}));
}

}  // namespace ssrkit
