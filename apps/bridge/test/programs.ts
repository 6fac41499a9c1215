import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { createClient, createMemoryIdentity } from '@ubii/client-web/node';
import type { UbiiClient } from '@ubii/client-web/node';
import { MasterProcess, type MasterStart } from '@ubii/harness';
import { RunningProgram, temporaryFolder } from '@ubii/program/testing';
import { onTestFinished } from 'vitest';
import { bridgeProgram, masterProgram } from './build-programs.ts';

/** What a program says when it is ready. */
export interface Printed {
  readonly id: string;
  readonly name: string;
}

/** Starts a master, which ends with the test. */
export async function startMaster(start: MasterStart = {}): Promise<MasterProcess> {
  const master = await MasterProcess.start({ program: masterProgram, ...start });
  onTestFinished(() => master.dispose());
  return master;
}

/** Writes a mapping file. @returns its path */
export function mappingFile(
  content: object,
  file = join(temporaryFolder(), 'bridge.json'),
): string {
  writeFileSync(file, JSON.stringify({ version: 1, ...content }));
  return file;
}

/** Starts a bridge. @param target address of the other system, and flags */
export function startBridge(
  target: readonly string[],
  master: string,
  mapping: string,
  env: Record<string, string> = {},
): RunningProgram {
  const flags = [...target, '--master', master, '--mapping', mapping, '--print-endpoints', 'json'];
  return new RunningProgram(bridgeProgram, flags, { env });
}

/** A client of the test. */
export async function joinAs(url: string, name = 'guest'): Promise<UbiiClient> {
  const client = createClient({
    url,
    name,
    identity: createMemoryIdentity(),
    publishIntervalMs: 0,
  });
  onTestFinished(() => client.close());
  await client.connect();
  return client;
}
