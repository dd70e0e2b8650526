// Tasks in processes of their own, so that one that crashes takes nobody along.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace sluice::app {

/// End of a task.
struct ChildEnd {
  std::string text;  ///< what it returned, or the message of what it threw
  int code = 0;      ///< 0, or 2 for InputError and 3 for any other exception
  int signal = 0;    ///< what killed it; 0 if nothing did
  double seconds = 0;
};

/// Does tasks 0 to `count` - 1, each in a child of this process and `jobs` >= 1 of them at a time. `done` is
/// called here with the end of each, in no particular order. Throws EnvironmentError when no process can be
/// made. To be called while this process has one thread.
void in_children(size_t count, int jobs, const std::function<std::string(size_t)>& task,
                 const std::function<void(size_t, const ChildEnd&)>& done);

}  // namespace sluice::app
