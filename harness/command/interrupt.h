// Ctrl-C and its kin: children are ended, unfinished files removed, nothing else of the run is touched.
#pragma once

namespace ssrkit {

void endCleanlyOnSignals();

}  // namespace ssrkit
