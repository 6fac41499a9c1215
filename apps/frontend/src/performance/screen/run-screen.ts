import type { Findings } from '../measure/findings.ts';
import type { TestRun } from '../measure/test-run.ts';
import type { Leavings } from '../run/leavings.ts';
import { openTestClient } from '../run/test-client.ts';
import { measureScreen, type ScreenParameters } from './measure-screen.ts';

/** Measures publishing to display in this page with a separate client, which is removed afterwards. */
export async function runScreen(
  parameters: ScreenParameters,
  draw: (value: number) => void,
  leavings: Leavings,
  run: TestRun,
): Promise<Findings> {
  const { client, close } = await openTestClient('Topic-to-screen test', leavings);
  try {
    const topic = `/${client.id}/performance/screen`;
    const subscription = client.subscribe(topic, { format: 'double' });
    await subscription.ready;
    return await measureScreen(
      parameters,
      {
        publish: (value) => client.publish(topic, 'double', value, { immediate: true }),
        onValue: (fn) => void subscription.onRecord(({ value }) => fn(value)),
        draw,
        nextFrame: (fn) => void requestAnimationFrame(fn),
        random: Math.random,
      },
      run,
    );
  } finally {
    await close();
  }
}
