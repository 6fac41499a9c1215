import { SessionState, SessionStatus } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { codes, doubler, doubling, SessionWorld, TOPICS } from './session-world.ts';

describe('a session on the master', () => {
  it('runs a module that came with a client, from topic to topic [SE-11]', async () => {
    const world = await SessionWorld.create();
    const session = await world.ask(TOPICS.start, doubling('/in', '/out'));
    expect(session.status).toBe(SessionStatus.CREATED);
    world.ada.publish('/in', 'double', 21);
    await world.master.pass(10);
    expect(await world.value('/out')).toBe(42);
    const now = await world.get(session);
    expect(now.status).toBe(SessionStatus.RUNNING);
    expect(now.extension?.state).toBe(SessionState.SESSION_RUNNING);
    world.ada.publish('/in', 'double', 0);
    await world.master.pass(10);
    expect(await world.value('/out')).toBe(0);
  });

  it('is announced at each step, with the whole session [SE-8] [SE-12] [SE-13]', async () => {
    const world = await SessionWorld.create();
    const added = await world.ask(TOPICS.add, doubling('/in', '/out'));
    expect(world.takeWords()).toEqual(['new']);
    const started = await world.ask(TOPICS.start, { id: added.id });
    const news = world.takeNews();
    expect(news.map(([word]) => word)).toEqual(['start', 'change', 'change', 'running']);
    const [, inRecord] = news[0]!;
    expect(inRecord.id).toBe(started.id);
    expect(inRecord.processingModules[0]).toMatchObject({
      ...doubler,
      id: started.processingModules[0]!.id,
      sessionId: started.id,
    });
    await world.ask(TOPICS.stop, { id: added.id });
    const words = world.takeNews();
    expect(words.map(([word]) => word)).toEqual(['stop', 'change', 'change']);
    expect(words.at(-1)![1].extension?.state).toBe(SessionState.SESSION_STOPPED);
    await world.ask(TOPICS.remove, { id: added.id });
    expect(world.takeWords()).toEqual(['delete']);
  });

  it('is told to slow clients like any other: no news replaces another [TD-31]', async () => {
    const world = await SessionWorld.create();
    world.ada.connection.stall();
    const one = await world.ask(TOPICS.start, doubling('/in', '/one'));
    const two = await world.ask(TOPICS.start, doubling('/in', '/two'));
    expect(world.takeNews()).toEqual([]);
    world.ada.connection.take();
    world.ada.socket.handleDrain();
    await world.master.pass();
    const started = world.takeNews().filter(([word]) => word === 'start');
    expect(started.map(([, { id }]) => id)).toEqual([one.id, two.id]);
  });

  it('stops: success at once, and its modules run no more [SE-13] [EC-12]', async () => {
    const world = await SessionWorld.create();
    const { id } = await world.ask(TOPICS.start, doubling('/in', '/out'));
    const reply = await world.master.call({ topic: TOPICS.stop, session: { id } });
    expect(reply.success).toBeDefined();
    await world.master.pass();
    world.ada.publish('/in', 'double', 1);
    await world.master.pass(50);
    expect(await world.value('/out')).toBeUndefined();
    // Stopping what is stopped succeeds.
    expect(
      (await world.master.call({ topic: TOPICS.stop, session: { id } })).success,
    ).toBeDefined();
    expect((await world.get({ id })).status).toBe(SessionStatus.STOPPED);
  });

  it('starts again after a stop, with a new state [SE-10]', async () => {
    const world = await SessionWorld.create();
    const counting = doubling('/in', '/out');
    const { id } = await world.ask(TOPICS.start, {
      ...counting,
      processingModules: [
        {
          ...doubler,
          onCreatedStringified: '(state) => { state.count = 0; }',
          onProcessingStringified:
            '(dt, inputs, state) => { state.count += 1; return { outputs: { out: { double: state.count } } }; }',
        },
      ],
    });
    for (const n of [1, 2, 3]) {
      world.ada.publish('/in', 'double', n);
      await world.master.pass(10);
    }
    expect(await world.value('/out')).toBe(3);
    await world.ask(TOPICS.stop, { id });
    await world.ask(TOPICS.start, { id });
    await world.master.pass(10);
    expect(await world.value('/out')).toBe(1);
  });

  it('cannot be started twice, without modules, or when it is unknown [SE-11]', async () => {
    const world = await SessionWorld.create();
    const { id } = await world.ask(TOPICS.start, doubling('/in', '/out'));
    expect(await world.refusal(TOPICS.start, { id })).toMatchObject({
      code: 'failed_precondition',
    });
    expect(await world.refusal(TOPICS.start, { name: 'empty' })).toMatchObject({
      code: 'failed_precondition',
    });
    expect(await world.refusal(TOPICS.start, { id: 'unknown' })).toMatchObject({
      code: 'not_found',
    });
    expect(await world.refusal(TOPICS.stop, { id: 'unknown' })).toMatchObject({
      code: 'not_found',
    });
  });

  it('is held with its state, and goes on [SE-14]', async () => {
    const world = await SessionWorld.create();
    const { id } = await world.ask(TOPICS.start, doubling('/in', '/out'));
    const paused = await world.ask(TOPICS.pause, { id });
    expect(paused).toMatchObject({ status: SessionStatus.PAUSED });
    world.ada.publish('/in', 'double', 2);
    await world.master.pass(50);
    expect(await world.value('/out')).toBeUndefined();
    expect(await world.ask(TOPICS.resume, { id })).toMatchObject({ status: SessionStatus.RUNNING });
    await world.master.pass(10);
    world.ada.publish('/in', 'double', 3);
    await world.master.pass(10);
    expect(await world.value('/out')).toBe(6);
    expect(await world.refusal(TOPICS.resume, { id })).toMatchObject({
      code: 'failed_precondition',
    });
  });

  it('is degraded while a module does not run, and says which and why [SE-12]', async () => {
    const world = await SessionWorld.create();
    const { id } = await world.ask(TOPICS.start, {
      ...doubling('/in', '/out'),
      processingModules: [
        doubler,
        {
          ...doubler,
          name: 'broken',
          onCreatedStringified: '() => { throw new Error("no luck"); }',
        },
      ],
    });
    const { extension } = await world.get({ id });
    expect(extension?.state).toBe(SessionState.SESSION_DEGRADED);
    const { masterStatus } = await world.master.call({
      topic: '/services/ubii/master_status',
      masterStatusRequest: {},
    });
    expect(masterStatus?.problems).toMatchObject([{ code: 'session_degraded' }]);
    const sessions = world.master.master.metrics().find(({ name }) => name === 'ubii_sessions');
    expect(sessions?.values).toContainEqual({ labels: { state: 'degraded' }, value: 1 });
    expect(extension?.problems[0]).toMatchObject({
      isError: true,
      code: 'module_failed',
      moduleName: 'broken',
      message: expect.stringContaining('no luck'),
    });
  });

  it('is stopped when none of its modules could be started [SE-12]', async () => {
    const world = await SessionWorld.create();
    const { id } = await world.ask(TOPICS.start, {
      processingModules: [
        { ...doubler, onCreatedStringified: '() => { throw new Error("no luck"); }' },
      ],
    });
    const { extension, status } = await world.get({ id });
    expect(status).toBe(SessionStatus.STOPPED);
    expect(codes(extension?.problems)).toContain('module_failed');
  });

  it('stays when the client that made it goes [SE-16]', async () => {
    const world = await SessionWorld.create();
    const { id } = await world.ask(TOPICS.start, doubling('/in', '/out'));
    await world.master.call({
      topic: '/services/client/deregistration',
      client: { id: world.ada.id },
    });
    const ben = await world.master.extension('ben');
    ben.publish('/in', 'double', 4);
    await world.master.pass(10);
    expect(await world.value('/out')).toBe(8);
    expect((await world.get({ id })).status).toBe(SessionStatus.RUNNING);
  });

  it('reports how its modules do, and what happens in them [SE-50] [SE-51]', async () => {
    const world = await SessionWorld.create();
    const { id } = await world.ask(TOPICS.start, {
      ...doubling('/in', '/out'),
      processingModules: [
        {
          ...doubler,
          onProcessingStringified:
            '(dt, inputs) => { console.log("ran"); return { outputs: { out: inputs.in } }; }',
        },
      ],
    });
    await world.ada.subscribe({ subscribeTopics: [`/ubii/session/${id}/statistics`] });
    await world.ada.subscribe({ subscribeTopics: [`/ubii/session/${id}/events`] });
    world.ada.publish('/in', 'double', 4);
    await world.master.pass(600);
    const records = world.ada.takeRecords();
    const statistics = records.filter(({ topic }) => topic.endsWith('/statistics'));
    expect(statistics.length).toBeGreaterThanOrEqual(2);
    expect(statistics.at(-1)?.value).toMatchObject({
      sessionId: id,
      modules: [{ moduleName: 'doubler', runs: 1 }],
    });
    const events = records.filter(({ topic }) => topic.endsWith('/events'));
    expect(events.map(({ value }) => value)).toMatchObject([
      { sessionId: id, moduleName: 'doubler', message: 'ran', level: 'log' },
    ]);
  });
});
