/** Explanations of figures, by the last part of their key. */
const MEANINGS: Readonly<Record<string, string>> = {
  p50: 'Median: half of the values were at least this fast.',
  p95: '95 of 100 values were at least this fast. Up to 20 ms is not noticeable. Up to 100 ms buttons feel direct, and what follows a hand trails behind it.',
  p99: '99 of 100 values were at least this fast. Far above p95 points to interruptions: other programs, wireless networks, garbage collection.',
  max: 'The slowest value. May be an outlier.',
  jitter:
    'Average difference between consecutive values. Small compared with p50 is good: motion looks smooth.',
  sent: 'Number of published records.',
  returned: 'Number of received records.',
  drawn: 'Number of records that were drawn.',
  lost: 'Number of records that were not received. Should be 0.',
};

/** Explanations by the whole key, where the last part is ambiguous. */
const OWN: Readonly<Record<string, string>> = {
  knee: 'Records per second of all clients that arrived before latency rose or records were lost. More is better; plan with half of it.',
  'knee.bytes': 'The same in bytes of delivered values.',
  'knee.p50': 'Median at that rate.',
  'knee.p95': '95 of 100 values were at least this fast at that rate.',
  'first.p50': 'Median at low load.',
  'first.p95':
    '95 of 100 values were at least this fast at low load. The knee is where it triples.',
  peak: 'Deliveries per second in the fastest step, including late ones.',
  lag: 'Delay of the timers of the load generator.',
  'lag.p95':
    'Delay of this browser itself. When it is close to the latency, the browser is the limit, not the system.',
  runs: 'Runs per second of all modules. In frequency mode it should be modules × frequency.',
  'runs.each': 'Runs per second of one module.',
  additions: 'Additions per second. Use it to compare nodes and modes.',
  'run.p50': 'Median run time of the slowest module, measured by the node.',
  'run.p95':
    '95 of 100 runs took no longer. Must be well below the period: 33 ms at 30 Hz, 16 ms at 60 Hz.',
  'pass.p50': 'Median time of one pass over all modules.',
  'pass.p95': '95 of 100 passes took no longer.',
  overruns: 'Runs that had not ended when the next one was due. Should be 0.',
  errors: 'Runs that failed. Should be 0.',
  'work.p50': 'The additions alone, without the sandbox of the module.',
  'work.p95': 'The same, for 95 of 100 runs.',
  'echo.p50': 'From publishing an input to receiving the output that uses it.',
  'echo.p95':
    'The same, for 95 of 100 values. In frequency mode it includes half a period of waiting.',
  'echo.p99': 'The same, for 99 of 100 values.',
  start: 'From the request until all modules run.',
  'total.p50': 'From publishing to the frame that draws the value, median.',
  'received.p50': 'From this page to the master and back.',
  'received.p95': 'The same, for 95 of 100 values.',
  'waited.p50': 'Waiting time for the next frame. Half a frame is normal.',
  'waited.p95':
    'The same, for 95 of 100 values. One frame is normal; more means that the page is busy.',
  'frame.p50': 'From one frame to the next. 16.7 ms is 60 frames per second.',
  'frame.p95': 'Far above p50 means that frames were skipped.',
};

/** `load` reports lost records in percent. */
const OWN_UNITS: Readonly<Record<string, string>> = {
  '%': 'The worst step of the ramp. Should be 0 up to the knee.',
};

export function figureMeaning({
  key,
  unit,
}: {
  readonly key: string;
  readonly unit: string;
}): string {
  const end = key.slice(key.lastIndexOf('.') + 1);
  return OWN[key] ?? OWN_UNITS[unit] ?? MEANINGS[end] ?? '';
}
