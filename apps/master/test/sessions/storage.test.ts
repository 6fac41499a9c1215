import type { SandboxFactory } from '@ubii/pm-sandbox';
import { createInlineSandboxes } from '@ubii/pm-sandbox/testing';
import { ModuleOrigin, SessionState, StatusEventKind } from '@ubii/proto';
import { describe, expect, it, vi } from 'vitest';
import { MemoryStorage } from '../../src/testing/index.ts';
import { doubler, doubling, SessionWorld, TOPICS } from './session-world.ts';
import { TestNode } from './test-node.ts';

const { MODULE_ORIGIN_BUILT_IN, MODULE_ORIGIN_NODE, MODULE_ORIGIN_STORED } = ModuleOrigin;

async function storedNames(world: SessionWorld): Promise<string[]> {
  const { sessionList } = await world.master.call({ topic: TOPICS.stored });
  return sessionList!.elements.map(({ name }) => name);
}

async function save(world: SessionWorld, session: Parameters<SessionWorld['ask']>[1]) {
  const { sessionList, error } = await world.master.call({ topic: TOPICS.save, session });
  if (error) throw new Error(`${error.code}: ${error.message}`);
  await world.master.pass();
  return sessionList!.elements[0]!;
}

describe('stored sessions', () => {
  it('are kept by name, known at once, and there for the next master [SE-20] [SE-21]', async () => {
    const storage = new MemoryStorage();
    const world = await SessionWorld.create({ storage });
    const saved = await save(world, doubling('/in', '/out'));
    expect(saved.extension).toMatchObject({ stored: true, state: SessionState.SESSION_CREATED });
    expect(world.takeWords()).toContain('new');
    const next = await SessionWorld.create({ storage });
    expect(await storedNames(next)).toEqual(['doubling']);
    const started = await next.ask(TOPICS.start, { name: 'doubling' });
    expect(started.extension?.stored).toBe(true);
    next.ada.publish('/in', 'double', 2);
    await next.master.pass(10);
    expect(await next.value('/out')).toBe(4);
  });

  it('are replaced by those of the same name [SE-21]', async () => {
    const world = await SessionWorld.create();
    const first = await save(world, doubling('/in', '/one'));
    const second = await save(world, doubling('/in', '/two'));
    expect(second.id).toBe(first.id);
    expect(await storedNames(world)).toEqual(['doubling']);
    const { session } = await world.master.call({
      topic: '/services/session/database/get',
      session: { name: 'doubling' },
    });
    expect(session?.ioMappings[0]?.outputMappings[0]?.topic).toBe('/two');
    expect(session?.processingModules[0]).toMatchObject({ nodeId: '', sessionId: '' });
  });

  it('stay stored for all who see them while they get another name [SE-21]', async () => {
    const world = await SessionWorld.create();
    const session = await save(world, doubling('/in', '/out'));
    world.takeNews();
    await save(world, { ...session, name: 'renamed' });
    const news = world.takeNews().map(([, { name, extension }]) => [name, extension?.stored]);
    expect(new Set(news.map(String))).toEqual(new Set(['renamed,true']));
  });

  it('that cannot be written under another name are not stored [SE-21]', async () => {
    const storage = new MemoryStorage();
    const world = await SessionWorld.create({ storage });
    const session = await save(world, doubling('/in', '/out'));
    vi.spyOn(storage.sessions, 'write').mockRejectedValueOnce(new Error('No space left.'));
    const topic = TOPICS.save;
    const reply = await world.master.call({ topic, session: { ...session, name: 'renamed' } });
    expect(reply.error).toBeDefined();
    expect((await world.get(session)).extension?.stored).toBe(false);
  });

  it('name the master by what it is, as its id changes [SE-30]', async () => {
    const storage = new MemoryStorage();
    const world = await SessionWorld.create({ storage });
    const here = {
      ...doubling('/in', '/out'),
      processingModules: [{ ...doubler, nodeId: 'master' }],
    };
    const { id } = await save(world, here);
    const { processingModules } = await world.get({ id });
    expect(processingModules[0]).toMatchObject({ nodeId: world.master.master.id });
    expect(storage.sessions.documents().get('doubling')?.json).toMatchObject({
      processingModules: [{ nodeId: 'master' }],
    });
    const next = await SessionWorld.create({ storage });
    const started = await next.ask(TOPICS.start, { name: 'doubling' });
    expect(started.processingModules[0]?.nodeId).toBe(next.master.master.id);
  });

  it('cannot be deleted while they run [SE-21]', async () => {
    const world = await SessionWorld.create();
    const { id } = await save(world, doubling('/in', '/out'));
    await world.ask(TOPICS.start, { id });
    const topic = '/services/session/database/delete';
    const refused = await world.master.call({ topic, session: { name: 'doubling' } });
    expect(refused.error).toMatchObject({ code: 'failed_precondition' });
    await world.ask(TOPICS.stop, { id });
    const { success } = await world.master.call({ topic, session: { id } });
    expect(success).toBeDefined();
    expect(await storedNames(world)).toEqual([]);
    expect((await world.get({ id })).extension?.stored).toBe(false);
    const gone = await world.master.call({ topic, session: { name: 'doubling' } });
    expect(gone.error).toMatchObject({ code: 'not_found' });
  });

  it('are read in the form of old masters, and with the spellings in use [SE-6] [SE-20]', async () => {
    const storage = new MemoryStorage();
    storage.sessions.edit(
      'old',
      JSON.stringify({
        name: 'old',
        processingModules: [{ name: 'doubler', language: 'JS' }],
        ioMappings: [
          {
            processingModuleName: 'doubler',
            inputMappings: [{ inputName: 'in', topicSource: '/in' }],
            outputMappings: [{ outputName: 'out', topicDestination: '/out' }],
          },
        ],
      }),
    );
    storage.modules.edit('doubler', JSON.stringify(doubler));
    const world = await SessionWorld.create({ storage });
    await world.ask(TOPICS.start, { name: 'old' });
    world.ada.publish('/in', 'double', 2);
    await world.master.pass(10);
    expect(await world.value('/out')).toBe(4);
  });

  it('that are broken are named, and stop nothing else [SE-23]', async () => {
    const storage = new MemoryStorage();
    storage.sessions.edit('broken', '{ "name": ');
    storage.modules.edit('wrong', '{ "inputs": 7 }');
    const world = await SessionWorld.create({ storage });
    await save(world, doubling('/in', '/out'));
    expect(await storedNames(world)).toEqual(['doubling']);
    const status = async () => {
      const { masterStatus } = await world.master.call({
        topic: '/services/ubii/master_status',
        masterStatusRequest: {},
      });
      return masterStatus!;
    };
    const { problems, events } = await status();
    expect(problems.map(({ code }) => code)).toEqual(['file_broken', 'file_broken']);
    expect(problems[0]?.text).toContain('broken');
    expect(events.filter(({ kind }) => kind === StatusEventKind.FILE_BROKEN)).toHaveLength(2);
    expect(world.master.log.lines).toContainEqual(
      expect.objectContaining({ level: 'warn', message: expect.stringContaining('is ignored') }),
    );
    // A person repairs the file: the change applies at once.
    storage.sessions.edit('broken', JSON.stringify({ name: 'repaired' }));
    storage.modules.edit('wrong', undefined);
    expect(await storedNames(world)).toEqual(expect.arrayContaining(['repaired']));
    expect((await status()).problems).toEqual([]);
  });
});

describe('the id of a stored session [SE-27]', () => {
  /** A master that stored a session, and the next one with the same disk. */
  async function restarted() {
    const storage = new MemoryStorage();
    const world = await SessionWorld.create({ storage });
    const { id } = await save(world, doubling('/in', '/out'));
    await world.master.master.close();
    return { id, storage, next: await SessionWorld.create({ storage }) };
  }

  it('is the same with the next master, and starts, changes and stops it', async () => {
    const { id, next } = await restarted();
    expect((await next.ask(TOPICS.start, { id })).id).toBe(id);
    next.ada.publish('/in', 'double', 2);
    await next.master.pass(10);
    expect(await next.value('/out')).toBe(4);
    const changed = await next.ask(TOPICS.update, { ...doubling('/in', '/two'), id });
    expect(changed.id).toBe(id);
    expect((await next.ask(TOPICS.pause, { id })).id).toBe(id);
    expect((await next.ask(TOPICS.resume, { id })).id).toBe(id);
    expect((await next.master.call({ topic: TOPICS.stop, session: { id } })).error).toBeUndefined();
  });

  it('is answered without opening the session, and opened once by those who ask for it', async () => {
    const { id, next } = await restarted();
    const listed = async () =>
      (await next.master.call({ topic: TOPICS.list })).sessionList!.elements.map((one) => one.id);
    expect(await next.get({ id })).toMatchObject({ id, extension: { stored: true } });
    expect(await listed()).toEqual([]);
    const opened = await Promise.all(
      [{ id }, { name: 'doubling' }, { id }].map((session) => next.ask(TOPICS.add, session)),
    );
    expect(opened.map((session) => session.id)).toEqual([id, id, id]);
    expect(await listed()).toEqual([id]);
  });

  it('stays when the session is saved by its name, or by a client with an id of its own', async () => {
    const { id, next } = await restarted();
    expect((await save(next, doubling('/in', '/two'))).id).toBe(id);
    const foreign = '99999999-0000-4000-8000-000000000000';
    expect((await save(next, { ...doubling('/in', '/three'), id: foreign })).id).toBe(id);
    const { session } = await next.master.call({
      topic: '/services/session/database/get',
      session: { id },
    });
    expect(session?.ioMappings[0]?.outputMappings[0]?.topic).toBe('/three');
  });

  it('that no session has opens and makes nothing', async () => {
    const world = await SessionWorld.create();
    const id = '99999999-0000-4000-8000-000000000000';
    for (const topic of [TOPICS.get, TOPICS.add, TOPICS.start, TOPICS.stop, TOPICS.update]) {
      expect(await world.refusal(topic, { id })).toMatchObject({ code: 'not_found' });
    }
    expect(await storedNames(world)).toEqual([]);
  });

  it('may be chosen by the client that saves a new session: a UUID that no session has', async () => {
    const world = await SessionWorld.create();
    const id = '99999999-0000-4000-8000-000000000000';
    expect((await save(world, { ...doubling('/in', '/out'), id })).id).toBe(id);
    const other = { ...doubling('/in', '/out'), name: 'other', id: '../../etc' };
    expect((await save(world, other)).id).not.toBe('../../etc');
  });

  it('is made of the name where a file has none, or that of another file', async () => {
    const storage = new MemoryStorage();
    const id = '99999999-0000-4000-8000-000000000000';
    for (const [name, own] of [
      ['a', id],
      ['a copy', id],
      ['by hand', ''],
      ['broken', 'no uuid'],
    ] as const) {
      storage.sessions.edit(name, JSON.stringify({ ...doubling('/in', '/out'), name, id: own }));
    }
    const ids = async () => {
      const world = await SessionWorld.create({ storage });
      const { sessionList } = await world.master.call({ topic: TOPICS.stored });
      return sessionList!.elements.map((one) => one.id);
    };
    const first = await ids();
    expect(first[0]).toBe(id);
    expect(new Set(first).size).toBe(4);
    expect(await ids()).toEqual(first);
  });

  it('keeps counting revisions: a change made from before the restart is noticed', async () => {
    const storage = new MemoryStorage();
    const world = await SessionWorld.create({ storage });
    await save(world, doubling('/in', '/out'));
    const { id, extension } = await save(world, doubling('/in', '/two'));
    expect(extension?.revision).toBe(2);
    const next = await SessionWorld.create({ storage });
    const old = { ...doubling('/in', '/three'), id, extension: { revision: 2 } };
    expect(await next.refusal(TOPICS.update, old)).toMatchObject({ code: 'failed_precondition' });
    const { revision } = (await next.get({ id })).extension!;
    expect(revision).toBe(3);
    const changed = await next.ask(TOPICS.update, { ...old, extension: { revision } });
    expect(changed.extension?.revision).toBe(4);
  });

  it('of a session that runs already leads to it, and a start by its name makes a second one', async () => {
    const storage = new MemoryStorage();
    const world = await SessionWorld.create({ storage });
    const { id } = await save(world, doubling('/in', '/out'));
    const next = await SessionWorld.create({ storage, idsGiven: 1000 });
    expect((await next.ask(TOPICS.start, { id })).id).toBe(id);
    const second = await next.ask(TOPICS.start, { name: 'doubling' });
    expect(second.id).not.toBe(id);
  });
});

describe('stored modules', () => {
  it('are listed with those of the program and of nodes, once each [SE-22]', async () => {
    const library = [await moduleOf({ ...doubler, name: 'built-in' })];
    const world = await SessionWorld.create({ library });
    await TestNode.original(world.master, 'nodejs', {
      processingModules: [{ name: 'offered', tags: ['camera'] }],
    });
    const { processingModule } = await world.master.call({
      topic: TOPICS.saveModule,
      processingModule: doubler,
    });
    expect(processingModule).toMatchObject({ extension: { origin: MODULE_ORIGIN_STORED } });
    const list = async (profile?: object) => {
      const { processingModuleList } = await world.master.call({
        topic: TOPICS.modules,
        ...(profile && { processingModuleList: { elements: [profile] } }),
      });
      return processingModuleList!.elements.map(({ name, extension }) => [name, extension?.origin]);
    };
    expect(await list()).toEqual([
      ['built-in', MODULE_ORIGIN_BUILT_IN],
      ['doubler', MODULE_ORIGIN_STORED],
      ['offered', MODULE_ORIGIN_NODE],
    ]);
    expect(await list({ tags: ['camera'] })).toEqual([['offered', MODULE_ORIGIN_NODE]]);
    expect(
      await list({
        inputs: [{ internalName: 'x', messageFormat: 'ubii.double' }],
        name: 'doubler',
      }),
    ).toEqual([['doubler', MODULE_ORIGIN_STORED]]);
  });

  it('of the program can be read, but not changed [SE-22]', async () => {
    const world = await SessionWorld.create({ library: [await moduleOf(doubler)] });
    for (const topic of [TOPICS.saveModule, TOPICS.deleteModule]) {
      const { error } = await world.master.call({ topic, processingModule: doubler });
      expect(error).toMatchObject({ code: 'failed_precondition' });
    }
    const { processingModuleList } = await world.master.call({
      topic: '/services/processing_module/database/get',
      processingModule: { name: 'doubler' },
    });
    expect(processingModuleList?.elements).toMatchObject([{ name: 'doubler' }]);
  });

  it('need a name, and are deleted by it [SE-22]', async () => {
    const world = await SessionWorld.create();
    const call = (topic: string, name: string) =>
      world.master.call({ topic, processingModule: { ...doubler, name } });
    expect((await call(TOPICS.saveModule, '')).error).toMatchObject({ code: 'invalid_argument' });
    expect((await call(TOPICS.deleteModule, 'unknown')).error).toMatchObject({ code: 'not_found' });
    await call(TOPICS.saveModule, 'mine');
    expect((await call(TOPICS.deleteModule, 'mine')).success).toBeDefined();
    expect((await call(TOPICS.deleteModule, 'mine')).error).toMatchObject({ code: 'not_found' });
  });

  it('give their code to sessions that name them [SE-1] [PM-64]', async () => {
    const world = await SessionWorld.create({ library: [await moduleOf(doubler)] });
    const session = await world.ask(TOPICS.start, {
      ...doubling('/in', '/out'),
      processingModules: [{ name: 'doubler' }],
    });
    expect(session.processingModules[0]).toMatchObject({ ...doubler, name: 'doubler' });
    world.ada.publish('/in', 'double', 5);
    await world.master.pass(10);
    expect(await world.value('/out')).toBe(10);
  });

  it('are not online [SE-25]', async () => {
    const world = await SessionWorld.create();
    const modules = await world.master.call({
      topic: '/services/processing_module/database/online/get_list',
    });
    const sessions = await world.master.call({
      topic: '/services/session/database/online/get_list',
    });
    expect(modules.processingModuleList?.elements).toEqual([]);
    expect(sessions.sessionList?.elements).toEqual([]);
  });
});

describe('a master that ends', () => {
  it('leaves its sessions to the next one, if they are marked so [SE-24]', async () => {
    const storage = new MemoryStorage();
    const world = await SessionWorld.create({ storage });
    const marked = await world.ask(TOPICS.start, {
      ...doubling('/in', '/out'),
      extension: { startWithMaster: true },
    });
    await world.ask(TOPICS.start, { ...doubling('/in', '/other'), name: 'passing' });
    expect(world.master.master.sessionsAtStop()).toEqual({
      startAgain: ['doubling'],
      end: ['passing'],
    });
    await world.master.master.close();

    const next = await SessionWorld.create({ storage });
    await next.master.pass();
    const { sessionList } = await next.master.call({ topic: TOPICS.list });
    expect(sessionList?.elements.map(({ id, name }) => [id, name])).toEqual([
      [marked.id, 'doubling'],
    ]);
    next.ada.publish('/in', 'double', 2);
    await next.master.pass(10);
    expect(await next.value('/out')).toBe(4);
    expect(await next.master.master.sessionsRestored()).toEqual({
      running: ['doubling'],
      others: [],
    });
  });

  it('answers a start and a stop when they are written down, else with an error [SE-24]', async () => {
    const storage = new MemoryStorage();
    const { running } = storage;
    const world = await SessionWorld.create({ storage });
    const write = running.write.bind(running);
    const writes: (() => Promise<void>)[] = [];
    running.write = (key, json) =>
      new Promise((resolve) => writes.push(() => write(key, json).then(resolve)));
    const marked = { ...doubling('/in', '/out'), extension: { startWithMaster: true } };
    let isAnswered = false;
    const reply = world.master.call({ topic: TOPICS.start, session: marked }).finally(() => {
      isAnswered = true;
    });
    await world.master.pass(20);
    expect(writes.length).toBeGreaterThan(0);
    expect(isAnswered).toBe(false);
    while (writes.length > 0) await writes.shift()!();
    const { session } = await reply;
    expect([...running.documents().keys()]).toEqual([session!.id]);

    running.delete = () => Promise.reject(new Error('the disk is full'));
    const { error } = await world.master.call({ topic: TOPICS.stop, session: { id: session!.id } });
    expect(error).toMatchObject({ code: 'unavailable' });
    expect(error!.message).toContain('the disk is full');
  });

  it('does not start again what was stopped before [SE-24]', async () => {
    const storage = new MemoryStorage();
    const world = await SessionWorld.create({ storage });
    const { id } = await world.ask(TOPICS.start, {
      ...doubling('/in', '/out'),
      extension: { startWithMaster: true },
    });
    await world.ask(TOPICS.stop, { id });
    await world.master.master.close();
    const next = await SessionWorld.create({ storage });
    const { sessionList } = await next.master.call({ topic: TOPICS.list });
    expect(sessionList?.elements).toEqual([]);
  });

  it('lets modules wait for nodes that come back later [SE-24] [SE-31]', async () => {
    const storage = new MemoryStorage();
    const world = await SessionWorld.create({ storage });
    const node = await TestNode.ours(world.master, 'tab');
    const { id } = await world.ask(TOPICS.start, {
      processingModules: [{ ...doubler, nodeId: node.id }],
      extension: { startWithMaster: true },
    });
    await node.ran(node.own(node.told('start')));
    await world.master.master.close();

    const next = await SessionWorld.create({ storage, clock: world.master.clock });
    const waiting = await next.get({ id });
    expect(waiting.extension?.problems[0]).toMatchObject({ code: 'node_gone', nodeId: node.id });
    expect(await next.master.master.sessionsRestored()).toEqual({
      running: [],
      others: [{ name: id, reason: waiting.extension?.problems[0]?.message }],
    });
    const back = await TestNode.ours(next.master, 'tab', {
      id: node.id,
      extension: {
        recordLists: true,
        resumeToken: node.client.token ?? '',
        node: node.client.registered.extension?.node ?? { runsJavascript: true },
      },
    });
    expect(back.id).toBe(node.id);
    await back.ran([{ ...waiting.processingModules[0], nodeId: back.id }]);
    expect((await next.get({ id })).extension?.state).toBe(SessionState.SESSION_RUNNING);
  });

  it('does not give up what takes long to start again [SE-12] [SE-24]', async () => {
    const storage = new MemoryStorage();
    const world = await SessionWorld.create({ storage });
    const { id } = await world.ask(TOPICS.start, {
      ...doubling('/in', '/out'),
      extension: { startWithMaster: true },
    });
    await world.master.master.close();

    const { sandboxes, letStart } = slowSandboxes();
    const next = await SessionWorld.create({ storage, sandboxes });
    await next.master.pass(11_000);
    const late = await next.get({ id });
    expect(late.extension?.problems[0]).toMatchObject({ code: 'module_not_started' });
    expect(late.extension?.state).toBe(SessionState.SESSION_DEGRADED);
    expect([...storage.running.documents().keys()]).toEqual([id]);
    letStart();
    await next.master.pass(1_000);
    expect((await next.get({ id })).extension?.state).toBe(SessionState.SESSION_RUNNING);
    await next.ask(TOPICS.stop, { id });
    expect([...storage.running.documents().keys()]).toEqual([]);
  });
});

/** Sandboxes whose instances are there when they are let. */
function slowSandboxes() {
  const inline = createInlineSandboxes();
  let letStart = (): void => {};
  const start = new Promise<void>((resolve) => (letStart = resolve));
  const sandboxes: SandboxFactory = {
    ...inline,
    open(request, events) {
      const sandbox = inline.open(request, events);
      return {
        create: () => start.then(() => sandbox.create()),
        run: (call) => sandbox.run(call),
        halt: () => sandbox.halt(),
        destroy: () => sandbox.destroy(),
        terminate: () => sandbox.terminate(),
      };
    },
  };
  return { sandboxes, letStart: () => letStart() };
}

async function moduleOf(module: object) {
  const { decode, encode } = await import('@ubii/proto');
  const format = 'ubii.processing.ProcessingModule';
  const extension = { origin: MODULE_ORIGIN_BUILT_IN };
  return decode(format, encode(format, { ...module, extension }));
}
