import { createPageClock } from '@ubii/client-web/processing';

/** Clock for pictures, which keeps its rate in background tabs, such as behind the session's graph. */
export const pictureClock = createPageClock();
