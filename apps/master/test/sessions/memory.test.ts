import { createInlineSandboxes } from '@ubii/pm-sandbox/testing';
import type { SandboxFactory } from '@ubii/pm-sandbox';
import type { Init, Session } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { doubler, SessionWorld, TOPICS } from './session-world.ts';
import { OUR_NODE, TestNode } from './test-node.ts';

const MIB = 1024 * 1024;
const MASTER_STATUS = { topic: '/services/ubii/master_status', masterStatusRequest: {} };

/** Sandboxes whose instances say that they have so much memory once they are there. */
function sandboxesThatHave(bytes: () => number, shortage?: () => 'all' | 'owner' | undefined) {
  const inline = createInlineSandboxes();
  return {
    ...inline,
    open(request, events) {
      const sandbox = inline.open(request, events);
      return {
        create: async () => {
          const short = shortage?.();
          if (short !== undefined) {
            throw {
              kind: 'memory',
              phase: 'onCreated',
              message: 'It is all used.',
              shortage: short,
            };
          }
          await sandbox.create();
          events.onMemory?.(bytes());
        },
        run: (call) => sandbox.run(call),
        halt: () => sandbox.halt(),
        destroy: () => sandbox.destroy(),
        terminate: () => sandbox.terminate(),
      };
    },
  } satisfies SandboxFactory;
}

/** A session of so many modules. */
function modules(name: string, count: number, nodeId = ''): Init<Session> {
  const names = Array.from({ length: count }, (_, i) => `${name} ${i}`);
  return {
    name,
    processingModules: names.map((one) => ({ ...doubler, name: one, nodeId })),
  };
}

describe('memory of modules', () => {
  it('is told for each module and each node, with what there may be [SE-64]', async () => {
    const world = await SessionWorld.create({ sandboxes: sandboxesThatHave(() => 20 * MIB) });
    const session = await world.ask(TOPICS.start, modules('one', 2));
    await world.master.pass(1000);
    const statistics = await world.value(`/ubii/session/${session.id}/statistics`);
    expect(statistics).toMatchObject({
      modules: [{ memoryBytes: 20 * MIB }, { memoryBytes: 20 * MIB }],
      memoryLimitBytes: 1024 * MIB,
    });
    const { nodeList } = await world.master.call({ topic: TOPICS.nodes });
    expect(nodeList!.elements[0]).toMatchObject({
      memoryBytes: 40 * MIB,
      node: { memoryBytes: 2048 * MIB },
    });
    const { limitList } = await world.master.call({ topic: '/services/ubii/limit_list' });
    const use = (name: string) => limitList!.elements.find((one) => one.name === name)!.use;
    expect(use('moduleBytes')).toMatchObject({ value: 40 * MIB });
    expect(use('moduleBytesPerSession')).toMatchObject({
      value: 40 * MIB,
      sessionId: session.id,
    });
  });

  it('does not suffice on the master: the start is refused, names its users, and succeeds later', async () => {
    const world = await SessionWorld.create({
      sandboxes: sandboxesThatHave(() => 20 * MIB),
      limits: { moduleBytes: 64 * MIB, moduleBytesPerSession: 64 * MIB },
    });
    const greedy = await world.ask(TOPICS.start, modules('greedy', 3));
    await world.master.pass(1000);
    const waiting = modules('waiting', 8);
    const { code, message } = await world.refusal(TOPICS.start, waiting);
    expect(code).toBe('resource_exhausted');
    expect(message).toBe(
      'The session "waiting" needs at least 7 MB of memory for its modules on "master-node"; of the 64 MB that modules may have there, 60 MB are used. Most is used by "greedy" (60 MB). Stop what is not needed, or raise the limit with --limits moduleBytes=<bytes>.',
    );
    await world.ask(TOPICS.stop, { id: greedy.id });
    await world.master.pass(1000);
    await world.ask(TOPICS.start, waiting);
  });

  it('does not suffice for one session', async () => {
    const world = await SessionWorld.create({
      limits: { moduleBytes: 64 * MIB, moduleBytesPerSession: 4 * MIB },
    });
    const { message } = await world.refusal(TOPICS.start, modules('large', 8));
    expect(message).toMatch(
      /^The session "large" needs at least 7 MB of memory for its modules on the master; those of one session may have 4 MB there\./,
    );
    await world.ask(TOPICS.start, modules('small', 4));
  });

  it('does not suffice on a node that says what it has', async () => {
    const world = await SessionWorld.create();
    const node = await TestNode.ours(world.master, 'small', {
      extension: { recordLists: true, node: { ...OUR_NODE, memoryBytes: 2 * MIB } },
    });
    const { message } = await world.refusal(TOPICS.start, modules('large', 3, node.client.id));
    expect(message).toMatch(/needs at least 2\.7 MB .* of the 2 MB .* --memory of that node\.$/);
    await world.ask(TOPICS.start, modules('small', 2, node.client.id));
  });

  it.each([
    ['all', 'all modules on the master', 'moduleBytes'],
    ['owner', 'the modules of its session', 'moduleBytesPerSession'],
  ] as const)('is used up (%s): the module is named [SE-65]', async (shortage, whose, limit) => {
    const world = await SessionWorld.create({
      sandboxes: sandboxesThatHave(
        () => MIB,
        () => shortage,
      ),
    });
    const session = await world.ask(TOPICS.start, modules('one', 1));
    const { extension } = await world.get(session);
    expect(extension!.problems[0]).toMatchObject({ code: 'module_failed', moduleName: 'one 0' });
    const { masterStatus } = await world.master.call(MASTER_STATUS);
    expect(masterStatus!.events.map(({ text }) => text)).toContain(
      `The module "one 0" of the session "one" was ended: the memory for ${whose} is used up`,
    );
    expect(masterStatus!.problems.map(({ text }) => text).join()).toContain(limit);
  });
});
