// Ctrl-C as a wish: what was asked for is written up to there.
#pragma once

namespace sluice::app {

/// From here on SIGINT, SIGTERM and SIGHUP don't end the program but are remembered.
void note_interrupts();
bool interrupted();

}  // namespace sluice::app
