import type { LinePoints } from '../history/series-ring.ts';

/** Points at the same moment are passed over, so many at most. */
const MAX_BACK = 16;

/** How fast a line changes, per second: at each point since the one before it. NaN where nobody can tell. */
export function derivativeOf(line: LinePoints): LinePoints {
  return {
    get size() {
      return line.size;
    },
    get pushed() {
      return line.pushed;
    },
    timeAt: (index) => line.timeAt(index),
    indexAtOrAfter: (timeMs) => line.indexAtOrAfter(timeMs),
    valueAt(index) {
      const timeMs = line.timeAt(index);
      for (let i = index - 1; i >= 0 && i >= index - MAX_BACK; i--) {
        const beforeMs = line.timeAt(i);
        // Records of one bundle may bear the same time: the one before them says how fast.
        if (beforeMs < timeMs) {
          return ((line.valueAt(index) - line.valueAt(i)) / (timeMs - beforeMs)) * 1000;
        }
      }
      return Number.NaN;
    },
  };
}
