import { shallowRef } from 'vue';
import type { Check } from './check.ts';
import { openChecks } from './check.ts';
import { runPreflight } from './run-preflight.ts';

/** Results of the preflight of this device, each as soon as it is known. A run continues after the page is left. */
export function usePreflight() {
  const checks = shallowRef<readonly Check[]>(openChecks());
  const isRunning = shallowRef(false);
  let run = 0;

  function put(check: Check): void {
    checks.value = checks.value.map((one) => (one.id === check.id ? check : one));
  }

  let last: Promise<void>;

  async function measure(): Promise<void> {
    run += 1;
    const own = run;
    isRunning.value = true;
    await runPreflight((check) => {
      if (own === run) put(check);
    });
    if (own === run) isRunning.value = false;
  }

  function start(): Promise<void> {
    last = measure();
    return last;
  }

  void start();
  return { checks, isRunning, put, start, done: () => last };
}
