// A hash of everything that decides a cell's answers, so that an earlier result is used again only when it is
// still true.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/error.h"
#include "device/device.h"

namespace ssrkit {

class InputHasher {
 public:
  // Reads the program and the shaders at once: a hundredth of a second or so.
  [[nodiscard]] static Expected<InputHasher> create(const std::filesystem::path& program,
                                                    const std::filesystem::path& shader_root);

  // Of one cell: its id, the test's file, what lies beside the scene's (buffers, pictures, TOML), and who the
  // devices are that it is drawn on and held against.
  [[nodiscard]] Expected<std::string> inputs(const std::string& cell_id,
                                             const std::filesystem::path& test_file,
                                             const std::filesystem::path& scene_file,
                                             const std::vector<DeviceIdentity>& devices);

 private:
  [[nodiscard]] Expected<std::string> ofFile(const std::filesystem::path& file);
  [[nodiscard]] Expected<std::string> ofFolder(const std::filesystem::path& folder);
  [[nodiscard]] Expected<std::string> ofScene(const std::filesystem::path& scene_file);
  [[nodiscard]] Expected<std::string> ofFiles(const std::vector<std::filesystem::path>& files,
                                              const std::filesystem::path& folder);

  std::string kit_;
  std::map<std::filesystem::path, std::string> known_;
};

}  // namespace ssrkit
