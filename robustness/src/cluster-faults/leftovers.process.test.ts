import { spawn, spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { describe, expect, it } from 'vitest';

import { NetworkNamespaces } from './network/namespace-network.ts';
import { removeLeftovers } from './leftovers.ts';

/** Id of a process that has ended. */
function endedPid(): number {
  return spawnSync(process.execPath, ['--version']).pid;
}

function folderOf(pid: number): string {
  return mkdtempSync(join(tmpdir(), `ubii-cluster-${pid}-`));
}

describe('what a run of a cluster left that was killed', () => {
  it.skipIf(process.platform !== 'linux')('is removed, with its processes', async () => {
    const left = folderOf(endedPid());
    const used = folderOf(process.pid);
    mkdirSync(join(left, 'data-1'));
    const script = 'setInterval(() => 0, 1000)';
    const child = spawn(process.execPath, ['-e', script, '--', join(left, 'data-1')]);
    const ended = new Promise((resolve) => child.once('exit', (_code, by) => resolve(by)));
    try {
      await new Promise((resolve) => child.once('spawn', resolve));
      expect(removeLeftovers()).toEqual(
        expect.arrayContaining([`process ${child.pid}`, `folder ${left}`]),
      );
      expect(await ended).toBe('SIGKILL');
      const names = readdirSync(tmpdir());
      expect(names).not.toContain(basename(left));
      // Of a run that goes on.
      expect(names).toContain(basename(used));
    } finally {
      child.kill('SIGKILL');
      rmSync(used, { recursive: true, force: true });
    }
  });

  const reason = NetworkNamespaces.reasonAgainst();
  if (reason !== undefined) console.warn(`The test of leftover namespaces is left out: ${reason}.`);
  it.skipIf(reason !== undefined)(
    'is removed with its network, not that of a run that goes on',
    () => {
      const left = new NetworkNamespaces(String(endedPid()), 1);
      const used = new NetworkNamespaces(String(process.pid), 1);
      try {
        left.open();
        used.open();
        removeLeftovers();
        const names = NetworkNamespaces.all().map(({ name }) => name);
        expect(names).toEqual(expect.arrayContaining([used.hub, used.nameOf(0)]));
        expect(names).not.toContain(left.hub);
        expect(names).not.toContain(left.nameOf(0));
      } finally {
        left.close();
        used.close();
      }
    },
  );
});
