/** What a figure means and what is good, by the end of its key. */
const MEANINGS: Readonly<Record<string, string>> = {
  p50: 'Half of them were at least this fast: what is usual.',
  p95: '95 of 100 were at least this fast. This is what people feel; up to 20 ms nobody notices, up to 100 ms it still feels direct.',
  p99: '99 of 100 were at least this fast. Far above p95 means hiccups: other programs, wireless networks, collection of garbage.',
  max: 'The one slowest. One alone says little.',
  jitter:
    'How much one differs from the next, on average. Small beside p50 is good: motion looks smooth.',
  sent: 'How many were published.',
  returned: 'How many came back.',
  drawn: 'How many reached the screen.',
  lost: 'How many never came. 0 is what it should be.',
};

/** Where the whole key says more than its end. */
const OWN: Readonly<Record<string, string>> = {
  knee: 'Records a second, all clients together, that got through before latency rose or records were lost. More is better; plan with half of it.',
  'knee.bytes': 'What that is in bytes of values delivered.',
  'knee.p50': 'What is usual at that rate.',
  'knee.p95': 'What people feel at that rate.',
  'first.p50': 'What is usual when little is going on.',
  'first.p95': 'What is felt when little is going on: the knee is where it triples.',
  peak: 'Deliveries a second in the fastest step, late or not.',
  lag: 'How late timers of the load generator were.',
  'lag.p95':
    'How late this browser itself was. When it is near the latency, the browser is the limit, not the system.',
  runs: 'Runs a second of all modules together. With frequency it should be modules × frequency.',
  'runs.each': 'Runs a second of one module.',
  additions: 'Work done a second. It compares places and modes with each other.',
  'run.p50': 'What a run usually takes, as the node measures it, of the slowest module.',
  'run.p95':
    'Most runs take no longer. It must be well below the pause between two runs: 33 ms at 30 Hz, 16 ms at 60 Hz.',
  'pass.p50': 'What one pass over all modules usually takes.',
  'pass.p95': 'Most passes take no longer.',
  overruns: 'Runs that were not over when the next was due. 0 is what it should be.',
  errors: 'Runs that failed. 0 is what it should be.',
  'work.p50': 'The additions alone, without the wall around the module.',
  'work.p95': 'The same for most runs.',
  'echo.p50':
    'From publishing an input until the output that uses it is here: there, through the module, and back.',
  'echo.p95': 'The same for most. With frequency, half a period of waiting is part of it.',
  'echo.p99': 'The same for nearly all.',
  start: 'From the request until all modules ran.',
  'total.p50': 'From publishing until the frame that draws it: what is usual.',
  'received.p50': 'The way to the master and back to this page.',
  'received.p95': 'The same for most.',
  'waited.p50': 'How long a value waits in the page for the next frame: half a frame is normal.',
  'waited.p95': 'The same for most: one frame is normal, more means the page is busy.',
  'frame.p50': 'From one frame to the next: 16.7 ms is 60 frames a second.',
  'frame.p95': 'Far above p50 means that frames were left out.',
};

/** `load` counts lost records in percent. */
const OWN_UNITS: Readonly<Record<string, string>> = {
  '%': 'The worst step of the ramp. Up to the knee it is 0.',
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
