import { fromJson, ServiceError, SessionState, toJson, type Init, type Session } from '@ubii/proto';
import { describe, expect, it, vi } from 'vitest';
import { shallowRef } from 'vue';
import { aSession } from '../testing/a-session.ts';
import { createSessionCalls } from './session-calls.ts';

const { SESSION_RUNNING, SESSION_STOPPED } = SessionState;
const whole = (spec: Init<Session>): Session =>
  fromJson('ubii.sessions.Session', toJson('ubii.sessions.Session', spec));

/** Mocks a master that accepts all sessions and assigns ids. */
function setup(...known: Session[]) {
  const asked: [string, Init<Session>][] = [];
  const call = vi.fn(async (service: string, request: Init<Session>) => {
    if (service === 'sessionDatabaseGetList') return { elements: [whole({ name: 'On disk' })] };
    asked.push([service, request]);
    const answer = whole({ ...request, id: request.id || 'new' });
    return service === 'sessionDatabaseSave' ? { elements: [answer] } : answer;
  });
  const taken: Session[] = [];
  const dropped: string[] = [];
  const store = {
    list: shallowRef<readonly Session[]>(known),
    take(session: Session) {
      taken.push(session);
      store.list.value = store.list.value.map((one) => (one.id === session.id ? session : one));
    },
    drop: (id: string) => void dropped.push(id),
  };
  const stops: string[] = [];
  let ids = 0;
  const calls = createSessionCalls(
    { call } as never,
    store,
    async (id) => void stops.push(id),
    () => `id ${(ids += 1)}`,
  );
  const services = () => asked.map(([service]) => service);
  return { calls, call, asked, services, taken, dropped, stops };
}

describe('what people do with sessions', () => {
  it('starts by id, also one that is only stored [SE-27]', async () => {
    const { calls, asked } = setup();
    await calls.act(aSession(), 'start');
    expect(asked).toEqual([['sessionRuntimeStart', { id: 'session' }]]);
  });

  it('restarts when it has stopped [SE-10]', async () => {
    const { calls, services, stops } = setup();
    await calls.act(aSession({ state: SESSION_RUNNING }), 'restart');
    expect(services()).toEqual(['sessionRuntimeStop', 'sessionRuntimeStart']);
    expect(stops).toEqual(['session']);
  });

  it('takes no name from a session that has it: the newer would replace it [SE-21]', async () => {
    const { calls, asked } = setup(aSession({ name: 'A' }), aSession({ name: 'A 2' }));
    await calls.create({ name: 'A' });
    await calls.create({ name: 'B' });
    await calls.create({});
    await calls.create({ name: 'On disk' });
    expect(asked.map(([, { name }]) => name)).toEqual(['A 3', 'B', 'Session', 'On disk 2']);
  });

  it('duplicates with modules of its own, and mappings that follow them [SE-1]', async () => {
    const { calls, asked } = setup(aSession(), aSession({ name: 'Two hands copy' }));
    await calls.duplicate(aSession());
    const [, spec] = asked[0]!;
    expect(spec).toMatchObject({ id: '', name: 'Two hands copy 2' });
    expect(spec.processingModules?.[0]?.id).toBe('id 1');
    expect(spec.ioMappings?.[0]?.processingModuleId).toBe('id 1');
  });

  it('says which revision a change was made from [SE-15]', async () => {
    const { calls, asked } = setup();
    await calls.update(aSession(), { extension: { startWithMaster: true } });
    expect(asked[0]).toMatchObject([
      'sessionRuntimeUpdate',
      { id: 'session', extension: { revision: 3, startWithMaster: true } },
    ]);
  });

  it('changes a stored one on the disk, too, and its file follows its name [SE-21]', async () => {
    const { calls, asked } = setup();
    const stored = aSession({ json: { extension: { stored: true, revision: 3 } } });
    await calls.rename(stored, 'Three hands');
    expect(asked.map(([service, { name }]) => [service, name])).toEqual([
      ['sessionDatabaseSave', 'Three hands'],
      ['sessionDatabaseDelete', 'Two hands'],
    ]);
    expect(asked[0]![1]).toMatchObject({ id: 'session', extension: { revision: 3 } });
  });

  it('saves other changes together with a new name [SE-21]', async () => {
    const stored = aSession({ json: { extension: { stored: true, revision: 3 } } });
    const { calls, asked } = setup(stored);
    await calls.rename(stored, 'Three hands', { description: 'Of three' });
    expect(asked[0]![1]).toMatchObject({ name: 'Three hands', description: 'Of three' });
  });

  it('leaves the choice of a node to the master where it had it [SE-30]', async () => {
    const { calls, asked } = setup();
    const session = aSession();
    session.processingModules[0]!.nodeId = 'node';
    await calls.update(session, {});
    session.processingModules[0]!.extension!.replaceable = true;
    await calls.update(session, {});
    const places = asked.map(([, spec]) => spec.processingModules![0]!.nodeId);
    expect(places).toEqual(['node', '']);
  });

  it('opens one that is only stored by its id [SE-27]', async () => {
    const { calls, asked } = setup();
    await calls.open('session');
    expect(asked).toEqual([['sessionRuntimeAdd', { id: 'session' }]]);
  });

  it('forgets a stored one on the disk, too, after it was stopped [SE-16, SE-21]', async () => {
    const { calls, services, dropped } = setup();
    const session = aSession({
      state: SESSION_RUNNING,
      json: { extension: { state: 2, stored: true } },
    });
    const removed = await calls.remove(session);
    // Otherwise pages that show the session would open the file again.
    expect(services()).toEqual([
      'sessionRuntimeStop',
      'sessionDatabaseDelete',
      'sessionRuntimeRemove',
    ]);
    expect(dropped).toEqual(['session']);
    expect(removed).toMatchObject({ id: 'session', wasAlive: true, wasStored: true });
  });

  it('deletes one that is being renamed under its new name, from the disk, too [SE-16, SE-21]', async () => {
    const stored = aSession({ json: { extension: { stored: true, revision: 3 } } });
    const { calls, asked } = setup(stored);
    await Promise.all([calls.rename(stored, 'Three hands'), calls.remove(stored)]);
    expect(asked.map(([service, { name }]) => [service, name])).toEqual([
      ['sessionDatabaseSave', 'Three hands'],
      ['sessionDatabaseDelete', 'Two hands'],
      ['sessionDatabaseDelete', 'Three hands'],
      ['sessionRuntimeRemove', undefined],
    ]);
  });

  it('brings back what was there: stored, and running if it ran', async () => {
    const { calls, services } = setup();
    const spec = { name: 'Two hands' };
    await calls.restore({ id: 'session', spec, wasAlive: true, wasStored: true });
    expect(services()).toEqual(['sessionDatabaseSave', 'sessionRuntimeStart']);
    const other = setup();
    await other.calls.restore({ id: 'session', spec, wasAlive: false, wasStored: false });
    expect(other.services()).toEqual(['sessionRuntimeAdd']);
  });

  it('passes on what the master refuses', async () => {
    const { calls, call } = setup();
    call.mockRejectedValueOnce(new ServiceError('failed_precondition', 'It runs.'));
    await expect(calls.act(aSession({ state: SESSION_STOPPED }), 'start')).rejects.toThrow(
      'It runs.',
    );
  });
});
