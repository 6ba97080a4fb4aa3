// The rows of an image on several threads.
#pragma once

#include <functional>

namespace ssrkit {

// Calls `work(y)` once for each row, from up to `thread_count` threads at once (0: one for each core), this
// one among them. Rows are handed out one by one: long and short rays lie in different parts of the image.
void forEachRow(int height, int thread_count, const std::function<void(int)>& work);

}  // namespace ssrkit
