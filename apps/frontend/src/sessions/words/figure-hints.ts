/** Explanations of the figures of modules and sessions, by their labels. */
export const FIGURE_HINTS: Readonly<Record<string, string>> = {
  'Runs/s': 'Runs of the module per second.',
  p50: 'Median run time: half of the runs take at most this long.',
  p95: '95 of 100 runs take at most this long.',
  Waiting: 'Triggers that wait for the current run or for the minimum delay.',
  Errors: 'Runs that ended with an error.',
  Overruns:
    'Runs skipped because the previous run had not ended: it took too long, or its node was too busy. The log shows the reason.',
  Refused: 'Outputs that were refused: over a limit, in a wrong format, or without parameters.',
  Restarts: 'Number of restarts after the module was killed.',
  Memory: 'Memory that the module uses.',
};
