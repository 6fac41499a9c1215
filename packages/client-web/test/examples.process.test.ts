import { spawn } from 'node:child_process';
import type { ChildProcess } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { MasterProcess } from '@ubii/harness';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { createClient } from '../src/node.ts';
import { startOwnMaster } from './start-own-master.ts';

const packageFolder = fileURLToPath(new URL('..', import.meta.url));
const exampleFolder = join(packageFolder, 'examples');
const examples = readdirSync(exampleFolder).filter((name) => name.endsWith('.ts'));
/** A whole process with a compiler in it, on a machine that may be busy. */
const TIMEOUT_MS = 60_000;

let master: MasterProcess;
const children: ChildProcess[] = [];

beforeAll(async () => {
  master = await startOwnMaster();
}, TIMEOUT_MS);

afterAll(async () => {
  for (const child of children) child.kill('SIGKILL'); // of a test that failed
  await master.dispose();
});

interface Run {
  /** Waits for a line. */
  readonly line: (text: string) => Promise<void>;
  /** Everything it wrote, once it ended. */
  readonly output: Promise<string[]>;
}

/** Runs an example as its first line says. */
function run(name: string, ...args: string[]): Run {
  const child = spawn(process.execPath, ['--import', 'tsx', `examples/${name}`, ...args], {
    cwd: packageFolder,
    stdio: ['ignore', 'pipe', 'pipe'],
  });
  children.push(child);
  let text = '';
  let errors = '';
  const lines = (): string[] => text.split('\n').filter((line) => line !== '');
  child.stderr.on('data', (data: Buffer) => (errors += data.toString()));
  const output = new Promise<string[]>((resolve, reject) => {
    child.stdout.on('data', (data: Buffer) => (text += data.toString()));
    child.once('close', (code) => {
      if (code === 0 && errors === '') resolve(lines());
      else reject(new Error(`${name} ended with ${code}: ${errors}`));
    });
  });
  return {
    output,
    line: (wanted) =>
      new Promise((resolve, reject) => {
        const look = (): void => {
          if (lines().includes(wanted)) resolve();
        };
        child.stdout.on('data', look);
        look();
        output.catch(reject);
      }),
  };
}

describe('the examples', { timeout: TIMEOUT_MS }, () => {
  it.each([
    ['publish.ts', ['5 records sent as weather station']],
    ['subscribe.ts', ['wind from the west: 3.2 m/s', '21.5 °C, measured just now']],
    [
      'glob.ts',
      [
        'glob: /house/kitchen/temperature is 21',
        'glob: /house/bathroom/temperature is 24',
        'regex: /house/bathroom/temperature holds a double',
        'regex: /house/bathroom/light holds a bool',
      ],
    ],
    [
      'services.ts',
      [
        expect.stringMatching(/^the master calls itself ".+"$/) as string,
        '1 client is called "inspector"',
        'refused: not_found',
      ],
    ],
    [
      'master-time.ts',
      [
        expect.stringMatching(
          /^the clock of the master is (ahead|behind), within \d+ ms$/,
        ) as string,
        'the record came soon',
      ],
    ],
    ['device.ts', ['touched at 0.25, 0.75', 'vibrates with 1']],
  ])('%s says what it should', async (name, expected) => {
    expect(await run(name, master.url).output).toEqual(expected);
  });

  it('processing.ts runs a module of a session', async () => {
    const worker = join(master.dataDir, 'module-worker.js');
    expect(await run('processing.ts', master.url, worker).output).toEqual(['the room is loud']);
  });

  it('node.ts comes back as the same client', async () => {
    const file = join(master.dataDir, 'identity.json');
    const [first] = await run('node.ts', master.url, file).output;
    const [second] = await run('node.ts', master.url, file).output;
    const [, id] = /^for the first time: (.+)$/.exec(first ?? '') ?? [];
    expect(id).toBeTruthy();
    expect(second).toBe(`again: ${id}`);
  });

  it('reconnect.ts stays the same client over a restart of the master', async () => {
    const example = run('reconnect.ts', master.url);
    await example.line('connected as a new client');
    await master.kill();
    await example.line('lost the master, trying again');
    await master.restart();
    await example.line('back as the same client');
    const client = createClient({ url: master.url, name: 'test' });
    await client.connect();
    client.publish('/stayer/stop', 'bool', true);
    expect(await example.output).toEqual([
      'connected as a new client',
      'lost the master, trying again',
      'back as the same client',
      'closed',
    ]);
    await client.close();
  });

  it('are all of them run', () => {
    expect(examples.sort()).toEqual([
      'device.ts',
      'glob.ts',
      'master-time.ts',
      'node.ts',
      'processing.ts',
      'publish.ts',
      'reconnect.ts',
      'services.ts',
      'subscribe.ts',
    ]);
  });
});

describe('the README', () => {
  const source = (name: string): string => readFileSync(join(exampleFolder, name), 'utf8').trim();

  it.each(examples)('shows %s as it is, in less than 60 lines', (name) => {
    const readme = readFileSync(join(packageFolder, 'README.md'), 'utf8');
    expect(source(name).split('\n').length).toBeLessThan(60);
    expect(readme).toContain(`\`\`\`ts\n${source(name)}\n\`\`\``);
  });

  it('shows no other TypeScript', () => {
    const readme = readFileSync(join(packageFolder, 'README.md'), 'utf8');
    expect(readme.match(/^```(ts|typescript)/gm)).toHaveLength(examples.length);
  });
});
