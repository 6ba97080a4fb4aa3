#include "base/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "../temporary_folder.h"

namespace ssrkit {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

std::string contentOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::ptrdiff_t entriesIn(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

// Runs `body` in a forked child, where limits and privileges may be given up, and returns its exit code.
template <class Body>
int exitCodeOfChild(const Body& body) {
  const pid_t child = fork();
  if (child == 0) {
    _exit(body());
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(WriteFileAtomically, CreatesParentsAndReplacesAnOlderFile) {
  const TemporaryFolder folder;
  const fs::path path = folder / "a/b/results.json";
  ASSERT_TRUE(writeFileAtomically(path, "old"));
  ASSERT_TRUE(writeFileAtomically(path, std::string("new\0bytes", 9)));
  EXPECT_EQ(contentOf(path), std::string("new\0bytes", 9));
  EXPECT_EQ(entriesIn(path.parent_path()), 1);
}

TEST(WriteFileAtomically, GivesTheWriterANameBesideTheTargetWithItsExtension) {
  const TemporaryFolder folder;
  const fs::path path = folder / "hit.exr";
  fs::path seen;
  ASSERT_TRUE(writeFileAtomically(path, [&](const fs::path& temporary) -> Expected<void> {
    seen = temporary;
    EXPECT_FALSE(fs::exists(path));
    std::ofstream(temporary) << "texels";
    return {};
  }));
  EXPECT_EQ(seen.extension(), ".exr");
  EXPECT_EQ(seen.parent_path(), folder.path());
  EXPECT_NE(seen.string().find(std::to_string(getpid())), std::string::npos);
  EXPECT_EQ(contentOf(path), "texels");
}

TEST(WriteFileAtomically, LeavesTheOldFileAndNoOtherWhenTheWriterFails) {
  const TemporaryFolder folder;
  const fs::path path = folder / "hit.exr";
  ASSERT_TRUE(writeFileAtomically(path, "old"));
  const auto written = writeFileAtomically(path, [](const fs::path& temporary) -> Expected<void> {
    std::ofstream(temporary) << "half";
    return setupError("encode", "no");
  });
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().attempted, "encode");
  EXPECT_EQ(contentOf(path), "old");
  EXPECT_EQ(entriesIn(folder.path()), 1);
}

// A file size limit makes write(2) fail half-way, as a full disk does.
TEST(WriteFileAtomically, RemovesTheHalfWhenTheDiskIsFull) {
  const TemporaryFolder folder;
  const fs::path path = folder / "big.bin";
  const int code = exitCodeOfChild([&] {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4096, 4096};
    setrlimit(RLIMIT_FSIZE, &limit);
    const auto written = writeFileAtomically(path, std::string(10000, 'x'));
    const bool told = !written && sentence(written.error()).find("EFBIG") != std::string::npos &&
                      sentence(written.error()).find("big.bin") != std::string::npos &&
                      exitCode(written.error()) == 3;
    return told ? 0 : 1;
  });
  EXPECT_EQ(code, 0);
  EXPECT_EQ(entriesIn(folder.path()), 0);
}

TEST(WriteFileAtomically, NamesAFolderThatIsReadOnly) {
  const TemporaryFolder folder;
  ASSERT_EQ(chmod(folder.path().c_str(), 0555), 0);
  const int code = exitCodeOfChild([&] {
    constexpr uid_t kNobody = 65534;
    if (geteuid() == 0 && setuid(kNobody) != 0) {
      return 2;  // root may write everywhere
    }
    const auto written = writeFileAtomically(folder / "a.txt", "x");
    const std::string text = written ? "" : sentence(written.error());
    return text.find("Permission denied (EACCES)") != std::string::npos && exitCode(written.error()) == 3 ? 0
                                                                                                          : 1;
  });
  EXPECT_EQ(code, 0);
}

TEST(WriteFileAtomically, NamesTheFileThatStandsWhereAFolderIsNeeded) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeFileAtomically(folder / "plain", "x"));
  const auto written = writeFileAtomically(folder / "plain/deeper/a.txt", "x");
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().problem.find("Not a directory (ENOTDIR)"), std::string::npos);
  EXPECT_NE(written.error().remedy.find((folder / "plain").string() + "'"), std::string::npos);
}

TEST(WriteFileAtomically, RefusesToReplaceAFolderOrAPipe) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "sub");
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_FALSE(writeFileAtomically(folder / "sub", "x"));
  EXPECT_FALSE(writeFileAtomically(folder / "pipe", "x"));
  EXPECT_FALSE(writeFileAtomically(folder.path() / "", "x"));
  EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
  EXPECT_EQ(entriesIn(folder.path()), 2);
}

TEST(WriteFileAtomically, TakesEveryNameThatTheFileSystemTakes) {
  const TemporaryFolder folder;
  EXPECT_TRUE(writeFileAtomically(folder / std::string(255, 'n'), "x"));
  EXPECT_TRUE(writeFileAtomically(folder / (std::string(251, 'n') + ".exr"), "x"));
  EXPECT_TRUE(writeFileAtomically(folder / ("a." + std::string(253, 'e')), "x"));
  const auto too_long = writeFileAtomically(folder / std::string(256, 'n'), "x");
  ASSERT_FALSE(too_long);
  EXPECT_NE(too_long.error().problem.find("ENAMETOOLONG"), std::string::npos);
  std::string deep_path;
  for (int i = 0; i < 3000; ++i) {
    deep_path += "d/";
  }
  EXPECT_FALSE(writeFileAtomically(folder / (deep_path + "file"), "x"));
}

TEST(RemoveUnfinishedFiles, RemovesAWriteUnderWayFromASignalHandler) {
  const TemporaryFolder folder;
  const int code = exitCodeOfChild([&] {
    signal(SIGUSR1, [](int) {
      removeUnfinishedFiles();
      _exit(7);
    });
    const auto written =
        writeFileAtomically(folder / "a.exr", [](const fs::path& temporary) -> Expected<void> {
          std::ofstream(temporary) << "half";
          raise(SIGUSR1);
          return {};
        });
    return written ? 1 : 2;
  });
  EXPECT_EQ(code, 7);
  EXPECT_EQ(entriesIn(folder.path()), 0);
}

TEST(RemoveUnfinishedFiles, LeavesTheFilesOfTheParentProcess) {
  const TemporaryFolder folder;
  const fs::path path = folder / "a.exr";
  ASSERT_TRUE(writeFileAtomically(path, [](const fs::path& temporary) -> Expected<void> {
    std::ofstream(temporary) << "parent's";
    EXPECT_EQ(exitCodeOfChild([] {
                removeUnfinishedFiles();
                return 0;
              }),
              0);
    return {};
  }));
  EXPECT_EQ(contentOf(path), "parent's");
}

TEST(ReadFile, GivesTheBytesBack) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\r\n\xff", 6);
  ASSERT_TRUE(writeFileAtomically(folder / "f", bytes));
  EXPECT_EQ(readFile(folder / "f").value(), bytes);
  EXPECT_EQ(readFile(folder / "f", 6).value(), bytes);
}

TEST(ReadFile, RefusesMissingFilesFoldersPipesDevicesAndLargeFilesWithoutHanging) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  ASSERT_TRUE(writeFileAtomically(folder / "seven", "1234567"));
  const auto problemOf = [](const Expected<std::string>& file) { return file ? "" : file.error().problem; };
  EXPECT_EQ(problemOf(readFile(folder / "none")), "there is no such file");
  EXPECT_EQ(problemOf(readFile(folder.path())), "it is a folder");
  EXPECT_EQ(problemOf(readFile(folder / "pipe")), "it is a device or a pipe");
  EXPECT_EQ(problemOf(readFile("/dev/zero")), "it is a device or a pipe");
  EXPECT_EQ(problemOf(readFile(folder / "seven", 6)), "it is larger than the limit of 6 bytes");
  EXPECT_EQ(exitCode(readFile(folder / "none").error()), 2);
}

}  // namespace
}  // namespace ssrkit
