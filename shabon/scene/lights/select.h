// `condition ? yes : no`, also for many numbers at once: the packets have their own.
#pragma once

namespace shabon::scene {

inline double select(bool condition, double yes, double no) { return condition ? yes : no; }

}  // namespace shabon::scene
