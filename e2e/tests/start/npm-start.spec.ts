import { spawn, type ChildProcess } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { mkdtemp, readdir, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';
import { expect, test } from '@playwright/test';
import type { MasterEndpoints } from '@ubii/harness';

const REPOSITORY = join(import.meta.dirname, '../../..');

// One after the other: each may build what is stale, in the same folders.
test.describe.configure({ mode: 'default' });
test.skip(process.platform === 'win32', 'signals');

let dataDir: string;
let npm: ChildProcess;

test.beforeEach(async () => {
  dataDir = await mkdtemp(join(tmpdir(), 'ubii-start-'));
});

test.afterEach(async () => {
  if (npm.exitCode === null && npm.signalCode === null) npm.kill('SIGKILL');
  await rm(dataDir, { recursive: true, force: true });
});

/** Starts the program as the README says and waits for its line of addresses. */
async function npmStart(...flags: string[]): Promise<MasterEndpoints> {
  npm = spawn(
    'npm',
    [
      ...['start', '--', '--lan', 'off', '--port', '0', '--legacy-ports', 'off'],
      ...['--data-dir', dataDir],
      ...['--print-endpoints', 'json', ...flags],
    ],
    // A group of its own, so that a signal can be sent to all of it, as a terminal does.
    { cwd: REPOSITORY, stdio: ['ignore', 'pipe', 'pipe'], detached: true },
  );
  let stderr = '';
  npm.stderr!.setEncoding('utf8').on('data', (text: string) => (stderr += text));
  return new Promise((resolve, reject) => {
    createInterface({ input: npm.stdout! }).on('line', (line) => {
      if (line.startsWith('{')) resolve(JSON.parse(line) as MasterEndpoints);
    });
    npm.once('exit', (code) => reject(new Error(`npm start ended with ${code}.\n${stderr}`)));
  });
}

/** Processes that were started, directly or not, by this one: [pid, command]. Linux only. */
async function descendantsOf(pid: number): Promise<[number, string][]> {
  const found: [number, string][] = [];
  const parents = new Set([pid]);
  const processes: [number, number, string][] = [];
  for (const entry of await readdir('/proc')) {
    const stat = await readFile(`/proc/${entry}/stat`, 'utf8').catch(() => undefined);
    const match = stat === undefined ? null : /^(\d+) \((.*)\) \S (\d+)/s.exec(stat);
    if (match) processes.push([Number(match[1]), Number(match[3]), match[2]!]);
  }
  for (const [child, parent, command] of processes.sort(([a], [b]) => a - b)) {
    if (!parents.has(parent)) continue;
    parents.add(child);
    found.push([child, command]);
  }
  return found;
}

function isAlive(pid: number): boolean {
  try {
    process.kill(pid, 0);
  } catch {
    return false;
  }
  // An orphaned process stays a zombie until process 1 reaps it, in containers forever.
  return process.platform !== 'linux' || !/^\d+ \(.*\) Z/s.test(readStat(pid));
}

function readStat(pid: number): string {
  try {
    return readFileSync(`/proc/${pid}/stat`, 'utf8');
  } catch {
    return `${pid} () Z`;
  }
}

const ENDINGS = [
  ['SIGTERM to npm', () => npm.kill('SIGTERM')],
  ['Ctrl-C in a terminal', () => process.kill(-npm.pid!, 'SIGINT')],
] as const;

for (const [ending, end] of ENDINGS) {
  test(`npm start serves the page, and ${ending} ends all of it within two seconds @smoke`, async () => {
    const endpoints = await npmStart();
    const page = await fetch(endpoints.url);
    expect(page.headers.get('content-type')).toContain('text/html');
    expect(await page.text()).toContain('<div id="app">');
    const reply = await fetch(endpoints.servicesJson, {
      method: 'POST',
      headers: { 'content-type': 'application/json' },
      body: '{"topic":"/services/server_configuration"}',
    });
    expect(await reply.json()).toHaveProperty('server.name');

    const all = process.platform === 'linux' ? await descendantsOf(npm.pid!) : [];
    if (process.platform === 'linux') expect(all.map(([pid]) => pid)).toContain(endpoints.pid);
    end();
    const remaining = () =>
      [[npm.pid!, 'npm'] as [number, string], ...all, [endpoints.pid, 'master'] as [number, string]]
        .filter(([pid]) => isAlive(pid))
        .map(([pid, command]) => `${pid} ${command}`);
    await expect.poll(remaining, { timeout: 2_000, intervals: [50] }).toEqual([]);
    await expect(fetch(endpoints.url)).rejects.toThrow();
  });
}

test('a wrong flag is answered with one sentence and no master', async () => {
  await expect(npmStart('--no-such-flag')).rejects.toThrow(/--no-such-flag/);
});
