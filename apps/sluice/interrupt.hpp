// Ctrl-C as a wish: what was asked for is written up to there.
#pragma once

namespace sluice::app {

/// Remembers SIGINT, SIGTERM and SIGHUP from now on, which then don't end the program.
void note_interrupts();
bool interrupted();

}  // namespace sluice::app
