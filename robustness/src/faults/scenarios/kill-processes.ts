import { spawn, type ChildProcess } from 'node:child_process';
import { once } from 'node:events';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { createInterface } from 'node:readline';

import { periodicSession } from '../../fixtures/sessions.ts';
import { FaultRun, type Scenario } from '../fault-run.ts';
import { ModuleOutput } from '../module-output.ts';

const WITHIN_MS = 2_000;

export const killMaster: Scenario = {
  name: 'kill-master',
  about: 'kill -9 of the master at random moments, and a start on the same data',
  async run({ program, random, times }) {
    const faultRun = await FaultRun.open({ program }, random);
    const losses: string[] = [];
    const backMs: number[] = [];
    try {
      const heartbeat = await faultRun.heartbeat();
      for (let index = 0; index < times; index++) {
        await faultRun.killDuringWork(random, WITHIN_MS);
        const begunMs = performance.now();
        await faultRun.master.restart();
        await heartbeat.beat();
        backMs.push(performance.now() - begunMs);
        losses.push(...(await faultRun.findLosses()));
      }
      return faultRun.outcome(losses, backMs);
    } finally {
      await faultRun.close();
    }
  },
};

export const killNode: Scenario = {
  name: 'kill-node',
  about: 'kill -9 of a node that runs the module of a session, and a start of it as the same node',
  async run({ program, node, random, times }) {
    const faultRun = await FaultRun.open({ program }, random);
    const folder = mkdtempSync(join(tmpdir(), 'ubii-node-'));
    const { url } = faultRun.master.endpoints;
    const identity = join(folder, 'identity');
    let child: ChildProcess | undefined;
    let moduleOutput: ModuleOutput | undefined;
    const losses: string[] = [];
    const backMs: number[] = [];
    try {
      const started = await startNode(node, url, identity);
      child = started.child;
      const session = periodicSession('on a node', '/node/tick');
      const { session: running } = await faultRun.master.call({
        topic: '/services/session/runtime/start',
        session: {
          ...session,
          processingModules: session.processingModules!.map((one) => ({
            ...one,
            nodeId: started.id,
          })),
        },
      });
      moduleOutput = await ModuleOutput.open(url, '/node/tick');
      await moduleOutput.waitForMore();
      for (let index = 0; index < times; index++) {
        await faultRun.workFor(random.below(1_500));
        child.kill('SIGKILL');
        await once(child, 'exit');
        const begunMs = performance.now();
        const again = await startNode(node, url, identity);
        child = again.child;
        if (again.id !== started.id) losses.push('the node came back as another one');
        await moduleOutput.waitForMore();
        backMs.push(performance.now() - begunMs);
        const { session: now } = await faultRun.ask({
          topic: '/services/session/runtime/get',
          session: { id: running!.id },
        });
        if (now === undefined) losses.push('the session is gone');
        losses.push(...(await faultRun.findLosses()));
      }
      return faultRun.outcome(losses, backMs);
    } finally {
      child?.kill('SIGKILL');
      await moduleOutput?.close();
      await faultRun.close();
      rmSync(folder, { recursive: true, force: true });
    }
  },
};

async function startNode(
  program: string,
  master: string,
  identity: string,
): Promise<{ child: ChildProcess; id: string }> {
  const flags = ['--master', master, '--identity', identity, '--print-endpoints', 'json'];
  const child = spawn(process.execPath, [program, ...flags], {
    stdio: ['ignore', 'pipe', 'ignore'],
  });
  const killWithUs = (): void => void child.kill('SIGKILL');
  process.once('exit', killWithUs);
  child.once('exit', () => process.off('exit', killWithUs));
  const id = await new Promise<string>((resolve, reject) => {
    createInterface({ input: child.stdout! }).on('line', (line) => {
      if (line.startsWith('{')) resolve((JSON.parse(line) as { id: string }).id);
    });
    child.once('exit', (code) => reject(new Error(`The node ended with ${code}.`)));
  });
  return { child, id };
}
