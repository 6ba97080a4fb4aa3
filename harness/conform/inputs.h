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

// What one cell's answers come from.
struct CellInputs {
  std::string id;
  std::filesystem::path test_file;
  std::filesystem::path scene_file;
  std::filesystem::path goldens;        // the folder of those that the cell is held against; empty: none
  std::vector<DeviceIdentity> devices;  // that it is drawn on and held against
};

class InputHasher {
 public:
  // Reads the program and the shaders at once: a hundredth of a second or so.
  [[nodiscard]] static Expected<InputHasher> create(const std::filesystem::path& program,
                                                    const std::filesystem::path& shader_root);

  // Of one cell: its id, the test's file, every file that the scene is read from, the goldens, and who the
  // devices are. A file that the scene names need not be there; any other that cannot be read is an Error.
  [[nodiscard]] Expected<std::string> inputs(const CellInputs& cell);

 private:
  [[nodiscard]] Expected<std::string> ofFile(const std::filesystem::path& file);
  [[nodiscard]] Expected<std::string> ofFolder(const std::filesystem::path& folder);
  [[nodiscard]] std::string ofScene(const std::filesystem::path& scene_file);
  [[nodiscard]] Expected<std::string> ofGoldens(const std::filesystem::path& folder);
  [[nodiscard]] Expected<std::string> ofFiles(const std::vector<std::filesystem::path>& files,
                                              const std::filesystem::path& folder);

  std::string kit_;
  std::map<std::filesystem::path, std::string> known_;   // by file or folder
  std::map<std::filesystem::path, std::string> scenes_;  // by the scene's file, with all that it names
};

}  // namespace ssrkit
