import { execFileSync, spawn } from 'node:child_process';
import type { ChildProcess } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const builder = fileURLToPath(new URL('../../../apps/master/build.mjs', import.meta.url));
const outputFolder = fileURLToPath(new URL('../.cache/', import.meta.url));

/** Builds the master from its sources, away from where others build it. */
export function buildMaster(): void {
  execFileSync(process.execPath, [builder, outputFolder], { stdio: 'inherit' });
}

/** A master in a process of its own. */
export interface SpawnedMaster {
  readonly url: string;
  readonly servicesJson: string;
  readonly topicDataWs: string;
  /** Ends the process as a crash would, and frees the port. */
  kill(): Promise<void>;
}

/** A folder for the data of masters, and what removes it. */
export function createDataFolder(): { readonly path: string; remove(): void } {
  const path = mkdtempSync(join(tmpdir(), 'ubii-client-test-'));
  return { path, remove: () => rmSync(path, { recursive: true, force: true }) };
}

/** Starts the master that was built. @param port 0 for any free one */
export async function spawnMaster(dataFolder: string, port = 0): Promise<SpawnedMaster> {
  const flags = [
    ...['--lan', 'off', '--port', String(port), '--legacy-ports', 'off'],
    ...['--print-endpoints', 'json', '--trust-loopback'],
  ];
  const child = spawn(
    process.execPath,
    [join(outputFolder, 'main.js'), ...flags, '--data-dir', dataFolder],
    { stdio: ['ignore', 'pipe', 'pipe'] },
  );
  const endpoints = await firstLine(child);
  return {
    ...(JSON.parse(endpoints) as Pick<SpawnedMaster, 'url' | 'servicesJson' | 'topicDataWs'>),
    kill: () =>
      new Promise((resolve) => {
        if (child.exitCode !== null || child.signalCode !== null) return resolve();
        child.once('exit', () => resolve());
        child.kill('SIGKILL');
      }),
  };
}

function firstLine(child: ChildProcess): Promise<string> {
  return new Promise((resolve, reject) => {
    let out = '';
    let err = '';
    child.stdout?.on('data', (data: Buffer) => {
      out += data.toString();
      if (out.includes('\n')) resolve(out.slice(0, out.indexOf('\n')));
    });
    child.stderr?.on('data', (data: Buffer) => (err += data.toString()));
    child.once('exit', (code) => reject(new Error(`the master ended with ${code}: ${err}`)));
  });
}
