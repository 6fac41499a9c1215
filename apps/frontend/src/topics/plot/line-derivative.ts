import type { LinePoints } from '../history/series-ring.ts';

/** Most points with the same time that are skipped. */
const MAX_BACK = 16;

/** Returns the derivative of a line per second, at each point since the previous one. NaN where undefined. */
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
        // Records of a batch may have the same time: use the previous different one.
        if (beforeMs < timeMs) {
          return ((line.valueAt(index) - line.valueAt(i)) / (timeMs - beforeMs)) * 1000;
        }
      }
      return Number.NaN;
    },
  };
}
