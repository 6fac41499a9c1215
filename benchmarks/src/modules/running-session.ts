import { setTimeout as sleep } from 'node:timers/promises';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import type { MasterProcess } from '@ubii/harness';
import {
  SERVICES,
  SessionState,
  decode,
  encode,
  toJson,
  type Init,
  type Session,
  type ProcessingModule,
} from '@ubii/proto';

const POLL_MS = 20;
const MAX_PROBLEMS = 3;
const START_TIMEOUT_MS = 15_000;

/** A session whose modules all run. */
export interface RunningSession {
  readonly id: string;
  /** Ends it and forgets it. */
  stop(): Promise<void>;
}

/** @throws Error with the session's problems when not all of its modules come to run */
export async function startSession(
  master: MasterProcess,
  session: Init<Session>,
): Promise<RunningSession> {
  const reply = await master.call({ topic: SERVICES.sessionRuntimeStart.topic, session });
  const id = reply.session?.id;
  if (id === undefined) throw new Error('The master started no session.');
  const stop = async (): Promise<void> => {
    await master.call({ topic: SERVICES.sessionRuntimeStop.topic, session: { id } });
    await master.call({ topic: SERVICES.sessionRuntimeRemove.topic, session: { id } });
  };
  const untilMs = performance.now() + START_TIMEOUT_MS;
  for (;;) {
    const { session: now } = await master.call({
      topic: SERVICES.sessionRuntimeGet.topic,
      session: { id },
    });
    const state = now?.extension?.state;
    if (state === SessionState.SESSION_RUNNING) break;
    if (state !== SessionState.SESSION_STARTING || performance.now() > untilMs) {
      const problems = new Set(now?.extension?.problems.map(({ message }) => message));
      await stop();
      const first = [...problems].slice(0, MAX_PROBLEMS).join(' ');
      throw new Error(`The session ${session.name} does not run: ${first}`);
    }
    await sleep(POLL_MS);
  }
  return { id, stop };
}

/** A folder of modules as an operator vouches for. */
interface ModuleFolder {
  readonly path: string;
  stop(): Promise<void>;
}

const MODULE = 'ubii.processing.ProcessingModule';

export async function writeModuleFolder(
  modules: readonly Init<ProcessingModule>[],
): Promise<ModuleFolder> {
  const path = await mkdtemp(join(tmpdir(), 'ubii-bench-modules-'));
  for (const module of modules) {
    const json = toJson(MODULE, decode(MODULE, encode(MODULE, module)));
    await writeFile(join(path, `${module.name}.pm`), JSON.stringify(json));
  }
  return { path, stop: () => rm(path, { recursive: true, force: true }) };
}
