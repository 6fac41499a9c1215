import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import {
  ServiceError,
  sessionStatisticsTopic,
  SessionState,
  type ProcessingModule,
  type Session,
} from '@ubii/proto';
import { randomUuid } from '../../connection/random-uuid.ts';
import type { Findings } from '../measure/findings.ts';
import { wait, type TestRun } from '../measure/test-run.ts';
import type { Leavings } from '../run/leavings.ts';
import { openTestClient } from '../run/test-client.ts';
import { measureSpeed, type SpeedSession } from './measure-speed.ts';
import type { SpeedParameters } from './speed-parameters.ts';
import { speedSession, speedTopics } from './speed-session.ts';

const MODULE = 'load-generator';
const POLL_MS = 50;
/** Longer than the time that the master waits for nodes, milliseconds. [SE-12] */
const START_TIMEOUT_MS = 12_000;
/** Time for the last run to end, milliseconds. */
const RUN_OUT_MS = 300;
/** Rate of durations that suffices for a histogram, Hz: a free module has thousands per second. */
const DURATION_RATE_HZ = 200;

/** Node that runs the test, and client that starts it. */
export interface SpeedPlace {
  readonly nodeId: string;
  /** Id of the page's client, with which the session is tagged. */
  readonly ownerId: string;
}

/** Runs the session test with a separate client and session, which are removed afterwards. */
export async function runSpeed(
  parameters: SpeedParameters,
  { nodeId, ownerId }: SpeedPlace,
  leavings: Leavings,
  run: TestRun,
): Promise<Findings> {
  const { client, close } = await openTestClient('Session speed test', leavings);
  try {
    const topics = speedTopics(client.id);
    const duration = client.subscribe(topics.duration, {
      format: 'double',
      maxRateHz: DURATION_RATE_HZ,
    });
    const echo = client.subscribe(topics.echo, { format: 'double' });
    await Promise.all([duration.ready, echo.ready]);
    // The first publisher owns a topic, and its values are deleted when it leaves. [TD-19, TD-40]
    for (const topic of [topics.duration, topics.echo]) {
      client.publish(topic, 'double', 0, { immediate: true });
    }
    const start = async (): Promise<SpeedSession> => {
      const spec = speedSession(parameters, {
        ownerId,
        nodeId,
        topics,
        module: await loadGenerator(),
        uuid: randomUuid,
      });
      const { id } = await client.call('sessionRuntimeStart', spec);
      const leaving = { kind: 'session', id } as const;
      leavings.add(leaving);
      const remove = async (): Promise<void> => {
        // If removal fails, it is retried after the next connect or on the next visit.
        if (!(await isRemoved(client, id))) return;
        leavings.drop(leaving);
        // A run in progress still publishes [PM-29]: on a topic whose owner is gone, the value would stay.
        await new Promise<void>((resolve) => run.clock.after(RUN_OUT_MS, resolve));
      };
      try {
        await whenRunning(client, id, run);
      } catch (cause) {
        await remove();
        throw cause;
      }
      const statistics = client.subscribe(sessionStatisticsTopic(id), {
        format: 'sessionStatistics',
      });
      return {
        onStatistics: (fn) => void statistics.onRecord(({ value }) => fn(value)),
        onDuration: (fn) => void duration.onRecord(({ value }) => fn(value)),
        onEcho: (fn) => void echo.onRecord(({ value }) => fn(value)),
        stamp: (stamp) => client.publish(topics.stamp, 'double', stamp, { immediate: true }),
        remove,
      };
    };
    return await measureSpeed(parameters, { start }, run);
  } finally {
    await close();
  }
}

async function loadGenerator(): Promise<ProcessingModule> {
  const { moduleLibrary } = await import('@ubii/modules');
  const module = moduleLibrary().find(({ name }) => name === MODULE);
  if (module === undefined) throw new Error(`The library has no module ${MODULE}.`);
  return module;
}

async function isRemoved(client: UbiiClient, id: string): Promise<boolean> {
  try {
    await client.call('sessionRuntimeRemove', { id });
    return true;
  } catch (cause) {
    if (cause instanceof ConnectionError) return false;
    // Another client has removed it.
    if (cause instanceof ServiceError && cause.code === 'not_found') return true;
    throw cause;
  }
}

/** @throws {Error} with the reason why it does not run */
async function whenRunning(client: UbiiClient, id: string, run: TestRun): Promise<void> {
  const untilMs = run.clock.monotonicMs() + START_TIMEOUT_MS;
  for (;;) {
    const session = await client.call('sessionRuntimeGet', { id });
    const state = session.extension?.state;
    if (state === SessionState.SESSION_RUNNING || run.signal.aborted) return;
    if (state !== SessionState.SESSION_STARTING) throw new Error(troubleOf(session));
    if (run.clock.monotonicMs() > untilMs) throw new Error('The session did not start in time.');
    await wait(POLL_MS, run);
  }
}

function troubleOf({ extension }: Session): string {
  const sentence = extension?.problems[0]?.message;
  return `The session does not run. ${sentence ?? 'The master reports no reason.'}`;
}
