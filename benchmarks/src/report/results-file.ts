import { mkdir, readFile, writeFile } from 'node:fs/promises';
import { dirname } from 'node:path';
import type { RunResult } from './results.ts';

/** Writes a run as JSON, with its directory. */
export async function writeRun(path: string, run: RunResult): Promise<void> {
  await mkdir(dirname(path), { recursive: true });
  await writeFile(path, `${JSON.stringify(run, null, 2)}\n`);
}

/**
 * Reads a run that `writeRun` wrote.
 *
 * @throws Error with one sentence when there is none at `path`.
 */
export async function readRun(path: string): Promise<RunResult> {
  let text: string;
  try {
    text = await readFile(path, 'utf8');
  } catch {
    throw new Error(`There is no readable file ${path}.`);
  }
  let run: Partial<RunResult> | null;
  try {
    run = JSON.parse(text) as Partial<RunResult> | null;
  } catch {
    throw new Error(`${path} is not JSON.`);
  }
  if (run?.formatVersion !== 1) throw new Error(`${path} is no benchmark result of format 1.`);
  return run as RunResult;
}
