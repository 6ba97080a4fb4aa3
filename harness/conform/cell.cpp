#include "conform/cell.h"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>

namespace ssrkit {

namespace {

bool isPlain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '.' || c == '_' || c == '-';
}

std::string plain(std::string name) {
  for (char& c : name) {
    if (c >= 'A' && c <= 'Z') {
      c = static_cast<char>(c - 'A' + 'a');
    } else if (!isPlain(c)) {
      c = '-';
    }
  }
  // "." and ".." would climb about in the folder of results.
  return std::ranges::all_of(name, [](char c) { return c == '.'; }) ? "-" + name : name;
}

}  // namespace

std::string groupId(const Cell& cell) {
  return fmt::format("{}/{}/{}x{}", plain(cell.test), plain(cell.scene), cell.size.width, cell.size.height);
}

std::string cellId(const Cell& cell) {
  return groupId(cell) + "/" + plain(cell.device);
}

bool matchesCell(const std::string& glob, const std::string& id) {
  for (std::size_t end = id.find('/'); end != std::string::npos; end = id.find('/', end + 1)) {
    if (fnmatch(glob.c_str(), id.substr(0, end).c_str(), 0) == 0) {
      return true;
    }
  }
  return fnmatch(glob.c_str(), id.c_str(), 0) == 0;
}

}  // namespace ssrkit
