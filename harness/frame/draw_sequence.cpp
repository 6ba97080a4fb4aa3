#include "frame/draw_sequence.h"

#include <fmt/format.h>

#include <utility>

#include "frame/frame_read_back.h"
#include "frame/history.h"

namespace ssrkit {

namespace {

// Tells the histories of a job's traces apart.
std::string ownerName(std::size_t trace) {
  return fmt::format("trace {}", trace);
}

Expected<void> readTrace(const SequenceDrawing& drawing, std::size_t index, JobResult& result) {
  const Tracing& trace = drawing.traces[index];
  drawing.progress("read back");
  if (index + 1 == drawing.traces.size()) {
    dropWhatStays(drawing.images, trace.imagesToRead());
  }
  auto read = trace.read(drawing.device, drawing.images);
  if (!read) {
    return tl::make_unexpected(read.error());
  }
  result.traces.push_back(std::move(*read));
  return {};
}

}  // namespace

Expected<void> drawSequence(const SequenceDrawing& drawing, int frame_count, int rounds, JobResult& result) {
  const auto& [device, images, frame_drawing, traces, values, progress, pose] = drawing;
  History history;
  history.watchFrame(frame_drawing.passes());
  for (std::size_t i = 0; i < traces.size(); ++i) {
    traces[i].watchHistory(history, ownerName(i));
  }
  auto done = history.clear(device, images);
  const int last = frame_count - 1;
  for (int frame = 0; done && frame <= last; ++frame) {
    done = pose(frame);
    const int more_rounds = frame == last ? rounds : 0;
    for (int round = 0; done && round <= more_rounds; ++round) {
      done = frame_drawing.draw(device, images, values, progress);
      for (std::size_t i = 0; done && i < traces.size(); ++i) {
        done = traces[i].draw(device, images, values, progress);
        if (done && frame < last) {
          done = history.keep(device, images, ownerName(i));
        } else if (done && round == more_rounds) {
          done = readTrace(drawing, i, result);
        }
      }
    }
    done = done && frame < last ? history.keep(device, images, "") : done;
  }
  return done;
}

}  // namespace ssrkit
