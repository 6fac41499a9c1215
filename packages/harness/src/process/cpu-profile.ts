/** Between two samples: what holds a thread for half a millisecond has some. */
const INTERVAL_US = 200;

/** Returns flags of Node that write a CPU profile of the whole run when the program stops. */
export function cpuProfileFlags(folder: string | undefined, name: string): readonly string[] {
  if (folder === undefined) return [];
  const interval = `--cpu-prof-interval=${INTERVAL_US}`;
  return ['--cpu-prof', interval, `--cpu-prof-dir=${folder}`, `--cpu-prof-name=${name}.cpuprofile`];
}
