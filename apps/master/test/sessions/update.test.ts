import { SessionState, StatusEventKind, type Session } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { codes, doubler, doubling, SessionWorld, TOPICS } from './session-world.ts';
import { TestNode } from './test-node.ts';

/** Counts its runs: a restart shows. */
const counter = {
  ...doubler,
  onCreatedStringified: '(state) => { state.count = 0; }',
  onProcessingStringified:
    '(dt, inputs, state) => { state.count += 1; return { outputs: { out: { double: state.count } } }; }',
};

async function setup() {
  const world = await SessionWorld.create();
  const session = await world.ask(TOPICS.start, {
    ...doubling('/in', '/out'),
    processingModules: [counter],
  });
  world.ada.publish('/in', 'double', 1);
  await world.master.pass(10);
  expect(await world.value('/out')).toBe(1);
  return { world, session: await world.get(session) };
}

describe('an update of a running session', () => {
  it('applies other mappings without a restart [SE-15]', async () => {
    const { world, session } = await setup();
    session.ioMappings[0]!.outputMappings[0]!.topic = '/elsewhere';
    const updated = await world.ask(TOPICS.update, session);
    expect(updated.extension).toMatchObject({
      state: SessionState.SESSION_RUNNING,
      revision: session.extension!.revision + 1,
    });
    world.ada.publish('/in', 'double', 1);
    await world.master.pass(10);
    expect(await world.value('/elsewhere')).toBe(2);
  });

  it('applies another mode without a restart [SE-15]', async () => {
    const { world, session } = await setup();
    session.processingModules[0]!.processingMode = { frequency: { hertz: 50 } };
    await world.ask(TOPICS.update, session);
    await world.master.pass(100);
    expect(await world.value('/out')).toBeGreaterThan(4);
  });

  it('restarts a module whose code changed [SE-15]', async () => {
    const { world, session } = await setup();
    session.processingModules[0]!.onCreatedStringified = '(state) => { state.count = 100; }';
    await world.ask(TOPICS.update, session);
    world.ada.publish('/in', 'double', 1);
    await world.master.pass(10);
    expect(await world.value('/out')).toBeGreaterThan(100);
    expect((await world.get(session)).extension?.state).toBe(SessionState.SESSION_RUNNING);
  });

  it('restarts a module that has another name [SE-15]', async () => {
    const { world, session } = await setup();
    session.processingModules[0]!.name = 'renamed';
    await world.ask(TOPICS.update, session);
    await world.master.pass(10);
    // The record that is there when it starts makes it run once.
    expect(await world.value('/out')).toBe(1);
    await world.master.pass(11_000);
    expect((await world.get(session)).extension?.state).toBe(SessionState.SESSION_RUNNING);
  });

  it('keeps a module that the master may place again where it is [SE-15] [SE-30]', async () => {
    const { world, session } = await setup();
    session.processingModules[0]!.extension!.replaceable = false;
    const pinned = await world.ask(TOPICS.update, session);
    pinned.processingModules[0]!.nodeId = '';
    await world.ask(TOPICS.update, pinned);
    world.ada.publish('/in', 'double', 1);
    await world.master.pass(10);
    expect(await world.value('/out')).toBe(2);
    await world.master.pass(11_000);
    expect((await world.get(session)).extension?.state).toBe(SessionState.SESSION_RUNNING);
  });

  it('stays running while a changed module restarts and an added one starts [SE-12] [SE-15]', async () => {
    const { world, session } = await setup();
    const states: (SessionState | undefined)[] = [];
    world.takeNews();
    session.processingModules[0]!.onCreatedStringified = '(state) => { state.count = 100; }';
    await world.ask(TOPICS.update, {
      ...session,
      processingModules: [...session.processingModules, { ...doubler, name: 'second' }],
    });
    await world.master.pass(10);
    for (const [, { extension }] of world.takeNews()) states.push(extension?.state);
    expect(states.length).toBeGreaterThan(0);
    expect(new Set(states)).toEqual(new Set([SessionState.SESSION_RUNNING]));
    const { masterStatus } = await world.master.call({
      topic: '/services/ubii/master_status',
      masterStatusRequest: { sinceMs: 0 },
    });
    expect(masterStatus!.events.map(({ kind }) => kind)).not.toContain(
      StatusEventKind.SESSION_DEGRADED,
    );
    expect((await world.get(session)).extension?.state).toBe(SessionState.SESSION_RUNNING);
  });

  it('starts modules that are new, and ends those that are gone [SE-15]', async () => {
    const { world, session } = await setup();
    const [kept] = session.ioMappings;
    const grown = await world.ask(TOPICS.update, {
      ...session,
      processingModules: [...session.processingModules, { ...doubler, name: 'second' }],
      ioMappings: [
        kept!,
        {
          processingModuleName: 'second',
          inputMappings: [{ inputName: 'in', topic: '/in' }],
          outputMappings: [{ outputName: 'out', topic: '/second' }],
        },
      ],
    });
    world.ada.publish('/in', 'double', 4);
    await world.master.pass(10);
    expect(await world.value('/second')).toBe(8);
    expect(await world.value('/out')).toBe(2);

    const now = await world.get(grown);
    await world.ask(TOPICS.update, {
      ...now,
      processingModules: now.processingModules.slice(1),
      ioMappings: now.ioMappings.slice(1),
    });
    world.ada.publish('/in', 'double', 5);
    await world.master.pass(10);
    expect(await world.value('/second')).toBe(10);
    // No module writes it any more. [SE-62]
    expect(await world.value('/out')).toBeUndefined();
  });

  it('needs a module to go on [SE-15]', async () => {
    const { world, session } = await setup();
    const empty = { ...session, processingModules: [], ioMappings: [] };
    expect(await world.refusal(TOPICS.update, empty)).toMatchObject({
      code: 'failed_precondition',
    });
    await world.ask(TOPICS.stop, { id: session.id });
    expect((await world.ask(TOPICS.update, empty)).processingModules).toEqual([]);
  });

  it('shows where a module of a session that does not run would run [SE-30]', async () => {
    const world = await SessionWorld.create();
    const session = await world.ask(TOPICS.add, doubling('/in', '/out'));
    const updated = await world.ask(TOPICS.update, {
      ...session,
      processingModules: [...session.processingModules, { ...doubler, name: 'new' }],
    });
    expect(updated.processingModules.map(({ nodeId }) => nodeId)).toEqual([
      world.master.master.id,
      world.master.master.id,
    ]);
  });

  it('is refused when another client has updated the session before [SE-15]', async () => {
    const { world, session } = await setup();
    await world.ask(TOPICS.update, { ...session, description: 'mine' });
    expect(await world.refusal(TOPICS.update, { ...session, description: 'late' })).toMatchObject({
      code: 'failed_precondition',
    });
    const blind = { ...session, extension: { ...session.extension, revision: 0 } };
    expect((await world.ask(TOPICS.update, blind)).description).toBe('');
  });

  it('that is wrong changes nothing [SE-3] [SE-15]', async () => {
    const { world, session } = await setup();
    const refused = await world.refusal(TOPICS.update, {
      ...session,
      ioMappings: [{ processingModuleName: 'unknown' }],
    });
    expect(codes(refused.problems)).toContain('mapping_without_module');
    expect((await world.get(session)).extension?.revision).toBe(session.extension?.revision);
    world.ada.publish('/in', 'double', 1);
    await world.master.pass(10);
    expect(await world.value('/out')).toBe(2);
  });

  it('moves a module to another node [SE-15] [SE-31]', async () => {
    const { world, session } = await setup();
    const node = await TestNode.ours(world.master, 'tab');
    session.processingModules[0]!.nodeId = node.id;
    const moved = await world.ask(TOPICS.update, session);
    expect(moved.extension?.state).toBe(SessionState.SESSION_RUNNING);
    const [module] = node.own(node.told('change'));
    await node.ran([module!]);
    expect((await world.get(session)).extension?.state).toBe(SessionState.SESSION_RUNNING);
    const before = await world.value('/out');
    world.ada.publish('/in', 'double', 1);
    await world.master.pass(10);
    // It has ended here.
    expect(await world.value('/out')).toBe(before);
  });

  it('does not pin modules where the master put them, unless it says so [SE-30]', async () => {
    const { world, session } = await setup();
    const replaceable = (from: Session) => from.processingModules[0]?.extension?.replaceable;
    const sentBack = await world.ask(TOPICS.update, session);
    expect(replaceable(sentBack)).toBe(true);
    sentBack.processingModules[0]!.extension!.replaceable = false;
    const pinned = await world.ask(TOPICS.update, sentBack);
    expect(replaceable(pinned)).toBe(false);
    // A copy is placed again.
    const copy = await world.ask(TOPICS.add, { ...sentBack, id: '' });
    expect(replaceable(copy)).toBe(false);
    const free = await world.ask(TOPICS.add, { ...session, id: '' });
    expect(replaceable(free)).toBe(true);
  });

  it('does not reach nodes of the original, which the session says [SE-15]', async () => {
    const world = await SessionWorld.create();
    const node = await TestNode.original(world.master, 'nodejs');
    const { id } = await world.ask(TOPICS.start, {
      ...doubling('/in', '/out'),
      processingModules: [{ ...doubler, nodeId: node.id }],
    });
    await node.ran(node.own(node.told('start')));
    const session = await world.get({ id });
    session.ioMappings[0]!.outputMappings[0]!.topic = '/elsewhere';
    const { extension } = await world.ask(TOPICS.update, session);
    expect(extension?.problems).toContainEqual(
      expect.objectContaining({ code: 'node_cannot_update', nodeId: node.id }),
    );
  });

  it('adds modules on nodes of the original as a start of their own [SE-31]', async () => {
    const { world, session } = await setup();
    const node = await TestNode.original(world.master, 'nodejs');
    await world.ask(TOPICS.update, {
      ...session,
      processingModules: [
        ...session.processingModules,
        { ...doubler, name: 'far', nodeId: node.id },
      ],
    });
    const told = node.told('start');
    expect(told.processingModules.map(({ name }) => name)).toEqual(['far']);
    expect(told.ioMappings).toHaveLength(1);
  });
});
