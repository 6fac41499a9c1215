import { systemClock } from '@ubii/client-web';
import type { Clock } from '@ubii/pm-sandbox';

/** Time and turns of this page. */
export const browserClock: Clock = {
  ...systemClock,
  atEndOfTurn: (fn) => queueMicrotask(fn),
};
