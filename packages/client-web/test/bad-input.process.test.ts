import { spawn } from 'node:child_process';
import { cpSync, mkdirSync, readdirSync, readFileSync, symlinkSync, writeFileSync } from 'node:fs';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import type { MasterProcess } from '@ubii/harness';
import { temporaryFolder } from '@ubii/program/testing';
import { AccessRole } from '@ubii/proto';
import { afterAll, beforeAll, describe, expect, it, onTestFinished } from 'vitest';
import { builtPackage } from './build-package.ts';
import { startOwnMaster } from './start-own-master.ts';

const samples = fileURLToPath(new URL('../samples', import.meta.url));

let master: MasterProcess;

beforeAll(async () => {
  master = await startOwnMaster();
});
afterAll(() => master.dispose());

interface Run {
  /** Exit code and standard error, when it ended. */
  readonly ended: Promise<{ readonly code: number | null; readonly said: string }>;
  readonly connected: Promise<void>;
  /** Folder with the identity of the program. */
  readonly state: string;
  kill(): void;
}

/** Runs the first program with the built package. */
function run(args: readonly string[], state = join(temporaryFolder(), 'state')): Run {
  const folder = temporaryFolder();
  mkdirSync(join(folder, 'node_modules/@ubii'), { recursive: true });
  symlinkSync(builtPackage, join(folder, 'node_modules/@ubii/client-web'), 'junction');
  cpSync(samples, folder, { recursive: true });
  const child = spawn(process.execPath, ['first-program.mjs', ...args], {
    cwd: folder,
    env: { ...process.env, XDG_STATE_HOME: state },
  });
  onTestFinished(() => void child.kill('SIGKILL'));
  let said = '';
  child.stderr.on('data', (data: Buffer) => (said += data.toString()));
  return {
    state,
    ended: new Promise((resolve) => child.once('close', (code) => resolve({ code, said }))),
    connected: new Promise((resolve) => child.stdout.once('data', () => resolve())),
    kill: () => void child.kill('SIGINT'),
  };
}

async function codeFor(changes: { maxJoins?: number; lifetimeMs?: number }): Promise<string> {
  const { accessGrantCreated } = await master.call({
    topic: '/services/ubii/access_grant_create',
    accessGrantCreateRequest: { role: AccessRole.ACCESS_ROLE_PARTICIPANT, ...changes },
  });
  return accessGrantCreated!.code;
}

async function serverOf(status: number): Promise<string> {
  const server: Server = createServer((_request, response) => {
    response.writeHead(status, { 'content-type': 'text/html' }).end('<p>another server</p>');
  });
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  onTestFinished(() => void server.close());
  return `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
}

describe('a program that cannot start says why in one line, and exits with', () => {
  const expectEnd = async ({ ended }: Run, code: number, sentence: RegExp): Promise<void> => {
    const end = await ended;
    expect(end.said).toMatch(sentence);
    expect(end.said.trim().split('\n')).toHaveLength(1);
    expect(end.code).toBe(code);
  };

  it('2 for an address that is none', async () => {
    await expectEnd(
      run(['localhost:8080']),
      2,
      /that begins with http:\/\/.*received "localhost:8080"/,
    );
  });

  it('3 for an address where nothing is, or another server', async () => {
    await expectEnd(run(['http://127.0.0.1:9']), 3, /cannot be reached.*Check the address/);
    await expectEnd(run([await serverOf(404)]), 3, /received 404.*Check the address/);
  });

  it('5 for an answer that is none of a master', async () => {
    await expectEnd(run([await serverOf(200)]), 5, /Check that the address is that of a Ubi-Inte/);
  });

  it('4 for a code that is wrong, used or expired', async () => {
    await expectEnd(run([master.url, 'ABCD-EFGH']), 4, /does not know this code/);
    const code = await codeFor({ maxJoins: 1 });
    const first = run([master.url, code]);
    await first.connected;
    await expectEnd(run([master.url, code]), 4, /used as often.*Ask an admin/);
    first.kill();
    expect(await first.ended).toEqual({ code: 0, said: '' });
    const again = run([master.url, code], first.state);
    await again.connected; // by its credential
    const short = await codeFor({ lifetimeMs: 1 });
    await expectEnd(run([master.url, short]), 4, /expired.*Ask an admin/);
  });

  it('6 when another program takes its identity', async () => {
    const first = run([master.url]);
    await first.connected;
    const folder = join(first.state, 'ubi-interact/programs');
    const [name = ''] = readdirSync(folder);
    const kept = JSON.parse(readFileSync(join(folder, name), 'utf8')) as object;
    const copy = join(temporaryFolder(), 'state');
    mkdirSync(join(copy, 'ubi-interact/programs'), { recursive: true });
    // Of a process that is gone: as a copy from another computer is.
    const moved = JSON.stringify({ ...kept, pid: 2 ** 22 });
    writeFileSync(join(copy, 'ubi-interact/programs', name), moved);
    const second = run([master.url], copy);
    await second.connected;
    await expectEnd(first, 6, /Another program connected with the identity/);
  });
});
