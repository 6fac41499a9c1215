import type { Findings } from '../measure/findings.ts';
import type { TestRun } from '../measure/test-run.ts';
import type { Leavings } from '../run/leavings.ts';
import { openTestClient } from '../run/test-client.ts';
import { measureRoundTrip, type RoundTripParameters } from './measure-round-trip.ts';

/** Measures the round trip of this browser with a separate client, which is removed afterwards. */
export async function runRoundTrip(
  parameters: RoundTripParameters,
  publishIntervalMs: number,
  leavings: Leavings,
  run: TestRun,
): Promise<Findings> {
  const { client, close } = await openTestClient('Round-trip test', leavings, {
    publishIntervalMs,
  });
  try {
    const topic = `/${client.id}/performance/round-trip`;
    const subscription = client.subscribe(topic, { format: 'double' });
    await subscription.ready;
    return await measureRoundTrip(
      parameters,
      {
        publish: (sequence, way) =>
          client.publish(topic, 'double', sequence, { immediate: way === 'immediate' }),
        onEcho: (fn) => void subscription.onRecord(({ value }) => fn(value)),
      },
      run,
    );
  } finally {
    await close();
  }
}
