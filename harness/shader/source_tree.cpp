#include "shader/source_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "base/atomic_file.h"
#include "shader/glsl_text.h"
#include "shader/virtual_root.h"

namespace ssrkit {

namespace {

namespace fs = std::filesystem;

Expected<std::string> readText(const fs::path& path) {
  std::error_code code;
  if (const std::uintmax_t size = fs::file_size(path, code); !code && size > kSourceLimitBytes) {
    return inputError(
        "", fmt::format("it has {} bytes, more than the {} that a shader may have", size, kSourceLimitBytes));
  }
  return readFile(path, kSourceLimitBytes).and_then(normaliseText);
}

constexpr int kIncludeLimit = 1000;

class Reader {
 public:
  explicit Reader(const VirtualRoot& root) : root_(root) {}

  [[nodiscard]] Expected<SourceTree> read(const std::string& attempted) {
    Expected<std::size_t> entry = add(root_.entry());
    if (!entry) {
      return inputError(attempted, entry.error().problem, shownPath(root_.entry()));
    }
    // Files are appended while the list is walked, so nothing here holds a reference across add().
    for (std::size_t i = 0; i < tree_.files.size(); ++i) {
      std::vector<IncludeEdge> edges;
      for (IncludeLine& include : findIncludeLines(tree_.files[i].text)) {
        edges.push_back(follow(std::move(include), tree_.files[i].path.parent_path()));
      }
      tree_.files[i].includes = std::move(edges);
    }
    return std::move(tree_);
  }

 private:
  [[nodiscard]] IncludeEdge follow(IncludeLine include, const fs::path& folder) {
    IncludeEdge edge{std::move(include.name), include.line, std::nullopt, {}};
    if (++include_count_ > kIncludeLimit) {
      edge.refusal = fmt::format("there are more than {} includes in all", kIncludeLimit);
      return edge;
    }
    const Expected<fs::path> path = root_.resolve(edge.name, folder);
    if (!path) {
      edge.refusal = path.error().problem;
      return edge;
    }
    const Expected<std::size_t> index = add(*path);
    if (index) {
      edge.target = *index;
    } else {
      edge.refusal = fmt::format("'{}' cannot be included: {}", edge.name, index.error().problem);
    }
    return edge;
  }

  [[nodiscard]] Expected<std::size_t> add(const fs::path& path) {
    const auto known = std::find_if(tree_.files.begin(), tree_.files.end(),
                                    [&path](const SourceFile& file) { return file.path == path; });
    if (known != tree_.files.end()) {
      return static_cast<std::size_t>(known - tree_.files.begin());
    }
    Expected<std::string> text = readText(path);
    if (!text) {
      return tl::make_unexpected(text.error());
    }
    if (total_bytes_ + text->size() > kSourceLimitBytes) {
      return inputError(
          "", fmt::format("with its includes the shader has more than {} bytes", kSourceLimitBytes));
    }
    total_bytes_ += text->size();
    tree_.files.push_back({path, shownPath(path), std::move(*text), {}});
    return tree_.files.size() - 1;
  }

  const VirtualRoot& root_;
  SourceTree tree_;
  std::size_t total_bytes_ = 0;
  int include_count_ = 0;
};

bool isBlankText(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); });
}

}  // namespace

Expected<SourceTree> readSourceTree(const ShaderSource& source, const std::string& attempted) {
  const Expected<VirtualRoot> root = VirtualRoot::open(source, attempted);
  if (!root) {
    return tl::make_unexpected(root.error());
  }
  Expected<SourceTree> tree = Reader(*root).read(attempted);
  if (tree && isBlankText(tree->files.front().text)) {
    return inputError(attempted, "the file is empty", tree->files.front().shown_path);
  }
  return tree;
}

std::string shownPath(const std::filesystem::path& path) {
  std::error_code code;
  const fs::path here = fs::current_path(code);
  const fs::path relative = code ? fs::path() : path.lexically_relative(here);
  return relative.empty() || *relative.begin() == ".." ? path.string() : relative.string();
}

}  // namespace ssrkit
