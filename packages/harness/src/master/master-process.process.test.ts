import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { describe, expect, it, onTestFinished } from 'vitest';

import { StartRefused } from '../process/server-process.ts';
import type { MasterStart } from './command-line.ts';
import { MasterProcess } from './master-process.ts';

const program = resolve(import.meta.dirname, '../../test/fake-master.mjs');

async function start(options: MasterStart = {}): Promise<MasterProcess> {
  const master = await MasterProcess.start({ program, ...options });
  onTestFinished(() => master.dispose());
  return master;
}

function folderWith(mode: string): string {
  const folder = mkdtempSync(join(tmpdir(), 'ubii-harness-'));
  writeFileSync(join(folder, 'mode'), mode);
  onTestFinished(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

describe('a master process', () => {
  it('has the address that the master reports', async () => {
    const master = await start();
    expect(master.url).toBe(`http://127.0.0.1:${master.port}`);
    expect(master.endpoints.pid).toBe(master.pid);
    expect(await master.metrics()).toEqual(
      new Map([
        ['a{b="c d"}', 2],
        ['e', 1.5],
      ]),
    );
  });

  it('keeps port, data folder and log over a restart', async () => {
    const master = await start();
    const { port, pid } = master;
    await master.kill();
    expect(master.isRunning).toBe(false);
    expect(master.ending).toMatch(/SIGKILL/);
    await master.restart();
    expect(master.port).toBe(port);
    expect(master.pid).not.toBe(pid);
    await expect.poll(() => master.log.length).toBe(2);
    expect(existsSync(master.dataDir)).toBe(true);
  });

  it('removes its data folder, and none that it was given', async () => {
    const own = await start();
    await own.dispose();
    expect(existsSync(own.dataDir)).toBe(false);
    const given = await start({ dataDir: folderWith('') });
    await given.dispose();
    expect(existsSync(given.dataDir)).toBe(true);
  });

  it('reports the exit code and output of a master that refuses to start', async () => {
    const refused = start({ dataDir: folderWith('refuse') });
    await expect(refused).rejects.toThrow(StartRefused);
    await expect(refused).rejects.toMatchObject({ exitCode: 3, output: 'The port is taken.' });
  });

  it('says what to do when there is no build', async () => {
    await expect(start({ program: '/no/master.js' })).rejects.toThrow('npm run build');
  });
});
