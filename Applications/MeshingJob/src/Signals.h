#pragma once

namespace moserhex::app
{

/** SIGINT, SIGTERM and SIGHUP remove the parts of files being written and then end the program as they always do.
 * SIGXFSZ is ignored, so that a limit on file sizes comes back as a write error like a full disk. */
void
installSignalHandlers();

} // namespace moserhex::app
