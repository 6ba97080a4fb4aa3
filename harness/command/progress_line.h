// One line on the terminal that says what is going on; nothing where standard error is no terminal.
#pragma once

#include <string>

namespace ssrkit {

class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const std::string& text);
  void clear();

 private:
  bool is_terminal_;
  bool is_shown_ = false;
};

}  // namespace ssrkit
