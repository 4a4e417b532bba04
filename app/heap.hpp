// The process's memory, laid out for what the command does: big arrays, one after the other, and an end.
#pragma once

namespace lustro::app {

/// Asks the system's allocator to keep what is given back and to take the first half gigabyte from huge pages. A fresh page costs more than what
/// most loops do with it, and a picture of a small mesh is drawn in the time of some thousand of them. To be called first, where it can be;
/// nothing depends on it.
void prepare_heap();

/// Gives the system back what is free: before a long time in which little is done.
void give_back_heap();

}  // namespace lustro::app
